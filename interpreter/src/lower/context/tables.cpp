#include "lower/context/tables.hpp"

#include "lower/context/emitter.hpp"

namespace armlet::lang {

namespace {

constexpr std::uint32_t kMostEntries = 0xFFFF;

// Adds an entry to `table` and returns its index.
template <class T>
std::uint32_t append(std::vector<T>& table, T entry, const char* what) {
  if (table.size() >= kMostEntries) throw TooLarge{{}, what, kMostEntries};
  table.push_back(std::move(entry));
  return static_cast<std::uint32_t>(table.size() - 1);
}

}  // namespace

std::uint32_t Tables::native(const NativeFunction* function) {
  const auto [known, is_new] = natives_.try_emplace(function);
  if (is_new) known->second = append(program_.natives, function, "library functions");
  return known->second;
}

std::uint32_t Tables::text(std::string_view text) {
  const auto known = texts_.find(text);
  if (known != texts_.end()) return known->second;
  const std::uint32_t index = append(program_.texts, std::string(text), "different texts");
  texts_.emplace(std::string(text), index);
  return index;
}

std::uint32_t Tables::layout(const Type* record) {
  const auto [known, is_new] = layouts_.try_emplace(record);
  if (!is_new) return known->second;
  std::vector<std::uint16_t> references;
  const auto& fields = record->record->fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i].type->is_reference()) references.push_back(static_cast<std::uint16_t>(i));
  }
  known->second =
      append(program_.layouts, RecordLayout{record, static_cast<std::uint16_t>(fields.size()), {}},
             "structs");
  program_.layout_references.push_back(std::move(references));
  return known->second;
}

std::uint32_t Tables::format(const Format& format) {
  const auto [known, is_new] =
      formats_.try_emplace(FormatKey{format.type, format.style, format.unit, format.factor});
  if (is_new) known->second = append(program_.formats, format, "formats");
  return known->second;
}

NotedStatements& Tables::noted() {
  if (program_.noted == nullptr) program_.noted = std::make_unique<NotedStatements>();
  return *program_.noted;
}

std::uint32_t Tables::add_assert(const hir::AssertStmt& statement) {
  return append(noted().asserts, AssertInfo{&statement, {}}, "assertions");
}

std::uint32_t Tables::add_expect(const hir::AssertThrowsStmt& statement) {
  return append(noted().expects, &statement, "assertions");
}

std::uint32_t Tables::add_wait(const hir::WaitUntilStmt& statement) {
  return append(noted().waits, &statement, "waits");
}

void Tables::finish() {
  for (std::size_t i = 0; i < program_.layouts.size(); ++i) {
    program_.layouts[i].references = program_.layout_references[i];
  }
}

}  // namespace armlet::lang
