// Rules between the columns of bytecode.def, which the compiler of this file checks.

#include "program/properties.hpp"

#include <algorithm>

namespace armlet::lang {

namespace {

template <class F>
constexpr bool holds_for_all(F f) {
  for (std::size_t i = 0; i < kOpCodes; ++i) {
    if (!f(static_cast<OpCode>(i))) return false;
  }
  return true;
}

// Whether a claim holds for all pairs of an instruction and its variant.
template <class F>
constexpr bool holds_for_variants(Variant variant, F f) {
  return holds_for_all(
      [&](OpCode op) { return !has_variant(variant, op) || f(op, variant_of(variant, op)); });
}

constexpr bool is_test(OpCode op) { return properties_of(op).flow == ControlFlow::kTest; }
constexpr bool is_letter_of(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

// ---- columns

static_assert(holds_for_all([](OpCode op) { return !properties_of(op).name.empty(); }));
static_assert(holds_for_all([](OpCode op) {
  return std::ranges::all_of(properties_of(op).operands,
                             [](char letter) { return is_letter_of(detail::kLetters, letter); });
}));
static_assert(holds_for_all([](OpCode op) {
                return !is_letter_of("dDuUa", operand_of(op, 1)) &&
                       !is_letter_of("dDuUa", operand_of(op, 2));
              }),
              "a destination is the first operand, and so are arguments");
static_assert(holds_for_all([](OpCode op) {
                return (properties_of(op).effect == Effect::kUpdate) == (operand_of(op, 0) == 'u');
              }),
              "what is updated is read and written");
static_assert(holds_for_all([](OpCode op) {
                const Effect effect = properties_of(op).effect;
                const bool is_value =
                    effect == Effect::kPure || effect == Effect::kLoad || effect == Effect::kInside;
                return !is_value || operand_of(op, 0) == 'd';
              }),
              "a value goes to a number register");
static_assert(holds_for_all([](OpCode op) {
                const Effect effect = properties_of(op).effect;
                return (effect != Effect::kStoreA || operand_of(op, 0) == 'R') &&
                       (effect != Effect::kStoreB || is_register(operand_of(op, 1)));
              }),
              "what is stored into is in a register");
static_assert(holds_for_all([](OpCode op) {
                return properties_of(op).last != Last::kMakes ||
                       is_letter_of("du", operand_of(op, 0));
              }),
              "a double that is computed goes to a register");
static_assert(holds_for_all([](OpCode op) {
                return !is_operand_word(op) || (!properties_of(op).defines &&
                                                properties_of(op).window == WindowKind::kNone);
              }),
              "operands of another instruction are only read");

// ---- variants

static_assert(holds_for_all([](OpCode op) {
                return is_test(op) == has_variant(Variant::kBeforeLoop, op) ||
                       properties_of(op).name.ends_with("_LOOP");
              }),
              "every comparison has a variant before a LOOP");
static_assert(holds_for_variants(Variant::kLastA, [](OpCode op, OpCode) {
  return is_register(operand_of(op, 0)) || op == OpCode::RETHERE;
}));
static_assert(holds_for_variants(Variant::kLastB, [](OpCode op, OpCode) {
  return is_letter_of("rs", operand_of(op, 1));
}));
static_assert(holds_for_variants(Variant::kLastC,
                                 [](OpCode op, OpCode) { return operand_of(op, 2) == 'r'; }));
static_assert(holds_for_variants(Variant::kTurned,
                                 [](OpCode op, OpCode turned) {
                                   return is_test(op) &&
                                          variant_of(Variant::kTurned, turned) == op &&
                                          variant_of(Variant::kElementLeft, turned) ==
                                              variant_of(Variant::kElementRight, op);
                                 }),
              "turned twice is as before");
static_assert(holds_for_variants(Variant::kSmall,
                                 [](OpCode op, OpCode small) {
                                   const std::size_t right = is_test(op) ? 1 : 2;
                                   return properties_of(op).flow == properties_of(small).flow &&
                                          properties_of(op).effect == properties_of(small).effect &&
                                          properties_of(op).last == properties_of(small).last &&
                                          operand_of(small, right) == 'i' &&
                                          is_register(operand_of(op, right));
                                 }),
              "the operand on the right is small, all else is as before");

// Whether the variant takes an element of a list as an operand. Comparisons name a[b]; instructions
// that compute a value have the element in the next word.
constexpr bool takes_element(OpCode op, OpCode variant) {
  if (!is_test(op)) return properties_of(variant).operands == std::array{'d', 'R', 'r'};
  const bool small = operand_of(op, 1) == 'i';
  return is_test(variant) &&
         properties_of(variant).operands == std::array{'R', 'r', small ? 'i' : 'r'} &&
         properties_of(variant).effect == properties_of(op).effect;
}
static_assert(holds_for_variants(Variant::kElementLeft, takes_element));
static_assert(holds_for_variants(Variant::kElementRight, takes_element));
static_assert(holds_for_variants(Variant::kElementChanged,
                                 [](OpCode op, OpCode changed) {
                                   return properties_of(op).last != Last::kForgets &&
                                          operand_of(changed, 0) == 'R' &&
                                          operand_of(changed, 1) == 'r';
                                 }),
              "the element is a[b]");

constexpr bool counts(OpCode op, OpCode variant) {
  return is_test(op) && is_test(variant) && operand_of(variant, 0) == 'u' &&
         (operand_of(variant, 1) == 'i') == (operand_of(op, 1) == 'i');
}
static_assert(holds_for_variants(Variant::kBehindStep, [](OpCode op, OpCode variant) {
  return counts(op, variant) && operand_of(variant, 2) == 'r';
}));
static_assert(holds_for_variants(Variant::kBehindCount, [](OpCode op, OpCode variant) {
  return counts(op, variant) && operand_of(variant, 2) == 'i';
}));
static_assert(holds_for_variants(Variant::kBehindCountOne, [](OpCode op, OpCode variant) {
  return counts(op, variant) && operand_of(variant, 2) == '-';
}));
static_assert(holds_for_variants(Variant::kOtherwiseMove,
                                 [](OpCode op, OpCode move) {
                                   return is_test(op) && operand_of(move, 0) == 'u' &&
                                          has_variant(Variant::kOtherwiseCount, op);
                                 }),
              "a comparison that chooses a move chooses a count too");
static_assert(holds_for_variants(Variant::kIfZero,
                                 [](OpCode op, OpCode test) {
                                   return is_test(test) && has_variant(Variant::kIfNotZero, op) &&
                                          operand_of(op, 1) == operand_of(test, 0) &&
                                          operand_of(op, 2) == operand_of(test, 1);
                                 }),
              "the comparison has the operands of what it compares with 0");

}  // namespace

}  // namespace armlet::lang
