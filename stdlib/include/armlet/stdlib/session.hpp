#pragma once
// Programs with their cell: what the command, the tests and embedding tools use.

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

// A message together with the texts that it points into.
struct Problem {
  Diagnostic diagnostic;
  std::shared_ptr<const SourceSet> sources;
};

// An entry of a session.
struct Entry {
  LoggedEntry logged;
  std::shared_ptr<const Program> program;  // null: a call
  std::size_t moves = 0;                   // motions that ended in it
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
  // errors and advice of the world's text included, are in problems(). If it was cancelled,
  // R0629 is the only one. What was there before is forgotten.
  bool compile(std::string text, std::string name);
  // The same with the program that another session has compiled, which is not compiled again: all
  // share it, and each has variables, a cell and a log of its own.
  //
  // throws  ArgumentError if the other has no whole program that can run, or if its engine, robot,
  //         planners, world or the options that a program is compiled for are others; and while one
  //         of the two runs. All stays as it was.
  void share(const Session& other);
  // What the text means, also if it has mistakes (interpreter/editor/analysis.hpp), for the robot
  // and the world of the session, and behind the entries that were submitted; the program that was
  // compiled last stays. The world is always described for it. `before` is the analysis of a text
  // that is much alike, or null.
  [[nodiscard]] std::shared_ptr<const Analysis> analyse(
      std::string text, std::string name, const std::shared_ptr<const Analysis>& before = nullptr);
  [[nodiscard]] const std::vector<Problem>& problems() const { return problems_; }
  // What was compiled last, or has begun since.
  [[nodiscard]] const Program* program() const { return compilation_.program.get(); }
  // throws  ArgumentError before the first compile().
  [[nodiscard]] const SourceSet& sources() const;

  // Runs what comes next, or goes on with what has paused, until it has ended or the budget is used
  // (see Vm::run). What comes next is the text that was compiled or submitted; otherwise the next
  // entry that is known from a log or from before the session went back; otherwise the program once
  // more, in a fresh cell at time 0. Robots that still move come to rest then.
  //
  // throws  ArgumentError if there is nothing to run, for a budget of no steps, or if the session
  //         runs in another thread or in the function that calls this; all stays as it was then.
  //         An exception of a backend or of another function of the host ends the run; all backends
  //         then hear that it has ended. One that is thrown at the end of a run does not change its
  //         result.
  Progress run(const Budget& budget);
  // The same without a budget.
  [[nodiscard]] RunResult run();
  // Runs one of the program's tests in a fresh cell; a run that has paused is given up.
  [[nodiscard]] RunResult run_test(std::size_t index);

  // ---- entries, one after the other, as at a prompt (docs/embedding.md)
  // Checks a text in the scope of the entries before it; run() then runs it in the cell as they
  // left it. One that does not compile changes nothing. One that fails or is cancelled while it
  // runs leaves names, world, robots and clock as they were before it. compile() ends this.
  //
  // throws  ArgumentError while an entry is under way.
  bool submit(std::string text, std::string name);
  // Begins a function of the program, which run() then runs as it runs a program: in slices, with
  // motion. What it gives is dropped; one that fails or is cancelled leaves what it did.
  //
  // throws  ArgumentError while an entry is under way, before the first has ended, for a function
  //         that does not exist and for arguments of other types; all stays as it was then.
  void begin_call(std::string_view name, const std::vector<Value>& arguments);
  // The value of the entry that has run last; nothing: it has none, or a semicolon follows it.
  [[nodiscard]] std::optional<EntryValue> shown() const;
  // The entries that have run to their end and were not undone, oldest first.
  [[nodiscard]] std::span<const Entry> entries() const;
  // How many are known beyond these: the one under way, and those that run() or redo() would run
  // again. A new one takes their place.
  [[nodiscard]] std::size_t to_come() const;
  // Goes back to where the last but `count` entry had ended, as go_to goes. Gives how many were
  // undone; none if somebody cancels.
  //
  // throws  ArgumentError while an entry is under way.
  std::size_t undo(std::size_t count = 1);
  // Goes forth to where `count` more of the entries to come had ended, the same way.
  std::size_t redo(std::size_t count = 1);
  // The names of the objects of the world that programs find.
  [[nodiscard]] std::vector<std::string> world_objects();

  // ---- what the host does to a run (inputs.cpp). It is kept in the log, which is not so for what
  // is done to vm() and its functions directly. All of it waits for the run to pause or end: it
  // throws ArgumentError while the session runs, and for what does not exist or has another type.

  // A signal, also before the first run: then it is there from the start.
  void set_signal(std::string_view name, SignalValue value);
  void set(std::string_view name, const Value& value);
  // Calls a function of the program, without time. An error (vm()->error_text()) if it failed.
  Result<Value> call(std::string_view name, const std::vector<Value>& arguments);

  // ---- a run once more
  // All entries, those to come included, with the options and what came from outside.
  //
  // throws  ArgumentError before the first compile(), and while the session runs.
  [[nodiscard]] SessionLog log() const;
  // Compiles the entries of a log; each run() then runs the next as it was logged: files are taken
  // from the log and none are written. Where the log ends the outside is asked again.
  //
  // throws  ArgumentError if the robot, the world, the planners or the limits of the session are
  //         not those of the log, if that begins with a call, and while the session runs; all stays
  //         as it was.
  bool replay(const SessionLog& log);
  // Goes to a virtual time of the run, after all that happened then: the entries are run again from
  // the first, unheard. What follows is then as it was before, event by event with the numbers that
  // they had, until the host does something else, cancels or submits: then the run is another one,
  // and what it was is the last of runs(). A cancel() that comes meanwhile gives up the going.
  //
  // entry    by its number from 0: several may lie at one time. Without it, the last one that does.
  // returns  whether it is there. Otherwise, and after an exception, all stays as it was.
  // throws   ArgumentError for a time that the run, or the entry, has not come to, and while the
  //          session runs.
  bool go_to(std::int64_t t_ns);
  bool go_to(std::size_t entry, std::int64_t t_ns);
  // The same with another text in the place of the entry, of which those behind it are no more: it
  // runs from its start, with what the host did before that time but for its wishes to stop, and
  // its events are compared with those of the run, which is the last of runs() then (edit.cpp).
  //
  // throws  ArgumentError as go_to, and for a call.
  TextChange change(std::string text, std::int64_t t_ns);
  TextChange change(std::size_t entry, std::string text, std::int64_t t_ns);
  // ---- by statements, in programs with markers (step.cpp); Budget::statements does the same
  // Until another move has ended, or a breakpoint or the end has come.
  Progress run_move();
  // To where the statement that began last had not begun, as go_to goes.
  //
  // throws  ArgumentError before the first statement, and as go_to.
  bool step_back();
  // Where runs of this session pause from now on (interpreter/host/stepping.hpp).
  //
  // returns  the lines that were taken.
  // throws   ArgumentError without a program with markers, and while the session runs.
  std::vector<SourceLine> set_breakpoints(std::vector<SourceLine> lines);

  // ---- laboratories (SessionOptions::laboratory)
  // Whether the program has ended, and nothing happens before the next input.
  [[nodiscard]] bool is_at_rest() const;
  // Ends a run that is at rest, which is then done. throws  ArgumentError if it is not.
  void finish();

  // The runs that were left for another one by going back or by another text, oldest first: copies
  // of their logs. Of more than kMostRuns, or of several with more than kMostRunBytes together, the
  // oldest give way, and the numbers of the others count from 0 again.
  [[nodiscard]] const std::vector<SessionLog>& runs() const { return runs_; }
  // Goes to where one of these had come, as go_to goes; the present one takes its place among them.
  //
  // throws  ArgumentError for a run that does not exist, and while the session runs.
  bool take_up(std::size_t run);

  // How far the last entry that has begun has come; kPaused before the first.
  [[nodiscard]] const RunResult& result() const;
  // The machine of the run: what it left can be read and called. Null before the first run, and
  // after a compile().
  [[nodiscard]] Vm* vm();
  // The cell of the run, as it is; null likewise.
  [[nodiscard]] const Host* host() const;

  // Asks the running program, or compiling, to stop; when the session does neither, the next of
  // them, so that a wish that comes a moment too soon is not lost. It is over with the end of what
  // it stopped. Safe in a signal handler and from any thread.
  void cancel() noexcept;

 private:
  friend class LabControls;
  struct Run;
  class OneSlice;
  class InReach;
  struct Compiled;
  // To stop: whether somebody has it, and whether no machine has heard of it yet. Each hears once:
  // what the program does then may take several slices.
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
  // Runs to each input of the entry that is repeated, and beyond, until the budget is used.
  void run_along(const Budget& budget);
  void run_to(const Instant& at, const std::function<Budget()>& left);
  void note_progress();
  // ---- once more (replay.cpp)
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
  Compilation compilation_;  // what was compiled last, or has begun since
  std::vector<Problem> problems_;
  std::unique_ptr<Run> run_;
  std::unique_ptr<Entry> submitted_;  // runs next
  std::vector<Input> early_inputs_;   // for the next run, from its start
  std::vector<SessionLog> runs_;
  std::vector<SourceLine> breakpoints_;
  bool is_silent_ = false;        // what runs has been heard before
  Backend* confidant_ = nullptr;  // who hears of it nevertheless
  // What the world holds, which is one for all programs, and the messages of its text.
  std::shared_ptr<const WorldNames> world_names_;
  std::vector<Problem> world_problems_;
  std::vector<Reply> world_replies_;  // files that the world of a log named, by its first entry
  std::atomic<bool> is_running_{false};
  std::atomic<Vm*> running_{nullptr};
  std::atomic<int> cancelling_{0};  // calls of cancel that are under way
  Wish wish_;
};

// The world that the command supplies: a table with a cube and a cylinder.
[[nodiscard]] WorldText table_world();

}  // namespace armlet
