// armlet run: checks a program, runs it, shows each move and a summary.

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>
#include <utility>
#include <vector>

#include "armlet/backend/run_hash.hpp"
#include "armlet/backend/run_marks.hpp"
#include "armlet/backend/trace_format.hpp"
#include "armlet/core/files.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/plot/svg.hpp"
#include "armlet/stdlib/install.hpp"
#include "cameras/recorded_frames.hpp"
#include "console/console.hpp"
#include "console/output_file.hpp"
#include "console/setup.hpp"
#include "run/inputs.hpp"
#include "run/record.hpp"
#include "run/run_report.hpp"
#include "storyboard/storyboard.hpp"
#include "video/video.hpp"

namespace armlet::cli {
namespace {

// The backend of a trace and its file, which replaces the old file when the run has ended, also if
// it failed.
class Trace {
 public:
  // Returns the exit status, after a message if there is no such trace format.
  int choose(const std::string& path) {
    if (path.empty()) return kDone;
    const TraceFormat* format = trace_format_of(path);
    if (format == nullptr) {
      progress(fmt::format("armlet: a trace is a {} file, not \"{}\"", trace_endings(), path));
      return kUsage;
    }
    file_.set_path(path);
    backend_ = format->make(out_);
    return kDone;
  }

  [[nodiscard]] Backend* backend() const { return backend_.get(); }

  // Called once the program is known to run. `texts` are its source files.
  int open(const std::vector<std::string>& texts) {
    if (backend_ == nullptr) return kDone;
    if (const int exit = file_.open(texts); exit != kDone) return exit;
    stream_.emplace(file_.file());
    out_.rdbuf(stream_->rdbuf());
    return kDone;
  }

  // Gives the file its name; a message only if it was not written completely.
  int finish() {
    if (backend_ == nullptr) return kDone;
    if (const int exit = file_.finish(); exit != kDone) return exit;
    if (backend_->error().empty()) return kDone;
    progress(fmt::format("armlet: {}", backend_->error()));
    return kFailed;
  }

 private:
  std::ostream out_{nullptr};  // writes to the file, once that is open
  std::unique_ptr<Backend> backend_;
  OutputFile file_{"trace"};
  std::optional<FileStream> stream_;
};

// The output files of a run.
class Outputs {
 public:
  // Returns the exit status, after a message if a name is refused.
  int choose(const RunOptions& options, SessionOptions& session) {
    if (const int exit = trace_.choose(options.trace); exit != kDone) return exit;
    if (const int exit = record_.choose(options.record); exit != kDone) return exit;
    if (const int exit = storyboard_.choose(options.storyboard); exit != kDone) return exit;
    if (const int exit = video_.choose(options.video); exit != kDone) return exit;
    frames_.choose(options.frames, trace_.backend());
    Backend* traced = frames_.backend() != nullptr ? frames_.backend() : trace_.backend();
    if (traced != nullptr) session.backends.push_back(traced);
    if (record_.is_wanted()) session.backends.push_back(&marks_);
    return kDone;
  }

  // Called once the program is known to run. `texts` are its source files.
  int open(const std::vector<std::string>& texts) {
    if (const int exit = trace_.open(texts); exit != kDone) return exit;
    if (const int exit = record_.open(texts); exit != kDone) return exit;
    if (const int exit = storyboard_.open(texts); exit != kDone) return exit;
    if (const int exit = video_.open(texts); exit != kDone) return exit;
    return frames_.open();
  }

  [[nodiscard]] bool wants_moves() const { return storyboard_.is_wanted(); }
  void take(const FinishedMove& move, const Cell& cell) { storyboard_.take(move, cell); }
  [[nodiscard]] bool wants_time() const { return video_.is_wanted(); }
  void look(const Cell& cell) { video_.look(cell); }  // before time goes on

  // Gives the files their names. Returns whether all of them were written.
  bool finish(const Session& session) {
    const bool has_frames = frames_.finish() == kDone;
    is_traced_ = trace_.finish() == kDone;
    SessionLog log = session.log();
    log.marks = marks_.marks();
    const bool recorded = record_.finish(log) == kDone;
    return storyboard_.finish() == kDone && recorded && is_traced_ && has_frames;
  }
  [[nodiscard]] bool is_traced() const { return is_traced_; }  // valid after finish
  // Draws and writes the video, which takes longest and is therefore done last. Returns whether it
  // was written, if one is wanted.
  bool film(const Session& session, bool talks) {
    return video_.finish(session.host()->cell(), talks) == kDone;
  }

 private:
  Trace trace_;
  FrameFolder frames_;
  Record record_;
  RunMarks marks_;
  Storyboard storyboard_;
  Video video_;
  bool is_traced_ = false;
};

// The source files of a program.
std::vector<std::string> texts_of(const RunOptions& options, const SourceSet& sources) {
  std::vector<std::string> texts{options.file, options.program.world};
  for (std::uint32_t i = 0; i < sources.size(); ++i) texts.push_back(sources[i].name());
  return texts;
}

using Pacing = std::function<bool(std::int64_t)>;

// Ctrl-C sends one stop request.
Pacing full_speed() {
  return
      [told = false](std::int64_t) mutable { return !interrupted() || std::exchange(told, true); };
}

// Sleeps until wall-clock time has reached virtual time, in short intervals so that Ctrl-C has
// effect. Ctrl-C sends one stop request; the deceleration after it does not wait for the clock.
Pacing real_time() {
  const auto start = std::chrono::steady_clock::now();
  return [start, told = false](std::int64_t t_ns) mutable {
    const auto due = start + std::chrono::nanoseconds(t_ns);
    while (!interrupted() && std::chrono::steady_clock::now() < due) {
      std::this_thread::sleep_for(std::min<std::chrono::steady_clock::duration>(
          due - std::chrono::steady_clock::now(), std::chrono::milliseconds(20)));
    }
    return !interrupted() || std::exchange(told, true);
  };
}

// The pacing of a run with these outputs, which must outlive the run, as must `running`. Null: the
// clock advances at once.
Pacing pace_of(const RunOptions& options, Outputs& outputs, const Session*& running) {
  if (!outputs.wants_time()) return options.realtime ? real_time() : Pacing();
  return [pace = options.realtime ? real_time() : full_speed(), &outputs,
          &running](std::int64_t t_ns) {
    outputs.look(running->host()->cell());
    return pace(t_ns);
  };
}

// The figures that the program has not saved itself, and the file that they were saved to.
class Figures {
 public:
  explicit Figures(const Session& session) {
    for (const Figure& figure : session.host()->figures()) {
      if (!figure.is_empty() && !figure.saved) unsaved_.push_back(figure);
    }
  }

  // Saves them beside the trace: run.csv, run.figures.svg. Returns the exit status.
  int save_beside(const std::string& trace) {
    if (unsaved_.empty() || trace.empty()) return kDone;
    path_ = trace.substr(0, trace.rfind('.')) + ".figures.svg";
    Result<NewFile> made = create_file(path_);
    std::string why = made.ok() ? std::string() : made.error().message;
    if (made.ok()) {
      NewFile file = std::move(made).value();
      file.write(to_svg(unsaved_));
      if (const auto error = file.finish()) why = error->message;
    }
    if (why.empty()) return kDone;
    progress(fmt::format("armlet: the figures {} cannot be written: {}", path_, why));
    path_.clear();
    return kFailed;
  }

  void show(bool drawn) const {
    if (unsaved_.empty()) return;
    const bool one = unsaved_.size() == 1;
    const std::string count = fmt::format("{} figure{}", unsaved_.size(), one ? "" : "s");
    if (!path_.empty()) {
      progress(fmt::format("  {} in {}", count, path_));
    } else if (!drawn) {
      progress(
          fmt::format("  {} not saved: savePlot(\"figures.svg\") in the program saves {}, --plots "
                      "shows {} here",
                      count, one ? "it" : "them", one ? "it" : "them"));
    }
  }

 private:
  std::vector<Figure> unsaved_;
  std::string path_;
};

void draw_figures(const Session& session) {
  for (const Figure& figure : session.host()->figures()) {
    print_out("\n" + to_braille(figure, 72, 18, is_capable_terminal(STDOUT_FILENO)));
  }
}

}  // namespace

int run(const RunOptions& options) {
  const bool json = options.program.json;
  auto text = read_file(options.file == "-" ? "/dev/stdin" : options.file, json);
  if (!text) return kNoFile;
  Setup setup = make_setup(options.program, options.file);
  if (setup.exit != kDone) return setup.exit;
  Outputs outputs;
  if (const int exit = outputs.choose(options, setup.session); exit != kDone) return exit;
  if (const int exit = choose_recorded_frames(options.cameras, setup.session); exit != kDone)
    return exit;
  const HostFrames recorded = setup.session.frames;
  InputScript script;
  if (const int exit = script.read(options.inputs); exit != kDone) return exit;
  RunHash hash;
  if (options.hash) setup.session.backends.push_back(&hash);
  const bool talks = !json && !options.quiet;
  const Session* running = nullptr;
  setup.session.pace = pace_of(options, outputs, running);
  if (talks || outputs.wants_moves()) {
    setup.session.on_move = [&](const FinishedMove& move) {
      if (talks) show_move(move);
      outputs.take(move, running->host()->cell());
    };
  }
  const SourceSet* sources = nullptr;
  setup.session.advice = [&](const Diagnostic& d) { show(d, *sources, json); };
  script.listen(setup.session, [&](const Diagnostic& d) { show(d, *sources, json); });

  Session session(library_engine(), std::move(setup.session));
  const bool runs = session.compile(*std::move(text), options.file);
  show(session.problems(), json);
  if (!runs) return kRejected;
  if (const int exit = check_recorded_frames(recorded, session); exit != kDone) return exit;
  sources = &session.sources();
  running = &session;
  if (const int exit = outputs.open(texts_of(options, *sources)); exit != kDone) return exit;

  RunResult result;
  {
    const Interruptible guard(session);
    result = script.is_wanted() ? script.play(session) : session.run();
  }
  // After Ctrl-C the program may also fail, for example by its step limit: the result is that the
  // user has stopped it.
  if (interrupted() && result.status == Progress::kFailed) result.status = Progress::kCancelled;
  if (result.error && output_is_read()) show(*result.error, session.sources(), json);
  if (options.plots) draw_figures(session);
  if (options.hash) print_out("hash " + hash.text() + "\n");
  bool whole = finish_output();
  whole &= outputs.finish(session);
  Figures figures(session);
  const bool pictured = !outputs.is_traced() || figures.save_beside(options.trace) == kDone;
  if (talks && output_is_read()) {
    show_summary(session, outputs.is_traced() ? options.trace : std::string(), result.status);
    figures.show(options.plots);
  }
  whole &= outputs.film(session, talks && output_is_read());
  if (result.status == Progress::kCancelled) return kStopped;
  return result.status == Progress::kDone && whole && pictured ? kDone : kFailed;
}

}  // namespace armlet::cli
