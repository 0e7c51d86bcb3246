#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "armlet/math/ode.hpp"
#include "armlet/model/joint_arrays.hpp"

namespace armlet {

// step         s, the longest step of a method with a fixed step size.
// tolerance    of a method with step control.
// restitution  0 to 1: ratio of the speeds after and before a joint hits the stop at its limit.
struct SimulationOptions {
  OdeMethod method = OdeMethod::kRungeKutta4;
  double step = 1e-3;
  double tolerance = 1e-8;
  double restitution = 0.0;
};

// kStop   a joint hit the stop at its limit; `speed` is that before.
// kStick  static friction holds a joint from now on.
// kSlip   a joint that was at rest, held by friction or pressed against its stop, begins to move.
enum class SimulationEventKind : std::uint8_t { kStop, kStick, kSlip };
struct SimulationEvent {
  double t = 0.0;  // s, to 1e-10
  SimulationEventKind kind = SimulationEventKind::kStop;
  int joint = 0;  // from 0
  double speed = 0.0;
};

enum class SimulationStatus : std::uint8_t {
  kDone,
  kMassless,     // the joint moves no inertia
  kNotFinite,    // its acceleration overflows
  kStepTooLong,  // it moves by more than 1 rad or 1 m in one step, or no step size is small enough
  kStiff,        // its viscous friction makes the method unstable with this step size
  kZeno,         // infinitely many events: more than 100 of it within a nanosecond
};
struct SimulationOutcome {
  SimulationStatus status = SimulationStatus::kDone;
  double t = 0.0;
  int joint = 0;
};

// The state between two steps. Between nodes the motion is the cubic through both positions and
// speeds; two nodes at one time are an impact.
struct SimulationNode {
  double t = 0.0;
  JointVector q, qd;
};

class JointModes;

// Simulation of an arm under forces: M(q) qdd + C(q, qd) qd + g(q) + f(qd) = tau, with static and
// dry friction and with stops at the joint limits. The equation changes at the exact instant of
// such an event; nothing is smoothed.
//
// source  D. Karnopp, Computer simulation of stick-slip friction in mechanical dynamic systems,
//         Journal of Dynamic Systems, Measurement, and Control 107, 1985; impacts by Newton's law
//         along the joint.
class ArmSimulation {
 public:
  // q, qd   n joint values and rates; values beyond a limit by rounding are set to it.
  // throws  ArgumentError for a wrong size or number, a value outside the limits, a step or a
  //         tolerance that is not positive, a restitution outside 0 to 1.
  ArmSimulation(std::shared_ptr<const Robot> robot, JointsIn q, JointsIn qd,
                const SimulationOptions& options = {});
  ~ArmSimulation();
  ArmSimulation(const ArmSimulation&) = delete;
  ArmSimulation& operator=(const ArmSimulation&) = delete;

  // Replaces the arm by another one with as many joints, for example after a grasp; the speeds
  // stay.
  void set_robot(std::shared_ptr<const Robot> robot);

  // Advances time by h >= 0 under constant joint forces. After a failure the state is the one
  // before the failed step. No allocation, except for `nodes`, to which the ends of all steps are
  // added.
  //
  // throws  ArgumentError for a wrong size and forces that are not finite.
  SimulationOutcome advance(JointsIn tau, double h, std::vector<SimulationNode>* nodes = nullptr);

  [[nodiscard]] double t() const { return t_; }
  [[nodiscard]] auto q() const { return y_.head(n_); }
  [[nodiscard]] auto qd() const { return y_.tail(n_); }
  [[nodiscard]] const Robot& robot() const { return *robot_; }

  // The first thousand events, and the number of all events.
  [[nodiscard]] const std::vector<SimulationEvent>& events() const { return events_; }
  [[nodiscard]] std::int64_t event_count() const { return event_count_; }

  // The change of the energy minus the work of forces and the losses by friction and impacts, J:
  // the error of the integration.
  [[nodiscard]] double energy_drift() const;

 private:
  [[nodiscard]] SimulationOutcome step(double h, std::vector<SimulationNode>* nodes, double& done);
  [[nodiscard]] bool integrate(double h, const Eigen::VectorXd& from, Eigen::VectorXd& to);
  [[nodiscard]] double first_event(double h);
  [[nodiscard]] SimulationOutcome failed(SimulationStatus status, int joint) const;
  [[nodiscard]] bool take_events();
  [[nodiscard]] bool end_short_flights();
  [[nodiscard]] bool settle();
  [[nodiscard]] int fast_joint() const;
  [[nodiscard]] int stiff_joint(double h);
  void account(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double h);
  void note(SimulationEventKind kind, int joint, double speed);
  void add_node(std::vector<SimulationNode>* nodes) const;

  std::shared_ptr<const Robot> robot_;
  Eigen::Index n_;
  SimulationOptions options_;
  std::unique_ptr<JointModes> modes_;
  OdeIntegrator integrator_;
  OdeRate rate_;
  OdeOutcome last_{};
  double t_ = 0.0;
  Eigen::VectorXd y_, next_, trial_;  // [q; qd]
  JointVector tau_;
  double start_energy_ = 0.0, received_ = 0.0;
  // which joints were at rest before the last change of modes
  std::array<bool, kMaxJoints> stood_{};
  std::vector<SimulationEvent> events_;
  std::int64_t event_count_ = 0;
  double burst_begin_ = 0.0;  // begin of the events of the last nanosecond
  int burst_ = 0;
  bool knows_stiffness_ = false;
};

}  // namespace armlet
