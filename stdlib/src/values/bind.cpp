#include "values/bind.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

namespace armlet::bind {

Failed failure(Vm& vm, KnownCode code, std::string message, CallPart part, std::string why,
               std::string fix) {
  Failure f;
  f.headline = Headline::own(code, std::move(message));
  f.mark = part;
  f.why = std::move(why);
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Failed domain_failure(Vm& vm, std::string_view function, double value, std::string_view requirement,
                      std::string fix, CallPart part) {
  if (!std::isfinite(value))
    return not_finite(vm, fmt::format("the value given to {}", function), value, part);
  Failure f;
  const std::string shown = fmt::format("{:.15g}", value);
  f.headline = Headline::own(
      "R0609", fmt::format("{} of {}: the value must {}", function, shown, requirement));
  f.mark = part;
  f.label = shown;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Failed not_finite(Vm& vm, std::string_view what, double value, CallPart part) {
  return failure(vm, "R0612",
                 fmt::format("{} is {}, which is not a finite number", what,
                             std::isnan(value) ? "nan"
                             : value > 0       ? "inf"
                                               : "-inf"),
                 part);
}

Failed size_failure(Vm& vm, std::string_view what, std::size_t left, std::size_t right) {
  return failure(vm, "R0613",
                 fmt::format("{}: the sizes do not fit: {} and {}", what, left, right));
}

std::string clause_of(const std::exception& error) {
  std::string sentence = error.what();
  // A number that is none has no sign.
  for (std::size_t at = sentence.find("-nan"); at != sentence.npos; at = sentence.find("-nan", at))
    sentence.erase(at, 1);
  if (sentence.ends_with('.')) sentence.pop_back();
  // A capital at the start becomes a small letter, unless a second capital follows.
  if (sentence.size() > 1 && std::isupper(static_cast<unsigned char>(sentence[0])) != 0 &&
      std::isupper(static_cast<unsigned char>(sentence[1])) == 0) {
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  }
  return sentence;
}

Failed failure_of(Vm& vm, MessageCode<1> code, const std::exception& error, CallPart part,
                  std::string fix) {
  Failure f;
  f.headline = {code, {clause_of(error)}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

}  // namespace armlet::bind
