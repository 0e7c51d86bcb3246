#pragma once
// What the checker finds out about a text, noted while it checks: for editors. A check that
// compiles has none of this (Shared::learnt is null), and pays one comparison for each note.

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "ast/ast.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

class Learnt {
 public:
  // An expression and its type. One in a function that is generic by use is noted for each form of
  // the function.
  struct Value {
    const ast::Expr* written;
    const Type* type;
  };
  // A name, and where the declaration stands that it refers to.
  struct Use {
    Span name;
    Span declaration;
  };
  // A name of a function of the library, or of a setting: one of its parameters.
  struct NativeUse {
    Span name;
    const NativeFunction* function;
    int parameter = -1;  // -1: the function itself
  };

  // Guessing: what the text does not say yet counts as what it most likely becomes. Nobody may read
  // the messages of such a check.
  explicit Learnt(bool guesses = false) : guesses_(guesses) {}
  [[nodiscard]] bool guesses() const { return guesses_; }
  // A check that does not guess has left out something that one that guesses would teach.
  void leave_out() { leaves_out_ = true; }
  [[nodiscard]] bool leaves_out() const { return leaves_out_; }

  void value(const ast::Expr& written, const hir::Expr& checked) {
    values_.push_back({&written, checked.type});
    if (guesses_) met_.insert(&written);
  }
  // While guessing: whether it has been noted.
  [[nodiscard]] bool has_met(const ast::Expr& written) const { return met_.contains(&written); }
  // A variable of the text; its type and the other properties are read when all is checked.
  void variable(const hir::Variable& variable) { variables_.push_back(&variable); }
  void constant(Span declaration, std::optional<Constant> value) {
    if (value) constants_.insert_or_assign(key(declaration), *std::move(value));
  }
  // What a function of the text gives, for the types of the first call of which it is known.
  void result(Span declaration, const Type* type) {
    const Type*& known = results_[key(declaration)];
    if (known == nullptr || known->is(Kind::kAny)) known = type;
  }
  // `name` may have a module in front of it, and may be empty or another text, where a call leaves
  // out what it means.
  void use(Span name, Span declaration) { uses_.push_back({name, declaration}); }
  void native(NativeUse use) { natives_.push_back(use); }
  void enumeration(const EnumInfo& type, const ast::EnumStmt& node) { enums_[&type] = &node; }
  void structure(const ast::StructStmt& node, const Type* type) { structs_[&node] = type; }
  [[nodiscard]] const Type* structure_of(const ast::StructStmt& node) const {
    const auto found = structs_.find(&node);
    return found == structs_.end() ? nullptr : found->second;
  }
  // Where a value of an enum is declared; empty: in no text.
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
