#pragma once
// The catalogue of messages: every code with its headline and its page of help.
//
// The rows are data in src/diagnostic/*.def; they are constant tables, so a program that reports
// nothing pays nothing.

#include <span>
#include <string>
#include <string_view>

namespace armlet {

struct CatalogEntry {
  std::string_view code;  // "E0401"
  std::string_view kind;  // of an error that a program can catch ("JointLimit"); otherwise empty
  std::string_view headline;  // with {} where make_diagnostic puts its arguments
  std::string_view page;      // what it means, a wrong and a right program

  // How many arguments the headline takes.
  [[nodiscard]] int argument_count() const;
};

// All entries in the order of their codes: E, then R, then W.
[[nodiscard]] std::span<const CatalogEntry> catalog();

// The entry of a code, null if there is none.
[[nodiscard]] const CatalogEntry* catalog_entry(std::string_view code);

// The text that `armlet explain CODE` shows, at most 20 lines; empty for an unknown code.
[[nodiscard]] std::string explain_page(std::string_view code);

// The kind that `e.kind` shows for a code of the family R; empty if a program cannot catch it by
// kind.
[[nodiscard]] std::string_view kind_of(std::string_view code);

// The code of an error kind of the library: "Unreachable" gives R0601. Empty for the kinds of
// programs.
[[nodiscard]] std::string_view code_of_kind(std::string_view kind);

}  // namespace armlet
