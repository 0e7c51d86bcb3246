#pragma once
// Results of a check for editors: types, uses of names, parameters. A check before compilation has
// none of this (Shared::learnt is null); each note then costs one comparison.

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ast/ast.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

class Learnt {
 public:
  // An expression and its type. In a function without declared parameter types there is one for
  // each form of the function.
  struct Value {
    const ast::Expr* written;
    const Type* type;
  };
  // A name, and the declaration that it refers to.
  struct Use {
    Span name;
    Span declaration;
  };
  // A name of a library function, of one of its parameters, or of a setting.
  struct NativeUse {
    Span name;
    const NativeFunction* function;
    int parameter = -1;  // -1: the function itself
  };

  // A check with guesses assumes the most likely types for incomplete parts of the text. Its
  // messages are not shown.
  explicit Learnt(bool guesses = false) : guesses_(guesses) {}
  [[nodiscard]] bool guesses() const { return guesses_; }
  // Notes that this check omitted results that a check with guesses would find.
  void leave_out() { leaves_out_ = true; }
  [[nodiscard]] bool leaves_out() const { return leaves_out_; }

  void value(const ast::Expr& written, const hir::Expr& checked) {
    values_.push_back({&written, checked.type});
    if (guesses_) met_.insert(&written);
  }
  // During guessing: whether the expression has been noted.
  [[nodiscard]] bool has_met(const ast::Expr& written) const { return met_.contains(&written); }
  // Notes a variable of the program. Its type and its other properties are read after the check.
  void variable(const hir::Variable& variable) { variables_.push_back(&variable); }
  void constant(Span declaration, std::optional<Constant> value) {
    if (value) constants_.insert_or_assign(key(declaration), *std::move(value));
  }
  // Notes the result type of a script function for the first call for which it is known.
  void result(Span declaration, const Type* type) {
    const Type*& known = results_[key(declaration)];
    if (known == nullptr || known->is(Kind::kAny)) known = type;
  }
  // Notes a use. `name` may include a module; it may be empty or another text if a call omits the
  // name.
  void use(Span name, Span declaration) { uses_.push_back({name, declaration}); }
  void native(NativeUse use) { natives_.push_back(use); }
  void enumeration(const EnumInfo& type, const ast::EnumStmt& node) { enums_[&type] = &node; }
  void structure(const ast::StructStmt& node, const Type* type) { structs_[&node] = type; }
  [[nodiscard]] const Type* structure_of(const ast::StructStmt& node) const {
    const auto found = structs_.find(&node);
    return found == structs_.end() ? nullptr : found->second;
  }
  // The declaration of an enum value; empty if it is not in a text.
  [[nodiscard]] Span value_of(const EnumInfo& type, std::size_t index) const {
    const auto found = enums_.find(&type);
    return found == enums_.end() ? Span{} : found->second->values[index].span;
  }

  [[nodiscard]] const std::vector<Value>& values() const { return values_; }
  [[nodiscard]] const std::vector<const hir::Variable*>& variables() const { return variables_; }
  [[nodiscard]] const std::vector<Use>& uses() const { return uses_; }
  [[nodiscard]] const std::vector<NativeUse>& natives() const { return natives_; }
  [[nodiscard]] const Constant* constant_at(Span declaration) const {
    const auto found = constants_.find(key(declaration));
    return found == constants_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] const Type* result_of(Span declaration) const {
    const auto found = results_.find(key(declaration));
    return found == results_.end() ? nullptr : found->second;
  }

 private:
  static std::uint64_t key(Span at) { return std::uint64_t{at.source} << 32U | at.begin; }

  bool guesses_;
  bool leaves_out_ = false;
  std::vector<Value> values_;
  std::unordered_set<const ast::Expr*> met_;
  std::vector<const hir::Variable*> variables_;
  std::vector<Use> uses_;
  std::vector<NativeUse> natives_;
  std::unordered_map<std::uint64_t, Constant> constants_;
  std::unordered_map<std::uint64_t, const Type*> results_;
  std::unordered_map<const ast::StructStmt*, const Type*> structs_;
  std::unordered_map<const EnumInfo*, const ast::EnumStmt*> enums_;
};

}  // namespace armlet::lang
