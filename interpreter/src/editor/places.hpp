#pragma once
// Completions for positions where few texts are possible: units after numbers and in formats,
// types, cases, and texts with a meaning.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/cursor.hpp"

namespace armlet::lang {

// The completions at the position; empty if any value or statement is possible.
[[nodiscard]] std::optional<std::vector<Completion>> items_of_place(const Facts& facts,
                                                                    const Cursor& cursor);
// The texts that fit between the quotes around the position, apart from those of parameters of
// library functions.
[[nodiscard]] std::vector<Completion> texts_of_place(const Facts& facts, const Cursor& cursor);

// The position in the text of a number where its unit begins.
[[nodiscard]] std::size_t unit_begin(std::string_view number);
// The units of a dimension, common ones first; all units if `dim` is empty.
[[nodiscard]] std::vector<std::string_view> units_of(std::optional<Dim> dim);
// Whether a type is expected at the token with this index, or ends before it.
[[nodiscard]] bool is_type_place(const Facts& facts, std::size_t token);
// Whether a value is expected: after an operator, in a call, as a setting.
[[nodiscard]] bool is_value_place(const Facts& facts, const Cursor& cursor);
// Whether the text at a token is compared with the kind of an error, so that it names a kind.
[[nodiscard]] bool is_kind_place(const Facts& facts, std::size_t token);

}  // namespace armlet::lang
