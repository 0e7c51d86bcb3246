// Robots under forces: without the clock, and on it (language reference, section 13.5).

#include <fmt/format.h>

#include <cmath>

#include "armlet/kinematics/forward.hpp"
#include "dynamics/torque_law.hpp"
#include "messages/library_messages.hpp"
#include "moves/grips.hpp"
#include "moves/moves.hpp"
#include "rules/rules_settings.hpp"
#include "values/robots/give.hpp"
#include "values/time_left.hpp"

namespace armlet::bind {
namespace {

// ---- without the clock

// A Simulation with room for its rows.
struct Rows {
  RecordObj* record = nullptr;  // null: there was no memory for it
  ListObj* t = nullptr;
  MatrixObj *q = nullptr, *qd = nullptr, *tau = nullptr;

  void put(std::uint32_t row, double time, const ArmSimulation& arm, const JointVector& forces) {
    t->data[row].d = time;
    const Eigen::Index n = forces.size();
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::size_t at =
          std::size_t{row} * static_cast<std::size_t>(n) + static_cast<std::size_t>(i);
      q->data()[at] = arm.q()[i];
      qd->data()[at] = arm.qd()[i];
      tau->data()[at] = forces[i];
    }
  }
};

Rows new_rows(Vm& vm, std::uint32_t count, std::uint32_t joints) {
  Rows rows{.record = new_record(vm, vm.program().library_record("Simulation"))};
  if (rows.record == nullptr) return rows;
  const std::span<Slot> fields(rows.record->fields(), 4);
  fields[0].o = rows.t = new_list(vm, count, false);
  if (rows.t != nullptr) fields[1].o = rows.q = new_matrix(vm, count, joints);
  if (rows.q != nullptr) fields[2].o = rows.qd = new_matrix(vm, count, joints);
  if (rows.qd != nullptr) fields[3].o = rows.tau = new_matrix(vm, count, joints);
  if (rows.tau != nullptr) return rows;
  release(vm, rows.record);
  return {};
}

Answer<std::uint32_t> holds_of(Vm& vm, const SimulationCall& call) {
  constexpr double kMost = 10'000'000;
  constexpr double kRest = 1e-9;  // of a hold: a remainder due to rounding is not a hold of its own
  const double holds = std::max(1.0, std::ceil(call.during / call.every - kRest));
  if (holds <= kMost) return static_cast<std::uint32_t>(holds);
  return failure(vm, "R0613",
                 fmt::format("{} would ask for torques {:.15g} times; {:.15g} are the limit",
                             call.function, holds, kMost),
                 at("every"), {}, "use a longer every");
}

// The start of hold k, s. A time that differs from a whole number of nanoseconds only by rounding
// becomes that number, as on the clock: row 3 of holds of 200 us is at 0.6 ms.
double start_of(std::uint32_t k, double every) {
  constexpr double kRounding = 4e-16;  // relative, of the product
  const double ns = k * every * 1e9;
  const double whole = std::round(ns);
  return std::abs(ns - whole) <= kRounding * ns ? whole / 1e9 : k * every;
}

// Simulates hold after hold; the torques of each are constant until the next.
Answer<void> run(Vm& vm, ArmSimulation& arm, TorqueLaw& law, MotorLimits& motors,
                 const SimulationCall& call, const SimulationOptions& options, std::uint32_t holds,
                 Rows& rows) {
  double now = 0.0;
  for (std::uint32_t k = 0;; ++k) {
    const auto asked = law(arm.robot(), now, arm.q(), arm.qd());
    if (!asked) return Failed{};
    const double next = k + 1 >= holds ? call.during : start_of(k + 1, call.every);
    const JointVector tau = motors.given(*asked, next - arm.t());
    rows.put(k, now, arm, tau);
    if (k == holds) return {};
    const double steps = std::max(1.0, (next - arm.t()) / options.step);
    if (!charge_steps(vm, static_cast<std::uint64_t>(20.0 * std::min(steps, 1e15))))
      return Failed{};
    const SimulationOutcome outcome = arm.advance(tau, next - arm.t());
    if (outcome.status != SimulationStatus::kDone)
      return cannot_simulate(vm, arm, outcome, options);
    now = next;
  }
}

// The joint values at which a simulation starts: the present ones, or given ones at rest.
Answer<Eigen::VectorXd> start_position(Vm& vm, const CellRobot& state, JointList from,
                                       CallPart part) {
  return joint_argument(vm, *state.model, from, part);
}

Answer<Eigen::VectorXd> start_position(Vm& vm, const CellRobot& state, const PosJ* from,
                                       CallPart part) {
  if (from == nullptr) return Eigen::VectorXd(state.q);
  return joint_argument(vm, *state.model, *from, part);
}

bool is_given(JointList) { return true; }
bool is_given(const PosJ* from) { return from != nullptr; }

template <class From>
Answer<RecordObj*> simulate(Vm& vm, const RobotRef& r, FunctionValue function, double during,
                            double every, From from, std::optional<JointList> speeds,
                            std::string_view method, std::optional<double> step, double restitution,
                            std::optional<JointList> most, std::optional<JointList> rates) {
  const SimulationCall call{"simulate", during, every, method, step, restitution, most, rates};
  const auto options = simulation_options(vm, call);
  if (!options) return Failed{};
  const auto holds = holds_of(vm, call);
  if (!holds) return Failed{};
  const CellRobot& state = state_of(vm, r);
  auto motors = motor_limits(vm, call, *state.model);
  if (!motors) return Failed{};
  const auto q = start_position(vm, state, from, at("from"));
  if (!q) return Failed{};
  Eigen::VectorXd qd = state.qd;
  if (is_given(from)) qd.setZero();
  if (speeds) {
    const auto given = joint_argument(vm, *state.model, *speeds, at("speeds"));
    if (!given) return Failed{};
    qd = *given;
  }
  try {
    ArmSimulation arm(state.loaded, *q, qd, *options);
    Rows rows = new_rows(vm, *holds + 1, static_cast<std::uint32_t>(q->size()));
    if (rows.record == nullptr) return Failed{};
    TorqueLaw law(vm, function);
    const bool done = static_cast<bool>(run(vm, arm, law, *motors, call, *options, *holds, rows));
    ListObj* const events = done ? joint_events(vm, arm) : nullptr;
    rows.record->fields()[4].o = events;
    rows.record->fields()[5] = slot_of(arm.energy_drift());
    rows.record->fields()[6] = slot_of(motors->clipped());
    if (events != nullptr) {
      tell_of_stops(vm, arm);
      return rows.record;
    }
    release(vm, rows.record);
    return Failed{};
  } catch (const ArgumentError& error) {
    return failure_of(vm, row("R0640"), error, at("from"));
  }
}

// ---- on the clock

// Adds the cubic between each two states; intervals shorter than a nanosecond are left out.
void add_pieces(const std::vector<SimulationNode>& nodes, double begin,
                std::vector<JointPath>& joints) {
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const SimulationNode &from = nodes[k - 1], &to = nodes[k];
    const double h = to.t - from.t;
    if (!(h > 0.0)) continue;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      const double rate = (to.q[j] - from.q[j]) / h;
      Segment piece{.start = from.t - begin, .duration = h, .degree = 3};
      piece.c[0] = from.q[j];
      piece.c[1] = from.qd[j];
      piece.c[2] = (3.0 * rate - 2.0 * from.qd[j] - to.qd[j]) / h;
      piece.c[3] = (from.qd[j] + to.qd[j] - 2.0 * rate) / (h * h);
      joints[i].segments.push_back(piece);
    }
  }
}

// The motion during a hold. It is extended to twice its duration, so that it does not end at rest.
Trajectory motion_of(const std::vector<SimulationNode>& nodes, double hold) {
  std::vector<JointPath> joints(static_cast<std::size_t>(nodes.front().q.size()));
  const double begin = nodes.front().t;
  add_pieces(nodes, begin, joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Segment& last = joints[i].segments.back();
    const SimulationNode& end = nodes.back();
    Segment tail{.start = last.end(), .duration = hold, .degree = 2};
    tail.c[0] = end.q[static_cast<Eigen::Index>(i)];
    tail.c[1] = end.qd[static_cast<Eigen::Index>(i)];
    tail.c[2] = 0.5 * last.value(last.duration, 2);
    joints[i].q_end = tail.value(hold);
    joints[i].segments.push_back(tail);
  }
  return Trajectory(std::move(joints), nodes.back().t - begin + hold);
}

class TorqueWaiting : public Waiting {
 public:
  TorqueWaiting(Vm& vm, const RobotRef& r, FunctionValue law, MotorLimits motors,
                const SimulationCall& call, const SimulationOptions& options)
      : host_(Host::of(vm)),
        robot_(r.id),
        law_(vm, law),
        motors_(std::move(motors)),
        options_(options),
        every_ns_(std::max<std::int64_t>(to_ns(call.every), 1)),
        begin_ns_(host_.now_ns()),
        end_ns_(host_.now_ns() + to_ns(call.during)),
        next_ns_(host_.now_ns()),
        arm_(state().loaded, state().q, state().qd, options) {}

  // Asks the law for torques and waits until the next time to ask.
  Answer<void> hold(Vm& vm) {
    arm_.set_robot(state().loaded);
    const auto asked = law_(arm_.robot(), to_seconds(next_ns_ - begin_ns_), arm_.q(), arm_.qd());
    if (!asked) return Failed{};
    next_ns_ = std::min(next_ns_ + every_ns_, end_ns_);
    const double until = to_seconds(next_ns_ - begin_ns_);
    const double seconds = until - arm_.t();
    const JointVector tau = motors_.given(*asked, seconds);
    nodes_.clear();
    const SimulationOutcome outcome = arm_.advance(tau, seconds, &nodes_);
    if (outcome.status != SimulationStatus::kDone)
      return cannot_simulate(vm, arm_, outcome, options_);
    motion_ = host_.cell().push(robot_, motion_of(nodes_, seconds), tau);
    return {};
  }

  [[nodiscard]] std::int64_t due_ns() const override {
    return is_pushed() ? next_ns_ : host_.cell().known_until(motion_);
  }
  [[nodiscard]] bool is_over() const override { return report().state != MotionState::kRunning; }
  [[nodiscard]] bool has_work() const override { return is_pushed() && host_.now_ns() >= next_ns_; }
  bool work(Vm& vm) override {
    if (next_ns_ < end_ns_) return static_cast<bool>(hold(vm));
    host_.cell().settle(robot_);
    return true;
  }
  void stop() override {
    if (!is_over()) host_.cell().stop(robot_);
  }
  Signal finish(Vm& vm, Slot& result) override {
    const MotionReport& done = report();
    const bool reached = done.state == MotionState::kReached;
    host_.report_move({state().name, "torqueJ", to_seconds(done.start_ns),
                       to_seconds(done.end_ns - done.start_ns), !reached,
                       host_.cell().T_world_tool(robot_)});
    if (done.halted) {
      Failure f;
      f.headline = Headline(row("R0618"));
      f.resource = resource();
      f.moved = done.end_ns > done.start_ns;
      return fail(vm, std::move(f));
    }
    if (!check_overload(vm, {.function = "torqueJ", .robot = robot_}, done)) return Signal::kFail;
    tell_of_stops(vm, arm_);
    RecordObj* record = new_record(vm, vm.program().library_record("TorqueRun"));
    ListObj* events = record != nullptr ? joint_events(vm, arm_) : nullptr;
    if (events == nullptr) {
      if (record != nullptr) release(vm, record);
      return Signal::kFail;
    }
    record->fields()[0] = slot_of(reached);
    record->fields()[1] = slot_of(!reached);
    record->fields()[2] = slot_of(to_seconds(done.end_ns - done.start_ns));
    record->fields()[3].o = events;
    record->fields()[4] = slot_of(arm_.energy_drift());
    record->fields()[5] = slot_of(motors_.clipped());
    result.o = record;
    return Signal::kDone;
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("torqueJ of {}", state().name);
  }
  [[nodiscard]] Resource resource() const override { return robot_called(state().name); }

 private:
  [[nodiscard]] const CellRobot& state() const { return host_.cell().robot(robot_); }
  [[nodiscard]] const MotionReport& report() const { return host_.cell().report(motion_); }
  [[nodiscard]] bool is_pushed() const { return !is_over() && state().forces.size() != 0; }

  Host& host_;
  int robot_;
  TorqueLaw law_;
  MotorLimits motors_;
  SimulationOptions options_;
  std::int64_t every_ns_, begin_ns_, end_ns_, next_ns_;
  ArmSimulation arm_;
  std::vector<SimulationNode> nodes_;
  int motion_ = -1;
};

Started torque_j(Vm& vm, const RobotRef& r, FunctionValue law, double during, double every,
                 std::string_view method, std::optional<double> step, double restitution,
                 std::optional<JointList> most, std::optional<JointList> rates) {
  const SimulationCall call{"torqueJ", during, every, method, step, restitution, most, rates};
  if (!check_idle(vm, r.id)) return Failed{};
  const auto options = simulation_options(vm, call);
  if (!options || !check_time_left(vm, "a motion", during, at("during"))) return Failed{};
  auto motors = motor_limits(vm, call, model_of(vm, r));
  if (!motors) return Failed{};
  try {
    auto waiting = std::make_unique<TorqueWaiting>(vm, r, law, *std::move(motors), call, *options);
    if (!waiting->hold(vm)) return Failed{};
    return std::unique_ptr<Waiting>(std::move(waiting));
  } catch (const ArgumentError& error) {
    return failure_of(vm, row("R0640"), error, at("law"));
  }
}

constexpr std::string_view kSimulateHelp =
    "What the robot would do under these torques, without moving it: M(q) qdd + C qd + g + f = "
    "tau, "
    "with dry friction that holds and lets go, and stops at the limits of the joints. law(t, q, "
    "qd), t from the start, is asked at the start and every so often, and held in between. It "
    "starts where the robot is, "
    "or from a position, at rest or with these speeds. t, q, qd and tau hold the start and the end "
    "of every hold; events are the instants at which a joint ran against its stop (\"stop\"), came "
    "to stand (\"stick\") or began to move (\"slip\"), the first thousand; drift is the error of "
    "the energy. method and step are those of ode; restitution is the part of its speed with which "
    "a joint leaves its stop. Motors give at most maxTorques, which are those of the arm if they "
    "are "
    "left out, and change by at most maxTorqueRates each second; `clipped` is how long one of them "
    "gave less than it was asked for.";
constexpr std::string_view kTorqueHelp =
    "Moves the arm by the torques of law(t, q, qd), t from the start, asked every so often and "
    "held "
    "in between; the rest as for simulate. Other tasks go on beside it, and until ends it. At its "
    "end the arm is brought to rest under control.";

constexpr NativeFunction kSimulationFunctions[] = {
    def<simulate<const PosJ*>, simulate<JointList>>(
        "simulate(r: robot, law: fn(time, double[], double[]) -> double[], during: time, every: "
        "time = 1ms, from: posJ? | double[], speeds: double[]?, method: string = \"rk4\", step: "
        "time?, restitution: double = 0.0, maxTorques: double[]?, maxTorqueRates: double[]?) -> "
        "Simulation",
        kSimulateHelp, "robots.puma560().simulate(fn(t, q, qd) => zeros(6), during: 100ms).t.last",
        {.check = check_method<"method">}),
    def<torque_j>(
        "torqueJ(r: robot, law: fn(time, double[], double[]) -> double[], during: time, every: "
        "time = 1ms, method: string = \"rk4\", step: time?, restitution: double = 0.0, maxTorques: "
        "double[]?, maxTorqueRates: double[]?) -> TorqueRun",
        kTorqueHelp, "robots.puma560().torqueJ(fn(t, q, qd) => zeros(6), during: 100ms)",
        {.check = check_method<"method">, .pauses = true}),
};

}  // namespace

std::span<const NativeFunction> simulation_functions() { return kSimulationFunctions; }

}  // namespace armlet::bind
