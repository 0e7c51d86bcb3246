#include "laboratory/lab_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "armlet/core/format.hpp"
#include "laboratory/lab_text.hpp"
#include "messages/library_messages.hpp"
#include "values/values.hpp"

namespace armlet::bind {

Result<std::vector<HandAxis>> hand_axes(std::string_view words) {
  std::vector<HandAxis> axes;
  std::set<HandAxis> known;
  std::size_t at = 0;
  while (at < words.size()) {
    const std::size_t first = words.find_first_not_of(' ', at);
    if (first == std::string_view::npos) break;
    const std::string_view word = words.substr(first, words.find(' ', first) - first);
    at = first + word.size();
    constexpr std::array kNamed = {HandAxis::kX,    HandAxis::kY,     HandAxis::kZ,
                                   HandAxis::kRoll, HandAxis::kPitch, HandAxis::kYaw};
    const auto* const found =
        std::ranges::find(kNamed, word, [](HandAxis axis) { return word_of(axis); });
    if (found == kNamed.end())
      return Error{"axes", fmt::format("a hand has no coordinate \"{}\"; it has x, y, z, roll, "
                                       "pitch and yaw",
                                       word)};
    if (!known.insert(*found).second)
      return Error{"axes", fmt::format("\"{}\" is named twice", word)};
    axes.push_back(*found);
  }
  if (axes.empty()) return Error{"axes", "no coordinate of the hand is named, such as \"x y z\""};
  const bool turns_freely = known.contains(HandAxis::kPitch) || known.contains(HandAxis::kYaw);
  if (!turns_freely) std::replace(axes.begin(), axes.end(), HandAxis::kRoll, HandAxis::kTurn);
  return axes;
}

std::optional<LabLayout> layout_named(std::string_view word) {
  if (word == "columns") return LabLayout::kColumns;
  if (word == "stack") return LabLayout::kStack;
  return std::nullopt;
}

std::string unknown_layout(std::string_view word) {
  return fmt::format("a page has no layout \"{}\"", word);
}

std::optional<LabOverlay> overlay_named(std::string_view word) {
  if (word == "corners") return LabOverlay::kCorners;
  if (word == "truth") return LabOverlay::kTruth;
  if (word == "wanted") return LabOverlay::kWanted;
  return std::nullopt;
}

std::string unknown_overlay(std::string_view word) {
  return fmt::format("a view has no overlay \"{}\"; it has {}", word, kOverlays);
}

std::string outside_range(const Value& value, const LabRow& field) {
  const auto [lower, upper] = *field.range;
  return fmt::format("{} lies outside of its range, {} to {}", field_text(value),
                     number_text(lower, field), number_text(upper, field));
}

namespace {

void refuse(CheckCall& call, CallPart part, std::string why, std::string fix = {}) {
  Diagnostic d = make_diagnostic(row("E0530"), call.span(part),
                                 {std::string(call.function_name()), std::move(why)});
  if (!fix.empty()) d.fix = Fix{.text = std::move(fix)};
  call.report(std::move(d));
}

bool is_numbers(const Type& type) {
  return type.is_number() || (type.is(Kind::kList) && type.element->is_number());
}

// Whether a row of a table may hold values of this type.
bool is_cell(const Type& type) {
  return type.is_number() || type.is(Kind::kBool) || type.is(Kind::kText) || type.is(Kind::kEnum);
}

bool is_table_like(const Type& type) {
  if (type.is(Kind::kMatrix) || type.is_table()) return true;
  if (!type.is(Kind::kList)) return false;
  const Type& element = *type.element;
  const bool is_joints = element.is(Kind::kHost) && element.host == &kPosJ;
  return is_cell(element) || element.is(Kind::kRecord) || is_joints ||
         (element.is(Kind::kList) && is_cell(*element.element));
}

}  // namespace

void check_lab(CheckCall& call) {
  const auto layout = call.constant(at("layout"));
  if (!layout || layout_named(layout->text)) return;
  refuse(call, at("layout"), unknown_layout(layout->text), kLayouts);
}

void check_sliders(CheckCall& call) {
  const auto as = call.constant(at("as"));
  if (!call.given(at("as")) || !as) return;
  if (const auto axes = hand_axes(as->text); !axes) refuse(call, at("as"), axes.error().message);
}

void check_field(CheckCall& call) {
  const auto range = call.given(at("range")) ? call.constant(at("range")) : std::nullopt;
  if (!range) return;
  if (range->items.size() != 2) return refuse(call, at("range"), kRangeSize);
  const double lower = range->items[0].real;
  const double upper = range->items[1].real;
  if (!(lower <= upper)) return refuse(call, at("range"), kRangeOrder);
  const auto value = call.constant(at("value"));
  if (!value || (value->real >= lower && value->real <= upper)) return;
  refuse(call, at("value"),
         fmt::format("{} lies outside of its range, {}", call.text_of(call.span(at("value"))),
                     call.text_of(call.span(at("range")))));
}

void check_plot(CheckCall& call) {
  const Type& shown = *call.type(at("value"))->result;
  if (is_numbers(shown) || (shown.is(Kind::kHost) && shown.host == &kPosJ)) return;
  refuse(call, at("value"), fmt::format("its function gives {}, not numbers", type_phrase(&shown)),
         "give a number, a list of numbers or joint values");
}

void check_view(CheckCall& call) {
  const auto overlay = call.given(at("overlay")) ? call.constant(at("overlay")) : std::nullopt;
  if (!overlay) return;
  const auto known = overlay_named(overlay->text);
  if (!known) {
    refuse(call, at("overlay"), fmt::format("a view has no overlay \"{}\"", overlay->text),
           kOverlays);
  } else if (*known == LabOverlay::kWanted && !call.given(at("wanted"))) {
    refuse(call, at("overlay"), kWantedMissing, "give `wanted:` an N x 2 matrix of pixels");
  }
}

void check_table(CheckCall& call) {
  const Type& shown = *call.type(at("value"))->result;
  if (is_table_like(shown)) return;
  refuse(call, at("value"),
         fmt::format("its function gives {}, which has no rows", type_phrase(&shown)),
         "give a matrix, a list of rows or a table");
}

}  // namespace armlet::bind
