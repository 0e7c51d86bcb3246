#include "ast/ast.hpp"

#include <algorithm>

#include "ast/marks.hpp"

namespace armlet::lang::ast {

std::string_view operator_text(BinaryOp op) {
  return std::ranges::find_if(
             kMarkRows, [&](const Mark& mark) { return mark.operation == op && !mark.assigns; })
      ->text;
}

std::string path_of(const ImportStmt& stmt) {
  std::string path(stmt.path);
  if (stmt.is_file) return path;
  for (char& c : path) {
    if (c == '.') c = '/';
  }
  return path + ".rbt";
}

}  // namespace armlet::lang::ast
