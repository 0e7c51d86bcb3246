#include "armlet/backend/csv_backend.hpp"

#include "backend/joint_columns.hpp"
#include "backend/text_sink.hpp"

namespace armlet {
namespace {

constexpr int kDigits = 9;

// A field in quotes, with quotes doubled (RFC 4180), if it needs them.
void write_field(TextSink& sink, std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    sink.text(text);
    return;
  }
  sink.text("\"");
  for (const char c : text)
    sink.text(c == '"' ? std::string_view("\"\"") : std::string_view(&c, 1));
  sink.text("\"");
}

}  // namespace

class CsvBackend::Table {
 public:
  explicit Table(std::ostream& out) : sink(out) {}

  void write_header() {
    sink.text("t,what,name,x,y,z,qw,qx,qy,qz");
    for (const char* symbol : {"q", "qd", "qdd"}) {
      for (std::size_t i = 1; i <= columns.count(); ++i) sink.text(fmt::format(",{}{}", symbol, i));
    }
    sink.text(",text");
    sink.end_line();
  }

  void begin_row(std::int64_t t_ns, std::string_view what, std::string_view name) {
    sink.seconds(t_ns);
    sink.text(",");
    sink.text(what);
    sink.text(",");
    write_field(sink, name);
  }

  void write_pose(const Eigen::Isometry3d& T) {
    const Eigen::Vector3d p = T.translation();
    const Eigen::Quaterniond r = positive_quaternion(T);
    for (const double value : {p.x(), p.y(), p.z(), r.w(), r.x(), r.y(), r.z()}) cell(value);
  }

  void write_joints(std::span<const double> values) {
    for (const double value : values) cell(value);
    skip(columns.count() - values.size());
  }

  void skip(std::size_t cells) { sink.text(std::string(cells, ',')); }

  void end_row(std::string_view text = {}) {
    sink.text(",");
    write_field(sink, text);
    sink.end_line();
  }

  void write_row(std::int64_t t_ns, std::string_view what, std::string_view name,
                 std::string_view text = {}) {
    begin_row(t_ns, what, name);
    skip(kPoseColumns + 3 * columns.count());
    end_row(text);
  }

  static constexpr std::size_t kPoseColumns = 7;
  TextSink sink;
  JointColumns columns;
  std::vector<std::string> robots{};

 private:
  void cell(double value) {
    sink.text(",");
    sink.number(value, kDigits);
  }
};

CsvBackend::CsvBackend(std::ostream& out) : table_(std::make_unique<Table>(out)) {}
CsvBackend::~CsvBackend() = default;

void CsvBackend::begin(const RunInfo& run) {
  for (const RobotInfo& robot : run.robots) {
    table_->robots.push_back(robot.name);
  }
  table_->columns.begin(run);
  table_->write_header();
  for (const ObjectInfo& object : run.objects) object_added(0, object);
}

void CsvBackend::robot_added(std::int64_t, const RobotInfo& robot) {
  table_->robots.push_back(robot.name);
  table_->columns.add(robot);
}

void CsvBackend::joint_sample(const JointSample& sample) {
  if (!table_->columns.hold(sample)) return;
  table_->begin_row(sample.t_ns, "robot", table_->robots[static_cast<std::size_t>(sample.robot)]);
  table_->write_pose(sample.T_world_tool);
  for (const auto values : {sample.q, sample.qd, sample.qdd}) table_->write_joints(values);
  table_->end_row();
}

void CsvBackend::object_added(std::int64_t t_ns, const ObjectInfo& object) {
  object_sample({.t_ns = t_ns, .name = object.name, .T_world_obj = object.T_world_obj});
}

void CsvBackend::object_sample(const ObjectSample& sample) {
  table_->begin_row(sample.t_ns, "object", sample.name);
  table_->write_pose(sample.T_world_obj);
  table_->skip(3 * table_->columns.count());
  table_->end_row();
}

void CsvBackend::object_event(const ObjectEvent& event) {
  const bool has_robot = event.robot >= 0;
  table_->write_row(
      event.t_ns, to_text(event.change), event.name,
      has_robot ? table_->robots[static_cast<std::size_t>(event.robot)] : std::string());
}

void CsvBackend::note(const Note& note) {
  table_->write_row(note.t_ns, to_text(note.kind), {}, note.text);
}

void CsvBackend::end(std::int64_t t_ns) {
  table_->write_row(t_ns, "end", {});
  table_->sink.flush();
}

std::string CsvBackend::error() const {
  return table_->columns.error().empty() ? table_->sink.error() : table_->columns.error();
}

}  // namespace armlet
