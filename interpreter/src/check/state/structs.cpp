#include "check/state/structs.hpp"

#include <algorithm>
#include <string>

#include "check/scopes/earlier.hpp"

namespace armlet::lang {
namespace {

constexpr std::size_t kManyNames = 16;  // with this many names a table is faster than a search

using Places = std::unordered_map<std::string_view, int>;

// The table of all names of a record or enum; null if there are few.
Places* table_for(std::unordered_map<const void*, Places>& tables, const void* key,
                  std::size_t names) {
  return names < kManyNames ? nullptr : &tables[key];
}

template <class Names, class Name>
int index_in(const Names& names, std::string_view name, Name name_of, Places* table) {
  if (table == nullptr) {
    const auto found = std::ranges::find(names, name, name_of);
    return found == names.end() ? -1 : static_cast<int>(found - names.begin());
  }
  if (table->size() != names.size()) {
    table->clear();
    for (std::size_t i = 0; i < names.size(); ++i)
      table->emplace(name_of(names[i]), static_cast<int>(i));
  }
  const auto found = table->find(name);
  return found == table->end() ? -1 : found->second;
}

}  // namespace

void Structs::add(const StructDecl& structure) { structs_[structure.type->record] = structure; }

const StructDecl* Structs::find(const Type* type) {
  if (!type->is(Kind::kRecord)) return nullptr;
  const auto found = structs_.find(type->record);
  if (found != structs_.end()) return &found->second;
  const KeptType* kept = earlier_.type(type->record);
  if (kept == nullptr) return nullptr;
  add({kept->node, &earlier_.file(*kept->file), type});
  return &structs_[type->record];
}

Checker* Structs::home(const Type* type) const {
  const auto found = homes_.find(type);
  if (found != homes_.end()) return found->second;
  const KeptType* kept = type->is(Kind::kRecord) ? earlier_.type(type->record)
                         : type->is(Kind::kEnum) ? earlier_.type(type->enumeration)
                                                 : nullptr;
  return kept != nullptr ? &earlier_.file(*kept->file) : nullptr;
}

int Structs::field_index(const RecordInfo& record, std::string_view name) {
  return index_in(
      record.fields, name, [](const RecordField& field) -> std::string_view { return field.name; },
      table_for(places_, &record, record.fields.size()));
}

int Structs::value_index(const EnumInfo& enumeration, std::string_view name) {
  return index_in(
      enumeration.values, name, [](const std::string& value) -> std::string_view { return value; },
      table_for(places_, &enumeration, enumeration.values.size()));
}

}  // namespace armlet::lang
