#include "check/library/misfits.hpp"

#include <algorithm>

#include "check/functions/function_names.hpp"
#include "check/library/overloads.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

namespace {

void report_unknown_setting(Checker& checker, std::string_view name, const Signature& signature,
                            const Argument& at, bool ambient);
void report_count(Checker& checker, std::string_view name, const Signature& signature, Span callee,
                  const std::vector<Argument>& arguments, const Fit& fit);
void report_argument(Checker& checker, std::string_view name, const Signature& signature, Span span,
                     const std::vector<Argument>& arguments, const Fit& fit);

// The count of values that a function accepts: "1 value", "2 to 4 values", "at least 1 value".
std::string accepted_count(const Signature& signature, bool ambient) {
  std::size_t least = 0;
  std::size_t most = 0;
  bool open = false;
  for (std::size_t i = ambient ? 1 : 0; i < signature.parameters.size(); ++i) {
    ++most;
    if (!signature.parameters[i].may_be_left_out()) ++least;
    open = open || signature.parameters[i].variadic;
  }
  const auto counted = [](std::size_t n) {
    return std::to_string(n) + (n == 1 ? " value" : " values");
  };
  if (open) return "at least " + counted(least);
  if (most == 0) return "no values";
  return least == most ? counted(most) : std::to_string(least) + " to " + counted(most);
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    out += (i == 0 ? "" : i + 1 < words.size() ? ", " : " and ") + words[i];
  }
  return out;
}

// The count of values before the point: it is 1 for x.f(a) and does not count in messages.
int receivers(const std::vector<Argument>& arguments) {
  return !arguments.empty() && arguments[0].written == nullptr ? 1 : 0;
}

}  // namespace

void report_misfit(Checker& checker, std::string_view name, const Signature& signature, Span callee,
                   Span span, const std::vector<Argument>& arguments, const Fit& fit) {
  if (!checker.messages.takes_errors())
    return checker.report(make_diagnostic("E0312", callee, {"", "", ""}));
  if (refuse_decimal_comma(checker, arguments)) return;
  switch (fit.problem) {
    case Fit::Problem::kUnknownName:
      return report_unknown_setting(checker, name, signature, arguments[fit.argument], fit.ambient);
    case Fit::Problem::kTwice: {
      const Argument& at = arguments[fit.argument];
      return checker.report(make_diagnostic("E0212", at.name_span, {std::string(at.name)}));
    }
    case Fit::Problem::kAfterNamed:
      return checker.report(make_diagnostic("E0326", arguments[fit.argument].span()));
    case Fit::Problem::kTooMany:
    case Fit::Problem::kMissing:
      return report_count(checker, name, signature, callee, arguments, fit);
    case Fit::Problem::kType:
      return report_argument(checker, name, signature, span, arguments, fit);
    case Fit::Problem::kNone:
      return;
  }
}

namespace {

void report_unknown_setting(Checker& checker, std::string_view name, const Signature& signature,
                            const Argument& at, bool ambient) {
  if (checker.messages.was_told(at.name)) return;  // a field of a struct with mistakes
  std::vector<std::string> settings;
  std::vector<std::string_view> names;
  for (std::size_t p = ambient ? 1 : 0; p < signature.parameters.size(); ++p) {
    const Parameter& parameter = signature.parameters[p];
    names.push_back(parameter.name);
    if (parameter.may_be_left_out()) settings.push_back(parameter.name);
  }
  Diagnostic out =
      make_diagnostic("E0207", at.name_span, {std::string(name), std::string(at.name)});
  if (settings.empty()) settings.assign(names.begin(), names.end());
  if (!settings.empty()) out.why = std::string(name) + " accepts " + joined(settings);
  const ForeignName* foreign = checker.registry.foreign(at.name, ForeignKind::kSetting);
  std::string_view meant = foreign != nullptr ? foreign->here : "";
  if (std::ranges::find(names, meant) == names.end()) {
    meant = suggest(at.name, std::span<const std::string_view>(names)).value_or("");
  }
  if (!meant.empty()) {
    out.fix = Fix{.text = "did you mean " + std::string(meant) + "?",
                  .edits = {{at.name_span, std::string(meant)}},
                  .confidence = Confidence::kMaybe};
  }
  checker.report(std::move(out));
}

void report_count(Checker& checker, std::string_view name, const Signature& signature, Span callee,
                  const std::vector<Argument>& arguments, const Fit& fit) {
  const bool missing = fit.problem == Fit::Problem::kMissing;
  // The count of values does not matter if some are named.
  const auto by_name = [](const Argument& argument) { return !argument.name.empty(); };
  if (missing && std::ranges::any_of(arguments, by_name)) {
    checker.report(make_diagnostic("E0327", callee,
                                   {std::string(name), signature.parameters[fit.parameter].name}));
    return;
  }
  const int receiver = receivers(arguments);
  const int given = static_cast<int>(arguments.size()) - receiver;
  Diagnostic out =
      make_diagnostic("E0312", missing ? callee : arguments[fit.argument].span(),
                      {std::string(name), accepted_count(signature, fit.ambient || receiver > 0),
                       std::to_string(given)});
  if (missing) {
    out.why = '`' + signature.parameters[fit.parameter].name + "` is missing";
  } else {
    out.mark.label = "one too many";
  }
  checker.report(std::move(out));
}

std::string function_of(std::size_t values) {
  return "a function of " + (values == 1 ? "1 value" : std::to_string(values) + " values");
}

// The count of parameters of a lambda or a script function.
std::size_t parameters_of(Checker& checker, const ast::Expr& function) {
  if (function.kind == ast::ExprKind::kLambda) return function.as<ast::LambdaExpr>().params.size();
  const FunctionDecl* known = written_function(checker, function);
  return known != nullptr ? known->node->params.size() : 0;
}

// fn(a, b) => a.n - b.n compares two elements; in this language the key is a function of one
// element.
void key_for_comparison(const Checker& checker, const ast::Expr& function, Diagnostic& diagnostic) {
  if (function.kind != ast::ExprKind::kLambda) return;
  const auto& lambda = function.as<ast::LambdaExpr>();
  if (lambda.params.size() != 2) return;
  diagnostic.why = "the order is that of the value that the function gives for each element";
  if (lambda.value == nullptr || lambda.value->kind != ast::ExprKind::kBinary) return;
  using ast::BinaryOp;
  const auto& compared = lambda.value->as<ast::BinaryExpr>();
  const bool is_below = compared.op == BinaryOp::kSub || compared.op == BinaryOp::kLess ||
                        compared.op == BinaryOp::kLessEq;
  const bool is_above = compared.op == BinaryOp::kGreater || compared.op == BinaryOp::kGreaterEq;
  if (!is_below && !is_above) return;
  const std::string left = checker.text_of(compared.left->span);
  const std::string right = checker.text_of(compared.right->span);
  const std::string first(lambda.params[0].name.text);
  const std::string second(lambda.params[1].name.text);
  const auto is_of = [](const std::string& text, const std::string& name) {
    return text == name || text.starts_with(name + '.') || text.starts_with(name + '[');
  };
  const bool in_order = is_of(left, first) && is_of(right, second);
  const bool turned = is_of(left, second) && is_of(right, first);
  const std::string& name = in_order ? first : second;
  const std::string rest = left.substr(std::min(left.size(), name.size()));
  if ((!in_order && !turned) || right != (in_order ? second : first) + rest) return;
  const bool descends = in_order == is_above;
  const std::string key = "fn(" + name + ") => " + (descends ? "-" : "") + left;
  diagnostic.fix = Fix{
      .text = "write " + key, .edits = {{function.span, key}}, .confidence = Confidence::kMaybe};
}

// f(400mm, 0mm, 200mm): a library function makes the expected value from these values.
bool report_loose_parts(Checker& checker, std::string_view name, const Type& wanted,
                        const std::vector<Argument>& arguments, const Fit& fit) {
  if (!wanted.is(Kind::kHost)) return false;
  std::vector<Argument> parts;
  for (auto i = static_cast<std::size_t>(fit.argument); i < arguments.size(); ++i) {
    const Argument& part = arguments[i];
    if (!part.name.empty() || part.written == nullptr || part.waits() ||
        !part.value->type->is_number())
      break;
    parts.push_back(part);
  }
  if (parts.size() < 2) return false;
  std::string maker;
  for (const std::string_view known : checker.registry.public_names()) {
    for (const NativeFunction* function : checker.registry.functions(known)) {
      const Signature& signature = checker.shared.signatures.of(*function);
      const Fit attempt = lang::fit(checker, signature, parts, false);
      const bool makes = attempt.problem == Fit::Problem::kNone && attempt.cost == 0 &&
                         attempt.generic == 0 &&
                         instantiate(signature.result, attempt.bindings, checker.types) == &wanted;
      if (makes && (maker.empty() || known.size() < maker.size())) maker = known;
    }
  }
  if (maker.empty()) return false;
  const Span whole = cover(parts.front().span(), parts.back().span());
  const std::string made = maker + '(' + checker.text_of(whole) + ')';
  Diagnostic out = make_diagnostic(
      "E0313", parts.front().span(),
      {std::string(name), type_phrase(&wanted), type_phrase(parts.front().value->type)});
  out.fix =
      Fix{.text = "write " + made, .edits = {{whole, made}}, .confidence = Confidence::kMaybe};
  checker.report(std::move(out));
  return true;
}

void report_argument(Checker& checker, std::string_view name, const Signature& signature, Span span,
                     const std::vector<Argument>& arguments, const Fit& fit) {
  const Argument& at = arguments[fit.argument];
  const Parameter& parameter = signature.parameters[fit.parameter];
  const TypePattern& pattern = parameter.variadic ? parameter.type.parts[0] : parameter.type;
  const Type* wanted = at.waits() ? nullptr : instantiate(pattern, fit.bindings, checker.types);
  const bool variable = pattern.form != TypePattern::Form::kType;
  if (variable && wanted != nullptr && wanted->is_quantity() && at.value->type->is_quantity()) {
    checker.report(
        make_diagnostic("E0402", at.span(),
                        {type_phrase(at.value->type), "used together with", type_phrase(wanted)}));
    return;
  }
  if (wanted != nullptr && report_loose_parts(checker, name, *wanted, arguments, fit)) return;
  if (wanted != nullptr) {
    checker.require(at.value,
                    {.role = at.name.empty() ? Target::Role::kArgument : Target::Role::kSetting,
                     .type = wanted,
                     .name = variable ? std::string_view() : parameter.name,
                     .function = name,
                     .position = fit.argument + 1 - receivers(arguments),
                     .call = span});
    return;
  }
  const std::string have = at.waits() ? "a function" : type_phrase(at.value->type);
  if (pattern.form == TypePattern::Form::kDimension) {
    checker.report(make_diagnostic("E0314", at.span(), {have}));
    return;
  }
  if (at.waits() && pattern.form == TypePattern::Form::kFunction) {
    const std::string given = function_of(parameters_of(checker, *at.written));
    Diagnostic diagnostic = make_diagnostic(
        "E0313", at.span(), {std::string(name), function_of(pattern.parts.size() - 1), given});
    if (pattern.parts.size() == 2) key_for_comparison(checker, *at.written, diagnostic);
    checker.report(std::move(diagnostic));
    return;
  }
  const std::string need = pattern_name(pattern, fit.bindings, checker.types);
  checker.report(make_diagnostic(
      "E0313", at.span(), {std::string(name), std::string(article(need)) + ' ' + need, have}));
}

}  // namespace

}  // namespace armlet::lang
