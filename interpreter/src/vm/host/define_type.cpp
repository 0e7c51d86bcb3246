#include "armlet/interpreter/define_type.hpp"

#include <algorithm>
#include <utility>

namespace armlet {

namespace {

// "width: length" -> "width", "length"
std::pair<std::string_view, std::string_view> parts_of(std::string_view field) {
  const std::size_t colon = field.find(':');
  if (colon == std::string_view::npos) return {field, {}};
  std::string_view type = field.substr(colon + 1);
  type.remove_prefix(std::min(type.find_first_not_of(' '), type.size()));
  return {field.substr(0, colon), type};
}

// The declared type of a field for a C++ type, if it follows from that type; otherwise empty.
std::string_view told_type(const ValueKind& kind) {
  using Form = ValueKind::Form;
  static constexpr std::pair<Form, std::string_view> kTypes[] = {{Form::kReal, "double"},
                                                                 {Form::kInt, "int"},
                                                                 {Form::kBool, "bool"},
                                                                 {Form::kText, "string"},
                                                                 {Form::kReals, "double[]"}};
  for (const auto& [form, type] : kTypes) {
    if (form == kind.form) return type;
  }
  return {};
}

// The name of the parameter for a value of a type: "Valve" -> "valve".
std::string parameter_name(std::string_view type) {
  std::string name(type);
  if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z')
    name[0] = static_cast<char>(name[0] - 'A' + 'a');
  return name;
}

}  // namespace

TypeDefinition::TypeDefinition(const HostType& in_cpp, std::string name, std::string help) {
  kept_->type = in_cpp;
  kept_->type.in_cpp = &in_cpp;
  kept_->type.name = keep(std::move(name));
  kept_->type.help = keep(std::move(help));
}

std::string_view TypeDefinition::keep(std::string text) {
  kept_->texts.push_back(std::make_unique<const std::string>(std::move(text)));
  return *kept_->texts.back();
}

std::string TypeDefinition::with_value(std::string_view signature) const {
  const std::size_t open = signature.find('(');
  if (open == std::string_view::npos) return std::string(signature);
  const std::string_view rest = signature.substr(open + 1);
  const std::size_t next = rest.find_first_not_of(' ');
  const bool has_more = next != std::string_view::npos && rest[next] != ')';
  return std::string(signature.substr(0, open)) + '(' + parameter_name(type().name) + ": " +
         std::string(type().name) + (has_more ? ", " : "") + std::string(rest);
}

std::string TypeDefinition::type_of_field(std::string_view field, const ValueKind& kind) {
  const auto [name, type] = parts_of(field);
  if (!type.empty()) return std::string(type);
  const std::string_view told = told_type(kind);
  if (told.empty())
    mistake("the field `" + std::string(name) + "` needs its type: \"" + std::string(name) +
            ": type\"");
  return std::string(told);
}

std::string TypeDefinition::getter(std::string_view field, const ValueKind& kind) {
  const std::string name = std::string(type().name) + '.' + std::string(parts_of(field).first);
  return with_value(name + "()") + " -> " + type_of_field(field, kind);
}

std::string TypeDefinition::setter(std::string_view field, const ValueKind& kind) {
  const std::string name = std::string(type().name) + '.' + std::string(parts_of(field).first);
  const auto told = parts_of(field).second.empty() ? told_type(kind) : parts_of(field).second;
  return with_value(name + "=(value: " + std::string(told) + ')') + " -> " +
         std::string(type().name);
}

}  // namespace armlet
