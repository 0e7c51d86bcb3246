// Positions from as many numbers as a robot controls, counted before the run: E0534.

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "armlet/core/error.hpp"
#include "armlet/kinematics/task_space.hpp"
#include "armlet/model/joint_limits.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"

namespace armlet::bind {
namespace {

constexpr int kPlaceNumbers = 3, kPoseNumbers = 6;

// "3, 5 or 6 numbers"
std::string numbers_text(const std::set<int>& counts) {
  std::string out;
  std::size_t at = 0;
  for (const int count : counts) {
    out += fmt::format("{}{}", at == 0 ? "" : at + 1 == counts.size() ? " or " : ", ", count);
    ++at;
  }
  return out + " numbers";
}

bool leaves_upright(const CheckCall& call, CallPart part) {
  return !call.given(part) ||
         std::dynamic_pointer_cast<const UprightFact>(call.fact(part)) != nullptr;
}

// The coordinates of the tool that a robot controls, if they are known from the text.
std::optional<TaskSpace> space_of(const RobotFact& robot) {
  if (robot.model == nullptr) return std::nullopt;
  const TaskSpace space = task_space(*robot.model);
  if (robot.may_be_tilted && space != TaskSpace::kPose) return std::nullopt;
  return space;
}

}  // namespace

bool may_be_tilted(const CheckCall& call, std::initializer_list<CallPart> may_tilt) {
  return !std::ranges::all_of(may_tilt, [&](CallPart each) { return leaves_upright(call, each); });
}

Joint joint_of(const JointFact& fact) {
  Joint joint = joint_without_limits(fact.turns ? JointKind::kRevolute : JointKind::kPrismatic);
  joint.dh = *fact.row;
  if (!fact.limits || (*fact.limits)[0] > (*fact.limits)[1]) return joint;
  joint.lower = (*fact.limits)[0];
  joint.upper = (*fact.limits)[1];
  return joint;
}

void note_upright(CheckCall& call) { call.set_result_fact(std::make_shared<UprightFact>()); }

void note_model(CheckCall& call, RobotFact& fact, const std::vector<Joint>& joints,
                DhConvention convention, std::initializer_list<CallPart> may_tilt) try {
  RobotSpec spec;
  spec.name = fact.name;
  spec.convention = convention;
  spec.joints = joints;
  fact.model = std::make_shared<const Robot>(std::move(spec));
  fact.may_be_tilted = may_be_tilted(call, may_tilt);
} catch (const ArgumentError&) {
  // Joints that make no robot are reported in the run, with the reason.
}

// (values, of)
void check_posc_list(CheckCall& call) {
  const auto constant = call.constant(CallPart::first());
  if (!constant || constant->kind != Constant::Kind::kList) return;
  const auto robot = call.given(at("of"))
                         ? std::dynamic_pointer_cast<const RobotFact>(call.fact(at("of")))
                         : ambient_robot(call);
  std::set<int> counts = {kPlaceNumbers, kPoseNumbers};
  const auto space = robot != nullptr ? space_of(*robot) : std::nullopt;
  const TaskSpace controlled = space.value_or(TaskSpace::kOther);
  const bool has_names = controlled != TaskSpace::kOther;
  if (has_names) counts.insert(coordinate_count(controlled));
  if (!space) counts.insert({2, 4, 5});
  const int count = static_cast<int>(constant->items.size());
  if (counts.contains(count)) return;
  Diagnostic d = make_diagnostic("E0534", call.span(CallPart::first()),
                                 {"posC", numbers_text(counts), fmt::format("{}", count)});
  d.why = "3 numbers are a place, 6 a place with roll, pitch and yaw";
  if (has_names) {
    const std::string_view names = coordinate_names(controlled);
    d.why = fmt::format("`{}` controls {} of its tool{}", robot->name, names,
                        counts.size() > 2 ? "; " + d.why : "");
    d.fix = Fix{.text = fmt::format("give {}", names)};
  }
  call.report(std::move(d));
}

}  // namespace armlet::bind
