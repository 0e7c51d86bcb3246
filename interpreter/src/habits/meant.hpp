#pragma once
// Converts lines of other languages: templates with gaps for the parts that a shape has matched.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// `here` with its gaps filled: {1} is the first part unchanged, {1:name} the first part after a
// conversion, {12:name} the first two with a comma between them. The conversions are:
//
//   operand      in parentheses, unless it is one value
//   test         a condition: `=` compares
//   truth        1, on, high and TRUE are true, 0, off, low and FALSE false
//   mm m deg s ms us   a number with this unit
//   type         the type for a type of another language: Integer, num, REAL
//   parameters   of a function, with their types if they have one: `num x, x:IN, int n`
//   print text   a format of C and its values: the arguments of print, or a text
//   braces       "{} {:.2f}" and its values: a text
//   inner        a text without its quotes
//   stream streamed  the operands of << in C++: a line without its break, a text
//   separated    Python's values and the text between them
//   strcat       two texts of MATLAB, which removes blanks at their ends
//   index counted stepped angle turned share   (meant_numbers.hpp)
//   shift        KRL's X 0, Z 50, without a rotation
//   zero         the first value of a variable of a type
//   kind         the kind of an error
//   speed        RAPID's v100: a setting after a comma, or an empty text
//   movej movel  URScript's settings a, v, t, r; fails if one has no counterpart
//   axes frame   KRL's A1 0, A2 -90 ... and X 100, Y 0, Z 50, A 0, B 0, C 0
//   degrees      a list of angles without units
//   place        coordinates without units: m, or mm if they are large
//   lower        without capitals
//   turn         URScript's rotation vector, "" if it is zero
//
// Empty if a part cannot be converted.
[[nodiscard]] std::optional<std::string> filled(std::string_view here,
                                                const std::vector<std::string>& parts);

// A value in parentheses, unless it is one term: a name, a number, a call.
[[nodiscard]] std::string as_factor(const std::string& part);

// A value in parentheses if an operator beside it would apply to a part of it.
[[nodiscard]] std::string in_a_term(const std::string& value);

}  // namespace armlet::lang
