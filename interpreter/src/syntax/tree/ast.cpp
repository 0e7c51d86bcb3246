#include "syntax/tree/ast.hpp"

#include <algorithm>

#include "syntax/tokens/marks.hpp"

namespace armlet::lang::ast {

std::string_view operator_text(BinaryOp op) {
  return std::ranges::find_if(
             kMarkRows, [&](const Mark& mark) { return mark.operation == op && !mark.assigns; })
      ->text;
}

}  // namespace armlet::lang::ast
