#include "vocabulary/registry.hpp"

#include <algorithm>
#include <functional>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/resource.hpp"
#include "base/foreign_words.hpp"
#include "vocabulary/foreign_names.hpp"
#include "vocabulary/union_rows.hpp"

namespace armlet::lang {
namespace {

template <class Map>
auto find_or(const Map& map, std::string_view name, typename Map::mapped_type otherwise) {
  const auto found = map.find(name);
  return found == map.end() ? otherwise : found->second;
}

}  // namespace

Registry::Registry(const LanguageFunctions& language) : language_(language) {
  describe_errors();
  add_foreign_names(kForeignNames);
  for (const ForeignWord& word : kForeignWords) {
    if (word.alone) foreign_[{ForeignKind::kName, word.found}] = {word.found, word.meant};
  }
}

void Registry::add_foreign_names(std::span<const ForeignName> rows) {
  for (const ForeignName& row : rows) {
    if (!foreign_.try_emplace({row.kind, row.foreign}, row).second)
      throw ArgumentError("What `" + std::string(row.foreign) + "` stands for is known already.");
  }
}

const ForeignName* Registry::foreign(std::string_view word, ForeignKind kind) const {
  const auto found = foreign_.find({kind, word});
  return found == foreign_.end() ? nullptr : &found->second;
}

void Registry::describe_errors() {
  std::string fields = "message: string, kind: string, line: int, ";
  for (const auto& [name, type] : types_) {
    if (type->resource != nullptr) fields += name + ": string, ";
  }
  add_record("error", fields + "time: time");
}

// A row whose C++ functions are fewer or more than its choices stays as it is: a signature with a
// union is reported as a mistake.
std::vector<const NativeFunction*> Registry::functions_of(const NativeFunction& row) {
  if (!has_union(row.signature)) return {&row};
  std::vector<std::string> signatures = signatures_of(row.signature);
  if (!row.alternatives.empty() && row.alternatives.size() != signatures.size()) return {&row};
  std::vector<const NativeFunction*> all;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    const std::string& signature = signatures_.emplace_back(std::move(signatures[i]));
    all.push_back(&defined_.emplace_back(choice_of(row, i, signature)));
  }
  return all;
}

const NativeFunction* Registry::add_functions(std::span<const NativeFunction> functions) {
  const auto overloads_of = [this](const NativeFunction& function) -> auto& {
    return function.event == BlockEvent::kNone
               ? functions_[function.name]
               : at_events_[static_cast<std::size_t>(function.event)];
  };
  std::vector<const NativeFunction*> all;
  for (const NativeFunction& row : functions) {
    const std::vector<const NativeFunction*> choices = functions_of(row);
    all.insert(all.end(), choices.begin(), choices.end());
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const NativeFunction* function = all[i];
    std::vector<const NativeFunction*>& overloads = overloads_of(*function);
    const bool is_there = std::ranges::any_of(overloads, [&](const NativeFunction* other) {
      return other->signature == function->signature;
    });
    if (!is_there) {
      overloads.push_back(function);
      continue;
    }
    while (i-- > 0) {
      std::vector<const NativeFunction*>& added = overloads_of(*all[i]);
      added.pop_back();
      if (added.empty() && all[i]->event == BlockEvent::kNone) functions_.erase(all[i]->name);
    }
    return function;
  }
  return nullptr;
}

bool Registry::only_gives(const NativeFunction& function) const {
  if (function.acts || function.commands || function.pauses || function.starts ||
      function.timed != nullptr)
    return false;
  return std::ranges::any_of(values_, [&](std::span<const NativeFunction> functions) {
    const std::less<const NativeFunction*> before;
    return !functions.empty() && !before(&row_of(function), functions.data()) &&
           !before(&functions.back(), &row_of(function));
  });
}

std::span<const NativeFunction> Registry::keep(const NativeFunction& function,
                                               std::shared_ptr<const void> needs) {
  keep(std::move(needs));
  return {&defined_.emplace_back(function), 1};
}

void Registry::add_constant(const NativeConstant& constant) {
  constants_[constant.name] = &constant;
}

void Registry::add_type(const HostType& type) {
  library_types_.reset();
  types_[std::string(type.name)] = &type;
  if (type.resource != nullptr) describe_errors();
}

void Registry::take_back_type(std::string_view name) {
  types_.erase(types_.find(name));
  describe_errors();
}

void Registry::add_record(std::string_view name, std::string_view fields) {
  library_types_.reset();
  records_[std::string(name)] = fields;
}

std::span<const NativeFunction* const> Registry::functions(std::string_view name) const {
  const auto found = functions_.find(name);
  if (found == functions_.end()) return {};
  return found->second;
}

const NativeConstant* Registry::constant(std::string_view name) const {
  return find_or(constants_, name, nullptr);
}

std::string what_takes_time(const Registry& registry) {
  std::vector<std::string_view> acts;
  for (const auto& [name, type] : registry.types()) {
    if (type->resource != nullptr) acts.push_back(type->resource->act);
  }
  std::string out = "wait";
  for (std::size_t i = 0; i < acts.size(); ++i)
    out.append(i + 1 < acts.size() ? ", " : " or ").append(acts[i]);
  return out;
}

// The name of a host type may be written with a capital letter, as in classic programs, if a
// function of that name makes its values.
const HostType* Registry::type(std::string_view name) const {
  const bool is_classic = !name.empty() && name[0] >= 'A' && name[0] <= 'Z' &&
                          !types_.contains(name) && functions_.contains(name);
  if (!is_classic) return find_or(types_, name, nullptr);
  std::string small(name);
  small[0] = static_cast<char>(small[0] - 'A' + 'a');
  return find_or(types_, small, nullptr);
}

std::vector<std::string_view> Registry::public_names() const {
  std::vector<std::string_view> names;
  const auto add = [&names](const auto& entry) {
    if (is_written(entry.first)) names.push_back(entry.first);
  };
  std::ranges::for_each(functions_, add);
  std::ranges::for_each(constants_, add);
  std::ranges::sort(names);
  // clang 14 cannot compile std::ranges::unique of g++ 12.
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool Registry::has_named_rows(std::string_view type) const {
  const std::string prefix = std::string(type) + '.';
  for (auto at = functions_.lower_bound(prefix);
       at != functions_.end() && at->first.starts_with(prefix); ++at) {
    if (at->first.ends_with(kNamedRow)) return true;
  }
  return false;
}

bool Registry::is_namespace(std::string_view name) const {
  const std::string prefix = std::string(name) + '.';
  const auto starts = [&prefix](const auto& map) {
    const auto at = map.lower_bound(prefix);
    return at != map.end() && at->first.starts_with(prefix);
  };
  return type(name) == nullptr && (starts(functions_) || starts(constants_));
}

TypeNames Registry::type_names(TypePool& types) const {
  return [this, &types](std::string_view name) -> const Type* {
    if (const HostType* host = type(name)) return types.host(host);
    return types.library_record(name);
  };
}

std::shared_ptr<const TypePool> Registry::library_types() const {
  const std::lock_guard one_thread(making_types_);
  if (library_types_ == nullptr) {
    auto types = std::make_shared<TypePool>();
    declare_records(*types);
    // The list types of host types are made here, so that all sessions share them.
    for (const auto& [name, type] : types_) static_cast<void>(types->list(types->host(type)));
    types->close();
    library_types_ = std::move(types);
  }
  return library_types_;
}

void Registry::declare_records(TypePool& types) const {
  std::vector<const Type*> made;
  for (const auto& [name, fields] : records_) {
    made.push_back(types.new_record(name));
    types.register_library_record(made.back());
  }
  // The fields are parsed after all records are known, because a record may contain another one.
  std::size_t i = 0;
  std::string error;
  for (const auto& [name, fields] : records_) {
    if (auto read = parse_fields(fields, types, type_names(types), error)) {
      made[i]->record->fields = std::move(*read);
    }
    ++i;
  }
}

}  // namespace armlet::lang
