// Events without a command are computed ahead of the motion: at every whole millisecond after the
// last begin or end of a motion, and between two of these by bisection to a nanosecond. They depend
// on the motions alone, not on how time is divided or who asks.
#include "armlet/cell/foresight.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/cell/cell.hpp"
#include "armlet/cell/fingers.hpp"
#include "armlet/core/error.hpp"

namespace armlet {
namespace {

constexpr std::int64_t kLookAhead = 1'000'000;  // ns

// The index of the hand with fingers that a robot is or carries; -1: none.
int hand_with_fingers(const Cell& cell, int index) {
  const CellRobot& robot = cell.robot(index);
  if (robot.on >= 0) return robot.hand < 0 ? index : robot.hand;
  return robot.model->tool().kind == ToolKind::kFingers ? cell.hand_on(index) : -1;
}

}  // namespace

void Cell::forget_ahead() { ahead_.clear(); }

bool Cell::is_watched(int index) const {
  const CellRobot& arm = robot(index);
  if (!arm.motion) return false;
  return arm.on >= 0 || std::isfinite(arm.model->tool().max_force) ||
         arm.model->tool().kind == ToolKind::kFingers;
}

std::int64_t Cell::known_until(int motion) const {
  const MotionReport& report = this->report(motion);
  if (report.state != MotionState::kRunning || !is_watched(report.robot)) return report.end_ns;
  if (ahead_.empty()) return now_ns();
  const Foresight& known = ahead_[static_cast<std::size_t>(report.robot)];
  return std::min(
      {report.end_ns, known.due_ns().value_or(report.end_ns), std::max(known.sure_ns, now_ns())});
}

// The contact forces on a gripper, and on the links of its arm, at the instant to which the cell
// was moved.
std::array<HandOverload, 2> Cell::pressed_at(int index, std::int64_t t_ns) {
  HandOverload over{.t_ns = t_ns, .most = robot(index).model->tool().max_force};
  if (const int hand = hand_with_fingers(*this, index); hand >= 0) {
    const HardestFinger hardest = hardest_finger(*this, hand);
    over.most = robot(hand).force;
    over.force = over.with_friction = hardest.force;
    over.finger = hardest.finger;
    over.by.object = hardest.object;
    return {over, HandOverload{}};
  }
  std::array<HandOverload, 2> all{over, over};
  std::array<Eigen::Vector3d, 2> sums{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (const Press& each : contacts_ahead_.presses(robots_, world_, index, t_ns)) {
    const std::size_t of = each.of_hand ? 0 : 1;
    sums[of] += each.force;
    all[of].with_friction += each.normal * std::sqrt(1.0 + each.friction * each.friction);
    if (each.normal > all[of].by.normal) all[of].by = each;
  }
  for (std::size_t of = 0; of < all.size(); ++of) all[of].force = sums[of].norm();
  return all;
}

// The first instant in (from, to] at which `is_so` is true, if it is true at `to`; nothing
// otherwise.
template <class IsSo>
std::optional<std::int64_t> Cell::first_instant(std::int64_t from, std::int64_t to, IsSo&& is_so) {
  const auto holds = [&](std::int64_t t_ns) {
    bring_to(t_ns);
    return is_so(t_ns);
  };
  if (!holds(to)) return std::nullopt;
  while (to - from > 1) {
    const std::int64_t middle = from + (to - from) / 2;
    (holds(middle) ? to : from) = middle;
  }
  bring_to(to);
  return to;
}

void Cell::foresee(int index) {
  constexpr double kSame = 1e-9;  // relative
  struct Back {
    Cell& cell;
    ~Back() { cell.bring_to(cell.now_ns()); }
  };
  const Back back{*this};
  const CellRobot& arm = robot(index);
  Foresight& known = ahead_[static_cast<std::size_t>(index)];
  const std::int64_t from = now_ns(), begin = contacts_.begin_ns(), end = arm.motion->end_ns();
  const std::int64_t to = std::min(end, begin + ((from - begin) / kLookAhead + 1) * kLookAhead);
  press_limits_.resize(robots_.size());
  PressLimit& limit = press_limits_[static_cast<std::size_t>(index)];
  if (limit.motion != arm.motion_id) {
    const auto pressed = pressed_at(index, from);
    limit.motion = arm.motion_id;
    for (std::size_t of = 0; of < pressed.size(); ++of)
      limit.most[of] = std::max(pressed[of].most, pressed[of].with_friction * (1.0 + kSame));
  }
  const bool was_too_much = report(arm.motion_id).overload.has_value();
  const auto overload_at = [&](std::int64_t t_ns) -> std::optional<HandOverload> {
    const auto pressed = pressed_at(index, t_ns);
    for (std::size_t of = 0; of < pressed.size(); ++of) {
      if (pressed[of].force > limit.most[of]) return pressed[of];
    }
    return std::nullopt;
  };
  const auto too_much = [&](std::int64_t t_ns) {
    return !was_too_much && overload_at(t_ns).has_value();
  };
  if (const auto t_ns = first_instant(from, to, too_much)) known.overload = overload_at(*t_ns);
  // A grasp is checked every fourth millisecond: this takes longer, and accelerations change
  // gradually.
  constexpr std::int64_t kLookAtGrip = 4 * kLookAhead;
  const bool has_fingers = arm.model->tool().kind == ToolKind::kFingers;
  const bool is_turn = known.sure_ns < 0 || (from - begin) % kLookAtGrip == 0;
  if (has_fingers && !arm.held.empty() && is_turn && !known.slips_ns) {
    const std::int64_t far = begin + ((from - begin) / kLookAtGrip + 1) * kLookAtGrip;
    const auto slips = [&](std::int64_t) { return carried_in_motion(*this, index) < 1.0; };
    known.slips_ns = first_instant(from, std::min(end, far), slips);
    if (known.slips_ns) known.carried = carried_in_motion(*this, index);
  }
  known.sure_ns = to;
  if (hand_with_fingers(*this, index) < 0 && !known.overload)
    known.sure_ns = std::max(to, std::min(end, contacts_ahead_.clear_until(index)));
}

std::optional<std::int64_t> Cell::look_ahead() {
  std::optional<std::int64_t> next;
  for (int i = 0; i < robot_count(); ++i) {
    if (!is_watched(i) || robot(i).motion->end_ns() <= now_ns()) continue;
    if (ahead_.size() != robots_.size()) {
      ahead_.assign(robots_.size(), {});
      contacts_ahead_ = contacts_;
      contacts_ahead_.look_again();  // results of other callers must not matter
    }
    Foresight& known = ahead_[static_cast<std::size_t>(i)];
    if (known.sure_ns <= now_ns()) foresee(i);
    const std::int64_t t_ns = std::min(known.due_ns().value_or(known.sure_ns), known.sure_ns);
    next = std::min(next.value_or(t_ns), t_ns);
  }
  return next;
}

void Cell::let_happen() {
  const std::vector<Foresight> due = ahead_;  // executing events changes what is known
  for (int i = 0; i < static_cast<int>(due.size()); ++i) {
    const Foresight& known = due[static_cast<std::size_t>(i)];
    if (known.overload && known.overload->t_ns <= now_ns() && robot(i).motion) {
      reports_[static_cast<std::size_t>(robot(i).motion_id)].overload = known.overload;
      stop(i);
    }
    if (known.slips_ns && *known.slips_ns <= now_ns() && !robot(i).held.empty())
      slip(i, known.carried, true);
  }
}

void Cell::slip(int index, double carried, bool moving) {
  const std::string held = robot(index).held;
  const Drop drop = let_go(index);
  events_.push_back({.t_ns = now_ns(),
                     .kind = CellEventKind::kSlipped,
                     .robot = index,
                     .object = held,
                     .support = drop.support,
                     .carried = carried,
                     .moving = moving});
}

}  // namespace armlet
