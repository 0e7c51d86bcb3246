#pragma once
// The torques that a program requests from its motors, the limits of these, and the options.

#include <optional>
#include <span>
#include <string_view>

#include "armlet/dynamics/simulation.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// A function of the program, fn(t, q, qd) -> double[], kept alive while the law is used.
class TorqueLaw {
 public:
  TorqueLaw(Vm& vm, FunctionValue law);
  ~TorqueLaw();
  TorqueLaw(TorqueLaw&& other) noexcept;
  TorqueLaw(const TorqueLaw&) = delete;
  TorqueLaw& operator=(const TorqueLaw&) = delete;
  TorqueLaw& operator=(TorqueLaw&&) = delete;

  // The torques requested in this state, t seconds after the start. Fails with the joint and the
  // time unless the result is one finite number for each joint.
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

// The limits of motors. Torques that a law requests beyond them are cut off.
class MotorLimits {
 public:
  // The arm's own force limits, which may be infinite, and no limit on the rate of change.
  explicit MotorLimits(const Robot& robot);

  // Sets other limits, above zero, in N m or N, and rates of change per second: one for each joint.
  Answer<void> set_most(Vm& vm, std::span<const double> most, CallPart part);
  Answer<void> set_rates(Vm& vm, std::span<const double> rates, CallPart part);

  // The torques that motors deliver for `hold` seconds when the law requests tau. The first torques
  // are not limited in rate.
  [[nodiscard]] JointVector given(const JointVector& tau, double hold);
  // The time during which any motor delivered less than requested, s.
  [[nodiscard]] double clipped() const { return clipped_; }

 private:
  Answer<void> take(Vm& vm, std::span<const double> values, std::string_view what, CallPart part,
                    JointVector& limits) const;

  JointVector most_, rates_, before_;
  double clipped_ = 0.0;
};

// The arguments of a call that simulates.
struct SimulationCall {
  std::string_view function;  // "simulate"
  double during, every;
  std::string_view method;
  std::optional<double> step;
  double restitution;
  std::optional<std::span<const double>> most, rates;  // of the motors
};

// The options of the call, checked, and the limits of the motors.
Answer<SimulationOptions> simulation_options(Vm& vm, const SimulationCall& call);
Answer<MotorLimits> motor_limits(Vm& vm, const SimulationCall& call, const Robot& robot);

// The failure of a simulation, with the joint and the time.
Failed cannot_simulate(Vm& vm, const ArmSimulation& arm, const SimulationOutcome& outcome,
                       const SimulationOptions& options);

// Advice about joints that reached their limits.
void tell_of_stops(Vm& vm, const ArmSimulation& arm);

// A list of JointEvent; null: it failed, and the failure is set.
[[nodiscard]] ListObj* joint_events(Vm& vm, const ArmSimulation& arm);

}  // namespace armlet::bind
