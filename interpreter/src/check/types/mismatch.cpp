#include "check/types/mismatch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "base/diagnostic/backticks.hpp"
#include "check/explain/edits.hpp"
#include "check/explain/mismatch_units.hpp"
#include "check/state/checker.hpp"
#include "check/types/any_table.hpp"
#include "vocabulary/language_words.hpp"

namespace armlet::lang {
namespace {

// A list where a matrix is needed: how a matrix with these rows is written.
std::optional<Fix> matrix_from_list_fix(const Checker& checker, const hir::Expr& list) {
  if (!list.type->is(Kind::kList)) return std::nullopt;
  const bool nested = list.type->element->is(Kind::kList);
  if (!nested) {
    Fix fix{.text = "a matrix has `;` between its rows; [1, 2;] is one row"};
    const Span end{list.span.end - 1, list.span.end - 1, list.span.source};
    if (list.kind == hir::ExprKind::kList && checker.text_of(list.span).ends_with(']'))
      fix.edits.push_back({end, ";"});
    return fix;
  }
  std::string text = "matrix(" + checker.text_of(list.span) + ')';
  if (list.kind == hir::ExprKind::kList) {
    std::string rows;
    bool written = true;
    for (const hir::Expr* row : list.as<hir::ListExpr>().items) {
      const std::string inside = checker.text_of(row->span);
      written = written && row->kind == hir::ExprKind::kList && inside.size() > 2;
      if (written) rows += (rows.empty() ? "" : "; ") + inside.substr(1, inside.size() - 2);
    }
    if (written && !rows.empty()) text = '[' + rows + ']';
  }
  return Fix{.text = "write " + text, .edits = {{list.span, text}}};
}

std::string ordinal(int position) {
  static constexpr std::array<std::string_view, 10> kWords = {
      "first", "second",  "third",  "fourth", "fifth",
      "sixth", "seventh", "eighth", "ninth",  "tenth"};
  if (position >= 1 && position <= 10) return std::string(kWords[position - 1]);
  const int last = position % 10;
  const bool teen = position % 100 >= 11 && position % 100 <= 13;
  const char* const ending = teen || last == 0 || last > 3 ? "th"
                             : last == 1                   ? "st"
                             : last == 2                   ? "nd"
                                                           : "rd";
  return std::to_string(position) + ending;
}

}  // namespace

namespace {

bool is_handed_over(const Target& target) {
  return target.role == Target::Role::kArgument || target.role == Target::Role::kSetting;
}

// The int for numbers such as 1e9 and 2.0; empty for numbers with a fraction.
std::string as_whole_number(const std::string& text) {
  constexpr double kMostExact = 9e15;
  if (!is_decimal_number(text) || text.find('_') != std::string::npos) return {};
  const double number = std::strtod(text.c_str(), nullptr);
  if (std::trunc(number) != number || std::abs(number) > kMostExact) return {};
  return std::to_string(static_cast<std::int64_t>(number));
}

// [1, 2].fold(0, fn(a, x) => a + x / 2.0): the result of a fold has the type of its start.
Diagnostic whole_start_of_fold(const Checker& checker, const hir::Expr& value, Span start) {
  Diagnostic out = make_diagnostic("E0303", value.span, {type_phrase(value.type)});
  const std::string text = checker.text_of(start);
  out.why = "the fold starts from an int, " + in_backticks(text) + ", and its function gives " +
            type_phrase(value.type);
  out.related.push_back({start, "the start"});
  if (text.find_first_not_of("0123456789") != std::string::npos) return out;
  const Span end{start.end, start.end, start.source};
  out.fix = Fix{.text = "write fold(" + text + ".0, ...)",
                .edits = {{end, ".0"}},
                .confidence = Confidence::kSure};
  return out;
}

Diagnostic whole_number_needed(const Checker& checker, const hir::Expr& value,
                               const Target& target) {
  const Span start = checker.surroundings.start_of_fold();
  if (target.role == Target::Role::kResult && !start.empty() && value.type->is_double())
    return whole_start_of_fold(checker, value, start);
  Diagnostic out = make_diagnostic("E0303", value.span, {type_phrase(value.type)});
  if (!value.type->is_double()) return out;
  const std::string text = checker.text_of(value.span);
  if (const std::string whole = as_whole_number(text); !whole.empty()) {
    out.why = "a number with a point or an exponent is a double";
    out.fix = Fix{
        .text = "write " + whole, .edits = {{value.span, whole}}, .confidence = Confidence::kSure};
    return out;
  }
  out.why = "storing it in an int would lose the fraction";
  const std::string cut = "int(" + text + ")";
  out.fix =
      Fix{.text = "write " + cut, .edits = {{value.span, cut}}, .confidence = Confidence::kMaybe};
  if (value.kind != hir::ExprKind::kBinary || value.as<hir::BinaryExpr>().op != hir::Op::kDivR)
    return out;
  // i / 3.0 for an int i: the fix is an int divisor.
  const auto& division = value.as<hir::BinaryExpr>();
  const std::string right = checker.text_of(division.right->span);
  if (division.left->kind != hir::ExprKind::kConvert || !right.ends_with(".0")) return out;
  const std::string whole =
      checker.text_of({value.span.begin, division.right->span.begin, value.span.source}) +
      right.substr(0, right.size() - 2);
  out.fix = Fix{.text = "write " + whole + " (whole-number division) or " + cut,
                .edits = {{value.span, whole}},
                .confidence = Confidence::kMaybe};
  return out;
}

// The message for a list where a host value is expected that can be made from it.
Diagnostic host_value_needed(const Checker& checker, const hir::Expr& value, const Target& target,
                             bool constructible) {
  const HostType& host = *target.type->host;
  Diagnostic out =
      make_diagnostic("E0301", value.span, {ordinal(target.position), std::string(host.noun)});
  out.mark.label = "this is " + type_phrase(value.type);
  if (!host.use.empty()) out.why = in_backticks(target.function) + ' ' + std::string(host.use);
  if (!constructible) return out;
  // What the classic style calls an object is made with `new`.
  const std::string made = (host.use.empty() ? "" : "new ") + std::string(host.name) + '(' +
                           checker.text_of(value.span) + ')';
  const Span before{target.call.begin, value.span.begin, value.span.source};
  Span after{value.span.end, target.call.end, value.span.source};
  if (checker.text_of({after.end, after.end + 1, after.source}) == ";") ++after.end;
  out.fix = Fix{.text = "write " + checker.text_of(before) + made + checker.text_of(after),
                .edits = {{value.span, made}},
                .confidence = Confidence::kSure};
  return out;
}

// Whether the function with the name of the host type makes a value of that type from this one.
bool is_made_from(Checker& checker, const Type* wanted, const Type* value) {
  const auto makers = checker.registry.functions(wanted->host->name);
  return std::ranges::any_of(makers, [&](const NativeFunction* maker) {
    const Signature& signature = checker.shared.signatures.of(*maker);
    Bindings bindings;
    return signature.parameters.size() == 1 && !signature.parameters[0].variadic &&
           match(signature.parameters[0].type, value, false, bindings) >= 0;
  });
}

}  // namespace

// In a session a name can be declared again.
std::string namesakes(const Type* one, const Type* other) {
  const std::string name = type_name(one);
  if (one == other || name != type_name(other)) return {};
  return "`" + name + "` was declared again, and a value keeps the type that it was made with";
}

hir::Expr* mismatch(Checker& checker, const hir::Expr& value, const Target& target) {
  const Type* have = value.type;
  const Type* want = target.type;
  if (!checker.messages.takes_errors()) {  // the text below may contain the whole call
    checker.report(make_diagnostic("E0315", value.span, {"", ""}));
    return checker.failed(value.span);
  }
  const std::string have_text = table_phrase(have);
  const std::string want_text = table_phrase(want);
  if (!have_text.empty() && !want_text.empty()) {
    Diagnostic diagnostic = make_diagnostic("E0315", value.span, {want_text, have_text});
    diagnostic.why = "all tables of a list, and of a field, have the same columns";
    checker.report(std::move(diagnostic));
  } else if (have->is(Kind::kVoid)) {
    const std::string text = checker.text_of(value.span);
    checker.report(make_diagnostic("E0320", value.span, {text.substr(0, text.find('('))}));
  } else if (want->is(Kind::kInt) && have->is(Kind::kReal)) {
    checker.report(whole_number_needed(checker, value, target));
  } else if (want->is_quantity() && (have->is(Kind::kInt) || have->is_double())) {
    plain_number_for_quantity(checker, value, target);
  } else if (want->is_double() && have->is_quantity()) {
    quantity_for_number(checker, value);
  } else if (want->is_quantity() && have->is_quantity()) {
    other_quantity(checker, value, target);
  } else if (target.role == Target::Role::kArgument && target.position >= 1 &&
             want->is(Kind::kHost) && !want->host->noun.empty()) {
    checker.report(host_value_needed(checker, value, target, is_made_from(checker, want, have)));
  } else if (want->is_number() && have->is(Kind::kText)) {
    Diagnostic diagnostic = make_diagnostic("E0314", value.span, {"a text"});
    checker.report(std::move(diagnostic));
  } else if (is_handed_over(target)) {
    Diagnostic diagnostic = make_diagnostic(
        "E0313", value.span, {std::string(target.function), type_phrase(want), type_phrase(have)});
    diagnostic.why = namesakes(want, have);
    if (diagnostic.why.empty() && target.role == Target::Role::kSetting && !target.name.empty() &&
        !want->is(Kind::kHost))
      diagnostic.why = in_backticks(target.name) + " is " + type_phrase(want);
    if (want->is(Kind::kHost) && have->is(Kind::kList) && have->element == want &&
        value.kind == hir::ExprKind::kVariable)
      diagnostic.fix = Fix{.text = "for one of them write " + checker.text_of(value.span) + "[0]"};
    if (want->is(Kind::kHost) && is_made_from(checker, want, have)) {
      const std::string made =
          std::string(want->host->name) + '(' + checker.text_of(value.span) + ')';
      diagnostic.fix = Fix{.text = "write " + made, .edits = {{value.span, made}}};
    }
    if (want->is(Kind::kMatrix)) diagnostic.fix = matrix_from_list_fix(checker, value);
    checker.report(std::move(diagnostic));
  } else {
    Diagnostic diagnostic =
        make_diagnostic("E0315", value.span, {type_phrase(want), type_phrase(have)});
    diagnostic.why = namesakes(want, have);
    if (want->is(Kind::kMatrix)) diagnostic.fix = matrix_from_list_fix(checker, value);
    checker.report(std::move(diagnostic));
  }
  return checker.failed(value.span);
}

}  // namespace armlet::lang
