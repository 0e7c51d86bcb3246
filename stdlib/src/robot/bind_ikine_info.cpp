// ikineInfo: the contents of the messages of inverse kinematics, as values (language reference,
// section 13.6).

#include <cmath>

#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/stdlib/host.hpp"
#include "moves/moves.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/robots/give.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// The fields of an IkInfo.
struct Info {
  bool found = false;
  PosJ q;  // no values if no solution was found
  std::string_view method;
  std::string branch;
  int iterations = 0;
  double residual = 0.0;
  double tilt = 0.0;
  double distance = 0.0;
  PosC nearest;
  int worst_joint = 0;  // from 1
  Eigen::VectorXd margin;
};

// Solvers accept goals up to this distance from the origin; towards farther ones the arm points in
// the same direction.
constexpr double kFarthest = 1e5;  // m

Eigen::Isometry3d brought_near(const Eigen::Isometry3d& T) {
  Eigen::Isometry3d near = T;
  const double size = T.translation().cwiseAbs().maxCoeff();
  if (size > kFarthest) near.translation() *= kFarthest / size;
  return near;
}

// Sets the joint that exceeds its limits most, and by how much each joint does.
void take_violations(const std::vector<LimitViolation>& violations, Info& info) {
  double most = 0.0;
  for (const LimitViolation& each : violations) {
    info.margin[each.joint] = -each.excess();
    if (each.excess() <= most) continue;
    most = each.excess();
    info.worst_joint = each.joint + 1;
  }
}

Info info_of(const Robot& robot, const PosC& target, IkTask task, IkOptions options) {
  options.task = task;
  const IkResult result = solve_ik(robot, brought_near(target.T), options);
  Info info{.found = result.ok(),
            .method = result.solver,
            .branch = result.ok() ? branch_name(robot, result) : std::string(),
            .iterations = result.iterations};
  if (result.ok()) {
    info.q = make_posj(robot, result.q);
    info.residual = result.position_error;
    info.tilt = result.rotation_error;
    info.nearest = {forward(robot, result.q), true};
    info.margin = limit_margins(robot, result.q);
    take_violations(limit_violations(robot, result.q), info);
    return info;
  }
  const IkDiagnosis& d = result.diagnosis;
  const bool known = d.q_nearest.size() == robot.n();
  const Eigen::VectorXd& q = known ? d.q_nearest : options.seed;
  info.nearest = {forward(robot, q), true};
  const double gap = (info.nearest.T.translation() - target.T.translation()).stableNorm();
  info.distance = known && d.distance == 0.0 ? 0.0 : gap;
  info.residual = gap;
  info.tilt = task == IkTask::kPose ? angle_between(info.nearest.T, target.T) : d.angle;
  info.margin = limit_margins(robot, q);
  take_violations(d.violations, info);
  return info;
}

// The fields that are objects are made first; null if one of them fails.
RecordObj* record_of(Vm& vm, const Info& info) {
  RecordObj* record = new_record(vm, vm.program().library_record("IkInfo"));
  if (record == nullptr) return nullptr;
  Slot* fields = record->fields();
  enum { kFound, kQ, kMethod, kBranch, kIterations, kResidual, kTilt, kDistance, kNearestPose };
  enum { kWorst = kNearestPose + 1, kMargin };
  const auto set = [&](int field, Obj* object) {
    fields[field].o = object;
    return object != nullptr;
  };
  fields[kFound].i = info.found ? 1 : 0;
  fields[kIterations].i = info.iterations;
  fields[kResidual].d = info.residual;
  fields[kTilt].d = info.tilt;
  fields[kDistance].d = info.distance;
  fields[kWorst].i = info.worst_joint;
  const bool whole =
      set(kQ, new_posj(vm, info.q)) && set(kMethod, new_text(vm, info.method)) &&
      set(kBranch, new_text(vm, info.branch)) && set(kNearestPose, new_posc(vm, info.nearest)) &&
      set(kMargin,
          new_reals(vm, {info.margin.data(), static_cast<std::size_t>(info.margin.size())}));
  if (whole) return record;
  release(vm, record);
  return nullptr;
}

template <class Near>
Answer<RecordObj*> ikine_info(Vm& vm, const RobotRef& r, const PosC& p, Near near, bool limits) {
  const Robot& robot = model_of(vm, r);
  IkOptions options;
  options.respect_limits = limits;
  auto seed = seed_of(vm, r, near, at("near"));
  if (!seed) return Failed{};
  options.seed = *std::move(seed);
  // An orientation that the arm cannot have is treated as a pose for which no solution is found.
  const IkTask task = task_of(robot, p).value_or(IkTask::kPose);
  return record_of(vm, info_of(robot, p, task, std::move(options)));
}

constexpr std::string_view kHelp =
    "What ikine finds and why it does not, as values; it never fails for what p is. An IkInfo has "
    "`found`; `q`, without values if nothing was found; `method`, `branch` and `iterations` of the "
    "solver; `nearest`, the reachable pose nearest to p; `residual` and `tilt`, by how much its "
    "place and orientation miss p; `distance`, how far p is out of reach; `worstJoint`, the joint "
    "that would be farthest outside its limits, from 1 (0: none); `margin`, each joint's distance "
    "to its nearer limit (rad, m), below 0 beyond it.";

constexpr NativeFunction kIkineInfoFunctions[] = {
    def<ikine_info<const PosJ*>, ikine_info<JointList>>(
        "ikineInfo(r: robot, p: posC, near: posJ? | double[], limits: bool = true) -> IkInfo",
        kHelp, "ikineInfo(xyz(2m, 0m, 300mm)).distance", {.check = check_joint_list<"near">}),
};

}  // namespace

std::span<const NativeFunction> ikine_info_functions() { return kIkineInfoFunctions; }

}  // namespace armlet::bind
