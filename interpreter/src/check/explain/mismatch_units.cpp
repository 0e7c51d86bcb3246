#include "check/explain/mismatch_units.hpp"

#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

#include "check/explain/edits.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

namespace {

bool variable_named_like_a_unit(Checker& checker, const hir::Expr& value, const Target& target);

// The unit that is usual for quantities of this dimension.
std::string usual_unit(Dim dim) {
  if (dim == dims::kAngle) return "deg";
  if (dim == dims::kLength) return "mm";
  if (dim == dims::kSpeed) return "mm/s";
  if (dim == dims::kAccel) return "mm/s^2";
  if (dim == dims::kAngularSpeed) return "deg/s";
  if (dim == dims::kAngularAccel) return "deg/s^2";
  if (dim == dims::kMass) return "kg";
  return display_unit(dim, 1.0).name;
}

// The definition of a named dimension, such as "length per time", if it helps.
std::string made_of(Dim dim) {
  if (dim == dims::kSpeed) return "length per time";
  if (dim == dims::kAngularSpeed) return "angle per time";
  if (dim == dims::kAccel) return "length per time squared";
  if (dim == dims::kAngularAccel) return "angle per time squared";
  return dimension_phrase(dim);
}

bool is_number_literal(const hir::Expr& value) {
  return value.kind == hir::ExprKind::kInt || value.kind == hir::ExprKind::kReal;
}

std::string short_number(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

// Whether the text contains PI: PI / 2, 2*PI
bool mentions_pi(std::string_view text) {
  constexpr std::string_view kPi = "PI";
  const auto belongs_to_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = text.find(kPi); at != text.npos; at = text.find(kPi, at + 1)) {
    const std::size_t end = at + kPi.size();
    const bool begins = at == 0 || !belongs_to_word(text[at - 1]);
    if (begins && (end == text.size() || !belongs_to_word(text[end]))) return true;
  }
  return false;
}

// A time of which a whole number hardly counts seconds: from one picture or sample to the next.
bool is_short_time(std::string_view name) {
  return name == "period" || name == "every" || name == "step";
}

}  // namespace

void plain_number_for_quantity(Checker& checker, const hir::Expr& value, const Target& target) {
  if (variable_named_like_a_unit(checker, value, target)) return;
  Diagnostic out = make_diagnostic("E0401", value.span);
  out.mark.label = "plain number";
  if (!target.name.empty()) {
    out.why = '`' + std::string(target.name) + "` is " + dimension_phrase(target.type->dim);
  }
  const std::string text = checker.text_of(value.span);
  const std::string unit = usual_unit(target.type->dim);
  if (!is_number_literal(value) || !is_decimal_number(text)) {
    // Computed values are in SI units. A constant such as 45 / 2 was chosen by the author, perhaps
    // in degrees; PI / 2 is in radians.
    const bool is_chosen = checker.shared.constants.of(value) && !mentions_pi(text);
    const std::string& one = is_chosen ? unit : si_unit(target.type->dim);
    const std::string written = as_operand(text) + " * 1" + one;
    out.fix = Fix{.text = "write " + written, .edits = {{value.span, written}}};
  } else {
    const auto constant = checker.shared.constants.of(value);
    // 0.3 for a length or a speed hardly means a third of a millimetre.
    const bool is_small = constant && std::abs(constant->real) < 1.0;
    const bool metres = target.type->dim == dims::kLength || target.type->dim == dims::kSpeed;
    const bool is_short = target.type->dim == dims::kTime && is_short_time(target.name);
    const bool is_milli = is_short && constant && std::abs(constant->real) >= 1.0;
    const std::string written = text + (is_milli             ? "ms"
                                        : is_small && metres ? si_unit(target.type->dim)
                                                             : unit);
    out.fix = Fix{.text = "write " + written, .edits = {{value.span, written}}};
    if (is_milli) out.fix->text += ", or " + text + unit + " if seconds are meant";
    const double turns = constant ? std::abs(constant->real) / (2.0 * std::numbers::pi) : 0.0;
    if (target.type->dim == dims::kAngle && turns >= 1.0) {
      out.fix->text += " (or " + text + "rad, which is more than " +
                       short_number(std::floor(turns)) + (turns < 2.0 ? " turn)" : " turns)");
    }
  }
  checker.report(std::move(out));
}

void quantity_for_number(Checker& checker, const hir::Expr& value) {
  const Dim dim = value.type->dim;
  Diagnostic out = make_diagnostic("E0405", value.span, {dimension_phrase(dim)});
  out.mark.label = dimension_name(dim);
  if (dim == dims::kLength) {
    out.why = "the program would not say whether the number counts metres or millimetres";
  } else {
    out.why = "the program would not say which unit the number counts";
  }
  const std::string unit = dim == dims::kLength ? "mm" : display_unit(dim, 1.0).name;
  const std::string written = as_operand(checker.text_of(value.span)) + " / 1" + unit;
  out.fix = Fix{.text = "divide by the unit you want: " + written,
                .edits = {{value.span, written}},
                .confidence = Confidence::kMaybe};
  checker.report(std::move(out));
}

void other_quantity(Checker& checker, const hir::Expr& value, const Target& target) {
  const Dim have = value.type->dim;
  const Dim want = target.type->dim;
  if (variable_named_like_a_unit(checker, value, target)) return;
  const std::string text = checker.text_of(value.span);
  const bool literal = is_number_literal(value);
  if (want == dims::kAngularSpeed && have == want.without_angle()) {
    Diagnostic out = make_diagnostic("E0407", value.span);
    out.mark.label = "frequency";
    if (literal) {
      const auto constant = checker.shared.constants.of(value);
      const std::string number = text.substr(0, text.find_first_not_of("0123456789._"));
      const std::string_view count = number == "1" ? "one turn" : number == "2" ? "two turns" : "";
      out.fix = Fix{.text = "write " + text + " * 1rev for " +
                            (count.empty() ? number + " turns" : std::string(count)) +
                            " per second, or " + number + "rad/s",
                    .edits = {{value.span, text + " * 1rev"}},
                    .confidence = Confidence::kMaybe};
    }
    checker.report(std::move(out));
    return;
  }
  const bool handed =
      target.role == Target::Role::kArgument || target.role == Target::Role::kSetting;
  Diagnostic out =
      handed
          ? make_diagnostic("E0403", value.span,
                            {std::string(target.name), made_of(want), dimension_phrase(have)})
          : make_diagnostic("E0410", value.span, {dimension_phrase(want), dimension_phrase(have)});
  const auto quotient = divide(have, want);
  if (literal && quotient == dims::kTime) {
    out.fix = Fix{.text = "write " + text + "/s",
                  .edits = {{value.span, text + "/s"}},
                  .confidence = Confidence::kMaybe};
  }
  checker.report(std::move(out));
}

namespace {

bool variable_named_like_a_unit(Checker& checker, const hir::Expr& value, const Target& target) {
  const hir::Expr& origin = origin_of(value);
  if (origin.kind != hir::ExprKind::kBinary) return false;
  const auto& quotient = origin.as<hir::BinaryExpr>();
  const hir::Expr* divisor = quotient.right;
  if (divisor->kind == hir::ExprKind::kConvert) divisor = divisor->as<hir::ConvertExpr>().operand;
  if (quotient.op != hir::Op::kDivR || divisor->kind != hir::ExprKind::kVariable) return false;
  const hir::Variable& variable = *divisor->as<hir::VariableExpr>().variable;
  const Unit* unit = unit_named(variable.name);
  if (unit == nullptr || !is_number_literal(*quotient.left)) return false;
  if (divide(quotient.left->type->dim, unit->dim) != target.type->dim) return false;

  const std::string name(variable.name);
  Diagnostic out = make_diagnostic("E0406", origin.span, {name});
  const auto by = checker.shared.constants.of(*divisor);
  out.mark.label = dimension_phrase(quotient.left->type->dim) + " divided by " +
                   (by ? short_number(by->real) : name) + " is " +
                   dimension_phrase(origin.type->dim);
  out.related.push_back({variable.declared, "declared here"});
  if (!(value.span == origin.span)) {
    out.related.push_back({value.span, dimension_phrase(target.type->dim) + " is needed"});
  }
  const std::string written = checker.text_of(quotient.left->span) + "/" + name;
  out.fix = Fix{.text = "write " + written + " without spaces, or rename the variable",
                .edits = {{origin.span, written}},
                .confidence = Confidence::kMaybe};
  checker.report(std::move(out));
  return true;
}

}  // namespace

}  // namespace armlet::lang
