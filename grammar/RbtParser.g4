// The syntax of the .rbt language (docs/language.md, section 4).
//
// The grammar has no ambiguities: a test parses random sentences with ANTLR's exact ambiguity detection. grammar/README.md
// lists the pitfalls that determined its form. Contexts have their depth of nesting (guarded_parser.hpp), because the
// generated parser is recursive and its stack is limited.
parser grammar RbtParser;

options {
  language = Cpp;
  tokenVocab = RbtLexer;
  superClass = GuardedParser;
  contextSuperClass = GuardedCtx;
}

@postinclude {
#include "guarded_parser.hpp"
}

@members {
  // What a reader would call one level of nesting.
  bool opensLevel(size_t rule) const override {
    return rule == RuleStmt || rule == RuleIfStmt || rule == RuleExpr || rule == RuleLambda || rule == RuleInitializer ||
           rule == RuleAnyType;
  }
}

// ---------------------------------------------------------------- program

// let h = 20mm; moveJ(home, time: 2s);
program : stmt* EOF ;

// double x = 1.0;
stmt
  : block
  | SEMI
  | letDecl SEMI
  | varDecl SEMI
  | blockDecl
  | fnDecl
  | structDecl
  | enumDecl
  | importDecl SEMI
  | testDecl
  | ifStmt
  | whileStmt
  | doStmt SEMI
  | forStmt
  | switchStmt
  | tryStmt
  | parallelStmt
  | whenStmt
  | everyStmt
  | withStmt
  | pathStmt
  | recordStmt
  | closedStmt
  ;

// return p.corner;      (the statements that may be an `if` body without braces, so that each `else` has one `if`)
closedStmt
  : exprStmt SEMI
  | waitStmt SEMI
  | BREAK SEMI
  | CONTINUE SEMI
  | RETRY SEMI
  | RETURN expression? SEMI
  | THROW expression SEMI
  ;

// { print(1); print(2); }
block : LBRACE stmt* RBRACE ;

// ---------------------------------------------------------------- declarations

// let h: length = 20mm
letDecl : (LET | VAR) name (COLON anyType)? (ASSIGN initializer)? ;

// final double[] q = {0.0, 0.5}, r
varDecl : FINAL? type declarator (COMMA declarator)* ;

// q[] = {0.0, 0.5}
declarator : name (LBRACK RBRACK)* (ASSIGN initializer)? ;

// {1.0, 2.0}
initializer : expression | braceInit ;

// {{1, 2}, {3, 4}}
braceInit : LBRACE (braceItem (COMMA braceItem)* COMMA?)? RBRACE ;

// "bolt": 3
braceItem : initializer (COLON initializer)? ;

// object cube { shape: box(40mm, 40mm, 40mm); mass: 200g }
blockDecl : typeName name LBRACE blockItem* RBRACE ;

// joint revolute(d: 400mm);
blockItem
  : name COLON expression (SEMI | COMMA)
  | name name args SEMI
  | SEMI
  ;

// fn area(w: length, h: length = 1m) -> area { return w * h; }
fnDecl
  : FN name LPAREN params? RPAREN (ARROW resultType)? fnBody
  | (type | VOID) name LPAREN params? RPAREN block
  ;

// => w * h;
fnBody : block | FATARROW expression SEMI ;

// w: length, h = 2
params : param (COMMA param)* COMMA? ;

// final double[] q
param
  : name (COLON anyType)? (ASSIGN expression)?
  | FINAL? type name (LBRACK RBRACK)*
  ;

// struct Pallet { corner: posC; rows: int = 1 }
structDecl : STRUCT name LBRACE (param (SEMI | COMMA) | SEMI)* RBRACE ;

// enum State { Idle, Done }
enumDecl : ENUM name LBRACE name ((COMMA | SEMI) name)* (COMMA | SEMI)* RBRACE ;

// import "grip.rbt" as g
importDecl : IMPORT (STRING | typeName) (AS name)? ;

// test "the cube was lifted" { assert(true); }
testDecl : TEST STRING block ;

// ---------------------------------------------------------------- types

// pal.Pallet[]
type : (primType | typeName) bracketPair* ;

// [string]
bracketPair : LBRACK (primType | typeName)? RBRACK ;

// fn(double, double[]) -> double[]
fnType : FN LPAREN (anyType (COMMA anyType)*)? RPAREN ARROW resultType ;

// void
resultType : anyType | VOID ;

// fn(double) -> double
anyType : fnType | dimType ;

// force/length
dimType : dimFactor ((STAR | SLASH) dimFactor)* ;

// time^-2
dimFactor : type (CARET MINUS? INT)? | inParens bracketPair* ;

// (fn(int) -> int)
inParens : LPAREN anyType RPAREN ;

// pal.Pallet
typeName : name (DOT name)* ;

// double
primType : INT_T | DOUBLE_T | BOOL_T ;

// ---------------------------------------------------------------- control flow

// if (d > 45mm) grasp(cube); else { release(); }
ifStmt : IF LPAREN expression RPAREN ifBody (ELSE (ifStmt | ifBody))? ;

// { release(); }
ifBody : block | closedStmt ;

// while (i < 3) i++;
whileStmt : WHILE LPAREN expression RPAREN stmt ;

// do { i++; } while (i < 3)
doStmt : DO block WHILE LPAREN expression RPAREN ;

// for (x in xs) print(x);
forStmt : FOR LPAREN forHeader RPAREN stmt ;

// x in xs    (i, x in xs    int i = 0; i < n; i++)
forHeader
  : name (COMMA name)? IN expression
  | FINAL? type name COLON expression
  | forInit? SEMI expression? SEMI forUpdate?
  ;

// int i = 0
forInit : varDecl | letDecl | exprStmt (COMMA exprStmt)* ;

// i++, j--
forUpdate : exprStmt (COMMA exprStmt)* ;

// switch (state) { case State.Idle: start(); default: stop(); }
switchStmt : SWITCH LPAREN expression RPAREN LBRACE SEMI* switchCase* RBRACE ;

// case 1, 2: print("few");
switchCase : (CASE expression (COMMA expression)* | DEFAULT) COLON stmt* ;

// try { moveL(p); } catch (e) { print(e.message); } finally { release(); }
tryStmt : TRY block catchClause* (FINALLY block)? ;

// catch (e) { throw e; }
catchClause : CATCH (LPAREN param RPAREN)? block ;

// ---------------------------------------------------------------- robot control flow

// parallel { left.moveJ(a); right.moveJ(b); }
parallelStmt : PARALLEL block ;

// when (arm.force().z > 40N) { halt(); }
whenStmt : WHEN LPAREN expression RPAREN block ;

// every (10ms) { count += 1; }
everyStmt : EVERY LPAREN expression RPAREN block ;

// wait until holding(), timeout: 10s
waitStmt : WAIT (UNTIL expr (COMMA arg)* | expression) ;

// with (robot: left, speed: 0.5) { moveJ(home); }
withStmt : WITH args block ;

// path (blend: 30mm) { moveL(a); moveL(b); }
pathStmt : PATH args? block ;

// record run every (10ms) { q: joints().q; }
recordStmt : RECORD name EVERY LPAREN expression RPAREN LBRACE blockItem* RBRACE ;

// ---------------------------------------------------------------- expressions

// x += 2
exprStmt : expression (assignTail | compoundOp expression | INC | DEC)? | (INC | DEC) expr ;

// = y = 0
assignTail : (ASSIGN expression)+ (ASSIGN braceInit)? | ASSIGN braceInit ;

// +=
compoundOp : PLUSEQ | MINUSEQ | STAREQ | SLASHEQ | PERCENTEQ ;

// arm.moveL(p, speed: 20mm/s) until arm.force().z > 5N
expression : lambda | newArray | expr (UNTIL expr)? ;

// fn(x) => x ^ 2
lambda : FN LPAREN params? RPAREN (ARROW resultType)? (block | FATARROW expression) ;

// -x ^ 2 + f(a, b: 1)[0].y
expr
  : primary                                                            # primaryE
  | expr DOT name                                                      # memberE
  | expr LBRACK indexItem (COMMA indexItem)* RBRACK                    # indexE
  | expr args                                                          # callE
  | <assoc = right> expr CARET expr                                    # powE
  | expr DOTCARET expr                                                 # epowE
  | (MINUS | PLUS | NOT) expr                                          # unaryE
  | LPAREN primType RPAREN expr                                        # castE
  | expr (STAR | SLASH | PERCENT | BSLASH | DOTSTAR | DOTSLASH) expr   # mulE
  | expr (PLUS | MINUS) expr                                           # addE
  | expr (LT | LE | GT | GE) expr                                      # relE
  | expr (EQ | NE) expr                                                # eqE
  | expr ANDAND expr                                                   # andE
  | expr OROR expr                                                     # orE
  | <assoc = right> expr QMARK expr COLON expr                         # condE
  ;

// [1, 2; 3, 4]
primary
  : literal
  | name
  | primType args
  | LPAREN expression RPAREN
  | LBRACK (row (SEMI row)* SEMI?)? RBRACK
  | LBRACK COLON RBRACK
  | NEW typeName args
  ;

// 1, 2,
row : item (COMMA item)* COMMA? ;

// "bolt": 3
item : expression (COLON expression)? ;

// new double[3][4]
newArray : NEW (primType | typeName) (newDim+ (LBRACK RBRACK)* | (LBRACK RBRACK)+ braceInit) ;

// [3]
newDim : LBRACK expression RBRACK ;

// 1:4
indexItem : expression (COLON expression?)? | COLON expression? ;

// (p, speed: 80mm/s)
args : LPAREN (arg (COMMA arg)* COMMA?)? RPAREN ;

// speed: 80mm/s
arg : (name COLON)? expression ;

// 250mm
literal : INT | FLOAT | QUANTITY | STRING | FSTRING | TRUE | FALSE ;

// record      (soft words are names too)
name : ID | TEST | RECORD | PATH | AS ;
