#include "armlet/stdlib/session.hpp"

#include <algorithm>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/host/instants.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "armlet/interpreter/world_names.hpp"
#include "replay/journal.hpp"
#include "robot/rules.hpp"
#include "session/bind.hpp"
#include "session/editor_texts.hpp"

namespace armlet {
namespace {

// One slice at a time; what somebody wished of a run ends with it, however it ends.
class OneSlice {
 public:
  OneSlice(std::atomic<bool>& is_running, std::atomic<bool>& cancelled, const bool& is_under_way)
      : is_running_(is_running), cancelled_(cancelled), is_under_way_(is_under_way) {
    if (is_running_.exchange(true))
      throw ArgumentError("The session runs already; use another one.");
  }
  ~OneSlice() {
    if (!is_under_way_) cancelled_.store(false);
    is_running_.store(false);
  }
  OneSlice(const OneSlice&) = delete;
  OneSlice& operator=(const OneSlice&) = delete;

 private:
  std::atomic<bool>& is_running_;
  std::atomic<bool>& cancelled_;
  const bool& is_under_way_;
};

// Whatever was wished of a compilation that ends with no program has come true with its end.
class OneCompilation {
 public:
  OneCompilation(const bool& can_run, std::atomic<bool>& cancelled)
      : can_run_(can_run), cancelled_(cancelled) {}
  ~OneCompilation() {
    if (!can_run_) cancelled_.store(false);
  }
  OneCompilation(const OneCompilation&) = delete;
  OneCompilation& operator=(const OneCompilation&) = delete;

 private:
  const bool& can_run_;
  std::atomic<bool>& cancelled_;
};

// The machine that `cancel` reaches. It goes only when nobody is about to touch it. A program that
// names an object first fills the world, so one machine can stand before another.
class InReach {
 public:
  InReach(Vm& vm, std::atomic<Vm*>& running, const std::atomic<int>& cancelling,
          const std::atomic<bool>& cancelled)
      : running_(running),
        cancelling_(cancelling),
        cancelled_(cancelled),
        before_(running.exchange(&vm)) {
    if (cancelled_.load()) vm.cancel();
  }
  ~InReach() {
    running_.store(before_);
    while (cancelling_.load() != 0) yield_thread();
    if (before_ != nullptr && cancelled_.load()) before_->cancel();
  }
  InReach(const InReach&) = delete;
  InReach& operator=(const InReach&) = delete;

 private:
  std::atomic<Vm*>& running_;
  const std::atomic<int>& cancelling_;
  const std::atomic<bool>& cancelled_;
  Vm* const before_;
};

// Whether names of objects may be checked: the text, or a file that it imports, calls one of the
// functions that take them.
bool may_name_objects(std::string_view text) {
  const auto mentions = [&](std::string_view word) {
    return text.find(word) != std::string_view::npos;
  };
  if (mentions("import")) return true;
  for (const bind::Chapter& chapter : bind::chapters()) {
    for (const NativeFunction& function : chapter.functions)
      if (function.check == bind::check_object_name && mentions(function.name)) return true;
  }
  return false;
}

// The variable is "scaraLab.pickIt".
PressReport report_of(const TaskEnd& end) {
  PressReport report{.button = std::string(end.variable.substr(end.variable.find('.') + 1)),
                     .start_ns = end.start_ns,
                     .end_ns = end.end_ns};
  if (end.failure != nullptr) report.failure = *end.failure;
  return report;
}

}  // namespace

Session::Session(const Engine& engine, SessionOptions options)
    : engine_(engine), options_(std::move(options)) {}
Session::~Session() {
  try {
    give_up();
  } catch (...) {  // of a backend; there is nobody to tell
    is_under_way_ = false;
  }
}

std::unique_ptr<Host> Session::make_host(bool with_world) {
  HostOptions host_options;
  if (with_world) host_options.journal = journal_.get();
  host_options.robot = options_.robot;
  host_options.planners = options_.planners;
  host_options.on_move = options_.on_move;
  host_options.pace = options_.pace;
  host_options.folder = options_.folder;
  if (options_.default_world) {
    host_options.default_world = [this](Host& host, const std::vector<std::string>&) {
      fill_world(host, *options_.default_world, problems_);
    };
  }
  auto host = std::make_unique<Host>(std::move(host_options));
  if (with_world && options_.world) fill_world(*host, *options_.world, problems_);
  return host;
}

// A world is a program that declares objects; it runs in the cell before time begins.
bool Session::fill_world(Host& host, const WorldText& world, std::vector<Problem>& problems) {
  host.set_world_name(world.name);
  CompileOptions compile_options;
  compile_options.limits = options_.parse_limits;
  compile_options.host = &host;
  compile_options.open = false;
  compile_options.cancelled = is_silent_ ? nullptr : &cancelled_;
  Compilation compiled = engine_.compile(world.text, world.name + ".rbt", compile_options);
  for (Diagnostic& d : compiled.diagnostics) problems.push_back({std::move(d), compiled.sources});
  if (compiled.program == nullptr) return false;
  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = &host;
  vm_options.host = &host;
  Vm vm(compiled.program, std::move(vm_options));
  std::optional<InReach> in_reach;
  if (!is_silent_) in_reach.emplace(vm, running_, cancelling_, cancelled_);
  RunResult result = vm.run();
  if (result.status == Progress::kDone) return true;
  if (result.error) problems.push_back({*std::move(result.error), compiled.sources});
  return false;
}

// The world is evaluated once, in a cell of its own; what it then holds is all that checks know.
void Session::describe_world() {
  const std::optional<WorldText>& text = options_.world ? options_.world : options_.default_world;
  if (world_names_ != nullptr || !text) return;
  world_problems_.clear();
  const std::unique_ptr<Host> host = make_host(false);
  fill_world(*host, *text, world_problems_);
  auto names = std::make_shared<WorldNames>();
  names->world = text->name;
  names->things = host->cell().world().names();
  names->maker = "object";
  if (!cancelled_.load()) world_names_ = std::move(names);
}

const SourceSet& Session::sources() const {
  if (compilation_.sources == nullptr)
    throw ArgumentError("A session has no sources before its first compile().");
  return *compilation_.sources;
}

void Session::cancel() noexcept {
  cancelled_.store(true);
  cancelling_.fetch_add(1);
  if (Vm* vm = running_.load()) vm->cancel();
  cancelling_.fetch_sub(1);
}

CompileOptions Session::compile_options(Host& host, CompileOptions how) const {
  CompileOptions out = std::move(how);
  out.limits = options_.parse_limits;
  out.host = &host;
  out.world = world_names_;
  out.load = options_.load;
  out.open = options_.open;
  out.markers = options_.markers;
  out.cancelled = &cancelled_;
  return out;
}

std::shared_ptr<const Analysis> Session::analyse(std::string text, std::string name,
                                                 const std::shared_ptr<const Analysis>& before) {
  if (is_running_.load())
    throw ArgumentError("A session cannot analyse while its program runs; use another one.");
  const bool makes_program = false;
  const OneCompilation one_compilation(makes_program, cancelled_);
  describe_world();
  const std::unique_ptr<Host> host = make_host(false);
  CompileOptions how;
  how.is_entry = is_entry_;
  how.after = newest_program();
  CompileOptions options = compile_options(*host, std::move(how));
  options.texts = editor_texts(host->planners().names(), world_names_);
  return engine_.analyse(std::move(text), std::move(name), options, before);
}

bool Session::compile(std::string text, std::string name) {
  require_idle("compile");
  repeated_.reset();
  return compile_program(std::move(text), std::move(name));
}

bool Session::compile_program(std::string text, std::string name) {
  forget_run();
  log_.clear();
  done_ = 0;
  is_entry_ = false;
  return compile_as(std::move(text), std::move(name), {});
}

void Session::forget_run() {
  can_run_ = false;
  give_up();
  vm_.reset();
  journal_.reset();
}

bool Session::compile_as(std::string text, std::string name, const CompileOptions& how) {
  can_run_ = false;
  problems_.clear();
  const OneCompilation one_compilation(can_run_, cancelled_);
  if (options_.world || may_name_objects(text)) describe_world();
  const std::unique_ptr<Host> host = make_host(false);
  CompileOptions options = compile_options(*host, how);
  options.load = load_imports();
  compilation_ = engine_.compile(text, name, options);
  // What it names and does not know may be a thing of the world, which is looked at only then.
  if (world_names_ == nullptr &&
      std::ranges::find(compilation_.diagnostics, "E0201", &Diagnostic::code) !=
          compilation_.diagnostics.end()) {
    describe_world();
    options.world = world_names_;
    options.load = load_imports();
    if (world_names_ != nullptr)
      compilation_ = engine_.compile(std::move(text), std::move(name), options);
  }
  const bool has_program = compilation_.program != nullptr;
  const bool uses_world = options_.world || (has_program && compilation_.program->uses_world());
  if (uses_world && !compilation_.cancelled) problems_ = world_problems_;
  for (const Diagnostic& d : compilation_.diagnostics)
    problems_.push_back({d, compilation_.sources});
  can_run_ = has_program && (!options_.world || world_problems_.empty());
  return can_run_;
}

std::vector<std::string> Session::world_objects() {
  describe_world();
  return world_names_ != nullptr ? world_names_->things : std::vector<std::string>();
}

void Session::begin_run() {
  give_up();
  begin_cell(compilation_.program);
  result_ = vm_->result();
  is_under_way_ = true;
}

// A new cell, and a machine for the program in it.
void Session::begin_cell(const std::shared_ptr<const Program>& program) {
  vm_.reset();
  begin_journal();
  host_ = make_host(true);
  names_objects_ = decides_picking_ = false;
  take_world(*program);
  fan_out_ = std::make_unique<FanOut>(confidant_ == nullptr ? options_.backends
                                                            : std::vector<Backend*>{confidant_});
  fan_out_->set_muted(is_silent_ && confidant_ == nullptr);
  // Of entries that run once more the next one begins to tell; a run counts on what it tells.
  if (!is_silent_ || !is_entry_) listen();

  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = host_.get();
  vm_options.host = host_.get();
  vm_options.output = [this, &cell = host_->cell()](std::string_view text) {
    cell.note(NoteKind::kOutput, text);
    return journal_->print(text,
                           [&] { return options_.output ? options_.output(text) : std::string(); });
  };
  vm_options.advice = [this](const Diagnostic& advice) {
    if (options_.advice && !is_silent_) options_.advice(advice);
  };
  vm_options.stays = options_.laboratory;
  vm_options.on_task_end = [this](const TaskEnd& end) {
    if (options_.on_press && !is_silent_) options_.on_press(report_of(end));
  };
  vm_ = std::make_unique<Vm>(program, std::move(vm_options));
  cancel_at(*vm_, journal_->entry().cancelled);
  if (!breakpoints_.empty() && !is_silent_) armlet::set_breakpoints(*vm_, breakpoints_);
}

void Session::listen() {
  fan_out_->set_muted(is_silent_ && confidant_ == nullptr);
  if (!options_.backends.empty() || confidant_ != nullptr)
    host_->cell().set_backend(fan_out_.get());
}

// The program that is about to run may name objects, and pick them by contact.
void Session::take_world(const Program& program) {
  if (!options_.world && program.uses_world()) host_->want_world(program.declared_names("object"));
  names_objects_ = names_objects_ || program.mentions("insertObj");
  decides_picking_ = decides_picking_ || program.mentions("grasp") || program.mentions("release");
  host_->cell().set_contact_picking(names_objects_ && !decides_picking_);
}

// A program may end while a robot still slows down after a velocity command. Whether all stand.
bool Session::come_to_rest(const Budget& budget) {
  while (const auto next = host_->cell().next_event()) {
    const std::int64_t until = std::min(*next, budget.until_ns.value_or(*next));
    if (until <= host_->now_ns() && until < *next) return false;
    if (!host_->advance_to(until)) break;
  }
  return true;
}

// A robot of a laboratory may slow down still when its program has ended.
void Session::rest(const Budget& budget) {
  while (!budget.until_ns && armlet::is_at_rest(*vm_)) {
    const auto next = host_->cell().next_event();
    if (!next || *next <= host_->now_ns()) break;
    vm_->run({.until_ns = *next});
  }
  // Who wished to stop what a button does has come to it.
  if (!is_at_rest()) return;
  cancelled_.store(false);
  host_->cell().begin();  // who listens is told what is there, also if nothing has moved
}

bool Session::is_at_rest() const {
  return is_under_way_ && armlet::is_at_rest(*vm_) && !host_->cell().next_event();
}

void Session::finish() {
  require_idle("finish a run");
  if (!is_at_rest())
    throw ArgumentError("A run is finished when its program and all tasks have ended.");
  armlet::finish(*vm_);
  result_ = vm_->result();
  note_progress();
  end_run();
}

void Session::end_run() {
  is_under_way_ = false;
  Cell& cell = host_->cell();
  for (const Figure& figure : host_->figures()) cell.figure(figure);
  cell.end();
  cell.set_backend(nullptr);
}

void Session::give_up() {
  if (is_under_way_ || (is_entry_ && host_ != nullptr)) end_run();
}

// The program, and when it is done the robots that still move.
Progress Session::run_slice(const Budget& budget) {
  if (vm_->result().status == Progress::kPaused) vm_->run(budget);
  return finish_slice(budget);
}

Progress Session::finish_slice(const Budget& budget) {
  rest(budget);
  result_ = vm_->result();
  if (result_.status == Progress::kDone && !come_to_rest(budget))
    result_.status = Progress::kPaused;
  note_progress();
  return result_.status;
}

Progress Session::go_on(const std::function<void()>& go) {
  if (!can_run_) {
    throw ArgumentError(
        "There is no program to run: compile() was not called, or has found mistakes.");
  }
  const OneSlice one_slice(is_running_, cancelled_, is_under_way_);
  try {
    if (!is_under_way_) is_entry_ ? begin_entry() : begin_run();
    {
      const InReach in_reach(*vm_, running_, cancelling_, cancelled_);
      go();
    }
    if (result_.status == Progress::kPaused) return Progress::kPaused;
    if (is_entry_) {
      end_entry();
    } else {
      end_run();
      apply_due_inputs();
    }
  } catch (...) {
    is_under_way_ = false;
    if (host_ != nullptr) host_->cell().set_backend(nullptr);
    if (is_entry_) replay_to(done_, true);
    throw;
  }
  return result_.status;
}

Progress Session::run(const Budget& budget) {
  if (budget.steps == 0)
    throw ArgumentError("A budget of 0 steps lets nothing happen; give at least 1 step.");
  if (budget.statements == 0)
    throw ArgumentError("A budget of 0 statements lets nothing happen; give at least 1.");
  if (budget.statements != Budget::kNoLimit && !options_.markers)
    throw ArgumentError("A run by statements needs a program that was compiled with markers.");
  return go_on([&] { run_along(budget); });
}

RunResult Session::run() {
  run(Budget{});
  return result_;
}

RunResult Session::run_test(std::size_t index) {
  if (is_entry_) throw ArgumentError("Tests are run of a whole program: compile() it.");
  if (!is_running_.load()) give_up();
  go_on([&] {
    static_cast<void>(vm_->run_test(index));
    finish_slice({});
  });
  return result_;
}

}  // namespace armlet
