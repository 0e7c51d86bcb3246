#include "syntax/tree/ast.hpp"

#include <array>

namespace armlet::lang::ast {

std::string_view operator_text(BinaryOp op) {
  constexpr std::array<std::string_view, 18> kTexts = {
      "+",  "-", "*",  "/", "%",  "\\", ".*", "./", "^",
      ".^", "<", "<=", ">", ">=", "==", "!=", "&&", "||"};
  return kTexts[static_cast<std::size_t>(op)];
}

}  // namespace armlet::lang::ast
