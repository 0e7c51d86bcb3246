#pragma once
// The catalogue of messages: every code with its headline and its page of help.
//
// The rows of the language are data in messages/*.def, those of a host in its own sources; they are
// constant tables, so a program without messages does no work for them.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/messages/message_code.hpp"

namespace armlet {

// All entries of the language in the order of their codes: E, then R, then W.
[[nodiscard]] std::span<const CatalogEntry> catalog();

// The entries of the language and those that a host added (Engine::add_messages).
class MessageTables {
 public:
  MessageTables() : tables_{catalog()} {}
  // throws  ArgumentError if a code is not a letter E, R or W with four digits, if it exists
  // already, or if the rows are not in the order of their codes. The rows must outlive the tables.
  void add(std::span<const CatalogEntry> rows);
  // The entry of a code; null if there is none.
  [[nodiscard]] const CatalogEntry* find(std::string_view code) const;
  // The kind that `e.kind` shows for a code of the family R; empty if a program cannot catch it by
  // kind.
  [[nodiscard]] std::string_view kind_of(std::string_view code) const;
  // The entry of an error kind: R0607 for "Timeout". Null for the kinds of programs.
  [[nodiscard]] const CatalogEntry* of_kind(std::string_view kind) const;
  // All rows in the order of their codes.
  [[nodiscard]] std::vector<const CatalogEntry*> all() const;

 private:
  std::vector<std::span<const CatalogEntry>> tables_;
};

// The text that `armlet explain CODE` shows, at most 20 lines.
[[nodiscard]] std::string explain_page(const CatalogEntry& entry);

}  // namespace armlet
