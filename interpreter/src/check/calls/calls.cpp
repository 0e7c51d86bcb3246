#include "check/calls/calls.hpp"

#include <algorithm>

#include "check/calls/fields.hpp"
#include "check/calls/foreign_calls.hpp"
#include "check/calls/imported.hpp"
#include "check/calls/intrinsics.hpp"
#include "check/calls/map_calls.hpp"
#include "check/calls/row_values.hpp"
#include "check/functions/function_names.hpp"
#include "check/library/native_calls.hpp"
#include "check/library/printf.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

namespace {

hir::Expr* call_by_name(Checker& checker, const ast::CallExpr& call, std::string_view name,
                        Span callee, const Type* expected);
hir::Expr* call_function(Checker& checker, std::string_view name, Span callee, Span span,
                         std::vector<Argument> arguments);
hir::Expr* call_member(Checker& checker, const ast::CallExpr& call, const ast::MemberExpr& member);

}  // namespace

bool waits(Checker& checker, const ast::Expr& expr) {
  return expr.kind == ast::ExprKind::kLambda || written_function(checker, expr) != nullptr ||
         !library_function(checker, expr).empty();
}

bool is_missing(const ast::Expr& expr) {
  return expr.kind == ast::ExprKind::kName && expr.as<ast::NameExpr>().name.empty();
}

// The type that a list literal in a call gets, if all functions of the name expect the same type.
const Type* list_hint(Checker& checker, std::string_view callee, const ast::Arg& arg,
                      std::size_t position) {
  if (arg.value->kind != ast::ExprKind::kList && arg.value->kind != ast::ExprKind::kBrace)
    return nullptr;
  const Type* hint = nullptr;
  for (const NativeFunction* candidate : checker.registry.functions(callee)) {
    const Signature& signature = checker.shared.signatures.of(*candidate);
    const int named = signature.index_of(arg.name.text);
    const std::size_t at = arg.name.text.empty() ? position : static_cast<std::size_t>(named);
    if (at >= signature.parameters.size()) continue;
    const TypePattern& pattern = signature.parameters[at].type;
    if (!is_bound(pattern, {})) return nullptr;
    const Type* type = instantiate(pattern, {}, checker.types);
    if (type == nullptr || !type->is(Kind::kList)) continue;
    if (hint != nullptr && hint != type) return nullptr;
    hint = type;
  }
  return hint;
}

std::vector<Argument> arguments_of(Checker& checker, ast::Seq<ast::Arg> args,
                                   std::string_view callee) {
  std::vector<Argument> out;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const ast::Arg& arg = args[i];
    // A missing last argument of an incomplete call is not an error: there may be none.
    const bool is_last = i + 1 == args.size() && arg.name.text.empty();
    if (checker.shared.guesses && is_last && is_missing(*arg.value)) break;
    Argument argument{.name = arg.name.text, .name_span = arg.name.span, .written = arg.value};
    if (!waits(checker, *arg.value))
      argument.value = checker.check_value(*arg.value, list_hint(checker, callee, arg, i));
    out.push_back(argument);
  }
  return out;
}

hir::Expr* check_call(Checker& checker, const ast::CallExpr& call, const Type* expected) {
  if (call.callee->kind == ast::ExprKind::kName) {
    return call_by_name(checker, call, call.callee->as<ast::NameExpr>().name, call.callee->span,
                        expected);
  }
  if (call.callee->kind == ast::ExprKind::kMember) {
    const auto& member = call.callee->as<ast::MemberExpr>();
    if (hir::Expr* row = named_row_value(checker, member)) return call_value(checker, row, call);
    return call_member(checker, call, member);
  }
  return call_value(checker, checker.check_value(*call.callee), call);
}

namespace {

hir::Expr* call_by_name(Checker& checker, const ast::CallExpr& call, std::string_view name,
                        Span callee, const Type* /*expected*/) {
  FunctionContext* where = nullptr;
  Local* local = checker.scopes.find(name, where);
  const bool is_value = local != nullptr && local->variable->type->is(Kind::kFunction);
  if (is_value || (local != nullptr && local->variable->type->is(Kind::kAny))) {
    return call_value(checker, read(checker, *local, *where, callee), call);
  }
  if (checker.names.find_function(name) == nullptr && checker.names.find_type(name) == nullptr) {
    bool known = false;
    if (hir::Expr* result = intrinsic(checker, call, name, callee, known); known) return result;
  }
  const bool exists = checker.names.find_function(name) != nullptr ||
                      checker.names.find_type(name) != nullptr ||
                      !checker.registry.functions(name).empty();
  if (!exists) {
    if (local != nullptr) return not_a_function(checker, call, name, local->variable->type);
    if (hir::Expr* told = foreign_call(checker, call, name)) return told;
    return unknown_name(checker, name, callee);
  }
  return call_function(checker, name, callee, call.span, arguments_of(checker, call.args, name));
}

// Checks a call of a script function, a struct, or a library function.
hir::Expr* call_function(Checker& checker, std::string_view name, Span callee, Span span,
                         std::vector<Argument> arguments) {
  if (FunctionDecl* function = checker.names.find_function(name)) {
    return call_script(checker, *function, callee, span, std::move(arguments));
  }
  if (const Type* found = checker.names.find_type(name)) {
    if (found->is(Kind::kRecord)) {
      return construct(checker, *checker.shared.structs.find(found), callee, span,
                       std::move(arguments));
    }
    checker.report(make_diagnostic("E0219", callee, {std::string(name), "type"}));
    return checker.failed(span);
  }
  return call_native(checker, name, checker.registry.functions(name), callee, span,
                     std::move(arguments));
}

// The library functions of a name with this type as the first parameter. A script function has
// priority if its first parameter has the type, or has none while the library has only a field.
std::span<const NativeFunction* const> methods_of(Checker& checker, const Type& type,
                                                  std::string_view name) {
  const auto methods = checker.registry.functions(type_name(&type) + '.' + std::string(name));
  const FunctionDecl* const own = checker.names.find_function(name);
  if (own == nullptr || own->parameters.empty()) return methods;
  const Type* const first = own->parameters.front();
  const bool comes_first =
      first != nullptr ? first == &type
                       : std::ranges::all_of(methods, [&](const NativeFunction* method) {
                           return checker.shared.signatures.of(*method).parameters.size() == 1;
                         });
  return comes_first ? std::span<const NativeFunction* const>() : methods;
}

hir::Expr* call_member(Checker& checker, const ast::CallExpr& call, const ast::MemberExpr& member) {
  const std::string_view name = member.member.text;
  const Span callee = member.member.span;
  if (const std::string group = dotted_name(checker, *member.object); !group.empty()) {
    if (const Import* from = checker.names.find_import(group))
      return call_imported(checker, *from, call, member);
    if (group == "System.out" && (name == "println" || name == "print"))
      return print_call(checker, call, name == "println");
    if (group == "System.out" && name == "printf") return print_formatted(checker, call);
    const std::string full = group + '.' + std::string(name);
    const auto functions =
        checker.registry.functions(group == "Math" ? name : std::string_view(full));
    if (!functions.empty()) {
      const std::string shown = group == "Math" ? std::string(name) : full;
      return call_native(checker, checker.arena.copy(shown), functions, member.span, call.span,
                         arguments_of(checker, call.args, shown));
    }
    if (hir::Expr* told = foreign_method(checker, call, member, full)) return told;
    if (checker.registry.is_namespace(group) || group == "Math" || group == "System.out" ||
        group == "System") {
      return unknown_name(checker, full, member.span);
    }
  }
  hir::Expr* object = checker.check_value(*member.object);
  const Type* type = object->type;
  if (type->is(Kind::kAny)) return checker.failed(call.span);
  if (type->is(Kind::kRecord)) {
    const int field = checker.shared.structs.field_index(*type->record, name);
    if (field >= 0 && type->record->fields[field].type->is(Kind::kFunction)) {
      return call_value(checker, field_of(checker, object, member), call);
    }
  }
  bool known = false;
  if (hir::Expr* result = builtin_method(checker, object, call, member, known); known)
    return result;

  const std::string method = type_name(type) + '.' + std::string(name);
  const auto methods = methods_of(checker, *type, name);
  std::vector<Argument> arguments = {Argument{.value = object}};
  const bool own = checker.names.find_function(name) != nullptr;
  FunctionDecl* const elsewhere = own ? nullptr : method_of(checker, type, name);
  const bool exists = own || elsewhere != nullptr || !checker.registry.functions(name).empty();
  if (methods.empty() && !exists) {
    if (type->is(Kind::kRecord) && checker.shared.structs.field_index(*type->record, name) >= 0) {
      checker.report(make_diagnostic(
          "E0217", callee,
          {std::string(name), type_phrase(field_of(checker, object, member)->type)}));
      return checker.failed(call.span);
    }
    return unknown_method(checker, call, member, *type);
  }
  std::ranges::copy(
      arguments_of(checker, call.args, methods.empty() ? name : std::string_view(method)),
      std::back_inserter(arguments));
  if (!methods.empty())
    return call_native(checker, name, methods, callee, call.span, std::move(arguments));
  if (elsewhere != nullptr)
    return call_script(checker, *elsewhere, callee, call.span, std::move(arguments));
  return call_function(checker, name, callee, call.span, std::move(arguments));
}

}  // namespace

hir::Expr* call_value(Checker& checker, hir::Expr* function, const ast::CallExpr& call) {
  const Type* type = function->type;
  if (type->is(Kind::kAny)) return checker.failed(call.span);
  const std::string name = checker.text_of(call.callee->span);
  if (!type->is(Kind::kFunction)) {
    checker.report(make_diagnostic("E0217", call.callee->span, {name, type_phrase(type)}));
    return checker.failed(call.span);
  }
  if (!takes(checker, call, name, type->parameters.size(), type->parameters.size())) {
    if (checker.shared.guesses) static_cast<void>(arguments_of(checker, call.args, name));
    return checker.guessed(call.span, type->result);
  }
  std::vector<hir::Expr*> values;
  std::vector<Span> spans;
  for (std::size_t i = 0; i < call.args.size(); ++i) {
    values.push_back(checker.check_as(*call.args[i].value, {.role = Target::Role::kArgument,
                                                            .type = type->parameters[i],
                                                            .function = name,
                                                            .position = static_cast<int>(i) + 1,
                                                            .call = call.span}));
    spans.push_back(values.back()->span);
  }
  return checker.make<hir::CallValueExpr>(
      hir::ExprKind::kCallValue, type->result, call.span, function, checker.seq(values),
      hir::CallSite{call.span, call.callee->span, checker.seq(spans)});
}

hir::Expr* check_new_object(Checker& checker, const ast::NewObjectExpr& expr) {
  if (type_called(checker, checker.text_of(expr.type->span)) == nullptr) {
    if (hir::Expr* told = foreign_empty_map(checker, checker.text_of(expr.type->span),
                                            expr.args.size(), expr.span))
      return told;
  }
  const Type* type = checker.resolve(*expr.type);
  if (type->is(Kind::kAny)) return checker.failed(expr.span);
  std::string_view name = checker.arena.copy(type_name(type));
  // A second name of a host type has a constructor of its own.
  if (type->is(Kind::kHost)) name = checker.arena.copy(checker.text_of(expr.type->span));
  if (type->is(Kind::kRecord) && checker.shared.structs.find(type) != nullptr) {
    return construct(checker, *checker.shared.structs.find(type), expr.type->span, expr.span,
                     arguments_of(checker, expr.args, name));
  }
  if (!type->is(Kind::kRecord) && checker.registry.functions(name).empty()) {
    checker.report(make_diagnostic("E0217", expr.type->span,
                                   {std::string(name), "a type without a constructor"}));
    return checker.failed(expr.span);
  }
  return call_function(checker, name, expr.type->span, expr.span,
                       arguments_of(checker, expr.args, name));
}

}  // namespace armlet::lang
