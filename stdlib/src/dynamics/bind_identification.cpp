// Identifies masses and friction of an arm from its motions and their forces.

#include "armlet/dynamics/identification.hpp"
#include "armlet/stdlib/host.hpp"
#include "dynamics/loaded_arm.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/robots/give.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

template <class Q>
Answer<Eigen::MatrixXd> regressor(Vm& vm, const RobotRef& r, Q values, JointList rates,
                                  JointList accels) try {
  const Robot& robot = loaded_of(vm, r);
  const auto motion =
      joint_arguments(vm, robot, {at("q"), at("qd"), at("qdd")}, values, rates, accels);
  if (!motion) return Failed{};
  const auto& [q, qd, qdd] = *motion;
  return dynamics_regressor(robot, q, qd, qdd);
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0640"), error);
}

Answer<Eigen::VectorXd> parameters_of_links(Vm& vm, const RobotRef& r) {
  return dynamic_parameters(loaded_of(vm, r));
}

// Upper bound of the number of operations per link that the search for its parameters takes.
constexpr double kWork = 4e5;

Answer<RecordObj*> base_of_links(Vm& vm, const RobotRef& r) try {
  const Robot& robot = loaded_of(vm, r);
  const double links = static_cast<double>(dynamic_parameters(robot).size()) / kLinkParameters;
  if (!charge_steps(vm, static_cast<std::uint64_t>(kWork / 50.0 * links * links * links)))
    return Failed{};
  const BaseParameters base = base_parameters(robot);
  const Eigen::VectorXd values = base.grouping * dynamic_parameters(robot);
  RecordObj* record = new_record(vm, vm.program().library_record("BaseParameters"));
  if (record == nullptr) return Failed{};
  const auto count = static_cast<std::uint32_t>(base.columns.size());
  Slot* fields = record->fields();
  ListObj* const columns = new_list(vm, count, false);
  fields[0].o = columns;
  if (columns != nullptr) {
    for (std::uint32_t i = 0; i < count; ++i) columns->data[i].i = base.columns[i];
    if (Given<Eigen::MatrixXd>::leave(vm, base.grouping, fields[1]) == Signal::kDone &&
        Given<Eigen::VectorXd>::leave(vm, values, fields[2]) == Signal::kDone)
      return record;
  }
  release(vm, record);
  return Failed{};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0640"), error);
}

constexpr std::string_view kRegressor =
    "The matrix that gives the forces of invDyn when it is multiplied by dynamicParameters(), "
    "without Stribeck's part of friction: it does not depend on masses, so these can be found from "
    "measured torques.";

constexpr NativeFunction kIdentificationFunctions[] = {
    def<regressor<Joints>, regressor<JointList>>(
        "regressor(r: robot, q: posJ | double[], qd: double[], qdd: double[]) -> matrix",
        kRegressor,
        "regressor(joints(), jointSpeeds(), jointAccels()); regressor([0.0, 0.5, 0.1, 0.0], "
        "jointSpeeds(), jointAccels()).cols",
        {.check = check_joint_list<"q">}),
    def<parameters_of_links>(
        "dynamicParameters(r: robot) -> double[]",
        "14 values of each link, one link after the other: mass and mass times centre of mass (x, "
        "y, z), inertia about the origin of the link's frame (xx, xy, xz, yy, yz, zz), and at the "
        "joint the inertia of the motor, viscous friction and Coulomb friction forwards and "
        "backwards. The payload and what the hand holds count to the last link. Behind them stand "
        "those "
        "of links beside the arm whose joints copy its joints.",
        "dynamicParameters().length"),
    def<base_of_links>(
        "baseParameters(r: robot) -> BaseParameters",
        "What motions and torques can tell of the parameters: the columns of the regressor that do "
        "not depend on each other, from 0; `grouping`, the matrix that takes all parameters to the "
        "combinations that belong to these columns; and the values of these now.",
        "baseParameters().columns"),
};

}  // namespace

std::span<const NativeFunction> identification_functions() { return kIdentificationFunctions; }

}  // namespace armlet::bind
