#include "armlet/backend/csv_backend.hpp"

#include <iterator>
#include <string_view>

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

class CsvBackend final : public Backend {
 public:
  explicit CsvBackend(std::ostream& out) : sink_(out) {}

  void on(const Event& event) override {
    std::visit(Overload{[this](const auto& each) { write(each); }, kIgnored}, event);
  }
  [[nodiscard]] EventKinds ignores() const override { return kIgnored.kinds(); }

  [[nodiscard]] std::string error() const override {
    return columns_.error().empty() ? sink_.error() : columns_.error();
  }

 private:
  // A row cannot be marked as undone. Where the time goes back, the rows before it are undone.
  static constexpr Ignore<RobotChanged, FigureChanged, FinalFigure, Undone, DrawingChanged,
                          CameraAdded>
      kIgnored{};
  static constexpr std::size_t kPoseColumns = 7;

  void write(const BeginRun& begin) {
    robots_.clear();
    for (const RobotInfo& robot : begin.run.robots) {
      robots_.push_back(robot.name);
    }
    columns_.begin(begin.run);
    write_header();
    for (const ObjectInfo& object : begin.run.objects) write_object(0, object);
  }

  void write(const RobotAdded& added) {
    robots_.push_back(added.robot.name);
    columns_.add(added.robot);
  }

  void write(const JointSample& sample) {
    if (!columns_.hold(sample)) return;
    begin_row(sample.t_ns, "robot", robots_[static_cast<std::size_t>(sample.robot)]);
    write_pose(sample.T_world_tool);
    for (const auto values : {sample.q, sample.qd, sample.qdd}) write_joints(values);
    end_row();
  }

  void write(const ObjectAdded& added) { write_object(added.t_ns, added.object); }

  void write(const ObjectSample& sample) {
    begin_row(sample.t_ns, "object", sample.name);
    write_pose(sample.T_world_obj);
    skip(3 * columns_.count());
    end_row();
  }

  void write(const ObjectEvent& event) {
    const bool has_robot = event.robot >= 0;
    write_row(event.t_ns, to_text(event.change), event.name,
              has_robot ? robots_[static_cast<std::size_t>(event.robot)] : std::string());
  }

  void write(const ImageFrame& frame) {
    begin_row(frame.t_ns, "frame", frame.camera);
    write_pose(frame.T_world_camera);
    skip(3 * columns_.count());
    end_row(frame.file);
  }

  void write(const Note& note) { write_row(note.t_ns, to_text(note.kind), {}, note.text); }

  void write(const EndRun& end) {
    write_row(end.t_ns, "end", {});
    sink_.flush();
  }

  void write_object(std::int64_t t_ns, const ObjectInfo& object) {
    write(ObjectSample{.t_ns = t_ns, .name = object.name, .T_world_obj = object.T_world_obj});
  }

  void write_header() {
    sink_.text("t [s],what,name,x [m],y [m],z [m],qw,qx,qy,qz");
    constexpr std::string_view kSymbols[] = {"q", "qd", "qdd"};
    constexpr std::string_view kPer[] = {"", "/s", "/s^2"};
    for (std::size_t order = 0; order < std::size(kSymbols); ++order) {
      for (std::size_t i = 0; i < columns_.count(); ++i) {
        sink_.text(fmt::format(",{}{}", kSymbols[order], i + 1));
        if (const auto unit = columns_.unit(i))
          sink_.text(fmt::format(" [{}{}]", unit == JointUnit::kRadian ? "rad" : "m", kPer[order]));
      }
    }
    sink_.text(",text");
    sink_.end_line();
  }

  void begin_row(std::int64_t t_ns, std::string_view what, std::string_view name) {
    sink_.seconds(t_ns);
    sink_.text(",");
    sink_.text(what);
    sink_.text(",");
    write_field(sink_, name);
  }

  void write_pose(const Eigen::Isometry3d& T) {
    const Eigen::Vector3d p = T.translation();
    const Eigen::Quaterniond r = positive_quaternion(T);
    for (const double value : {p.x(), p.y(), p.z(), r.w(), r.x(), r.y(), r.z()}) cell(value);
  }

  void write_joints(std::span<const double> values) {
    for (const double value : values) cell(value);
    skip(columns_.count() - values.size());
  }

  void skip(std::size_t cells) { sink_.text(std::string(cells, ',')); }

  void end_row(std::string_view text = {}) {
    sink_.text(",");
    write_field(sink_, text);
    sink_.end_line();
  }

  void write_row(std::int64_t t_ns, std::string_view what, std::string_view name,
                 std::string_view text = {}) {
    begin_row(t_ns, what, name);
    skip(kPoseColumns + 3 * columns_.count());
    end_row(text);
  }

  void cell(double value) {
    sink_.text(",");
    sink_.number(value, kDigits);
  }

  TextSink sink_;
  JointColumns columns_;
  std::vector<std::string> robots_{};
};

}  // namespace

std::unique_ptr<Backend> make_csv_backend(std::ostream& out) {
  return std::make_unique<CsvBackend>(out);
}

}  // namespace armlet
