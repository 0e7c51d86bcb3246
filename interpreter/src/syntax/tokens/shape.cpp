#include "syntax/tokens/shape.hpp"

#include <RbtParser.h>

namespace armlet::lang {
namespace {

// Rule and the generated parser have the rules in the same order.
static_assert(static_cast<std::size_t>(Rule::kBlock) == RbtParser::RuleBlock);
static_assert(static_cast<std::size_t>(Rule::kFnBody) == RbtParser::RuleFnBody);
static_assert(static_cast<std::size_t>(Rule::kTypeName) == RbtParser::RuleTypeName);
static_assert(static_cast<std::size_t>(Rule::kSwitchCase) == RbtParser::RuleSwitchCase);
static_assert(static_cast<std::size_t>(Rule::kExprStmt) == RbtParser::RuleExprStmt);
static_assert(static_cast<std::size_t>(Rule::kName) == RbtParser::RuleName);

ShapeNode shape_of_part(antlr4::tree::ParseTree* tree) {
  if (auto* leaf = dynamic_cast<antlr4::tree::TerminalNode*>(tree)) {
    return {Rule::kToken, static_cast<std::uint32_t>(leaf->getSymbol()->getTokenIndex()), {}};
  }
  auto* context = static_cast<antlr4::ParserRuleContext*>(tree);
  if (context->children.size() == 1) return shape_of_part(context->children[0]);
  ShapeNode node{static_cast<Rule>(context->getRuleIndex()),
                 static_cast<std::uint32_t>(context->start->getTokenIndex()),
                 {}};
  node.parts.reserve(context->children.size());
  for (antlr4::tree::ParseTree* child : context->children) {
    node.parts.push_back(shape_of_part(child));
  }
  return node;
}

class Comparison {
 public:
  Comparison(const Shape& a, const Source& a_text, const Shape& b, const Source& b_text)
      : a_(a), b_(b), a_text_(a_text), b_text_(b_text) {}

  bool same(const ShapeNode& a, const ShapeNode& b) const {
    if (a.rule != b.rule) return false;
    if (a.rule == Rule::kToken) return same_token(a_.tokens[a.token], b_.tokens[b.token]);
    std::size_t i = 0;
    std::size_t j = 0;
    while (true) {
      while (i < a.parts.size() && stands_for_nothing(a.parts[i], a_)) ++i;
      while (j < b.parts.size() && stands_for_nothing(b.parts[j], b_)) ++j;
      if (i == a.parts.size() || j == b.parts.size()) break;
      if (!same(a.parts[i++], b.parts[j++])) return false;
    }
    return i == a.parts.size() && j == b.parts.size();
  }

 private:
  static bool stands_for_nothing(const ShapeNode& node, const Shape& shape) {
    return node.rule == Rule::kToken && shape.tokens[node.token].inserted;
  }

  bool same_token(const Token& a, const Token& b) const {
    return a.type == b.type && a_text_.text().substr(a.begin, a.end - a.begin) ==
                                   b_text_.text().substr(b.begin, b.end - b.begin);
  }

  const Shape& a_;
  const Shape& b_;
  const Source& a_text_;
  const Source& b_text_;
};

}  // namespace

ShapeNode shape_of(antlr4::ParserRuleContext* statement) { return shape_of_part(statement); }

bool same_shape(const Shape& a, const Source& a_text, const Shape& b, const Source& b_text) {
  return Comparison(a, a_text, b, b_text).same(a.program, b.program);
}

}  // namespace armlet::lang
