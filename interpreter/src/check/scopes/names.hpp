#pragma once
// The names that one file declares or imports. They refer to the text of the file.

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
  // Adds the names of an earlier entry: they apply where this file does not declare the same name.
  void follow(const KeptFile& kept, Earlier& earlier);
  // The meaning of a name in the earlier entries; null if it had none, or if this file declares a
  // function, a type or an import of that name.
  [[nodiscard]] const KeptName* find_earlier(std::string_view name) const;
  // All names of the earlier entries.
  [[nodiscard]] std::vector<const KeptName*> all_earlier() const;

  // Adds an import. Returns the import of that name, and whether it is the new one: the first of a
  // name stays.
  std::pair<const Import*, bool> add_import(std::string_view name, const Import& import);
  [[nodiscard]] const Import* find_import(std::string_view name) const;
  // The import of that name in this file, without earlier entries.
  [[nodiscard]] const Import* own_import(std::string_view name) const;
  [[nodiscard]] const FunctionDecl* own_function(std::string_view name) const;
  [[nodiscard]] const std::map<std::string_view, Import>& imports() const { return imports_; }

  // Adds a function. No other function may have its name.
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

  // Adds a struct or an enum; false if the name is taken.
  bool add_type(const ast::Name& name, const Type* type);
  [[nodiscard]] const Type* find_type(std::string_view name) const;
  [[nodiscard]] const std::map<std::string_view, const Type*>& types() const { return types_; }

  // Adds a variable of the top level, before its declaration is checked; false if the name is
  // taken.
  bool add_variable(const ast::Name& name);
  [[nodiscard]] const Span* find_variable(std::string_view name) const;  // its declaration

  // Adds a global variable with an ambient value, which calls may omit.
  void add_ambient(std::string_view type, std::string_view name);
  [[nodiscard]] std::span<const std::string_view> ambient(std::string_view type) const;

  // Sets the names of variables that the text changes.
  void set_changed(std::set<std::string_view> names) { changed_ = std::move(names); }
  [[nodiscard]] bool is_changed(std::string_view name) const { return changed_.contains(name); }

  // The declaration of a global variable, function or type; empty if there is none.
  [[nodiscard]] Span declaration_of(std::string_view name) const;
  // The names of all global variables, functions and types.
  [[nodiscard]] std::vector<std::string_view> all() const;

 private:
  std::map<std::string_view, Import> imports_;
  std::map<std::string_view, FunctionDecl> functions_;
  std::map<std::string_view, const Type*> types_;
  std::map<std::string_view, Span> type_spans_;  // of their declarations
  std::map<std::string_view, Span> variables_;
  std::map<std::string_view, std::vector<std::string_view>> ambient_;  // by type
  std::set<std::string_view> changed_;
  const KeptFile* kept_ = nullptr;
  Earlier* earlier_ = nullptr;
};

}  // namespace armlet::lang
