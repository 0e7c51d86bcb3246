#include "check/names/names.hpp"

#include <algorithm>

namespace armlet::lang {
namespace {

// What a map has for a name; null if nothing.
auto* value_in(auto& map, std::string_view name) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : &found->second;
}

}  // namespace

bool FunctionDecl::is_generic() const {
  return std::ranges::any_of(parameters, [](const Type* type) { return type == nullptr; });
}

std::pair<const Import*, bool> Names::add_import(std::string_view name, const Import& import) {
  const auto [first, is_new] = imports_.try_emplace(name, import);
  return {&first->second, is_new};
}

const Import* Names::find_import(std::string_view name) const { return value_in(imports_, name); }

FunctionDecl& Names::add_function(const ast::FunctionStmt& node, Checker& file) {
  FunctionDecl& function = functions_[node.name.text];
  function.node = &node;
  function.file = &file;
  return function;
}

FunctionDecl* Names::find_function(std::string_view name) { return value_in(functions_, name); }

const FunctionDecl* Names::find_function(std::string_view name) const {
  return value_in(functions_, name);
}

bool Names::add_type(const ast::Name& name, const Type* type) {
  if (!types_.emplace(name.text, type).second) return false;
  type_spans_[name.text] = name.span;
  return true;
}

const Type* Names::find_type(std::string_view name) const {
  const auto* type = value_in(types_, name);
  return type == nullptr ? nullptr : *type;
}

bool Names::add_variable(const ast::Name& name) {
  return variables_.emplace(name.text, name.span).second;
}

const Span* Names::find_variable(std::string_view name) const { return value_in(variables_, name); }

void Names::add_ambient(std::string_view type, std::string_view name) {
  ambient_[type].push_back(name);
}

std::span<const std::string_view> Names::ambient(std::string_view type) const {
  const auto* names = value_in(ambient_, type);
  return names == nullptr ? std::span<const std::string_view>() : *names;
}

Span Names::declaration_of(std::string_view name) const {
  if (const Span* variable = find_variable(name)) return *variable;
  if (const FunctionDecl* function = find_function(name)) return function->node->name.span;
  const Span* type = value_in(type_spans_, name);
  return type == nullptr ? Span{} : *type;
}

std::vector<std::string_view> Names::all() const {
  std::vector<std::string_view> out;
  for (const auto& [name, span] : variables_) out.push_back(name);
  for (const auto& [name, function] : functions_) out.push_back(name);
  for (const auto& [name, type] : types_) out.push_back(name);
  return out;
}

}  // namespace armlet::lang
