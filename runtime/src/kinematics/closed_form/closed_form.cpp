#include "armlet/kinematics/closed_form.hpp"

#include <fmt/format.h>

#include <cmath>

#include "closed_form_families.hpp"
#include "closed_lanes.hpp"
#include "one_to_four_joints.hpp"

namespace armlet {
namespace {

// Whether all joints are revolute, except joint `except`.
bool all_revolute(const CanonicalRows& rows, std::size_t except = kMaxJoints) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(rows.n); ++i) {
    if (!rows.revolute[i] && i != except) return false;
  }
  return true;
}

// Whether a closed form gives joints 1 to 3 for a position; the third may be prismatic if axes 1
// and 2 meet. Two joints about one line are not possible.
bool has_shoulder(const CanonicalRows& rows) {
  if (rows.parallel(1) || !all_revolute(rows, 2)) return false;
  if (rows.parallel(2) && rows.revolute[2]) return rows.a[2] != 0.0;
  return rows.meet(1);
}

bool is_scara(const CanonicalRows& rows) {
  int sliding = 0;
  for (std::size_t i = 0; i < 4; ++i) sliding += rows.revolute[i] ? 0 : 1;
  return sliding == 1 && rows.parallel(1) && rows.parallel(2) && rows.parallel(3);
}

ClosedFormKind recognised_six(const CanonicalRows& rows) {
  if (rows.meet(4) && rows.meet(5) && rows.h[4] == 0.0 && has_shoulder(rows))
    return rows.parallel(2) ? ClosedFormKind::kSphericalParallel
                            : ClosedFormKind::kSphericalMeeting;
  const bool three = !rows.parallel(1) && rows.parallel(2) && rows.parallel(3) && !rows.parallel(4);
  return three && rows.meet(5) && all_revolute(rows) ? ClosedFormKind::kThreeParallel
                                                     : ClosedFormKind::kNone;
}

ClosedFormKind recognised(const CanonicalRows& rows) {
  if (rows.n == 4 && is_scara(rows)) return ClosedFormKind::kScara;
  if (rows.n == 6) return recognised_six(rows);
  const ClosedFormKind few = recognised_few(rows);
  if (few == ClosedFormKind::kFewPose) return few;
  if (rows.n == 3 && has_shoulder(rows) && !rows.reversed) return ClosedFormKind::kShoulder;
  if (few != ClosedFormKind::kNone) return few;
  if (!all_revolute(rows)) return ClosedFormKind::kNone;
  switch (rows.n) {
    case 3:
      return rows.parallel(1) && rows.parallel(2) ? ClosedFormKind::kPlane : ClosedFormKind::kNone;
    case 5:
      return !rows.parallel(1) && rows.parallel(2) && rows.parallel(3) && !rows.parallel(4)
                 ? ClosedFormKind::kPlanarArmTwist
                 : ClosedFormKind::kNone;
    case 7: {
      const bool shoulder = rows.meet(1) && rows.meet(2) && rows.h[1] == 0.0;
      const bool wrist = rows.meet(5) && rows.meet(6) && rows.h[5] == 0.0;
      return shoulder && wrist && !rows.parallel(3) ? ClosedFormKind::kShoulderElbowWrist
                                                    : ClosedFormKind::kNone;
    }
    default:
      return ClosedFormKind::kNone;
  }
}

// The two solutions of each part of the arm, in words: the first, the second.
struct PartNames {
  std::string_view shoulder, elbow, wrist;
};

PartNames part_names(ClosedFormKind kind) {
  switch (kind) {
    case ClosedFormKind::kNone:
      return {};
    case ClosedFormKind::kPlane:
    case ClosedFormKind::kScara:
      return {"", "elbow", ""};
    case ClosedFormKind::kShoulder:
    case ClosedFormKind::kPlanarArmTwist:
      return {"shoulder", "elbow", ""};
    default:
      return {"shoulder", "elbow", "wrist"};
  }
}

// Direction of the first axis in the world: +1 up, -1 down, 0 neither.
double uprightness(const CanonicalRows& rows) {
  const double z = rows.before.linear()(2, 2);  // the same for the inverse
  return z > 0.9 ? 1.0 : z < -0.9 ? -1.0 : 0.0;
}

}  // namespace

std::string_view to_text(ClosedFormKind kind) {
  switch (kind) {
    case ClosedFormKind::kNone:
      return "none";
    case ClosedFormKind::kPlane:
      return "three parallel axes";
    case ClosedFormKind::kScara:
      return "SCARA: three parallel axes and a slide along them";
    case ClosedFormKind::kShoulder:
      return "three joints that reach a place";
    case ClosedFormKind::kPlanarArmTwist:
      return "five joints, axes 2, 3 and 4 parallel";
    case ClosedFormKind::kSphericalParallel:
      return "six joints, spherical wrist, axes 2 and 3 parallel";
    case ClosedFormKind::kSphericalMeeting:
      return "six joints, spherical wrist, axes 1 and 2 meet";
    case ClosedFormKind::kThreeParallel:
      return "six joints, axes 2, 3 and 4 parallel, 5 and 6 meet";
    case ClosedFormKind::kShoulderElbowWrist:
      return "seven joints, spherical shoulder and wrist";
    case ClosedFormKind::kFewPosition:
      return "up to three turning joints that reach a place";
    case ClosedFormKind::kFewPose:
      return "up to four turning joints";
    case ClosedFormKind::kMeetingWrist:
      return "five joints, axes 4 and 5 meet";
    case ClosedFormKind::kSphericalWrist:
      return "six joints, spherical wrist";
  }
  return "none";
}

ClosedForm::ClosedForm(const Chain& chain) : chain_(chain), plan_(plan_walk(chain)) {
  recognise(chain);
  lanes_ = LaneForm::make(kind_, *rows_, chain);
  if (exists() || chain.coupled || chain.n != 7) return;
  if (!hold_still(Hold::kLast)) hold_still(Hold::kFirst);
}

// Whether the arm has a closed form with its first or last joint held.
bool ClosedForm::hold_still(Hold hold) {
  const bool first = hold == Hold::kFirst;
  const Chain others = with_held_joint(chain_, first, 0.0);
  recognise(others);
  if (!exists()) return false;
  hold_ = hold;
  lanes_ = LaneForm::make(kind_, *rows_, others);
  const std::size_t k = first ? 0 : static_cast<std::size_t>(chain_.n);
  const Eigen::Isometry3d X = twist_and_length(chain_, k);
  T_beside_held_ = first ? chain_.T_world_base * X : X * chain_.T_flange_tool;
  return true;
}

void ClosedForm::recognise(const Chain& chain) {
  // The families come first, in both directions of reading: their formulas are shorter.
  for (const auto find : {recognised, recognised_wrist}) {
    for (const bool reversed : {false, true}) {
      auto rows = std::make_unique<CanonicalRows>(canonical_rows(chain, reversed));
      // Closed forms need an independent value for each row.
      kind_ = chain.coupled ? ClosedFormKind::kNone : find(*rows);
      reversed_ = reversed;
      rows_ = std::move(rows);
      if (exists()) return;
    }
  }
}

ClosedForm::~ClosedForm() = default;
ClosedForm::ClosedForm(ClosedForm&&) noexcept = default;
ClosedForm& ClosedForm::operator=(ClosedForm&&) noexcept = default;

std::string ClosedForm::branch_name(int branch) const {
  if (kind_ >= ClosedFormKind::kFewPosition) return fmt::format("way {}", branch + 1);
  const PartNames names = part_names(kind_);
  const bool back = (branch & kShoulderBit) != 0;
  const bool second = (branch & kElbowBit) != 0;
  const bool flipped = (branch & kWristBit) != 0;
  const double up = reversed_ ? 0.0 : uprightness(*rows_);
  const bool in_plane = rows_->parallel(2) && kind_ != ClosedFormKind::kPlane &&
                        kind_ != ClosedFormKind::kScara && up != 0.0;
  std::string text;
  const auto add = [&text](std::string_view part, std::string_view value) {
    if (part.empty()) return;
    if (!text.empty()) text += ", ";
    text.append(part).append(" ").append(value);
  };
  // Read from the tool to the base, the shoulder is solved last.
  const std::string_view shoulder = reversed_ ? names.wrist : names.shoulder;
  const std::string_view wrist = reversed_ ? names.shoulder : names.wrist;
  add(shoulder, in_plane ? (back ? "back" : "front") : (back ? "-" : "+"));
  if (in_plane) {
    // The arm's plane has its x axis outwards and its y axis along the first axis, or against it;
    // an elbow that bends to the left is on the right of the line to the wrist.
    const bool y_up = up * rows_->alpha[1].s > 0.0;
    add(names.elbow, (second != back) == y_up ? "up" : "down");
  } else if (kind_ == ClosedFormKind::kScara && up != 0.0) {
    add(names.elbow, second == (up > 0.0) ? "left" : "right");
  } else {
    add(names.elbow, second ? "-" : "+");
  }
  add(wrist, reversed_ ? (flipped ? "-" : "+") : (flipped ? "flipped" : "not flipped"));
  return text;
}

const ClosedForm& closed_form(const Robot& robot) { return robot.derived<ClosedForm>(); }

}  // namespace armlet
