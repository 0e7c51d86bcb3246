#pragma once
// The structs and enums of all files.

#include <map>
#include <set>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "check/scopes/declared.hpp"

namespace armlet::lang {

class Earlier;

class Structs {
 public:
  void add(const StructDecl& structure);
  explicit Structs(Earlier& earlier) : earlier_(earlier) {}

  // The declaration of a struct; null if the type is not a struct of the program.
  [[nodiscard]] const StructDecl* find(const Type* type);

  // Sets the file that declares a struct or an enum; it is null for other types.
  void set_home(const Type* type, Checker& file) { homes_[type] = &file; }
  [[nodiscard]] Checker* home(const Type* type) const;

  // The index of a name among the fields of a struct or the values of an enum; -1 if it is none.
  [[nodiscard]] int field_index(const RecordInfo& record, std::string_view name);
  [[nodiscard]] int value_index(const EnumInfo& enumeration, std::string_view name);

  // The function that returns the name of a value, or all values, of an enum with many values; null
  // until it is made.
  [[nodiscard]] hir::Function*& name_function(const EnumInfo& info) { return enum_names_[&info]; }
  [[nodiscard]] hir::Function*& values_function(const EnumInfo& info) {
    return enum_values_[&info];
  }

  // Notes an element type of lists whose elements have no first value.
  void add_unset(const Type* element) { unset_.insert(element); }
  [[nodiscard]] std::vector<const Type*> unset() const { return {unset_.begin(), unset_.end()}; }

 private:
  using Places = std::unordered_map<std::string_view, int>;

  Earlier& earlier_;
  std::map<const RecordInfo*, StructDecl> structs_;
  std::map<const Type*, Checker*> homes_;
  std::unordered_map<const void*, Places> places_;  // by record or enum with many names
  std::unordered_map<const EnumInfo*, hir::Function*> enum_names_;
  std::unordered_map<const EnumInfo*, hir::Function*> enum_values_;
  std::set<const Type*> unset_;
};

}  // namespace armlet::lang
