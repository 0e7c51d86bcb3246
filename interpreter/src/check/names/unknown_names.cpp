#include "check/names/unknown_names.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "check/explain/edits.hpp"
#include "check/types/maps.hpp"
#include "syntax/tokens/foreign_words.hpp"

namespace armlet::lang {
namespace {

struct Meant {
  std::string_view found;
  std::string_view here;
};

constexpr auto kTypes = std::to_array<Meant>({
    {"Double", "double"},      {"Float", "double"},   {"real", "double"},
    {"number", "double"},      {"Number", "double"},  {"decimal", "double"},
    {"Integer", "int"},        {"Int", "int"},        {"integer", "int"},
    {"Long", "int"},           {"short", "int"},      {"byte", "int"},
    {"unsigned", "int"},       {"size_t", "int"},     {"int32_t", "int"},
    {"int64_t", "int"},        {"Boolean", "bool"},   {"Bool", "bool"},
    {"str", "string"},         {"char", "string"},    {"Str", "string"},
    {"text", "string"},        {"list", "double[]"},  {"vector", "double[]"},
    {"ArrayList", "double[]"}, {"array", "double[]"}, {"Point", "posC"},
    {"Pose", "posC"},          {"pose", "posC"},      {"Robot", "robot"},
    {"Exception", "error"},    {"Error", "error"},    {"Object", "object"},
});

template <std::size_t N>
std::string_view lookup(const std::array<Meant, N>& table, std::string_view word) {
  const auto found = std::ranges::find(table, word, &Meant::found);
  return found == table.end() ? std::string_view() : found->here;
}

// Whether a name can be a new one beside another: vy beside vx, p2 beside p1.
bool is_name_of_its_own(std::string_view name, std::string_view other) {
  constexpr std::size_t kShort = 2;
  const auto without_digits = [](std::string_view text) {
    std::string out(text);
    std::erase_if(out, [](char c) { return c >= '0' && c <= '9'; });
    return out;
  };
  return name.size() <= kShort || without_digits(name) == without_digits(other);
}

}  // namespace

void unknown_variable(Checker& checker, const ast::Expr& root, const ast::Expr& place,
                      Span statement) {
  const std::string_view name = root.as<ast::NameExpr>().name;
  if (checker.syntax_failed_ || !checker.told_.emplace(name).second) return;
  if (checker.top_level_names_.contains(name) || foreign_name(name) != nullptr ||
      checker.registry_.is_planned(name)) {
    checker.told_.erase(std::string(name));
    checker.unknown_name(name, root.span);
    return;
  }
  if (!checker.takes_errors())
    return checker.report(make_diagnostic("E0201", root.span, {std::string(name)}));
  std::vector<std::string_view> variables;
  for (const FunctionContext* context = checker.here_; context != nullptr;
       context = context->outer) {
    for (const Local& local : context->locals) variables.push_back(local.variable->name);
  }
  for (const Local& local : checker.main_.locals) variables.push_back(local.variable->name);
  Diagnostic diagnostic = make_diagnostic("E0201", root.span, {std::string(name)});
  diagnostic.fix = checker.did_you_mean(name, root.span, variables);
  const std::string text = checker.text_of(statement);
  const std::string rest = text.substr(std::min(text.size(), name.size()));
  const std::size_t mark = rest.find_first_not_of(" \t");
  const bool stores = mark != std::string::npos && rest[mark] == '=';
  const bool declares = &root == &place && stores && text.starts_with(name);
  if (declares && diagnostic.fix && is_name_of_its_own(name, diagnostic.fix->edits[0].text))
    diagnostic.fix.reset();
  if (!diagnostic.fix && declares) {
    const Span begin{statement.begin, statement.begin, statement.source};
    diagnostic.why = "a variable is declared with its first value";
    diagnostic.fix = Fix{.text = "write var " + text.substr(0, text.find('\n')),
                         .edits = {{begin, "var "}},
                         .confidence = Confidence::kSure};
  }
  checker.report(std::move(diagnostic));
}

hir::Expr* foreign_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, std::string_view full) {
  std::string better;
  if (const ForeignName* foreign = foreign_name(full)) better = foreign->here;
  constexpr std::array<std::string_view, 5> kModules = {"math", "np", "numpy", "cmath", "std"};
  const std::string_view group = full.substr(0, full.find('.'));
  const bool is_module = std::ranges::find(kModules, group) != kModules.end();
  if (is_module && !checker.registry_.functions(member.member.text).empty())
    better = member.member.text;
  if (better.empty()) return nullptr;
  const Span mark = cover(member.object->span, member.member.span);
  if (checker.syntax_failed_ || !checker.told_.emplace(full).second)
    return checker.failed(call.span);
  Diagnostic diagnostic = make_diagnostic("E0201", mark, {std::string(full)});
  diagnostic.fix =
      Fix{.text = "write " + better, .edits = {{mark, better}}, .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

hir::Expr* foreign_call(Checker& checker, const ast::CallExpr& call, std::string_view name) {
  constexpr std::array<std::string_view, 6> kLengths = {"len",    "size",   "count",
                                                        "sizeof", "strlen", "numel"};
  if (hir::Expr* told = foreign_empty_map(checker, name, call.args.size(), call.span)) return told;
  if (std::ranges::find(kLengths, name) == kLengths.end() || call.args.size() != 1) {
    return nullptr;
  }
  if (checker.syntax_failed_ || !checker.told_.emplace(name).second)
    return checker.failed(call.span);
  const std::string better = as_operand(checker.text_of(call.args[0].value->span)) + ".length";
  Diagnostic diagnostic = make_diagnostic("E0201", call.callee->span, {std::string(name)});
  diagnostic.fix = Fix{
      .text = "write " + better, .edits = {{call.span, better}}, .confidence = Confidence::kSure};
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
    diagnostic.why = type->is(Kind::kMap) ? "keys stand in square brackets"
                                          : "indexes stand in square brackets and count from 0";
    diagnostic.fix =
        Fix{.text = "write " + std::string(name) + '[' + checker.text_of(cover(first, last)) + ']',
            .edits = {{{call.callee->span.end, first.begin, first.source}, "["},
                      {{last.end, call.span.end, last.source}, "]"}},
            .confidence = Confidence::kSure};
  }
  checker.report(std::move(diagnostic));
  return checker.failed(call.span);
}

bool refuse_decimal_comma(Checker& checker, const std::vector<Argument>& arguments) {
  // One comma without a blank behind it, among others that have one.
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i + 1 < arguments.size(); ++i) {
    const ast::Expr* whole = arguments[i].written;
    const ast::Expr* part = arguments[i + 1].written;
    const bool touch = whole != nullptr && part != nullptr && arguments[i + 1].name.empty() &&
                       part->span.begin == whole->span.end + 1;
    if (touch && found) return false;
    if (touch) found = i;
  }
  if (!found || arguments.size() < 3) return false;
  const ast::Expr& whole = *arguments[*found].written;
  const ast::Expr& part = *arguments[*found + 1].written;
  const bool is_number =
      whole.kind == ast::ExprKind::kInt &&
      (part.kind == ast::ExprKind::kInt || part.kind == ast::ExprKind::kQuantity);
  const Span comma{whole.span.end, part.span.begin, part.span.source};
  if (!is_number || checker.text_of(comma) != ",") return false;
  Diagnostic diagnostic = make_diagnostic("E0108", cover(whole.span, part.span));
  diagnostic.fix =
      Fix{.text = "write " + checker.text_of(whole.span) + '.' + checker.text_of(part.span),
          .edits = {{comma, "."}},
          .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return true;
}

std::string_view empty_value(const Type& type) {
  if (type.is(Kind::kText)) return "\"\"";
  if (type.is(Kind::kList)) return "[]";
  if (type.is(Kind::kMap)) return "[:]";
  if (type.is(Kind::kBool)) return "false";
  if (type.is(Kind::kInt)) return "0";
  return type.is(Kind::kReal) ? "0.0" : std::string_view();
}

// MoveL p10, v1000, z50, tool0;  reads like a declaration of four variables.
static bool refuse_call_without_parentheses(Checker& checker, std::string_view name, Span span) {
  const ForeignName* foreign = foreign_name(name);
  const std::string function(foreign != nullptr ? foreign->here : name);
  if (checker.registry_.functions(function).empty()) return false;
  const std::string_view text = (*checker.into_.sources)[span.source].text().substr(span.end);
  const std::string line(text.substr(0, text.find('\n')));
  std::string first = line.substr(0, line.find_first_of(",;"));
  while (first.ends_with(' ') || first.ends_with('\r')) first.pop_back();
  first.erase(0, first.find_first_not_of(" \t"));
  const auto end = static_cast<std::uint32_t>(span.end + line.find_last_not_of("; \t\r") + 1);
  const std::string call = function + '(' + first + ')';
  Diagnostic diagnostic = make_diagnostic("E0201", span, {std::string(name)});
  diagnostic.why = "a call has parentheses, and settings have names: speed: 100mm/s, blend: 10mm";
  diagnostic.fix = Fix{.text = "write " + call,
                       .edits = {{{span.begin, end, span.source}, call}},
                       .confidence = Confidence::kMaybe};
  checker.report(std::move(diagnostic));
  return true;
}

bool refuse_foreign_type(Checker& checker, std::string_view name, Span span) {
  std::string_view here = meant_by(name, &ForeignWord::declares);
  const bool is_declaration = !here.empty();
  if (!is_declaration) here = lookup(kTypes, name);
  if (here.empty()) return refuse_call_without_parentheses(checker, name, span);
  const std::string better(here);
  Diagnostic diagnostic = is_declaration
                              ? make_diagnostic("E0130", span, {std::string(name), better})
                              : make_diagnostic("E0216", span, {std::string(name)});
  diagnostic.fix =
      Fix{.text = "write " + better, .edits = {{span, better}}, .confidence = Confidence::kSure};
  checker.report(std::move(diagnostic));
  return true;
}

}  // namespace armlet::lang
