#include <cassert>
#include <utility>

#include "armlet/core/ample_stack.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/work.hpp"
#include "format_value.hpp"
#include "vm/failures/failures.hpp"
#include "vm/tasks/tasks.hpp"

namespace armlet {

namespace {

// A clock without a world.
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

// A Vm runs once: its variables are those of that run.
RunResult refuse_second_run() {
  RunResult result;
  result.status = RunStatus::kFailed;
  result.error =
      make_diagnostic("R0626", {}, {"this Vm has run already; make a new one to run again"});
  return result;
}

// The program belongs to this thread while it runs.
class OnThisThread {
 public:
  explicit OnThisThread(lang::VmState& state) : state_(state) {
    state_.thread = lang::this_thread();
  }
  ~OnThisThread() { state_.thread = nullptr; }
  OnThisThread(const OnThisThread&) = delete;
  OnThisThread& operator=(const OnThisThread&) = delete;

 private:
  lang::VmState& state_;
};

RunResult finish_run(lang::VmState& state, lang::Exit exit, std::uint64_t steps_before) {
  RunResult result;
  state.steps.settle();
  result.steps = state.steps.total - steps_before;
  if (exit != lang::Exit::kDone) {
    result.status = state.fault->cancelled ? RunStatus::kCancelled : RunStatus::kFailed;
    result.error = std::move(state.fault->diagnostic);
  }
  if (state.newest->is_entry) {
    lang::finish_entry(state, exit == lang::Exit::kDone);
    state.fault.reset();
    state.is_leaving = false;
  } else {
    state.clear();
    assert(state.heap.used() == 0 && "every object was released");
  }
  return result;
}

// Functions of the library call the program, which calls functions of the library, and so on.
RunResult start(lang::VmState& state, std::uint32_t function) {
  RunResult result;
  const OnThisThread here(state);
  const std::uint64_t steps_before = state.steps.total;
  on_ample_stack([&] {
    const Supervised kernels(&state.kernels);
    lang::Exit exit = lang::Exit::kFailed;
    try {
      lang::Scheduler scheduler(state);
      if (lang::make_texts(state)) exit = scheduler.run(function);
    } catch (...) {  // of the host, where no instruction of the program is to blame
      lang::raise_thrown(state, state.main);
      exit = lang::Exit::kFailed;
    }
    result = finish_run(state, exit, steps_before);
  });
  return result;
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
      state_(std::make_unique<lang::VmState>(*this, program_->compiled(), options_)) {}

Vm::~Vm() = default;

RunResult Vm::run() {
  if (std::exchange(state_->has_run, true)) return refuse_second_run();
  if (!program_->is_entry()) return start(*state_, 0);
  if (state_->before == nullptr) state_->before = std::make_unique<lang::Before>(*state_);
  state_->tree.wake_watches();
  RunResult result = start(*state_, 0);
  if (result.status == RunStatus::kDone) done_ = program_;
  program_ = done_ != nullptr ? done_ : program_;
  state_->newest = &program_->compiled();
  return result;
}

void Vm::begin(std::shared_ptr<const Program> entry) {
  entry = require_program(std::move(entry));
  if (state_->thread != nullptr)
    throw ArgumentError("A new entry can begin only when the one before has ended.");
  if (!state_->has_run) throw ArgumentError("The entry before has not run; run it first.");
  if (!entry->is_entry() || !program_->is_entry())
    throw ArgumentError(
        "Only entries can follow each other: compile both with CompileOptions::is_entry.");
  if (entry->after() != done_)
    throw ArgumentError(
        "This entry was compiled behind another one than the newest that has run here: give that "
        "one "
        "as CompileOptions::after.");
  state_->has_run = false;
  state_->before = std::make_unique<lang::Before>(*state_);
  lang::load(*state_, entry->compiled(), state_->before.get());
  program_ = std::move(entry);
}

std::optional<EntryValue> Vm::shown() const {
  const lang::ShownValue* shown = done_ == nullptr ? nullptr : &done_->compiled().shown;
  if (shown == nullptr || shown->variable == nullptr || shown->is_hidden) return std::nullopt;
  const lang::hir::Variable& variable = *shown->variable;
  EntryValue value;
  if (shown->is_declared) value.name = variable.name;
  const Slot slot = state_->globals[variable.index];
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
  if (std::exchange(state_->has_run, true)) return refuse_second_run();
  return start(*state_, program.module.tests[index].function->index);
}

namespace {

// What `when` and `every` start, and conditions, draw from the stream of the task around them.
lang::Task& source_of_chance(const lang::VmState& state) {
  lang::Task* task = state.running;
  while (task->watch != nullptr || task == state.condition_task.get()) task = task->parent;
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
  diagnostic.when.reset();  // advice is about the text, whenever it was given
  options_.advice(diagnostic);
}

bool Vm::print(std::string_view text) {
  constexpr std::size_t kPiece = 1U << 16U;
  if (!options_.output) return true;
  std::uint64_t& left = state_->output_left;
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
