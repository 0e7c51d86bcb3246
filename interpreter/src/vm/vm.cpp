#include "armlet/interpreter/host/vm.hpp"

#include <limits>
#include <utility>

#include "armlet/core/ample_stack.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/work.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/state/turn.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet {

namespace {

constexpr std::int64_t kEndless = std::numeric_limits<std::int64_t>::max();

// The virtual clock of a run without a world.
class Clock final : public Timeline {
 public:
  [[nodiscard]] std::int64_t now_ns() const override { return now_ns_; }
  [[nodiscard]] std::int64_t tick_ns() const override { return 1'000'000; }
  bool advance_to(std::int64_t t_ns) override {
    now_ns_ = t_ns;
    return true;
  }

 private:
  std::int64_t now_ns_ = 0;
};

constexpr std::size_t kMostShown = 2000;  // bytes of a value; the rest is left out

RunResult ended(lang::VmState& state, lang::Exit exit) {
  RunResult result;
  if (exit == lang::Exit::kFailed) {
    result.status = state.fault->cancelled ? Progress::kCancelled : Progress::kFailed;
    result.error = std::move(state.fault->diagnostic);
    state.fault.reset();
  }
  state.reopen();
  return result;
}

lang::Exit run_slice(lang::VmState& state, std::uint32_t function, std::int64_t until_ns) {
  try {
    if (state.scheduler == nullptr) {
      state.scheduler = std::make_unique<lang::Scheduler>(state, function);
      if (!lang::make_texts(state)) return lang::Exit::kFailed;
    }
    return state.scheduler->go_on(until_ns);
  } catch (...) {  // of the host, without an instruction of the program as the cause
    lang::raise_thrown(state, state.main);
    return lang::Exit::kFailed;
  }
}

}  // namespace

static std::shared_ptr<const Program> require_program(std::shared_ptr<const Program> program) {
  if (program != nullptr) return program;
  throw ArgumentError("A Vm needs a program; there is none when compiling found mistakes.");
}

static VmOptions require_limits(VmOptions options) {
  const std::int64_t end_ns = options.limits.time_ns;
  if (end_ns >= 0 && end_ns <= kEndOfTime_ns) return options;
  throw ArgumentError("A run cannot end at a virtual time of " + std::to_string(end_ns) +
                      " ns; RunLimits::time_ns lies from 0 to " + std::to_string(kEndOfTime_ns) +
                      " ns, 100 years.");
}

Vm::Vm(std::shared_ptr<const Program> program, VmOptions options)
    : program_(require_program(std::move(program))),
      options_(require_limits(std::move(options))),
      own_timeline_(options_.timeline == nullptr ? std::make_unique<Clock>() : nullptr),
      timeline_(options_.timeline == nullptr ? own_timeline_.get() : options_.timeline),
      state_(std::make_unique<State>(*this, program_->compiled(), options_)) {}

Vm::~Vm() = default;

// Library functions may call the program, which may call library functions, and so on, so a slice
// needs a large stack.
Progress Vm::go_on(std::uint32_t function, const Budget& budget) {
  lang::VmState& state = *state_;
  if (budget.steps == 0)
    throw ArgumentError("A budget of 0 steps lets nothing happen; give at least 1 step.");
  if (budget.statements == 0)
    throw ArgumentError("A budget of 0 statements lets nothing happen; give at least 1.");
  if (budget.statements != Budget::kNoLimit && !program_->compiled().functions[0].has_markers)
    throw ArgumentError("A run by statements needs a program with markers (CompileOptions).");
  const lang::Turn turn(state);
  if (result_.status != Progress::kPaused)
    throw ArgumentError("This Vm has run to its end; make a new one to run again.");
  const bool is_entry = program_->is_entry() && !state.host.call;
  const lang::CountOfRun counting(state);
  if (is_entry && state.scheduler == nullptr) {
    if (state.programs.before == nullptr) {
      state.programs.before = std::make_unique<lang::Before>(state);
      state.programs.before->pass_over(program_->compiled());
    }
    state.tree.wake_watches();
  }
  on_ample_stack([&] {
    const Supervised kernels(&state.kernels);
    state.steps.begin_slice(budget.steps);
    const std::uint64_t begun = state.marks.begun;
    state.marks.pause_at =
        budget.statements < Budget::kNoLimit - begun ? begun + budget.statements : Budget::kNoLimit;
    const lang::Exit exit = run_slice(state, function, budget.until_ns.value_or(kEndless));
    state.steps.begin_slice(Budget::kNoLimit);
    const std::uint64_t steps = state.steps.total - steps_before_;
    if (exit != lang::Exit::kSliced) {
      result_ = ended(state, exit);
      if (result_.error) state.host.error = result_.error;
      // The timeline may have reported the same stop request already.
      if (result_.status == Progress::kCancelled) static_cast<void>(take_cancellation());
      if (state.host.call) state.finish_call(exit == lang::Exit::kDone);
      if (is_entry) finish_entry();
    }
    result_.steps = steps;
  });
  return result_.status;
}

void Vm::finish_entry() {
  const bool done = result_.status == Progress::kDone;
  lang::finish_entry(*state_, done);
  if (done) {
    done_ = program_;
  } else if (done_ != nullptr) {
    program_ = done_;
  }
  state_->programs.newest = &program_->compiled();
}

Progress Vm::run(const Budget& budget) { return go_on(0, budget); }

RunResult Vm::run() {
  run(Budget{});
  return result_;
}

static void require_end(const RunResult& result, std::string_view what) {
  if (result.status != Progress::kPaused) return;
  throw ArgumentError(std::string(what) +
                      " can begin only when what runs in the Vm has run to its end.");
}

void Vm::begin(std::shared_ptr<const Program> entry) {
  entry = require_program(std::move(entry));
  const lang::Turn turn(*state_);
  require_end(result_, "A new entry");
  if (!entry->is_entry() || !program_->is_entry())
    throw ArgumentError(
        "Only entries can follow each other: compile both with CompileOptions::is_entry.");
  if (entry->after() != done_)
    throw ArgumentError(
        "This entry was compiled behind another one than the newest that has run here: give "
        "Vm::newest_entry() as CompileOptions::after.");
  const lang::CountOfRun counting(*state_);
  result_ = {.status = Progress::kPaused, .error = {}, .steps = 0};
  state_->scheduler.reset();
  state_->host.output_left = options_.limits.output_bytes;
  state_->programs.before = std::make_unique<lang::Before>(*state_);
  steps_before_ = state_->programs.before->steps();
  state_->forget_cancellations();
  lang::load(*state_, entry->compiled(), state_->programs.before.get());
  program_ = std::move(entry);
}

void Vm::begin_call(std::uint32_t function, std::vector<Slot> arguments) {
  lang::VmState& state = *state_;
  require_end(result_, "A call in slices");
  result_ = {.status = Progress::kPaused, .error = {}, .steps = 0};
  steps_before_ = state.host.aside.steps;
  state.host.output_left = options_.limits.output_bytes;
  state.forget_cancellations();
  if (program_->is_entry()) state.tree.wake_watches();
  state.scheduler = std::make_unique<lang::Scheduler>(state, function, std::move(arguments));
}

std::optional<EntryValue> Vm::shown() const {
  const lang::ShownValue* shown = done_ == nullptr ? nullptr : &done_->compiled().entry.shown;
  if (shown == nullptr || shown->variable == nullptr || shown->is_hidden) return std::nullopt;
  const lang::hir::Variable& variable = *shown->variable;
  EntryValue value;
  if (shown->is_declared) value.name = variable.name;
  const Slot slot = state_->globals.values[variable.index];
  value.text = lang::value_text(slot, *variable.type, kMostShown);
  if (value.text.size() > kMostShown)
    value.text = std::string(whole_characters(value.text, kMostShown)) + " ...";
  if (variable.type->is(Kind::kText)) value.text = '"' + value.text + '"';
  value.type = type_name(variable.type);
  return value;
}

RunResult Vm::run_test(std::size_t index) {
  const lang::CompiledProgram& program = program_->compiled();
  if (index >= program.module.tests.size()) {
    throw ArgumentError("test " + std::to_string(index) + " does not exist; the program has " +
                        std::to_string(program.module.tests.size()) + " tests.");
  }
  if (state_->scheduler != nullptr)
    throw ArgumentError("This Vm runs something already; make a new one to run a test.");
  go_on(program.module.tests[index].function->index, Budget{});
  return result_;
}

namespace {

// Conditions and the bodies of `when` and `every` take random numbers from the task that contains
// them.
lang::Task& source_of_chance(const lang::VmState& state) {
  lang::Task* task = state.running;
  while (task->origin.watch != nullptr || task == state.condition_task.get() ||
         task == state.host.task.get()) {
    task = task->origin.parent;
  }
  return *task;
}

}  // namespace

Random& Vm::random() { return source_of_chance(*state_).random; }

void Vm::seed(std::uint64_t seed) {
  lang::Task& task = source_of_chance(*state_);
  task.random = Random(seed);
  task.parallels = 0;
}
std::shared_ptr<const void>& Vm::task_data() { return state_->running->host_data; }

void Vm::advise(const Failure& advice) {
  if (!options_.advice) return;
  Diagnostic diagnostic = lang::diagnostic_of(*state_, advice);
  diagnostic.when.reset();  // advice is about the text, so it has no time
  options_.advice(diagnostic);
}

bool Vm::print(std::string_view text) {
  constexpr std::size_t kPiece = 1U << 16U;
  if (!options_.output || state_->host.is_read) return true;
  std::uint64_t& left = state_->host.output_left;
  const std::string_view fitting = whole_characters(text, left);
  left -= fitting.size();
  for (std::size_t at = 0; at < fitting.size();) {
    const std::string_view piece = whole_characters(fitting.substr(at), kPiece);
    if (!charge_work(*this, 4 * piece.size())) return false;
    const std::string why = options_.output(piece);
    if (!why.empty()) return lang::raise(*state_, "R0626", {"print cannot write: " + why});
    at += piece.size();
  }
  if (fitting.size() == text.size()) return true;
  left = 0;
  return lang::raise_out_of_output(*state_);
}

}  // namespace armlet
