#pragma once
// Rules of a `lab` block, checked before the run and when it is executed: E0530 and R0641.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet::bind {

inline constexpr const char* kRangeSize = "a range has two values, the smallest and the largest";
inline constexpr const char* kRangeOrder =
    "the first value of a range is the smallest and the second the largest";
inline constexpr const char* kLayouts =
    "\"columns\" puts elements side by side, \"stack\" one below the other";

inline constexpr const char* kOverlays =
    "\"corners\", \"truth\", \"wanted\", or a function that gives pixels";
inline constexpr const char* kWantedMissing = "its overlay \"wanted\" needs `wanted:`";

// "x y z roll" as axes; an error if a word is no axis.
[[nodiscard]] Result<std::vector<HandAxis>> hand_axes(std::string_view words);
[[nodiscard]] std::optional<LabLayout> layout_named(std::string_view word);
[[nodiscard]] std::string unknown_layout(std::string_view word);
[[nodiscard]] std::optional<LabOverlay> overlay_named(std::string_view word);
[[nodiscard]] std::string unknown_overlay(std::string_view word);

// "250 mm lies outside of its range, 20 mm to 200 mm", for a field with a range.
[[nodiscard]] std::string outside_range(const Value& value, const LabRow& field);

void check_lab(CheckCall& call);      // (name, title, layout, rows)
void check_sliders(CheckCall& call);  // (of, as, ...)
void check_field(CheckCall& call);    // (value, range, ...)
void check_plot(CheckCall& call);     // (value: fn() -> T, ...)
void check_table(CheckCall& call);    // (value: fn() -> T, ...)
void check_view(CheckCall& call);     // (of, overlay, wanted, ...)

}  // namespace armlet::bind
