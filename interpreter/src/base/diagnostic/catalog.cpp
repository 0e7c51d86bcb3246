#include "armlet/interpreter/messages/catalog.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/diagnostic.hpp"

namespace armlet {
namespace {

#define ARMLET_MESSAGE(code, kind, headline, page) CatalogEntry{#code, kind, headline, page},

// The order is that of the codes.
// clang-format off
constexpr auto kCatalog = std::to_array<CatalogEntry>({
#include "armlet/interpreter/messages/text.def"
#include "armlet/interpreter/messages/names.def"
#include "armlet/interpreter/messages/types.def"
#include "armlet/interpreter/messages/units.def"
#include "armlet/interpreter/messages/tasks.def"
#include "armlet/interpreter/messages/running.def"
#include "armlet/interpreter/messages/advice.def"
});
// clang-format on

#undef ARMLET_MESSAGE

static_assert(std::ranges::is_sorted(kCatalog, {}, &CatalogEntry::code),
              "rows stand in the order of their codes");

constexpr std::string_view kPlace = "{}";

}  // namespace

std::span<const CatalogEntry> catalog() { return kCatalog; }

const CatalogEntry& language_row(std::size_t place) { return kCatalog[place]; }

namespace {

const CatalogEntry* find_in(std::span<const CatalogEntry> rows, std::string_view code) {
  const auto found = std::ranges::lower_bound(rows, code, {}, &CatalogEntry::code);
  return found != rows.end() && found->code == code ? &*found : nullptr;
}

bool is_code(std::string_view code) {
  return code.size() == 5 && std::string_view("ERW").find(code[0]) != std::string_view::npos &&
         code.find_first_not_of("0123456789", 1) == std::string_view::npos;
}

}  // namespace

void MessageTables::add(std::span<const CatalogEntry> rows) {
  if (!std::ranges::is_sorted(rows, {}, &CatalogEntry::code))
    throw ArgumentError("Rows of messages stand in the order of their codes.");
  std::string_view before;
  for (const CatalogEntry& row : rows) {
    const std::string code(row.code);
    if (!is_code(row.code)) throw ArgumentError("`" + code + "` is no code such as E0901.");
    if (find(row.code) != nullptr || row.code == before)
      throw ArgumentError("There is a message " + code + " already.");
    before = row.code;
  }
  tables_.push_back(rows);
}

const CatalogEntry* MessageTables::find(std::string_view code) const {
  for (const std::span<const CatalogEntry> rows : tables_) {
    if (const CatalogEntry* entry = find_in(rows, code)) return entry;
  }
  return nullptr;
}

std::string_view MessageTables::kind_of(std::string_view code) const {
  const CatalogEntry* entry = find(code);
  return entry == nullptr ? std::string_view() : entry->kind;
}

const CatalogEntry* MessageTables::of_kind(std::string_view kind) const {
  if (kind.empty()) return nullptr;
  for (const std::span<const CatalogEntry> rows : tables_) {
    const auto found = std::ranges::find(rows, kind, &CatalogEntry::kind);
    if (found != rows.end()) return &*found;
  }
  return nullptr;
}

std::vector<const CatalogEntry*> MessageTables::all() const {
  std::vector<const CatalogEntry*> rows;
  for (const std::span<const CatalogEntry> table : tables_)
    for (const CatalogEntry& row : table) rows.push_back(&row);
  std::ranges::sort(rows, {}, [](const CatalogEntry* row) { return row->code; });
  return rows;
}

std::string explain_page(const CatalogEntry& entry) {
  std::string title(entry.headline);
  for (std::size_t at = title.find(kPlace); at != std::string::npos; at = title.find(kPlace)) {
    title.replace(at, kPlace.size(), "...");
  }
  // The text of the page starts with a line break, which follows its opening quote in the source.
  return std::string(entry.code) + ": " + title + '\n' + std::string(entry.page);
}

Headline Headline::own(KnownCode code, std::string sentence) {
  Headline out;
  out.row_ = &code.row();
  out.text_ = std::move(sentence);
  return out;
}

Headline Headline::of(const CatalogEntry& row, std::span<const std::string> arguments) {
  const std::size_t asked = row.argument_count();
  if (asked != arguments.size()) {
    throw ArgumentError("The headline of " + std::string(row.code) + " takes " +
                        std::to_string(asked) + " arguments, and " +
                        std::to_string(arguments.size()) + " are given.");
  }
  return {row, arguments};
}

Headline::Headline(const CatalogEntry& row, std::span<const std::string> arguments) : row_(&row) {
  std::string_view rest = row.headline;
  for (const std::string& argument : arguments) {
    const std::size_t at = rest.find(kPlace);
    text_.append(rest.substr(0, at)).append(argument);
    rest.remove_prefix(at + kPlace.size());
  }
  text_.append(rest);
}

Diagnostic make_diagnostic(const Headline& headline, Span span) {
  assert(headline.row() != nullptr && "a message has a headline");
  Diagnostic out;
  out.code = headline.row()->code;
  out.severity = out.code.starts_with('W') ? Severity::kAdvice : Severity::kError;
  out.message = headline.text();
  out.mark.span = span;
  return out;
}

}  // namespace armlet
