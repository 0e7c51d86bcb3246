#include "armlet/stdlib/session.hpp"

#include <thread>
#include <utility>

#include "armlet/backend/fan_out.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/world_names.hpp"
#include "robot/rules.hpp"
#include "session/bind.hpp"
#include "session/editor_texts.hpp"

namespace armlet {
namespace {

// One run at a time; what somebody wished of it ends with it, however it ends.
class OneRun {
 public:
  OneRun(std::atomic<bool>& is_running, std::atomic<bool>& cancelled)
      : is_running_(is_running), cancelled_(cancelled) {
    if (is_running_.exchange(true))
      throw ArgumentError("The session runs already; use another one.");
  }
  ~OneRun() {
    cancelled_.store(false);
    is_running_.store(false);
  }
  OneRun(const OneRun&) = delete;
  OneRun& operator=(const OneRun&) = delete;

 private:
  std::atomic<bool>& is_running_;
  std::atomic<bool>& cancelled_;
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
    while (cancelling_.load() != 0) std::this_thread::yield();
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

// The cell tells the backend until this goes.
class Listening {
 public:
  Listening(Cell& cell, Backend* backend) : cell_(cell) { cell_.set_backend(backend); }
  ~Listening() { cell_.set_backend(nullptr); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  Cell& cell_;
};

// A program may end while a robot still slows down after a velocity command.
void come_to_rest(Host& host) {
  while (const auto next = host.cell().next_event()) {
    if (!host.advance_to(*next)) return;
  }
}

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

}  // namespace

Session::Session(const Engine& engine, SessionOptions options)
    : engine_(engine), options_(std::move(options)) {}
Session::~Session() = default;

std::unique_ptr<Host> Session::make_host(bool with_world) {
  HostOptions host_options;
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
  compile_options.cancelled = &cancelled_;
  Compilation compiled = engine_.compile(world.text, world.name + ".rbt", compile_options);
  for (Diagnostic& d : compiled.diagnostics) problems.push_back({std::move(d), compiled.sources});
  if (compiled.program == nullptr) return false;
  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = &host;
  vm_options.host = &host;
  Vm vm(compiled.program, std::move(vm_options));
  const InReach in_reach(vm, running_, cancelling_, cancelled_);
  RunResult result = vm.run();
  if (result.status == RunStatus::kDone) return true;
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

CompileOptions Session::compile_options(Host& host) const {
  CompileOptions out;
  out.limits = options_.parse_limits;
  out.host = &host;
  out.world = world_names_;
  out.load = options_.load;
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
  CompileOptions options = compile_options(*host);
  options.texts = editor_texts(host->planners().names(), world_names_);
  return engine_.analyse(std::move(text), std::move(name), options, before);
}

bool Session::compile(std::string text, std::string name) {
  if (is_running_.load())
    throw ArgumentError("A session cannot compile while its program runs; use another one.");
  can_run_ = false;
  problems_.clear();
  const OneCompilation one_compilation(can_run_, cancelled_);
  if (options_.world || may_name_objects(text)) describe_world();
  const std::unique_ptr<Host> host = make_host(false);
  compilation_ = engine_.compile(std::move(text), std::move(name), compile_options(*host));
  const bool has_program = compilation_.program != nullptr;
  const bool uses_world = options_.world || (has_program && compilation_.program->uses_world());
  if (uses_world && !compilation_.cancelled) problems_ = world_problems_;
  for (const Diagnostic& d : compilation_.diagnostics)
    problems_.push_back({d, compilation_.sources});
  can_run_ = has_program && (!options_.world || world_problems_.empty());
  return can_run_;
}

RunResult Session::run_with(const std::function<RunResult(Vm&)>& start) {
  if (!can_run_) {
    throw ArgumentError(
        "There is no program to run: compile() was not called, or has found mistakes.");
  }
  const OneRun one_run(is_running_, cancelled_);
  host_ = make_host(true);
  const Program& program = *compilation_.program;
  if (!options_.world && program.uses_world()) host_->want_world(program.declared_names("object"));
  FanOut fan_out(options_.backends);
  Cell& cell = host_->cell();
  const Listening listening(cell, options_.backends.empty() ? nullptr : &fan_out);
  cell.set_contact_picking(program.mentions("insertObj") && !program.mentions("grasp") &&
                           !program.mentions("release"));

  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = host_.get();
  vm_options.host = host_.get();
  vm_options.output = [this, &cell](std::string_view text) {
    cell.note(NoteKind::kOutput, text);
    return options_.output ? options_.output(text) : std::string();
  };
  vm_options.advice = options_.advice;
  Vm vm(compilation_.program, std::move(vm_options));
  const InReach in_reach(vm, running_, cancelling_, cancelled_);
  RunResult result = start(vm);
  if (result.status == RunStatus::kDone) come_to_rest(*host_);
  for (const Figure& figure : host_->figures()) cell.figure(figure);
  cell.end();
  return result;
}

RunResult Session::run() {
  return run_with([](Vm& vm) { return vm.run(); });
}
RunResult Session::run_test(std::size_t index) {
  return run_with([index](Vm& vm) { return vm.run_test(index); });
}

}  // namespace armlet
