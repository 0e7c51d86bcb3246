// Velocity commands (language reference, sections 13.2 and 19).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/motion_torques.hpp"
#include "moves/moves.hpp"
#include "values/bind.hpp"
#include "values/time_left.hpp"
#include "values/values.hpp"
#include "values/world/cameras.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {
namespace {

// Waits from a velocity command until it no longer holds; the robot then decelerates to rest unless
// the task continues with another command at that instant. A command that is stopped has ended when
// the robot is at rest.
class VelocityWaiting : public Waiting {
 public:
  VelocityWaiting(Host& host, const MoveCall& call, int motion)
      : host_(host), function_(call.function), robot_(call.robot), motion_(motion) {}

  [[nodiscard]] std::int64_t due_ns() const override {
    const std::int64_t known = host_.cell().known_until(motion_);
    return slows_down() ? known : std::min(known, *report().held_ns);
  }
  [[nodiscard]] bool is_over() const override {
    if (report().state != MotionState::kRunning) return true;
    return !slows_down() && host_.now_ns() >= *report().held_ns;
  }
  void stop() override {
    if (report().state != MotionState::kRunning) return;
    stopped_ = true;
    host_.cell().stop(robot_);
  }
  Signal finish(Vm& vm, Slot&) override {
    if (!report().halted) {
      const MoveCall call{.function = function_, .robot = robot_};
      return check_overload(vm, call, report()) ? Signal::kDone : Signal::kFail;
    }
    Failure f;
    f.headline = Headline(row("R0618"));
    f.resource = resource();
    f.moved = report().end_ns > report().start_ns;
    return fail(vm, std::move(f));
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("{} of {}", function_, resource().name);
  }
  [[nodiscard]] Resource resource() const override {
    return robot_called(host_.cell().robot(robot_).name);
  }

 private:
  [[nodiscard]] const MotionReport& report() const { return host_.cell().report(motion_); }
  [[nodiscard]] bool slows_down() const { return stopped_ || report().halted || report().overload; }

  Host& host_;
  std::string function_;
  int robot_;
  int motion_;
  bool stopped_ = false;
};

Failure refusal(Vm& vm, const MoveCall& call) {
  Failure f;
  f.mark = call.target;
  f.resource = robot_called(Host::of(vm).cell().robot(call.robot).name);
  return f;
}

std::string rate_text(JointKind kind, LimitKind limit, double value) {
  static constexpr const char* kPer[] = {"/s", "/s^2", "/s^3"};
  return format_joint_value(kind, value) + kPer[static_cast<int>(limit)];
}

Failed fail_velocity(Vm& vm, const MoveCall& call, const VelocityPlan& plan) {
  const Robot& robot = model_of(vm, call);
  if (plan.too_high) {
    static constexpr const char* kVerbs[] = {"move", "gain speed", "gain acceleration"};
    const RateTooHigh& high = *plan.too_high;
    const JointKind kind = robot.joint(high.joint).kind;
    Failure f = refusal(vm, call);
    f.headline =
        Headline::own(row("R0604"), fmt::format("joint {} would have to {} by {}; its limit is {}",
                                                high.joint + 1, kVerbs[static_cast<int>(high.kind)],
                                                rate_text(kind, high.kind, high.value),
                                                rate_text(kind, high.kind, high.limit)));
    if (call.function == "speedC")
      f.why = "near a posture where the arm is singular the joints run fast for a slow hand";
    f.fix = "ask for less speed";
    return fail(vm, std::move(f));
  }
  if (plan.outside) {
    const Joint& joint = robot.joint(plan.outside->joint);
    Failure f = refusal(vm, call);
    f.headline = {
        row("R0602"),
        {std::to_string(plan.outside->joint + 1), std::string(joint_word(joint.kind)),
         format_joint_value(joint.kind, plan.outside->value, plan.outside->limit),
         format_joint_value(joint.kind, joint.lower), format_joint_value(joint.kind, joint.upper)}};
    f.why = "the way on which it would stop counts, so that it can always stop in time";
    f.fix = "hold the velocity for a shorter time, or ask for less speed";
    return fail(vm, std::move(f));
  }
  Failure f = refusal(vm, call);
  f.headline = {row("R0601"), {"no joint speeds give the hand this velocity"}};
  f.why = fmt::format("the nearest that this arm can do differs by {} % of it",
                      format_number(100.0 * plan.lacking, 1));
  f.fix = "leave out what the arm cannot do, or move away from where it is singular";
  return fail(vm, std::move(f));
}

// Fails while the robot is moved by another command.
Answer<void> check_drivable(Vm& vm, const MoveCall& call) {
  if (Host::of(vm).cell().can_drive(call.robot)) return {};
  return check_idle(vm, call.robot);
}

// `during` in whole nanoseconds, the unit of the clock.
Answer<std::int64_t> holding_time(Vm& vm, double seconds, CallPart part) {
  if (!std::isfinite(seconds)) return not_finite(vm, "the time", seconds, part);
  if (!check_time_left(vm, "a velocity", seconds, part)) return Failed{};
  const std::int64_t ns = seconds > 0.0 ? to_ns(seconds) : 0;
  if (ns > 0) return ns;
  return domain_failure(vm, "a velocity held for a time", seconds, "be longer than 0 s", {}, part);
}

Started drive(Vm& vm, const MoveCall& call, VelocityPlan plan, std::int64_t during_ns) {
  if (!plan.motion) return fail_velocity(vm, call, plan);
  if (!check_time_left(vm, "a motion", plan.motion->duration(), CallPart::callee()))
    return Failed{};
  if (!check_velocity_torques(vm, call, *plan.motion, during_ns)) return Failed{};
  Host& host = Host::of(vm);
  report_rest(vm, call.robot);
  Trajectory path = *plan.motion;
  const int motion =
      host.cell().drive(call.robot, *std::move(plan.motion), host.now_ns() + during_ns);
  remember_rest(vm, call, std::move(path), motion);
  return std::unique_ptr<Waiting>(std::make_unique<VelocityWaiting>(host, call, motion));
}

VelocityStart start_of(Vm& vm, const MoveCall& call, std::int64_t during_ns) {
  const CellRobot& state = Host::of(vm).cell().robot(call.robot);
  return {.q = state.q, .qd = state.qd, .qdd = state.qdd, .during = to_seconds(during_ns)};
}

Started speed_j(Vm& vm, const RobotRef& r, std::span<const double> values, double seconds) {
  const MoveCall call{.function = "speedJ", .robot = r.id, .target = at("rates")};
  if (!check_drivable(vm, call)) return Failed{};
  const auto during = holding_time(vm, seconds, at("during"));
  if (!during) return Failed{};
  const Robot& robot = model_of(vm, call);
  if (values.size() != static_cast<std::size_t>(robot.n())) {
    return failure(vm, "R0613",
                   fmt::format("{} joint speeds for a robot with {} joint{}", values.size(),
                               robot.n(), robot.n() == 1 ? "" : "s"),
                   at("rates"));
  }
  const Eigen::VectorXd rates =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  if (!rates.allFinite()) return not_finite(vm, "a joint speed", rates.sum(), at("rates"));
  return drive(vm, call, plan_joint_velocity(robot, start_of(vm, call, *during), rates), *during);
}

// A velocity given in axes that are rotated by R, and its duration.
struct Drift {
  std::span<const double> values;
  Eigen::Matrix3d R;
  double seconds;
};
Started speed_c(Vm& vm, const RobotRef& r, const Drift& drift) {
  MoveCall call{.function = "speedC", .robot = r.id, .target = at("v")};
  if (!check_drivable(vm, call)) return Failed{};
  const auto during = holding_time(vm, drift.seconds, at("during"));
  if (!during) return Failed{};
  const std::span<const double> values = drift.values;
  if (values.size() != 6) {
    return failure(vm, "R0613",
                   fmt::format("the velocity of a hand has 6 values, not {}", values.size()),
                   at("v"), "they are vx, vy, vz in m/s and wx, wy, wz in rad/s");
  }
  const Vector6d v = Eigen::Map<const Vector6d>(values.data());
  if (!v.allFinite()) return not_finite(vm, "a velocity", v.sum(), at("v"));
  Vector6d twist;
  twist << drift.R * v.head<3>(), drift.R * v.tail<3>();
  choose_model(vm, call, {}, 1.0);
  VelocityStart start = start_of(vm, call, *during);
  Host& host = Host::of(vm);
  constexpr double kSame = 1e-12;  // relative
  if (const LastVelocity* last = host.last_velocity(call.robot)) {
    start.fastest = last->take_up.fastest;
    const bool goes_on = host.cell().report(last->motion).held_ns == host.now_ns();
    if (goes_on && (last->twist - twist).norm() <= kSame * twist.norm()) start.same = last->take_up;
  }
  VelocityPlan plan = plan_tool_velocity(model_of(vm, call), start, twist);
  const ToolTakeUp take_up = plan.take_up;
  auto started = drive(vm, call, std::move(plan), *during);
  if (started) {
    const int motion = host.cell().robot(call.robot).motion_id;
    host.remember_velocity(call.robot, {.motion = motion, .twist = twist, .take_up = take_up});
  }
  return started;
}

// Along the axes of the frame of the blocks around the call, or of the world.
Started speed_c_world(Vm& vm, const RobotRef& r, std::span<const double> v, double during) {
  const auto axes =
      in_world(vm, {.function = "speedC", .robot = r.id, .target = at("v")}, {}, PosC{});
  if (!axes) return Failed{};
  return speed_c(vm, r, {v, axes->T.linear(), during});
}
Started speed_c_frame(Vm& vm, const RobotRef& r, std::span<const double> v, const PosC& frame,
                      double during) {
  return speed_c(vm, r, {v, frame.T.linear(), during});
}
Started speed_c_object(Vm& vm, const RobotRef& r, std::span<const double> v, const ObjectRef& frame,
                       double during) {
  const Object* object = find_object(vm, frame.name);
  if (object == nullptr) return fail_unknown_object(vm, frame.name, at("frame"));
  return speed_c(vm, r, {v, object->T_world_obj.linear(), during});
}
Started speed_c_named(Vm& vm, const RobotRef& r, std::span<const double> v, const FrameRef& frame,
                      double during) {
  const auto now = frame_now(vm, frame, at("frame"));
  if (!now) return Failed{};
  return speed_c(vm, r, {v, now->T.linear(), during});
}

// A camera velocity along the camera's axes, converted to the tool point of the arm that carries
// the camera.
Started speed_c_camera(Vm& vm, const RobotRef& r, std::span<const double> v,
                       const CameraRef& camera, double during) {
  const auto T_world_camera = pose_now(vm, camera);
  if (!T_world_camera) return Failed{};
  Cell& cell = Host::of(vm).cell();
  const Mount& on = cell.cameras().at(camera.id).on;
  const int carrier =
      on.base == FrameBase::kFrame ? cell.world().mount_of_frame(on.on).carrier : on.carrier;
  const CellRobot& arm = cell.robot(r.id);
  if (carrier != r.id && (arm.on < 0 || carrier != arm.on)) {
    return fail_blind(vm, fmt::format("`{}` does not carry it", arm.name), at("frame"),
                      "give the velocity in the frame of a camera that is on the arm");
  }
  if (v.size() != 6) return speed_c(vm, r, {v, Eigen::Matrix3d::Identity(), during});
  const Eigen::Matrix3d& R = T_world_camera->linear();
  const Eigen::Vector3d w = R * Eigen::Vector3d(v[3], v[4], v[5]);
  const Eigen::Vector3d to_tool =
      cell.T_world_tool(r.id).translation() - T_world_camera->translation();
  const Eigen::Vector3d moved = R * Eigen::Vector3d(v[0], v[1], v[2]) + w.cross(to_tool);
  const std::array<double, 6> twist{moved.x(), moved.y(), moved.z(), w.x(), w.y(), w.z()};
  return speed_c(vm, r, {twist, Eigen::Matrix3d::Identity(), during});
}

constexpr std::string_view kSpeedJHelp =
    "Takes up these joint speeds (rad/s, m/s) within the limits on acceleration and jerk and holds "
    "them; "
    "during is the whole time. A velocity command that follows at once goes on without a step, "
    "otherwise the robot then stops under control.";
constexpr std::string_view kSpeedCHelp =
    "Moves the tool point with this velocity: vx, vy, vz in m/s, wx, wy, wz in rad/s along the "
    "axes of the frame, the world's if there is none. The rest as for speedJ.";

constexpr NativeFunction kVelocityFunctions[] = {
    def<speed_j>("speedJ(r: robot, rates: double[], during: time)", kSpeedJHelp,
                 "speedJ([0.2, 0.1, 0.0, 0.0], during: 500ms)", {.pauses = true}),
    def<speed_c_world>(
        "speedC(r: robot, v: double[], during: time)", kSpeedCHelp,
        "moveJ(xyz(300mm, 200mm, 150mm)); speedC([0.05, 0.0, 0.0, 0.0, 0.0, 0.0], during: 500ms)",
        {.pauses = true}),
    def<speed_c_frame, speed_c_object, speed_c_named>(
        "speedC(r: robot, v: double[], frame: posC | object | frame, during: time)", kSpeedCHelp,
        "moveJ(xyz(300mm, 200mm, 150mm)); speedC([0.05, 0.0, 0.0, 0.0, 0.0, 0.0], frame: "
        "rotZ(90deg), during: 500ms)",
        {.pauses = true}),
    def<speed_c_camera>("speedC(r: robot, v: double[], frame: camera, during: time)",
                        "Moves the arm so that the camera that it carries has this velocity along "
                        "its own axes: vx, "
                        "vy, vz in m/s, wx, wy, wz in rad/s, as interactionMatrix takes it. The "
                        "rest as for speedJ.",
                        "robot one = robots.scara(); one.moveJ(xyz(300mm, 200mm, 200mm)); camera "
                        "eye { on: one } one.speedC([0.0, "
                        "0.0, 0.02, 0.0, 0.0, 0.0], frame: eye, during: 500ms)",
                        {.pauses = true}),
};

}  // namespace

std::span<const NativeFunction> velocity_functions() { return kVelocityFunctions; }

}  // namespace armlet::bind
