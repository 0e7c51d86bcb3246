#pragma once
// The map expressions of a checked program; hir.hpp describes the whole tree.

#include "hir/hir_expr.hpp"

namespace armlet::lang::hir {

struct MapExpr : Expr {  // ["bolt": 3, "nut": 5]
  Seq<Expr*> keys;
  Seq<Expr*> values;  // as many
};

struct EntryExpr : Expr {  // m[k]; m.get(k, otherwise)
  Expr* object;
  Expr* key;
  Expr* otherwise;  // null: the key has to exist
};

enum class MapQuestion : std::uint8_t { kHas, kKeys, kValues };
struct MapQueryExpr : Expr {  // m.has(k), m.keys(), m.values()
  MapQuestion question;
  Expr* object;
  Expr* key;  // has
};

}  // namespace armlet::lang::hir
