#pragma once
// The names that one file declares or imports. They point into its text.

#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "check/scopes/declared.hpp"

namespace armlet::lang {

class Earlier;
struct KeptFile;
struct KeptName;

class Names {
 public:
  // From now on names that this file does not declare stand for what they stand for there.
  void follow(const KeptFile& kept, Earlier& earlier);
  // What a name stood for in the entries before; null: nothing, or this file declares a function, a
  // type or an import of that name.
  [[nodiscard]] const KeptName* find_earlier(std::string_view name) const;
  // Everything that had a name there.
  [[nodiscard]] std::vector<const KeptName*> all_earlier() const;

  // The import of that name, and whether it is this one: the first of a name stays.
  std::pair<const Import*, bool> add_import(std::string_view name, const Import& import);
  [[nodiscard]] const Import* find_import(std::string_view name) const;
  // Of this file alone.
  [[nodiscard]] const Import* own_import(std::string_view name) const;
  [[nodiscard]] const FunctionDecl* own_function(std::string_view name) const;
  [[nodiscard]] const std::map<std::string_view, Import>& imports() const { return imports_; }

  // The name must be free among functions.
  FunctionDecl& add_function(const ast::FunctionStmt& node, Checker& file);
  [[nodiscard]] FunctionDecl* find_function(std::string_view name);
  [[nodiscard]] const FunctionDecl* find_function(std::string_view name) const;
  [[nodiscard]] std::map<std::string_view, FunctionDecl>& functions() { return functions_; }
  [[nodiscard]] const std::map<std::string_view, FunctionDecl>& functions() const {
    return functions_;
  }

  [[nodiscard]] const std::map<std::string_view, std::vector<std::string_view>>& ambient() const {
    return ambient_;
  }

  // A struct or an enum; false if another one has the name.
  bool add_type(const ast::Name& name, const Type* type);
  [[nodiscard]] const Type* find_type(std::string_view name) const;
  [[nodiscard]] const std::map<std::string_view, const Type*>& types() const { return types_; }

  // A variable of the top level, wherever it stands; false if another one has the name.
  bool add_variable(const ast::Name& name);
  [[nodiscard]] const Span* find_variable(std::string_view name) const;  // where it is declared

  // A variable of the top level that calls may leave out, such as a ambient value.
  void add_ambient(std::string_view type, std::string_view name);
  [[nodiscard]] std::span<const std::string_view> ambient(std::string_view type) const;

  // Names of variables that some statement of the text changes.
  void set_changed(std::set<std::string_view> names) { changed_ = std::move(names); }
  [[nodiscard]] bool is_changed(std::string_view name) const { return changed_.contains(name); }

  // Where a variable, function or type of the top level is declared; empty: there is none.
  [[nodiscard]] Span declaration_of(std::string_view name) const;
  // Variables, functions and types of the top level.
  [[nodiscard]] std::vector<std::string_view> all() const;

 private:
  std::map<std::string_view, Import> imports_;
  std::map<std::string_view, FunctionDecl> functions_;
  std::map<std::string_view, const Type*> types_;
  std::map<std::string_view, Span> type_spans_;  // where they are declared
  std::map<std::string_view, Span> variables_;
  std::map<std::string_view, std::vector<std::string_view>> ambient_;  // by type
  std::set<std::string_view> changed_;
  const KeptFile* kept_ = nullptr;
  Earlier* earlier_ = nullptr;
};

}  // namespace armlet::lang
