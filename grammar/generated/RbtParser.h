
// Generated from RbtParser.g4 by ANTLR 4.7.2

#pragma once


#include "antlr4-runtime.h"


#include "guarded_parser.hpp"




class  RbtParser : public GuardedParser {
public:
  enum {
    LET = 1, VAR = 2, FN = 3, STRUCT = 4, ENUM = 5, IMPORT = 6, FINAL = 7, 
    VOID = 8, NEW = 9, IF = 10, ELSE = 11, WHILE = 12, DO = 13, FOR = 14, 
    IN = 15, SWITCH = 16, CASE = 17, DEFAULT = 18, BREAK = 19, CONTINUE = 20, 
    RETURN = 21, TRY = 22, CATCH = 23, FINALLY = 24, THROW = 25, RETRY = 26, 
    PARALLEL = 27, WHEN = 28, EVERY = 29, WAIT = 30, UNTIL = 31, WITH = 32, 
    TRUE = 33, FALSE = 34, INT_T = 35, DOUBLE_T = 36, BOOL_T = 37, TEST = 38, 
    RECORD = 39, PATH = 40, AS = 41, QUANTITY = 42, FLOAT = 43, INT = 44, 
    BADNUM = 45, FSTRING = 46, STRING = 47, BADSTR = 48, ID = 49, LBRACE = 50, 
    RBRACE = 51, LPAREN = 52, RPAREN = 53, LBRACK = 54, RBRACK = 55, SEMI = 56, 
    COMMA = 57, DOT = 58, COLON = 59, QMARK = 60, ARROW = 61, FATARROW = 62, 
    EQ = 63, NE = 64, LE = 65, GE = 66, LT = 67, GT = 68, ANDAND = 69, OROR = 70, 
    NOT = 71, PLUSEQ = 72, MINUSEQ = 73, STAREQ = 74, SLASHEQ = 75, PERCENTEQ = 76, 
    ASSIGN = 77, INC = 78, DEC = 79, DOTSTAR = 80, DOTSLASH = 81, DOTCARET = 82, 
    PLUS = 83, MINUS = 84, STAR = 85, SLASH = 86, PERCENT = 87, BSLASH = 88, 
    CARET = 89, BLOCK_COMMENT = 90, LINE_COMMENT = 91, NL = 92, WS = 93, 
    ERR = 94
  };

  enum {
    RuleProgram = 0, RuleStmt = 1, RuleClosedStmt = 2, RuleBlock = 3, RuleLetDecl = 4, 
    RuleVarDecl = 5, RuleDeclarator = 6, RuleInitializer = 7, RuleBraceInit = 8, 
    RuleBraceItem = 9, RuleBlockDecl = 10, RuleBlockItem = 11, RuleFnDecl = 12, 
    RuleFnBody = 13, RuleParams = 14, RuleParam = 15, RuleStructDecl = 16, 
    RuleEnumDecl = 17, RuleImportDecl = 18, RuleTestDecl = 19, RuleType = 20, 
    RuleBracketPair = 21, RuleFnType = 22, RuleResultType = 23, RuleAnyType = 24, 
    RuleDimType = 25, RuleDimFactor = 26, RuleInParens = 27, RuleTypeName = 28, 
    RulePrimType = 29, RuleIfStmt = 30, RuleIfBody = 31, RuleWhileStmt = 32, 
    RuleDoStmt = 33, RuleForStmt = 34, RuleForHeader = 35, RuleForInit = 36, 
    RuleForUpdate = 37, RuleSwitchStmt = 38, RuleSwitchCase = 39, RuleTryStmt = 40, 
    RuleCatchClause = 41, RuleParallelStmt = 42, RuleWhenStmt = 43, RuleEveryStmt = 44, 
    RuleWaitStmt = 45, RuleWithStmt = 46, RulePathStmt = 47, RuleRecordStmt = 48, 
    RuleExprStmt = 49, RuleAssignTail = 50, RuleCompoundOp = 51, RuleExpression = 52, 
    RuleLambda = 53, RuleExpr = 54, RulePrimary = 55, RuleRow = 56, RuleItem = 57, 
    RuleNewArray = 58, RuleNewDim = 59, RuleIndexItem = 60, RuleArgs = 61, 
    RuleArg = 62, RuleLiteral = 63, RuleName = 64
  };

  RbtParser(antlr4::TokenStream *input);
  ~RbtParser();

  virtual std::string getGrammarFileName() const override;
  virtual const antlr4::atn::ATN& getATN() const override { return _atn; };
  virtual const std::vector<std::string>& getTokenNames() const override { return _tokenNames; }; // deprecated: use vocabulary instead.
  virtual const std::vector<std::string>& getRuleNames() const override;
  virtual antlr4::dfa::Vocabulary& getVocabulary() const override;


    // What a reader would call one level of nesting.
    bool opensLevel(size_t rule) const override {
      return rule == RuleStmt || rule == RuleIfStmt || rule == RuleExpr || rule == RuleLambda || rule == RuleInitializer ||
             rule == RuleAnyType;
    }


  class ProgramContext;
  class StmtContext;
  class ClosedStmtContext;
  class BlockContext;
  class LetDeclContext;
  class VarDeclContext;
  class DeclaratorContext;
  class InitializerContext;
  class BraceInitContext;
  class BraceItemContext;
  class BlockDeclContext;
  class BlockItemContext;
  class FnDeclContext;
  class FnBodyContext;
  class ParamsContext;
  class ParamContext;
  class StructDeclContext;
  class EnumDeclContext;
  class ImportDeclContext;
  class TestDeclContext;
  class TypeContext;
  class BracketPairContext;
  class FnTypeContext;
  class ResultTypeContext;
  class AnyTypeContext;
  class DimTypeContext;
  class DimFactorContext;
  class InParensContext;
  class TypeNameContext;
  class PrimTypeContext;
  class IfStmtContext;
  class IfBodyContext;
  class WhileStmtContext;
  class DoStmtContext;
  class ForStmtContext;
  class ForHeaderContext;
  class ForInitContext;
  class ForUpdateContext;
  class SwitchStmtContext;
  class SwitchCaseContext;
  class TryStmtContext;
  class CatchClauseContext;
  class ParallelStmtContext;
  class WhenStmtContext;
  class EveryStmtContext;
  class WaitStmtContext;
  class WithStmtContext;
  class PathStmtContext;
  class RecordStmtContext;
  class ExprStmtContext;
  class AssignTailContext;
  class CompoundOpContext;
  class ExpressionContext;
  class LambdaContext;
  class ExprContext;
  class PrimaryContext;
  class RowContext;
  class ItemContext;
  class NewArrayContext;
  class NewDimContext;
  class IndexItemContext;
  class ArgsContext;
  class ArgContext;
  class LiteralContext;
  class NameContext; 

  class  ProgramContext : public GuardedCtx {
  public:
    ProgramContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *EOF();
    std::vector<StmtContext *> stmt();
    StmtContext* stmt(size_t i);

   
  };

  ProgramContext* program();

  class  StmtContext : public GuardedCtx {
  public:
    StmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    BlockContext *block();
    antlr4::tree::TerminalNode *SEMI();
    LetDeclContext *letDecl();
    VarDeclContext *varDecl();
    BlockDeclContext *blockDecl();
    FnDeclContext *fnDecl();
    StructDeclContext *structDecl();
    EnumDeclContext *enumDecl();
    ImportDeclContext *importDecl();
    TestDeclContext *testDecl();
    IfStmtContext *ifStmt();
    WhileStmtContext *whileStmt();
    DoStmtContext *doStmt();
    ForStmtContext *forStmt();
    SwitchStmtContext *switchStmt();
    TryStmtContext *tryStmt();
    ParallelStmtContext *parallelStmt();
    WhenStmtContext *whenStmt();
    EveryStmtContext *everyStmt();
    WithStmtContext *withStmt();
    PathStmtContext *pathStmt();
    RecordStmtContext *recordStmt();
    ClosedStmtContext *closedStmt();

   
  };

  StmtContext* stmt();

  class  ClosedStmtContext : public GuardedCtx {
  public:
    ClosedStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    ExprStmtContext *exprStmt();
    antlr4::tree::TerminalNode *SEMI();
    WaitStmtContext *waitStmt();
    antlr4::tree::TerminalNode *BREAK();
    antlr4::tree::TerminalNode *CONTINUE();
    antlr4::tree::TerminalNode *RETRY();
    antlr4::tree::TerminalNode *RETURN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *THROW();

   
  };

  ClosedStmtContext* closedStmt();

  class  BlockContext : public GuardedCtx {
  public:
    BlockContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<StmtContext *> stmt();
    StmtContext* stmt(size_t i);

   
  };

  BlockContext* block();

  class  LetDeclContext : public GuardedCtx {
  public:
    LetDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    NameContext *name();
    antlr4::tree::TerminalNode *LET();
    antlr4::tree::TerminalNode *VAR();
    antlr4::tree::TerminalNode *COLON();
    AnyTypeContext *anyType();
    antlr4::tree::TerminalNode *ASSIGN();
    InitializerContext *initializer();

   
  };

  LetDeclContext* letDecl();

  class  VarDeclContext : public GuardedCtx {
  public:
    VarDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    TypeContext *type();
    std::vector<DeclaratorContext *> declarator();
    DeclaratorContext* declarator(size_t i);
    antlr4::tree::TerminalNode *FINAL();
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  VarDeclContext* varDecl();

  class  DeclaratorContext : public GuardedCtx {
  public:
    DeclaratorContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    NameContext *name();
    std::vector<antlr4::tree::TerminalNode *> LBRACK();
    antlr4::tree::TerminalNode* LBRACK(size_t i);
    std::vector<antlr4::tree::TerminalNode *> RBRACK();
    antlr4::tree::TerminalNode* RBRACK(size_t i);
    antlr4::tree::TerminalNode *ASSIGN();
    InitializerContext *initializer();

   
  };

  DeclaratorContext* declarator();

  class  InitializerContext : public GuardedCtx {
  public:
    InitializerContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    ExpressionContext *expression();
    BraceInitContext *braceInit();

   
  };

  InitializerContext* initializer();

  class  BraceInitContext : public GuardedCtx {
  public:
    BraceInitContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<BraceItemContext *> braceItem();
    BraceItemContext* braceItem(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  BraceInitContext* braceInit();

  class  BraceItemContext : public GuardedCtx {
  public:
    BraceItemContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<InitializerContext *> initializer();
    InitializerContext* initializer(size_t i);
    antlr4::tree::TerminalNode *COLON();

   
  };

  BraceItemContext* braceItem();

  class  BlockDeclContext : public GuardedCtx {
  public:
    BlockDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    TypeNameContext *typeName();
    NameContext *name();
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<BlockItemContext *> blockItem();
    BlockItemContext* blockItem(size_t i);

   
  };

  BlockDeclContext* blockDecl();

  class  BlockItemContext : public GuardedCtx {
  public:
    BlockItemContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<NameContext *> name();
    NameContext* name(size_t i);
    antlr4::tree::TerminalNode *COLON();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *SEMI();
    antlr4::tree::TerminalNode *COMMA();
    ArgsContext *args();

   
  };

  BlockItemContext* blockItem();

  class  FnDeclContext : public GuardedCtx {
  public:
    FnDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *FN();
    NameContext *name();
    antlr4::tree::TerminalNode *LPAREN();
    antlr4::tree::TerminalNode *RPAREN();
    FnBodyContext *fnBody();
    ParamsContext *params();
    antlr4::tree::TerminalNode *ARROW();
    ResultTypeContext *resultType();
    BlockContext *block();
    TypeContext *type();
    antlr4::tree::TerminalNode *VOID();

   
  };

  FnDeclContext* fnDecl();

  class  FnBodyContext : public GuardedCtx {
  public:
    FnBodyContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    BlockContext *block();
    antlr4::tree::TerminalNode *FATARROW();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *SEMI();

   
  };

  FnBodyContext* fnBody();

  class  ParamsContext : public GuardedCtx {
  public:
    ParamsContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ParamContext *> param();
    ParamContext* param(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  ParamsContext* params();

  class  ParamContext : public GuardedCtx {
  public:
    ParamContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    NameContext *name();
    antlr4::tree::TerminalNode *COLON();
    AnyTypeContext *anyType();
    antlr4::tree::TerminalNode *ASSIGN();
    ExpressionContext *expression();
    TypeContext *type();
    antlr4::tree::TerminalNode *FINAL();
    std::vector<antlr4::tree::TerminalNode *> LBRACK();
    antlr4::tree::TerminalNode* LBRACK(size_t i);
    std::vector<antlr4::tree::TerminalNode *> RBRACK();
    antlr4::tree::TerminalNode* RBRACK(size_t i);

   
  };

  ParamContext* param();

  class  StructDeclContext : public GuardedCtx {
  public:
    StructDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *STRUCT();
    NameContext *name();
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<ParamContext *> param();
    ParamContext* param(size_t i);
    std::vector<antlr4::tree::TerminalNode *> SEMI();
    antlr4::tree::TerminalNode* SEMI(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  StructDeclContext* structDecl();

  class  EnumDeclContext : public GuardedCtx {
  public:
    EnumDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *ENUM();
    std::vector<NameContext *> name();
    NameContext* name(size_t i);
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);
    std::vector<antlr4::tree::TerminalNode *> SEMI();
    antlr4::tree::TerminalNode* SEMI(size_t i);

   
  };

  EnumDeclContext* enumDecl();

  class  ImportDeclContext : public GuardedCtx {
  public:
    ImportDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *IMPORT();
    antlr4::tree::TerminalNode *STRING();
    TypeNameContext *typeName();
    antlr4::tree::TerminalNode *AS();
    NameContext *name();

   
  };

  ImportDeclContext* importDecl();

  class  TestDeclContext : public GuardedCtx {
  public:
    TestDeclContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *TEST();
    antlr4::tree::TerminalNode *STRING();
    BlockContext *block();

   
  };

  TestDeclContext* testDecl();

  class  TypeContext : public GuardedCtx {
  public:
    TypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    PrimTypeContext *primType();
    TypeNameContext *typeName();
    std::vector<BracketPairContext *> bracketPair();
    BracketPairContext* bracketPair(size_t i);

   
  };

  TypeContext* type();

  class  BracketPairContext : public GuardedCtx {
  public:
    BracketPairContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LBRACK();
    antlr4::tree::TerminalNode *RBRACK();
    PrimTypeContext *primType();
    TypeNameContext *typeName();

   
  };

  BracketPairContext* bracketPair();

  class  FnTypeContext : public GuardedCtx {
  public:
    FnTypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *FN();
    antlr4::tree::TerminalNode *LPAREN();
    antlr4::tree::TerminalNode *RPAREN();
    antlr4::tree::TerminalNode *ARROW();
    ResultTypeContext *resultType();
    std::vector<AnyTypeContext *> anyType();
    AnyTypeContext* anyType(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  FnTypeContext* fnType();

  class  ResultTypeContext : public GuardedCtx {
  public:
    ResultTypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    AnyTypeContext *anyType();
    antlr4::tree::TerminalNode *VOID();

   
  };

  ResultTypeContext* resultType();

  class  AnyTypeContext : public GuardedCtx {
  public:
    AnyTypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    FnTypeContext *fnType();
    DimTypeContext *dimType();

   
  };

  AnyTypeContext* anyType();

  class  DimTypeContext : public GuardedCtx {
  public:
    DimTypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<DimFactorContext *> dimFactor();
    DimFactorContext* dimFactor(size_t i);
    std::vector<antlr4::tree::TerminalNode *> STAR();
    antlr4::tree::TerminalNode* STAR(size_t i);
    std::vector<antlr4::tree::TerminalNode *> SLASH();
    antlr4::tree::TerminalNode* SLASH(size_t i);

   
  };

  DimTypeContext* dimType();

  class  DimFactorContext : public GuardedCtx {
  public:
    DimFactorContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    TypeContext *type();
    antlr4::tree::TerminalNode *CARET();
    antlr4::tree::TerminalNode *INT();
    antlr4::tree::TerminalNode *MINUS();
    InParensContext *inParens();
    std::vector<BracketPairContext *> bracketPair();
    BracketPairContext* bracketPair(size_t i);

   
  };

  DimFactorContext* dimFactor();

  class  InParensContext : public GuardedCtx {
  public:
    InParensContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LPAREN();
    AnyTypeContext *anyType();
    antlr4::tree::TerminalNode *RPAREN();

   
  };

  InParensContext* inParens();

  class  TypeNameContext : public GuardedCtx {
  public:
    TypeNameContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<NameContext *> name();
    NameContext* name(size_t i);
    std::vector<antlr4::tree::TerminalNode *> DOT();
    antlr4::tree::TerminalNode* DOT(size_t i);

   
  };

  TypeNameContext* typeName();

  class  PrimTypeContext : public GuardedCtx {
  public:
    PrimTypeContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *INT_T();
    antlr4::tree::TerminalNode *DOUBLE_T();
    antlr4::tree::TerminalNode *BOOL_T();

   
  };

  PrimTypeContext* primType();

  class  IfStmtContext : public GuardedCtx {
  public:
    IfStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *IF();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    std::vector<IfBodyContext *> ifBody();
    IfBodyContext* ifBody(size_t i);
    antlr4::tree::TerminalNode *ELSE();
    IfStmtContext *ifStmt();

   
  };

  IfStmtContext* ifStmt();

  class  IfBodyContext : public GuardedCtx {
  public:
    IfBodyContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    BlockContext *block();
    ClosedStmtContext *closedStmt();

   
  };

  IfBodyContext* ifBody();

  class  WhileStmtContext : public GuardedCtx {
  public:
    WhileStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *WHILE();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    StmtContext *stmt();

   
  };

  WhileStmtContext* whileStmt();

  class  DoStmtContext : public GuardedCtx {
  public:
    DoStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *DO();
    BlockContext *block();
    antlr4::tree::TerminalNode *WHILE();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();

   
  };

  DoStmtContext* doStmt();

  class  ForStmtContext : public GuardedCtx {
  public:
    ForStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *FOR();
    antlr4::tree::TerminalNode *LPAREN();
    ForHeaderContext *forHeader();
    antlr4::tree::TerminalNode *RPAREN();
    StmtContext *stmt();

   
  };

  ForStmtContext* forStmt();

  class  ForHeaderContext : public GuardedCtx {
  public:
    ForHeaderContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<NameContext *> name();
    NameContext* name(size_t i);
    antlr4::tree::TerminalNode *IN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *COMMA();
    TypeContext *type();
    antlr4::tree::TerminalNode *COLON();
    antlr4::tree::TerminalNode *FINAL();
    std::vector<antlr4::tree::TerminalNode *> SEMI();
    antlr4::tree::TerminalNode* SEMI(size_t i);
    ForInitContext *forInit();
    ForUpdateContext *forUpdate();

   
  };

  ForHeaderContext* forHeader();

  class  ForInitContext : public GuardedCtx {
  public:
    ForInitContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    VarDeclContext *varDecl();
    LetDeclContext *letDecl();
    std::vector<ExprStmtContext *> exprStmt();
    ExprStmtContext* exprStmt(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  ForInitContext* forInit();

  class  ForUpdateContext : public GuardedCtx {
  public:
    ForUpdateContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ExprStmtContext *> exprStmt();
    ExprStmtContext* exprStmt(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  ForUpdateContext* forUpdate();

  class  SwitchStmtContext : public GuardedCtx {
  public:
    SwitchStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *SWITCH();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<antlr4::tree::TerminalNode *> SEMI();
    antlr4::tree::TerminalNode* SEMI(size_t i);
    std::vector<SwitchCaseContext *> switchCase();
    SwitchCaseContext* switchCase(size_t i);

   
  };

  SwitchStmtContext* switchStmt();

  class  SwitchCaseContext : public GuardedCtx {
  public:
    SwitchCaseContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *COLON();
    antlr4::tree::TerminalNode *CASE();
    std::vector<ExpressionContext *> expression();
    ExpressionContext* expression(size_t i);
    antlr4::tree::TerminalNode *DEFAULT();
    std::vector<StmtContext *> stmt();
    StmtContext* stmt(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  SwitchCaseContext* switchCase();

  class  TryStmtContext : public GuardedCtx {
  public:
    TryStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *TRY();
    std::vector<BlockContext *> block();
    BlockContext* block(size_t i);
    std::vector<CatchClauseContext *> catchClause();
    CatchClauseContext* catchClause(size_t i);
    antlr4::tree::TerminalNode *FINALLY();

   
  };

  TryStmtContext* tryStmt();

  class  CatchClauseContext : public GuardedCtx {
  public:
    CatchClauseContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *CATCH();
    BlockContext *block();
    antlr4::tree::TerminalNode *LPAREN();
    ParamContext *param();
    antlr4::tree::TerminalNode *RPAREN();

   
  };

  CatchClauseContext* catchClause();

  class  ParallelStmtContext : public GuardedCtx {
  public:
    ParallelStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *PARALLEL();
    BlockContext *block();

   
  };

  ParallelStmtContext* parallelStmt();

  class  WhenStmtContext : public GuardedCtx {
  public:
    WhenStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *WHEN();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    BlockContext *block();

   
  };

  WhenStmtContext* whenStmt();

  class  EveryStmtContext : public GuardedCtx {
  public:
    EveryStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *EVERY();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    BlockContext *block();

   
  };

  EveryStmtContext* everyStmt();

  class  WaitStmtContext : public GuardedCtx {
  public:
    WaitStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *WAIT();
    antlr4::tree::TerminalNode *UNTIL();
    ExprContext *expr();
    ExpressionContext *expression();
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);
    std::vector<ArgContext *> arg();
    ArgContext* arg(size_t i);

   
  };

  WaitStmtContext* waitStmt();

  class  WithStmtContext : public GuardedCtx {
  public:
    WithStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *WITH();
    ArgsContext *args();
    BlockContext *block();

   
  };

  WithStmtContext* withStmt();

  class  PathStmtContext : public GuardedCtx {
  public:
    PathStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *PATH();
    BlockContext *block();
    ArgsContext *args();

   
  };

  PathStmtContext* pathStmt();

  class  RecordStmtContext : public GuardedCtx {
  public:
    RecordStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *RECORD();
    NameContext *name();
    antlr4::tree::TerminalNode *EVERY();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    antlr4::tree::TerminalNode *LBRACE();
    antlr4::tree::TerminalNode *RBRACE();
    std::vector<BlockItemContext *> blockItem();
    BlockItemContext* blockItem(size_t i);

   
  };

  RecordStmtContext* recordStmt();

  class  ExprStmtContext : public GuardedCtx {
  public:
    ExprStmtContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ExpressionContext *> expression();
    ExpressionContext* expression(size_t i);
    AssignTailContext *assignTail();
    CompoundOpContext *compoundOp();
    antlr4::tree::TerminalNode *INC();
    antlr4::tree::TerminalNode *DEC();
    ExprContext *expr();

   
  };

  ExprStmtContext* exprStmt();

  class  AssignTailContext : public GuardedCtx {
  public:
    AssignTailContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<antlr4::tree::TerminalNode *> ASSIGN();
    antlr4::tree::TerminalNode* ASSIGN(size_t i);
    std::vector<ExpressionContext *> expression();
    ExpressionContext* expression(size_t i);
    BraceInitContext *braceInit();

   
  };

  AssignTailContext* assignTail();

  class  CompoundOpContext : public GuardedCtx {
  public:
    CompoundOpContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *PLUSEQ();
    antlr4::tree::TerminalNode *MINUSEQ();
    antlr4::tree::TerminalNode *STAREQ();
    antlr4::tree::TerminalNode *SLASHEQ();
    antlr4::tree::TerminalNode *PERCENTEQ();

   
  };

  CompoundOpContext* compoundOp();

  class  ExpressionContext : public GuardedCtx {
  public:
    ExpressionContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    LambdaContext *lambda();
    NewArrayContext *newArray();
    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *UNTIL();

   
  };

  ExpressionContext* expression();

  class  LambdaContext : public GuardedCtx {
  public:
    LambdaContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *FN();
    antlr4::tree::TerminalNode *LPAREN();
    antlr4::tree::TerminalNode *RPAREN();
    BlockContext *block();
    antlr4::tree::TerminalNode *FATARROW();
    ExpressionContext *expression();
    ParamsContext *params();
    antlr4::tree::TerminalNode *ARROW();
    ResultTypeContext *resultType();

   
  };

  LambdaContext* lambda();

  class  ExprContext : public GuardedCtx {
  public:
    ExprContext(antlr4::ParserRuleContext *parent, size_t invokingState);
   
    ExprContext() = default;
    void copyFrom(ExprContext *context);
    using antlr4::ParserRuleContext::copyFrom;

    virtual size_t getRuleIndex() const override;

   
  };

  class  AndEContext : public ExprContext {
  public:
    AndEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *ANDAND();
  };

  class  OrEContext : public ExprContext {
  public:
    OrEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *OROR();
  };

  class  CondEContext : public ExprContext {
  public:
    CondEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *QMARK();
    antlr4::tree::TerminalNode *COLON();
  };

  class  MemberEContext : public ExprContext {
  public:
    MemberEContext(ExprContext *ctx);

    ExprContext *expr();
    antlr4::tree::TerminalNode *DOT();
    NameContext *name();
  };

  class  CastEContext : public ExprContext {
  public:
    CastEContext(ExprContext *ctx);

    antlr4::tree::TerminalNode *LPAREN();
    PrimTypeContext *primType();
    antlr4::tree::TerminalNode *RPAREN();
    ExprContext *expr();
  };

  class  PrimaryEContext : public ExprContext {
  public:
    PrimaryEContext(ExprContext *ctx);

    PrimaryContext *primary();
  };

  class  CallEContext : public ExprContext {
  public:
    CallEContext(ExprContext *ctx);

    ExprContext *expr();
    ArgsContext *args();
  };

  class  AddEContext : public ExprContext {
  public:
    AddEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *PLUS();
    antlr4::tree::TerminalNode *MINUS();
  };

  class  EpowEContext : public ExprContext {
  public:
    EpowEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *DOTCARET();
  };

  class  MulEContext : public ExprContext {
  public:
    MulEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *STAR();
    antlr4::tree::TerminalNode *SLASH();
    antlr4::tree::TerminalNode *PERCENT();
    antlr4::tree::TerminalNode *BSLASH();
    antlr4::tree::TerminalNode *DOTSTAR();
    antlr4::tree::TerminalNode *DOTSLASH();
  };

  class  UnaryEContext : public ExprContext {
  public:
    UnaryEContext(ExprContext *ctx);

    ExprContext *expr();
    antlr4::tree::TerminalNode *MINUS();
    antlr4::tree::TerminalNode *PLUS();
    antlr4::tree::TerminalNode *NOT();
  };

  class  EqEContext : public ExprContext {
  public:
    EqEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *EQ();
    antlr4::tree::TerminalNode *NE();
  };

  class  PowEContext : public ExprContext {
  public:
    PowEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *CARET();
  };

  class  RelEContext : public ExprContext {
  public:
    RelEContext(ExprContext *ctx);

    std::vector<ExprContext *> expr();
    ExprContext* expr(size_t i);
    antlr4::tree::TerminalNode *LT();
    antlr4::tree::TerminalNode *LE();
    antlr4::tree::TerminalNode *GT();
    antlr4::tree::TerminalNode *GE();
  };

  class  IndexEContext : public ExprContext {
  public:
    IndexEContext(ExprContext *ctx);

    ExprContext *expr();
    antlr4::tree::TerminalNode *LBRACK();
    std::vector<IndexItemContext *> indexItem();
    IndexItemContext* indexItem(size_t i);
    antlr4::tree::TerminalNode *RBRACK();
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);
  };

  ExprContext* expr();
  ExprContext* expr(int precedence);
  class  PrimaryContext : public GuardedCtx {
  public:
    PrimaryContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    LiteralContext *literal();
    NameContext *name();
    PrimTypeContext *primType();
    ArgsContext *args();
    antlr4::tree::TerminalNode *LPAREN();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RPAREN();
    antlr4::tree::TerminalNode *LBRACK();
    antlr4::tree::TerminalNode *RBRACK();
    std::vector<RowContext *> row();
    RowContext* row(size_t i);
    std::vector<antlr4::tree::TerminalNode *> SEMI();
    antlr4::tree::TerminalNode* SEMI(size_t i);
    antlr4::tree::TerminalNode *COLON();
    antlr4::tree::TerminalNode *NEW();
    TypeNameContext *typeName();

   
  };

  PrimaryContext* primary();

  class  RowContext : public GuardedCtx {
  public:
    RowContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ItemContext *> item();
    ItemContext* item(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  RowContext* row();

  class  ItemContext : public GuardedCtx {
  public:
    ItemContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ExpressionContext *> expression();
    ExpressionContext* expression(size_t i);
    antlr4::tree::TerminalNode *COLON();

   
  };

  ItemContext* item();

  class  NewArrayContext : public GuardedCtx {
  public:
    NewArrayContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *NEW();
    PrimTypeContext *primType();
    TypeNameContext *typeName();
    BraceInitContext *braceInit();
    std::vector<NewDimContext *> newDim();
    NewDimContext* newDim(size_t i);
    std::vector<antlr4::tree::TerminalNode *> LBRACK();
    antlr4::tree::TerminalNode* LBRACK(size_t i);
    std::vector<antlr4::tree::TerminalNode *> RBRACK();
    antlr4::tree::TerminalNode* RBRACK(size_t i);

   
  };

  NewArrayContext* newArray();

  class  NewDimContext : public GuardedCtx {
  public:
    NewDimContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LBRACK();
    ExpressionContext *expression();
    antlr4::tree::TerminalNode *RBRACK();

   
  };

  NewDimContext* newDim();

  class  IndexItemContext : public GuardedCtx {
  public:
    IndexItemContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    std::vector<ExpressionContext *> expression();
    ExpressionContext* expression(size_t i);
    antlr4::tree::TerminalNode *COLON();

   
  };

  IndexItemContext* indexItem();

  class  ArgsContext : public GuardedCtx {
  public:
    ArgsContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *LPAREN();
    antlr4::tree::TerminalNode *RPAREN();
    std::vector<ArgContext *> arg();
    ArgContext* arg(size_t i);
    std::vector<antlr4::tree::TerminalNode *> COMMA();
    antlr4::tree::TerminalNode* COMMA(size_t i);

   
  };

  ArgsContext* args();

  class  ArgContext : public GuardedCtx {
  public:
    ArgContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    ExpressionContext *expression();
    NameContext *name();
    antlr4::tree::TerminalNode *COLON();

   
  };

  ArgContext* arg();

  class  LiteralContext : public GuardedCtx {
  public:
    LiteralContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *INT();
    antlr4::tree::TerminalNode *FLOAT();
    antlr4::tree::TerminalNode *QUANTITY();
    antlr4::tree::TerminalNode *STRING();
    antlr4::tree::TerminalNode *FSTRING();
    antlr4::tree::TerminalNode *TRUE();
    antlr4::tree::TerminalNode *FALSE();

   
  };

  LiteralContext* literal();

  class  NameContext : public GuardedCtx {
  public:
    NameContext(antlr4::ParserRuleContext *parent, size_t invokingState);
    virtual size_t getRuleIndex() const override;
    antlr4::tree::TerminalNode *ID();
    antlr4::tree::TerminalNode *TEST();
    antlr4::tree::TerminalNode *RECORD();
    antlr4::tree::TerminalNode *PATH();
    antlr4::tree::TerminalNode *AS();

   
  };

  NameContext* name();


  virtual bool sempred(antlr4::RuleContext *_localctx, size_t ruleIndex, size_t predicateIndex) override;
  bool exprSempred(ExprContext *_localctx, size_t predicateIndex);

private:
  static std::vector<antlr4::dfa::DFA> _decisionToDFA;
  static antlr4::atn::PredictionContextCache _sharedContextCache;
  static std::vector<std::string> _ruleNames;
  static std::vector<std::string> _tokenNames;

  static std::vector<std::string> _literalNames;
  static std::vector<std::string> _symbolicNames;
  static antlr4::dfa::Vocabulary _vocabulary;
  static antlr4::atn::ATN _atn;
  static std::vector<uint16_t> _serializedATN;


  struct Initializer {
    Initializer();
  };
  
public:
  static void prepare();  // reads the tables
};

