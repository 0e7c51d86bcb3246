#pragma once
// Programs with their cell, for the command, the tests and embedding tools.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/host/stepping.hpp"
#include "armlet/stdlib/session_log.hpp"
#include "armlet/stdlib/session_options.hpp"
#include "armlet/stdlib/text_change.hpp"

namespace armlet {

class Journal;
class LabControls;

// A message together with the source texts that its marks refer to.
struct Problem {
  Diagnostic diagnostic;
  std::shared_ptr<const SourceSet> sources;
};

// An entry of a session.
struct Entry {
  LoggedEntry logged;
  std::shared_ptr<const Program> program;  // null: a call
  std::size_t moves = 0;                   // motions that ended in this entry
};

class Session {
 public:
  static constexpr std::size_t kMostRuns = 64;
  static constexpr std::size_t kMostRunBytes = 16'000'000;

  Session(const Engine& engine, SessionOptions options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Checks a program against the robot and the world. Returns whether it can run; the messages,
  // including errors and advice of the world's text, are in problems(). If the compilation was
  // cancelled, R0629 is the only one. Discards the program and entries that were there before.
  bool compile(std::string text, std::string name);
  // Takes over a program that another session has compiled, without compiling it again: the
  // sessions share the program, and each has its own variables, cell and log.
  //
  // throws  ArgumentError if the other session has no whole program that can run, or if its engine,
  //         robot, planners, world or compile options are different; and while one of the two runs.
  //         Nothing changes then.
  void share(const Session& other);
  // Analysis of a text for an editor, also if it has mistakes (interpreter/editor/analysis.hpp),
  // for the robot and the world of the session, and after the entries that were submitted; the
  // program that was compiled last stays. The world is always described for it. `before` is the
  // analysis of a similar text, or null.
  [[nodiscard]] std::shared_ptr<const Analysis> analyse(
      std::string text, std::string name, const std::shared_ptr<const Analysis>& before = nullptr);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  // The program that was compiled last, or whose compilation began last.
  [[nodiscard]] const Program* program() const { return compilation_.program.get(); }
  // throws  ArgumentError before the first compile().
  [[nodiscard]] const SourceSet& sources() const;

  // Runs the next text, or continues a paused run, until it has ended or the budget is used (see
  // Vm::run). The next text is the one that was compiled or submitted; otherwise the next entry
  // that is known from a log or from before the session went back; otherwise the program again, in
  // a fresh cell at time 0. Robots that still move come to rest then.
  //
  // throws  ArgumentError if there is nothing to run, for a budget of no steps, or if the session
  //         runs in another thread or in the function that calls this; nothing changes then. An
  //         exception of a backend or of another function of the host ends the run; all backends
  //         then receive its end. An exception at the end of a run does not change the result of
  //         the run.
  Progress run(const Budget& budget);
  // Runs the next text, or continues a paused run, without a budget.
  [[nodiscard]] RunResult run();
  // Runs one of the program's tests in a fresh cell; a paused run is discarded.
  [[nodiscard]] RunResult run_test(std::size_t index);

  // ---- entries, one after the other, as at a prompt (docs/embedding.md)
  // Checks a text in the scope of the entries before it; run() then runs it in the cell as they
  // left it. A text that does not compile changes nothing. If it fails or is cancelled while it
  // runs, names, world, robots and clock are restored to the state before it. compile() ends this
  // mode.
  //
  // throws  ArgumentError while an entry is running or paused.
  bool submit(std::string text, std::string name);
  // Begins a function of the program; run() then runs it as it runs a program: in slices, with
  // motion. Its result is discarded; the effects of a call that fails or is cancelled stay.
  //
  // throws  ArgumentError while an entry is running or paused, before the first has ended, for a
  //         function that does not exist and for arguments of other types; nothing changes then.
  void begin_call(std::string_view name, const std::vector<Value>& arguments);
  // The value of the last entry that has run; nullopt: it has none, or ends with a semicolon.
  [[nodiscard]] std::optional<EntryValue> shown() const;
  // The entries that have run to their end and were not undone, oldest first.
  [[nodiscard]] std::span<const Entry> entries() const;
  // The number of entries known beyond these: the running one, and those that run() or redo() would
  // run again. A new entry replaces them.
  [[nodiscard]] std::size_t to_come() const;
  // Undoes the last `count` entries: goes back to the end of the entry before them, as go_to does.
  // Returns the number of entries undone; 0 if it is cancelled.
  //
  // throws  ArgumentError while an entry is running or paused.
  std::size_t undo(std::size_t count = 1);
  // Redoes `count` of the entries that were undone, in the same manner.
  std::size_t redo(std::size_t count = 1);
  // The names of the objects of the world that programs can use.
  [[nodiscard]] std::vector<std::string> world_objects();

  // ---- inputs of the host to a run (inputs.cpp). They are recorded in the log; direct changes to
  // vm() and calls of its functions are not. All of them need a run that has paused or ended: else,
  // and for names that do not exist or have another type, they throw ArgumentError.

  // Sets a signal; before the first run: from the start of the run.
  void set_signal(std::string_view name, SignalValue value);
  void set(std::string_view name, const Value& value);
  // Calls a function of the program; no time passes. An error (vm()->error_text()) if it failed.
  Result<Value> call(std::string_view name, const std::vector<Value>& arguments);

  // ---- replay
  // All entries, including those to come, with the options and all inputs from outside.
  //
  // throws  ArgumentError before the first compile(), and while the session runs.
  [[nodiscard]] SessionLog log() const;
  // Compiles the entries of a log; each run() then runs the next one as it was logged: files are
  // read from the log and none are written. After the end of the log the session asks the host
  // again.
  //
  // throws  ArgumentError if the robot, the world, the planners or the limits of the session differ
  //         from those of the log, if the log begins with a call, and while the session runs;
  //         nothing changes then.
  bool replay(const SessionLog& log);
  // Goes to a virtual time of the run, after all events of that time: the entries are run again
  // silently from the first. The run then continues as it did before, event by event with the same
  // numbers, until the host makes another input, cancels or submits: from then on it is another
  // run, and the earlier one is the last of runs(). A cancel() in the meantime ends go_to.
  //
  // entry    index of the entry, from 0: several entries may contain the same time. Without it: the
  //          last that does.
  // returns  whether that time was reached. If not, and after an exception, nothing changes.
  // throws   ArgumentError for a time that the run, or the entry, has not reached, and while the
  //          session runs.
  bool go_to(std::int64_t t_ns);
  bool go_to(std::size_t entry, std::int64_t t_ns);
  // Goes to a virtual time like go_to, with another text instead of the entry; the entries after it
  // are dropped. The new text runs from its start, with the inputs of the host before that time
  // except stop requests, and its events are compared with those of the earlier run, which becomes
  // the last of runs() (edit.cpp).
  //
  // throws  ArgumentError as go_to, and for a call.
  TextChange change(std::string text, std::int64_t t_ns);
  TextChange change(std::size_t entry, std::string text, std::int64_t t_ns);
  // ---- by statements, in programs with markers (step.cpp); Budget::statements does the same
  // Runs until another move has ended, or a breakpoint or the end is reached.
  Progress run_move();
  // Goes back to just before the statement that began last, as go_to does.
  //
  // throws  ArgumentError before the first statement, and as go_to.
  bool step_back();
  // Sets the lines at which runs of this session pause from now on (interpreter/host/stepping.hpp).
  //
  // returns  the lines with breakpoints.
  // throws   ArgumentError without a program with markers, and while the session runs.
  std::vector<SourceLine> set_breakpoints(std::vector<SourceLine> lines);

  // ---- laboratories (SessionOptions::laboratory)
  // Whether the program has ended and nothing happens before the next input.
  [[nodiscard]] bool is_at_rest() const;
  // Ends a run that is at rest. throws  ArgumentError if it is not.
  void finish();

  // The runs that were left by going back or by another text, oldest first: copies of their logs.
  // If there are more than kMostRuns, or several with more than kMostRunBytes together, the oldest
  // are dropped, and the others are numbered from 0 again.
  [[nodiscard]] const std::vector<SessionLog>& runs() const { return runs_; }
  // Goes to the end of one of these runs, as go_to does; the present run replaces it in runs().
  //
  // throws  ArgumentError for a run that does not exist, and while the session runs.
  bool take_up(std::size_t run);

  // The state of the last entry that has begun; kPaused before the first.
  [[nodiscard]] const RunResult& result() const;
  // The virtual machine of the run: its variables can be read and its functions called. Null before
  // the first run, and after a compile().
  [[nodiscard]] Vm* vm();
  // The cell of the run; null in the same cases.
  [[nodiscard]] const Host* host() const;

  // A stop request to the running program or compilation. If the session is idle, the next run or
  // compilation is stopped, so that a request that comes a moment too early is not lost. It is used
  // up when that run has ended. Safe in a signal handler and from any thread.
  void cancel() noexcept;

 private:
  friend class LabControls;
  struct Run;
  class OneSlice;
  class InReach;
  struct Compiled;
  // A stop request: whether there is one, and whether no virtual machine has received it yet. It is
  // delivered once, since the program may take several slices to react.
  struct Wish {
    std::atomic<bool> is_there{false};
    std::atomic<bool> is_new{false};
    void forget() {
      is_there.store(false);
      is_new.store(false);
    }
  };
  class OneCompilation;

  // ---- texts (session.cpp)
  [[nodiscard]] std::unique_ptr<Host> make_host(Journal* journal);
  bool fill_world(Host& host, const WorldText& world, std::vector<Problem>& problems);
  void describe_world();
  [[nodiscard]] CompileOptions compile_options(Host& host, CompileOptions how) const;
  [[nodiscard]] Compiled compile_text(const LoggedEntry& entry,
                                      std::shared_ptr<const Program> after, bool is_logged);
  bool compile_entry(LoggedEntry entry);
  [[nodiscard]] std::shared_ptr<const Program> newest_program() const;
  // ---- running (running.cpp)
  void require_idle(std::string_view what) const;
  void require_rest(std::string_view what) const;
  void require_run(std::string_view what) const;
  void break_off();
  void advance(const Budget& budget);
  void begin_next();
  void begin_new(Entry entry);
  void begin_entry();
  void begin_cell(Entry& entry);
  void take_world(const Program& program);
  Progress run_slice(const Budget& budget);
  Progress finish_slice(const Budget& budget);
  bool come_to_rest(const Budget& budget);
  void rest(const Budget& budget);
  void end_entry();
  void take_back_entry();
  void tell_end();
  void tell_undone(const Run& former, const Host* host, std::optional<std::uint64_t> from = {});
  void give_up();
  // ---- inputs (inputs.cpp)
  [[nodiscard]] Instant instant() const;
  void keep(Input input);
  void apply(const Input& input);
  std::optional<Error> act(const Action& action);
  void apply_due_inputs();
  // Runs to each input of the entry that is replayed, and beyond, until the budget is used.
  void run_along(const Budget& budget);
  void run_to(const Instant& at, const std::function<Budget()>& left);
  void note_progress();
  // ---- replay (replay.cpp)
  [[nodiscard]] SessionLog log_of(const std::vector<Entry>& entries) const;
  [[nodiscard]] std::vector<Entry> compile_log(const SessionLog& log);
  [[nodiscard]] std::size_t entry_at(std::int64_t t_ns) const;
  void require_time(std::size_t entry, std::int64_t t_ns) const;
  bool run_through(std::size_t count);
  bool run_again_to(std::size_t entry, std::int64_t t_ns);
  bool take_again(std::vector<Entry> entries, const std::function<bool()>& go,
                  std::optional<std::uint64_t> undone_from = {});
  bool go_to_rest(std::size_t count);
  [[nodiscard]] std::vector<Entry> with_text(const std::vector<Entry>& known, std::size_t entry,
                                             std::string text, std::int64_t t_ns);
  void keep_run(SessionLog run);

  const Engine& engine_;
  SessionOptions options_;
  Compilation compilation_;  // compiled last, or being compiled
  std::vector<Problem> problems_;
  std::unique_ptr<Run> run_;
  std::unique_ptr<Entry> submitted_;  // the entry to run next
  std::vector<Input> early_inputs_;   // for the next run, from its start
  std::vector<SessionLog> runs_;
  std::vector<SourceLine> breakpoints_;
  bool is_silent_ = false;        // its events were already reported
  Backend* confidant_ = nullptr;  // receives its events all the same
  // The names in the world, the same for all programs, and the messages of the text of the world.
  std::shared_ptr<const WorldNames> world_names_;
  std::vector<Problem> world_problems_;
  std::vector<Reply> world_replies_;  // files of a log's world; logged with its first entry
  std::atomic<bool> is_running_{false};
  std::atomic<Vm*> running_{nullptr};
  std::atomic<int> cancelling_{0};  // calls of cancel that are running
  Wish wish_;
};

// The default world of the command: a table with a cube and a cylinder.
[[nodiscard]] WorldText table_world();

}  // namespace armlet
