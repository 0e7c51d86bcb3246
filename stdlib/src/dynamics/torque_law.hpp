#pragma once
// What a program says of the forces of its motors, and what came of it.

#include <string_view>

#include "armlet/dynamics/simulation.hpp"
#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// A function of the program, fn(t, q, qd) -> double[], which it keeps.
class TorqueLaw {
 public:
  TorqueLaw(Vm& vm, FunctionValue law);
  ~TorqueLaw();
  TorqueLaw(TorqueLaw&& other) noexcept;
  TorqueLaw(const TorqueLaw&) = delete;
  TorqueLaw& operator=(const TorqueLaw&) = delete;
  TorqueLaw& operator=(TorqueLaw&&) = delete;

  // What the motors give in this state, t seconds after the start. Fails with the joint and the
  // time if it is not one finite number for each joint.
  Answer<JointVector> operator()(const Robot& robot, double t, JointsIn q, JointsIn qd);

 private:
  struct Argument {
    ListObj* list = nullptr;
  };
  [[nodiscard]] ListObj* fill(Argument& argument, JointsIn values);

  Vm& vm_;
  Obj* law_;
  Argument q_, qd_;
};

// How a simulation is made, as the call says it, and which parameters say it.
struct SimulationCall {
  std::string_view function;  // "simulate"
  double during, every;
  std::string_view method;
  std::optional<double> step;
  double restitution;
  int during_parameter, every_parameter, method_parameter, step_parameter, restitution_parameter;
};

// Its options, checked.
Answer<SimulationOptions> simulation_options(Vm& vm, const SimulationCall& call);

// What a simulation could not do, with the joint and the time.
Failed cannot_simulate(Vm& vm, const ArmSimulation& arm, const SimulationOutcome& outcome,
                       const SimulationOptions& options);

// Advice about joints that ran against their limits.
void tell_of_stops(Vm& vm, const ArmSimulation& arm);

// A list of JointEvent; null: the failure is set.
[[nodiscard]] ListObj* joint_events(Vm& vm, const ArmSimulation& arm);

}  // namespace armlet::bind
