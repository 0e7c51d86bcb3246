#include "armlet/backend/jsonl_backend.hpp"

#include <array>
#include <cmath>

#include "backend/text_sink.hpp"

namespace armlet {

class JsonlBackend::Writer {
 public:
  explicit Writer(std::ostream& out) : sink(out) {}

  void begin_line(std::int64_t t_ns, std::string_view what) {
    sink.text("{\"t\":");
    sink.seconds(t_ns);
    field("what", what);
  }

  void field(std::string_view key, std::string_view text) {
    write_key(key);
    sink.quoted(text);
  }

  void field(std::string_view key, double value) {
    write_key(key);
    sink.number(value);
  }

  void field(std::string_view key, std::span<const double> values) {
    write_key(key);
    sink.text("[");
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) sink.text(",");
      if (std::isfinite(values[i])) {
        sink.number(values[i]);
      } else {
        sink.text("null");
      }
    }
    sink.text("]");
  }

  void pose(const Eigen::Isometry3d& T) {
    const Eigen::Vector3d p = T.translation();
    const Eigen::Quaterniond r = positive_quaternion(T);
    field("p", std::array{p.x(), p.y(), p.z()});
    field("r", std::array{r.w(), r.x(), r.y(), r.z()});
  }

  // The units of the axes and the series between them.
  void axes(const Figure& figure) {
    field("x", figure.x.unit);
    field("y", figure.y.unit);
    field("z", figure.z.unit);
    field("right", figure.right.unit);
    if (figure.x.log || figure.y.log)
      field("log", std::string(figure.x.log ? "x" : "") + (figure.y.log ? "y" : ""));
    sink.text(",\"series\":[");
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
      const Series& series = figure.series[i];
      sink.text(i > 0 ? ",{\"kind\":" : "{\"kind\":");
      sink.quoted(to_text(series.kind));
      field("label", series.label);
      field("axis", series.right ? "right" : "left");
      field("x", std::span<const double>(series.x));
      field("y", std::span<const double>(series.y));
      field("z", std::span<const double>(series.z));
      sink.text("}");
    }
    sink.text("]");
    if (figure.names.empty()) return;
    sink.text(",\"names\":[");
    for (std::size_t i = 0; i < figure.names.size(); ++i) {
      if (i > 0) sink.text(",");
      sink.quoted(figure.names[i]);
    }
    sink.text("]");
  }

  // Fields of a robot that joins, without braces.
  void robot(const RobotInfo& robot) {
    robots.push_back(robot.name);
    sink.text("\"name\":");
    sink.quoted(robot.name);
    sink.text(",\"joints\":[");
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      sink.text(i > 0 ? "," : "");
      sink.quoted(robot.joints[i] == JointUnit::kRadian ? "rad" : "m");
    }
    sink.text("]");
  }

  void end_line() {
    sink.text("}");
    sink.end_line();
  }

  TextSink sink;
  std::vector<std::string> robots{};

 private:
  void write_key(std::string_view key) {
    sink.text(",");
    sink.quoted(key);
    sink.text(":");
  }
};

JsonlBackend::JsonlBackend(std::ostream& out) : writer_(std::make_unique<Writer>(out)) {}
JsonlBackend::~JsonlBackend() = default;

void JsonlBackend::begin(const RunInfo& run) {
  writer_->sink.text("{\"what\":\"begin\",\"robots\":[");
  for (const RobotInfo& robot : run.robots) {
    writer_->sink.text(writer_->robots.empty() ? "{" : ",{");
    writer_->robot(robot);
    writer_->sink.text("}");
  }
  writer_->sink.text("]");
  writer_->end_line();
  for (const ObjectInfo& object : run.objects) object_added(0, object);
}

void JsonlBackend::robot_added(std::int64_t t_ns, const RobotInfo& robot) {
  writer_->begin_line(t_ns, "robotAdded");
  writer_->sink.text(",");
  writer_->robot(robot);
  writer_->end_line();
}

void JsonlBackend::joint_sample(const JointSample& sample) {
  writer_->begin_line(sample.t_ns, "robot");
  writer_->field("name", writer_->robots[static_cast<std::size_t>(sample.robot)]);
  writer_->field("q", sample.q);
  writer_->field("qd", sample.qd);
  writer_->field("qdd", sample.qdd);
  writer_->pose(sample.T_world_tool);
  writer_->end_line();
}

void JsonlBackend::object_added(std::int64_t t_ns, const ObjectInfo& object) {
  writer_->begin_line(t_ns, "added");
  writer_->field("name", object.name);
  writer_->field("shape", object.shape);
  writer_->field("size", std::span<const double>(object.size));
  writer_->field("mass", object.mass);
  writer_->field("color", object.color);
  writer_->pose(object.T_world_obj);
  writer_->end_line();
}

void JsonlBackend::object_sample(const ObjectSample& sample) {
  writer_->begin_line(sample.t_ns, "object");
  writer_->field("name", sample.name);
  writer_->pose(sample.T_world_obj);
  writer_->end_line();
}

void JsonlBackend::object_event(const ObjectEvent& event) {
  writer_->begin_line(event.t_ns, to_text(event.change));
  writer_->field("name", event.name);
  if (event.robot >= 0) {
    writer_->field("robot", writer_->robots[static_cast<std::size_t>(event.robot)]);
  }
  writer_->end_line();
}

void JsonlBackend::note(const Note& note) {
  writer_->begin_line(note.t_ns, to_text(note.kind));
  writer_->field("text", note.text);
  writer_->end_line();
}

void JsonlBackend::figure(std::int64_t t_ns, const Figure& figure) {
  writer_->begin_line(t_ns, "figure");
  writer_->field("title", figure.title);
  writer_->axes(figure);
  if (!figure.panels.empty()) {
    writer_->sink.text(",\"panels\":[");
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      writer_->sink.text(i > 0 ? ",{\"title\":" : "{\"title\":");
      writer_->sink.quoted(figure.panels[i].title);
      writer_->axes(figure.panels[i]);
      writer_->sink.text("}");
    }
    writer_->sink.text("]");
  }
  writer_->end_line();
}

void JsonlBackend::end(std::int64_t t_ns) {
  writer_->begin_line(t_ns, "end");
  writer_->end_line();
  writer_->sink.flush();
}

std::string JsonlBackend::error() const { return writer_->sink.error(); }

}  // namespace armlet
