#include "check/calls/intrinsics.hpp"

#include "check/calls/map_calls.hpp"
#include "check/library/formatted.hpp"
#include "check/library/native_calls.hpp"
#include "check/library/printf.hpp"
#include "check/state/checker.hpp"
#include "check/state/list_mutations.hpp"
#include "check/types/indices.hpp"
#include "check/types/types.hpp"

namespace armlet::lang {

namespace {

hir::Expr* error_call(Checker& checker, const ast::CallExpr& call);
hir::Expr* conversion_call(Checker& checker, const ast::CallExpr& call, const Type* type,
                           std::string_view name);
hir::Expr* mutation(Checker& checker, const ast::CallExpr& call, const ast::MemberExpr& member,
                    hir::Mutation mutation);

std::string values(std::size_t least, std::size_t most) {
  if (most == 0) return "no values";
  const std::string count =
      least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
  return count + (most == 1 ? " value" : " values");
}

}  // namespace

// Whether the call has a count of values in this range, none of them named.
bool takes(Checker& checker, const ast::CallExpr& call, std::string_view name, std::size_t least,
           std::size_t most) {
  for (const ast::Arg& arg : call.args) {
    if (arg.name.text.empty()) continue;
    checker.report(
        make_diagnostic("E0207", arg.name.span, {std::string(name), std::string(arg.name.text)}));
    return false;
  }
  if (call.args.size() >= least && call.args.size() <= most) return true;
  const Span mark = call.args.size() > most ? call.args[most].span : call.callee->span;
  checker.report(make_diagnostic(
      "E0312", mark, {std::string(name), values(least, most), std::to_string(call.args.size())}));
  return false;
}

hir::Expr* intrinsic(Checker& checker, const ast::CallExpr& call, std::string_view name,
                     Span /*callee*/, bool& known) {
  known = true;
  if (name == "print") return print_call(checker, call, true);
  if (name == "error") return error_call(checker, call);
  if (name == "int" || name == "long")
    return conversion_call(checker, call, checker.types.integer(), name);
  if (name == "double" || name == "float")
    return conversion_call(checker, call, checker.types.real(), name);
  if (name == kToText) {
    if (!takes(checker, call, name, 1, 1)) return checker.failed(call.span);
    return to_text(checker, checker.check_value(*call.args[0].value));
  }
  if (name == "assert" || name == "assertThrows") {
    checker.report(make_diagnostic("E0320", call.span, {std::string(name)}));
    return checker.failed(call.span);
  }
  known = false;
  return nullptr;
}

namespace {

hir::Expr* print_parts(Checker& checker, const ast::CallExpr& call,
                       const std::vector<hir::Expr*>& parts) {
  hir::Expr* text = checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types.text(),
                                                  call.span, checker.seq(parts));
  const std::vector<Span> spans = {call.args_span};
  return checker.make<hir::CallNativeExpr>(
      hir::ExprKind::kCallNative, checker.types.void_type(), call.span,
      checker.registry.language().print, checker.seq(std::vector<hir::Expr*>{text}),
      hir::CallSite{call.span, call.callee->span, checker.seq(spans)});
}

}  // namespace

hir::Expr* print_call(Checker& checker, const ast::CallExpr& call, bool line) {
  checker.shared.mentions.add("print");
  if (!takes(checker, call, "print", 0, call.args.size())) return checker.failed(call.span);
  std::vector<hir::Expr*> parts;
  const auto add = [&](std::string_view text) {
    parts.push_back(
        checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(), call.span, text));
  };
  for (const ast::Arg& arg : call.args) {
    if (!parts.empty()) add(" ");
    parts.push_back(to_text(checker, checker.check_value(*arg.value)));
  }
  if (line) add("\n");
  return print_parts(checker, call, parts);
}

hir::Expr* print_line(Checker& checker, const ast::CallExpr& call, hir::Expr* text) {
  checker.shared.mentions.add("print");
  hir::Expr* end =
      checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(), call.span, "\n");
  return print_parts(checker, call, {text, end});
}

hir::Expr* print_formatted(Checker& checker, const ast::CallExpr& call) {
  checker.shared.mentions.add("print");
  const auto parts = printf_parts(checker, call);
  return parts ? print_parts(checker, call, *parts) : checker.failed(call.span);
}

// The last element of a list, whose expression is evaluated only once.
hir::Expr* last_call(Checker& checker, hir::Expr* list, Span span) {
  const NativeFunction* const functions[] = {checker.registry.language().last};
  return call_native(checker, "last", functions, span, span, {Argument{.value = list}});
}

namespace {

hir::Expr* error_call(Checker& checker, const ast::CallExpr& call) {
  hir::Expr* message = nullptr;
  hir::Expr* kind = nullptr;
  for (const ast::Arg& arg : call.args) {
    const bool is_kind = arg.name.text == "kind";
    if (!arg.name.text.empty() && !is_kind && arg.name.text != "text") {
      Diagnostic diagnostic =
          make_diagnostic("E0207", arg.name.span, {"error", std::string(arg.name.text)});
      diagnostic.why = "error accepts kind";
      checker.report(std::move(diagnostic));
      return checker.failed(call.span);
    }
    hir::Expr*& place = is_kind ? kind : message;
    if (place != nullptr) {
      checker.report(make_diagnostic(
          "E0312", arg.span, {"error", "1 text and a kind", std::to_string(call.args.size())}));
      return checker.failed(call.span);
    }
    place = checker.check_as(
        *arg.value,
        {.role = Target::Role::kArgument, .type = checker.types.text(), .function = "error"});
  }
  if (message == nullptr) {
    checker.report(
        make_diagnostic("E0312", call.callee->span, {"error", "1 text and a kind", "none"}));
    return checker.failed(call.span);
  }
  return checker.make<hir::ErrorExpr>(hir::ExprKind::kError, checker.shared.error_type, call.span,
                                      message, kind);
}

hir::Expr* conversion_call(Checker& checker, const ast::CallExpr& call, const Type* type,
                           std::string_view name) {
  if (!takes(checker, call, name, 1, 1)) return checker.failed(call.span);
  return cast(checker, checker.check_value(*call.args[0].value), type, call.span);
}

}  // namespace

hir::Expr* builtin_method(Checker& checker, hir::Expr* object, const ast::CallExpr& call,
                          const ast::MemberExpr& member, bool& known) {
  const std::string_view name = member.member.text;
  const Type* type = object->type;
  known = true;
  const auto no_values = [&] { return takes(checker, call, name, 0, 0); };
  if (name == "length" &&
      (type->is(Kind::kList) || type->is(Kind::kText) || type->is(Kind::kMap))) {
    if (!no_values()) return checker.failed(call.span);
    return checker.make<hir::LengthExpr>(hir::ExprKind::kLength, checker.types.integer(), call.span,
                                         object);
  }
  if (type->is(Kind::kList)) {
    if (name == "clone") return no_values() ? object : checker.failed(call.span);
    for (const ListMutation& change : kListMutations) {
      if (name == change.name) return mutation(checker, call, member, change.mutation);
    }
  }
  if (type->is(Kind::kMap)) {
    hir::Expr* result = call_of_map(checker, object, call, member);
    known = result != nullptr;
    return result;
  }
  if (type->is(Kind::kText) && name == "equals") {
    if (!takes(checker, call, name, 1, 1)) return checker.failed(call.span);
    hir::Expr* other = checker.check_as(
        *call.args[0].value,
        {.role = Target::Role::kArgument, .type = checker.types.text(), .function = "equals"});
    return checker.make<hir::BinaryExpr>(hir::ExprKind::kBinary, checker.types.boolean(), call.span,
                                         hir::Op::kEqText, object, other, member.member.span);
  }
  if (type == checker.shared.error_type && name == "getMessage") {
    if (!no_values()) return checker.failed(call.span);
    return checker.make<hir::FieldExpr>(
        hir::ExprKind::kField, checker.types.text(), call.span, object,
        static_cast<std::uint32_t>(type->record->index_of("message")));
  }
  known = false;
  return nullptr;
}

namespace {

hir::Expr* mutation(Checker& checker, const ast::CallExpr& call, const ast::MemberExpr& member,
                    hir::Mutation mutation) {
  using hir::Mutation;
  const std::string_view name = member.member.text;
  const bool has_index = mutation == Mutation::kInsert || mutation == Mutation::kRemoveAt;
  const bool has_value = mutation == Mutation::kPush || mutation == Mutation::kInsert;
  const std::size_t count = (has_index ? 1 : 0) + (has_value ? 1 : 0);
  if (!takes(checker, call, name, count, count)) return checker.failed(call.span);
  const auto place = checker.check_place(*member.object, call.span, false);
  if (!place) return checker.failed(call.span);
  const Type* element = place->type->element;
  hir::Expr* index = has_index ? index_value(checker, *call.args[0].value) : nullptr;
  hir::Expr* value = nullptr;
  if (has_value) {
    value = checker.check_as(*call.args[count - 1].value, {.role = Target::Role::kArgument,
                                                           .type = element,
                                                           .name = "element",
                                                           .function = name,
                                                           .position = static_cast<int>(count),
                                                           .call = call.span});
  }
  const Type* type = has_value ? checker.types.void_type() : element;
  return checker.make<hir::MutateExpr>(hir::ExprKind::kMutate, type, call.span, mutation, *place,
                                       index, value);
}

}  // namespace

}  // namespace armlet::lang
