#include "armlet/backend/jsonl_backend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "backend/text_sink.hpp"

namespace armlet {
namespace {

class JsonlBackend final : public Backend {
 public:
  explicit JsonlBackend(std::ostream& out) : sink_(out) {}

  void on(const Event& event) override {
    if (!kIgnored.kinds().has(kind_of(event))) note_line(number_of(event));
    std::visit(Overload{[this](const auto& each) { write(each); }, kIgnored}, event);
  }
  [[nodiscard]] EventKinds ignores() const override { return kIgnored.kinds(); }

  [[nodiscard]] std::string error() const override { return sink_.error(); }

 private:
  static constexpr Ignore<FigureChanged> kIgnored{};

  void write(const BeginRun& begin) {
    robots_.clear();
    sink_.text("{\"what\":\"begin\",\"robots\":[");
    for (const RobotInfo& robot : begin.run.robots) {
      sink_.text(robots_.empty() ? "{" : ",{");
      write_robot(robot);
      sink_.text("}");
    }
    sink_.text("]");
    if (!begin.run.cameras.empty()) {
      sink_.text(",\"cameras\":[");
      for (const CameraInfo& camera : begin.run.cameras) {
        sink_.text(&camera == begin.run.cameras.data() ? "{" : ",{");
        describe(camera);
        sink_.text("}");
      }
      sink_.text("]");
    }
    end_line();
    for (const ObjectInfo& object : begin.run.objects) write_object(0, object);
  }

  void write(const RobotAdded& added) {
    begin_line(added.t_ns, "robotAdded");
    sink_.text(",");
    write_robot(added.robot);
    end_line();
  }

  void write(const RobotChanged& changed) {
    begin_line(changed.t_ns, "robotChanged");
    sink_.text(",");
    describe(changed.robot);
    end_line();
  }

  void write(const JointSample& sample) {
    begin_line(sample.t_ns, "robot");
    field("name", robots_[static_cast<std::size_t>(sample.robot)]);
    field("q", sample.q);
    field("qd", sample.qd);
    field("qdd", sample.qdd);
    pose(sample.T_world_tool);
    end_line();
  }

  void write(const ObjectAdded& added) { write_object(added.t_ns, added.object); }

  void write_object(std::int64_t t_ns, const ObjectInfo& object) {
    begin_line(t_ns, "added");
    field("name", object.name);
    field("shape", object.shape);
    field("size", std::span<const double>(object.size));
    field("mass", object.mass);
    field("color", object.color);
    pose(object.T_world_obj);
    end_line();
  }

  void write(const ObjectSample& sample) {
    begin_line(sample.t_ns, "object");
    field("name", sample.name);
    pose(sample.T_world_obj);
    end_line();
  }

  void write(const ObjectEvent& event) {
    begin_line(event.t_ns, to_text(event.change));
    field("name", event.name);
    if (event.robot >= 0) {
      field("robot", robots_[static_cast<std::size_t>(event.robot)]);
    }
    end_line();
  }

  void write(const Note& note) {
    begin_line(note.t_ns, to_text(note.kind));
    field("text", note.text);
    end_line();
  }

  void write(const FinalFigure& final) {
    const Figure& figure = *final.figure;
    begin_line(final.t_ns, "figure");
    field("title", figure.title);
    axes(figure);
    if (!figure.panels.empty()) {
      sink_.text(",\"panels\":[");
      for (std::size_t i = 0; i < figure.panels.size(); ++i) {
        sink_.text(i > 0 ? ",{\"title\":" : "{\"title\":");
        sink_.quoted(figure.panels[i].title);
        axes(figure.panels[i]);
        sink_.text("}");
      }
      sink_.text("]");
    }
    if (figure.picture != nullptr) {
      sink_.text(",\"picture\":{\"note\":");
      sink_.quoted(figure.note);
      const Image& image = *figure.picture;
      size_of_pixels(image.width(), image.height(), image.channels());
      field("hash", fmt::format("{:016x}", pixel_hash(image.bytes())));
      sink_.text("}");
    }
    end_line();
  }

  // Lines count from 1: those from `line` up to this one are undone. For redo, the lines undone
  // last count again up to the time `back`.
  void write(const Undone& undone) {
    if (undone.from >= undone.number) {
      begin_line(undone.t_ns, "redone");
      field("back", static_cast<double>(undone.back_ns) / 1e9);
      return end_line();
    }
    const auto behind = std::ranges::upper_bound(stretches_, undone.from, {}, &Stretch::number);
    const Stretch& stretch = behind == stretches_.begin() ? *behind : *std::prev(behind);
    begin_line(undone.t_ns, "undone");
    field("line", static_cast<double>(stretch.line + undone.from - stretch.number));
    field("back", static_cast<double>(undone.back_ns) / 1e9);
    end_line();
  }

  void write(const DrawingChanged& changed) {
    const DrawingInfo& drawing = changed.drawing;
    begin_line(changed.t_ns, changed.removed ? "undrawn" : "drawn");
    field("name", drawing.name);
    if (!changed.removed) {
      field("kind", drawing.kind);
      field("size", std::span<const double>(drawing.size));
      if (!drawing.text.empty()) field("text", drawing.text);
      field("color", drawing.color);
      if (drawing.robot >= 0) {
        field("robot", robots_[static_cast<std::size_t>(drawing.robot)]);
        field("link", static_cast<double>(drawing.link));
      }
      if (!drawing.object.empty()) field("object", drawing.object);
      pose(drawing.T_on_drawing);
    }
    end_line();
  }

  void write(const CameraAdded& added) {
    begin_line(added.t_ns, "cameraAdded");
    sink_.text(",");
    describe(added.camera);
    end_line();
  }

  void write(const ImageFrame& frame) {
    begin_line(frame.t_ns, "frame");
    field("camera", frame.camera);
    field("number", static_cast<double>(frame.frame));
    size_of_pixels(frame.width, frame.height, frame.channels);
    field("hash", fmt::format("{:016x}", pixel_hash(frame)));
    if (!frame.file.empty()) field("file", frame.file);
    pose(frame.T_world_camera);
    end_line();
  }

  void write(const EndRun& end) {
    begin_line(end.t_ns, "end");
    end_line();
    sink_.flush();
  }

  // The line of an event follows from its number, except where events had no line, or several.
  void note_line(std::uint64_t number) {
    while (!stretches_.empty() && stretches_.back().number > number) stretches_.pop_back();
    const std::uint64_t line = lines_ + 1;
    if (stretches_.empty() || line - stretches_.back().line != number - stretches_.back().number)
      stretches_.push_back({number, line});
  }

  void begin_line(std::int64_t t_ns, std::string_view what) {
    sink_.text("{\"t\":");
    sink_.seconds(t_ns);
    field("what", what);
  }

  void field(std::string_view key, std::string_view text) {
    write_key(key);
    sink_.quoted(text);
  }

  void field(std::string_view key, double value) {
    write_key(key);
    sink_.number(value);
  }

  void field(std::string_view key, std::span<const double> values) {
    write_key(key);
    numbers(values);
  }

  // Writes null for values that are not finite.
  void numbers(std::span<const double> values) {
    sink_.text("[");
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) sink_.text(",");
      if (std::isfinite(values[i])) {
        sink_.number(values[i]);
      } else {
        sink_.text("null");
      }
    }
    sink_.text("]");
  }

  void pose(const Eigen::Isometry3d& T) {
    const std::array<double, 7> numbers = pose_numbers(T);
    field("p", std::span(numbers).first<3>());
    field("r", std::span(numbers).last<4>());
  }

  // x, y, z and a unit quaternion w, x, y, z.
  static std::array<double, 7> pose_numbers(const Eigen::Isometry3d& T) {
    const Eigen::Vector3d p = T.translation();
    const Eigen::Quaterniond r = positive_quaternion(T);
    return {p.x(), p.y(), p.z(), r.w(), r.x(), r.y(), r.z()};
  }

  // Leaves a brace open.
  void describe(const JointInfo& joint) {
    sink_.text("{\"before\":");
    numbers(pose_numbers(joint.T_before_joint));
    field("after", pose_numbers(joint.T_joint_link));
    field("limits", std::array{joint.lower, joint.upper});
    field("speed", joint.max_speed);
    if (!joint.mesh.empty()) field("mesh", joint.mesh);
  }

  void describe(const ToolInfo& tool) {
    sink_.text(",\"tool\":{\"kind\":");
    sink_.quoted(tool.kind);
    field("pose", pose_numbers(tool.T_flange_tool));
    field("stroke", tool.stroke);
    field("radius", tool.radius);
    field("length", tool.length);
    sink_.text("}");
  }

  void size_of_pixels(int width, int height, int channels) {
    const double size[] = {static_cast<double>(width), static_cast<double>(height),
                           static_cast<double>(channels)};
    field("size", size);
  }

  // Writes the units of the axes and the series.
  void axes(const Figure& figure) {
    field("x", figure.x.unit);
    field("y", figure.y.unit);
    field("z", figure.z.unit);
    field("right", figure.right.unit);
    if (figure.x.log || figure.y.log)
      field("log", std::string(figure.x.log ? "x" : "") + (figure.y.log ? "y" : ""));
    sink_.text(",\"series\":[");
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
      const Series& series = figure.series[i];
      sink_.text(i > 0 ? ",{\"kind\":" : "{\"kind\":");
      sink_.quoted(to_text(series.kind));
      field("label", series.label);
      field("axis", series.right ? "right" : "left");
      field("x", std::span<const double>(series.x));
      field("y", std::span<const double>(series.y));
      field("z", std::span<const double>(series.z));
      sink_.text("}");
    }
    sink_.text("]");
    if (figure.names.empty()) return;
    sink_.text(",\"names\":[");
    for (std::size_t i = 0; i < figure.names.size(); ++i) {
      if (i > 0) sink_.text(",");
      sink_.quoted(figure.names[i]);
    }
    sink_.text("]");
  }

  // Writes the fields of an added robot, without braces.
  void write_robot(const RobotInfo& robot) {
    robots_.push_back(robot.name);
    describe(robot);
  }

  void describe(const RobotInfo& robot) {
    sink_.text("\"name\":");
    sink_.quoted(robot.name);
    sink_.text(",\"joints\":[");
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      sink_.text(i > 0 ? "," : "");
      sink_.quoted(robot.joints[i].unit == JointUnit::kRadian ? "rad" : "m");
    }
    sink_.text("],\"links\":[");
    for (std::size_t i = 0; i < robot.link_count(); ++i) {
      sink_.text(i > 0 ? "," : "");
      describe(robot.link(i));
      if (!robot.rows.empty()) {
        field("joint", static_cast<double>(robot.rows[i].joint));
        field("ratio", robot.rows[i].ratio);
        field("offset", robot.rows[i].offset);
      }
      sink_.text("}");
    }
    sink_.text("]");
    field("home", std::span<const double>(robot.home));
    if (robot.on >= 0) field("on", static_cast<double>(robot.on));
    field("base", pose_numbers(robot.T_world_base));
    describe(robot.tool);
  }

  // Writes the fields of a camera, without braces.
  void describe(const CameraInfo& camera) {
    sink_.text("\"name\":");
    sink_.quoted(camera.name);
    const double size[] = {static_cast<double>(camera.width), static_cast<double>(camera.height)};
    field("size", size);
    const double K[] = {camera.fx, camera.fy, camera.cx, camera.cy};
    field("K", K);
    field("distortion", std::span<const double>(camera.distortion));
    const double range[] = {camera.near, camera.far};
    field("range", range);
    if (camera.rate > 0.0) field("rate", camera.rate);
    if (camera.robot >= 0) {
      field("robot", robots_[static_cast<std::size_t>(camera.robot)]);
      field("link", static_cast<double>(camera.link));
    }
    if (!camera.object.empty()) field("object", camera.object);
    if (!camera.frame.empty()) field("frame", camera.frame);
    field("on", pose_numbers(camera.T_on_camera));
  }

  void end_line() {
    sink_.text("}");
    sink_.end_line();
    ++lines_;
  }

  void write_key(std::string_view key) {
    sink_.text(",");
    sink_.quoted(key);
    sink_.text(":");
  }

  // A sequence of events with one line each.
  struct Stretch {
    std::uint64_t number;
    std::uint64_t line;
  };

  TextSink sink_;
  std::vector<std::string> robots_{};
  std::vector<Stretch> stretches_{};
  std::uint64_t lines_ = 0;
};

}  // namespace

std::unique_ptr<Backend> make_jsonl_backend(std::ostream& out) {
  return std::make_unique<JsonlBackend>(out);
}

}  // namespace armlet
