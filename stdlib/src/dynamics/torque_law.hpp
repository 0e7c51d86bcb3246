#pragma once
// What a program says of the forces of its motors, and what came of it.

#include <optional>
#include <span>
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

// What motors can give. What a law asks for beyond it is cut off.
class MotorLimits {
 public:
  // The arm's own largest forces, which may be infinite, and no limit on how fast they change.
  explicit MotorLimits(const Robot& robot);

  // Other limits instead, above zero, in N m and N, and per second: one value for each joint.
  Answer<void> set_most(Vm& vm, std::span<const double> most, int parameter);
  Answer<void> set_rates(Vm& vm, std::span<const double> rates, int parameter);

  // What the motors give for `hold` seconds, where the law asks for tau. The first forces may be
  // any.
  [[nodiscard]] JointVector given(const JointVector& tau, double hold);
  // How long any motor gave less than it was asked for, s.
  [[nodiscard]] double clipped() const { return clipped_; }

 private:
  Answer<void> take(Vm& vm, std::span<const double> values, std::string_view what, int parameter,
                    JointVector& limits) const;

  JointVector most_, rates_, before_;
  double clipped_ = 0.0;
};

// How a simulation is made, as the call says it.
//
// extra  how many parameters of its own the call has between `every` and `method`.
struct SimulationCall {
  std::string_view function;  // "simulate"
  double during, every;
  std::string_view method;
  std::optional<double> step;
  double restitution;
  std::optional<std::span<const double>> most, rates;  // of the motors
  int extra = 0;

  // Which parameter says what; the robot and the law come before.
  static constexpr int kDuring = 2, kEvery = 3;
  [[nodiscard]] int method_parameter() const { return 4 + extra; }
  [[nodiscard]] int step_parameter() const { return 5 + extra; }
  [[nodiscard]] int restitution_parameter() const { return 6 + extra; }
  [[nodiscard]] int most_parameter() const { return 7 + extra; }
  [[nodiscard]] int rates_parameter() const { return 8 + extra; }
};

// Its options, checked, and what the motors can give.
Answer<SimulationOptions> simulation_options(Vm& vm, const SimulationCall& call);
Answer<MotorLimits> motor_limits(Vm& vm, const SimulationCall& call, const Robot& robot);

// What a simulation could not do, with the joint and the time.
Failed cannot_simulate(Vm& vm, const ArmSimulation& arm, const SimulationOutcome& outcome,
                       const SimulationOptions& options);

// Advice about joints that ran against their limits.
void tell_of_stops(Vm& vm, const ArmSimulation& arm);

// A list of JointEvent; null: the failure is set.
[[nodiscard]] ListObj* joint_events(Vm& vm, const ArmSimulation& arm);

}  // namespace armlet::bind
