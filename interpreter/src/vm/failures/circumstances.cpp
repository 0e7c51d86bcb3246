// The circumstances of a failure: the running calls, and the iteration of the running loop.

#include <string>
#include <vector>

#include "vm/failures/failures.hpp"

namespace armlet::lang {
namespace {

std::string ordinal(std::int64_t n) {
  const bool teen = n % 100 >= 11 && n % 100 <= 13;
  const char* ending = "th";
  if (n % 10 == 1 && !teen) ending = "st";
  if (n % 10 == 2 && !teen) ending = "nd";
  if (n % 10 == 3 && !teen) ending = "rd";
  return std::to_string(n) + ending;
}

// The inlined calls that run in a frame, the innermost first.
std::vector<const ExpandedCall*> expanded_calls(const Frame& frame) {
  std::vector<const ExpandedCall*> calls;
  for (const ExpandedCall& call : frame.callee->function->expanded) {
    if (call.begin <= frame.at() && frame.at() < call.end) calls.push_back(&call);
  }
  return calls;
}

// "in the 5th pass of the loop on line 7" for the innermost loop around the running instruction.
std::string loop_note(const Frame& frame) {
  if (!expanded_calls(frame).empty()) return {};
  const LoopInfo* innermost_loop = nullptr;
  for (const LoopInfo& loop : frame.callee->function->loops) {
    const bool inside = loop.begin <= frame.at() && frame.at() < loop.end;
    const bool smaller = innermost_loop == nullptr ||
                         loop.end - loop.begin < innermost_loop->end - innermost_loop->begin;
    if (inside && smaller) innermost_loop = &loop;
  }
  if (innermost_loop == nullptr || innermost_loop->step == 0) return {};
  const std::int64_t counter = frame.base[innermost_loop->counter].i;
  const std::int64_t pass = (counter - innermost_loop->first) / innermost_loop->step + 1;
  return "in the " + ordinal(pass) + " pass of the loop on line " +
         std::to_string(innermost_loop->line);
}

// A running call, inlined into its caller or with a frame of its own.
struct RunningCall {
  const std::string* name;
  const Span* inlined_at;
  const Frame* caller;  // null: the host or the program as a whole
};

std::string described(const VmState& state, const RunningCall& call) {
  const Span* site = call.inlined_at;
  if (const CodeSpan* at = call.caller == nullptr ? nullptr : code_span(*call.caller))
    site = &at->span;
  return site == nullptr ? *call.name : *call.name + ", called on " + line_name(state, *site);
}

// The running calls, the innermost first.
std::vector<RunningCall> running_calls(const VmState& state) {
  std::vector<RunningCall> calls;
  const Frame* frame = innermost(state);
  for (; frame != nullptr && frame > state.running->stack.frames; --frame) {
    if (frame->is_host()) continue;
    const Callee& callee = *frame->callee;
    for (const ExpandedCall* inner : expanded_calls(*frame))
      calls.push_back({&callee.program->functions[inner->function].name, &inner->call, nullptr});
    if (callee.function->name.empty() || callee.function->function->is_task) continue;
    calls.push_back({&callee.function->name, nullptr, frame[-1].is_host() ? nullptr : frame - 1});
  }
  return calls;
}

// Of deep recursion only both ends are reported, and only they are made into text, because programs
// may cause such failures many times.
std::vector<std::string> call_path(const VmState& state) {
  constexpr std::size_t kMost = 10;
  const std::vector<RunningCall> calls = running_calls(state);
  const std::size_t left_out = calls.size() > kMost ? calls.size() - kMost : 0;
  std::vector<std::string> path;
  for (std::size_t i = 0; i < calls.size(); ++i) {
    if (left_out > 0 && i == kMost / 2) {
      path.push_back("... " + std::to_string(left_out) + " calls more ...");
      i += left_out;
    }
    path.push_back(described(state, calls[i]));
  }
  return path;
}

}  // namespace

When circumstances(const VmState& state) {
  When when;
  when.time_ns = state.vm.timeline().now_ns();
  const Task* task = state.running;
  if (task != nullptr && task == state.condition_task.get()) task = task->origin.parent;
  if (task != nullptr) when.task = task_name(*task);
  if (const Frame* frame = innermost(state)) when.note = loop_note(*frame);
  when.calls = call_path(state);
  return when;
}

}  // namespace armlet::lang
