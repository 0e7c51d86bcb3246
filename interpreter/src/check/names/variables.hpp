#pragma once
// Variables and the blocks in which they are visible.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Variable* new_variable(Checker& checker, std::string_view name, const Type* type, Span span);
// One that the program does not name, for a value that is computed once.
hir::Variable* hidden(Checker& checker, const Type* type, Span span);
// Whether a name can be declared here; says so if not.
bool is_free(Checker& checker, const ast::Name& name, const ast::Expr* value = nullptr,
             Span keyword = {});
// Ends the innermost block, with advice about variables that nothing reads.
void close_block(Checker& checker);

}  // namespace armlet::lang
