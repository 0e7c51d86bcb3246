#pragma once
// Structs and enums of any size, and default values of any depth: the work and the code for a use
// do not grow with them.

#include "check/checker.hpp"

namespace armlet::lang {

// Where a field, or a value of an enum, stands; -1 if there is none of this name.
[[nodiscard]] int field_index(Checker& checker, const RecordInfo& record, std::string_view name);
[[nodiscard]] int value_index(Checker& checker, const EnumInfo& enumeration, std::string_view name);

// State.values
[[nodiscard]] hir::Expr* enum_values(Checker& checker, const Type* type, Span span);

// The value that a call leaves out; `file` is where it is written.
[[nodiscard]] hir::Expr* default_value(Checker& checker, Checker& file, const ast::Expr& expr,
                                       const Target& target);

}  // namespace armlet::lang
