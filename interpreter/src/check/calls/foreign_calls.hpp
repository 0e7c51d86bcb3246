#pragma once
// What is said of calls that other languages write otherwise.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// Reports console.log(x), math.sin(x); null if the call is none of these.
hir::Expr* foreign_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, std::string_view full);
// Reports E0201 for a method that does not exist. The fix is a function of a module with this name,
// or the method that corresponds to one of Java. object: the type of the value before the point.
hir::Expr* unknown_method(Checker& checker, const ast::CallExpr& call,
                          const ast::MemberExpr& member, const Type& object);
// Reports len(q); null if the call is none of these.
hir::Expr* foreign_call(Checker& checker, const ast::CallExpr& call, std::string_view name);
// Reports q(0) for a variable q that is not a function.
hir::Expr* not_a_function(Checker& checker, const ast::CallExpr& call, std::string_view name,
                          const Type* type);

}  // namespace armlet::lang
