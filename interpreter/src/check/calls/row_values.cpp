#include "check/calls/row_values.hpp"

#include <string>
#include <string_view>
#include <vector>

#include "check/names/unknown_names.hpp"
#include "check/state/learnt.hpp"

namespace armlet::lang {
namespace {

// The names of the rows of a block that have a value.
std::vector<std::string_view> row_names(Checker& checker, std::string_view block) {
  const std::string prefix = std::string(block) + '.';
  std::vector<std::string_view> out;
  for (const Local& local : checker.scopes.main().locals) {
    const std::string_view name = local.variable->name;
    if (name.starts_with(prefix) && local.variable->storage == hir::Storage::kGlobal)
      out.push_back(name.substr(prefix.size()));
  }
  return out;
}

}  // namespace

hir::Expr* named_row_value(Checker& checker, const ast::MemberExpr& member) {
  if (member.object->kind != ast::ExprKind::kName) return nullptr;
  const std::string_view block = member.object->as<ast::NameExpr>().name;
  FunctionContext* where = nullptr;
  const Local* named = checker.scopes.find(block, where);
  const bool is_block = named != nullptr && named->how == Declared::kBlock &&
                        named->variable->type->is(Kind::kHost) &&
                        checker.registry.has_named_rows(named->variable->type->host->name);
  if (named != nullptr && !is_block) return nullptr;
  Local* row =
      checker.scopes.find(std::string(block) + '.' + std::string(member.member.text), where);
  if (row != nullptr && row->variable->storage == hir::Storage::kGlobal) {
    hir::Variable* variable = row->variable;
    if (checker.shared.learnt != nullptr)
      checker.shared.learnt->use(member.member.span, variable->declared);
    if (named != nullptr && checker.shared.learnt != nullptr)
      checker.shared.learnt->use(member.object->span, named->variable->declared);
    checker.scopes.use().add(variable);
    return checker.make<hir::VariableExpr>(hir::ExprKind::kVariable, variable->type, member.span,
                                           variable);
  }
  if (!is_block) return nullptr;
  const hir::Expr* made = named->variable->init;
  if (made != nullptr && made->type->is(Kind::kAny)) return checker.failed(member.span);
  Diagnostic diagnostic =
      make_diagnostic("E0208", member.member.span,
                      {'`' + std::string(block) + '`', std::string(member.member.text)});
  if (row != nullptr) diagnostic.why = "this row holds nothing that can be read";
  diagnostic.fix =
      did_you_mean(checker, member.member.text, member.member.span, row_names(checker, block));
  checker.report(std::move(diagnostic));
  return checker.failed(member.span);
}

}  // namespace armlet::lang
