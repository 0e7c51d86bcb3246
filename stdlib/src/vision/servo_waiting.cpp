#include "vision/servo_waiting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/interpreter/host/taken_failure.hpp"
#include "armlet/interpreter/work.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/joint.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/motion_torques.hpp"
#include "values/eigen_results.hpp"
#include "values/world/pictures.hpp"
#include "vision/capture.hpp"
#include "vision/features.hpp"

namespace armlet::bind {
namespace {

// Kinds of failures of `features` that mean that the points are not in this picture.
constexpr std::string_view kNotFound[] = {"FeatureLost", "NoFeatures"};

Eigen::MatrixXd jacobian_of_camera(const Robot& robot, const Eigen::VectorXd& q,
                                   const Eigen::Isometry3d& T_tool_camera) {
  Jacobian J;
  const Eigen::Isometry3d T_world_tool = forward_and_jacobian(robot, q, J);
  return camera_jacobian(J, T_world_tool.linear(), T_tool_camera);
}

// The points that corners or update found beside those that are lost. They count if they lie where
// they are expected: `features` may have looked for them in a part of the picture, or for others.
void take_found(const FailureDetail* detail, const PlanePoints& expected, ServoSight& sight) {
  const auto* found = dynamic_cast<const FoundCorners*>(detail);
  if (found == nullptr || found->points.rows() != expected.rows()) return;
  std::vector<Eigen::Index> missing(found->lost.begin(), found->lost.end());
  for (Eigen::Index i = 0; i < expected.rows(); ++i) {
    const bool is_lost = std::find(missing.begin(), missing.end(), i) != missing.end();
    if (!is_lost && !((found->points.row(i) - expected.row(i)).norm() <= found->within)) return;
  }
  if (static_cast<Eigen::Index>(missing.size()) == expected.rows()) return;
  sight.pixels = found->points;
  sight.missing = std::move(missing);
}

// Rows of equal length as a matrix; null: it failed.
template <class Row>
MatrixObj* rows_matrix(Vm& vm, const std::vector<ServoRow>& rows, Eigen::Index columns, Row row) {
  MatrixObj* matrix = new_matrix_unset(vm, static_cast<std::uint32_t>(rows.size()),
                                       static_cast<std::uint32_t>(columns));
  for (std::size_t i = 0; matrix != nullptr && i < rows.size(); ++i) {
    const auto values = row(rows[i]);
    std::copy(values, values + columns, matrix->data() + i * static_cast<std::size_t>(columns));
  }
  return matrix;
}
Obj* number_list(Vm& vm, const std::vector<ServoRow>& rows, double ServoRow::*number) {
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(rows.size()), false);
  for (std::size_t i = 0; list != nullptr && i < rows.size(); ++i)
    list->data[i].d = rows[i].*number;
  return list;
}

class ServoWaiting : public Waiting {
 public:
  ServoWaiting(Vm& vm, ServoCall call, VisualServo servo)
      : vm_(vm),
        host_(Host::of(vm)),
        call_(std::move(call)),
        servo_(std::move(servo)),
        begin_ns_(host_.now_ns()),
        next_ns_(frame_after(begin_ns_)) {
    retain(call_.features);
  }
  ServoWaiting(const ServoWaiting&) = delete;
  ServoWaiting& operator=(const ServoWaiting&) = delete;
  ~ServoWaiting() override { release(vm_, call_.features); }

  // Takes a picture, and moves the arm until the next one.
  Answer<void> step(Vm& vm) {
    // While nothing moves, another task may have moved the arm.
    if (!moves() && !host_.cell().can_drive(call_.robot) && !check_idle(vm, call_.robot))
      return Failed{};
    auto sight = seen_now(vm);
    if (!sight || !keep_row(vm)) return Failed{};
    Eigen::VectorXd qd;
    try {
      qd = servo_.look(*sight);
    } catch (const ArgumentError& error) {
      return fail_servo(vm, clause_of(error), at("features"));
    }
    is_done_ = servo_.end() != ServoEnd::kNone;
    if (is_done_) return {};
    next_ns_ = has_rate() ? frame_after(next_ns_ + call_.period_ns - frame_ns() / 2)
                          : next_ns_ + call_.period_ns;
    return drive(vm, std::move(qd));
  }

  // Whether the first picture is taken at once.
  [[nodiscard]] bool starts_now() const { return !has_rate(); }

  [[nodiscard]] std::int64_t due_ns() const override {
    if (!moves()) return is_done_ ? host_.now_ns() : next_ns_;
    const std::int64_t known = host_.cell().known_until(motion_);
    return is_done_ ? known : std::min(known, next_ns_);
  }
  [[nodiscard]] bool is_over() const override { return is_done_ && !moves(); }
  [[nodiscard]] bool has_work() const override {
    return !is_done_ && (host_.now_ns() >= next_ns_ || was_interrupted());
  }
  bool work(Vm& vm) override {
    if (!was_interrupted()) return static_cast<bool>(step(vm));
    is_done_ = true;
    return true;
  }
  void stop() override {
    is_done_ = is_stopped_ = true;
    if (moves()) host_.cell().stop(call_.robot);
  }
  Signal finish(Vm& vm, Slot& result) override {
    host_.report_move({state().name, "visualServo", to_seconds(begin_ns_),
                       to_seconds(host_.now_ns() - begin_ns_), is_stopped_,
                       host_.cell().T_world_tool(call_.robot)});
    if (motion_ >= 0 && report().halted) {
      Failure f;
      f.headline = Headline(row("R0618"));
      f.resource = resource();
      f.moved = true;
      return fail(vm, std::move(f));
    }
    if (motion_ >= 0 && !check_overload(vm, motion_call(), report())) return Signal::kFail;
    return give(&result, made_run(vm));
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("visualServo of {}", state().name);
  }
  [[nodiscard]] Resource resource() const override { return robot_called(state().name); }

 private:
  [[nodiscard]] const CellRobot& state() const { return host_.cell().robot(call_.robot); }
  [[nodiscard]] const MotionReport& report() const { return host_.cell().report(motion_); }
  [[nodiscard]] bool moves() const {
    return motion_ >= 0 && report().state == MotionState::kRunning;
  }
  [[nodiscard]] bool was_interrupted() const {
    return motion_ >= 0 && (report().halted || report().overload);
  }
  [[nodiscard]] MoveCall motion_call() const {
    return {.function = "visualServo", .robot = call_.robot};
  }

  [[nodiscard]] double rate() const { return host_.cell().cameras().at(call_.camera.id).rate; }
  [[nodiscard]] bool has_rate() const { return rate() > 0.0; }
  [[nodiscard]] std::int64_t frame_ns() const { return to_ns(1.0 / rate()); }
  // The next picture of a camera with a rate; of others, the same instant.
  [[nodiscard]] std::int64_t frame_after(std::int64_t ns) const {
    return host_.cell().cameras().next_frame_ns(call_.camera.id, ns);
  }

  // Charges one more row of the table.
  Answer<void> keep_row(Vm& vm) {
    constexpr std::size_t kRows = 256;
    if (servo_.rows().size() < kRows * room_.size()) return {};
    const std::size_t numbers =
        24 + 4 * static_cast<std::size_t>(servo_.wanted_points() + state().q.size());
    auto room = std::make_unique<Scratch>(vm, kRows * numbers * sizeof(double));
    if (!room->granted()) return Failed{};
    room_.push_back(std::move(room));
    return {};
  }

  // The picture of this instant, and the points that the program finds in it.
  Answer<ServoSight> seen_now(Vm& vm) {
    const auto T_world_camera = pose_now(vm, call_.camera);
    if (!T_world_camera) return Failed{};
    const Eigen::Isometry3d T_tool_camera =
        host_.cell().T_world_tool(call_.robot).inverse(Eigen::Isometry) * *T_world_camera;
    ServoSight sight{.t = to_seconds(host_.now_ns() - begin_ns_)};
    const PlanePoints expected = servo_.rows().empty() ? call_.start : servo_.expected(state().qd);
    auto image = capture(vm, call_.camera, nullptr);
    if (!image || !find_points(vm, *std::move(image), expected, sight)) return Failed{};
    sight.q = state().q;
    sight.qd = state().qd;
    sight.J_camera = jacobian_of_camera(*state().model, sight.q, T_tool_camera);
    return sight;
  }

  Answer<void> find_points(Vm& vm, Image image, const PlanePoints& expected, ServoSight& sight) {
    Slot arguments[2];
    arguments[0].o = new_picture(vm, std::move(image));
    if (arguments[0].o == nullptr) return Failed{};
    arguments[1].o = nullptr;
    Signal ready = Signal::kDone;
    if (call_.expected)
      ready = Given<Eigen::MatrixXd>::leave(vm, Eigen::MatrixXd(expected), arguments[1]);
    Slot found;
    const bool done = ready == Signal::kDone &&
                      vm.call(call_.features, {arguments, call_.expected ? 2U : 1U}, found);
    release(vm, arguments[0].o);
    if (arguments[1].o != nullptr) release(vm, arguments[1].o);
    if (!done) {
      auto taken = take_failure(vm, kNotFound);
      if (!taken) return Failed{};
      sight.lost = std::move(taken->message);
      take_found(taken->detail.get(), expected, sight);
      return {};
    }
    auto points = pixels_of(vm, matrix_value(found), at("features"), " that `features` gives");
    release(vm, found.o);
    if (!points) return Failed{};
    sight.pixels = *std::move(points);
    return {};
  }

  // Sets joint speeds until the next picture; lower ones if the arm could not stop in time.
  Answer<void> drive(Vm& vm, Eigen::VectorXd rates) {
    if ((rates.array() == 0.0).all() && !moves()) return {};
    const std::int64_t now = host_.now_ns();
    const VelocityStart from{
        .q = state().q, .qd = state().qd, .qdd = state().qdd, .during = to_seconds(next_ns_ - now)};
    VelocityPlan plan = plan_joint_velocity(*state().model, from, rates);
    constexpr int kSlower = 6;
    for (int i = 0; i < kSlower && !plan.motion; ++i) {
      rates *= 0.5;
      plan = plan_joint_velocity(*state().model, from, rates);
    }
    if (!plan.motion) {
      servo_.finish(ServoEnd::kJointLimit, why_not(plan));
      is_done_ = true;
      return {};
    }
    if (!check_velocity_torques(vm, motion_call(), *plan.motion, next_ns_ - now)) return Failed{};
    report_rest(vm, call_.robot);
    Trajectory path = *plan.motion;
    motion_ = host_.cell().drive(call_.robot, *std::move(plan.motion), next_ns_);
    remember_rest(vm, motion_call(), std::move(path), motion_);
    return {};
  }
  [[nodiscard]] std::string why_not(const VelocityPlan& plan) const {
    const int joint = plan.outside ? plan.outside->joint : plan.too_high ? plan.too_high->joint : 0;
    const Joint& at = state().model->joint(joint);
    return fmt::format(
        "joint {} stands at {} within {} to {} and cannot take up the speed of the law", joint + 1,
        format_joint_value(at.kind, state().q[joint]), format_joint_value(at.kind, at.lower),
        format_joint_value(at.kind, at.upper));
  }

  // Makes a ServoRun; null: it failed.
  RecordObj* made_run(Vm& vm) {
    servo_.finish(ServoEnd::kStopped, "the call was stopped");
    RecordObj* record = new_record(vm, vm.program().library_record("ServoRun"));
    if (record == nullptr) return nullptr;
    const std::vector<ServoRow>& rows = servo_.rows();
    std::size_t next = 0;
    const auto put = [&](Obj* field) {
      record->fields()[next++].o = field;
      return field != nullptr;
    };
    const Eigen::Index k = 2 * servo_.wanted_points();
    Slot blind;
    const bool done =
        put(new_text(vm, name_of(servo_.end()))) && put(new_text(vm, servo_.why())) &&
        put(number_list(vm, rows, &ServoRow::t)) && put(number_list(vm, rows, &ServoRow::error)) &&
        put(rows_matrix(vm, rows, 6, [](const ServoRow& r) { return r.twist.data(); })) &&
        put(rows_matrix(vm, rows, k, [](const ServoRow& r) { return r.points.data(); })) &&
        put(number_list(vm, rows, &ServoRow::smallest)) &&
        put(number_list(vm, rows, &ServoRow::condition)) &&
        put(rows_matrix(vm, rows, state().q.size(),
                        [](const ServoRow& r) { return r.qd.data(); })) &&
        Given<Eigen::MatrixXd>::leave(vm, servo_.uncontrollable(), blind) == Signal::kDone &&
        put(blind.o) && put(new_text(vm, servo_.explanation()));
    if (done) return record;
    release(vm, record);
    return nullptr;
  }

  Vm& vm_;
  Host& host_;
  ServoCall call_;
  VisualServo servo_;
  std::int64_t begin_ns_, next_ns_;
  std::vector<std::unique_ptr<Scratch>> room_;  // for rows, charged against the heap limit
  int motion_ = -1;
  bool is_done_ = false;
  bool is_stopped_ = false;
};

}  // namespace

Failed fail_servo(Vm& vm, std::string_view clause, CallPart part, std::string fix) {
  Failure f;
  f.headline = {row("R0690"), {std::string(clause)}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

ServoArm servo_arm(const Robot& robot, const Eigen::Isometry3d& T_tool_camera) {
  const Eigen::Index n = robot.n();
  ServoArm arm{.lower = Eigen::VectorXd(n),
               .upper = Eigen::VectorXd(n),
               .max_speed = Eigen::VectorXd(n),
               .max_accel = Eigen::VectorXd(n),
               .turns = {},
               .rank = 0};
  for (int i = 0; i < robot.n(); ++i) {
    const Joint& joint = robot.joint(i);
    const bool is_endless = joint.is_continuous();
    arm.lower[i] = is_endless ? -HUGE_VAL : joint.lower;
    arm.upper[i] = is_endless ? HUGE_VAL : joint.upper;
    arm.max_speed[i] = joint.max_speed > 0.0 ? joint.max_speed : HUGE_VAL;
    arm.max_accel[i] = joint.max_accel > 0.0 ? joint.max_accel : HUGE_VAL;
    arm.turns.push_back(joint.is_revolute());
  }
  Random random(1);  // random postures, of which at least one is not singular
  constexpr int kSamples = 8;
  Eigen::VectorXd q(n);
  for (int k = 0; k < kSamples; ++k) {
    for (Eigen::Index i = 0; i < n; ++i)
      q[i] = std::isfinite(arm.lower[i]) ? random.uniform(arm.lower[i], arm.upper[i])
                                         : random.uniform(-1.0, 1.0);
    arm.rank = std::max(arm.rank, camera_directions(jacobian_of_camera(robot, q, T_tool_camera)));
  }
  return arm;
}

Started start_servo(Vm& vm, const ServoCall& call, VisualServo servo) {
  auto waiting = std::make_unique<ServoWaiting>(vm, call, std::move(servo));
  if (waiting->starts_now() && !waiting->step(vm)) return Failed{};
  return std::unique_ptr<Waiting>(std::move(waiting));
}

}  // namespace armlet::bind
