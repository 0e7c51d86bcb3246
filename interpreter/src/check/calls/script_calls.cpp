// Checks calls of script functions, and values of struct types.

#include <algorithm>
#include <utility>

#include "check/calls/calls.hpp"
#include "check/functions/functions.hpp"
#include "check/library/misfits.hpp"
#include "check/library/overloads.hpp"
#include "check/names/reading.hpp"
#include "check/state/checker.hpp"
#include "check/state/learnt.hpp"
#include "check/types/any_table.hpp"
#include "check/types/long_lists.hpp"

namespace armlet::lang {
namespace {

// The most likely type of a lambda's parameter in this call: that of another argument, or of its
// elements.
std::string likely_type(const std::vector<Argument>& arguments) {
  for (const Argument& argument : arguments) {
    if (argument.waits() || argument.value->type->is(Kind::kAny)) continue;
    const Type* type = argument.value->type;
    return type_name(type->is(Kind::kList) ? type->element : type);
  }
  return "double";
}

// For editors: notes the parameters that argument names refer to.
void note_named_values(Checker& checker, ast::Seq<ast::Param> parameters,
                       const std::vector<Argument>& arguments) {
  if (checker.shared.learnt == nullptr) return;
  for (const Argument& argument : arguments) {
    const auto named = std::ranges::find_if(parameters, [&](const ast::Param& parameter) {
      return parameter.name.text == argument.name;
    });
    if (named != parameters.end()) checker.shared.learnt->use(argument.name_span, named->name.span);
  }
}

std::optional<std::vector<Argument*>> by_parameter(Checker& checker, std::string_view name,
                                                   ast::Seq<ast::Param> parameters, Span callee,
                                                   Span span, std::vector<Argument>& arguments) {
  note_named_values(checker, parameters, arguments);
  // The rules and messages are those of library functions.
  Signature signature;
  for (const ast::Param& parameter : parameters) {
    signature.parameters.push_back({.name = std::string(parameter.name.text),
                                    .type = {.type = checker.types.any()},
                                    .optional = parameter.default_value != nullptr});
  }
  Fit fit;
  const bool is_placed = place_arguments(signature, arguments, fit);
  const bool is_begun = checker.shared.guesses && fit.problem == Fit::Problem::kMissing;
  if (!is_placed && !is_begun) {
    report_misfit(checker, name, signature, callee, span, arguments, fit);
    return std::nullopt;
  }
  std::vector<Argument*> out;
  for (const int from : fit.from) out.push_back(from >= 0 ? &arguments[from] : nullptr);
  return out;
}

// Whether a type is not fully known: the value failed, or is an empty list or map.
bool is_open(const Type& type) {
  return type.is(Kind::kAny) ||
         ((type.is(Kind::kList) || type.is(Kind::kMap)) && type.element->is(Kind::kAny));
}

// Whether an argument with a known type is refused for a parameter of the same kind, after a
// message: a table with other columns, or a list without a known element type.
bool refuse_kind(Checker& checker, const FunctionDecl& function, const ast::Param& parameter,
                 const hir::Expr& value) {
  const ast::TypeExpr* written = parameter.type;
  if (is_any_table(*function.file, written) && !fits_any_table(written, value.type)) {
    checker.report(make_diagnostic("E0313", value.span,
                                   {std::string(function.node->name.text),
                                    any_table_phrase(written), type_phrase(value.type)}));
    return true;
  }
  if (!is_open(*value.type)) return false;
  const bool is_map = value.type->is(Kind::kMap);
  checker.report(
      make_diagnostic("E0323", value.span, {is_map ? "this empty map" : "this empty list"}));
  return true;
}

}  // namespace

hir::Expr* call_script(Checker& checker, FunctionDecl& function, Span callee, Span span,
                       std::vector<Argument> arguments) {
  const ast::FunctionStmt& node = *function.node;
  const std::string_view name = node.name.text;
  if (checker.shared.learnt != nullptr) checker.shared.learnt->use(callee, node.name.span);
  const auto given = by_parameter(checker, name, node.params, callee, span, arguments);
  if (!given) return checker.guessed(span, function.result);
  const int receiver = !arguments.empty() && arguments[0].written == nullptr ? 1 : 0;
  std::vector<hir::Expr*> values;
  std::vector<const Type*> types;
  std::vector<Span> spans;
  for (std::size_t p = 0; p < node.params.size(); ++p) {
    const Type* type = function.parameters[p];
    Argument* argument = (*given)[p];
    Target target{.role = Target::Role::kArgument,
                  .type = type,
                  .name = node.params[p].name.text,
                  .function = name,
                  .call = span};
    spans.push_back(argument != nullptr ? argument->span()
                                        : Span{callee.end, callee.end, callee.source});
    hir::Expr* value = nullptr;
    if (argument == nullptr && node.params[p].default_value == nullptr) {
      value = checker.failed(span);
    } else if (argument == nullptr) {
      value = default_value(checker, *function.file, *node.params[p].default_value, target);
    } else {
      if (!argument->name.empty()) target.role = Target::Role::kSetting;
      target.position = static_cast<int>(argument - arguments.data()) + 1 - receiver;
      if (argument->waits()) {
        const std::string before = checker.surroundings.set_likely_type(likely_type(arguments));
        argument->value = checker.check_value(*argument->written, type);
        checker.surroundings.set_likely_type(before);
      }
      value = type != nullptr ? checker.require(argument->value, target) : argument->value;
    }
    if (checker.shared.guesses && is_open(*value->type)) {
      values.push_back(value);
      types.push_back(type != nullptr ? type : checker.types.any());
      continue;
    }
    if (value->type->is(Kind::kAny) || refuse_kind(checker, function, node.params[p], *value))
      return checker.failed(span);
    values.push_back(value);
    types.push_back(value->type);
  }
  Instance* instance = instance_of(*function.file, function, std::move(types), span);
  if (instance == nullptr) return checker.guessed(span, function.result);
  note_call(checker, instance->function);
  return checker.make<hir::CallExpr>(hir::ExprKind::kCall, instance->function->result, span,
                                     instance->function, checker.seq(values),
                                     hir::CallSite{span, callee, checker.seq(spans)});
}

hir::Expr* construct(Checker& checker, const StructDecl& structure, Span callee, Span span,
                     std::vector<Argument> arguments) {
  const ast::StructStmt& node = *structure.node;
  const std::string_view name = node.name.text;
  if (checker.shared.learnt != nullptr) checker.shared.learnt->use(callee, node.name.span);
  const auto given = by_parameter(checker, name, node.fields, callee, span, arguments);
  if (!given) return checker.guessed(span, structure.type);
  std::vector<hir::Expr*> values;
  for (std::size_t i = 0; i < node.fields.size(); ++i) {
    Argument* argument = (*given)[i];
    Target target{.role = Target::Role::kSetting,
                  .type = structure.type->record->fields[i].type,
                  .name = node.fields[i].name.text,
                  .function = name,
                  .call = span};
    if (argument == nullptr && node.fields[i].default_value == nullptr) {
      values.push_back(checker.failed(span));
    } else if (argument == nullptr) {
      values.push_back(
          default_value(checker, *structure.file, *node.fields[i].default_value, target));
    } else {
      if (argument->waits()) argument->value = checker.check_value(*argument->written, target.type);
      values.push_back(checker.require(argument->value, target));
    }
    if (values.back()->type->is(Kind::kAny) && !checker.shared.guesses) return checker.failed(span);
  }
  return checker.make<hir::RecordExpr>(hir::ExprKind::kRecord, structure.type, span,
                                       checker.seq(values));
}

}  // namespace armlet::lang
