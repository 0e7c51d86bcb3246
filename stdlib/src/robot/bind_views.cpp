// The read-only variables of the 2011 platform that show the present state of a robot: A01, q1,
// q_current, qLimits, vpp and app (language reference, section 18).

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "armlet/kinematics/forward.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/robots/robot_state.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// The number in "q3" and "A03"; 0 in a name without a number.
int joint_in(std::string_view name) {
  const std::size_t digits = name.find_first_of("123456789");
  int joint = 0;
  if (digits != std::string_view::npos)
    std::from_chars(name.data() + digits, name.data() + name.size(), joint);
  return joint;
}

std::string joints_text(int n) { return fmt::format("{} joint{}", n, n == 1 ? "" : "s"); }

// R0606: a joint that the robot does not have.
Answer<void> check_has(Vm& vm, const RobotRef& r, int joint, int n) {
  if (joint <= n) return {};
  return failure(
      vm, "R0606",
      fmt::format("joint {} of `{}`, which has {}", joint, state_of(vm, r).name, joints_text(n)),
      CallPart::first());
}

Answer<double> joint_value(Vm& vm, const RobotRef& r, int joint) {
  if (!check_has(vm, r, joint, model_of(vm, r).n())) return Failed{};
  return state_of(vm, r).q[joint - 1];
}

// The frame after a joint, relative to the frame before the first joint.
Answer<Eigen::Matrix4d> frame_of_link(Vm& vm, const RobotRef& r, int joint) {
  const Robot& robot = model_of(vm, r);
  if (!check_arm(vm, r.id) || !check_has(vm, r, joint, robot.rows())) return Failed{};
  const Eigen::Isometry3d T_world_link = link_frame(robot, state_of(vm, r).q, joint);
  return Eigen::Matrix4d((robot.chain().T_world_base.inverse() * T_world_link).matrix());
}

Eigen::VectorXd q_current(Vm& vm, const RobotRef& r) { return state_of(vm, r).q; }
Eigen::VectorXd speeds_now(Vm& vm, const RobotRef& r) { return state_of(vm, r).qd; }
Eigen::VectorXd accels_now(Vm& vm, const RobotRef& r) { return state_of(vm, r).qdd; }

std::vector<std::vector<double>> q_limits(Vm& vm, const RobotRef& r) {
  const Robot& robot = model_of(vm, r);
  std::vector<std::vector<double>> rows;
  for (int i = 0; i < robot.n(); ++i) rows.push_back({robot.lower()[i], robot.upper()[i]});
  return rows;
}

// E0302 for q5 and A05 of a robot with four joints.
void check_joint_exists(CheckCall& call) {
  const auto robot = robot_of(call);
  std::string_view name = call.function_name();
  name.remove_prefix(std::min(name.size(), std::string_view("robot.").size()));
  if (robot == nullptr || joint_in(name) <= static_cast<int>(robot->turns.size())) return;
  const int n = static_cast<int>(robot->turns.size());
  Diagnostic d =
      make_diagnostic(row("E0302"), call.callee_span(), {std::string(name), joints_text(n)});
  const std::string_view prefix = name.starts_with('q') ? "q" : "A0";
  d.why = n == 1 ? fmt::format("`{}` has {}1 only", robot->name, prefix)
                 : fmt::format("`{}` has {}1 to {}{}", robot->name, prefix, prefix, n);
  call.report(std::move(d));
}

// The statement that changes the value of such a variable.
std::string instead_of(std::string_view name, const std::string& robot) {
  if (name == "qLimits")
    return "limits belong to the robot: joint revolute(limits: [-90deg, 90deg]), or new Robot(dh, "
           "types, limits)";
  if (name == "DHTable") return "make another robot: new Robot(dh, types, limits)";
  if (name == "vpp") return fmt::format("command speeds: {}.speedJ(rates, during: 1s)", robot);
  if (name == "app")
    return fmt::format("the motion decides them: {}.moveJ(..., accel: 0.5), or its time", robot);
  if (name.starts_with("A0"))
    return fmt::format("the joints decide where it is: {}.moveJ(...) or {}.moveL(...)", robot,
                       robot);
  return fmt::format(
      "move there with {}.moveJ(posJ(...)), or place the joints with "
      "{}.setJoints(posJ(...))",
      robot, robot);
}

// E0328: such a variable cannot be assigned.
void refuse_writing(CheckCall& call) {
  const std::string place = call.text_of(call.callee_span());
  const std::size_t point = place.rfind('.');
  const std::string robot = place.substr(0, point);
  Diagnostic d = make_diagnostic("E0328", call.callee_span());
  d.why = fmt::format("`{}` shows what the robot is now; it can only be read", place);
  d.fix = Fix{.text = instead_of(place.substr(point + 1), robot)};
  call.report(std::move(d));
}

NativeFunction read_only(std::string_view signature) {
  return declare(signature, "", "", refuse_writing);
}

// The variables of one kind, one for each joint that a robot can have.
struct JointViews {
  std::vector<Definition> definitions;
  std::vector<std::string> stores;

  JointViews() {
    for (int joint = 1; joint <= kMaxJoints; ++joint) {
      add(
          fmt::format("A0{}", joint), "matrix",
          [joint](Vm& vm, const RobotRef& r) { return frame_of_link(vm, r, joint); },
          fmt::format(
              "The frame after joint {} now, seen from the frame before the first joint, as "
              "a 4 x 4 matrix. Read only.",
              joint));
    }
    for (int joint = 1; joint <= kMaxJoints; ++joint) {
      add(
          fmt::format("q{}", joint), "double",
          [joint](Vm& vm, const RobotRef& r) { return joint_value(vm, r, joint); },
          fmt::format("The value of joint {} now, rad or m. Read only.", joint));
    }
  }

 private:
  template <class F>
  void add(const std::string& name, std::string_view type, const F& function, std::string help) {
    definitions.push_back(def(fmt::format("robot.{}(r: robot) -> {}", name, type), function,
                              std::move(help), example_of(name), {.check = check_joint_exists}));
    stores.push_back(fmt::format("robot.{}=(r: robot, value: T) -> robot", name));
  }
  // An example with a robot that has enough joints.
  static std::string example_of(const std::string& name) {
    const int joint = joint_in(name);
    if (joint <= 6) return "robots.puma560()." + name;
    std::string rows;
    for (int i = 0; i < joint; ++i)
      rows += fmt::format("{}[0.0, 0.0, 0.1, 0.0]", i == 0 ? "" : ", ");
    return fmt::format("dh([{}], types: \"{}\").{}", rows,
                       std::string(static_cast<std::size_t>(joint), 'R'), name);
  }
};

constexpr NativeFunction kWholeViews[] = {
    def<q_current>("robot.q_current(r: robot) -> double[]",
                   "The joint values now, rad and m. Read only.", "robots.scara().q_current",
                   {.check = note_positions}),
    def<q_limits>("robot.qLimits(r: robot) -> double[][]",
                  "The lower and the upper limit of each joint, one row for each, rad and m. Read "
                  "only.",
                  "robots.scara().qLimits"),
    def<speeds_now>("robot.vpp(r: robot) -> double[]",
                    "The speeds of the joints on their planned path now, rad/s and m/s. Read only.",
                    "robots.scara().vpp", {.check = note_speeds}),
    def<accels_now>("robot.app(r: robot) -> double[]",
                    "The accelerations of the joints on their planned path now, rad/s^2 and m/s^2. "
                    "Read only.",
                    "robots.scara().app", {.check = note_accels}),
};

constexpr std::string_view kWholeStores[] = {
    "robot.q_current=(r: robot, value: T) -> robot", "robot.qLimits=(r: robot, value: T) -> robot",
    "robot.vpp=(r: robot, value: T) -> robot", "robot.app=(r: robot, value: T) -> robot",
    "robot.DHTable=(r: robot, value: T) -> robot"};

}  // namespace

std::span<const NativeFunction> view_functions() {
  static const JointViews views;
  static const std::vector<NativeFunction> functions = [] {
    std::vector<NativeFunction> all;
    for (const Definition& each : views.definitions) all.push_back(each.function);
    all.insert(all.end(), std::begin(kWholeViews), std::end(kWholeViews));
    for (const std::string& store : views.stores) all.push_back(read_only(store));
    for (const std::string_view store : kWholeStores) all.push_back(read_only(store));
    return all;
  }();
  return functions;
}

}  // namespace armlet::bind
