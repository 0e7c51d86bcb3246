#include "armlet/stdlib/session.hpp"

#include <algorithm>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/world_names.hpp"
#include "host/journal.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "session/editor_texts.hpp"
#include "session/run.hpp"
#include "values/bind.hpp"

namespace armlet {
namespace {

// While it exists, files are those of a world; afterwards those of the program again.
class FillingWorld {
 public:
  FillingWorld(Host& host, const WorldText& world) : host_(host) { host.begin_world(world.folder); }
  ~FillingWorld() { host_.end_world(); }
  FillingWorld(const FillingWorld&) = delete;
  FillingWorld& operator=(const FillingWorld&) = delete;

 private:
  Host& host_;
};

// Whether names of objects may be checked: the text, or a file that it imports, calls one of the
// functions that take names.
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

// Whether a text compiles to the same program with both options.
bool are_checked_alike(const SessionOptions& a, const SessionOptions& b) {
  return a.robot == b.robot && a.world == b.world && a.default_world == b.default_world &&
         a.open == b.open && a.markers == b.markers && a.laboratory == b.laboratory &&
         std::ranges::equal(a.planners, b.planners, {}, &NamedPlanner::name, &NamedPlanner::name);
}

}  // namespace

Session::Session(const Engine& engine, SessionOptions options)
    : engine_(engine), options_(std::move(options)), run_(std::make_unique<Run>()) {}
Session::~Session() {
  try {
    give_up();
  } catch (...) {  // of a backend; it cannot be reported
    run_->is_under_way = false;
  }
}

std::unique_ptr<Host> Session::make_host(Journal* journal) {
  HostOptions host_options;
  host_options.journal = journal;
  host_options.robot = options_.robot;
  host_options.planners = options_.planners;
  host_options.on_move = options_.on_move;
  host_options.pace = options_.pace;
  host_options.folder = options_.folder;
  host_options.convert_mesh = options_.meshes.convert;
  host_options.packages = options_.meshes.packages;
  host_options.frames = options_.frames;
  host_options.is_cancelled = [this] { return wish_.is_there.load(); };
  if (options_.default_world) {
    host_options.default_world = [this](Host& host, const std::vector<std::string>&) {
      fill_world(host, *options_.default_world, problems_);
    };
  }
  auto host = std::make_unique<Host>(std::move(host_options));
  host->cell().cameras().keep_pictures(options_.pictures);
  return host;
}

// A world is a program that declares objects; it runs in the cell before time begins.
bool Session::fill_world(Host& host, const WorldText& world, std::vector<Problem>& problems) {
  host.set_world_name(world.name);
  CompileOptions compile_options;
  compile_options.limits = options_.parse_limits;
  compile_options.host = &host;
  compile_options.open = false;
  compile_options.cancelled = &wish_.is_there;
  if (options_.world) {  // given by the user, not the default one
    compile_options.only_blocks = {"object", "frame"};
    compile_options.refuse = [](Span statement) {
      return make_diagnostic(bind::row("R0670"), statement);
    };
  }
  const FillingWorld filling(host, world);
  Compilation compiled = engine_.compile(world.text, world.name + ".rbt", compile_options);
  for (Diagnostic& d : compiled.diagnostics) problems.push_back({std::move(d), compiled.sources});
  if (compiled.program == nullptr) return false;
  VmOptions vm_options;
  vm_options.limits = options_.limits;
  vm_options.timeline = &host;
  vm_options.host = &host;
  Vm vm(compiled.program, std::move(vm_options));
  const InReach in_reach(*this, vm);
  RunResult result = vm.run();
  if (result.status == Progress::kDone) return true;
  if (result.error) problems.push_back({*std::move(result.error), compiled.sources});
  return false;
}

// Runs the world once, in a cell of its own; the checks know only the names that it then holds.
void Session::describe_world() {
  const std::optional<WorldText>& text = options_.world ? options_.world : options_.default_world;
  if (world_names_ != nullptr || !text) return;
  world_problems_.clear();
  // The files that the world reads are the first replies of a run.
  LoggedEntry known;
  known.replies = world_replies_;
  Journal journal;
  journal.begin(known, false);
  const std::unique_ptr<Host> host = make_host(&journal);
  fill_world(*host, *text, world_problems_);
  auto names = std::make_shared<WorldNames>();
  names->world = text->name;
  names->things = host->cell().world().names();
  names->maker = "object";
  if (!wish_.is_there.load()) world_names_ = std::move(names);
}

const SourceSet& Session::sources() const {
  if (compilation_.sources == nullptr)
    throw ArgumentError("A session has no sources before its first compile().");
  return *compilation_.sources;
}

void Session::cancel() noexcept {
  wish_.is_there.store(true);
  cancelling_.fetch_add(1);
  wish_.is_new.store(true);
  Vm* vm = running_.load();
  if (vm != nullptr && wish_.is_new.exchange(false)) vm->cancel();
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
  out.cancelled = &wish_.is_there;
  return out;
}

std::shared_ptr<const Analysis> Session::analyse(std::string text, std::string name,
                                                 const std::shared_ptr<const Analysis>& before) {
  if (is_running_.load())
    throw ArgumentError("A session cannot analyse while its program runs; use another one.");
  const OneCompilation one_compilation(wish_);
  describe_world();
  const std::unique_ptr<Host> host = make_host(nullptr);
  CompileOptions how;
  how.after = newest_program();
  how.is_entry = how.after != nullptr;
  CompileOptions options = compile_options(*host, std::move(how));
  options.texts = editor_texts(host->planners().names(), world_names_);
  return engine_.analyse(std::move(text), std::move(name), options, before);
}

static ModuleLoader remembering(ModuleLoader load, std::vector<LoggedImport>& imports) {
  return [load = std::move(load), &imports](const std::string& path, const std::string& from) {
    return imports.emplace_back(LoggedImport{path, from, load(path, from)}).given;
  };
}

static ModuleLoader from_log(const std::vector<LoggedImport>& logged) {
  return [&logged](const std::string& path, const std::string& from) {
    for (const LoggedImport& each : logged)
      if (each.path == path && each.from == from) return each.given;
    return ImportedText{};
  };
}

Session::Compiled Session::compile_text(const LoggedEntry& entry,
                                        std::shared_ptr<const Program> after, bool is_logged) {
  Compiled made;
  OneCompilation one_compilation(wish_);
  if (options_.world || may_name_objects(entry.text)) describe_world();
  const std::unique_ptr<Host> host = make_host(nullptr);
  CompileOptions how;
  how.is_entry = entry.kind == EntryKind::kEntry;
  how.after = std::move(after);
  CompileOptions options = compile_options(*host, std::move(how));
  const ModuleLoader load = is_logged ? from_log(entry.imports) : options_.load;
  const auto compile = [&] {
    made.imports.clear();
    if (load) options.load = remembering(load, made.imports);
    made.compilation = engine_.compile(entry.text, entry.name, options);
  };
  compile();
  // An unknown name may be an object of the world; only now the world is described.
  const auto& found = made.compilation.diagnostics;
  if (world_names_ == nullptr &&
      std::ranges::find(found, "E0201", &Diagnostic::code) != found.end()) {
    describe_world();
    options.world = world_names_;
    if (world_names_ != nullptr) compile();
  }
  const bool has_program = made.compilation.program != nullptr;
  const bool uses_world = options_.world || (has_program && made.compilation.program->uses_world());
  if (uses_world && !made.compilation.cancelled) made.problems = world_problems_;
  for (const Diagnostic& d : made.compilation.diagnostics)
    made.problems.push_back({d, made.compilation.sources});
  made.can_run = has_program && (!options_.world || world_problems_.empty());
  if (made.can_run) one_compilation.makes_program();
  return made;
}

bool Session::compile_entry(LoggedEntry entry) {
  const bool is_program = entry.kind == EntryKind::kProgram;
  Compiled made = compile_text(entry, is_program ? nullptr : newest_program(), false);
  compilation_ = std::move(made.compilation);
  problems_ = std::move(made.problems);
  entry.imports = std::move(made.imports);
  submitted_.reset();
  if (made.can_run)
    submitted_ = std::make_unique<Entry>(Entry{std::move(entry), compilation_.program});
  return made.can_run;
}

bool Session::compile(std::string text, std::string name) {
  require_idle("compile");
  give_up();
  run_ = std::make_unique<Run>();
  return compile_entry(
      {.kind = EntryKind::kProgram, .name = std::move(name), .text = std::move(text)});
}

void Session::share(const Session& other) {
  require_idle("take a program");
  other.require_idle("give its program");
  const Entry* given = other.submitted_.get();
  if (given == nullptr && !other.run_->entries.empty()) given = &other.run_->entries.front();
  if (given == nullptr || given->logged.kind != EntryKind::kProgram)
    throw ArgumentError("There is no program to share: compile() one in the other session first.");
  if (&engine_ != &other.engine_ || !are_checked_alike(options_, other.options_)) {
    throw ArgumentError(
        "This program was compiled for another session: they share one only with the same engine, "
        "robot, planners and world, and the same options of compiling.");
  }
  const LoggedEntry& logged = given->logged;
  Entry entry{
      {.kind = logged.kind, .name = logged.name, .text = logged.text, .imports = logged.imports},
      given->program};
  give_up();
  run_ = std::make_unique<Run>();
  world_names_ = other.world_names_;
  world_problems_ = other.world_problems_;
  problems_ = other.problems_;
  compilation_ = {.program = entry.program, .sources = {entry.program, &entry.program->sources()}};
  submitted_ = std::make_unique<Entry>(std::move(entry));
}

std::vector<std::string> Session::world_objects() {
  describe_world();
  return world_names_ != nullptr ? world_names_->things : std::vector<std::string>();
}

}  // namespace armlet
