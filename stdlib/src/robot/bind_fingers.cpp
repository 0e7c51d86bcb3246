// Hands with fingers, which are robots mounted on a robot (language reference, section 14).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/cell/fingers.hpp"
#include "armlet/cell/gripper.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/limit_policy.hpp"
#include "moves/motion_collisions.hpp"
#include "moves/moves.hpp"
#include "robot/grasps.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/robots/models.hpp"
#include "values/values.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {
namespace {

using Number = std::optional<double>;

constexpr const char* kHandName = "hand";

Answer<RobotRef> barrett_hand(Vm& vm, const RobotRef& on, std::optional<std::string_view> name) {
  Host& host = Host::of(vm);
  try {
    const int hand =
        host.cell().add_hand(on.id, make_barrett_robots(std::string(name.value_or(kHandName))));
    return RobotRef{hand, &host.cell()};
  } catch (const ArgumentError& error) {
    return failure_of(vm, row("R0630"), error, at("on"));
  }
}

void check_barrett_hand(CheckCall& call) {
  const auto name = call.constant(at("name"));
  const FingeredHand hand = make_barrett_robots(name ? name->text : kHandName);
  set_robot_fact(call, std::make_shared<const Robot>(hand.palm), hand.palm.name());
}

// The hand with fingers: the robot itself, or the one mounted on it; -1: there is none.
int hand_of(const Cell& cell, int robot) {
  return cell.robot(robot).fingers.empty() ? cell.hand_on(robot) : robot;
}

Failed fail_no_fingers(Vm& vm, int robot) {
  Failure f;
  const std::string& name = Host::of(vm).cell().robot(robot).name;
  f.resource = robot_called(name);
  f.headline = {row("R0650"), {name}};
  f.mark = CallPart::first();
  f.fix = fmt::format("mount one: robot hand = robots.barrettHand(on: {})", name);
  return fail(vm, std::move(f));
}

Answer<FingerRef> finger(Vm& vm, const RobotRef& h, std::int64_t number) {
  const Cell& cell = Host::of(vm).cell();
  const int hand = hand_of(cell, h.id);
  if (hand < 0) return fail_no_fingers(vm, h.id);
  const auto& fingers = cell.robot(hand).fingers;
  const auto count = static_cast<std::int64_t>(fingers.size());
  if (number < 1 || number > count)
    return failure(vm, "R0606", fmt::format("finger {} is outside 1 to {}", number, count),
                   at("i"));
  return FingerRef{fingers[static_cast<std::size_t>(number - 1)], hand, static_cast<int>(number)};
}

// The joint values of a finger when its first link has this angle.
Eigen::VectorXd bent(const Cell& cell, const FingerRef& f, double bend) {
  Eigen::VectorXd q = cell.robot(f.hand).q;
  q[f.number] = bend;
  return finger_joints(f.number - 1, q);
}

Started move_finger(Vm& vm, const FingerRef& f, const PosJ& target, Number time, Number speed) {
  const Cell& cell = Host::of(vm).cell();
  if (target.n != 1) return size_failure(vm, "a finger", target.n, 1);
  MoveCall hand{.function = "moveJ", .robot = f.hand};
  Eigen::VectorXd q = cell.robot(f.hand).q;
  q[f.number] = target.q[0];
  q = clamped(vm, hand, q);
  const bool warns = settings_of(vm).limits == LimitCheck::kWarn;
  if (const auto outside = limit_violations(*cell.robot(f.hand).model, q);
      !outside.empty() && !warns)
    return fail_outside(vm, hand, q, outside.front());
  MoveCall call = hand;
  call.robot = f.id;
  return move_to_joints(vm, call, bent(cell, f, q[f.number]), "Syn",
                        {.time = time, .speed = speed});
}

double force_of_finger(Vm& vm, const FingerRef& f) {
  return finger_force(Host::of(vm).cell(), f.id);
}

PosJ finger_joint(Vm& vm, const FingerRef& f) {
  PosJ q{.n = 1, .kinds_known = true};
  q.turns[0] = true;
  q.q[0] = Host::of(vm).cell().robot(f.hand).q[f.number];
  return q;
}

// ---- closing and opening ------------------------------------------------------------------------

// W0725: fingers touch something that they would not lift.
void advise_touching(Vm& vm, int hand) {
  const Cell& cell = Host::of(vm).cell();
  const int arm = cell.robot(hand).on;
  if (!cell.robot(arm).held.empty()) return;
  const std::vector<FingerContact> contacts = finger_contacts(cell, hand);
  for (const FingerContact& each : contacts) {
    if (cell.world().at(each.object).fixed || each.finger < 0) continue;
    const double part = carried_part(cell, arm, contacts, each.object);
    Failure advice;
    advice.headline = {row("W0725"), {each.object}};
    advice.mark = CallPart::callee();
    advice.why = fmt::format("friction at the fingers carries {:.0f} % of its weight",
                             100.0 * std::min(part, 0.99));
    advice.fix = "close with more force, or take it nearer to its middle, from more sides";
    return vm.advise(advice);
  }
}

// A motion of a finger, and its possible collisions.
struct FingerMotion {
  MoveCall call{};
  int motion = -1;
  std::vector<PossibleCollision> possible{};
};

// Waits until all moving fingers are at rest.
class HandWaiting : public Waiting {
 public:
  HandWaiting(Host& host, int robot, std::vector<FingerMotion> motions, bool closes)
      : host_(host), robot_(robot), motions_(std::move(motions)), closes_(closes) {}

  [[nodiscard]] std::int64_t due_ns() const override {
    std::int64_t due = 0;
    for (const FingerMotion& each : motions_)
      due = std::max(due, host_.cell().known_until(each.motion));
    return due;
  }
  [[nodiscard]] bool is_over() const override {
    return std::ranges::all_of(motions_, [&](const FingerMotion& each) {
      return host_.cell().report(each.motion).state != MotionState::kRunning;
    });
  }
  void stop() override {
    for (const FingerMotion& each : motions_) {
      const MotionReport& report = host_.cell().report(each.motion);
      if (report.state == MotionState::kRunning) host_.cell().stop(report.robot);
    }
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("{} of {}", closes_ ? "closeHand" : "openHand",
                       host_.cell().robot(robot_).name);
  }
  [[nodiscard]] Resource resource() const override {
    return robot_called(host_.cell().robot(robot_).name);
  }
  Signal finish(Vm& vm, Slot&) override {
    for (const CellEvent& event : host_.take_events()) {
      if (event.kind == CellEventKind::kSlipped) advise_slip(vm, event);
    }
    for (const FingerMotion& each : motions_) {
      report_collisions(vm, each.call, each.motion, each.possible);
      if (!check_overload(vm, each.call, host_.cell().report(each.motion))) return Signal::kFail;
    }
    if (closes_ && !motions_.empty()) advise_touching(vm, robot_);
    return Signal::kDone;
  }

 private:
  Host& host_;
  int robot_;
  std::vector<FingerMotion> motions_;
  bool closes_;
};

Started waiting_for(Vm& vm, int robot, std::vector<FingerMotion> motions, bool closes) {
  std::unique_ptr<Waiting> waiting =
      std::make_unique<HandWaiting>(Host::of(vm), robot, std::move(motions), closes);
  return waiting;
}

// Starts the motions of the fingers to these angles.
Started move_fingers(Vm& vm, int hand, const std::vector<double>& bends, bool closes) {
  Host& host = Host::of(vm);
  Cell& cell = host.cell();
  std::vector<FingerMotion> motions;
  std::vector<Trajectory> planned;
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const FingerRef f{cell.robot(hand).fingers[i], hand, static_cast<int>(i) + 1};
    const CellRobot& state = cell.robot(f.id);
    const Eigen::VectorXd q = bent(cell, f, bends[i]);
    if ((q - state.q).cwiseAbs().maxCoeff() <= 0.0) continue;
    MotionPlan plan =
        plan_joint_move(host.planners(), *state.model,
                        {.q0 = state.q, .q1 = q, .planner = "Syn", .speed = settings_of(vm).speed});
    motions.push_back({.call = {.function = closes ? kCloseHand : "openHand", .robot = f.id}});
    planned.push_back(*std::move(plan.trajectory));
  }
  for (std::size_t i = 0; i < motions.size(); ++i) {
    std::vector<MotionBeside> beside;
    for (std::size_t k = 0; k < motions.size(); ++k) {
      if (k != i) beside.push_back({motions[k].call.robot, &planned[k]});
    }
    auto possible = check_finger_collisions(vm, motions[i].call, planned[i], beside);
    if (!possible) return Failed{};
    motions[i].possible = *std::move(possible);
  }
  for (std::size_t i = 0; i < motions.size(); ++i)
    motions[i].motion = cell.start(motions[i].call.robot, std::move(planned[i]));
  return waiting_for(vm, hand, std::move(motions), closes);
}

constexpr double kUsualForce = 10.0;  // N

// Closes a gripper to the width of the object between its fingers.
Started close_gripper(Vm& vm, const RobotRef& r) {
  const GraspResult result = grasp(Host::of(vm).cell(), r.id);
  if (!result.ok()) return fail_grasp(vm, r.id, result);
  return waiting_for(vm, r.id, {}, true);
}

Started close_hand(Vm& vm, const RobotRef& h, Number force) {
  const Cell& cell = Host::of(vm).cell();
  if (!check_idle(vm, h.id)) return Failed{};
  const int hand = hand_of(cell, h.id);
  if (hand < 0 && cell.robot(h.id).model->tool().can_grasp() && !force) return close_gripper(vm, h);
  if (hand < 0) return fail_no_fingers(vm, h.id);
  if (!check_idle(vm, hand)) return Failed{};
  const double most = cell.robot(hand).force;
  const double wanted = force.value_or(std::min(kUsualForce, most));
  if (!(wanted > 0.0 && wanted <= most)) {
    return failure(vm, "R0609",
                   fmt::format("fingers that press with {} N: those of `{}` press with up to {} N",
                               format_number(wanted), cell.robot(hand).name, format_number(most)),
                   at("force"));
  }
  std::vector<double> bends;
  for (const Closing& each : close_hand(cell, hand, wanted)) bends.push_back(each.bend);
  return move_fingers(vm, hand, bends, true);
}

Started open_hand(Vm& vm, const RobotRef& h) {
  Cell& cell = Host::of(vm).cell();
  if (!check_idle(vm, h.id)) return Failed{};
  const int hand = hand_of(cell, h.id);
  if (hand < 0 && cell.robot(h.id).model->tool().can_grasp()) {
    if (!cell.robot(h.id).held.empty()) release(cell, h.id);
    return waiting_for(vm, h.id, {}, false);
  }
  if (hand < 0) return fail_no_fingers(vm, h.id);
  if (!check_idle(vm, hand)) return Failed{};
  return move_fingers(vm, hand, std::vector<double>(cell.robot(hand).fingers.size(), 0.0), false);
}

Answer<RecordObj*> grasp_quality_of(Vm& vm, const RobotRef& h, const ObjectRef& o) {
  const Cell& cell = Host::of(vm).cell();
  if (find_object(vm, o.name) == nullptr) return fail_unknown_object(vm, o.name, at("o"));
  const int hand = hand_of(cell, h.id);
  if (hand < 0) return fail_no_fingers(vm, h.id);
  const GraspQuality quality = hand_quality(cell, hand, o.name);
  RecordObj* record = new_record(vm, vm.program().library_record("GraspQuality"));
  if (record == nullptr) return Failed{};
  record->fields()[0] = slot_of(quality.epsilon);
  record->fields()[1] = slot_of(quality.min_singular);
  record->fields()[2] = slot_of(static_cast<std::int64_t>(quality.contacts));
  record->fields()[3] = slot_of(quality.force_closure);
  return record;
}

// The distance between the two fingers of a gripper.
Answer<double> opening(Vm& vm, const RobotRef& r) {
  const Cell& cell = Host::of(vm).cell();
  const CellRobot& arm = cell.robot(r.id);
  const Tool& tool = arm.model->tool();
  if (tool.kind != ToolKind::kParallelGripper) {
    Failure f;
    f.resource = robot_called(arm.name);
    f.headline =
        Headline::own(row("R0605"), fmt::format("`{}` has no gripper with two fingers", arm.name));
    f.fix = "give it one: tool: parallelGripper(stroke: 60mm)";
    return fail(vm, std::move(f));
  }
  if (arm.held.empty()) return tool.stroke;
  return grasp_width(cell.world().at(arm.held), cell.T_world_tool(r.id).linear().col(0));
}

#define HAND "robot arm = robots.pa10(); robot hand = robots.barrettHand(on: arm); "

constexpr NativeFunction kFingerFunctions[] = {
    def<barrett_hand>(
        "robots.barrettHand(on: robot, name: string?) -> robot",
        "A Barrett hand on the flange of an arm: four joints, the spread of fingers 1 and 2 and "
        "the bends of all three, whose last links curl by a third. The tool point of the arm goes "
        "to between the fingers. What fingers press on and carry by friction, the arm holds.",
        HAND "hand.moveJ(posJ(0deg, 60deg, 60deg, 60deg))", {.check = check_barrett_hand}),
    def<finger>("finger(h: robot, i: int) -> finger",
                "A finger of the hand, counted from 1: a robot of one joint.",
                HAND "hand.finger(1).moveJ(posJ(45deg))"),
    def<move_finger>("moveJ(f: finger, target: posJ, time: time?, speed: double?) -> Move",
                     "Bends a finger; speed is a fraction of its limit.",
                     HAND "hand.finger(1).moveJ(posJ(45deg), speed: 0.3)", {.pauses = true}),
    def<force_of_finger>("force(f: finger) -> force",
                         "What the finger presses with: the stiffness of what it touches times how "
                         "deep it is in it.",
                         HAND "print(hand.finger(1).force())"),
    def<finger_joint>("joints(f: finger) -> posJ", "How far the finger is bent.",
                      HAND "print(hand.finger(1).joints())"),
    def<close_hand>(
        "closeHand(h: robot, force: force?)",
        "Closes each finger until it presses with this force, 10 N unless told otherwise, has come "
        "to another finger, or to its end. A gripper closes to the width of what is between its "
        "fingers, as grasp() "
        "does.",
        HAND "hand.closeHand(force: 8N)", {.pauses = true}),
    def<open_hand>("openHand(h: robot)",
                   "Opens all fingers; what they held falls to the first surface.",
                   HAND "hand.openHand()", {.pauses = true}),
    def<grasp_quality_of>(
        "graspQuality(h: robot, o: object) -> GraspQuality",
        "How well the fingers hold an object where they touch it now: Ferrari and Canny's epsilon, "
        "the smallest singular value of the grasp matrix, and whether any load is withstood.",
        HAND "object ball { shape: sphere(30mm); at: xyz(x: 500mm) }; "
             "print(hand.graspQuality(ball).contacts)"),
    def<opening>("opening(r: robot) -> length",
                 "How far the fingers of a parallel gripper stand apart: its stroke, or the width "
                 "of what it holds.",
                 "print(opening())"),
};

#undef HAND

}  // namespace

std::span<const NativeFunction> finger_functions() { return kFingerFunctions; }

}  // namespace armlet::bind
