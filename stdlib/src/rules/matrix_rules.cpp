#include "rules/matrix_rules.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "values/matrices.hpp"

namespace armlet::bind {
namespace {

// The operands, whose names differ from operator to operator.
constexpr CallPart kLeft = CallPart::first(), kRight = CallPart::operand(1);

std::optional<SizeFact> size_of(const CheckCall& call, CallPart part) {
  if (const auto fact = std::dynamic_pointer_cast<const SizeFact>(call.fact(part))) return *fact;
  const int items = call.item_count(part);
  if (!call.type(part)->is(Kind::kList) || items == 0) return std::nullopt;
  return SizeFact(items);
}

std::string text_of(const SizeFact& size) {
  return size.is_list ? fmt::format("{}", size.rows) : size_text(size.rows, size.cols);
}

std::string label_of(const SizeFact& size) {
  if (size.is_list) return values_text(size.rows);
  return fmt::format("{} row{}, {} column{}", size.rows, size.rows == 1 ? "" : "s", size.cols,
                     size.cols == 1 ? "" : "s");
}

void set_size(CheckCall& call, SizeFact size) {
  call.set_result_fact(std::make_shared<SizeFact>(size));
}

// E0305 with both operands marked.
void report_sizes(CheckCall& call, const SizeFact& a, std::string_view word, const SizeFact& b,
                  std::string fix) {
  Diagnostic d = make_diagnostic("E0305", call.span(kRight),
                                 {fmt::format("{} {} {}", text_of(a), word, text_of(b))});
  d.mark.label = label_of(b);
  d.related.push_back({call.span(kLeft), label_of(a)});
  if (!fix.empty()) d.fix = Fix{.text = std::move(fix)};
  call.report(std::move(d));
}

std::string_view word_of(std::string_view function) {
  if (function == "operator+") return "plus";
  if (function == "operator-") return "minus";
  return function.substr(std::string_view("operator").size());
}

std::optional<std::int64_t> whole(const CheckCall& call, CallPart part) {
  const auto value = call.constant(part);
  if (!value || value->kind != Constant::Kind::kInt || value->integer < 0) return std::nullopt;
  return value->integer;
}

bool refuse_oblong(CheckCall& call, const SizeFact& size) {
  if (size.rows == size.cols) return false;
  const bool power = call.function_name() == "operator^";
  const std::string name = power ? "a power" : std::string(call.function_name());
  Diagnostic d =
      make_diagnostic("E0305", call.span(kLeft), {fmt::format("{} of {}", name, text_of(size))});
  d.mark.label = label_of(size);
  d.why = fmt::format("{} needs a square matrix", name);
  call.report(std::move(d));
  return true;
}

}  // namespace

void check_product(CheckCall& call) {
  const auto a = size_of(call, kLeft);
  const auto b = size_of(call, kRight);
  if (!a || !b) return;
  if (a->cols != b->rows) {
    return report_sizes(call, *a, "times", *b,
                        b->is_list
                            ? "the matrix needs as many columns as the list has values"
                            : "the first matrix needs as many columns as the second has rows");
  }
  set_size(call, b->is_list ? SizeFact(a->rows) : SizeFact(a->rows, b->cols));
}

void check_solve(CheckCall& call) {
  const auto a = size_of(call, kLeft);
  const auto b = size_of(call, kRight);
  if (!a || !b) return;
  if (a->rows != b->rows) {
    return report_sizes(call, *a, "\\", *b,
                        b->is_list ? "the matrix needs as many rows as the list has values"
                                   : "both matrices need equally many rows");
  }
  set_size(call, b->is_list ? SizeFact(a->cols) : SizeFact(a->cols, b->cols));
}

void check_sum(CheckCall& call) {
  const auto a = size_of(call, kLeft);
  const auto b = size_of(call, kRight);
  if (!a || !b) return;
  if (a->rows != b->rows || a->cols != b->cols) {
    return report_sizes(call, *a, word_of(call.function_name()), *b,
                        "both matrices need the same size");
  }
  set_size(call, *a);
}

void check_same_size(CheckCall& call) {
  for (const CallPart part : {kLeft, kRight}) {
    if (part == kRight && call.type(kLeft)->is(Kind::kMatrix)) return;
    if (!call.type(part)->is(Kind::kMatrix)) continue;
    if (const auto size = size_of(call, part)) set_size(call, *size);
    return;
  }
}

void check_square(CheckCall& call) {
  const auto size = size_of(call, kLeft);
  if (size && !refuse_oblong(call, *size)) set_size(call, *size);
}

void check_square_to_number(CheckCall& call) {
  if (const auto size = size_of(call, kLeft)) refuse_oblong(call, *size);
}

void check_transposed(CheckCall& call) {
  if (const auto size = size_of(call, kLeft)) set_size(call, SizeFact(size->cols, size->rows));
}

void check_filled(CheckCall& call) {
  const auto rows = whole(call, kLeft);
  const auto cols = whole(call, kRight);
  if (rows && cols) set_size(call, SizeFact(*rows, *cols));
}

void check_filled_list(CheckCall& call) {
  if (const auto n = whole(call, kLeft)) set_size(call, SizeFact(*n));
}

void check_identity(CheckCall& call) {
  if (const auto n = whole(call, kLeft)) set_size(call, SizeFact(*n, *n));
}

void check_diagonal(CheckCall& call) {
  if (const auto v = size_of(call, kLeft)) set_size(call, SizeFact(v->rows, v->rows));
}

void check_outer(CheckCall& call) {
  const auto v = size_of(call, kLeft);
  const auto w = size_of(call, kRight);
  if (v && w) set_size(call, SizeFact(v->rows, w->rows));
}

}  // namespace armlet::bind
