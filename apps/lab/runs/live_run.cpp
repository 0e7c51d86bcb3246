#include "live_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/cell/clock.hpp"
#include "armlet/plot/svg.hpp"
#include "armlet/stdlib/install.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostFigures = 50;
constexpr std::size_t kMostFigureBytes = 4'000'000;

}  // namespace

SessionOptions session_options(SessionOptions options, const RunBounds& bounds) {
  options.open = true;
  options.markers = true;
  options.limits.heap_bytes = std::uint64_t{256} << 20U;
  options.limits.output_bytes = std::uint64_t{4} << 20U;
  options.limits.steps = std::min(options.limits.steps, bounds.steps);
  options.keeps_files = false;
  options.backends.clear();
  options.output = [](std::string_view) {};
  options.advice = nullptr;
  options.on_move = nullptr;
  return options;
}

LiveRun::LiveRun(const SessionOptions& options, const RunBounds& bounds, RunRecord& record)
    : bounds_(bounds), record_(record), recording_(record) {
  SessionOptions own = options;
  own.backends = {&recording_, &marks_};
  own.on_move = [this](const MoveReport& report) { recording_.on_move(report); };
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

bool LiveRun::advance() {
  if (is_over()) return false;
  Budget budget;
  budget.until_ns = std::min(now_ns() + kSlice_ns, bounds_.time_ns);
  budget.steps = kSliceSteps;
  const Progress progress = session_->run(budget);
  recording_.look_at_models();
  record_.t_end = std::max(record_.t_end, to_seconds(now_ns()));
  ++record_.changes;
  if (progress != Progress::kPaused) {
    come_to_end(progress);
  } else if (now_ns() >= bounds_.time_ns) {
    stop(fmt::format("A laboratory runs a program for {} s of its time; it was stopped there.",
                     bounds_.time_ns / 1'000'000'000));
  } else if (session_->result().steps >= bounds_.steps) {
    stop(fmt::format("A laboratory runs a program for {} steps; it was stopped there.",
                     bounds_.steps));
  }
  return !is_over();
}

void LiveRun::stop(std::string why) {
  if (is_over()) return;
  record_.state = RunState::kStopped;
  record_.error = TextMessage{.is_error = false, .message = std::move(why), .t = record_.t_end};
  finish_record();
}

void LiveRun::come_to_end(Progress progress) {
  record_.state = progress == Progress::kDone     ? RunState::kDone
                  : progress == Progress::kFailed ? RunState::kFailed
                                                  : RunState::kStopped;
  if (const auto& error = session_->result().error)
    record_.error = resolved(*error, session_->sources());
  finish_record();
}

void LiveRun::finish_record() {
  record_.log = session_->log();
  record_.marks = marks_.marks();
  record_.hash = marks_.text();
  take_figures();
  ++record_.changes;
}

void LiveRun::take_figures() {
  if (session_->host() == nullptr) return;
  record_.figures.clear();
  ++record_.figure_changes;
  for (const Figure& figure : session_->host()->figures()) {
    if (record_.figures.size() >= kMostFigures) break;
    std::string svg = figure.is_empty() ? std::string() : to_svg({&figure, 1});
    if (svg.size() > kMostFigureBytes) svg.clear();
    record_.figures.push_back({figure.index, figure.title, std::move(svg)});
  }
}

}  // namespace armlet::lab
