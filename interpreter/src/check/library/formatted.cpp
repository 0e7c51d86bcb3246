// Checks formatted texts: f"value {j + 1} at {q[j]:.1f deg}".

#include "check/library/formatted.hpp"

#include "check/library/native_calls.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {

// f"{n:x}", f"{n:d}": the language has no such format letters. px is no such letter but a unit.
static bool is_kind_of_python(std::string_view unit) {
  return unit.size() == 1 && std::string_view("bcdnosxX").find(unit[0]) != std::string_view::npos;
}

hir::Expr* to_text(Checker& checker, hir::Expr* value) {
  if (value->type->is(Kind::kText) || value->type->is(Kind::kAny)) return value;
  return checker.make<hir::ToTextExpr>(hir::ExprKind::kToText, checker.types.text(), value->span,
                                       value, TextStyle{}, std::string_view{}, 1.0);
}

hir::Expr* check_formatted(Checker& checker, const ast::FormattedExpr& text) {
  std::vector<hir::Expr*> parts;
  const auto add_text = [&](std::string_view piece) {
    if (piece.empty()) return;
    parts.push_back(checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(),
                                                text.span, checker.arena.copy(piece)));
  };
  for (std::size_t i = 0; i < text.pieces.size(); ++i) {
    add_text(text.texts[i]);
    parts.push_back(
        in_format(checker, checker.check_value(*text.pieces[i].value), text.pieces[i].format));
  }
  add_text(text.texts.back());
  return checker.make<hir::ConcatExpr>(hir::ExprKind::kConcat, checker.types.text(), text.span,
                                       checker.seq(parts));
}

namespace {

// The unit of a format; empty after a message.
std::optional<CombinedUnit> unit_of(Checker& checker, const ast::FormatSpec& format) {
  if (const auto unit = parse_unit(format.unit)) return unit;
  std::vector<std::string_view> names;
  for (const Unit& known : all_units()) names.push_back(known.name);
  Diagnostic diagnostic = make_diagnostic("E0209", format.span, {std::string(format.unit)});
  if (is_kind_of_python(format.unit)) {
    diagnostic.why = "the letters of Python's formats are left out: {n}, {n:5}, {n:.2f}";
  } else if (const auto near = suggest(format.unit, std::span<const std::string_view>(names))) {
    Span word = format.span;
    const std::size_t at = checker.text_of(word).rfind(format.unit);
    if (at != std::string::npos) word.begin += static_cast<std::uint32_t>(at);
    diagnostic.fix = Fix{.text = "did you mean " + std::string(*near) + "?",
                         .edits = {{word, std::string(*near)}}};
  }
  checker.report(std::move(diagnostic));
  return std::nullopt;
}

// Reports E0402: a value of one dimension with a unit of another.
hir::Expr* refuse_unit(Checker& checker, const hir::Expr& value, const ast::FormatSpec& format,
                       const std::string& phrase, const std::string& have, Dim unit) {
  Diagnostic diagnostic =
      make_diagnostic("E0402", format.span, {phrase, "shown in", std::string(format.unit)});
  diagnostic.mark.label = dimension_name(unit);
  diagnostic.related.push_back({value.span, have});
  checker.report(std::move(diagnostic));
  return checker.failed(value.span);
}

// The format of a number in the syntax of fmt: "+8.2f".
std::string style_text(const TextStyle& style) {
  std::string out;
  if (style.align != 0) out += style.align;
  if (style.sign) out += '+';
  if (style.zeros) out += '0';
  if (style.width > 0) out += std::to_string(style.width);
  if (style.digits >= 0) out += '.' + std::to_string(style.digits);
  if (style.notation != 0) out += style.notation;
  if (style.digits >= 0 && style.notation == 0) out += 'f';
  return out;
}

// A host value whose type has a function "NAME{:}": (value, style, unit) -> string, which writes
// each length and angle in the format. Null if there is no such function.
hir::Expr* host_in_format(Checker& checker, hir::Expr* value, const ast::FormatSpec& format) {
  if (!value->type->is(Kind::kHost)) return nullptr;
  const std::string name = type_name(value->type) + "{:}";
  const auto found = checker.registry.functions(name);
  if (found.empty()) return nullptr;
  if (!format.unit.empty()) {
    const std::optional<CombinedUnit> unit = unit_of(checker, format);
    if (!unit) return checker.failed(value->span);
    if (unit->dim != dims::kLength && unit->dim != dims::kAngle)
      return refuse_unit(checker, *value, format, type_phrase(value->type), "lengths and angles",
                         unit->dim);
  }
  const auto text = [&](std::string_view said) {
    return Argument{.value = checker.make<hir::TextExpr>(hir::ExprKind::kText, checker.types.text(),
                                                         value->span, checker.arena.copy(said))};
  };
  return call_native(checker, name, found, value->span, value->span,
                     {Argument{.value = value}, text(style_text(format.style)), text(format.unit)});
}

}  // namespace

hir::Expr* in_format(Checker& checker, hir::Expr* value, const ast::FormatSpec& format) {
  if (value->type->is(Kind::kAny)) return value;
  if (format.style.is_plain() && format.unit.empty()) return to_text(checker, value);
  if (hir::Expr* text = host_in_format(checker, value, format)) return text;

  const Type* number = value->type;
  while (number->is(Kind::kList) || number->is(Kind::kMap)) number = number->element;
  if (number->is(Kind::kMatrix)) number = checker.types.real();
  const bool only_width = !format.style.needs_number() && format.unit.empty();
  const bool is_word =
      value->type->is(Kind::kText) || value->type->is(Kind::kBool) || value->type->is(Kind::kEnum);
  if (!number->is_number() && !(only_width && is_word)) {
    checker.report(make_diagnostic("E0314", value->span, {type_phrase(value->type)}));
    return checker.failed(value->span);
  }
  double factor = 1.0;
  if (!format.unit.empty()) {
    const std::optional<CombinedUnit> unit = unit_of(checker, format);
    if (!unit) return checker.failed(value->span);
    // An angle may have been converted to a plain number in radians already.
    if (unit->dim != number->dim && unit->dim.without_angle() != number->dim)
      return refuse_unit(checker, *value, format, dimension_phrase(number->dim),
                         dimension_name(number->dim), unit->dim);
    factor = unit->factor;
  }
  return checker.make<hir::ToTextExpr>(hir::ExprKind::kToText, checker.types.text(), value->span,
                                       value, format.style, checker.arena.copy(format.unit),
                                       factor);
}

}  // namespace armlet::lang
