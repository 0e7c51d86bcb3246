#include "check/blocks/number_dims.hpp"

#include <algorithm>
#include <functional>

#include "armlet/interpreter/binding/dims_fact.hpp"
#include "check/state/checker.hpp"
#include "check/state/constants.hpp"

namespace armlet::lang {
namespace {

using hir::ExprKind;
using Dims = std::optional<std::vector<NumberDim>>;

constexpr int kDeepestPart = 24;
constexpr int kMostLooks = 5000;
constexpr std::size_t kMostParts = 200;  // numbers in one value

bool is_number_list(const TypePattern& pattern, int d) {
  return pattern.form == TypePattern::Form::kList &&
         pattern.parts[0].form == TypePattern::Form::kDimension && pattern.parts[0].d == d &&
         pattern.parts[0].e == 0;
}
// Whether a type pattern is just the dimension parameter D.
bool is_plain_d(const TypePattern& pattern) {
  return pattern.form == TypePattern::Form::kDimension && pattern.d == 1 && pattern.e == 0 &&
         pattern.dim.is_none();
}

// The function of the program that a value is; null if it is not one.
const hir::Function* function_of(const hir::Expr& value) {
  if (value.kind == ExprKind::kFunctionValue) return value.as<hir::FunctionValueExpr>().function;
  return value.kind == ExprKind::kClosure ? value.as<hir::ClosureExpr>().function : nullptr;
}

class DimsOfParts {
 public:
  explicit DimsOfParts(Checker& checker) : checker_(checker) {}

  Dims of(const hir::Expr& expr, int depth) const {
    if (depth > kDeepestPart || --left_ < 0) return std::nullopt;
    const hir::Expr& at = origin_of(expr);
    if (const hir::Expr* given = argument_for(at)) return outside(*given, depth);
    if (const hir::Expr* list = list_of(at)) return each_outside(*list, depth);
    if (const auto* fact = dynamic_cast<const DimsFact*>(fact_of(at))) return fact->dims;
    const bool is_negative =
        at.kind == ExprKind::kUnary && at.as<hir::UnaryExpr>().op == hir::Op::kNegR;
    Dims found;
    if (at.kind == ExprKind::kElement) found = element(at.as<hir::ElementExpr>(), depth);
    if (at.kind == ExprKind::kSlice) return slice(at.as<hir::SliceExpr>(), depth);
    if (at.kind == ExprKind::kPart) found = part_of_row(at.as<hir::PartExpr>(), depth);
    if (at.kind == ExprKind::kField) found = field(at.as<hir::FieldExpr>(), depth);
    if (is_negative) found = of(*at.as<hir::UnaryExpr>().operand, depth + 1);
    if (at.kind == ExprKind::kBinary) found = sum(at.as<hir::BinaryExpr>(), depth);
    if (at.kind == ExprKind::kCond) found = either(at.as<hir::CondExpr>(), depth);
    if (at.kind == ExprKind::kList) return all_of(at.as<hir::ListExpr>().items, depth);
    if (at.kind == ExprKind::kRecord) return all_of(at.as<hir::RecordExpr>().fields, depth);
    if (at.kind == ExprKind::kCall) found = called(at.as<hir::CallExpr>(), depth);
    if (at.kind == ExprKind::kCallNative) found = native(at.as<hir::CallNativeExpr>(), depth);
    return found ? found : by_type(*at.type);
  }

  // The dimensions of one element of a list, or of one row of a matrix, if they are equal for all.
  Dims each(const hir::Expr& expr, int depth) const {
    if (depth > kDeepestPart || --left_ < 0) return std::nullopt;
    const hir::Expr& at = origin_of(expr);
    if (const hir::Expr* given = argument_for(at)) return each_outside(*given, depth);
    if (at.kind == ExprKind::kSlice) return each(*at.as<hir::SliceExpr>().object, depth + 1);
    if (at.kind == ExprKind::kPart) return part(at.as<hir::PartExpr>(), depth);
    if (at.kind == ExprKind::kOverList) return over_list(at.as<hir::OverListExpr>(), depth);
    if (at.kind == ExprKind::kCallNative) {
      if (at.as<hir::CallNativeExpr>().function == checker_.registry.language().table_column)
        return column(at.as<hir::CallNativeExpr>(), depth);
      if (const Dims found = each_native(at.as<hir::CallNativeExpr>(), depth)) return found;
    }
    const bool is_list = at.type->is(Kind::kList) && at.type->element->is_number();
    Dims all = is_list ? of(at, depth + 1) : std::nullopt;
    if (!all || !are_alike(*all)) return std::nullopt;
    all->resize(1);
    return all;
  }

  // The row that a recording samples at each instant; null if the table is not a recording.
  const hir::RecordExpr* row_of(const hir::Expr& table) const {
    const hir::Expr& at = origin_of(table);
    if (at.kind != ExprKind::kCallNative) return nullptr;
    const auto& call = at.as<hir::CallNativeExpr>();
    const hir::Function* sample = call.function == checker_.registry.language().start_recording
                                      ? function_of(*call.arguments[0])
                                      : nullptr;
    if (sample == nullptr || sample->body == nullptr || sample->body->body.empty()) return nullptr;
    const hir::Stmt* last = sample->body->body.back();
    if (last->kind != hir::StmtKind::kReturn) return nullptr;
    const hir::Expr* row = static_cast<const hir::ReturnStmt*>(last)->value;
    return row->kind == ExprKind::kRecord ? &row->as<hir::RecordExpr>() : nullptr;
  }

  // The dimensions of the result of a function whose body consists of declarations and a last
  // value.
  Dims result_of(const hir::Function& function, int depth) const {
    if (function.body == nullptr || function.body->body.empty()) return std::nullopt;
    const hir::Stmt* last = function.body->body.back();
    for (const hir::Stmt* each : function.body->body)
      if (each != last && each->kind != hir::StmtKind::kInit) return std::nullopt;
    if (last->kind != hir::StmtKind::kReturn) return std::nullopt;
    const hir::Expr* value = static_cast<const hir::ReturnStmt*>(last)->value;
    return value == nullptr ? std::nullopt : of(*value, depth + 1);
  }

 private:
  static bool are_alike(const std::vector<NumberDim>& all) {
    return !all.empty() && std::ranges::all_of(all, &NumberDim::is_one) &&
           std::adjacent_find(all.begin(), all.end(), std::not_equal_to()) == all.end();
  }

  // The dimensions of a column of a recording: those of the value that is sampled.
  Dims column(const hir::CallNativeExpr& call, int depth) const {
    const hir::RecordExpr* row = row_of(*call.arguments[0]);
    const auto place = whole(call.arguments[1], 0);
    const bool is_known = row != nullptr && place && *place >= 0 &&
                          static_cast<std::size_t>(*place) < row->fields.size();
    if (!is_known) return std::nullopt;
    return of(*row->fields[static_cast<std::size_t>(*place)], depth + 1);
  }

  // The dimensions of a part of a matrix: matrix[a:b, j] is a list of column j, matrix[a:b, c:d] a
  // matrix.
  Dims part(const hir::PartExpr& node, int depth) const {
    return node.rows.is_range ? columns_of(node, depth) : std::nullopt;
  }
  // The dimensions of matrix[i, c:d], which is a list.
  Dims part_of_row(const hir::PartExpr& node, int depth) const {
    return node.rows.is_range ? std::nullopt : columns_of(node, depth);
  }
  Dims columns_of(const hir::PartExpr& node, int depth) const {
    const Dims row = each(*node.object, depth + 1);
    if (!row) return std::nullopt;
    const auto first = whole(node.cols.first, 0);
    if (!node.cols.is_range) return first ? some(*row, *first, *first + 1) : std::nullopt;
    if (node.cols.first == nullptr && node.cols.last == nullptr) return row;
    const bool is_counted = std::ranges::all_of(*row, &NumberDim::is_one);
    if (node.cols.last == nullptr && !is_counted) return std::nullopt;
    const auto last = whole(node.cols.last, static_cast<std::int64_t>(row->size()));
    return first && last && *first <= *last ? some(*row, *first, *last) : std::nullopt;
  }

  Dims over_list(const hir::OverListExpr& node, int depth) const {
    using hir::ListVerb;
    if (node.verb == ListVerb::kFilter || node.verb == ListVerb::kSort)
      return each(*node.operands[0], depth + 1);
    if (node.verb != ListVerb::kMap) return std::nullopt;
    const hir::Function* mapped = function_of(origin_of(*node.operands[1]));
    if (mapped == nullptr) return std::nullopt;
    const Inside inside{nullptr, here_, mapped, node.operands[0]};
    here_ = &inside;
    Dims found = result_of(*mapped, depth + 1);
    here_ = inside.outer;
    return found;
  }

  // The list whose element a parameter of the current function is; null if it is none.
  const hir::Expr* list_of(const hir::Expr& at) const {
    if (at.kind != ExprKind::kVariable || here_ == nullptr || here_->mapped == nullptr)
      return nullptr;
    const hir::Variable* variable = at.as<hir::VariableExpr>().variable;
    const auto& parameters = here_->mapped->parameters;
    const bool is_first = !parameters.empty() && *parameters.begin() == variable;
    return is_first && variable->fixed ? here_->list : nullptr;
  }

  // The dimensions of matrix(rows), and of a + b, a - b and abs(a) element by element.
  Dims each_native(const hir::CallNativeExpr& call, int depth) const {
    const std::string_view name = call.function->name;
    if (name != "matrix" && name != "abs" && name != "operator+" && name != "operator-")
      return std::nullopt;
    Dims found;
    for (const hir::Expr* argument : call.arguments) {
      const bool has_rows = argument->type->is(Kind::kList) || argument->type->is(Kind::kMatrix);
      Dims own = has_rows ? each(*argument, depth + 1) : std::nullopt;
      if (!own || (found && found != own)) return std::nullopt;
      found = std::move(own);
    }
    return found;
  }

  // The function whose body is searched, with its call: its arguments, or the list whose elements
  // it is called with.
  struct Inside {
    const hir::CallExpr* call;
    const Inside* outer;
    const hir::Function* mapped = nullptr;
    const hir::Expr* list = nullptr;
  };

  Dims called(const hir::CallExpr& call, int depth) const {
    const Inside inside{&call, here_};
    here_ = &inside;
    Dims found = result_of(*call.function, depth);
    here_ = inside.outer;
    return found;
  }

  // The argument for a parameter of the current function; null if the expression is not a
  // parameter.
  const hir::Expr* argument_for(const hir::Expr& at) const {
    if (at.kind != ExprKind::kVariable || here_ == nullptr || here_->call == nullptr)
      return nullptr;
    const hir::Variable* variable = at.as<hir::VariableExpr>().variable;
    const auto& parameters = here_->call->function->parameters;
    const auto found = std::ranges::find(parameters, variable);
    const auto place = static_cast<std::size_t>(found - parameters.begin());
    const bool is_given = variable->fixed && found != parameters.end() &&
                          here_->call->arguments.size() == parameters.size();
    return is_given ? here_->call->arguments[place] : nullptr;
  }

  // The dimensions of an argument, in the scope of the call.
  Dims outside(const hir::Expr& argument, int depth) const {
    const Inside* const inside = here_;
    here_ = inside->outer;
    Dims found = of(argument, depth + 1);
    here_ = inside;
    return found;
  }

  Dims each_outside(const hir::Expr& list, int depth) const {
    const Inside* const inside = here_;
    here_ = inside->outer;
    Dims found = each(list, depth + 1);
    here_ = inside;
    return found;
  }

  // The fact that a rule of the host has stored for a value, which may be an argument of the
  // current function.
  const Fact* fact_here(const hir::Expr& expr) const {
    const Inside* const inside = here_;
    const hir::Expr* at = &origin_of(expr);
    while (const hir::Expr* given = argument_for(*at)) {
      at = &origin_of(*given);
      here_ = here_->outer;
    }
    here_ = inside;
    return fact_of(*at);
  }

  Dims of_argument(const hir::CallNativeExpr& call, const DimsOfArgumentFact& fact,
                   int depth) const {
    const hir::Expr& argument = *call.arguments[static_cast<std::size_t>(fact.argument)];
    std::optional<DimsFact> found;
    const Fact* given = fact_here(argument);
    if (given == nullptr) {
      Dims own = of(argument, depth + 1);
      if (!own) return std::nullopt;
      given = &found.emplace(*std::move(own));
    }
    std::vector<NumberDim> dims = fact.dims(*given);
    return dims.empty() ? std::nullopt : Dims(std::move(dims));
  }

  // The dimension of one number; the count of numbers in a list, matrix or host value does not
  // follow from its type.
  static Dims by_type(const Type& type) {
    if (type.is_quantity()) return std::vector{NumberDim{type.dim}};
    const bool is_one =
        type.is_number() || type.is(Kind::kBool) || type.is(Kind::kText) || type.is(Kind::kEnum);
    return is_one ? Dims(std::vector{NumberDim{}}) : std::nullopt;
  }

  [[nodiscard]] std::optional<std::int64_t> whole(const hir::Expr* expr,
                                                  std::int64_t otherwise) const {
    if (expr == nullptr) return otherwise;
    const auto known = checker_.shared.constants.of(*expr);
    if (!known || known->kind != Constant::Kind::kInt) return std::nullopt;
    return known->integer;
  }

  Dims element(const hir::ElementExpr& node, int depth) const {
    const bool is_of_matrix = node.column != nullptr;
    const auto index = whole(is_of_matrix ? node.column : node.index, 0);
    if (!is_of_matrix && node.type->is(Kind::kHost)) return each(*node.object, depth + 1);
    if (!index || !node.type->is_number()) return std::nullopt;
    const Dims all = is_of_matrix ? each(*node.object, depth + 1) : of(*node.object, depth + 1);
    return all ? some(*all, *index, *index + 1) : std::nullopt;
  }

  // The dimensions of a field of a record that the program makes.
  Dims field(const hir::FieldExpr& node, int depth) const {
    const hir::Expr& record = origin_of(*node.object);
    if (record.kind != ExprKind::kRecord) return std::nullopt;
    return of(*record.as<hir::RecordExpr>().fields[node.field], depth + 1);
  }

  Dims slice(const hir::SliceExpr& node, int depth) const {
    const Dims all = of(*node.object, depth + 1);
    if (!all || !node.type->is(Kind::kList) || !node.type->element->is_number())
      return std::nullopt;
    const bool is_counted = std::ranges::all_of(*all, &NumberDim::is_one);
    if (node.last == nullptr && !is_counted) return std::nullopt;
    const auto first = whole(node.first, 0);
    const auto last = whole(node.last, static_cast<std::int64_t>(all->size()));
    if (!first || !last || *first > *last) return std::nullopt;
    return some(*all, *first, *last);
  }

  // The dimensions from `first` to before `last`. After a part whose count is known only at run
  // time, no positions are known.
  static Dims some(const std::vector<NumberDim>& all, std::int64_t first, std::int64_t last) {
    if (first < 0 || last - first > static_cast<std::int64_t>(kMostParts)) return std::nullopt;
    std::vector<NumberDim> out;
    for (std::int64_t i = first; i < last; ++i) {
      const auto many = std::ranges::find_if_not(all, &NumberDim::is_one);
      const std::int64_t known = many - all.begin();
      if (i < known) {
        out.push_back(all[static_cast<std::size_t>(i)]);
      } else if (many != all.end() && many + 1 == all.end()) {
        out.push_back({.later = many->later, .index = static_cast<int>(i - known)});
      } else {
        return std::nullopt;
      }
    }
    return out;
  }

  // The dimensions of a sum: those of both operands, if they are equal.
  Dims sum(const hir::BinaryExpr& node, int depth) const {
    if (node.op != hir::Op::kAddR && node.op != hir::Op::kSubR) return std::nullopt;
    const Dims left = of(*node.left, depth + 1);
    return left == of(*node.right, depth + 1) ? left : std::nullopt;
  }
  Dims either(const hir::CondExpr& node, int depth) const {
    const Dims yes = of(*node.yes, depth + 1);
    return yes == of(*node.no, depth + 1) ? yes : std::nullopt;
  }

  Dims all_of(std::span<hir::Expr* const> parts, int depth) const {
    std::vector<NumberDim> all;
    for (const hir::Expr* part : parts) {
      const Dims some = of(*part, depth + 1);
      if (!some || all.size() + some->size() > kMostParts) return std::nullopt;
      all.insert(all.end(), some->begin(), some->end());
    }
    return all;
  }

  // The dimensions of a host value that contains numbers: q[k] has one of them; q + r and q - r
  // have those of both, or those of q if nothing is known of r.
  Dims in_host(const hir::CallNativeExpr& call, int depth) const {
    const std::string_view name = call.function->name;
    const bool is_element = name.ends_with("[]");
    if (call.arguments.size() != 2 || !call.arguments[0]->type->is(Kind::kHost) ||
        !(is_element || name == "operator+" || name == "operator-"))
      return std::nullopt;
    const Dims all = of(*call.arguments[0], depth + 1);
    if (!all) return std::nullopt;
    if (is_element) {
      const auto index = whole(call.arguments[1], 0);
      return index ? some(*all, *index, *index + 1) : std::nullopt;
    }
    const Dims others = of(*call.arguments[1], depth + 1);
    const bool is_known =
        others && std::ranges::any_of(*others, [](const NumberDim& dim) { return !dim.is_none(); });
    return !is_known || others == all ? all : std::nullopt;
  }

  // The dimensions of the result of a library function: norm(v: D[]) -> D has that of all elements
  // of v; a + b, element by element, those of both.
  Dims native(const hir::CallNativeExpr& call, int depth) const {
    const Signature& signature = checker_.shared.signatures.of(*call.function);
    const auto* by_argument = dynamic_cast<const DimsOfArgumentFact*>(call.fact);
    if (by_argument != nullptr) return of_argument(call, *by_argument, depth);
    const std::string_view name = call.function->name;
    if (const Dims of_host = in_host(call, depth)) return of_host;
    const bool is_by_element = name == "operator+" || name == "operator-" || name == "abs";
    const bool gives_list = is_by_element && is_number_list(signature.result, 1);
    if (!gives_list && !is_plain_d(signature.result)) return std::nullopt;
    Dims given;
    for (std::size_t p = 0; p < signature.parameters.size(); ++p) {
      const TypePattern& pattern = signature.parameters[p].type;
      const bool is_list = is_number_list(pattern, 1);
      if (!is_list && !is_plain_d(pattern)) continue;
      Dims own = of(*call.arguments[p], depth + 1);
      if (!own || own->empty()) return std::nullopt;
      if (!gives_list && !are_alike(*own)) return std::nullopt;
      if (!gives_list) own->resize(1);
      if (given && given != own) return std::nullopt;
      given = std::move(own);
    }
    return given;
  }

  Checker& checker_;
  mutable const Inside* here_ = nullptr;  // null: no function is searched
  // Limits the work: `let b = a + a; let c = b + b` doubles it with each line.
  mutable int left_ = kMostLooks;
};

}  // namespace

Dims dims_of_numbers(Checker& checker, const hir::Expr& expr) {
  const DimsOfParts reader(checker);
  const hir::Function* function = function_of(origin_of(expr));
  Dims found = function != nullptr ? reader.result_of(*function, 0) : reader.of(expr, 0);
  if (!found || std::ranges::all_of(*found, &NumberDim::is_none)) return std::nullopt;
  return found;
}

namespace {

// Dimensions as text: "rad/s,m/s"; "@" and NumberDim::later for one known at run time only; empty
// if none is known.
std::string text_of(const Dims& dims) {
  std::string units;
  if (!dims || std::ranges::all_of(*dims, &NumberDim::is_none)) return units;
  for (const NumberDim& each : *dims) {
    units += each.later.empty() ? si_unit(each.dim) : '@' + each.later;
    if (each.index >= 0) units += '#' + std::to_string(each.index);
    units += ',';
  }
  units.pop_back();
  return units;
}

// The units of each column of a recording, separated by semicolons.
std::string units_of_columns(Checker& checker, const hir::Expr& table) {
  const hir::RecordExpr* row = DimsOfParts(checker).row_of(table);
  if (row == nullptr) return {};
  std::string units;
  for (const hir::Expr* field : row->fields) {
    if (field != row->fields[0]) units += ';';
    const bool has_type = !field->type->is(Kind::kList) && !field->type->is_number();
    if (!has_type) units += text_of(DimsOfParts(checker).of(*field, 0));
  }
  return units.find_first_not_of(';') == std::string::npos ? std::string() : units;
}

// The units of the inner lists of a list of lists.
std::string units_of_lists(Checker& checker, const hir::Expr& lists) {
  const hir::Expr& at = origin_of(lists);
  if (at.kind != ExprKind::kList) return {};
  std::vector<NumberDim> dims;
  for (const hir::Expr* line : at.as<hir::ListExpr>().items) {
    const Dims own = DimsOfParts(checker).each(*line, 0);
    dims.push_back(own && own->size() == 1 ? own->front() : NumberDim{});
  }
  return dims.empty() ? std::string() : text_of(Dims(std::move(dims)));
}

std::string units_of_value(Checker& checker, const hir::Expr& value) {
  const Type& type = *value.type;
  if (type.is_table())
    return type.is_open_table() ? std::string() : units_of_columns(checker, value);
  if (type.is(Kind::kMatrix)) return text_of(DimsOfParts(checker).each(value, 0));
  if (type.is(Kind::kList) && type.element->is(Kind::kList)) return units_of_lists(checker, value);
  if (type.is(Kind::kList)) {
    if (std::string units = text_of(DimsOfParts(checker).each(value, 0)); !units.empty())
      return units;
  }
  return text_of(dims_of_numbers(checker, value));
}

}  // namespace

void finish_units(Checker& checker) {
  for (const auto& [text, value] : checker.shared.postponed.units()) {
    if (const std::string units = units_of_value(checker, *value); !units.empty())
      text->value = checker.arena.copy(units);
  }
}

}  // namespace armlet::lang
