#include "vm/values/durations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "armlet/interpreter/virtual_time.hpp"
#include "vm/failures/failures.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/state/state.hpp"

namespace armlet::lang {
namespace {

bool refuse(VmState& state, Headline headline, const CallPart& part) {
  if (part == CallPart()) return raise(state, start_failure(state, headline));
  Failure failure;
  failure.headline = std::move(headline);
  failure.mark = part;
  return raise(state, failure);
}

}  // namespace

bool check_time(VmState& state, const TimeUse& use, double seconds, std::int64_t& ns) {
  const std::string what(use.what);
  if (!std::isfinite(seconds))
    return refuse(state, {"R0612", {std::string(use.time), number_text(seconds)}}, use.part);
  const std::string time = quantity_text(seconds, dims::kTime);
  const double left = time_left(state.vm);
  if (seconds > left) {
    return refuse(state, {"R0636", {what + " of " + time, quantity_text(left, dims::kTime)}},
                  use.part);
  }
  ns = seconds > 0.0 ? std::llround(seconds * 1e9) : 0;
  if (seconds >= 0.0 && ns >= use.least_ns) return true;
  return refuse(state, {"R0609", {what, time, std::string(use.requirement)}}, use.part);
}

}  // namespace armlet::lang

namespace armlet {

double time_left(Vm& vm) {
  const std::int64_t left = vm.state().options.limits.time_ns - vm.timeline().now_ns();
  return seconds_of(std::max<std::int64_t>(left, 0));
}

}  // namespace armlet
