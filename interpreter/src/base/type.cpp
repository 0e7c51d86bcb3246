#include "armlet/interpreter/type.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "armlet/interpreter/object.hpp"
#include "base/persistent_map.hpp"

namespace armlet {
namespace {

template <class Range, class Proj>
int index_by(const Range& range, std::string_view name, Proj projection) {
  const auto found = std::ranges::find(range, name, projection);
  return found == range.end() ? -1 : static_cast<int>(found - range.begin());
}

std::string function_name(const Type* type) {
  std::string out = "fn(";
  for (std::size_t i = 0; i < type->parameters.size(); ++i) {
    if (i > 0) out += ", ";
    out += type_name(type->parameters[i]);
  }
  out += ')';
  if (type->result != nullptr && !type->result->is(Kind::kVoid)) {
    out += " -> " + type_name(type->result);
  }
  return out;
}

// The name of an element type in a list type. Function types need parentheses, because fn() ->
// double[] is a function that returns a list.
std::string element_name(const Type* type) {
  const std::string name = type_name(type->element);
  return type->element->is(Kind::kFunction) ? '(' + name + ')' : name;
}

std::size_t hash_of(const Type& type) {
  std::size_t hash = static_cast<std::size_t>(type.kind);
  const auto add = [&hash](std::size_t part) { hash = (hash ^ part) * 0x9E37'79B9'7F4A'7C15ULL; };
  const auto add_address = [&add](const void* address) { add(std::hash<const void*>()(address)); };
  for (const int exponent : {type.dim.length, type.dim.mass, type.dim.time, type.dim.angle})
    add(static_cast<std::size_t>(exponent));
  add_address(type.element);
  add_address(type.key);
  add_address(type.record);
  add_address(type.enumeration);
  add_address(type.host);
  for (const Type* parameter : type.parameters) add_address(parameter);
  add_address(type.result);
  return hash;
}

bool same(const Type& a, const Type& b) {
  return a.kind == b.kind && a.dim == b.dim && a.element == b.element && a.key == b.key &&
         a.record == b.record && a.enumeration == b.enumeration && a.host == b.host &&
         a.parameters == b.parameters && a.result == b.result;
}

std::uint64_t hash_of_fields(const std::vector<RecordField>& fields) {
  std::uint64_t hash = fields.size();
  for (const RecordField& field : fields)
    hash = ((hash ^ lang::key_of(field.name)) * 31 ^ lang::key_of(field.type)) *
           0x9E37'79B9'7F4A'7C15ULL;
  return hash;
}

bool have_same_fields(const std::vector<RecordField>& a, const std::vector<RecordField>& b) {
  return std::ranges::equal(a, b, [](const RecordField& one, const RecordField& other) {
    return one.name == other.name && one.type == other.type;
  });
}

}  // namespace

int RecordInfo::index_of(std::string_view field) const {
  return index_by(fields, field, [](const RecordField& f) -> std::string_view { return f.name; });
}

int EnumInfo::index_of(std::string_view value) const {
  return index_by(values, value, [](const std::string& v) -> std::string_view { return v; });
}

bool Type::is_reference() const {
  switch (kind) {
    case Kind::kText:
    case Kind::kList:
    case Kind::kMap:
    case Kind::kMatrix:
    case Kind::kRecord:
    case Kind::kFunction:
    case Kind::kHost:
      return true;
    case Kind::kAny:
    case Kind::kVoid:
    case Kind::kBool:
    case Kind::kInt:
    case Kind::kReal:
    case Kind::kEnum:
      return false;
  }
  return false;
}

std::string type_name(const Type* type) {
  if (type == nullptr) return "any";
  switch (type->kind) {
    case Kind::kAny:
      return "any";
    case Kind::kVoid:
      return "void";
    case Kind::kBool:
      return "bool";
    case Kind::kInt:
      return "int";
    case Kind::kReal:
      return type->dim.is_none() ? "double" : dimension_name(type->dim);
    case Kind::kText:
      return "string";
    case Kind::kMatrix:
      return "matrix";
    case Kind::kList:
      return element_name(type) + "[]";
    case Kind::kMap:
      return element_name(type) + '[' + type_name(type->key) + ']';
    case Kind::kRecord:
      return type->record->name;
    case Kind::kEnum:
      return type->enumeration->name;
    case Kind::kFunction:
      return function_name(type);
    case Kind::kHost:
      return std::string(type->host->name);
  }
  return "any";
}

std::string_view article(std::string_view word) {
  constexpr std::string_view kVowels = "aeiouAEIOU";
  return !word.empty() && kVowels.find(word[0]) != std::string_view::npos ? "an" : "a";
}

std::string type_phrase(const Type* type) {
  if (type == nullptr || type->is(Kind::kAny)) return "any value";
  if (type->is(Kind::kVoid)) return "no value";
  if (type->is_quantity()) return dimension_phrase(type->dim);
  const std::string name = type_name(type);
  return std::string(article(name)) + ' ' + name;
}

// The types that earlier pools of the session have made.
struct TypePool::Earlier {
  using Bucket = std::vector<const Type*>;

  lang::PersistentMap<Bucket> interned;      // by hash_of
  lang::PersistentMap<Bucket> tables;        // by hash_of_fields of their rows
  lang::PersistentMap<Bucket> made_records;  // by name

  static void add(lang::PersistentMap<Bucket>& map, std::uint64_t key, const Type* type) {
    const Bucket* known = map.find(key);
    Bucket longer = known != nullptr ? *known : Bucket();
    longer.push_back(type);
    map.set(key, std::move(longer));
  }
  static const Bucket& find(const lang::PersistentMap<Bucket>& map, std::uint64_t key) {
    static const Bucket none;
    const Bucket* known = map.find(key);
    return known != nullptr ? *known : none;
  }
};

TypePool::TypePool() : library_records_(std::make_shared<RecordsByName>()) { name_basic_types(); }

TypePool::TypePool(const TypePool* before)
    : earlier_(before->earlier_),
      library_records_(before->library_records_),
      any_(before->any_),
      void_(before->void_),
      bool_(before->bool_),
      int_(before->int_),
      real_(before->real_),
      text_(before->text_),
      matrix_(before->matrix_) {}

TypePool::~TypePool() = default;

void TypePool::name_basic_types() {
  any_ = intern({.kind = Kind::kAny});
  void_ = intern({.kind = Kind::kVoid});
  bool_ = intern({.kind = Kind::kBool});
  int_ = intern({.kind = Kind::kInt});
  real_ = intern({.kind = Kind::kReal});
  text_ = intern({.kind = Kind::kText});
  matrix_ = intern({.kind = Kind::kMatrix});
}

void TypePool::close() {
  if (earlier_ != nullptr && interned_.empty() && tables_.empty() && made_records_.empty()) return;
  auto all =
      earlier_ != nullptr ? std::make_shared<Earlier>(*earlier_) : std::make_shared<Earlier>();
  for (const auto& [hash, type] : interned_) Earlier::add(all->interned, hash, type);
  for (const auto& [columns, table] : tables_)
    Earlier::add(all->tables, hash_of_fields(table->record->row->record->fields), table);
  for (const Type* record : made_records_)
    Earlier::add(all->made_records, lang::key_of(record->record->name), record);
  earlier_ = std::move(all);
}

const Type* TypePool::quantity(Dim dim) { return intern({.kind = Kind::kReal, .dim = dim}); }

const Type* TypePool::list(const Type* element) {
  return intern({.kind = Kind::kList, .element = element});
}

const Type* TypePool::map(const Type* key, const Type* element) {
  return intern({.kind = Kind::kMap, .element = element, .key = key});
}

const Type* TypePool::function(std::vector<const Type*> parameters, const Type* result) {
  return intern({.kind = Kind::kFunction, .parameters = std::move(parameters), .result = result});
}

const Type* TypePool::host(const HostType* host) {
  return intern({.kind = Kind::kHost, .host = host});
}

const Type* TypePool::new_record(std::string name) {
  RecordInfo& info = records_.emplace_back();
  info.name = std::move(name);
  return &types_.emplace_back(Type{.kind = Kind::kRecord, .record = &info});
}

const Type* TypePool::table(std::vector<RecordField> row) {
  if (earlier_ != nullptr) {
    for (const Type* table : Earlier::find(earlier_->tables, hash_of_fields(row))) {
      if (have_same_fields(table->record->row->record->fields, row)) return table;
    }
  }
  Columns columns;
  for (const RecordField& field : row) columns.emplace_back(field.name, field.type);
  const Type*& known = tables_[std::move(columns)];
  if (known == nullptr) known = new_table(std::move(row));
  return known;
}

const Type* TypePool::new_table(std::vector<RecordField> row) {
  const Type* table = new_record("table");
  const Type* row_type = new_record("row");
  for (const RecordField& field : row) {
    const bool is_numbers = field.type->is(Kind::kList) && field.type->element->is_number();
    table->record->fields.push_back(
        {.name = field.name, .type = is_numbers ? matrix() : list(field.type)});
  }
  row_type->record->fields = std::move(row);
  row_type->record->table = table;
  table->record->row = row_type;
  return table;
}

const Type* TypePool::open_table() {
  const Type* table = new_record("table");
  table->record->row = new_record("row");
  tables_of_[table->record].push_back(&*std::prev(types_.end(), 2));
  return table;
}

void TypePool::join_tables(const Type* a, const Type* b) {
  while (a->is(Kind::kList) && b->is(Kind::kList)) {
    a = a->element;
    b = b->element;
  }
  if (!a->is_table() || !b->is_table()) return;
  if (!a->is_open_table()) std::swap(a, b);
  if (!a->is_open_table() || b->record == a->record) return;
  // Of two tables whose columns are not known yet, the one with fewer types is changed.
  if (b->is_open_table() && tables_of_[a->record].size() > tables_of_[b->record].size())
    std::swap(a, b);
  RecordInfo* const joined = b->record;
  const std::vector<Type*> moved = std::exchange(tables_of_[a->record], {});
  std::vector<Type*>& there = tables_of_[joined];
  for (Type* type : moved) {
    type->record = joined;
    there.push_back(type);
  }
}

const Type* TypePool::new_enum(std::string name, std::vector<std::string> values) {
  const EnumInfo& info = enums_.emplace_back(EnumInfo{std::move(name), std::move(values)});
  return &types_.emplace_back(Type{.kind = Kind::kEnum, .enumeration = &info});
}

const Type* TypePool::record_of(std::string_view name, std::vector<RecordField> fields) {
  const auto is_same = [&](const Type* known) {
    return known->record->name == name && have_same_fields(known->record->fields, fields);
  };
  if (earlier_ != nullptr) {
    const auto& known = Earlier::find(earlier_->made_records, lang::key_of(name));
    if (const auto at = std::ranges::find_if(known, is_same); at != known.end()) return *at;
  }
  if (const auto at = std::ranges::find_if(made_records_, is_same); at != made_records_.end())
    return *at;
  made_records_.push_back(new_record(std::string(name)));
  made_records_.back()->record->fields = std::move(fields);
  return made_records_.back();
}

const Type* TypePool::made_record(std::string_view name, const Type* of) const {
  const auto is_meant = [&](const Type* known) {
    const auto has = [of](const RecordField& field) {
      return field.type == of || (field.type->is(Kind::kList) && field.type->element == of) ||
             (field.type->is(Kind::kFunction) &&
              std::ranges::count(field.type->parameters, of) > 0);
    };
    return known->record->name == name && std::ranges::any_of(known->record->fields, has);
  };
  if (const auto at = std::ranges::find_if(made_records_, is_meant); at != made_records_.end())
    return *at;
  if (earlier_ == nullptr) return nullptr;
  const auto& known = Earlier::find(earlier_->made_records, lang::key_of(name));
  const auto at = std::ranges::find_if(known, is_meant);
  return at != known.end() ? *at : nullptr;
}

const Type* TypePool::library_record(std::string_view name) const {
  const auto found = library_records_->find(name);
  return found == library_records_->end() ? nullptr : found->second;
}

void TypePool::register_library_record(const Type* record) {
  auto longer = std::make_shared<RecordsByName>(*library_records_);
  longer->emplace(record->record->name, record);
  library_records_ = std::move(longer);
}

const Type* TypePool::find(std::size_t hash, const Type& type) const {
  if (earlier_ != nullptr) {
    for (const Type* known : Earlier::find(earlier_->interned, hash)) {
      if (same(*known, type)) return known;
    }
  }
  const auto [first, last] = interned_.equal_range(hash);
  for (auto known = first; known != last; ++known) {
    if (same(*known->second, type)) return known->second;
  }
  return nullptr;
}

const Type* TypePool::intern(Type type) {
  const std::size_t hash = hash_of(type);
  if (const Type* known = find(hash, type)) return known;
  const Type* made = &types_.emplace_back(std::move(type));
  interned_.emplace(hash, made);
  return made;
}

}  // namespace armlet
