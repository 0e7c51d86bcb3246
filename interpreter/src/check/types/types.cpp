#include "check/types/types.hpp"

#include <algorithm>

#include "base/basic_types.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {

const Type* type_called(Checker& checker, std::string_view name) {
  if (const Type* basic = basic_type(checker.types, name)) return basic;
  if (const Type* found = checker.names.find_type(name)) return found;
  if (const HostType* host = checker.registry.type(name)) return checker.types.host(host);
  if (const auto dim = dimension_named(name)) return checker.types.quantity(*dim);
  if (name == "table") return checker.types.open_table();
  return checker.types.library_record(name);
}

namespace {

// Whether a word is the type of characters in Java or C.
bool is_type_of_one_character(std::string_view word) {
  return word == "char" || word == "Character";
}

Diagnostic single_character_advice(std::string_view word, Span span) {
  Diagnostic out = make_diagnostic("W0755", span, {std::string(word)});
  out.fix =
      Fix{.text = "write string", .edits = {{span, "string"}}, .confidence = Confidence::kSure};
  return out;
}

const Type* resolve_named(Checker& checker, const ast::TypeExpr& type) {
  if (type.path.size() == 1) {
    const std::string_view word = type.path[0].text;
    if (const Type* found = type_called(checker, word)) {
      note_type_use(checker, *found, type.span);
      return found;
    }
    if (is_type_of_one_character(word)) {
      if (checker.messages.is_news(word)) checker.report(single_character_advice(word, type.span));
      return checker.types.text();
    }
  }
  std::string name;
  for (const ast::Name& part : type.path)
    name += (name.empty() ? "" : ".") + std::string(part.text);
  if (type.path.size() > 1) return imported_type(checker, type);
  if (!checker.messages.is_news(name)) return checker.types.any();
  if (refuse_foreign_type(checker, name, type.span)) return checker.types.any();
  if (!checker.messages.takes_errors()) {
    checker.report(make_diagnostic("E0216", type.span, {name}));
    return checker.types.any();
  }
  std::vector<std::string_view> names = {"table", "void"};
  for (const BasicType& basic : kBasicTypes) names.push_back(basic.name);
  std::ranges::copy(dimension_names(), std::back_inserter(names));
  for (const auto& [known, unused] : checker.names.types()) names.push_back(known);
  for (const KeptName* kept : checker.names.all_earlier())
    if (kept->type != nullptr) names.push_back(kept->name);
  for (const auto& [known, unused] : checker.registry.types()) names.push_back(known);
  for (const auto& [known, unused] : checker.registry.records()) names.push_back(known);
  Diagnostic diagnostic = make_diagnostic("E0216", type.span, {name});
  diagnostic.fix = did_you_mean(checker, name, type.span, names);
  checker.report(std::move(diagnostic));
  return checker.types.any();
}

const Type* resolve_product(Checker& checker, const ast::TypeExpr& type) {
  if (type.factors.size() == 1 && type.factors[0].exponent == 1)
    return checker.resolve(*type.factors[0].type);
  std::optional<Dim> dim = Dim{};
  for (const ast::TypeFactor& factor : type.factors) {
    const Type* base = checker.resolve(*factor.type);
    if (base->is(Kind::kAny)) return base;
    if (!base->is(Kind::kReal)) {
      checker.report(
          make_diagnostic("E0315", factor.type->span, {"a quantity", type_phrase(base)}));
      return checker.types.any();
    }
    const auto raised = power(base->dim, 2 * factor.exponent);
    dim = raised ? multiply(*dim, *raised) : std::nullopt;
    if (!dim) {
      checker.report(make_diagnostic("E0409", type.span));
      return checker.types.any();
    }
  }
  return checker.types.quantity(*dim);
}

}  // namespace

const Type* Checker::resolve(const ast::TypeExpr& type) {
  switch (type.form) {
    case ast::TypeForm::kNamed:
    case ast::TypeForm::kPrimitive:
      return resolve_named(*this, type);
    case ast::TypeForm::kArray: {
      const Type* element = resolve(*type.element);
      return element->is(Kind::kAny) ? element : types.list(element);
    }
    case ast::TypeForm::kMap:
      return map_type(*this, type);
    case ast::TypeForm::kProduct:
      return resolve_product(*this, type);
    case ast::TypeForm::kFunction: {
      std::vector<const Type*> parameters;
      for (const ast::TypeExpr* parameter : type.parameters)
        parameters.push_back(resolve(*parameter));
      return types.function(std::move(parameters), resolve(*type.result));
    }
    case ast::TypeForm::kVoid:
      return types.void_type();
  }
  return types.any();
}

}  // namespace armlet::lang
