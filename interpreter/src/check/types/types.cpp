// Types as written, turned into types.

#include <algorithm>

#include "check/checker.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {

const Type* Checker::type_called(std::string_view name) {
  if (name == "int" || name == "long") return types_.integer();
  if (name == "double" || name == "float") return types_.real();
  if (name == "bool" || name == "boolean") return types_.boolean();
  if (name == "string" || name == "String") return types_.text();
  if (name == "matrix" || name == "Matrix") return types_.matrix();
  if (const auto found = named_types_.find(name); found != named_types_.end()) return found->second;
  if (const HostType* host = registry_.type(name)) return types_.host(host);
  if (const auto dim = dimension_named(name)) return types_.quantity(*dim);
  if (name == "table") return types_.open_table();
  return types_.library_record(name);
}

const Type* Checker::resolve_named(const ast::TypeExpr& type) {
  if (type.path.size() == 1) {
    if (const Type* found = type_called(type.path[0].text)) return found;
  }
  std::string name;
  for (const ast::Name& part : type.path)
    name += (name.empty() ? "" : ".") + std::string(part.text);
  if (type.path.size() > 1) return imported_type(*this, type);
  if (syntax_failed_ || !told_.emplace(name).second) return types_.any();
  if (registry_.is_planned(name)) {
    not_available(type.span, '`' + name + '`');
    return types_.any();
  }
  if (refuse_foreign_type(*this, name, type.span)) return types_.any();
  if (!takes_errors()) {
    report(make_diagnostic("E0216", type.span, {name}));
    return types_.any();
  }
  std::vector<std::string_view> names = {"int",    "double", "bool", "string",
                                         "matrix", "table",  "void"};
  std::ranges::copy(dimension_names(), std::back_inserter(names));
  for (const auto& [known, unused] : named_types_) names.push_back(known);
  for (const auto& [known, unused] : registry_.types()) names.push_back(known);
  for (const auto& [known, unused] : registry_.records()) names.push_back(known);
  Diagnostic diagnostic = make_diagnostic("E0216", type.span, {name});
  diagnostic.fix = did_you_mean(name, type.span, names);
  report(std::move(diagnostic));
  return types_.any();
}

const Type* Checker::resolve_product(const ast::TypeExpr& type) {
  if (type.factors.size() == 1 && type.factors[0].exponent == 1)
    return resolve(*type.factors[0].type);
  std::optional<Dim> dim = Dim{};
  for (const ast::TypeFactor& factor : type.factors) {
    const Type* base = resolve(*factor.type);
    if (base->is(Kind::kAny)) return base;
    if (!base->is(Kind::kReal)) {
      report(make_diagnostic("E0315", factor.type->span, {"a quantity", type_phrase(base)}));
      return types_.any();
    }
    const auto raised = power(base->dim, 2 * factor.exponent);
    dim = raised ? multiply(*dim, *raised) : std::nullopt;
    if (!dim) {
      report(make_diagnostic("E0409", type.span));
      return types_.any();
    }
  }
  return types_.quantity(*dim);
}

const Type* Checker::resolve(const ast::TypeExpr& type) {
  switch (type.form) {
    case ast::TypeForm::kNamed:
    case ast::TypeForm::kPrimitive:
      return resolve_named(type);
    case ast::TypeForm::kArray: {
      const Type* element = resolve(*type.element);
      return element->is(Kind::kAny) ? element : types_.list(element);
    }
    case ast::TypeForm::kMap:
      return map_type(*this, type);
    case ast::TypeForm::kProduct:
      return resolve_product(type);
    case ast::TypeForm::kFunction: {
      std::vector<const Type*> parameters;
      for (const ast::TypeExpr* parameter : type.parameters)
        parameters.push_back(resolve(*parameter));
      return types_.function(std::move(parameters), resolve(*type.result));
    }
    case ast::TypeForm::kVoid:
      return types_.void_type();
  }
  return types_.any();
}

}  // namespace armlet::lang
