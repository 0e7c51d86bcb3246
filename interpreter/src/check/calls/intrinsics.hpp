#pragma once
// Checks calls that are part of the language: print, error, int(x), and the methods of lists and
// texts.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* intrinsic(Checker& checker, const ast::CallExpr& call, std::string_view name,
                     Span callee, bool& known);
hir::Expr* print_call(Checker& checker, const ast::CallExpr& call, bool line);
hir::Expr* last_call(Checker& checker, hir::Expr* list, Span span);
hir::Expr* builtin_method(Checker& checker, hir::Expr* object, const ast::CallExpr& call,
                          const ast::MemberExpr& member, bool& known);
bool takes(Checker& checker, const ast::CallExpr& call, std::string_view name, std::size_t least,
           std::size_t most);

}  // namespace armlet::lang
