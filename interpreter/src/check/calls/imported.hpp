#pragma once
// Values and calls of imported files.

#include "check/state/checker.hpp"

namespace armlet::lang {

// Members of an import: grip.width, grip.close, grip.Side. After a message, a value that failed.
hir::Expr* imported_member(Checker& checker, const Import& from, const ast::MemberExpr& member,
                           const Type* expected);
// Calls of functions of an import: grip.close(5mm), grip.Part(mass: 2kg), grip.law(0.5).
hir::Expr* call_imported(Checker& checker, const Import& from, const ast::CallExpr& call,
                         const ast::MemberExpr& member);

}  // namespace armlet::lang
