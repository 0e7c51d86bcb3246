#pragma once
// One program with its cell: what the command, the tests and embedding tools use.

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/backend/backend.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/stdlib/host.hpp"

namespace armlet {

class FanOut;

// A program that declares objects, such as worlds/table.rbt.
struct WorldText {
  std::string name;
  std::string text;
};

struct SessionOptions {
  std::shared_ptr<const Robot> robot;  // for programs that declare none; null: none
  std::vector<NamedPlanner> planners;  // beside the built-in ones
  std::optional<WorldText> world;      // given by the user
  std::optional<WorldText>
      default_world;             // used when a program names an object and no world is given
  std::filesystem::path folder;  // below which the program may write files; empty: none
  ParseLimits parse_limits;
  bool open = false;  // see CompileOptions
  ModuleLoader load;  // files that the program imports; none without it
  RunLimits limits;
  std::vector<Backend*> backends;               // must outlive the session
  std::function<bool(std::int64_t t_ns)> pace;  // see HostOptions
  Output output;
  std::function<void(const Diagnostic&)> advice;
  std::function<void(const MoveReport&)> on_move;
};

// A message together with the texts that it points into.
struct Problem {
  Diagnostic diagnostic;
  std::shared_ptr<const SourceSet> sources;
};

// A text of a session that has run to its end.
struct Entry {
  std::shared_ptr<const Program> program;
  std::shared_ptr<const SourceSet> sources;
  std::string name;
  std::string text;
  std::int64_t begin_ns = 0;  // the virtual time at its start
  std::int64_t end_ns = 0;
  std::size_t moves = 0;  // motions that ended in it
};

class Session {
 public:
  Session(const Engine& engine, SessionOptions options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Checks a program against the robot and the world. Returns whether it can run; the messages,
  // errors and advice of the world's text included, are in problems(). If it was cancelled,
  // R0629 is the only one.
  bool compile(std::string text, std::string name);
  // What the text means, also if it has mistakes (interpreter/editor/analysis.hpp), for the robot
  // and the world of the session, and behind the entries that were submitted; the program that was
  // compiled last stays. The world is always described for it. `before` is the analysis of a text
  // that is much alike, or null.
  [[nodiscard]] std::shared_ptr<const Analysis> analyse(
      std::string text, std::string name, const std::shared_ptr<const Analysis>& before = nullptr);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  [[nodiscard]] const Program* program() const { return compilation_.program.get(); }
  // throws  ArgumentError before the first compile().
  [[nodiscard]] const SourceSet& sources() const;

  // Runs the program in a fresh cell at time 0, or goes on with a run that has paused, until it has
  // ended or the budget is used (see Vm::run). When a program is done its robots come to rest,
  // which is part of the run. A run that has ended begins again.
  //
  // throws  ArgumentError unless the last compile() has said that it can run, for a budget of no
  //         steps, or if the session runs in another thread or in the function that calls this; all
  //         stays as it was then. What backends and other functions of the host throw outside the
  //         program ends the run.
  Progress run(const Budget& budget);
  // The same without a budget.
  [[nodiscard]] RunResult run();
  // Runs one of the program's tests in a fresh cell; a run that has paused is given up.
  [[nodiscard]] RunResult run_test(std::size_t index);

  // ---- entries: texts that are submitted one after the other, as at a prompt (docs/embedding.md)
  // Checks a text in the scope of the entries before it; run() then runs it in the cell as they
  // left it. One that does not compile changes nothing. One that fails or is cancelled while it
  // runs leaves names, world, robots and clock as they were before it. compile() ends this.
  //
  // throws  ArgumentError while an entry is under way.
  bool submit(std::string text, std::string name);
  // The value of the entry that has run last; nothing: it has none, or a semicolon follows it.
  [[nodiscard]] std::optional<EntryValue> shown() const;
  // The entries that have run to their end and were not undone, oldest first.
  [[nodiscard]] std::span<const Entry> entries() const { return {log_.data(), done_}; }
  // Goes back to where the last but `count` entry had ended: in a new cell those that stay run once
  // more, without output, backends and files that are written. Gives how many were undone. Where
  // one of them fails now, since what it reads from outside has changed, those before it stay, and
  // problems() says so.
  //
  // throws  ArgumentError while an entry is under way.
  std::size_t undo(std::size_t count = 1);
  // Runs entries again that were undone last, the same way; a new entry forgets them. Gives how
  // many.
  std::size_t redo(std::size_t count = 1);
  // The names of the objects of the world that programs find.
  [[nodiscard]] std::vector<std::string> world_objects();

  // How far the run has come; kPaused before the first.
  [[nodiscard]] const RunResult& result() const { return result_; }
  // The machine of the run, or of the last one: what it left can be read and called. Null before
  // the first run, and after a compile().
  [[nodiscard]] Vm* vm() { return vm_.get(); }

  // The cell of the last run, as it was left.
  [[nodiscard]] const Host* host() const { return host_.get(); }

  // Asks the running program, or compiling, to stop; when the session does neither, the next of
  // them, so that a wish that comes a moment too soon is not lost. It is over with the end of what
  // it stopped. Safe in a signal handler and from any thread.
  void cancel() noexcept;

 private:
  [[nodiscard]] std::unique_ptr<Host> make_host(bool with_world);
  bool fill_world(Host& host, const WorldText& world, std::vector<Problem>& problems);
  void describe_world();
  bool compile_as(std::string text, std::string name, const CompileOptions& how);
  void forget_run();
  void begin_run();
  void begin_cell(const std::shared_ptr<const Program>& program);
  void take_world(const Program& program);
  void listen();
  Progress go_on(const Budget& budget, const std::function<void(Vm&)>& go);
  bool come_to_rest(const Budget& budget);
  void end_run();
  void give_up();
  // ---- entries
  void require_rest(std::string_view what) const;
  [[nodiscard]] std::shared_ptr<const Program> newest_program() const;
  void begin_program(const std::shared_ptr<const Program>& program);
  void begin_entry();
  void end_entry();
  void take_result();
  // All becomes as the first `count` entries of the log leave it: from what is there, or from the
  // start. The one way of going to another place of a session.
  void replay_to(std::size_t count, bool from_start);
  [[nodiscard]] CompileOptions compile_options(Host& host, CompileOptions how) const;

  const Engine& engine_;
  SessionOptions options_;
  Compilation compilation_;
  std::vector<Problem> problems_;
  std::unique_ptr<Host> host_;
  std::unique_ptr<FanOut> fan_out_;
  std::unique_ptr<Vm> vm_;
  RunResult result_{.status = Progress::kPaused, .error = {}, .steps = 0};
  bool is_under_way_ = false;  // a run has begun and not ended
  bool is_entry_ = false;      // what was compiled last was submitted
  bool is_silent_ = false;     // what runs has been heard before
  Entry entry_{};              // under way, or about to run
  std::vector<Entry> log_;     // entries that have run to their end
  std::size_t done_ = 0;       // of these; the others were undone
  // What the world holds, which is one for all programs, and the messages of its text.
  std::shared_ptr<const WorldNames> world_names_;
  std::vector<Problem> world_problems_;
  bool can_run_ = false;
  std::atomic<bool> is_running_{false};
  std::atomic<Vm*> running_{nullptr};
  std::atomic<int> cancelling_{0};  // calls of cancel that are under way
  std::atomic<bool> cancelled_{false};
};

// The world that the command supplies: a table with a cube and a cylinder.
[[nodiscard]] WorldText table_world();

}  // namespace armlet
