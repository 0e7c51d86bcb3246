// Calls: f(a), x.f(a), new T(a). Which function is meant; the other parts check the values.

#include <algorithm>

#include "check/calls/printf.hpp"
#include "check/checker.hpp"
#include "check/names/function_names.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/types/long_lists.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {

bool Checker::waits(const ast::Expr& expr) {
  return expr.kind == ast::ExprKind::kLambda || written_function(*this, expr) != nullptr ||
         !library_function(*this, expr).empty();
}

// What a list written in a call is going to be, when all functions of the name agree on it.
const Type* Checker::list_hint(std::string_view callee, const ast::Arg& arg, std::size_t position) {
  if (arg.value->kind != ast::ExprKind::kList && arg.value->kind != ast::ExprKind::kBrace)
    return nullptr;
  const Type* hint = nullptr;
  for (const NativeFunction* candidate : registry_.functions(callee)) {
    const Signature& signature = signature_of(*candidate);
    const int named = signature.index_of(arg.name.text);
    const std::size_t at = arg.name.text.empty() ? position : static_cast<std::size_t>(named);
    if (at >= signature.parameters.size()) continue;
    const TypePattern& pattern = signature.parameters[at].type;
    if (!is_bound(pattern, {})) return nullptr;
    const Type* type = instantiate(pattern, {}, types_);
    if (type == nullptr || !type->is(Kind::kList)) continue;
    if (hint != nullptr && hint != type) return nullptr;
    hint = type;
  }
  return hint;
}

std::vector<Argument> Checker::arguments_of(ast::Seq<ast::Arg> args, std::string_view callee) {
  std::vector<Argument> out;
  for (std::size_t i = 0; i < args.size(); ++i) {
    const ast::Arg& arg = args[i];
    Argument argument{.name = arg.name.text, .name_span = arg.name.span, .written = arg.value};
    if (!waits(*arg.value)) argument.value = check_value(*arg.value, list_hint(callee, arg, i));
    out.push_back(argument);
  }
  return out;
}

hir::Expr* Checker::check_call(const ast::CallExpr& call, const Type* expected) {
  if (call.callee->kind == ast::ExprKind::kName) {
    return call_by_name(call, call.callee->as<ast::NameExpr>().name, call.callee->span, expected);
  }
  if (call.callee->kind == ast::ExprKind::kMember) {
    return call_member(call, call.callee->as<ast::MemberExpr>());
  }
  return call_value(check_value(*call.callee), call);
}

hir::Expr* Checker::call_by_name(const ast::CallExpr& call, std::string_view name, Span callee,
                                 const Type* /*expected*/) {
  FunctionContext* where = nullptr;
  Local* local = find_local(name, where);
  const bool is_value = local != nullptr && local->variable->type->is(Kind::kFunction);
  if (is_value || (local != nullptr && local->variable->type->is(Kind::kAny))) {
    return call_value(read(*local, *where, callee), call);
  }
  if (find_function(name) == nullptr && !named_types_.contains(name)) {
    bool known = false;
    if (hir::Expr* result = intrinsic(call, name, callee, known); known) return result;
  }
  const bool exists = find_function(name) != nullptr || named_types_.contains(name) ||
                      !registry_.functions(name).empty();
  if (!exists) {
    if (local != nullptr) return not_a_function(*this, call, name, local->variable->type);
    if (hir::Expr* told = foreign_call(*this, call, name)) return told;
    return unknown_name(name, callee);
  }
  return call_function(name, callee, call.span, arguments_of(call.args, name));
}

// A function of the text, a struct, or a function of the library.
hir::Expr* Checker::call_function(std::string_view name, Span callee, Span span,
                                  std::vector<Argument> arguments) {
  if (FunctionDecl* function = find_function(name)) {
    return call_script(*function, callee, span, std::move(arguments));
  }
  if (const auto found = named_types_.find(name); found != named_types_.end()) {
    if (found->second->is(Kind::kRecord)) {
      return construct(structs_[found->second->record], callee, span, std::move(arguments));
    }
    report(make_diagnostic("E0219", callee, {std::string(name), "type"}));
    return failed(span);
  }
  return call_native(name, registry_.functions(name), callee, span, std::move(arguments));
}

hir::Expr* Checker::call_member(const ast::CallExpr& call, const ast::MemberExpr& member) {
  const std::string_view name = member.member.text;
  const Span callee = member.member.span;
  if (const std::string group = dotted_name(*member.object); !group.empty()) {
    if (const Import* from = find_import(*this, group))
      return call_imported(*this, *from, call, member);
    if (group == "System.out" && (name == "println" || name == "print"))
      return print_call(call, name == "println");
    if (group == "System.out" && name == "printf") return print_formatted(*this, call);
    const std::string full = group + '.' + std::string(name);
    const auto functions = registry_.functions(group == "Math" ? name : std::string_view(full));
    if (!functions.empty()) {
      const std::string shown = group == "Math" ? std::string(name) : full;
      return call_native(arena_.copy(shown), functions, member.span, call.span,
                         arguments_of(call.args, shown));
    }
    if (hir::Expr* told = foreign_method(*this, call, member, full)) return told;
    if (registry_.is_namespace(group) || group == "Math" || group == "System.out" ||
        group == "System") {
      return unknown_name(full, member.span);
    }
  }
  hir::Expr* object = check_value(*member.object);
  const Type* type = object->type;
  if (type->is(Kind::kAny)) return failed(call.span);
  if (type->is(Kind::kRecord)) {
    const int field = field_index(*this, *type->record, name);
    if (field >= 0 && type->record->fields[field].type->is(Kind::kFunction)) {
      return call_value(field_of(object, member), call);
    }
  }
  bool known = false;
  if (hir::Expr* result = builtin_method(object, call, member, known); known) return result;

  const std::string method = type_name(type) + '.' + std::string(name);
  const auto methods = registry_.functions(method);
  std::vector<Argument> arguments = {Argument{.value = object}};
  FunctionDecl* const elsewhere =
      find_function(name) == nullptr ? method_of(*this, type, name) : nullptr;
  const bool exists =
      find_function(name) != nullptr || elsewhere != nullptr || !registry_.functions(name).empty();
  if (methods.empty() && !exists) {
    if (type->is(Kind::kRecord) && field_index(*this, *type->record, name) >= 0) {
      report(make_diagnostic("E0217", callee,
                             {std::string(name), type_phrase(field_of(object, member)->type)}));
      return failed(call.span);
    }
    return unknown_name(name, callee);
  }
  std::ranges::copy(arguments_of(call.args, methods.empty() ? name : std::string_view(method)),
                    std::back_inserter(arguments));
  if (!methods.empty()) return call_native(name, methods, callee, call.span, std::move(arguments));
  if (elsewhere != nullptr) return call_script(*elsewhere, callee, call.span, std::move(arguments));
  return call_function(name, callee, call.span, std::move(arguments));
}

hir::Expr* Checker::call_value(hir::Expr* function, const ast::CallExpr& call) {
  const Type* type = function->type;
  if (type->is(Kind::kAny)) return failed(call.span);
  const std::string name = text_of(call.callee->span);
  if (!type->is(Kind::kFunction)) {
    report(make_diagnostic("E0217", call.callee->span, {name, type_phrase(type)}));
    return failed(call.span);
  }
  if (!takes(call, name, type->parameters.size(), type->parameters.size()))
    return failed(call.span);
  std::vector<hir::Expr*> values;
  std::vector<Span> spans;
  for (std::size_t i = 0; i < call.args.size(); ++i) {
    values.push_back(check_as(*call.args[i].value, {.role = Target::Role::kArgument,
                                                    .type = type->parameters[i],
                                                    .function = name,
                                                    .position = static_cast<int>(i) + 1,
                                                    .call = call.span}));
    spans.push_back(values.back()->span);
  }
  return make<hir::CallValueExpr>(hir::ExprKind::kCallValue, type->result, call.span, function,
                                  seq(values),
                                  hir::CallSite{call.span, call.callee->span, seq(spans)});
}

hir::Expr* Checker::check_new_object(const ast::NewObjectExpr& expr) {
  if (type_called(text_of(expr.type->span)) == nullptr) {
    if (hir::Expr* told =
            foreign_empty_map(*this, text_of(expr.type->span), expr.args.size(), expr.span))
      return told;
  }
  const Type* type = resolve(*expr.type);
  if (type->is(Kind::kAny)) return failed(expr.span);
  std::string_view name = arena_.copy(type_name(type));
  // Another name of a type of the host has a constructor of its own.
  if (type->is(Kind::kHost)) name = arena_.copy(text_of(expr.type->span));
  if (type->is(Kind::kRecord) && structs_.contains(type->record)) {
    return construct(structs_[type->record], expr.type->span, expr.span,
                     arguments_of(expr.args, name));
  }
  if (!type->is(Kind::kRecord) && registry_.functions(name).empty()) {
    report(make_diagnostic("E0217", expr.type->span,
                           {std::string(name), "a type without a constructor"}));
    return failed(expr.span);
  }
  return call_function(name, expr.type->span, expr.span, arguments_of(expr.args, name));
}

}  // namespace armlet::lang
