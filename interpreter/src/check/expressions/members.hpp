#pragma once
// Checks x.name and x[i].

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* check_member(Checker& checker, const ast::MemberExpr& member,
                        const Type* expected = nullptr);
hir::Expr* check_index(Checker& checker, const ast::IndexExpr& index);

}  // namespace armlet::lang
