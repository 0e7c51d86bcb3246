#include "looker.hpp"

#include <algorithm>

#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "armlet/stdlib/install.hpp"
#include "live_run.hpp"

namespace armlet::lab {
namespace {

constexpr int kStatementsInSlice = 200;
constexpr std::size_t kMostVariables = 2000;
constexpr std::size_t kMostTasks = 200;

// The task that has run last, or the program itself.
const SeenTask* task_in_focus(const std::vector<SeenTask>& tasks, Span running) {
  for (const SeenTask& task : tasks) {
    if (!task.calls.empty() && task.calls.front().at == running) return &task;
  }
  return tasks.empty() ? nullptr : &tasks.front();
}

}  // namespace

Looker::Looker(SessionOptions options) : options_(std::move(options)) {}
Looker::~Looker() = default;

bool Looker::has_ended() const {
  return session_->vm() != nullptr && session_->result().status != Progress::kPaused;
}
bool Looker::is_over() const { return has_ended() || session_->is_at_rest(); }
std::int64_t Looker::now_ns() const {
  return session_->vm() == nullptr ? 0 : session_->host()->now_ns();
}
std::uint64_t Looker::begun() const {
  return session_->vm() == nullptr ? 0 : statements_begun(*session_->vm());
}

void Looker::forget() {
  session_.reset();
  run_ = -1;
  aim_ = Aim::kNothing;
}

void Looker::restart(const SessionLog& log) {
  session_ = std::make_unique<Session>(library_engine(), options_);
  session_->replay(log);
  is_between_ = true;
}

void Looker::go_to(int run, const SessionLog& log, LookAt place) {
  const bool is_same = is_at(run) && session_->vm() != nullptr;
  const bool is_behind =
      is_same && (place.statements ? begun() > *place.statements || now_ns() > place.t_ns
                                   : now_ns() > place.t_ns);
  if (!is_same || is_behind) restart(log);
  log_ = log;
  run_ = run;
  target_ = place;
  aim_ = place.statements ? Aim::kStatements : Aim::kTime;
}

void Looker::step(StepHow how, const std::vector<int>& breakpoints) {
  if (how == StepHow::kBack) {
    const std::uint64_t now = begun();
    if (now == 0) return;
    restart(log_);
    target_ = {.t_ns = kEndOfTime_ns, .statements = now - 1};
    aim_ = Aim::kStatements;
    return;
  }
  if (session_->vm() != nullptr && is_over()) return;
  how_ = how;
  breakpoints_ = breakpoints;
  from_ = session_->vm() == nullptr ? Focus{.depth = 1} : focus();
  if (how == StepHow::kContinue) {
    aim_ = Aim::kBreakpoint;
    set_breakpoints();
  } else if (is_between_) {
    begin_statements();
  } else {
    aim_ = Aim::kStatement;
    static_cast<void>(session_->set_breakpoints(statement_lines(*session_->program())));
  }
}

bool Looker::begin_statements() {
  aim_ = Aim::kStep;
  set_breakpoints();
  return true;
}

void Looker::set_breakpoints() {
  std::vector<SourceLine> places;
  for (const int line : breakpoints_) places.push_back({.source = 0, .line = line});
  static_cast<void>(session_->set_breakpoints(std::move(places)));
}

// Whether the steps of the budget were used up before the goal was reached.
bool Looker::run_slice(Budget budget) {
  const std::uint64_t before = session_->vm() == nullptr ? 0 : session_->result().steps;
  budget.steps = kSliceSteps;
  if (session_->run(budget) != Progress::kPaused) return false;
  return session_->result().steps - before >= kSliceSteps;
}

bool Looker::advance() {
  if (aim_ == Aim::kNothing) return false;
  if (session_->vm() != nullptr && has_ended()) {
    arrive();
    return false;
  }
  bool goes_on = false;
  switch (aim_) {
    case Aim::kNothing:
      break;
    case Aim::kTime:
      goes_on = run_slice({.until_ns = target_.t_ns});
      break;
    case Aim::kStatements:
      // At the start no statement has begun, also before anything has run.
      if (*target_.statements > begun())
        goes_on = run_slice({.statements = *target_.statements - begun()});
      break;
    case Aim::kBreakpoint:
      goes_on = run_slice({});
      break;
    case Aim::kStatement:
      goes_on = run_slice({}) || (!is_over() && !is_step_done() && begin_statements());
      break;
    case Aim::kStep:
      goes_on = true;
      for (int i = 0; i < kStatementsInSlice && goes_on; ++i) {
        const bool is_short = run_slice({.statements = 1});
        goes_on = is_short || !is_step_done();
      }
      break;
  }
  if (has_ended()) goes_on = false;
  if (!goes_on) arrive();
  return goes_on;
}

void Looker::arrive() {
  is_between_ = aim_ != Aim::kTime;
  breakpoints_.clear();
  set_breakpoints();
  aim_ = Aim::kNothing;
}

Looker::Focus Looker::focus() const {
  const std::vector<SeenTask> tasks = seen_tasks(*session_->vm());
  const SeenTask* task = task_in_focus(tasks, running_at(*session_->vm()));
  if (task == nullptr) return {};
  return {task->name, task->calls.size(), task->calls.empty() ? Span{} : task->calls.front().at};
}

bool Looker::is_step_done() const {
  if (is_over() || how_ == StepHow::kInto) return true;
  if (aim_ == Aim::kStep && is_at_breakpoint(*session_->vm())) return true;
  const std::vector<SeenTask> tasks = seen_tasks(*session_->vm());
  for (const SeenTask& task : tasks) {
    if (task.name != from_.task) continue;
    const std::size_t depth = task.calls.size();
    if (how_ == StepHow::kOut) return depth < from_.depth;
    // Statements of other tasks may run in between.
    const bool has_moved = tasks.size() == 1 || depth != from_.depth || task.calls.empty() ||
                           !(task.calls.front().at == from_.at);
    return depth <= from_.depth && has_moved;
  }
  return true;
}

LookAt Looker::place() { return {.t_ns = now_ns(), .statements = begun()}; }

SeenInstant Looker::look() {
  SeenInstant out{.run = run_, .t = to_seconds(now_ns())};
  if (session_->vm() == nullptr) return out;
  Vm& vm = *session_->vm();
  const SourceSet& sources = session_->sources();
  out.statements = begun();
  out.has_ended = is_over();
  out.is_at_breakpoint = !out.has_ended && is_at_breakpoint(vm);
  const std::vector<SeenTask> tasks = seen_tasks(vm);
  const SeenTask* in_focus = task_in_focus(tasks, running_at(vm));
  const auto line_of = [&](Span at) {
    return at.empty() || at.source != sources.first() ? 0 : sources.position(at).line;
  };
  const Span at =
      in_focus != nullptr && !in_focus->calls.empty() ? in_focus->calls.front().at : running_at(vm);
  out.line = line_of(at);
  if (!at.empty()) out.span = span_of(sources, at);
  const auto add = [&](int scope, const SeenVariable& each) {
    if (out.variables.size() >= kMostVariables) return;
    out.variables.push_back({scope, each.name, each.type,
                             each.value.empty() ? std::nullopt : std::optional(each.value),
                             span_of(sources, each.declared)});
  };
  for (const SeenVariable& each : seen_variables(vm)) add(0, each);
  if (in_focus != nullptr) {
    int scope = 0;
    for (auto call = in_focus->calls.rbegin(); call != in_focus->calls.rend(); ++call, ++scope) {
      for (const SeenVariable& each : call->variables) add(scope, each);
    }
  }
  for (const SeenTask& task : tasks) {
    if (out.tasks.size() >= kMostTasks) break;
    SeenInstant::Task seen{.name = task.name, .waits = task.waits};
    if (!task.calls.empty()) {
      seen.line = line_of(task.calls.front().at);
      seen.span = span_of(sources, task.calls.front().at);
    }
    for (auto call = task.calls.rbegin(); call != task.calls.rend(); ++call)
      seen.calls.push_back(call->function);
    out.tasks.push_back(std::move(seen));
  }
  for (const auto& [name, value] : session_->host()->cell().signals().all())
    out.signals.emplace_back(name, value);
  out.things = things_of(session_->host()->cell());
  return out;
}

}  // namespace armlet::lab
