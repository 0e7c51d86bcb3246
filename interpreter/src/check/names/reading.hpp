#pragma once
// Reading variables: what is noted of uses, and the variables that functions inside functions share
// or copy.

#include <string>
#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// "System.out" for a chain of names that are no variables; empty otherwise.
[[nodiscard]] std::string dotted_name(Checker& checker, const ast::Expr& expr);
// Fact::kind of a value, also of a variable that changes; empty if it has none.
[[nodiscard]] std::string_view kind_of(const hir::Expr& value);

// Notes a call at the current position, for the order in which the top level runs.
void note_call(Checker& checker, const hir::Function* function);
// For editors: notes that the end of `name` refers to a struct or enum of the program.
void note_type_use(Checker& checker, const Type& type, Span name);

// The current state of the variables of `where`: tasks have a state of their own.
[[nodiscard]] const Flow& flow_for(const Checker& checker, const FunctionContext& where);
// Notes that the variable has a value from here on, also under its names in inner functions.
void note_assigned(FunctionContext& here, const hir::Variable* variable);

// The variable that `here` uses for a variable of `owner` outside of it.
hir::Variable* captured(Checker& checker, Local& local, FunctionContext& owner,
                        FunctionContext& here);
// The value of a variable that is in scope.
hir::Expr* read(Checker& checker, Local& local, FunctionContext& where, Span span);

}  // namespace armlet::lang
