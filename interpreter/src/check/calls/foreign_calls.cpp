#include "check/calls/foreign_calls.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "check/calls/map_calls.hpp"
#include "check/explain/edits.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"

namespace armlet::lang {

hir::Expr* foreign_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, std::string_view full) {
  std::string better;
  if (const ForeignName* foreign = checker.registry.foreign(full)) better = foreign->here;
  constexpr std::array<std::string_view, 5> kModules = {"math", "np", "numpy", "cmath", "std"};
  const std::string_view group = full.substr(0, full.find('.'));
  const bool is_module = std::ranges::find(kModules, group) != kModules.end();
  if (is_module && !checker.registry.functions(member.member.text).empty())
    better = member.member.text;
  if (better.empty()) return nullptr;
  const Span mark = cover(member.object->span, member.member.span);
  if (!checker.messages.is_news(full)) return checker.failed(call.span);
  Diagnostic diagnostic = make_diagnostic("E0201", mark, {std::string(full)});
  diagnostic.fix =
      Fix{.text = "write " + better, .edits = {{mark, better}}, .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

hir::Expr* unknown_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, const Type& type) {
  const std::string_view name = member.member.text;
  const std::string object = checker.text_of(member.object->span);
  std::string better;
  if (name == "get" && call.args.size() == 1 && type.is(Kind::kList)) {
    better = object + '[' + checker.text_of(call.args[0].value->span) + ']';
  } else if (name == "toString" && call.args.empty()) {
    better = "string(" + object + ')';
  } else if (const std::string imported = imported_name(checker, name); !imported.empty()) {
    const std::string_view source = (*checker.into.sources)[call.span.source].text();
    const std::string behind(
        source.substr(member.member.span.end, call.span.end - member.member.span.end));
    const std::size_t open = behind.find('(');
    if (open != std::string::npos)
      better = imported + '(' + object + (call.args.empty() ? ")" : ", " + behind.substr(open + 1));
  }
  if (better.empty()) return unknown_name(checker, name, member.member.span);
  if (!checker.messages.is_news(name)) return checker.failed(call.span);
  Diagnostic diagnostic = make_diagnostic("E0201", member.member.span, {std::string(name)});
  diagnostic.fix = Fix{
      .text = "write " + better, .edits = {{call.span, better}}, .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

hir::Expr* foreign_call(Checker& checker, const ast::CallExpr& call, std::string_view name) {
  constexpr std::array<std::string_view, 7> kLengths = {"len",    "size",   "count", "length",
                                                        "sizeof", "strlen", "numel"};
  const bool counts_bytes = name == "sizeof";
  if (hir::Expr* told = foreign_empty_map(checker, name, call.args.size(), call.span)) return told;
  if (std::ranges::find(kLengths, name) == kLengths.end() || call.args.size() != 1) {
    return nullptr;
  }
  if (!checker.messages.is_news(name)) return checker.failed(call.span);
  const std::string better = as_operand(checker.text_of(call.args[0].value->span)) + ".length";
  Diagnostic diagnostic = make_diagnostic("E0201", call.callee->span, {std::string(name)});
  diagnostic.fix = Fix{
      .text = "write " + better, .edits = {{call.span, better}}, .confidence = Confidence::kSure};
  if (counts_bytes) {
    diagnostic.why = "sizeof counts bytes; .length is how many values there are";
    diagnostic.fix->edits.clear();
  }
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

hir::Expr* not_a_function(Checker& checker, const ast::CallExpr& call, std::string_view name,
                          const Type* type) {
  Diagnostic diagnostic =
      make_diagnostic("E0217", call.callee->span, {std::string(name), type_phrase(type)});
  const bool is_matrix = type->is(Kind::kMatrix);
  const bool has_parts =
      type->is(Kind::kList) || type->is(Kind::kText) || type->is(Kind::kMap) || is_matrix;
  const bool has_indexes = call.args.size() == 1 || (is_matrix && call.args.size() == 2);
  const bool are_named =
      std::ranges::any_of(call.args, [](const ast::Arg& arg) { return !arg.name.text.empty(); });
  if (has_parts && has_indexes && !are_named) {
    const Span first = call.args[0].value->span;
    const Span last = call.args[call.args.size() - 1].value->span;
    const std::string meant = std::string(name) + '[' + checker.text_of(cover(first, last)) + ']';
    // Languages with round brackets for indices count from 1; only an index 0 shows that the
    // program counts from 0.
    const bool counts_from_zero = std::ranges::any_of(
        call.args, [&](const ast::Arg& arg) { return checker.text_of(arg.value->span) == "0"; });
    if (type->is(Kind::kMap) || counts_from_zero) {
      diagnostic.why = type->is(Kind::kMap) ? "keys stand in square brackets"
                                            : "indexes stand in square brackets and count from 0";
      diagnostic.fix = Fix{.text = "write " + meant,
                           .edits = {{{call.callee->span.end, first.begin, first.source}, "["},
                                     {{last.end, call.span.end, last.source}, "]"}},
                           .confidence = Confidence::kSure};
    } else {
      diagnostic.why = "indexes stand in square brackets and count from 0";
      diagnostic.fix = Fix{"write " + meant + ", or one less where you counted from 1"};
    }
  }
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

}  // namespace armlet::lang
