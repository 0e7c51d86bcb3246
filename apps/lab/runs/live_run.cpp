#include "live_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/cell/clock.hpp"
#include "armlet/plot/svg.hpp"
#include "armlet/stdlib/install.hpp"
#include "lab_elements.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostFigures = 50;
constexpr std::size_t kMostFigureBytes = 4'000'000;
constexpr std::size_t kMostFigureValues = 40'000;  // with more, pages get the picture alone

}  // namespace

SessionOptions session_options(SessionOptions options, const RunBounds& bounds) {
  options.open = true;
  options.markers = true;
  options.limits.heap_bytes = std::uint64_t{256} << 20U;
  options.limits.output_bytes = std::uint64_t{4} << 20U;
  options.laboratory = true;
  options.limits.time_ns = std::min(options.limits.time_ns, bounds.time_ns);
  options.limits.steps = std::min(options.limits.steps, bounds.steps);
  options.keeps_files = false;
  options.backends.clear();
  options.output = [](std::string_view) {};
  options.advice = nullptr;
  options.on_move = nullptr;
  return options;
}

LiveRun::LiveRun(const SessionOptions& options, const RunBounds& bounds, RunRecord& record,
                 ShownFiles& files)
    : bounds_(bounds), record_(record), recording_(record, files) {
  SessionOptions own = options;
  own.backends = {&recording_, &marks_};
  own.on_move = [this](const FinishedMove& report) { recording_.on_move(report); };
  own.advice = [this](const Diagnostic& advice) { recording_.on_advice(advice); };
  own.on_press = [this](const PressReport& report) { recording_.on_press(report); };
  own.pace = [this](std::int64_t) {
    recording_.on_wait();
    return true;
  };
  session_ = std::make_unique<Session>(library_engine(), std::move(own));
  recording_.listen_to(*session_);
}

bool LiveRun::begin(const std::string& text, const std::string& name) {
  return session_->compile(text, name);
}

std::int64_t LiveRun::now_ns() const {
  return session_->vm() == nullptr ? 0 : session_->host()->now_ns();
}

void LiveRun::begin_fork(const SessionLog& log, std::int64_t t_ns, InputWhat input) {
  static_cast<void>(session_->replay(log));
  fork_ = Fork{t_ns, std::move(input)};
}

bool LiveRun::advance() {
  if (is_over()) return false;
  fork_ ? advance_fork() : run_slice();
  return !is_over();
}

void LiveRun::advance_fork() {
  const std::uint64_t steps = session_->vm() == nullptr ? 0 : session_->result().steps;
  const Progress progress = session_->run({.until_ns = fork_->t_ns, .steps = kSliceSteps});
  recording_.look_at_models();
  recording_.look_at_objects();
  recording_.look_at_cameras();
  take_rows();
  const bool is_there = session_->result().steps - steps < kSliceSteps;
  if (progress == Progress::kPaused && !is_there) return;
  const InputWhat input = std::move(fork_->input);
  fork_.reset();
  fork_fault_ = give(input);
}

void LiveRun::run_slice() {
  const Progress progress = session_->run({.steps = kSliceSteps});
  recording_.look_at_models();
  recording_.look_at_objects();
  recording_.look_at_cameras();
  take_rows();
  record_.t_end = std::max(record_.t_end, to_seconds(now_ns()));
  ++record_.changes;
  if (progress != Progress::kPaused || session_->is_at_rest()) {
    come_to_end(progress == Progress::kPaused ? Progress::kDone : progress);
  } else if (session_->result().steps >= bounds_.steps) {
    stop(fmt::format("A laboratory runs a program for {} steps; it is still running there.",
                     bounds_.steps));
  } else {
    recording_.on_slice();
  }
}

std::optional<InputFault> LiveRun::give(const InputWhat& input) {
  if (session_->vm() == nullptr) return InputFault{"The run has not begun."};
  if (const std::optional<Error> fault = apply_input(*session_, input)) {
    const UnreachedGoal* goal = session_->host()->unreached();
    const bool is_out_of_reach = fault->code == "unreachable" && goal != nullptr;
    return InputFault{fault->message, is_out_of_reach ? std::optional(*goal) : std::nullopt};
  }
  record_.inputs.push_back({to_seconds(now_ns()), input});
  record_.state = RunState::kRunning;
  record_.error.reset();
  ++record_.changes;
  return std::nullopt;
}

void LiveRun::stop(std::string why) {
  if (is_over()) return;
  record_.state = RunState::kStopped;
  record_.error = TextMessage{.is_error = false, .message = std::move(why), .t = record_.t_end};
  record_.error->place.span = recording_.here();
  finish_record();
}

void LiveRun::come_to_end(Progress progress) {
  if (progress != Progress::kDone && session_->result().error && now_ns() >= bounds_.time_ns) {
    return stop(fmt::format("A laboratory runs a program for {:g} s; it is still running there.",
                            to_seconds(bounds_.time_ns)));
  }
  record_.state = progress == Progress::kDone     ? RunState::kDone
                  : progress == Progress::kFailed ? RunState::kFailed
                                                  : RunState::kStopped;
  if (const auto& error = session_->result().error; error && progress != Progress::kDone) {
    record_.error = resolved(*error, session_->sources());
    // An earlier goal, after which the program continued, is not the cause of this failure.
    const UnreachedGoal* goal = session_->host()->unreached();
    if (error->code == "R0601" && goal != nullptr && goal->t_ns == now_ns())
      record_.error->unreached = *goal;
  }
  finish_record();
}

void LiveRun::finish_record() {
  recording_.on_end();
  record_.log = session_->log();
  // As if the run ended here; a run that is at rest can continue.
  RunMarks ended = marks_;
  if (session_->is_at_rest()) {
    for (const Figure& figure : session_->host()->figures())
      ended.on(FinalFigure{.t_ns = now_ns(), .index = figure.index, .figure = &figure});
    ended.on(EndRun{.t_ns = now_ns()});
  }
  record_.marks = ended.marks();
  record_.hash = ended.text();
  take_figures();
  ++record_.changes;
}

void LiveRun::take_rows() {
  if (record_.lab && record_.lab->has_block) return;
  record_.lab = lab_of(*session_, record_.lab);
  if (record_.lab && record_.lab->is_new) {
    record_.lab->is_new = false;
    recording_.keep_pictures(*record_.lab);
    ++record_.described;
  }
}

void LiveRun::take_figures() {
  if (session_->host() == nullptr) return;
  record_.figures.clear();
  ++record_.figure_changes;
  for (const Figure& figure : session_->host()->figures()) {
    if (record_.figures.size() >= kMostFigures) break;
    std::string svg = figure.is_empty() ? std::string() : to_svg({&figure, 1});
    if (svg.size() > kMostFigureBytes) svg.clear();
    record_.figures.push_back({figure.index, figure.title, std::move(svg), {}});
    if (!figure.is_empty() && is_plot(figure) && values_of(figure) <= kMostFigureValues)
      record_.figures.back().plot = figure;
  }
}

}  // namespace armlet::lab
