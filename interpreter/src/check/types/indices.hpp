#pragma once
// Indexes of lists, texts and matrices.

#include <string_view>

#include "check/state/checker.hpp"

namespace armlet::lang {

// The indexed value, for messages about an index: its span, and the expression for the count of its
// elements.
struct Indexed {
  Span object{};
  std::string_view size = "length";
};
// The value of an index. Reports E0340 if the text shows that it is negative.
hir::Expr* index_value(Checker& checker, const ast::Expr& expr, const Indexed& of = {});

}  // namespace armlet::lang
