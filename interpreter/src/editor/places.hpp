#pragma once
// Positions where only a few things can stand: units behind numbers and in formats, types, cases,
// and texts that name something.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/cursor.hpp"

namespace armlet::lang {

// What can be written at the position; nothing where any value or statement can.
[[nodiscard]] std::optional<std::vector<Completion>> items_of_place(const Facts& facts,
                                                                    const Cursor& cursor);
// The texts that fit between the quotes which the position is in, apart from those that a parameter
// of a library function takes.
[[nodiscard]] std::vector<Completion> texts_of_place(const Facts& facts, const Cursor& cursor);

// Where the unit of a number begins in its text.
[[nodiscard]] std::size_t unit_begin(std::string_view number);
// Units that measure a quantity, common ones first; of all quantities if there is none.
[[nodiscard]] std::vector<std::string_view> units_of(std::optional<Dim> dim);
// Whether a type is written in front of the token of this number, or as the token of this number.
[[nodiscard]] bool is_type_place(const Facts& facts, std::size_t token);
// Whether a value has to stand there: behind an operator, in a call, as a setting.
[[nodiscard]] bool is_value_place(const Facts& facts, const Cursor& cursor);
// Whether the text at a token is compared with the kind of an error, and so is the name of one.
[[nodiscard]] bool is_kind_place(const Facts& facts, std::size_t token);

}  // namespace armlet::lang
