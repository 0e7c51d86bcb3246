#pragma once
// A program as its author wrote it: every token, every comment, and the rules of the grammar that
// the tokens belong to. What the formatter works on; the tree of ast.hpp forgets too much for it.

#include <cstdint>
#include <vector>

#include "syntax/tokens/token.hpp"

namespace antlr4 {
class ParserRuleContext;
}

namespace armlet::lang {

// The rules of grammar/RbtParser.g4, in its order, and the tokens.
enum class Rule : std::uint8_t {
  kProgram,
  kStmt,
  kClosedStmt,
  kBlock,
  kLetDecl,
  kVarDecl,
  kDeclarator,
  kInitializer,
  kBraceInit,
  kBraceItem,
  kBlockDecl,
  kBlockItem,
  kFnDecl,
  kFnBody,
  kParams,
  kParam,
  kStructDecl,
  kEnumDecl,
  kImportDecl,
  kTestDecl,
  kType,
  kBracketPair,
  kFnType,
  kResultType,
  kAnyType,
  kDimType,
  kDimFactor,
  kInParens,
  kTypeName,
  kPrimType,
  kIfStmt,
  kIfBody,
  kWhileStmt,
  kDoStmt,
  kForStmt,
  kForHeader,
  kForInit,
  kForUpdate,
  kSwitchStmt,
  kSwitchCase,
  kTryStmt,
  kCatchClause,
  kParallelStmt,
  kWhenStmt,
  kEveryStmt,
  kWaitStmt,
  kWithStmt,
  kPathStmt,
  kRecordStmt,
  kExprStmt,
  kAssignTail,
  kCompoundOp,
  kExpression,
  kLambda,
  kExpr,
  kPrimary,
  kRow,
  kItem,
  kNewArray,
  kNewDim,
  kIndexItem,
  kArgs,
  kArg,
  kLiteral,
  kName,
  kToken
};

// A rule with what it consists of; rules that consist of one part only are left out, so that
// `(f(x))` is not twenty levels deep.
struct ShapeNode {
  Rule rule = Rule::kProgram;
  std::uint32_t token = 0;  // kToken: its index; otherwise the index of its first token
  std::vector<ShapeNode> parts = {};
};

struct Shape {
  Tokens tokens;  // with the inserted ends of statements
  std::vector<Span> comments;
  ShapeNode program;
};

// The shape of one statement that the parser has read.
[[nodiscard]] ShapeNode shape_of(antlr4::ParserRuleContext* statement);

// Whether two programs consist of the same tokens, put together in the same way. Ends of statements
// that stand for nothing, such as the one after a block, do not count.
[[nodiscard]] bool same_shape(const Shape& a, const Source& a_text, const Shape& b,
                              const Source& b_text);

}  // namespace armlet::lang
