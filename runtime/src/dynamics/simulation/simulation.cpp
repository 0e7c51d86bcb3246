#include "armlet/dynamics/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/dynamics/energy.hpp"
#include "armlet/dynamics/forward_dynamics.hpp"
#include "joint_modes.hpp"

namespace armlet {
namespace {

constexpr double kInstant = 1e-12;     // s, accuracy of event times
constexpr double kRestSpeed = 1e-6;    // per s: a slower joint does not leave its stop
constexpr double kShortFlight = 1e-4;  // s: nor does one that would be back so soon
constexpr double kSlack = 1e-9;        // rad or m, beyond a limit by rounding
constexpr double kFarInOneStep = 1.0;  // rad or m
constexpr int kMostEventsAtOnce = 100;
constexpr double kAtOnce = 1e-9;  // s
constexpr std::size_t kKeptEvents = 1000;

std::span<double> as_span(Eigen::VectorXd& y) {
  return {y.data(), static_cast<std::size_t>(y.size())};
}

bool chooses_steps(OdeMethod method) {
  return method == OdeMethod::kFehlberg45 || method == OdeMethod::kDormandPrince45;
}

double check_inside(const Robot& robot, int i, double q) {
  const double inside = std::clamp(q, robot.lower()[i], robot.upper()[i]);
  if (std::abs(q - inside) <= kSlack) return inside;
  const JointKind kind = robot.joint(i).kind;
  throw ArgumentError(fmt::format(
      "Joint {} of robot `{}` is at {}; expected a value in its range, {} to {}.", i + 1,
      robot.name(), format_joint_value(kind, q), format_joint_value(kind, robot.lower()[i]),
      format_joint_value(kind, robot.upper()[i])));
}

}  // namespace

ArmSimulation::ArmSimulation(std::shared_ptr<const Robot> robot, JointsIn q, JointsIn qd,
                             const SimulationOptions& options)
    : robot_(std::move(robot)),
      n_(robot_->n()),
      options_(options),
      modes_(std::make_unique<JointModes>(*robot_)),
      integrator_(2 * robot_->n(), options.method, options.tolerance),
      tau_(JointVector::Zero(n_)) {
  check_joint_values("q", q, *robot_);
  check_joint_values("qd", qd, *robot_);
  check_positive("step", options.step);
  check_finite("step", options.step);
  if (!(options.restitution >= 0.0 && options.restitution <= 1.0)) {
    throw ArgumentError(
        fmt::format("The restitution is {}; expected 0 to 1.", options.restitution));
  }
  y_.resize(2 * n_);
  y_ << q, qd;
  for (int i = 0; i < n_; ++i) y_[i] = check_inside(*robot_, i, y_[i]);
  next_ = trial_ = y_;
  events_.reserve(kKeptEvents);
  start_energy_ =
      kinetic_energy(*robot_, this->q(), this->qd()) + potential_energy(*robot_, this->q());
  rate_ = [this](double, std::span<const double> y, std::span<double> rate) {
    std::copy_n(y.data() + n_, n_, rate.data());
    return modes_->accelerate(y.data(), y.data() + n_, tau_.data(), rate.data() + n_);
  };
}

ArmSimulation::~ArmSimulation() = default;

void ArmSimulation::set_robot(std::shared_ptr<const Robot> robot) {
  if (robot == robot_) return;
  check_size("robot", robot->n(), n_);
  const double before = energy_drift();
  robot_ = std::move(robot);
  modes_->set_robot(*robot_);
  knows_stiffness_ = false;
  // The change of the energy by a change of the arm is not an error.
  received_ += energy_drift() - before;
}

double ArmSimulation::energy_drift() const {
  return kinetic_energy(*robot_, q(), qd()) + potential_energy(*robot_, q()) - start_energy_ -
         received_;
}

SimulationOutcome ArmSimulation::failed(SimulationStatus status, int joint) const {
  return {status, t_, joint};
}

SimulationOutcome ArmSimulation::advance(JointsIn tau, double h,
                                         std::vector<SimulationNode>* nodes) try {
  check_joint_values("tau", tau, *robot_);
  check_finite("h", h);
  if (h < 0.0) throw ArgumentError(fmt::format("`h` is {} s; expected 0 or more.", h));
  tau_ = tau;
  if (!settle()) return failed(SimulationStatus::kMassless, modes_->bad_joint());
  const double end = t_ + h;
  const double steps = std::max(1.0, std::ceil(h / options_.step - kSlack));
  if (!chooses_steps(options_.method)) {
    const int stiff = stiff_joint(h / steps);
    if (stiff >= 0) return failed(SimulationStatus::kStiff, stiff);
  }
  add_node(nodes);
  const double begin = t_;
  for (double k = 1.0; k <= steps; k += 1.0) {
    const double to = k == steps ? end : begin + h * k / steps;
    while (t_ < to) {
      double done = 0.0;
      const SimulationOutcome outcome = step(to - t_, nodes, done);
      if (outcome.status != SimulationStatus::kDone) return outcome;
      t_ = done == to - t_ ? to : t_ + done;
      if (to - t_ < kInstant) t_ = to;
      add_node(nodes);
    }
  }
  return {SimulationStatus::kDone, t_, 0};
} catch (const ArgumentError&) {
  // Kernels refuse joint values that are not finite.
  if (tau.size() != n_ || !all_finite(tau.data(), n_) || !(h >= 0.0 && std::isfinite(h))) throw;
  Eigen::Index fastest = 0;
  qd().cwiseAbs().maxCoeff(&fastest);
  return failed(SimulationStatus::kNotFinite, static_cast<int>(fastest));
}

// One step of the method, up to the first event in it.
SimulationOutcome ArmSimulation::step(double h, std::vector<SimulationNode>* nodes, double& done) {
  done = h;
  if (!integrate(h, y_, next_)) {
    if (last_.status == OdeStatus::kStopped)
      return failed(SimulationStatus::kMassless, modes_->bad_joint());
    if (last_.status == OdeStatus::kNotFinite)
      return failed(SimulationStatus::kNotFinite, last_.element % static_cast<int>(n_));
    return failed(SimulationStatus::kStepTooLong, fast_joint());
  }
  const bool happened = modes_->margin(next_.data(), next_.data() + n_, tau_.data()) < 0.0;
  if (happened) done = first_event(h);
  const int fast = fast_joint();
  if (std::abs(next_[fast] - y_[fast]) > kFarInOneStep)
    return failed(SimulationStatus::kStepTooLong, fast);
  account(y_, next_, done);
  y_.swap(next_);
  if (!happened) return {};
  t_ += done;
  const double at = t_;
  add_node(nodes);
  const bool went = take_events();
  t_ -= done;
  if (!went) return failed(SimulationStatus::kMassless, modes_->bad_joint());
  if (at - burst_begin_ > kAtOnce) {
    burst_begin_ = at;
    burst_ = 0;
  }
  if (++burst_ <= kMostEventsAtOnce) return {};
  return failed(SimulationStatus::kZeno, events_.empty() ? 0 : events_.back().joint);
}

bool ArmSimulation::integrate(double h, const Eigen::VectorXd& from, Eigen::VectorXd& to) {
  to = from;
  last_ = integrator_.advance(rate_, t_, h, as_span(to));
  return last_.status == OdeStatus::kDone;
}

// The time at which the first mode has ended; next_ becomes the state then.
double ArmSimulation::first_event(double h) {
  double before = 0.0, after = h;
  while (after - before > kInstant) {
    const double middle = 0.5 * (before + after);
    if (!integrate(middle, y_, trial_)) break;
    if (modes_->margin(trial_.data(), trial_.data() + n_, tau_.data()) < 0.0) {
      after = middle;
      next_.swap(trial_);
    } else {
      before = middle;
    }
  }
  return after;
}

// The events at y_: joints that came to rest, hit their stop, or began to slip.
bool ArmSimulation::take_events() {
  double* q = y_.data();
  double* qd = y_.data() + n_;
  const double energy = kinetic_energy(*robot_, this->q(), this->qd());
  bool struck = false;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const JointModes::Mode& mode = (*modes_)[i];
    if (mode.stands) continue;
    if (mode.slides * qd[i] < 0.0) qd[i] = 0.0;
    const double inside = std::clamp(q[i], robot_->lower()[i], robot_->upper()[i]);
    struck = struck || q[i] != inside;
    q[i] = inside;
  }
  // An impact may drive other joints that are pressed against their stops.
  for (int round = 0; struck && round < kMostEventsAtOnce; ++round) {
    struck = false;
    for (Eigen::Index i = 0; i < n_; ++i) {
      const bool into = (q[i] >= robot_->upper()[i] && qd[i] > 0.0) ||
                        (q[i] <= robot_->lower()[i] && qd[i] < 0.0);
      if (!into) continue;
      struck = true;
      if (round == 0) note(SimulationEventKind::kStop, static_cast<int>(i), qd[i]);
      const double bounce = std::abs(qd[i]) < kRestSpeed ? 0.0 : options_.restitution;
      if (!modes_->strike(i, q, qd, bounce)) return false;
    }
  }
  if (!end_short_flights()) return false;
  received_ += kinetic_energy(*robot_, this->q(), this->qd()) - energy;
  return settle();
}

// Joints that would be back at their stop at once are held there.
bool ArmSimulation::end_short_flights() {
  double* q = y_.data();
  double* qd = y_.data() + n_;
  JointVector qdd(n_);
  if (!modes_->settle(q, qd, tau_.data()) || !modes_->accelerate(q, qd, tau_.data(), qdd.data()))
    return false;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const double back = (*modes_)[i].at_stop * qdd[i];
    if (back <= 0.0 || qd[i] == 0.0 || 2.0 * std::abs(qd[i]) > kShortFlight * back) continue;
    if (!modes_->strike(i, q, qd, 0.0)) return false;
  }
  return true;
}

// Chooses the modes from here on, and notes which joints begin to rest or to move.
bool ArmSimulation::settle() {
  integrator_.restart();
  if (!modes_->settle(y_.data(), y_.data() + n_, tau_.data())) return false;
  for (int i = 0; i < n_; ++i) {
    const JointModes::Mode& mode = (*modes_)[i];
    if (std::exchange(stood_[static_cast<std::size_t>(i)], mode.stands) == mode.stands) continue;
    if (!mode.stands) note(SimulationEventKind::kSlip, i, 0.0);
    if (mode.stands && mode.at_stop == 0 && t_ > 0.0) note(SimulationEventKind::kStick, i, 0.0);
  }
  return true;
}

void ArmSimulation::note(SimulationEventKind kind, int joint, double speed) {
  ++event_count_;
  if (events_.size() < kKeptEvents) events_.push_back({t_, kind, joint, speed});
}

int ArmSimulation::fast_joint() const {
  Eigen::Index fastest = 0;
  (next_.head(n_) - y_.head(n_)).cwiseAbs().maxCoeff(&fastest);
  return static_cast<int>(fastest);
}

// A joint whose rate decays faster than a step of h can follow: explicit methods diverge there.
int ArmSimulation::stiff_joint(double h) {
  if (knows_stiffness_) return -1;
  knows_stiffness_ = true;
  const double most = options_.method == OdeMethod::kRungeKutta4 ? 2.78 : 2.0;
  const DynamicsPlan& plan = robot_->derived<RobotDynamics>().plan;
  JointMatrix M = mass_matrix(*robot_, q());
  for (int i = 0; i < n_; ++i) {
    // The joint alone, with all others held: its own decay is at least as fast.
    if (plan.links[robot_->row_of(i)].friction.viscous * h > most * M(i, i)) return i;
  }
  return -1;
}

// Adds the work of the forces, and the loss by friction, by Simpson's rule over the cubic between
// both states.
void ArmSimulation::account(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double h) {
  received_ += tau_.dot(to.head(n_) - from.head(n_));
  if (robot_->derived<RobotDynamics>().plan.friction == FrictionKind::kNone) return;
  double lost = 0.0;
  for (Eigen::Index i = 0; i < n_; ++i) {
    const double v0 = from[n_ + i], v1 = to[n_ + i];
    const double middle = 1.5 * (to[i] - from[i]) / h - 0.25 * (v0 + v1);
    lost += h / 6.0 *
            (v0 * modes_->friction(i, v0) + 4.0 * middle * modes_->friction(i, middle) +
             v1 * modes_->friction(i, v1));
  }
  received_ -= lost;
}

void ArmSimulation::add_node(std::vector<SimulationNode>* nodes) const {
  if (nodes != nullptr) nodes->push_back({t_, q(), qd()});
}

}  // namespace armlet
