#include "armlet/interpreter/catalog.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/diagnostic.hpp"

namespace armlet {
namespace {

#define ARMLET_MESSAGE(code, kind, headline, page) CatalogEntry{#code, kind, headline, page},

// The order is that of the codes.
// clang-format off
constexpr auto kCatalog = std::to_array<CatalogEntry>({
#include "catalog_text.def"
#include "catalog_names.def"
#include "catalog_types.def"
#include "catalog_units.def"
#include "catalog_robots.def"
#include "catalog_running.def"
#include "catalog_advice.def"
});
// clang-format on

#undef ARMLET_MESSAGE

static_assert(std::ranges::is_sorted(kCatalog, {}, &CatalogEntry::code),
              "rows stand in the order of their codes");

constexpr std::string_view kPlace = "{}";

}  // namespace

int CatalogEntry::argument_count() const {
  int count = 0;
  for (std::size_t at = headline.find(kPlace); at != std::string_view::npos;
       at = headline.find(kPlace, at + kPlace.size())) {
    ++count;
  }
  return count;
}

std::span<const CatalogEntry> catalog() { return kCatalog; }

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

const CatalogEntry* catalog_entry(std::string_view code) { return find_in(kCatalog, code); }

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

std::string explain_page(std::string_view code) {
  const CatalogEntry* entry = catalog_entry(code);
  if (entry == nullptr) return {};
  std::string title(entry->headline);
  for (std::size_t at = title.find(kPlace); at != std::string::npos; at = title.find(kPlace)) {
    title.replace(at, kPlace.size(), "...");
  }
  // The page starts with the line break behind its opening quote.
  return std::string(code) + ": " + title + '\n' + std::string(entry->page);
}

Diagnostic make_diagnostic(std::string_view code, Span span,
                           const std::vector<std::string>& arguments) {
  const CatalogEntry* entry = catalog_entry(code);
  if (entry == nullptr) throw std::logic_error("no message has the code " + std::string(code));
  return make_diagnostic(*entry, span, arguments);
}

Diagnostic make_diagnostic(const CatalogEntry& entry, Span span,
                           const std::vector<std::string>& arguments) {
  if (entry.argument_count() != static_cast<int>(arguments.size())) {
    throw std::logic_error("the message " + std::string(entry.code) + " takes " +
                           std::to_string(entry.argument_count()) + " arguments, not " +
                           std::to_string(arguments.size()));
  }
  Diagnostic out;
  out.code = entry.code;
  out.severity = entry.code.starts_with('W') ? Severity::kAdvice : Severity::kError;
  out.mark.span = span;
  std::string_view rest = entry.headline;
  for (const std::string& argument : arguments) {
    const std::size_t at = rest.find(kPlace);
    out.message.append(rest.substr(0, at)).append(argument);
    rest.remove_prefix(at + kPlace.size());
  }
  out.message.append(rest);
  return out;
}

}  // namespace armlet
