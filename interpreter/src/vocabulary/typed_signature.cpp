#include "vocabulary/typed_signature.hpp"

#include <algorithm>

namespace armlet::lang {
namespace {

using CppForm = ValueKind::Form;

ValueKind list_of(const ValueKind& element) {
  if (element.form == CppForm::kReal) return {CppForm::kReals};
  if (element.form == CppForm::kHost) return {CppForm::kHosts, false, element.host};
  return {CppForm::kItems};
}

ValueKind kind_of(const Type& type) {
  switch (type.kind) {
    case Kind::kAny:
      return {CppForm::kAny};
    case Kind::kVoid:
      return {CppForm::kNothing};
    case Kind::kBool:
      return {CppForm::kBool};
    case Kind::kInt:
    case Kind::kEnum:
      return {CppForm::kInt};
    case Kind::kReal:
      return {CppForm::kReal};
    case Kind::kText:
      return {CppForm::kText};
    case Kind::kList:
      return list_of(kind_of(*type.element));
    case Kind::kMap:
      return {CppForm::kAny};
    case Kind::kMatrix:
      return {CppForm::kMatrix};
    case Kind::kRecord:
      return {CppForm::kRecord};
    case Kind::kFunction:
      return {CppForm::kFunction};
    case Kind::kHost:
      return {CppForm::kHost, false, type.host};
  }
  return {};
}

ValueKind kind_of(const TypePattern& pattern) {
  switch (pattern.form) {
    case TypePattern::Form::kType:
      return kind_of(*pattern.type);
    case TypePattern::Form::kVariable:
      return {CppForm::kAny};
    case TypePattern::Form::kDimension:
      return {CppForm::kReal};
    case TypePattern::Form::kFunction:
      return {CppForm::kFunction};
    case TypePattern::Form::kTable:
    case TypePattern::Form::kRecord:
      return {CppForm::kRecord};
    case TypePattern::Form::kList:
      break;
  }
  return list_of(kind_of(pattern.parts.front()));
}

ValueKind kind_of(const Parameter& parameter) {
  ValueKind kind = kind_of(parameter.type);
  if (parameter.variadic && kind.form == CppForm::kReal) kind.form = CppForm::kReals;
  kind.optional = parameter.optional;
  return kind;
}

// Whether the kind `said` of a signature fits the C++ kind `written`. A slot may be of any kind,
// and a list of slots may be any list.
bool fits(const ValueKind& said, const ValueKind& written) {
  if (written.form == CppForm::kAny) return said.form != CppForm::kNothing;
  const bool is_list = said.form == CppForm::kReals || said.form == CppForm::kHosts;
  if (written.form == CppForm::kItems && is_list) return said.optional == written.optional;
  return said.form == written.form && said.optional == written.optional &&
         is_same_in_cpp(said.host, written.host);
}

std::string name_in_cpp(const ValueKind& kind) {
  const std::string host(kind.host == nullptr ? "" : kind.host->name);
  const auto plain = [&]() -> std::string {
    switch (kind.form) {
      case CppForm::kAny:
        return "Slot";
      case CppForm::kNothing:
        return "void";
      case CppForm::kBool:
        return "bool";
      case CppForm::kInt:
        return "std::int64_t";
      case CppForm::kReal:
        return "double";
      case CppForm::kText:
        return "std::string_view";
      case CppForm::kReals:
        return "std::span<const double>";
      case CppForm::kItems:
        return "std::span<const Slot>";
      case CppForm::kMatrix:
        return "const MatrixObj&";
      case CppForm::kRecord:
        return "const RecordObj&";
      case CppForm::kFunction:
        return "ScriptFunction";
      case CppForm::kHost:
        return "the value of a " + host;
      case CppForm::kHosts:
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
    case CppForm::kAny:
      return "Value";
    case CppForm::kText:
      return "std::string";
    case CppForm::kReals:
      return "std::vector<double>";
    case CppForm::kHost:
      return std::string(kind.host->name);
    case CppForm::kNothing:
    case CppForm::kBool:
    case CppForm::kInt:
    case CppForm::kReal:
    case CppForm::kItems:
    case CppForm::kMatrix:
    case CppForm::kRecord:
    case CppForm::kFunction:
    case CppForm::kHosts:
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
  const bool takes_time = function.pauses && function.gives->form == CppForm::kAny;
  if (!takes_time && !fits(result, *function.gives))
    faults.push_back(difference("the result", result, *function.gives));
  return faults;
}

}  // namespace armlet::lang
