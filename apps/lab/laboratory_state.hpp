#pragma once
// The state of a laboratory; private to its sources.

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "laboratory.hpp"
#include "pages.hpp"
#include "runs/looker.hpp"
#include "runs/taken_files.hpp"

namespace armlet::lab {

// A request to show an instant, or to step to one.
struct Look {
  int page = 0;
  Seq seq;
  int run = 0;
  LookAt place{};
  std::optional<StepHow> step;
  bool moves_cursor = false;
  bool looks_only = false;  // does not move the cursor; the answer has the values of elements too
  std::string picture{};    // request for only the picture of this element; empty: none
  bool has_stepped = false;
};

struct Laboratory::State {
  explicit State(LaboratoryOptions given);

  // ---- requests (requests.cpp)
  void handle(Page& page, const Request& request);
  void handle(Page& page, Seq seq, const Hello& hello);
  void handle(Page& page, Seq seq, const SetText& text);
  void handle(Page& page, Seq seq, const SetName& given);
  void handle(Page& page, Seq seq, const AskText& ask);
  void handle(Page& page, Seq seq, const FormatText& format);
  void handle(Page& page, Seq seq, const GoTo& go);
  void handle(Page& page, Seq seq, const AskPicture& ask);
  void handle(Page& page, Seq seq, const Step& step);
  void handle(Page& page, Seq seq, const SetBreakpoints& breakpoints);
  void handle(Page& page, Seq seq, const GiveInput& input);
  void handle(Page& page, Seq seq, const AskInverse& ask);
  void handle(Page& page, Seq seq, const ShowRun& show);
  void handle(Page& page, Seq seq, const CompareRuns& compare);
  void handle(Page& page, Seq seq, const FetchRun& fetch);
  void handle(Page& page, Seq seq, const StopRun& stop);
  void handle(Page& page, Seq seq, const AskExport& ask);
  void handle(Page& page, Seq seq, const SaveText& save);
  void handle(Page& page, Seq seq, const AskFile& ask);
  void handle(Page& page, Seq seq, const SendFile& sent);
  void handle(Page& page, Seq seq, const TakeControl& take);
  void handle(Page& page, Seq seq, const GiveControl& give);
  void refuse(Page& page, Seq seq, std::string_view reason, std::string_view message);
  void refuse(Page& page, Seq seq, const InputFault& fault);
  // Whether the page may change something; if not, it gets a refusal.
  bool has_control(Page& page, Seq seq);

  // ---- the file of the program (program_file.cpp)
  void look_at_file();

  // ---- text and runs (text_and_runs.cpp)
  // Takes the text and, if `goes` and it has no mistakes, begins its run; otherwise only checks it.
  // change  its run takes the place of the shown one if that belongs to the same change; 0: none.
  void take_text(std::string given, std::int64_t version, bool goes, int change = 0);
  // Lists the run of the text, and shows it.
  void list_run(std::unique_ptr<RunRecord> record, int change);
  [[nodiscard]] const Analysis& analysis();
  [[nodiscard]] RunRecord* find_run(int number);
  [[nodiscard]] RunRecord* shown_run() { return shown == 0 ? nullptr : find_run(shown); }
  [[nodiscard]] RunRecord& new_run(std::string label, const RunRecord* parent);
  void show(int run);
  void drop_run(int run);
  void drop_old_runs();
  void end_live_run(const std::string& why);
  // The log of a run so far; null: there is none yet.
  [[nodiscard]] const SessionLog* log_of(RunRecord& run);
  [[nodiscard]] LiveRun* live_run(const RunRecord& run) {
    return live != nullptr && live_number == run.number ? live.get() : nullptr;
  }
  bool advance_run();
  bool advance_plots();
  // Begins a run that equals `parent` until a time and then gets the input.
  void begin_fork(RunRecord& parent, std::int64_t t_ns, const GiveInput& input);
  void end_fork();
  // Must be called when the log of the run has changed, or before the run is dropped.
  void forget_look(int run);
  // Must be called when the log of the run has changed.
  void forget_looks_of(const RunRecord& run);
  void note_parting(RunRecord& run);

  // ---- looking (text_and_runs.cpp)
  void ask_to_look(Look look);
  bool advance_look();
  void begin_look();
  void end_look();
  void answer_picture(Page& page);
  // The run to show at a time; null: the page got a refusal.
  [[nodiscard]] RunRecord* run_to_see(Page& page, Seq seq, std::optional<int> number, double t);

  // ---- messages to pages (delivery.cpp)
  [[nodiscard]] std::vector<Message> take_messages(Page& page, std::size_t most_bytes);

  // Registers the session that interrupt() stops.
  class Busy {
   public:
    Busy(State& state, Session& session);
    ~Busy();
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

   private:
    State& state_;
  };

  LaboratoryOptions options;
  std::shared_ptr<TakenFiles> imported;  // shared with the loaders of sessions
  SessionOptions session_options;
  Pages pages;
  Versions versions;

  struct Text {
    std::string now;
    std::int64_t version = 0;
    int from = 0;  // the page that sent it; 0: none
    bool runs = false;
    std::vector<TextMessage> diagnostics;
    std::shared_ptr<const Analysis> analysis;
    bool is_analysis_old = true;
    Document document;  // the file
  } text;
  Session text_session;  // for analyses

  ShownFiles files;  // of the runs
  RunList runs;      // oldest first
  int last_run = 0;
  int shown = 0;         // 0: none
  std::string run_text;  // of the newest run
  struct Change {
    int number = 0;      // 0: none
    int run = 0;         // its newest run
    std::string before;  // the text of the run before it
  } change;
  int live_number = 0;
  std::unique_ptr<LiveRun> live;

  std::unique_ptr<PlotReader> plots;
  std::vector<int> runs_with_plots;  // whose plots have been read
  struct Asked {                     // the page that waits for the result of its input
    int page = 0;
    Seq seq;
    int shown_before = 0;
  };
  std::optional<Asked> fork_asked;

  Looker looker;
  struct Looks {
    std::deque<Look> waiting;
    std::optional<Look> now;
  } looks;
  struct Cursor {
    int run = 0;
    LookAt place{};
    Message instant;
    Message elements;
  };
  std::optional<Cursor> cursor;
  struct Breakpoints {
    std::vector<int> lines;
    std::vector<int> known;  // lines of the newest run that can have a breakpoint
  } breakpoints;

  std::mutex busy_mutex;
  Session* busy = nullptr;
};

}  // namespace armlet::lab
