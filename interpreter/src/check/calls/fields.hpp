#pragma once
// What stands behind a point: fields, lengths, and what the library gives for a value.

#include <cstddef>

#include "check/state/checker.hpp"

namespace armlet::lang {

hir::Expr* field_of(Checker& checker, hir::Expr* object, const ast::MemberExpr& member);
hir::Expr* unknown_field(Checker& checker, const hir::Expr& object, const ast::Name& field);
// For editors: notes that `name` refers to field `field` of a struct.
void note_field_use(Checker& checker, const Type& record, std::size_t field, Span name);

}  // namespace armlet::lang
