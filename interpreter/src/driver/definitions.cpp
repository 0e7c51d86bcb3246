#include "driver/definitions.hpp"

#include <fmt/format.h>

#include <string_view>

#include "armlet/interpreter/define_type.hpp"
#include "ast/marks.hpp"
#include "syntax/tokens/lex.hpp"
#include "vocabulary/typed_signature.hpp"
#include "vocabulary/union_rows.hpp"

namespace armlet::lang {
namespace {

std::string no_name(std::string_view text) {
  return '`' + std::string(text) + "` cannot be a name";
}

// Whether the text consists of names joined by points, such as "Math.sin".
bool is_path_of_names(std::string_view text) {
  constexpr std::string_view kSetting = "with.";  // of the statement `with`
  if (text.starts_with(kSetting)) text.remove_prefix(kSetting.size());
  for (;;) {
    const std::size_t point = text.find('.');
    if (!is_name(text.substr(0, point))) return false;
    if (point == std::string_view::npos) return true;
    text.remove_prefix(point + 1);
  }
}

std::vector<std::string> faults(const NativeFunction& function, TypePool& types,
                                const TypeNames& names);

// The mistakes of a row with unions.
std::vector<std::string> faults_of_choices(const NativeFunction& row, TypePool& types,
                                           const TypeNames& names) {
  const std::vector<std::string> signatures = signatures_of(row.signature);
  if (!row.alternatives.empty() && row.alternatives.size() != signatures.size()) {
    return {fmt::format("the signature has {} choices of types, but there are {} functions in C++",
                        signatures.size(), row.alternatives.size())};
  }
  std::vector<std::string> all;
  for (std::size_t i = 0; i < signatures.size(); ++i) {
    for (const std::string& fault : faults(choice_of(row, i, signatures[i]), types, names))
      all.push_back(signatures[i] + ": " + fault);
  }
  return all;
}

std::vector<std::string> faults(const NativeFunction& function, TypePool& types,
                                const TypeNames& names) {
  if (function.name.empty()) return {"it has no name"};
  if (has_union(function.signature)) return faults_of_choices(function, types, names);
  std::string error;
  const auto signature = parse_signature(function.signature, types, names, error);
  if (!signature) return {error};
  std::vector<std::string> all = typed_faults(function, *signature);
  const bool is_called = function.event == BlockEvent::kNone && is_written(function.name);
  if (is_called && !is_path_of_names(function.name)) all.push_back(no_name(function.name));
  for (const Parameter& parameter : signature->parameters) {
    if (!is_argument_name(parameter.name)) all.push_back(no_name(parameter.name));
  }
  return all;
}

// The name of a function of the type `type`, without the parts that are only for the lookup by the
// checker.
std::string_view written_name(std::string_view name, std::string_view type) {
  if (name.starts_with(type) && name.substr(type.size()).starts_with('.')) {
    name.remove_prefix(type.size() + 1);
    if (name.ends_with('=')) name.remove_suffix(1);
  }
  return name;
}

bool is_operator_row(std::string_view name) {
  return name.starts_with("operator") && is_arithmetic(find_mark(name.substr(8)));
}

}  // namespace

std::vector<std::string> add_type(Registry& registry, const TypeDefinition& definition) {
  const HostType& type = definition.type();
  std::vector<std::string> all(definition.mistakes().begin(), definition.mistakes().end());
  if (!is_name(type.name)) all.push_back(no_name(type.name));
  TypePool types;
  registry.declare_records(types);
  std::string error;
  if (parse_fields("x: " + std::string(type.name), types, registry.type_names(types), error))
    all.push_back("there is a type of this name");
  for (const auto& [name, other] : registry.types()) {
    if (is_same_in_cpp(other, &type)) all.push_back("its values are those of `" + name + '`');
  }
  if (!all.empty()) return all;
  registry.add_type(type);
  const TypeNames names = registry.type_names(types);
  for (const NativeFunction& function : definition.functions()) {
    const std::string name(written_name(function.name, type.name));
    if (!is_name(name) && !is_operator_row(name)) all.push_back(no_name(name));
    for (const std::string& fault : faults(function, types, names))
      all.push_back('`' + name + "`: " + fault);
  }
  const NativeFunction* twice =
      all.empty() ? registry.add_functions(definition.functions()) : nullptr;
  if (twice != nullptr) {
    all.push_back('`' + std::string(twice->name) + std::string(twice->signature) +
                  "` is known to this engine already");
  }
  if (all.empty()) {
    registry.keep(definition.kept());
  } else {
    registry.take_back_type(type.name);
  }
  return all;
}

std::vector<std::string> check_signatures(const Registry& registry) {
  TypePool types;
  registry.declare_records(types);
  const TypeNames names = registry.type_names(types);
  std::vector<std::string> problems;
  std::string error;
  for (const auto& [name, fields] : registry.records()) {
    if (!parse_fields(fields, types, names, error)) problems.push_back(name + ": " + error);
  }
  const auto look = [&](std::span<const NativeFunction* const> overloads) {
    for (const NativeFunction* function : overloads) {
      for (const std::string& fault : faults(*function, types, names)) {
        problems.push_back(std::string(function->name) + std::string(function->signature) + ": " +
                           fault);
      }
    }
  };
  for (const auto& [name, overloads] : registry.functions()) look(overloads);
  for (std::size_t event = 0; event < kBlockEvents; ++event)
    look(registry.functions(static_cast<BlockEvent>(event)));
  return problems;
}

std::vector<std::string> faults_of(const Registry& registry, const NativeFunction& function) {
  TypePool types;
  registry.declare_records(types);
  return faults(function, types, registry.type_names(types));
}

}  // namespace armlet::lang
