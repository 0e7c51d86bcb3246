#include "check/names/unknown_names.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "armlet/interpreter/world_names.hpp"
#include "base/diagnostic/backticks.hpp"
#include "base/foreign_words.hpp"
#include "check/explain/file_names.hpp"
#include "check/explain/nothings.hpp"
#include "check/names/imports.hpp"
#include "vocabulary/language_words.hpp"

namespace armlet::lang {
namespace {

// Whether a name may be intended as a new one beside a similar one: vy and vx, p2 and p1.
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
  if (!checker.messages.is_news(name)) return;
  if (checker.names.find_variable(name) != nullptr || checker.registry.foreign(name) != nullptr) {
    checker.messages.forget(name);
    unknown_name(checker, name, root.span);
    return;
  }
  if (!checker.messages.takes_errors())
    return checker.report(make_diagnostic("E0201", root.span, {std::string(name)}));
  std::vector<std::string_view> variables;
  for (const FunctionContext* context = &checker.scopes.here(); context != nullptr;
       context = context->outer) {
    for (const Local& local : context->locals) variables.push_back(local.variable->name);
  }
  for (const Local& local : checker.scopes.main().locals) variables.push_back(local.variable->name);
  for (const KeptName* kept : checker.names.all_earlier())
    if (kept->variable != nullptr) variables.push_back(kept->name);
  Diagnostic diagnostic = make_diagnostic("E0201", root.span, {std::string(name)});
  diagnostic.fix = did_you_mean(checker, name, root.span, variables);
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

bool refuse_decimal_comma(Checker& checker, const std::vector<Argument>& arguments) {
  // Searches a single comma without a blank after it, among others with one.
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

// go p10, v1000, z50, tool0;  is parsed as a declaration of four variables.
static bool refuse_call_without_parentheses(Checker& checker, std::string_view name, Span span) {
  const ForeignName* foreign = checker.registry.foreign(name);
  const std::string function(foreign != nullptr ? foreign->here : name);
  if (checker.registry.functions(function).empty()) return false;
  const std::string_view text = (*checker.into.sources)[span.source].text().substr(span.end);
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
  if (here.empty()) here = type_meant_by(name);
  if (const ForeignName* type = checker.registry.foreign(name, ForeignKind::kType);
      here.empty() && type != nullptr)
    here = type->here;
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

std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name, Span span,
                                const std::vector<std::string_view>& names) {
  if (!checker.messages.takes_errors()) return std::nullopt;
  const auto found = suggest(name, std::span<const std::string_view>(names));
  if (!found) return std::nullopt;
  return Fix{.text = "did you mean " + in_backticks(*found) + "?",
             .edits = {{span, std::string(*found)}},
             .confidence = Confidence::kMaybe};
}

std::optional<Fix> did_you_mean(const Checker& checker, std::string_view name, Span span,
                                const Type* wanted) {
  if (!checker.messages.takes_errors()) return std::nullopt;
  std::vector<Candidate> own;
  std::map<std::string_view, Span> declared;
  const auto add = [&](const Local& local) {
    if (local.variable->name.empty()) return;
    own.push_back({local.variable->name, local.variable->type});
    declared[local.variable->name] = local.variable->declared;
  };
  for (const FunctionContext* context = &checker.scopes.here(); context != nullptr;
       context = context->outer) {
    std::ranges::for_each(context->locals, add);
  }
  if (!checker.scopes.in_program()) std::ranges::for_each(checker.scopes.main().locals, add);
  for (const auto& [function, declaration] : checker.names.functions()) {
    own.push_back({function, wanted});
    declared[function] = declaration.node->name.span;
  }
  for (const KeptName* kept : checker.names.all_earlier()) {
    if (kept->variable == nullptr && kept->function == nullptr) continue;
    const auto [at, is_new] = declared.try_emplace(kept->name, kept->declared);
    if (is_new)
      own.push_back({kept->name, kept->variable != nullptr ? kept->variable->type : wanted});
  }
  if (const auto found = suggest(name, std::span<const Candidate>(own), wanted)) {
    return Fix{.text = "did you mean " + in_backticks(found->name) + ", declared on " +
                       line_phrase(checker, declared[found->name]) + "?",
               .edits = {{span, std::string(found->name)}},
               .confidence = Confidence::kMaybe};
  }
  std::vector<std::string_view> library = checker.registry.public_names();
  for (const NativeFunction& word : language_words()) library.push_back(word.name);
  for (const auto& [type, unused] : checker.names.types()) library.push_back(type);
  for (const auto& [import, unused] : checker.names.imports()) library.push_back(import);
  return did_you_mean(checker, name, span, library);
}

// let f = fn(n: int) -> int => n * f(n - 1): only a named function can call itself.
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

// object("cube") for the undeclared name `cube`.
static std::optional<Fix> fix_of_world(const Checker& checker, std::string_view name, Span span) {
  const WorldNames* world = checker.options.world.get();
  if (world == nullptr || world->maker.empty() || !world->has(name)) return std::nullopt;
  const std::string made = world->maker + "(\"" + std::string(name) + "\")";
  return Fix{.text = "write " + made, .edits = {{span, made}}, .confidence = Confidence::kSure};
}

// The full form of a name that is used after a point: State.Idle, pal.slot, group.member. Empty if
// there is none, or if there are several.
static std::string whole_name(const Checker& checker, std::string_view name) {
  if (std::string imported = imported_name(checker, name); !imported.empty()) return imported;
  std::vector<std::string> found;
  for (const auto& [type_name, type] : checker.names.types()) {
    if (!type->is(Kind::kEnum)) continue;
    if (std::ranges::find(type->enumeration->values, name) != type->enumeration->values.end())
      found.push_back(std::string(type_name) + '.' + std::string(name));
  }
  for (const std::string_view known : checker.registry.public_names()) {
    const std::size_t point = known.rfind('.');
    const bool is_it = point != std::string_view::npos && known.substr(point + 1) == name &&
                       checker.registry.is_namespace(known.substr(0, point));
    if (is_it) found.emplace_back(known);
  }
  return found.size() == 1 ? found[0] : std::string();
}

// s^2 for the s2 of 5m/s2; empty for other names.
static std::string unit_with_exponent(const Checker& checker, std::string_view name, Span span) {
  const std::size_t letters = name.find_first_of("0123456789");
  if (letters == std::string_view::npos || letters + 1 != name.size() || span.begin < 2) return {};
  const std::string before = checker.text_of({span.begin - 2, span.begin, span.source});
  const bool follows = (before[1] == '/' || before[1] == '*') && before[0] != ' ';
  if (!follows || unit_named(name.substr(0, letters)) == nullptr) return {};
  return std::string(name.substr(0, letters)) + '^' + std::string(name.substr(letters));
}

hir::Expr* unknown_name(Checker& checker, std::string_view name, Span span, const Type* expected) {
  if (!checker.messages.is_news(name)) return checker.failed(span);
  if (!checker.messages.takes_errors()) {
    checker.report(make_diagnostic("E0201", span, {std::string(name)}));
    return checker.failed(span);
  }
  if (is_nothing(name)) {
    Diagnostic diagnostic = make_diagnostic("E0310", span, {std::string(name)});
    diagnostic.why = "every variable has a value of its type from the start";
    if (const std::string empty(expected != nullptr ? empty_value(*expected) : ""); !empty.empty())
      diagnostic.fix = Fix{.text = "write " + empty, .edits = {{span, empty}}};
    checker.report(std::move(diagnostic));
    return checker.failed(span);
  }
  if (const Span* declared = checker.names.find_variable(name)) {
    Diagnostic diagnostic = make_diagnostic("E0211", span, {std::string(name)});
    diagnostic.related.push_back({*declared, "declared here"});
    diagnostic.fix = named_function_fix(checker, *declared, span);
    checker.report(std::move(diagnostic));
    return checker.failed(span);
  }
  if (checker.names.find_import(name) != nullptr) {
    checker.report(make_diagnostic("E0219", span, {std::string(name), "module"}));
    return checker.failed(span);
  }
  Diagnostic diagnostic = make_diagnostic("E0201", span, {std::string(name)});
  if (const ForeignName* foreign = checker.registry.foreign(name)) {
    diagnostic.why = foreign->note;
    if (!foreign->here.empty()) {
      diagnostic.fix = Fix{.text = "write " + std::string(foreign->here),
                           .edits = {{span, std::string(foreign->here)}},
                           .confidence = Confidence::kMaybe};
    }
  } else if (const std::string whole = whole_name(checker, name); !whole.empty()) {
    diagnostic.fix =
        Fix{.text = "write " + whole, .edits = {{span, whole}}, .confidence = Confidence::kSure};
  } else if (const std::string unit = unit_with_exponent(checker, name, span); !unit.empty()) {
    diagnostic.why = "the exponent of a unit is written with ^";
    diagnostic.fix =
        Fix{.text = "write " + unit, .edits = {{span, unit}}, .confidence = Confidence::kSure};
  } else if (auto fix = fix_of_world(checker, name, span)) {
    diagnostic.why = "it is a thing of the world, and no variable";
    diagnostic.fix = std::move(fix);
  } else {
    diagnostic.fix = did_you_mean(checker, name, span, expected);
  }
  checker.report(std::move(diagnostic));
  return checker.failed(span);
}

}  // namespace armlet::lang
