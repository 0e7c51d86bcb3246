#include "check/expressions/matrices.hpp"

#include <memory>

#include "check/explain/edits.hpp"
#include "check/expressions/operators.hpp"
#include "check/expressions/places.hpp"
#include "check/names/variables.hpp"
#include "check/types/indices.hpp"

namespace armlet::lang {
namespace {

using hir::ExprKind;

std::string size_text(const SizeFact& size) {
  if (size.is_list) return std::to_string(size.rows) + (size.rows == 1 ? " value" : " values");
  return std::to_string(size.rows) + 'x' + std::to_string(size.cols);
}

void set_size(Checker& checker, hir::Expr& expr, SizeFact size) {
  auto fact = std::make_shared<SizeFact>(size);
  expr.fact = fact.get();
  checker.into.facts.push_back(std::move(fact));
}

// The size of a list or matrix, if it follows from the text.
std::optional<SizeFact> size_of(const hir::Expr& expr) {
  if (const auto* size = dynamic_cast<const SizeFact*>(fact_of(expr))) return *size;
  const hir::Expr& origin = origin_of(expr);
  if (origin.kind != ExprKind::kList) return std::nullopt;
  return SizeFact(static_cast<std::int64_t>(origin.as<hir::ListExpr>().items.size()));
}

// The count of rows or columns that an index position selects of `all`; empty if it does not follow
// from the text.
std::optional<std::int64_t> count_of(const Constants& constants, const hir::PartEnds& ends,
                                     std::optional<std::int64_t> all) {
  if (!ends.is_range) return 1;
  const auto end = [&](const hir::Expr* expr, std::optional<std::int64_t> otherwise) {
    if (expr == nullptr) return otherwise;
    const auto value = constants.of(*expr);
    return value ? std::optional(value->integer) : std::nullopt;
  };
  const auto first = end(ends.first, 0);
  const auto last = end(ends.last, all);
  if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
  return *last - *first;
}

// The size of a part of a list or matrix.
std::optional<SizeFact> size_of_part(const Constants& constants, const hir::PartEnds& rows,
                                     const hir::PartEnds& cols,
                                     const std::optional<SizeFact>& whole, bool list) {
  const auto along = [&](std::int64_t SizeFact::*axis) {
    return whole ? std::optional((*whole).*axis) : std::nullopt;
  };
  const auto r = count_of(constants, rows, along(&SizeFact::rows));
  if (list) return r ? std::optional(SizeFact(*r)) : std::nullopt;
  const auto c = count_of(constants, cols, along(&SizeFact::cols));
  if (!r || !c) return std::nullopt;
  const bool matrix = rows.is_range && cols.is_range;
  return matrix ? SizeFact(*r, *c) : SizeFact(*r * *c);
}

Indexed rows_of(const ast::IndexExpr& index) { return {index.object->span, "rows"}; }
Indexed columns_of(const ast::IndexExpr& index) { return {index.object->span, "cols"}; }

hir::PartEnds check_ends(Checker& checker, const ast::IndexItem& item, const Indexed& of) {
  const auto end = [&](const ast::Expr* written) {
    return written != nullptr ? index_value(checker, *written, of) : nullptr;
  };
  hir::Expr* first = end(item.first);
  return {first, item.is_range ? end(item.last) : nullptr, item.is_range};
}

// Reports E0336 unless the brackets contain two index positions.
bool has_two_places(Checker& checker, const ast::IndexExpr& index) {
  if (index.items.size() == 2) return true;
  Diagnostic diagnostic =
      make_diagnostic("E0336", index.span, {std::to_string(index.items.size())});
  if (index.items.size() == 1) {
    const Span whole = index.items[0].span;
    const std::string text = checker.text_of(index.object->span) + '[' + checker.text_of(whole);
    const Span end{whole.end, whole.end, whole.source};
    diagnostic.fix = Fix{.text = index.items[0].is_range ? "write " + text + ", :] for these rows"
                                                         : "write " + text + ", :] for the row",
                         .edits = {{end, ", :"}}};
  }
  checker.report(std::move(diagnostic));
  return false;
}

bool is_block(const hir::Expr& value) {
  return value.type->is(Kind::kList) || value.type->is(Kind::kMatrix);
}

const Type* part_type(Checker& checker, const hir::PartEnds& rows, const hir::PartEnds& cols) {
  return rows.is_range && cols.is_range ? checker.types.matrix()
                                        : checker.types.list(checker.types.real());
}

// Reports E0305 if the text shows that value and part have different sizes.
bool part_fits(Checker& checker, const hir::StorePartStmt& store, Span target) {
  const bool list = store.place.type->is(Kind::kList);
  const auto* init = store.place.variable->init;
  const auto whole =
      store.place.steps.empty() && init != nullptr ? size_of(*init) : std::optional<SizeFact>();
  const auto part = size_of_part(checker.shared.constants, store.rows, store.cols, whole, list);
  const auto value = size_of(*store.value);
  if (!part || !value || part->is_list != value->is_list) return true;
  if (part->rows == value->rows && part->cols == value->cols) return true;
  Diagnostic diagnostic =
      make_diagnostic("E0305", store.value->span,
                      {"a part of " + size_text(*part) + " is given " + size_text(*value)});
  diagnostic.mark.label = size_text(*value);
  diagnostic.related.push_back({target, size_text(*part)});
  checker.report(std::move(diagnostic));
  return false;
}

}  // namespace

hir::Expr* check_matrix(Checker& checker, const ast::MatrixExpr& matrix) {
  const Type* real = checker.types.real();
  std::vector<hir::Expr*> items;
  const std::size_t cols = matrix.rows[0].size();
  for (const ast::Seq<ast::Expr*>& row : matrix.rows) {
    if (row.size() != cols) {
      Diagnostic diagnostic = make_diagnostic("E0335", cover(row.front()->span, row.back()->span),
                                              {std::to_string(cols), std::to_string(row.size())});
      const auto values = [](std::size_t n) {
        return std::to_string(n) + (n == 1 ? " value" : " values");
      };
      diagnostic.mark.label = values(row.size());
      diagnostic.related.push_back(
          {cover(matrix.rows[0].front()->span, matrix.rows[0].back()->span), values(cols)});
      checker.report(std::move(diagnostic));
      return checker.failed(matrix.span);
    }
    for (const ast::Expr* item : row) {
      hir::Expr* value = checker.check_value(*item, real);
      if (is_block(*value)) {
        Diagnostic diagnostic =
            make_diagnostic("E0315", value->span, {type_phrase(real), type_phrase(value->type)});
        diagnostic.fix = Fix{.text = "put lists and matrices together with hcat and vcat"};
        checker.report(std::move(diagnostic));
        return checker.failed(matrix.span);
      }
      items.push_back(checker.require(value, {.role = Target::Role::kElement, .type = real}));
      if (items.back()->type->is(Kind::kAny)) return checker.failed(matrix.span);
    }
  }
  auto* out = checker.make<hir::MatrixExpr>(ExprKind::kMatrix, checker.types.matrix(), matrix.span,
                                            static_cast<std::uint32_t>(cols), checker.seq(items));
  set_size(
      checker, *out,
      SizeFact(static_cast<std::int64_t>(matrix.rows.size()), static_cast<std::int64_t>(cols)));
  return out;
}

hir::Expr* check_matrix_index(Checker& checker, const ast::IndexExpr& index, hir::Expr* matrix) {
  if (!has_two_places(checker, index)) return checker.failed(index.span);
  const hir::PartEnds rows = check_ends(checker, index.items[0], rows_of(index));
  const hir::PartEnds cols = check_ends(checker, index.items[1], columns_of(index));
  if (!rows.is_range && !cols.is_range) {
    return checker.make<hir::ElementExpr>(ExprKind::kElement, checker.types.real(), index.span,
                                          matrix, rows.first, cols.first);
  }
  auto* part = checker.make<hir::PartExpr>(ExprKind::kPart, part_type(checker, rows, cols),
                                           index.span, matrix, rows, cols);
  const auto size = size_of_part(checker.shared.constants, rows, cols, size_of(*matrix), false);
  if (size) set_size(checker, *part, *size);
  return part;
}

void refuse_element_of_part(Checker& checker, const ast::IndexExpr& part) {
  Diagnostic diagnostic = make_diagnostic("E0328", part.span);
  diagnostic.why =
      '`' + checker.text_of(part.span) + "` is a copy; what is stored in it changes nothing else";
  const std::string whole = checker.text_of(part.object->span);
  diagnostic.fix = Fix{.text = "name the element by its place in " + whole};
  checker.report(std::move(diagnostic));
}

std::optional<hir::Step> matrix_step(Checker& checker, const ast::IndexExpr& index) {
  if (!has_two_places(checker, index)) return std::nullopt;
  if (is_part(index)) {
    refuse_element_of_part(checker, index);
    return std::nullopt;
  }
  hir::Step step{};
  step.span = index.span;
  step.index = index_value(checker, *index.items[0].first, rows_of(index));
  step.column = index_value(checker, *index.items[1].first, columns_of(index));
  step.type = checker.types.real();
  return step;
}

// ---- parts that change -------------------------------------------------------------------------

bool is_part(const ast::Expr& target) {
  if (target.kind != ast::ExprKind::kIndex) return false;
  for (const ast::IndexItem& item : target.as<ast::IndexExpr>().items) {
    if (item.is_range) return true;
  }
  return false;
}

void evaluate_once(Checker& checker, hir::Expr*& index, std::vector<hir::Stmt*>& before) {
  if (index == nullptr || index->kind == ExprKind::kInt || index->kind == ExprKind::kVariable ||
      index->kind == ExprKind::kText || index->kind == ExprKind::kEnum)
    return;
  hir::Variable* once = hidden(checker, index->type, index->span);
  before.push_back(checker.make<hir::InitStmt>(hir::StmtKind::kInit, index->span, once, index));
  index = checker.make<hir::VariableExpr>(ExprKind::kVariable, once->type, once->declared, once);
}

namespace {

// The current value of the part.
hir::Expr* read_part(Checker& checker, const hir::StorePartStmt& store, const Type* type,
                     Span span) {
  hir::Expr* whole = read_place(checker, store.place);
  if (store.place.type->is(Kind::kList)) {
    return checker.make<hir::SliceExpr>(ExprKind::kSlice, type, span, whole, store.rows.first,
                                        store.rows.last);
  }
  return checker.make<hir::PartExpr>(ExprKind::kPart, type, span, whole, store.rows, store.cols);
}

// part op= value becomes part = part op value, with every index evaluated once.
hir::Expr* compound_value(Checker& checker, hir::StorePartStmt& store, const Type* type,
                          const ast::IndexExpr& target, const ast::AssignStmt& assign,
                          std::vector<hir::Stmt*>& before) {
  for (hir::Step& step : store.place.steps) {
    evaluate_once(checker, step.index, before);
    evaluate_once(checker, step.column, before);
  }
  for (hir::PartEnds* ends : {&store.rows, &store.cols}) {
    evaluate_once(checker, ends->first, before);
    evaluate_once(checker, ends->last, before);
  }
  hir::Expr* value = checker.check_value(*assign.value);
  const ast::BinaryExpr node = operation_of(assign, target);
  return combine(checker, node, read_part(checker, store, type, target.span), value);
}

}  // namespace

std::optional<PartStore> check_part(Checker& checker, const ast::IndexExpr& target,
                                    Span statement) {
  const auto place = checker.check_place(*target.object, statement, false);
  if (!place) return std::nullopt;
  const bool list = place->type->is(Kind::kList);
  if (!list && !place->type->is(Kind::kMatrix)) {
    checker.report(make_diagnostic("E0328", target.span));
    return std::nullopt;
  }
  if (list && target.items.size() != 1) {
    checker.report(
        make_diagnostic("E0318", target.span, {"with a comma, " + type_phrase(place->type)}));
    return std::nullopt;
  }
  if (!list && !has_two_places(checker, target)) return std::nullopt;
  auto* store = checker.make<hir::StorePartStmt>(hir::StmtKind::kStorePart, statement, *place,
                                                 hir::PartEnds{}, hir::PartEnds{}, nullptr);
  store->rows = check_ends(checker, target.items[0],
                           list ? Indexed{.object = target.object->span} : rows_of(target));
  if (!list) store->cols = check_ends(checker, target.items[1], columns_of(target));
  const Type* type = list ? place->type : part_type(checker, store->rows, store->cols);
  return PartStore{store, {.type = type, .name = place->variable->name}};
}

hir::Stmt* fill_part(Checker& checker, const PartStore& part, hir::Expr* value, Span target) {
  part.store->value = value;
  const bool fits = !value->type->is(Kind::kAny) && part_fits(checker, *part.store, target);
  return fits ? part.store : nullptr;
}

hir::Stmt* assign_part(Checker& checker, const ast::IndexExpr& target,
                       const ast::AssignStmt& assign) {
  const auto part = check_part(checker, target, assign.span);
  if (!part) {
    checker.check(*assign.value);
    return nullptr;
  }
  if (!assign.compound) {
    return fill_part(checker, *part, checker.check_as(*assign.value, part->wanted), target.span);
  }
  std::vector<hir::Stmt*> before;
  hir::Expr* result =
      compound_value(checker, *part->store, part->wanted.type, target, assign, before);
  hir::Stmt* store = fill_part(checker, *part, checker.require(result, part->wanted), target.span);
  if (store == nullptr || before.empty()) return store;
  before.push_back(store);
  return checker.make<hir::Block>(hir::StmtKind::kBlock, assign.span, checker.seq(before));
}

// ---- what to write instead ----------------------------------------------------------------------

// ---- operators that do not exist ---------------------------------------------------------------

std::optional<Fix> matrix_operator_fix(const Checker& checker, const ast::BinaryExpr& node,
                                       const hir::Expr& left, const hir::Expr& right) {
  const bool sum = node.op == ast::BinaryOp::kAdd || node.op == ast::BinaryOp::kSub;
  const bool is_left = left.type->is(Kind::kMatrix);
  const hir::Expr& matrix = is_left ? left : right;
  const hir::Expr& number = is_left ? right : left;
  if (sum && matrix.type->is(Kind::kMatrix) && number.type->is_number()) {
    const bool is_variable = matrix.kind == ExprKind::kVariable;
    const std::string A = is_variable ? checker.text_of(matrix.span) : "m";
    const std::string all = "ones(" + A + ".rows, " + A + ".cols)";
    const std::string each = as_operand(checker.text_of(number.span)) + " * " + all;
    if (is_variable)
      return Fix{.text = "to every element: " + each, .edits = {{number.span, each}}};
    return Fix{.text = "for every element, name the matrix m and write " + each};
  }
  if (!right.type->is(Kind::kMatrix)) return std::nullopt;
  const std::string a = as_operand(checker.text_of(left.span));
  const std::string b = as_operand(checker.text_of(right.span));
  const auto write = [&](const std::string& text, const std::string& purpose) {
    return Fix{.text = "write " + text + purpose, .edits = {{node.span, text}}};
  };
  const bool list = left.type->is(Kind::kList);
  if (node.op == ast::BinaryOp::kMul && list) return write(b + ".T * " + a, "");
  if (node.op == ast::BinaryOp::kDiv && (list || left.type->is(Kind::kMatrix)))
    return write(b + " \\ " + a, " to solve " + b + " * x = " + a);
  return std::nullopt;
}

}  // namespace armlet::lang
