#pragma once
// Types of the language (reference, section 5). Types are interned: equal types are one object,
// compared by address.

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "armlet/interpreter/unit.hpp"

namespace armlet {

struct HostType;

enum class Kind : std::uint8_t {
  // The type of a value with a mistake; fits everywhere, so that one mistake causes one message.
  kAny,
  kVoid,
  kBool,
  kInt,
  kReal,  // double (dim none) and every quantity
  kText,
  kList,
  kMap,
  kMatrix,
  kRecord,  // struct types, and records of the library such as Move
  kEnum,
  kFunction,
  kHost,  // values and handles that the host defines
};

struct Type;

struct RecordField {
  std::string name;
  const Type* type = nullptr;
  bool has_default = false;
};

struct RecordInfo {
  std::string name;
  std::vector<RecordField> fields;
  const Type* row = nullptr;    // of a table, whose fields are its columns: the type of its rows
  const Type* table = nullptr;  // of a row: the type of its table
  [[nodiscard]] int index_of(std::string_view field) const;  // -1 if there is none
};

struct EnumInfo {
  std::string name;
  std::vector<std::string> values;
  [[nodiscard]] int index_of(std::string_view value) const;  // -1 if there is none
};

struct Type {
  Kind kind = Kind::kAny;
  Dim dim{};                              // kReal
  const Type* element = nullptr;          // kList; kMap: of the values
  const Type* key = nullptr;              // kMap
  RecordInfo* record = nullptr;           // kRecord; fields may be filled in after interning
  const EnumInfo* enumeration = nullptr;  // kEnum
  const HostType* host = nullptr;         // kHost
  std::vector<const Type*> parameters{};  // kFunction
  const Type* result = nullptr;           // kFunction

  [[nodiscard]] bool is(Kind k) const { return kind == k; }
  [[nodiscard]] bool is_double() const { return kind == Kind::kReal && dim.is_none(); }
  [[nodiscard]] bool is_table() const { return kind == Kind::kRecord && record->row != nullptr; }
  // Whether it is a table whose columns are not known yet; every other table has at least the
  // column t.
  [[nodiscard]] bool is_open_table() const { return is_table() && record->fields.empty(); }
  [[nodiscard]] bool is_quantity() const { return kind == Kind::kReal && !dim.is_none(); }
  [[nodiscard]] bool is_number() const { return kind == Kind::kReal || kind == Kind::kInt; }
  // Whether a slot has a counted reference to the value (text, lists, records ...) and not its
  // bits.
  [[nodiscard]] bool is_reference() const;
};

// The name of a type: "double[]", "length", "fn(double) -> double", "point".
[[nodiscard]] std::string type_name(const Type* type);
// The name with its article: "a double[]", "an int", "a length".
[[nodiscard]] std::string type_phrase(const Type* type);
// "a" or "an" for a word of the language.
[[nodiscard]] std::string_view article(std::string_view word);

// Owns and interns the types of one program. It includes the types of the pool before it, which is
// closed and must outlive it: the pool of the library, or of the entry before in a session.
class TypePool {
 public:
  TypePool();
  explicit TypePool(const TypePool* before);
  ~TypePool();
  TypePool(const TypePool&) = delete;
  TypePool& operator=(const TypePool&) = delete;

  const Type* any() const { return any_; }
  const Type* void_type() const { return void_; }
  const Type* boolean() const { return bool_; }
  const Type* integer() const { return int_; }
  const Type* real() const { return real_; }
  const Type* text() const { return text_; }
  const Type* matrix() const { return matrix_; }
  const Type* quantity(Dim dim);
  const Type* list(const Type* element);
  const Type* map(const Type* key, const Type* element);
  const Type* function(std::vector<const Type*> parameters, const Type* result);
  const Type* host(const HostType* host);
  // A new record or enum type, different from all others: these are compared by identity.
  const Type* new_record(std::string name);
  const Type* new_enum(std::string name, std::vector<std::string> values);
  // The table type whose rows have these fields; equal fields give the same type. A column is a
  // list; a column of lists of numbers is a matrix with one row for each sample.
  const Type* table(std::vector<RecordField> row);
  // The type of a declared `table`, whose columns are unknown until `join_tables` sets them.
  const Type* open_table();
  // For tables, or lists of tables: the one with unknown columns gets those of the other.
  void join_tables(const Type* a, const Type* b);
  // The record type with this name and these fields, made at the first call.
  const Type* record_of(std::string_view name, std::vector<RecordField> fields);
  // The type that `record_of` made with this name and a field of type `of`, of a list of it or of a
  // function that takes it; null if there is none.
  const Type* made_record(std::string_view name, const Type* of) const;
  // The record of the library with this name.
  const Type* library_record(std::string_view name) const;
  void register_library_record(const Type* record);
  // Ends the changes of this pool; later pools then include its types.
  void close();
  // Whether the pool has no types besides those of the pool before it.
  [[nodiscard]] bool adds_nothing() const { return types_.empty(); }

 private:
  using Columns = std::vector<std::pair<std::string, const Type*>>;
  using RecordsByName = std::unordered_map<std::string_view, const Type*>;
  const Type* intern(Type type);
  [[nodiscard]] const Type* find(std::size_t hash, const Type& type) const;
  const Type* new_table(std::vector<RecordField> row);
  void name_basic_types();

  struct Earlier;
  std::shared_ptr<const Earlier> earlier_;  // of the pools before; null: none
  std::list<Type> types_;
  std::unordered_multimap<std::size_t, const Type*> interned_;  // by their structure
  std::map<Columns, const Type*> tables_;                       // by the fields of their rows
  // The tables with unknown columns, and those whose columns were joined with them, by their
  // record.
  std::unordered_map<const RecordInfo*, std::vector<Type*>> tables_of_;
  std::list<RecordInfo> records_;
  std::list<EnumInfo> enums_;
  std::shared_ptr<const RecordsByName> library_records_;
  std::vector<const Type*> made_records_;  // by record_of
  const Type *any_, *void_, *bool_, *int_, *real_, *text_, *matrix_;
};

}  // namespace armlet
