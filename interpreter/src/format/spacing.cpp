// The space between neighbouring tokens.

#include <algorithm>

#include "format/layout.hpp"

namespace armlet::lang {
namespace {

bool is_plain_number(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || c == '_'; });
}

bool is_quantity(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.empty() || !(is_digit(text[0]) || text[0] == '.')) return false;
  const char last = text.back();
  return !is_digit(last) && last != '.' && last != '_';
}

// Whether a rule has no blanks between its tokens: pal.Pallet, force/length^2, double[], 1:4.
bool is_tight(Rule rule) {
  return rule == Rule::kTypeName || rule == Rule::kDimType || rule == Rule::kDimFactor ||
         rule == Rule::kInParens || rule == Rule::kType || rule == Rule::kIndexItem ||
         rule == Rule::kNewDim;
}

}  // namespace

bool Layout::is_one_word(const ShapeNode& node) const {
  return node.rule == Rule::kBracketPair ||
         (node.rule == Rule::kPrimary && node.parts.size() == 3 && is(node.parts[1], ":"));
}

// The space before part `part`, which is not the first one.
Lead Layout::between(const ShapeNode& node, std::size_t part) const {
  const ShapeNode& right = node.parts[part];
  if (shape_.tokens[right.token].inserted || is(right, ",") || is(right, ";")) return Lead::kTight;
  if (is_tight(node.rule) || is_one_word(node)) return Lead::kTight;
  const auto tight_if = [](bool tight) { return tight ? Lead::kTight : Lead::kSpace; };
  const Rule rule = node.rule;
  if (rule == Rule::kExpr) return between_operands(node, part);
  if (rule == Rule::kExprStmt) {  // i++
    const ShapeNode& first = node.parts[0];
    return tight_if(is(first, "++") || is(first, "--") || is(right, "++") || is(right, "--"));
  }
  if (rule == Rule::kWaitStmt)  // wait(2s), wait 2s
    return tight_if(node.parts.size() == 2 && text_of(right.token) == "(");
  if (rule == Rule::kPrimary || rule == Rule::kBlockItem)
    return tight_if(right.rule == Rule::kArgs || is(right, ":"));
  if (rule == Rule::kFnDecl || rule == Rule::kLambda || rule == Rule::kFnType)
    return tight_if(is(right, "("));
  if (rule == Rule::kForHeader) return Lead::kSpace;
  const bool is_size = rule == Rule::kNewArray && right.rule == Rule::kNewDim;
  return tight_if(is_size || is(right, "[") || is(right, ":"));
}

// Operators with one operand have no blank after them; `^` has none at both sides if its operands
// are words.
Lead Layout::between_operands(const ShapeNode& node, std::size_t part) const {
  const ShapeNode& left = node.parts[part - 1];
  const ShapeNode& right = node.parts[part];
  const std::string_view before = text_of(last_token(left));
  if (right.rule == Rule::kArgs || is(right, "[") || is(left, ".")) return Lead::kTight;
  if (is(right, ".")) return is_plain_number(before) ? Lead::kSpace : Lead::kTight;
  if (node.parts.size() == 2) {  // -x, but - -x
    return text_of(right.token)[0] == before[0] && before != "!" ? Lead::kSpace : Lead::kTight;
  }
  if (is(left, "^") || is(right, "^")) {  // l^2, but (a + b) ^ 2, and never 2m^2 for 2m ^ 2
    const bool touch = is_short(node.parts[0]) && is_short(node.parts[2]) &&
                       !is_quantity(text_of(last_token(node.parts[0])));
    return touch ? Lead::kTight : Lead::kSpace;
  }
  return Lead::kSpace;
}

}  // namespace armlet::lang
