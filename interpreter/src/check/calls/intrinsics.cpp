// Calls that the language itself understands: print, error, int(x), and the methods of lists and
// texts.

#include "armlet/interpreter/engine.hpp"
#include "check/calls/list_mutations.hpp"
#include "check/calls/printf.hpp"
#include "check/checker.hpp"
#include "check/tree/hand_on.hpp"
#include "check/types/maps.hpp"

namespace armlet::lang {
namespace {

Signal print_text(Vm& vm, Slot* args) {
  return vm.print(text_value(args[0])) ? give_nothing() : Signal::kFail;
}

constexpr NativeFunction kPrint = {
    .name = "print",
    .signature = "(text: string)",
    .help = "Writes its values, separated by spaces, and ends the line.",
    .example = "print(1, \"two\")",
    .thunk = &print_text};

Signal last_element(Vm& vm, Slot* args) {
  const auto* list = static_cast<const ListObj*>(args[0].o);
  if (list->size == 0) {
    Failure failure;
    failure.code = "R0606";
    failure.message = "an empty list has no last value";
    failure.mark_parameter = 0;
    return fail(vm, std::move(failure));
  }
  const Slot last = list->data[list->size - 1];
  if (list->holds_references() && last.o == nullptr) {
    Failure failure;
    failure.code = "R0623";
    failure.message = "the last element of this list is read before it has a value";
    failure.mark_parameter = 0;
    return fail(vm, std::move(failure));
  }
  if (list->holds_references()) retain(last.o);
  args[0] = last;
  return Signal::kDone;
}

}  // namespace

const NativeFunction kLast = {.name = "last",
                              .signature = "(xs: T[]) -> T",
                              .help = "The last value of a list.",
                              .example = "[1, 2].last",
                              .thunk = &last_element};

namespace {

std::string values(std::size_t least, std::size_t most) {
  if (most == 0) return "no values";
  const std::string count =
      least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
  return count + (most == 1 ? " value" : " values");
}

}  // namespace

// Whether the call has that many values, none of them named.
bool Checker::takes(const ast::CallExpr& call, std::string_view name, std::size_t least,
                    std::size_t most) {
  for (const ast::Arg& arg : call.args) {
    if (arg.name.text.empty()) continue;
    report(
        make_diagnostic("E0207", arg.name.span, {std::string(name), std::string(arg.name.text)}));
    return false;
  }
  if (call.args.size() >= least && call.args.size() <= most) return true;
  const Span mark = call.args.size() > most ? call.args[most].span : call.callee->span;
  report(make_diagnostic(
      "E0312", mark, {std::string(name), values(least, most), std::to_string(call.args.size())}));
  return false;
}

hir::Expr* Checker::intrinsic(const ast::CallExpr& call, std::string_view name, Span /*callee*/,
                              bool& known) {
  known = true;
  if (name == "print") return print_call(call, true);
  if (name == "error") return error_call(call);
  if (name == "int" || name == "long") return conversion_call(call, types_.integer(), name);
  if (name == "double" || name == "float") return conversion_call(call, types_.real(), name);
  if (name == kToText) {
    if (!takes(call, name, 1, 1)) return failed(call.span);
    return to_text(check_value(*call.args[0].value));
  }
  if (name == "assert" || name == "assertThrows") {
    report(make_diagnostic("E0320", call.span, {std::string(name)}));
    return failed(call.span);
  }
  known = false;
  return nullptr;
}

namespace {

hir::Expr* print_parts(Checker& checker, const ast::CallExpr& call,
                       const std::vector<hir::Expr*>& parts) {
  hir::Expr* text = checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types_.text(),
                                                  call.span, checker.seq(parts));
  const std::vector<Span> spans = {call.args_span};
  return checker.make<hir::CallNativeExpr>(
      hir::ExprKind::kCallNative, checker.types_.void_type(), call.span, &kPrint,
      checker.seq(std::vector<hir::Expr*>{text}),
      hir::CallSite{call.span, call.callee->span, checker.seq(spans)});
}

}  // namespace

hir::Expr* Checker::print_call(const ast::CallExpr& call, bool line) {
  mentioned_.insert("print");
  if (!takes(call, "print", 0, call.args.size())) return failed(call.span);
  std::vector<hir::Expr*> parts;
  const auto add = [&](std::string_view text) {
    parts.push_back(make<hir::TextExpr>(hir::ExprKind::kText, types_.text(), call.span, text));
  };
  for (const ast::Arg& arg : call.args) {
    if (!parts.empty()) add(" ");
    parts.push_back(to_text(check_value(*arg.value)));
  }
  if (line) add("\n");
  return print_parts(*this, call, parts);
}

hir::Expr* print_line(Checker& checker, const ast::CallExpr& call, hir::Expr* text) {
  checker.mentioned_.insert("print");
  hir::Expr* end =
      checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types_.text(), call.span, "\n");
  return print_parts(checker, call, {text, end});
}

hir::Expr* print_formatted(Checker& checker, const ast::CallExpr& call) {
  checker.mentioned_.insert("print");
  const auto parts = printf_parts(checker, call);
  return parts ? print_parts(checker, call, *parts) : checker.failed(call.span);
}

// The last value of a list that should be computed only once.
hir::Expr* Checker::last_call(hir::Expr* list, Span span) {
  const NativeFunction* const functions[] = {&kLast};
  return call_native("last", functions, span, span, {Argument{.value = list}});
}

hir::Expr* Checker::error_call(const ast::CallExpr& call) {
  hir::Expr* message = nullptr;
  hir::Expr* kind = nullptr;
  for (const ast::Arg& arg : call.args) {
    const bool is_kind = arg.name.text == "kind";
    if (!arg.name.text.empty() && !is_kind && arg.name.text != "text") {
      Diagnostic diagnostic =
          make_diagnostic("E0207", arg.name.span, {"error", std::string(arg.name.text)});
      diagnostic.why = "error accepts kind";
      report(std::move(diagnostic));
      return failed(call.span);
    }
    hir::Expr*& place = is_kind ? kind : message;
    if (place != nullptr) {
      report(make_diagnostic("E0312", arg.span,
                             {"error", "1 text and a kind", std::to_string(call.args.size())}));
      return failed(call.span);
    }
    place = check_as(*arg.value,
                     {.role = Target::Role::kArgument, .type = types_.text(), .function = "error"});
  }
  if (message == nullptr) {
    report(make_diagnostic("E0312", call.callee->span, {"error", "1 text and a kind", "none"}));
    return failed(call.span);
  }
  return make<hir::ErrorExpr>(hir::ExprKind::kError, error_type_, call.span, message, kind);
}

hir::Expr* Checker::conversion_call(const ast::CallExpr& call, const Type* type,
                                    std::string_view name) {
  if (!takes(call, name, 1, 1)) return failed(call.span);
  return cast(check_value(*call.args[0].value), type, call.span);
}

hir::Expr* Checker::builtin_method(hir::Expr* object, const ast::CallExpr& call,
                                   const ast::MemberExpr& member, bool& known) {
  const std::string_view name = member.member.text;
  const Type* type = object->type;
  known = true;
  const auto no_values = [&] { return takes(call, name, 0, 0); };
  if (name == "length" &&
      (type->is(Kind::kList) || type->is(Kind::kText) || type->is(Kind::kMap))) {
    if (!no_values()) return failed(call.span);
    return make<hir::LengthExpr>(hir::ExprKind::kLength, types_.integer(), call.span, object);
  }
  if (type->is(Kind::kList)) {
    if (name == "clone") return no_values() ? object : failed(call.span);
    for (const ListMutation& change : kListMutations) {
      if (name == change.name) return mutation(call, member, change.mutation);
    }
  }
  if (type->is(Kind::kMap)) {
    hir::Expr* result = call_of_map(*this, object, call, member);
    known = result != nullptr;
    return result;
  }
  if (type->is(Kind::kText) && name == "equals") {
    if (!takes(call, name, 1, 1)) return failed(call.span);
    hir::Expr* other =
        check_as(*call.args[0].value,
                 {.role = Target::Role::kArgument, .type = types_.text(), .function = "equals"});
    return make<hir::BinaryExpr>(hir::ExprKind::kBinary, types_.boolean(), call.span,
                                 hir::Op::kEqText, object, other, member.member.span);
  }
  if (type == error_type_ && name == "getMessage") {
    if (!no_values()) return failed(call.span);
    return make<hir::FieldExpr>(hir::ExprKind::kField, types_.text(), call.span, object,
                                static_cast<std::uint32_t>(type->record->index_of("message")));
  }
  known = false;
  return nullptr;
}

hir::Expr* Checker::mutation(const ast::CallExpr& call, const ast::MemberExpr& member,
                             hir::Mutation mutation) {
  using hir::Mutation;
  const std::string_view name = member.member.text;
  const bool has_index = mutation == Mutation::kInsert || mutation == Mutation::kRemoveAt;
  const bool has_value = mutation == Mutation::kPush || mutation == Mutation::kInsert;
  const std::size_t count = (has_index ? 1 : 0) + (has_value ? 1 : 0);
  if (!takes(call, name, count, count)) return failed(call.span);
  const auto place = check_place(*member.object, call.span, false);
  if (!place) return failed(call.span);
  const Type* element = place->type->element;
  hir::Expr* index = has_index ? index_value(*call.args[0].value) : nullptr;
  hir::Expr* value = nullptr;
  if (has_value) {
    value = check_as(*call.args[count - 1].value, {.role = Target::Role::kArgument,
                                                   .type = element,
                                                   .name = "element",
                                                   .function = name,
                                                   .position = static_cast<int>(count),
                                                   .call = call.span});
  }
  const Type* type = has_value ? types_.void_type() : element;
  return make<hir::MutateExpr>(hir::ExprKind::kMutate, type, call.span, mutation, *place, index,
                               value);
}

}  // namespace armlet::lang
