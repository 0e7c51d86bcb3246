// with (name: value, ...) { }: settings of the library inside the block.
//
// A setting whose name is an ambient type, such as motor, has an effect at compile time: calls
// inside the block that omit the argument use this value. Other settings are functions of the host,
// which run at the start of the block; every exit from the block restores the previous values.

#include "check/statements/settings.hpp"

#include <algorithm>
#include <unordered_set>

#include "check/library/native_calls.hpp"
#include "check/names/unknown_names.hpp"
#include "check/names/variables.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kWith = "with";

void unknown_setting(Checker& checker, std::string_view word, const ast::Arg& setting) {
  const std::string prefix = std::string(word) + '.';
  if (!checker.messages.takes_errors())
    return checker.report(make_diagnostic("E0207", setting.span, {std::string(word), ""}));
  std::vector<std::string_view> known;
  for (const std::string_view name : checker.registry.public_names()) {
    if (name.starts_with(prefix)) known.push_back(name.substr(prefix.size()));
  }
  for (const auto& [name, type] : checker.registry.types()) {
    if (type->is_ambient && word == kWith) known.push_back(name);
  }
  std::ranges::sort(known);
  const bool is_named = !setting.name.text.empty();
  const Span mark = is_named ? setting.name.span : setting.span;
  Diagnostic diagnostic =
      make_diagnostic("E0207", mark, {std::string(word), checker.text_of(mark)});
  diagnostic.why = std::string(word) + " accepts ";
  for (std::size_t i = 0; i < known.size(); ++i) {
    diagnostic.why += (i == 0 ? "" : i + 1 < known.size() ? ", " : " and ") + std::string(known[i]);
  }
  if (is_named) diagnostic.fix = did_you_mean(checker, setting.name.text, mark, known);
  checker.report(std::move(diagnostic));
}

void check_setting(Checker& checker, std::string_view word, const ast::Arg& setting,
                   CheckedSettings& out) {
  const std::string_view name = setting.name.text;
  const std::string full = std::string(word) + '.' + std::string(name);
  const HostType* ambient = checker.registry.type(name);
  const auto setters = checker.registry.functions(full);
  const bool is_ambient = word == kWith && ambient != nullptr && ambient->is_ambient;
  if (name.empty() || (!is_ambient && setters.empty()))
    return unknown_setting(checker, word, setting);
  hir::Expr* value = checker.check_value(*setting.value);
  if (value->type->is(Kind::kAny)) return;
  const auto keep = [&](hir::Expr* kept) {
    hir::Variable* variable = hidden(checker, kept->type, kept->span);
    variable->init = kept;
    out.before.push_back(
        checker.make<hir::InitStmt>(hir::StmtKind::kInit, kept->span, variable, kept));
    return variable;
  };
  if (is_ambient) {
    value = checker.require(value, {.role = Target::Role::kSetting,
                                    .type = checker.types.host(ambient),
                                    .name = name,
                                    .function = word,
                                    .call = setting.span});
    if (value->type->is(Kind::kAny)) return;
    checker.scopes.here().ambients.push_back(
        {ambient, {.variable = keep(value), .how = Declared::kLet}});
    return;
  }
  const Argument argument{
      .name = name, .name_span = setting.name.span, .written = setting.value, .value = value};
  hir::Expr* call =
      call_native(checker, word, setters, setting.name.span, setting.span, {argument});
  if (call->kind != hir::ExprKind::kCallNative) return;
  hir::Expr*& given = call->as<hir::CallNativeExpr>().arguments[0];
  hir::Variable* variable = keep(given);
  given = checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, given->span,
                                          variable);
  out.inside.push_back(checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, setting.span, call));
}

}  // namespace

CheckedSettings check_settings(Checker& checker, std::string_view word,
                               ast::Seq<ast::Arg> settings) {
  CheckedSettings out;
  std::unordered_set<std::string_view> given;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const std::string_view name = settings[i].name.text;
    if (!name.empty() && !given.insert(name).second) {
      checker.report(make_diagnostic("E0212", settings[i].name.span, {std::string(name)}));
      continue;
    }
    check_setting(checker, word, settings[i], out);
  }
  return out;
}

hir::Stmt* event_call(Checker& checker, BlockEvent event, std::string_view word, Span mark,
                      Span span) {
  hir::Expr* made = call_native(checker, word, checker.registry.functions(event), mark, mark, {});
  return checker.make<hir::ExprStmt>(hir::StmtKind::kExpr, span, made);
}

hir::Stmt* check_with(Checker& checker, const ast::WithStmt& stmt) {
  checker.scopes.open_block();
  const std::size_t ambients = checker.scopes.here().ambients.size();
  auto [before, inside] = check_settings(checker, kWith, stmt.settings);
  inside.push_back(checker.check_block(stmt.body->body, stmt.body->span));
  checker.scopes.here().ambients.resize(ambients);
  close_block(checker);
  const auto block = [&](const std::vector<hir::Stmt*>& body) {
    return checker.make<hir::Block>(hir::StmtKind::kBlock, stmt.span, checker.seq(body));
  };
  if (inside.size() == 1) {
    before.push_back(inside[0]);
    return block(before);
  }
  const Span keyword{stmt.span.begin, stmt.span.begin, stmt.span.source};
  const auto call = [&](BlockEvent event) {
    return event_call(checker, event, kWith, keyword, stmt.span);
  };
  before.push_back(call(BlockEvent::kWithBegins));
  before.push_back(checker.make<hir::TryStmt>(hir::StmtKind::kTry, stmt.span, block(inside),
                                              nullptr, nullptr,
                                              block({call(BlockEvent::kWithEnds)})));
  return block(before);
}

}  // namespace armlet::lang
