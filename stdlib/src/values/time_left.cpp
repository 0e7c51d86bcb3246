#include "values/time_left.hpp"

#include <fmt/format.h>

#include <utility>

#include "armlet/core/format.hpp"
#include "armlet/interpreter/virtual_time.hpp"
#include "values/bind.hpp"

namespace armlet::bind {

Answer<void> check_time_left(Vm& vm, std::string_view what, double seconds, CallPart part) {
  const double left = time_left(vm);
  if (seconds <= left) return {};
  Failure f;
  f.headline = {
      "R0636",
      {fmt::format("{} of {:.6g} s", what, seconds), fmt::format("{} s", format_number(left))}};
  f.mark = part;
  return fail(vm, std::move(f));
}

}  // namespace armlet::bind
