// Converts the events of a run to its record.

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostObjects = 2000;
constexpr std::size_t kMostLines = 500'000;
constexpr std::size_t kMostAdvice = 2000;

// x, y, z, qw, qx, qy, qz.
std::array<double, 7> numbers_of(const Eigen::Isometry3d& T) {
  const Eigen::Quaterniond turn(T.linear());
  const Eigen::Vector3d p = T.translation();
  return {p.x(), p.y(), p.z(), turn.w(), turn.x(), turn.y(), turn.z()};
}

}  // namespace

void Recording::on(const Event& event) {
  const double t = to_seconds(time_of(event));
  record_.t_end = std::max(record_.t_end, t);
  note_line(t);
  take_ways();
  std::visit(Overload{[](const FigureChanged&) {}, [](const FinalFigure&) {}, [](const Undone&) {},
                      [](const EndRun&) {}, [](const CameraAdded&) {}, [](const ImageFrame&) {},
                      [this](const auto& each) { take(each); }},
             event);
}

// The statement of the task that runs, or has run last.
std::optional<TextSpan> Recording::here() const {
  if (session_ == nullptr || session_->vm() == nullptr) return std::nullopt;
  const Span at = running_at(*session_->vm());
  return at.empty() ? std::nullopt : span_of(session_->sources(), at);
}

// The failure of a button ends only the task that it has started.
void Recording::on_press(const PressReport& report) {
  if (!report.failure) return;
  const TextMessage told = resolved(*report.failure, session_->sources());
  record_.texts.push_back({to_seconds(report.end_ns), NoteKind::kMessage, told.message,
                           told.place.span, report.button});
}

void Recording::on_advice(const Diagnostic& advice) {
  if (record_.advice.size() >= kMostAdvice) return;
  TextMessage told = resolved(advice, session_->sources());
  if (!told.t) told.t = to_seconds(session_->host()->now_ns());
  record_.advice.push_back(std::move(told));
}

void Recording::on_wait() {
  const double t = to_seconds(session_->host()->now_ns());
  note_line(t);
  take_ways();
  take_stretches(t);
  take_forces_at_rest(t);
}

void Recording::on_slice() {
  if (session_->host() != nullptr) note_line(to_seconds(session_->host()->now_ns()));
}

void Recording::on_end() {
  take_ways();
  record_.drawings.flush();
  if (session_->host() == nullptr) return;
  const double t = to_seconds(session_->host()->now_ns());
  take_forces_at_rest(t);
  // An open interval is recorded up to the present end; if the run continues, so does the interval.
  for (Going& each : going_) {
    end_stretch(each, t);
    each.t0 = t;
  }
}

void Recording::note_line(double t) {
  if (session_ == nullptr || session_->vm() == nullptr) return;
  const Span at = running_at(*session_->vm());
  if (at.empty() || at.source != session_->sources().first()) return;
  const int line = session_->sources().position(at).line;
  std::vector<RecordedLine>& lines = record_.lines;
  if (!lines.empty() && lines.back().line == line) return;
  if (lines.size() < kMostLines) lines.push_back({t, line});
}

// ---- robots ---------------------------------------------------------------------------------

void Recording::take(const BeginRun& begin) {
  for (const RobotInfo& robot : begin.run.robots) add_robot(robot);
  for (const ObjectInfo& object : begin.run.objects) add_object(object, to_seconds(begin.t_ns));
}

void Recording::take(const RobotAdded& added) { add_robot(added.robot); }

// Only new files count; a file that another run shows already needs no memory.
std::string Recording::keep_file(FileBytes& bytes) {
  if (bytes == nullptr) return {};
  const FileBytes given = bytes;
  std::string name = files_.keep(bytes);
  if (bytes == given) record_.file_bytes += bytes->size();
  return name;
}

void Recording::keep_pictures(LabElements& lab) {
  lab.pictures.clear();
  for (LabRow& row : lab.rows.rows) lab.pictures.push_back(keep_file(row.picture));
}

void Recording::add_robot(const RobotInfo& robot) {
  RecordedRobot& added = record_.robots.emplace_back(RecordedRobot{.info = robot});
  for (LinkPicture& each : added.info.pictures) added.pictures.push_back(keep_file(each.glb));
  record_.robot_rows.emplace_back(1 + 3 * robot.joints.size() + 7);
  record_.force_rows.emplace_back(1 + robot.joints.size());
  record_.contact_rows.emplace_back(7);
  motions_.emplace_back();
  forces_.emplace_back();
  touches_.emplace_back();
  ++record_.described;
  look_at_models();
}

void Recording::take(const RobotChanged& changed) {
  const auto index = static_cast<std::size_t>(changed.index);
  const Host* host = session_->host();
  const bool is_known = host != nullptr && changed.index < host->cell().robot_count();
  record_.robots[index].changes.push_back(
      {to_seconds(changed.t_ns), changed.robot,
       is_known ? host->cell().robot(changed.index).model : record_.robots[index].model});
  ++record_.described;
}

void Recording::look_at_models() {
  const Host* host = session_ == nullptr ? nullptr : session_->host();
  if (host == nullptr) return;
  if (record_.world != host->world_name()) {
    record_.world = host->world_name();
    ++record_.described;
  }
  for (std::size_t i = 0; i < record_.robots.size(); ++i) {
    std::shared_ptr<const Robot>& model = record_.robots[i].model;
    if (model == nullptr && static_cast<int>(i) < host->cell().robot_count())
      model = host->cell().robot(static_cast<int>(i)).model;
  }
}

void Recording::take(const JointSample& sample) {
  const auto index = static_cast<std::size_t>(sample.robot);
  const double t = to_seconds(sample.t_ns);
  Motion& motion = motions_[index];
  const bool is_other = sample.motion != motion.number;
  if (is_other) {
    end_motion(sample.robot);
    motion.number = sample.motion;
    motion.move = {.robot = sample.robot, .motion = sample.motion, .span = here(), .t0 = t};
  }
  std::vector<double> row{t};
  row.reserve(1 + 3 * sample.q.size() + 7);
  for (const auto& part : {sample.q, sample.qd, sample.qdd})
    row.insert(row.end(), part.begin(), part.end());
  const auto pose = numbers_of(sample.T_world_tool);
  row.insert(row.end(), pose.begin(), pose.end());
  motion.move.t1 = t;
  motion.move.p_end = sample.T_world_tool.translation();
  record_.robot_rows[index].add(row, is_other);
  motion.last_row = std::move(row);
  take_forces(sample);
  take_contacts(sample.robot, t);
}

// A motion is recorded at its last sample; the report of the move comes after that.
void Recording::end_motion(int robot) {
  Motion& motion = motions_[static_cast<std::size_t>(robot)];
  if (motion.number >= 0) {
    Rows& rows = record_.robot_rows[static_cast<std::size_t>(robot)];
    if (rows.rows(rows.count() - 1, 1)[0] != motion.last_row[0]) rows.add(motion.last_row, true);
    record_.moves.push_back(motion.move);
  }
  motion.number = -1;
}

void Recording::on_move(const FinishedMove& report) {
  const std::optional<int> robot = record_.find_robot(report.robot);
  if (!robot) return;
  Motion& motion = motions_[static_cast<std::size_t>(*robot)];
  // A move to where the robot is has no samples; it counts, too.
  const bool has_samples = motion.number >= 0;
  if (!has_samples) motion.move = {.robot = *robot, .p_end = motion.move.p_end};
  motion.move.t0 = report.start;
  motion.move.t1 = report.start + report.duration;
  motion.move.text = report.function;
  motion.move.stopped = report.stopped;
  // The task whose move has ended continues now; at its start another task may have run last.
  if (const std::optional<TextSpan> place = here()) motion.move.span = place;
  if (!has_samples) record_.moves.push_back(motion.move);
  end_motion(*robot);
}

// ---- objects --------------------------------------------------------------------------------

std::optional<int> Recording::find_object(std::string_view name) const {
  for (std::size_t i = record_.objects.size(); i > 0; --i) {
    if (record_.objects[i - 1].name == name) return static_cast<int>(i - 1);
  }
  return std::nullopt;
}

void Recording::take(const ObjectAdded& added) { add_object(added.object, to_seconds(added.t_ns)); }

void Recording::add_object(const ObjectInfo& object, double t) {
  if (record_.objects.size() >= kMostObjects) return;
  ObjectInfo& added = record_.objects.emplace_back(object);
  record_.object_files.push_back(
      {.glb = keep_file(added.glb), .texture = keep_file(added.texture)});
  record_.object_places.push_back(t > 0.0 ? here() : std::nullopt);
  record_.object_rows.emplace_back(8);
  record_.events.push_back({t, "added", static_cast<int>(record_.objects.size() - 1), -1});
  ++record_.described;
}

void Recording::look_at_objects() {
  if (looked_at_ == record_.objects.size() || session_->vm() == nullptr) return;
  const std::vector<SeenVariable> variables = seen_variables(*session_->vm());
  for (; looked_at_ < record_.objects.size(); ++looked_at_) {
    const auto known =
        std::ranges::find(variables, record_.objects[looked_at_].name, &SeenVariable::name);
    std::optional<TextSpan>& place = record_.object_places[looked_at_];
    if (place || known == variables.end() || known->type != "object") continue;
    place = span_of(session_->sources(), known->declared);
    ++record_.described;
  }
}

void Recording::take(const ObjectSample& sample) {
  const std::optional<int> object = find_object(sample.name);
  if (!object) return;
  std::array<double, 8> row{to_seconds(sample.t_ns)};
  std::ranges::copy(numbers_of(sample.T_world_obj), row.begin() + 1);
  record_.object_rows[static_cast<std::size_t>(*object)].add(row);
}

void Recording::take(const ObjectEvent& event) {
  const std::optional<int> object = find_object(event.name);
  if (!object) return;
  record_.events.push_back(
      {to_seconds(event.t_ns), std::string(to_text(event.change)), *object, event.robot});
}

void Recording::take(const DrawingChanged& changed) {
  const double t = to_seconds(changed.t_ns);
  record_.drawings.take(changed, t, t > 0.0 ? here() : std::nullopt);
}

// ---- texts and figures ----------------------------------------------------------------------

void Recording::take(const Note& note) {
  record_.texts.push_back({to_seconds(note.t_ns), note.kind, std::string(note.text), here(), {}});
}

}  // namespace armlet::lab
