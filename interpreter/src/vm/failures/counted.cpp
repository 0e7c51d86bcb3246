#include "vm/failures/counted.hpp"

#include <string_view>

namespace armlet::lang {

bool is_counted(const SourceSet& sources, const hir::Expr& value) {
  if (value.kind != hir::ExprKind::kVariable) return false;
  const hir::Variable* origin = value.as<hir::VariableExpr>().variable;
  while (origin->outer != nullptr) origin = origin->outer;
  if (origin->is_parameter) return false;
  if (origin->fixed) return origin->init == nullptr;
  const Source& source = sources[origin->declared.source];
  const std::string_view line = source.line(source.position(origin->declared.begin).line);
  const std::size_t word = line.find("for");
  return word != std::string_view::npos && line.find('(', word) < line.find(origin->name);
}

}  // namespace armlet::lang
