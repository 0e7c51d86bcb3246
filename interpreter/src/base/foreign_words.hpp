#pragma once
// Keywords of other languages, with the word of this language that means the same.

#include <string_view>

namespace armlet::lang {

// The bools say in which positions of the text the word is recognised:
struct ForeignWord {
  std::string_view found;
  std::string_view meant;
  bool at_start = false;  // as the first word of a statement that cannot be read
  bool inside = false;    // anywhere in such a statement
  bool declares = false;  // in the position of a type: const x = 3
  bool alone = false;     // as a name that is not declared
};

// clang-format off
inline constexpr ForeignWord kForeignWords[] = {
    {.found = "and", .meant = "&&", .inside = true, .alone = true},
    {.found = "or", .meant = "||", .inside = true, .alone = true},
    {.found = "not", .meant = "!", .inside = true, .alone = true},
    {.found = "mod", .meant = "%", .inside = true},
    {.found = "div", .meant = "/", .inside = true},
    {.found = "of", .meant = "in", .inside = true},
    {.found = "elif", .meant = "else if", .at_start = true, .inside = true, .alone = true},
    {.found = "elseif", .meant = "else if", .at_start = true, .inside = true, .alone = true},
    {.found = "elsif", .meant = "else if", .inside = true},
    {.found = "foreach", .meant = "for", .at_start = true, .alone = true},
    {.found = "except", .meant = "catch", .at_start = true, .inside = true, .alone = true},
    {.found = "raise", .meant = "throw", .at_start = true, .alone = true},
    {.found = "def", .meant = "fn", .at_start = true, .declares = true, .alone = true},
    {.found = "function", .meant = "fn", .at_start = true, .declares = true, .alone = true},
    {.found = "func", .meant = "fn", .at_start = true, .declares = true, .alone = true},
    {.found = "fun", .meant = "fn", .at_start = true, .declares = true},
    {.found = "sub", .meant = "fn", .at_start = true},
    {.found = "lambda", .meant = "fn", .alone = true},
    {.found = "const", .meant = "let", .at_start = true, .declares = true, .alone = true},
    {.found = "constexpr", .meant = "let", .declares = true},
    {.found = "val", .meant = "let", .declares = true, .alone = true},
    {.found = "auto", .meant = "var", .declares = true, .alone = true},
    {.found = "dim", .meant = "var", .declares = true},
    {.found = "local", .meant = "var", .declares = true},
    {.found = "mut", .meant = "var", .declares = true},
    {.found = "True", .meant = "true", .alone = true},
    {.found = "False", .meant = "false", .alone = true},
};
// clang-format on

// Names of types in other languages.
struct ForeignType {
  std::string_view found;
  std::string_view meant;
};
inline constexpr ForeignType kForeignTypes[] = {
    {"Double", "double"},  {"Float", "double"},    {"real", "double"},
    {"number", "double"},  {"Number", "double"},   {"decimal", "double"},
    {"Integer", "int"},    {"Int", "int"},         {"integer", "int"},
    {"Long", "int"},       {"short", "int"},       {"byte", "int"},
    {"unsigned", "int"},   {"size_t", "int"},      {"int32_t", "int"},
    {"int64_t", "int"},    {"Boolean", "bool"},    {"Bool", "bool"},
    {"str", "string"},     {"Str", "string"},      {"text", "string"},
    {"list", "double[]"},  {"vector", "double[]"}, {"ArrayList", "double[]"},
    {"array", "double[]"}, {"Exception", "error"}, {"Error", "error"},
};

// The type of this language for a foreign type; empty if the word is none.
[[nodiscard]] constexpr std::string_view type_meant_by(std::string_view word) {
  for (const ForeignType& row : kForeignTypes) {
    if (row.found == word) return row.meant;
  }
  return {};
}

// The word of this language for a foreign word in a position; empty if the word is none.
[[nodiscard]] constexpr std::string_view meant_by(std::string_view word, bool ForeignWord::*place) {
  for (const ForeignWord& row : kForeignWords) {
    if (row.found == word && row.*place) return row.meant;
  }
  return {};
}

}  // namespace armlet::lang
