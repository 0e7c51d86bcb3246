#pragma once
// The concrete syntax of a program for the formatter: every token, every comment, and the grammar
// rules of the tokens. The syntax tree of ast.hpp lacks details that the formatter needs.

#include <cstdint>
#include <vector>

#include "syntax/tokens/token.hpp"

namespace antlr4 {
class ParserRuleContext;
}

namespace armlet::lang {

// The rules of grammar/RbtParser.g4 in its order, and tokens.
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

// A grammar rule with its parts. Rules that have only one part are omitted, so that `(f(x))` does
// not have twenty levels.
struct ShapeNode {
  Rule rule = Rule::kProgram;
  std::uint32_t token = 0;  // kToken: its index; otherwise that of its first token
  std::vector<ShapeNode> parts = {};
};

struct Shape {
  Tokens tokens;  // with the inserted ends of statements
  std::vector<Span> comments;
  ShapeNode program;
};

// The shape of one statement that the parser has read.
[[nodiscard]] ShapeNode shape_of(antlr4::ParserRuleContext* statement);

// Whether two programs have the same tokens in the same grammar rules. Ends of statements without
// effect, such as the one after a block, are ignored.
[[nodiscard]] bool same_shape(const Shape& a, const Source& a_text, const Shape& b,
                              const Source& b_text);

}  // namespace armlet::lang
