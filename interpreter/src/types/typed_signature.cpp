#include "types/typed_signature.hpp"

#include <algorithm>

namespace armlet::lang {
namespace {

using Form = ValueKind::Form;

ValueKind list_of(const ValueKind& element) {
  if (element.form == Form::kReal) return {Form::kReals};
  if (element.form == Form::kHost) return {Form::kHosts, false, element.host};
  return {Form::kItems};
}

ValueKind kind_of(const Type& type) {
  switch (type.kind) {
    case Kind::kAny:
      return {Form::kAny};
    case Kind::kVoid:
      return {Form::kNothing};
    case Kind::kBool:
      return {Form::kBool};
    case Kind::kInt:
    case Kind::kEnum:
      return {Form::kInt};
    case Kind::kReal:
      return {Form::kReal};
    case Kind::kText:
      return {Form::kText};
    case Kind::kList:
      return list_of(kind_of(*type.element));
    case Kind::kMap:
      return {Form::kAny};
    case Kind::kMatrix:
      return {Form::kMatrix};
    case Kind::kRecord:
      return {Form::kRecord};
    case Kind::kFunction:
      return {Form::kFunction};
    case Kind::kHost:
      return {Form::kHost, false, type.host};
  }
  return {};
}

ValueKind kind_of(const TypePattern& pattern) {
  switch (pattern.form) {
    case TypePattern::Form::kType:
      return kind_of(*pattern.type);
    case TypePattern::Form::kVariable:
      return {Form::kAny};
    case TypePattern::Form::kDimension:
      return {Form::kReal};
    case TypePattern::Form::kFunction:
      return {Form::kFunction};
    case TypePattern::Form::kTable:
    case TypePattern::Form::kRecord:
      return {Form::kRecord};
    case TypePattern::Form::kList:
      break;
  }
  return list_of(kind_of(pattern.parts.front()));
}

ValueKind kind_of(const Parameter& parameter) {
  ValueKind kind = kind_of(parameter.type);
  if (parameter.variadic && kind.form == Form::kReal) kind.form = Form::kReals;
  kind.optional = parameter.optional;
  return kind;
}

// `said` is the kind that the signature means, `written` that of C++: a slot may hold anything, and
// slots are the elements of any list.
bool fits(const ValueKind& said, const ValueKind& written) {
  if (written.form == Form::kAny) return said.form != Form::kNothing;
  const bool is_list = said.form == Form::kReals || said.form == Form::kHosts;
  if (written.form == Form::kItems && is_list) return said.optional == written.optional;
  return said.form == written.form && said.optional == written.optional &&
         is_same_in_cpp(said.host, written.host);
}

std::string name_in_cpp(const ValueKind& kind) {
  const std::string host(kind.host == nullptr ? "" : kind.host->name);
  const auto plain = [&]() -> std::string {
    switch (kind.form) {
      case Form::kAny:
        return "Slot";
      case Form::kNothing:
        return "void";
      case Form::kBool:
        return "bool";
      case Form::kInt:
        return "std::int64_t";
      case Form::kReal:
        return "double";
      case Form::kText:
        return "std::string_view";
      case Form::kReals:
        return "std::span<const double>";
      case Form::kItems:
        return "std::span<const Slot>";
      case Form::kMatrix:
        return "const MatrixObj&";
      case Form::kRecord:
        return "const RecordObj&";
      case Form::kFunction:
        return "ScriptFunction";
      case Form::kHost:
        return "the value of a " + host;
      case Form::kHosts:
        return "the HostList of a " + host;
    }
    return {};
  }();
  return kind.optional ? "an optional " + plain : plain;
}

std::string difference(const std::string& what, const ValueKind& said, const ValueKind& written) {
  return what + " is " + name_in_cpp(written) + " in C++, where the signature asks for " +
         name_in_cpp(said);
}

}  // namespace

bool stands_for(const Type& type, const ValueKind& kind) { return fits(kind_of(type), kind); }

std::string stored_name(const ValueKind& kind) {
  switch (kind.form) {
    case Form::kAny:
      return "Value";
    case Form::kText:
      return "std::string";
    case Form::kReals:
      return "std::vector<double>";
    case Form::kHost:
      return std::string(kind.host->name);
    case Form::kNothing:
    case Form::kBool:
    case Form::kInt:
    case Form::kReal:
    case Form::kItems:
    case Form::kMatrix:
    case Form::kRecord:
    case Form::kFunction:
    case Form::kHosts:
      return name_in_cpp(kind);
  }
  return {};
}

std::vector<std::string> typed_faults(const NativeFunction& function, const Signature& signature) {
  std::vector<std::string> faults;
  if (function.gives == nullptr) return faults;
  const std::size_t said = signature.parameters.size();
  if (said != function.takes.size()) {
    faults.push_back("the signature has " + std::to_string(said) +
                     " parameters, the function in C++ " + std::to_string(function.takes.size()));
  }
  for (std::size_t i = 0; i < std::min(said, function.takes.size()); ++i) {
    const Parameter& parameter = signature.parameters[i];
    const ValueKind kind = kind_of(parameter);
    if (!fits(kind, function.takes[i]))
      faults.push_back(difference('`' + parameter.name + '`', kind, function.takes[i]));
  }
  for (std::size_t i = 0; i < said; ++i) {
    for (std::size_t other = 0; other < i; ++other) {
      if (signature.parameters[i].name == signature.parameters[other].name)
        faults.push_back("two parameters are called `" + signature.parameters[i].name + '`');
    }
  }
  const ValueKind result = kind_of(signature.result);
  const bool takes_time = function.pauses && function.gives->form == Form::kAny;
  if (!takes_time && !fits(result, *function.gives))
    faults.push_back(difference("the result", result, *function.gives));
  return faults;
}

}  // namespace armlet::lang
