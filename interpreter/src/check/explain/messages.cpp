// Messages that several parts of the checker share: unknown names and values of the wrong type.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "check/checker.hpp"
#include "check/explain/edits.hpp"
#include "check/explain/joined_lines.hpp"
#include "check/explain/nothings.hpp"
#include "check/names/imports.hpp"
#include "check/names/unknown_names.hpp"
#include "check/types/any_table.hpp"
#include "check/types/matrices.hpp"
#include "diagnostic/backticks.hpp"
#include "reference/language_words.hpp"

namespace armlet::lang {
namespace {

std::string ordinal(int position) {
  static constexpr std::array<std::string_view, 10> kWords = {
      "first", "second",  "third",  "fourth", "fifth",
      "sixth", "seventh", "eighth", "ninth",  "tenth"};
  if (position >= 1 && position <= 10) return std::string(kWords[position - 1]);
  return std::to_string(position) + "th";
}

}  // namespace

void Checker::report(Diagnostic diagnostic) {
  const FunctionContext& root = here_->root();
  const bool is_error = diagnostic.severity == Severity::kError;
  if (is_error && root.instance != nullptr && root.declaration->is_generic()) {
    std::string types;
    for (const Type* type : root.instance->types)
      types += (types.empty() ? "" : " and ") + type_phrase(type);
    diagnostic.related.push_back({root.instance->first_call, "called here with " + types});
  }
  if (is_error) {
    tell_of_joined_lines(joined_, diagnostic);
    ++errors_;
  }
  sink_.report(std::move(diagnostic));
}

hir::Expr* Checker::failed(Span span) {
  return make<hir::IntExpr>(hir::ExprKind::kInt, types_.any(), span, std::int64_t{0});
}

hir::Expr* Checker::not_available(Span span, std::string_view feature) {
  report(make_diagnostic("E0199", span, {std::string(feature)}));
  return failed(span);
}

void Checker::note_later(Span span, std::string feature) {
  later_.emplace(std::move(feature), span);
}

void Checker::report_later() {
  for (const auto& [feature, span] : later_) {
    sink_.begin_statement();
    report(make_diagnostic("E0199", span, {feature}));
  }
}

std::string Checker::text_of(Span span) const { return std::string(into_.sources->slice(span)); }

int Checker::line_of(Span span) const { return into_.sources->position(span).line; }

// For names of functions without one, which messages show while running.
std::string Checker::line_name(Span span) const {
  const std::string line = "line " + std::to_string(line_of(span));
  return is_main_file(*this) ? line : line + " of " + file_name(*this);
}

std::optional<Fix> Checker::did_you_mean(std::string_view name, Span span,
                                         const std::vector<std::string_view>& names) const {
  if (!takes_errors()) return std::nullopt;
  const auto found = suggest(name, std::span<const std::string_view>(names));
  if (!found) return std::nullopt;
  return Fix{.text = "did you mean " + in_backticks(*found) + "?",
             .edits = {{span, std::string(*found)}},
             .confidence = Confidence::kMaybe};
}

std::optional<Fix> Checker::did_you_mean(std::string_view name, Span span,
                                         const Type* wanted) const {
  if (!takes_errors()) return std::nullopt;
  std::vector<Candidate> own;
  std::map<std::string_view, Span> declared;
  const auto add = [&](const Local& local) {
    if (local.variable->name.empty()) return;
    own.push_back({local.variable->name, local.variable->type});
    declared[local.variable->name] = local.variable->declared;
  };
  for (const FunctionContext* context = here_; context != nullptr; context = context->outer) {
    std::ranges::for_each(context->locals, add);
  }
  if (&here_->root() != &main_) std::ranges::for_each(main_.locals, add);
  for (const auto& [function, declaration] : functions_) {
    own.push_back({function, wanted});
    declared[function] = declaration.node->name.span;
  }
  if (const auto found = suggest(name, std::span<const Candidate>(own), wanted)) {
    const int line = line_of(declared[found->name]);
    return Fix{.text = "did you mean " + in_backticks(found->name) + ", declared on line " +
                       std::to_string(line) + "?",
               .edits = {{span, std::string(found->name)}},
               .confidence = Confidence::kMaybe};
  }
  std::vector<std::string_view> library = registry_.public_names();
  for (const NativeFunction& word : language_words()) library.push_back(word.name);
  for (const auto& [type, unused] : named_types_) library.push_back(type);
  return did_you_mean(name, span, library);
}

// let f = fn(n: int) -> int => n * f(n - 1): a function that calls itself has a name.
static std::optional<Fix> named_function_fix(const Checker& checker, Span declared, Span use) {
  if (use.source != declared.source || use.begin < declared.end) return std::nullopt;
  const std::string between = checker.text_of({declared.end, use.begin, use.source});
  const std::size_t sign = between.find_first_not_of(" \t");
  if (sign == std::string::npos || between[sign] != '=') return std::nullopt;
  const std::size_t word = between.find_first_not_of(" \t", sign + 1);
  if (word == std::string::npos || !between.substr(word).starts_with("fn")) return std::nullopt;
  const std::string before = checker.text_of({0, declared.begin, use.source});
  const std::size_t keyword = before.find_last_not_of(" \t");
  if (keyword == std::string::npos || keyword < 2) return std::nullopt;
  const std::string_view let = std::string_view(before).substr(keyword - 2, 3);
  if (let != "let" && let != "var") return std::nullopt;
  const std::string name = "fn " + checker.text_of(declared);
  return Fix{.text = "a lambda does not know its own name: write " + name + "(...)",
             .edits = {{{static_cast<std::uint32_t>(keyword - 2),
                         static_cast<std::uint32_t>(declared.end + word + 2), use.source},
                        name}},
             .confidence = Confidence::kSure};
}

hir::Expr* Checker::unknown_name(std::string_view name, Span span, const Type* expected) {
  if (syntax_failed_ || !told_.emplace(name).second) return failed(span);
  if (!takes_errors()) {
    report(make_diagnostic("E0201", span, {std::string(name)}));
    return failed(span);
  }
  if (is_nothing(name)) {
    Diagnostic diagnostic = make_diagnostic("E0310", span, {std::string(name)});
    diagnostic.why = "every variable has a value of its type from the start";
    if (const std::string empty(expected != nullptr ? empty_value(*expected) : ""); !empty.empty())
      diagnostic.fix = Fix{.text = "write " + empty, .edits = {{span, empty}}};
    report(std::move(diagnostic));
    return failed(span);
  }
  if (const auto found = top_level_names_.find(name); found != top_level_names_.end()) {
    Diagnostic diagnostic = make_diagnostic("E0211", span, {std::string(name)});
    diagnostic.related.push_back({found->second, "declared here"});
    diagnostic.fix = named_function_fix(*this, found->second, span);
    report(std::move(diagnostic));
    return failed(span);
  }
  if (find_import(*this, name) != nullptr) {
    report(make_diagnostic("E0219", span, {std::string(name), "module"}));
    return failed(span);
  }
  if (registry_.is_planned(name)) return not_available(span, in_backticks(name));
  Diagnostic diagnostic = make_diagnostic("E0201", span, {std::string(name)});
  if (const ForeignName* foreign = foreign_name(name)) {
    diagnostic.why = foreign->note;
    if (!foreign->here.empty()) {
      diagnostic.fix = Fix{.text = "write " + std::string(foreign->here),
                           .edits = {{span, std::string(foreign->here)}},
                           .confidence = Confidence::kMaybe};
    }
  } else if (const std::string imported = imported_name(*this, name); !imported.empty()) {
    diagnostic.fix = Fix{
        .text = "write " + imported, .edits = {{span, imported}}, .confidence = Confidence::kSure};
  } else {
    diagnostic.fix = did_you_mean(name, span, expected);
  }
  report(std::move(diagnostic));
  return failed(span);
}

// ---- values of the wrong type ------------------------------------------------------------------

namespace {

bool is_handed_over(const Target& target) {
  return target.role == Target::Role::kArgument || target.role == Target::Role::kSetting;
}

// 1e9 and 2.0 as ints have them; empty for numbers with a fraction.
std::string as_whole_number(const std::string& text) {
  constexpr double kMostExact = 9e15;
  if (!is_decimal_number(text) || text.find('_') != std::string::npos) return {};
  const double number = std::strtod(text.c_str(), nullptr);
  if (std::trunc(number) != number || std::abs(number) > kMostExact) return {};
  return std::to_string(static_cast<std::int64_t>(number));
}

Diagnostic whole_number_needed(const Checker& checker, const hir::Expr& value) {
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
  // i / 3.0 for an int i: the same with a whole number.
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

// A list where the host's value made from it is needed.
Diagnostic host_value_needed(const Checker& checker, const hir::Expr& value, const Target& target,
                             bool constructible) {
  const HostType& host = *target.type->host;
  Diagnostic out =
      make_diagnostic("E0301", value.span, {ordinal(target.position), std::string(host.noun)});
  out.mark.label = "this is " + type_phrase(value.type);
  if (!host.use.empty()) out.why = in_backticks(target.function) + ' ' + std::string(host.use);
  if (!constructible) return out;
  const std::string made =
      "new " + std::string(host.name) + '(' + checker.text_of(value.span) + ')';
  const Span before{target.call.begin, value.span.begin, value.span.source};
  Span after{value.span.end, target.call.end, value.span.source};
  if (checker.text_of({after.end, after.end + 1, after.source}) == ";") ++after.end;
  out.fix = Fix{.text = "write " + checker.text_of(before) + made + checker.text_of(after),
                .edits = {{value.span, made}},
                .confidence = Confidence::kSure};
  return out;
}

// Whether the function that is called like the host's type makes one of a value like this.
bool is_made_from(Checker& checker, const Type* wanted, const Type* value) {
  const auto makers = checker.registry_.functions(wanted->host->name);
  return std::ranges::any_of(makers, [&](const NativeFunction* maker) {
    const Signature& signature = checker.signature_of(*maker);
    Bindings bindings;
    return signature.parameters.size() == 1 && !signature.parameters[0].variadic &&
           match(signature.parameters[0].type, value, false, bindings) >= 0;
  });
}

}  // namespace

hir::Expr* Checker::mismatch(const hir::Expr& value, const Target& target) {
  const Type* have = value.type;
  const Type* want = target.type;
  if (!takes_errors()) {  // what is said below may quote the whole call
    report(make_diagnostic("E0315", value.span, {"", ""}));
    return failed(value.span);
  }
  const std::string have_text = table_phrase(have);
  const std::string want_text = table_phrase(want);
  if (!have_text.empty() && !want_text.empty()) {
    Diagnostic diagnostic = make_diagnostic("E0315", value.span, {want_text, have_text});
    diagnostic.why = "all tables of a list, and of a field, have the same columns";
    report(std::move(diagnostic));
  } else if (have->is(Kind::kVoid)) {
    const std::string text = text_of(value.span);
    report(make_diagnostic("E0320", value.span, {text.substr(0, text.find('('))}));
  } else if (want->is(Kind::kInt) && have->is(Kind::kReal)) {
    report(whole_number_needed(*this, value));
  } else if (want->is_quantity() && (have->is(Kind::kInt) || have->is_double())) {
    plain_number_for_quantity(value, target);
  } else if (want->is_double() && have->is_quantity()) {
    quantity_for_number(value);
  } else if (want->is_quantity() && have->is_quantity()) {
    other_quantity(value, target);
  } else if (target.role == Target::Role::kArgument && want->is(Kind::kHost) &&
             !want->host->noun.empty()) {
    report(host_value_needed(*this, value, target, is_made_from(*this, want, have)));
  } else if (want->is_number() && have->is(Kind::kText)) {
    Diagnostic diagnostic = make_diagnostic("E0314", value.span, {"a text"});
    report(std::move(diagnostic));
  } else if (is_handed_over(target)) {
    Diagnostic diagnostic = make_diagnostic(
        "E0313", value.span, {std::string(target.function), type_phrase(want), type_phrase(have)});
    if (want->is(Kind::kHost) && is_made_from(*this, want, have)) {
      const std::string made = std::string(want->host->name) + '(' + text_of(value.span) + ')';
      diagnostic.fix = Fix{.text = "write " + made, .edits = {{value.span, made}}};
    }
    report(std::move(diagnostic));
  } else {
    Diagnostic diagnostic =
        make_diagnostic("E0315", value.span, {type_phrase(want), type_phrase(have)});
    if (want->is(Kind::kMatrix)) diagnostic.fix = matrix_from_list_fix(*this, value);
    report(std::move(diagnostic));
  }
  return failed(value.span);
}

}  // namespace armlet::lang
