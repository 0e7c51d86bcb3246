#include "check/scopes/names.hpp"

#include <algorithm>

#include "check/scopes/earlier.hpp"

namespace armlet::lang {
namespace {

// The value of a name in a map; null if it has none.
auto* value_in(auto& map, std::string_view name) {
  const auto found = map.find(name);
  return found == map.end() ? nullptr : &found->second;
}

}  // namespace

bool FunctionDecl::is_generic() const {
  return std::ranges::any_of(parameters, [](const Type* type) { return type == nullptr; });
}

void Names::follow(const KeptFile& kept, Earlier& earlier) {
  kept_ = &kept;
  earlier_ = &earlier;
}

const KeptName* Names::find_earlier(std::string_view name) const {
  const bool hides = kept_ == nullptr || functions_.contains(name) || types_.contains(name) ||
                     imports_.contains(name);
  return hides ? nullptr : kept_->find(name);
}

std::vector<const KeptName*> Names::all_earlier() const {
  std::vector<const KeptName*> out;
  if (kept_ == nullptr) return out;
  kept_->names.for_each([&](const KeptFile::Bucket& bucket) {
    for (const KeptName& kept : bucket) {
      if (find_earlier(kept.name) != nullptr) out.push_back(&kept);
    }
  });
  std::ranges::sort(out, {}, [](const KeptName* kept) {
    return std::pair(kept->declared.source, kept->declared.begin);
  });
  return out;
}

std::pair<const Import*, bool> Names::add_import(std::string_view name, const Import& import) {
  const auto [first, is_new] = imports_.try_emplace(name, import);
  return {&first->second, is_new};
}

const Import* Names::own_import(std::string_view name) const { return value_in(imports_, name); }

const FunctionDecl* Names::own_function(std::string_view name) const {
  return value_in(functions_, name);
}

const Import* Names::find_import(std::string_view name) const {
  if (const Import* own = own_import(name)) return own;
  const KeptName* kept = find_earlier(name);
  return kept != nullptr && kept->import != nullptr ? &earlier_->import(*kept) : nullptr;
}

FunctionDecl& Names::add_function(const ast::FunctionStmt& node, Checker& file) {
  FunctionDecl& function = functions_[node.name.text];
  function.node = &node;
  function.file = &file;
  return function;
}

FunctionDecl* Names::find_function(std::string_view name) {
  if (FunctionDecl* own = value_in(functions_, name)) return own;
  const KeptName* kept = find_earlier(name);
  return kept != nullptr && kept->function != nullptr ? &earlier_->function(kept->function)
                                                      : nullptr;
}

const FunctionDecl* Names::find_function(std::string_view name) const {
  return const_cast<Names*>(this)->find_function(name);
}

bool Names::add_type(const ast::Name& name, const Type* type) {
  if (!types_.emplace(name.text, type).second) return false;
  type_spans_[name.text] = name.span;
  return true;
}

const Type* Names::find_type(std::string_view name) const {
  if (const auto* own = value_in(types_, name)) return *own;
  const KeptName* kept = find_earlier(name);
  return kept != nullptr ? kept->type : nullptr;
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
  if (const Span* type = value_in(type_spans_, name)) return *type;
  const KeptName* kept = find_earlier(name);
  return kept == nullptr || kept->import != nullptr ? Span{} : kept->declared;
}

std::vector<std::string_view> Names::all() const {
  std::vector<std::string_view> out;
  for (const auto& [name, span] : variables_) out.push_back(name);
  for (const auto& [name, function] : functions_) out.push_back(name);
  for (const auto& [name, type] : types_) out.push_back(name);
  for (const KeptName* kept : all_earlier()) {
    if (kept->import == nullptr) out.push_back(kept->name);
  }
  return out;
}

}  // namespace armlet::lang
