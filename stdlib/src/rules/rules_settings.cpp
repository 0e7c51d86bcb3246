#include "rules/rules_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/math/ode.hpp"

namespace armlet::bind {
namespace {

// The value of a setting that the program writes; nullopt if it is left out or computed.
std::optional<Constant> written(const CheckCall& call, CallPart part) {
  return call.given(part) ? call.constant(part) : std::nullopt;
}

bool is_number(const Constant& constant) {
  return constant.kind == Constant::Kind::kReal || constant.kind == Constant::Kind::kInt;
}

Diagnostic refused(const CheckCall& call, CallPart part, std::string accepted, std::string given) {
  return make_diagnostic(
      "E0534", call.span(part),
      {std::string(call.function_name()), std::move(accepted), std::move(given)});
}

}  // namespace

std::string choice_of(std::span<const std::string_view> words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == words.size() ? " or " : ", ", words[i]);
  return out;
}

std::optional<Fix> meant_word(std::string_view written, const std::vector<std::string_view>& words,
                              Span span) {
  const auto meant = most_similar(written, words);
  if (!meant) return std::nullopt;
  return Fix{.text = fmt::format("did you mean \"{}\"?", *meant),
             .edits = {{span, fmt::format("\"{}\"", *meant)}},
             .confidence = Confidence::kMaybe};
}

void check_words(CheckCall& call, CallPart part, std::span<const std::string_view> words,
                 std::string_view setting) {
  const auto constant = written(call, part);
  if (!constant || constant->kind != Constant::Kind::kText ||
      std::ranges::find(words, constant->text) != words.end())
    return;
  std::string accepted = choice_of(words);
  if (!setting.empty()) accepted += fmt::format(" for `{}`", setting);
  Diagnostic out = refused(call, part, std::move(accepted), '"' + constant->text + '"');
  out.fix = meant_word(constant->text, {words.begin(), words.end()}, call.span(part));
  call.report(std::move(out));
}

void check_method_word(CheckCall& call, CallPart part) {
  check_words(call, part, ode_method_names());
}

void check_endings(CheckCall& call, CallPart part, std::span<const std::string_view> endings) {
  const auto constant = written(call, part);
  if (!constant || constant->kind != Constant::Kind::kText) return;
  const std::string_view text = constant->text;
  const std::string_view name = text.substr(text.find_last_of('/') + 1);
  if (std::ranges::find(endings, name) != endings.end()) {
    call.report(
        refused(call, part, fmt::format("a name before \"{}\"", name), '"' + constant->text + '"'));
    return;
  }
  if (std::ranges::any_of(endings, [&](std::string_view ending) { return text.ends_with(ending); }))
    return;
  call.report(refused(call, part, "a file that ends with " + choice_of(endings),
                      '"' + constant->text + '"'));
}

void check_fraction(CheckCall& call, CallPart part) {
  const auto constant = written(call, part);
  if (!constant || !is_number(*constant) || (constant->real > 0.0 && constant->real <= 1.0)) return;
  Diagnostic out =
      refused(call, part, "a fraction above 0 and at most 1", format_number(constant->real, 6));
  out.why = "it is a part of what the joints can do";
  constexpr double kPercent = 100.0;
  constexpr double kLeastPercent = 2.0;  // smaller: 1.5 rather means 150 % than 1.5 %
  if (constant->real >= kLeastPercent && constant->real <= kPercent) {
    const std::string meant = format_number(constant->real / kPercent, 6);
    out.fix = Fix{.text = fmt::format("for {} % write {}", format_number(constant->real, 6), meant),
                  .edits = {{call.span(part), meant}},
                  .confidence = Confidence::kMaybe};
  }
  call.report(std::move(out));
}

void check_positive(CheckCall& call, CallPart part) {
  const auto constant = written(call, part);
  if (!constant || !is_number(*constant) || constant->real > 0.0) return;
  call.report(refused(call, part, "more than 0", call.text_of(call.span(part))));
}

void check_inertia_size(CheckCall& call, CallPart part) {
  if (!call.given(part)) return;
  constexpr std::int64_t kRows = 3;
  const auto report = [&](std::string size) {
    call.report(refused(call, part, "an inertia of 3 rows of 3 values", std::move(size)));
  };
  const auto size = std::dynamic_pointer_cast<const SizeFact>(call.fact(part));
  if (size != nullptr && !size->is_list) {
    if (size->rows == kRows && size->cols == kRows) return;
    return report(fmt::format("a {} x {} matrix", size->rows, size->cols));
  }
  const auto constant = call.constant(part);
  if (!constant || constant->kind != Constant::Kind::kList) return;
  if (constant->items.size() != kRows)
    return report(
        fmt::format("{} row{}", constant->items.size(), constant->items.size() == 1 ? "" : "s"));
  for (std::size_t i = 0; i < kRows; ++i) {
    const std::size_t values = constant->items[i].items.size();
    if (values != kRows) return report(fmt::format("{} values in row {}", values, i + 1));
  }
}

}  // namespace armlet::bind
