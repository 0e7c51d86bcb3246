// Matrices, and parts of matrices and lists.

#include "evaluator.hpp"

namespace armlet::oracle {

using namespace lang::hir;

namespace {

std::string count_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " value" : " values");
}
std::string size_text(std::size_t rows, std::size_t cols) {
  return std::to_string(rows) + "x" + std::to_string(cols);
}

}  // namespace

Value Evaluator::matrix(const MatrixExpr& e) {
  Values numbers = evaluate_all(e.items);
  return {Matrix{numbers.size() / e.cols, e.cols, std::move(numbers)}};
}

Value& Evaluator::cell(Value& matrix, Index at, Span where) const {
  Matrix& m = matrix.matrix();
  if (at.row < 0 || static_cast<std::size_t>(at.row) >= m.rows) {
    fail_index(at.row, m.rows, where, "row");
  }
  if (at.column < 0 || static_cast<std::size_t>(at.column) >= m.cols) {
    fail_index(at.column, m.cols, where, "column");
  }
  return m.numbers[static_cast<std::size_t>(at.row) * m.cols + static_cast<std::size_t>(at.column)];
}

Evaluator::Ends Evaluator::ends(const PartEnds& written) {
  Ends out{{}, {}, written.is_range};
  if (written.first != nullptr) out.first = evaluate(*written.first);
  if (written.last != nullptr) out.last = evaluate(*written.last);
  return out;
}

Evaluator::Stretch Evaluator::stretch(const Ends& ends, std::size_t size, Span where,
                                      const std::string& what) const {
  const std::int64_t first = ends.first.absent() ? 0 : ends.first.integer();
  if (!ends.is_range) {
    if (first < 0 || static_cast<std::size_t>(first) >= size) fail_index(first, size, where, what);
    return {static_cast<std::size_t>(first), 1};
  }
  const std::int64_t last =
      ends.last.absent() ? static_cast<std::int64_t>(size) : ends.last.integer();
  if (last < 0 || static_cast<std::size_t>(last) > size) fail_index(last, size + 1, where, what);
  if (first > last) fail_backwards(first, last, where);
  if (first < 0) fail_index(first, static_cast<std::size_t>(last) + 1, where, what);
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last - first)};
}

Value Evaluator::part(const PartExpr& e) {
  const Value object = evaluate(*e.object);
  const Matrix& from = object.matrix();
  const Ends row_ends = ends(e.rows);
  const Ends col_ends = ends(e.cols);
  const Stretch rows = stretch(row_ends, from.rows, e.span, "row");
  const Stretch cols = stretch(col_ends, from.cols, e.span, "column");
  Values numbers;
  for (std::size_t i = 0; i < rows.count; ++i) {
    for (std::size_t j = 0; j < cols.count; ++j) {
      numbers.push_back(from.numbers[(rows.first + i) * from.cols + cols.first + j]);
    }
  }
  if (e.rows.is_range && e.cols.is_range) {
    return {Matrix{rows.count, cols.count, std::move(numbers)}};
  }
  return {List{std::move(numbers)}};
}

void Evaluator::store_part(const StorePartStmt& s) {
  check_set(*s.place.variable, s.span);
  const Indices where = indices(s.place);
  const bool is_list = s.place.type->is(Kind::kList);
  const Ends row_ends = ends(s.rows);
  const Ends col_ends = is_list ? Ends{{}, {}, true} : ends(s.cols);
  const Value value = evaluate(*s.value);
  if (is_list) check_whole(value, *s.value->type, s.value->span, false);
  Value& target = walk(s.place, where);
  if (is_list) {
    store_in_list(target.list(), stretch(row_ends, target.list().items.size(), s.span, "list"),
                  value.list(), s.span);
    return;
  }
  const Matrix& to = target.matrix();
  const Stretch rows = stretch(row_ends, to.rows, s.span, "row");
  const Stretch cols = stretch(col_ends, to.cols, s.span, "column");
  store_in_matrix(target.matrix(), rows, cols, value, s.span);
}

// The value must have just the size of the part.
void Evaluator::store_in_list(List& to, Stretch part, const List& given, Span where) const {
  if (given.items.size() != part.count) {
    fail("R0613", where,
         {"a part of " + std::to_string(part.count) + " is given " +
          count_text(given.items.size())});
  }
  for (std::size_t i = 0; i < part.count; ++i) to.items[part.first + i] = given.items[i];
}

void Evaluator::store_in_matrix(Matrix& to, Stretch rows, Stretch cols, const Value& value,
                                Span where) const {
  const bool is_matrix = std::holds_alternative<Matrix>(value.is);
  const Values& given = is_matrix ? value.matrix().numbers : value.list().items;
  const bool fits = is_matrix
                        ? value.matrix().rows == rows.count && value.matrix().cols == cols.count
                        : given.size() == rows.count * cols.count;
  if (!fits) {
    const std::string size =
        is_matrix ? size_text(value.matrix().rows, value.matrix().cols) : count_text(given.size());
    fail("R0613", where, {"a part of " + size_text(rows.count, cols.count) + " is given " + size});
  }
  for (std::size_t i = 0; i < rows.count; ++i) {
    for (std::size_t j = 0; j < cols.count; ++j) {
      to.numbers[(rows.first + i) * to.cols + cols.first + j] = given[i * cols.count + j];
    }
  }
}

}  // namespace armlet::oracle
