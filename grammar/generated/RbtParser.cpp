
// Generated from RbtParser.g4 by ANTLR 4.7.2



#include "RbtParser.h"
#include "table_reader.hpp"


#include "guarded_parser.hpp"


using namespace antlrcpp;
using namespace antlr4;

RbtParser::RbtParser(TokenStream *input) : GuardedParser(input) {
  _interpreter = new atn::ParserATNSimulator(this, _atn, _decisionToDFA, _sharedContextCache);
}

RbtParser::~RbtParser() {
  delete _interpreter;
}

std::string RbtParser::getGrammarFileName() const {
  return "RbtParser.g4";
}

const std::vector<std::string>& RbtParser::getRuleNames() const {
  return _ruleNames;
}

dfa::Vocabulary& RbtParser::getVocabulary() const {
  return _vocabulary;
}


//----------------- ProgramContext ------------------------------------------------------------------

RbtParser::ProgramContext::ProgramContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::ProgramContext::EOF() {
  return getToken(RbtParser::EOF, 0);
}

std::vector<RbtParser::StmtContext *> RbtParser::ProgramContext::stmt() {
  return getRuleContexts<RbtParser::StmtContext>();
}

RbtParser::StmtContext* RbtParser::ProgramContext::stmt(size_t i) {
  return getRuleContext<RbtParser::StmtContext>(i);
}


size_t RbtParser::ProgramContext::getRuleIndex() const {
  return RbtParser::RuleProgram;
}


RbtParser::ProgramContext* RbtParser::program() {
  ProgramContext *_localctx = _tracker.createInstance<ProgramContext>(_ctx, getState());
  enterRule(_localctx, 0, RbtParser::RuleProgram);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(127);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::LET)
      | (1ULL << RbtParser::VAR)
      | (1ULL << RbtParser::FN)
      | (1ULL << RbtParser::STRUCT)
      | (1ULL << RbtParser::ENUM)
      | (1ULL << RbtParser::IMPORT)
      | (1ULL << RbtParser::FINAL)
      | (1ULL << RbtParser::VOID)
      | (1ULL << RbtParser::NEW)
      | (1ULL << RbtParser::IF)
      | (1ULL << RbtParser::WHILE)
      | (1ULL << RbtParser::DO)
      | (1ULL << RbtParser::FOR)
      | (1ULL << RbtParser::SWITCH)
      | (1ULL << RbtParser::BREAK)
      | (1ULL << RbtParser::CONTINUE)
      | (1ULL << RbtParser::RETURN)
      | (1ULL << RbtParser::TRY)
      | (1ULL << RbtParser::THROW)
      | (1ULL << RbtParser::RETRY)
      | (1ULL << RbtParser::PARALLEL)
      | (1ULL << RbtParser::WHEN)
      | (1ULL << RbtParser::EVERY)
      | (1ULL << RbtParser::WAIT)
      | (1ULL << RbtParser::WITH)
      | (1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LBRACE)
      | (1ULL << RbtParser::LPAREN)
      | (1ULL << RbtParser::LBRACK)
      | (1ULL << RbtParser::SEMI))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
      | (1ULL << (RbtParser::INC - 71))
      | (1ULL << (RbtParser::DEC - 71))
      | (1ULL << (RbtParser::PLUS - 71))
      | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
      setState(124);
      stmt();
      setState(129);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(130);
    match(RbtParser::EOF);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- StmtContext ------------------------------------------------------------------

RbtParser::StmtContext::StmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::BlockContext* RbtParser::StmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

tree::TerminalNode* RbtParser::StmtContext::SEMI() {
  return getToken(RbtParser::SEMI, 0);
}

RbtParser::LetDeclContext* RbtParser::StmtContext::letDecl() {
  return getRuleContext<RbtParser::LetDeclContext>(0);
}

RbtParser::VarDeclContext* RbtParser::StmtContext::varDecl() {
  return getRuleContext<RbtParser::VarDeclContext>(0);
}

RbtParser::BlockDeclContext* RbtParser::StmtContext::blockDecl() {
  return getRuleContext<RbtParser::BlockDeclContext>(0);
}

RbtParser::FnDeclContext* RbtParser::StmtContext::fnDecl() {
  return getRuleContext<RbtParser::FnDeclContext>(0);
}

RbtParser::StructDeclContext* RbtParser::StmtContext::structDecl() {
  return getRuleContext<RbtParser::StructDeclContext>(0);
}

RbtParser::EnumDeclContext* RbtParser::StmtContext::enumDecl() {
  return getRuleContext<RbtParser::EnumDeclContext>(0);
}

RbtParser::ImportDeclContext* RbtParser::StmtContext::importDecl() {
  return getRuleContext<RbtParser::ImportDeclContext>(0);
}

RbtParser::TestDeclContext* RbtParser::StmtContext::testDecl() {
  return getRuleContext<RbtParser::TestDeclContext>(0);
}

RbtParser::IfStmtContext* RbtParser::StmtContext::ifStmt() {
  return getRuleContext<RbtParser::IfStmtContext>(0);
}

RbtParser::WhileStmtContext* RbtParser::StmtContext::whileStmt() {
  return getRuleContext<RbtParser::WhileStmtContext>(0);
}

RbtParser::DoStmtContext* RbtParser::StmtContext::doStmt() {
  return getRuleContext<RbtParser::DoStmtContext>(0);
}

RbtParser::ForStmtContext* RbtParser::StmtContext::forStmt() {
  return getRuleContext<RbtParser::ForStmtContext>(0);
}

RbtParser::SwitchStmtContext* RbtParser::StmtContext::switchStmt() {
  return getRuleContext<RbtParser::SwitchStmtContext>(0);
}

RbtParser::TryStmtContext* RbtParser::StmtContext::tryStmt() {
  return getRuleContext<RbtParser::TryStmtContext>(0);
}

RbtParser::ParallelStmtContext* RbtParser::StmtContext::parallelStmt() {
  return getRuleContext<RbtParser::ParallelStmtContext>(0);
}

RbtParser::WhenStmtContext* RbtParser::StmtContext::whenStmt() {
  return getRuleContext<RbtParser::WhenStmtContext>(0);
}

RbtParser::EveryStmtContext* RbtParser::StmtContext::everyStmt() {
  return getRuleContext<RbtParser::EveryStmtContext>(0);
}

RbtParser::WithStmtContext* RbtParser::StmtContext::withStmt() {
  return getRuleContext<RbtParser::WithStmtContext>(0);
}

RbtParser::PathStmtContext* RbtParser::StmtContext::pathStmt() {
  return getRuleContext<RbtParser::PathStmtContext>(0);
}

RbtParser::RecordStmtContext* RbtParser::StmtContext::recordStmt() {
  return getRuleContext<RbtParser::RecordStmtContext>(0);
}

RbtParser::ClosedStmtContext* RbtParser::StmtContext::closedStmt() {
  return getRuleContext<RbtParser::ClosedStmtContext>(0);
}


size_t RbtParser::StmtContext::getRuleIndex() const {
  return RbtParser::RuleStmt;
}


RbtParser::StmtContext* RbtParser::stmt() {
  StmtContext *_localctx = _tracker.createInstance<StmtContext>(_ctx, getState());
  enterRule(_localctx, 2, RbtParser::RuleStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(163);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 1, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(132);
      block();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(133);
      match(RbtParser::SEMI);
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(134);
      letDecl();
      setState(135);
      match(RbtParser::SEMI);
      break;
    }

    case 4: {
      enterOuterAlt(_localctx, 4);
      setState(137);
      varDecl();
      setState(138);
      match(RbtParser::SEMI);
      break;
    }

    case 5: {
      enterOuterAlt(_localctx, 5);
      setState(140);
      blockDecl();
      break;
    }

    case 6: {
      enterOuterAlt(_localctx, 6);
      setState(141);
      fnDecl();
      break;
    }

    case 7: {
      enterOuterAlt(_localctx, 7);
      setState(142);
      structDecl();
      break;
    }

    case 8: {
      enterOuterAlt(_localctx, 8);
      setState(143);
      enumDecl();
      break;
    }

    case 9: {
      enterOuterAlt(_localctx, 9);
      setState(144);
      importDecl();
      setState(145);
      match(RbtParser::SEMI);
      break;
    }

    case 10: {
      enterOuterAlt(_localctx, 10);
      setState(147);
      testDecl();
      break;
    }

    case 11: {
      enterOuterAlt(_localctx, 11);
      setState(148);
      ifStmt();
      break;
    }

    case 12: {
      enterOuterAlt(_localctx, 12);
      setState(149);
      whileStmt();
      break;
    }

    case 13: {
      enterOuterAlt(_localctx, 13);
      setState(150);
      doStmt();
      setState(151);
      match(RbtParser::SEMI);
      break;
    }

    case 14: {
      enterOuterAlt(_localctx, 14);
      setState(153);
      forStmt();
      break;
    }

    case 15: {
      enterOuterAlt(_localctx, 15);
      setState(154);
      switchStmt();
      break;
    }

    case 16: {
      enterOuterAlt(_localctx, 16);
      setState(155);
      tryStmt();
      break;
    }

    case 17: {
      enterOuterAlt(_localctx, 17);
      setState(156);
      parallelStmt();
      break;
    }

    case 18: {
      enterOuterAlt(_localctx, 18);
      setState(157);
      whenStmt();
      break;
    }

    case 19: {
      enterOuterAlt(_localctx, 19);
      setState(158);
      everyStmt();
      break;
    }

    case 20: {
      enterOuterAlt(_localctx, 20);
      setState(159);
      withStmt();
      break;
    }

    case 21: {
      enterOuterAlt(_localctx, 21);
      setState(160);
      pathStmt();
      break;
    }

    case 22: {
      enterOuterAlt(_localctx, 22);
      setState(161);
      recordStmt();
      break;
    }

    case 23: {
      enterOuterAlt(_localctx, 23);
      setState(162);
      closedStmt();
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ClosedStmtContext ------------------------------------------------------------------

RbtParser::ClosedStmtContext::ClosedStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::ExprStmtContext* RbtParser::ClosedStmtContext::exprStmt() {
  return getRuleContext<RbtParser::ExprStmtContext>(0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::SEMI() {
  return getToken(RbtParser::SEMI, 0);
}

RbtParser::WaitStmtContext* RbtParser::ClosedStmtContext::waitStmt() {
  return getRuleContext<RbtParser::WaitStmtContext>(0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::BREAK() {
  return getToken(RbtParser::BREAK, 0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::CONTINUE() {
  return getToken(RbtParser::CONTINUE, 0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::RETRY() {
  return getToken(RbtParser::RETRY, 0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::RETURN() {
  return getToken(RbtParser::RETURN, 0);
}

RbtParser::ExpressionContext* RbtParser::ClosedStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::ClosedStmtContext::THROW() {
  return getToken(RbtParser::THROW, 0);
}


size_t RbtParser::ClosedStmtContext::getRuleIndex() const {
  return RbtParser::RuleClosedStmt;
}


RbtParser::ClosedStmtContext* RbtParser::closedStmt() {
  ClosedStmtContext *_localctx = _tracker.createInstance<ClosedStmtContext>(_ctx, getState());
  enterRule(_localctx, 4, RbtParser::RuleClosedStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(186);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::INC:
      case RbtParser::DEC:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        enterOuterAlt(_localctx, 1);
        setState(165);
        exprStmt();
        setState(166);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::WAIT: {
        enterOuterAlt(_localctx, 2);
        setState(168);
        waitStmt();
        setState(169);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::BREAK: {
        enterOuterAlt(_localctx, 3);
        setState(171);
        match(RbtParser::BREAK);
        setState(172);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::CONTINUE: {
        enterOuterAlt(_localctx, 4);
        setState(173);
        match(RbtParser::CONTINUE);
        setState(174);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::RETRY: {
        enterOuterAlt(_localctx, 5);
        setState(175);
        match(RbtParser::RETRY);
        setState(176);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::RETURN: {
        enterOuterAlt(_localctx, 6);
        setState(177);
        match(RbtParser::RETURN);
        setState(179);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if ((((_la & ~ 0x3fULL) == 0) &&
          ((1ULL << _la) & ((1ULL << RbtParser::FN)
          | (1ULL << RbtParser::NEW)
          | (1ULL << RbtParser::TRUE)
          | (1ULL << RbtParser::FALSE)
          | (1ULL << RbtParser::INT_T)
          | (1ULL << RbtParser::DOUBLE_T)
          | (1ULL << RbtParser::BOOL_T)
          | (1ULL << RbtParser::TEST)
          | (1ULL << RbtParser::RECORD)
          | (1ULL << RbtParser::PATH)
          | (1ULL << RbtParser::AS)
          | (1ULL << RbtParser::QUANTITY)
          | (1ULL << RbtParser::FLOAT)
          | (1ULL << RbtParser::INT)
          | (1ULL << RbtParser::FSTRING)
          | (1ULL << RbtParser::STRING)
          | (1ULL << RbtParser::ID)
          | (1ULL << RbtParser::LPAREN)
          | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
          ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
          | (1ULL << (RbtParser::PLUS - 71))
          | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
          setState(178);
          expression();
        }
        setState(181);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::THROW: {
        enterOuterAlt(_localctx, 7);
        setState(182);
        match(RbtParser::THROW);
        setState(183);
        expression();
        setState(184);
        match(RbtParser::SEMI);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- BlockContext ------------------------------------------------------------------

RbtParser::BlockContext::BlockContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::BlockContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::BlockContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<RbtParser::StmtContext *> RbtParser::BlockContext::stmt() {
  return getRuleContexts<RbtParser::StmtContext>();
}

RbtParser::StmtContext* RbtParser::BlockContext::stmt(size_t i) {
  return getRuleContext<RbtParser::StmtContext>(i);
}


size_t RbtParser::BlockContext::getRuleIndex() const {
  return RbtParser::RuleBlock;
}


RbtParser::BlockContext* RbtParser::block() {
  BlockContext *_localctx = _tracker.createInstance<BlockContext>(_ctx, getState());
  enterRule(_localctx, 6, RbtParser::RuleBlock);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(188);
    match(RbtParser::LBRACE);
    setState(192);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::LET)
      | (1ULL << RbtParser::VAR)
      | (1ULL << RbtParser::FN)
      | (1ULL << RbtParser::STRUCT)
      | (1ULL << RbtParser::ENUM)
      | (1ULL << RbtParser::IMPORT)
      | (1ULL << RbtParser::FINAL)
      | (1ULL << RbtParser::VOID)
      | (1ULL << RbtParser::NEW)
      | (1ULL << RbtParser::IF)
      | (1ULL << RbtParser::WHILE)
      | (1ULL << RbtParser::DO)
      | (1ULL << RbtParser::FOR)
      | (1ULL << RbtParser::SWITCH)
      | (1ULL << RbtParser::BREAK)
      | (1ULL << RbtParser::CONTINUE)
      | (1ULL << RbtParser::RETURN)
      | (1ULL << RbtParser::TRY)
      | (1ULL << RbtParser::THROW)
      | (1ULL << RbtParser::RETRY)
      | (1ULL << RbtParser::PARALLEL)
      | (1ULL << RbtParser::WHEN)
      | (1ULL << RbtParser::EVERY)
      | (1ULL << RbtParser::WAIT)
      | (1ULL << RbtParser::WITH)
      | (1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LBRACE)
      | (1ULL << RbtParser::LPAREN)
      | (1ULL << RbtParser::LBRACK)
      | (1ULL << RbtParser::SEMI))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
      | (1ULL << (RbtParser::INC - 71))
      | (1ULL << (RbtParser::DEC - 71))
      | (1ULL << (RbtParser::PLUS - 71))
      | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
      setState(189);
      stmt();
      setState(194);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(195);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- LetDeclContext ------------------------------------------------------------------

RbtParser::LetDeclContext::LetDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::NameContext* RbtParser::LetDeclContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::LetDeclContext::LET() {
  return getToken(RbtParser::LET, 0);
}

tree::TerminalNode* RbtParser::LetDeclContext::VAR() {
  return getToken(RbtParser::VAR, 0);
}

tree::TerminalNode* RbtParser::LetDeclContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

RbtParser::AnyTypeContext* RbtParser::LetDeclContext::anyType() {
  return getRuleContext<RbtParser::AnyTypeContext>(0);
}

tree::TerminalNode* RbtParser::LetDeclContext::ASSIGN() {
  return getToken(RbtParser::ASSIGN, 0);
}

RbtParser::InitializerContext* RbtParser::LetDeclContext::initializer() {
  return getRuleContext<RbtParser::InitializerContext>(0);
}


size_t RbtParser::LetDeclContext::getRuleIndex() const {
  return RbtParser::RuleLetDecl;
}


RbtParser::LetDeclContext* RbtParser::letDecl() {
  LetDeclContext *_localctx = _tracker.createInstance<LetDeclContext>(_ctx, getState());
  enterRule(_localctx, 8, RbtParser::RuleLetDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(197);
    _la = _input->LA(1);
    if (!(_la == RbtParser::LET

    || _la == RbtParser::VAR)) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
    setState(198);
    name();
    setState(201);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COLON) {
      setState(199);
      match(RbtParser::COLON);
      setState(200);
      anyType();
    }
    setState(205);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ASSIGN) {
      setState(203);
      match(RbtParser::ASSIGN);
      setState(204);
      initializer();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- VarDeclContext ------------------------------------------------------------------

RbtParser::VarDeclContext::VarDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::TypeContext* RbtParser::VarDeclContext::type() {
  return getRuleContext<RbtParser::TypeContext>(0);
}

std::vector<RbtParser::DeclaratorContext *> RbtParser::VarDeclContext::declarator() {
  return getRuleContexts<RbtParser::DeclaratorContext>();
}

RbtParser::DeclaratorContext* RbtParser::VarDeclContext::declarator(size_t i) {
  return getRuleContext<RbtParser::DeclaratorContext>(i);
}

tree::TerminalNode* RbtParser::VarDeclContext::FINAL() {
  return getToken(RbtParser::FINAL, 0);
}

std::vector<tree::TerminalNode *> RbtParser::VarDeclContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::VarDeclContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::VarDeclContext::getRuleIndex() const {
  return RbtParser::RuleVarDecl;
}


RbtParser::VarDeclContext* RbtParser::varDecl() {
  VarDeclContext *_localctx = _tracker.createInstance<VarDeclContext>(_ctx, getState());
  enterRule(_localctx, 10, RbtParser::RuleVarDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(208);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::FINAL) {
      setState(207);
      match(RbtParser::FINAL);
    }
    setState(210);
    type();
    setState(211);
    declarator();
    setState(216);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::COMMA) {
      setState(212);
      match(RbtParser::COMMA);
      setState(213);
      declarator();
      setState(218);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- DeclaratorContext ------------------------------------------------------------------

RbtParser::DeclaratorContext::DeclaratorContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::NameContext* RbtParser::DeclaratorContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

std::vector<tree::TerminalNode *> RbtParser::DeclaratorContext::LBRACK() {
  return getTokens(RbtParser::LBRACK);
}

tree::TerminalNode* RbtParser::DeclaratorContext::LBRACK(size_t i) {
  return getToken(RbtParser::LBRACK, i);
}

std::vector<tree::TerminalNode *> RbtParser::DeclaratorContext::RBRACK() {
  return getTokens(RbtParser::RBRACK);
}

tree::TerminalNode* RbtParser::DeclaratorContext::RBRACK(size_t i) {
  return getToken(RbtParser::RBRACK, i);
}

tree::TerminalNode* RbtParser::DeclaratorContext::ASSIGN() {
  return getToken(RbtParser::ASSIGN, 0);
}

RbtParser::InitializerContext* RbtParser::DeclaratorContext::initializer() {
  return getRuleContext<RbtParser::InitializerContext>(0);
}


size_t RbtParser::DeclaratorContext::getRuleIndex() const {
  return RbtParser::RuleDeclarator;
}


RbtParser::DeclaratorContext* RbtParser::declarator() {
  DeclaratorContext *_localctx = _tracker.createInstance<DeclaratorContext>(_ctx, getState());
  enterRule(_localctx, 12, RbtParser::RuleDeclarator);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(219);
    name();
    setState(224);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::LBRACK) {
      setState(220);
      match(RbtParser::LBRACK);
      setState(221);
      match(RbtParser::RBRACK);
      setState(226);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(229);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ASSIGN) {
      setState(227);
      match(RbtParser::ASSIGN);
      setState(228);
      initializer();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- InitializerContext ------------------------------------------------------------------

RbtParser::InitializerContext::InitializerContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::ExpressionContext* RbtParser::InitializerContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

RbtParser::BraceInitContext* RbtParser::InitializerContext::braceInit() {
  return getRuleContext<RbtParser::BraceInitContext>(0);
}


size_t RbtParser::InitializerContext::getRuleIndex() const {
  return RbtParser::RuleInitializer;
}


RbtParser::InitializerContext* RbtParser::initializer() {
  InitializerContext *_localctx = _tracker.createInstance<InitializerContext>(_ctx, getState());
  enterRule(_localctx, 14, RbtParser::RuleInitializer);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(233);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        enterOuterAlt(_localctx, 1);
        setState(231);
        expression();
        break;
      }

      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 2);
        setState(232);
        braceInit();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- BraceInitContext ------------------------------------------------------------------

RbtParser::BraceInitContext::BraceInitContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::BraceInitContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::BraceInitContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<RbtParser::InitializerContext *> RbtParser::BraceInitContext::initializer() {
  return getRuleContexts<RbtParser::InitializerContext>();
}

RbtParser::InitializerContext* RbtParser::BraceInitContext::initializer(size_t i) {
  return getRuleContext<RbtParser::InitializerContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::BraceInitContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::BraceInitContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::BraceInitContext::getRuleIndex() const {
  return RbtParser::RuleBraceInit;
}


RbtParser::BraceInitContext* RbtParser::braceInit() {
  BraceInitContext *_localctx = _tracker.createInstance<BraceInitContext>(_ctx, getState());
  enterRule(_localctx, 16, RbtParser::RuleBraceInit);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(235);
    match(RbtParser::LBRACE);
    setState(247);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::FN)
      | (1ULL << RbtParser::NEW)
      | (1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LBRACE)
      | (1ULL << RbtParser::LPAREN)
      | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
      | (1ULL << (RbtParser::PLUS - 71))
      | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
      setState(236);
      initializer();
      setState(241);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 12, _ctx);
      while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
        if (alt == 1) {
          setState(237);
          match(RbtParser::COMMA);
          setState(238);
          initializer(); 
        }
        setState(243);
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 12, _ctx);
      }
      setState(245);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(244);
        match(RbtParser::COMMA);
      }
    }
    setState(249);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- BlockDeclContext ------------------------------------------------------------------

RbtParser::BlockDeclContext::BlockDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::TypeNameContext* RbtParser::BlockDeclContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}

RbtParser::NameContext* RbtParser::BlockDeclContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::BlockDeclContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::BlockDeclContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<RbtParser::BlockItemContext *> RbtParser::BlockDeclContext::blockItem() {
  return getRuleContexts<RbtParser::BlockItemContext>();
}

RbtParser::BlockItemContext* RbtParser::BlockDeclContext::blockItem(size_t i) {
  return getRuleContext<RbtParser::BlockItemContext>(i);
}


size_t RbtParser::BlockDeclContext::getRuleIndex() const {
  return RbtParser::RuleBlockDecl;
}


RbtParser::BlockDeclContext* RbtParser::blockDecl() {
  BlockDeclContext *_localctx = _tracker.createInstance<BlockDeclContext>(_ctx, getState());
  enterRule(_localctx, 18, RbtParser::RuleBlockDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(251);
    typeName();
    setState(252);
    name();
    setState(253);
    match(RbtParser::LBRACE);
    setState(257);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::SEMI))) != 0)) {
      setState(254);
      blockItem();
      setState(259);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(260);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- BlockItemContext ------------------------------------------------------------------

RbtParser::BlockItemContext::BlockItemContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::NameContext *> RbtParser::BlockItemContext::name() {
  return getRuleContexts<RbtParser::NameContext>();
}

RbtParser::NameContext* RbtParser::BlockItemContext::name(size_t i) {
  return getRuleContext<RbtParser::NameContext>(i);
}

tree::TerminalNode* RbtParser::BlockItemContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

RbtParser::ExpressionContext* RbtParser::BlockItemContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::BlockItemContext::SEMI() {
  return getToken(RbtParser::SEMI, 0);
}

tree::TerminalNode* RbtParser::BlockItemContext::COMMA() {
  return getToken(RbtParser::COMMA, 0);
}

RbtParser::ArgsContext* RbtParser::BlockItemContext::args() {
  return getRuleContext<RbtParser::ArgsContext>(0);
}


size_t RbtParser::BlockItemContext::getRuleIndex() const {
  return RbtParser::RuleBlockItem;
}


RbtParser::BlockItemContext* RbtParser::blockItem() {
  BlockItemContext *_localctx = _tracker.createInstance<BlockItemContext>(_ctx, getState());
  enterRule(_localctx, 20, RbtParser::RuleBlockItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(273);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 16, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(262);
      name();
      setState(263);
      match(RbtParser::COLON);
      setState(264);
      expression();
      setState(265);
      _la = _input->LA(1);
      if (!(_la == RbtParser::SEMI

      || _la == RbtParser::COMMA)) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(267);
      name();
      setState(268);
      name();
      setState(269);
      args();
      setState(270);
      match(RbtParser::SEMI);
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(272);
      match(RbtParser::SEMI);
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- FnDeclContext ------------------------------------------------------------------

RbtParser::FnDeclContext::FnDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::FnDeclContext::FN() {
  return getToken(RbtParser::FN, 0);
}

RbtParser::NameContext* RbtParser::FnDeclContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::FnDeclContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

tree::TerminalNode* RbtParser::FnDeclContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::FnBodyContext* RbtParser::FnDeclContext::fnBody() {
  return getRuleContext<RbtParser::FnBodyContext>(0);
}

RbtParser::ParamsContext* RbtParser::FnDeclContext::params() {
  return getRuleContext<RbtParser::ParamsContext>(0);
}

tree::TerminalNode* RbtParser::FnDeclContext::ARROW() {
  return getToken(RbtParser::ARROW, 0);
}

RbtParser::ResultTypeContext* RbtParser::FnDeclContext::resultType() {
  return getRuleContext<RbtParser::ResultTypeContext>(0);
}

RbtParser::BlockContext* RbtParser::FnDeclContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

RbtParser::TypeContext* RbtParser::FnDeclContext::type() {
  return getRuleContext<RbtParser::TypeContext>(0);
}

tree::TerminalNode* RbtParser::FnDeclContext::VOID() {
  return getToken(RbtParser::VOID, 0);
}


size_t RbtParser::FnDeclContext::getRuleIndex() const {
  return RbtParser::RuleFnDecl;
}


RbtParser::FnDeclContext* RbtParser::fnDecl() {
  FnDeclContext *_localctx = _tracker.createInstance<FnDeclContext>(_ctx, getState());
  enterRule(_localctx, 22, RbtParser::RuleFnDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(300);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN: {
        enterOuterAlt(_localctx, 1);
        setState(275);
        match(RbtParser::FN);
        setState(276);
        name();
        setState(277);
        match(RbtParser::LPAREN);
        setState(279);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if ((((_la & ~ 0x3fULL) == 0) &&
          ((1ULL << _la) & ((1ULL << RbtParser::FINAL)
          | (1ULL << RbtParser::INT_T)
          | (1ULL << RbtParser::DOUBLE_T)
          | (1ULL << RbtParser::BOOL_T)
          | (1ULL << RbtParser::TEST)
          | (1ULL << RbtParser::RECORD)
          | (1ULL << RbtParser::PATH)
          | (1ULL << RbtParser::AS)
          | (1ULL << RbtParser::ID))) != 0)) {
          setState(278);
          params();
        }
        setState(281);
        match(RbtParser::RPAREN);
        setState(284);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::ARROW) {
          setState(282);
          match(RbtParser::ARROW);
          setState(283);
          resultType();
        }
        setState(286);
        fnBody();
        break;
      }

      case RbtParser::VOID:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        enterOuterAlt(_localctx, 2);
        setState(290);
        _errHandler->sync(this);
        switch (_input->LA(1)) {
          case RbtParser::INT_T:
          case RbtParser::DOUBLE_T:
          case RbtParser::BOOL_T:
          case RbtParser::TEST:
          case RbtParser::RECORD:
          case RbtParser::PATH:
          case RbtParser::AS:
          case RbtParser::ID: {
            setState(288);
            type();
            break;
          }

          case RbtParser::VOID: {
            setState(289);
            match(RbtParser::VOID);
            break;
          }

        default:
          throw NoViableAltException(this);
        }
        setState(292);
        name();
        setState(293);
        match(RbtParser::LPAREN);
        setState(295);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if ((((_la & ~ 0x3fULL) == 0) &&
          ((1ULL << _la) & ((1ULL << RbtParser::FINAL)
          | (1ULL << RbtParser::INT_T)
          | (1ULL << RbtParser::DOUBLE_T)
          | (1ULL << RbtParser::BOOL_T)
          | (1ULL << RbtParser::TEST)
          | (1ULL << RbtParser::RECORD)
          | (1ULL << RbtParser::PATH)
          | (1ULL << RbtParser::AS)
          | (1ULL << RbtParser::ID))) != 0)) {
          setState(294);
          params();
        }
        setState(297);
        match(RbtParser::RPAREN);
        setState(298);
        block();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- FnBodyContext ------------------------------------------------------------------

RbtParser::FnBodyContext::FnBodyContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::BlockContext* RbtParser::FnBodyContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

tree::TerminalNode* RbtParser::FnBodyContext::FATARROW() {
  return getToken(RbtParser::FATARROW, 0);
}

RbtParser::ExpressionContext* RbtParser::FnBodyContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::FnBodyContext::SEMI() {
  return getToken(RbtParser::SEMI, 0);
}


size_t RbtParser::FnBodyContext::getRuleIndex() const {
  return RbtParser::RuleFnBody;
}


RbtParser::FnBodyContext* RbtParser::fnBody() {
  FnBodyContext *_localctx = _tracker.createInstance<FnBodyContext>(_ctx, getState());
  enterRule(_localctx, 24, RbtParser::RuleFnBody);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(307);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 1);
        setState(302);
        block();
        break;
      }

      case RbtParser::FATARROW: {
        enterOuterAlt(_localctx, 2);
        setState(303);
        match(RbtParser::FATARROW);
        setState(304);
        expression();
        setState(305);
        match(RbtParser::SEMI);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ParamsContext ------------------------------------------------------------------

RbtParser::ParamsContext::ParamsContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ParamContext *> RbtParser::ParamsContext::param() {
  return getRuleContexts<RbtParser::ParamContext>();
}

RbtParser::ParamContext* RbtParser::ParamsContext::param(size_t i) {
  return getRuleContext<RbtParser::ParamContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::ParamsContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::ParamsContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::ParamsContext::getRuleIndex() const {
  return RbtParser::RuleParams;
}


RbtParser::ParamsContext* RbtParser::params() {
  ParamsContext *_localctx = _tracker.createInstance<ParamsContext>(_ctx, getState());
  enterRule(_localctx, 26, RbtParser::RuleParams);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(309);
    param();
    setState(314);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 23, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(310);
        match(RbtParser::COMMA);
        setState(311);
        param(); 
      }
      setState(316);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 23, _ctx);
    }
    setState(318);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COMMA) {
      setState(317);
      match(RbtParser::COMMA);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ParamContext ------------------------------------------------------------------

RbtParser::ParamContext::ParamContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::NameContext* RbtParser::ParamContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::ParamContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

RbtParser::AnyTypeContext* RbtParser::ParamContext::anyType() {
  return getRuleContext<RbtParser::AnyTypeContext>(0);
}

tree::TerminalNode* RbtParser::ParamContext::ASSIGN() {
  return getToken(RbtParser::ASSIGN, 0);
}

RbtParser::ExpressionContext* RbtParser::ParamContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

RbtParser::TypeContext* RbtParser::ParamContext::type() {
  return getRuleContext<RbtParser::TypeContext>(0);
}

tree::TerminalNode* RbtParser::ParamContext::FINAL() {
  return getToken(RbtParser::FINAL, 0);
}

std::vector<tree::TerminalNode *> RbtParser::ParamContext::LBRACK() {
  return getTokens(RbtParser::LBRACK);
}

tree::TerminalNode* RbtParser::ParamContext::LBRACK(size_t i) {
  return getToken(RbtParser::LBRACK, i);
}

std::vector<tree::TerminalNode *> RbtParser::ParamContext::RBRACK() {
  return getTokens(RbtParser::RBRACK);
}

tree::TerminalNode* RbtParser::ParamContext::RBRACK(size_t i) {
  return getToken(RbtParser::RBRACK, i);
}


size_t RbtParser::ParamContext::getRuleIndex() const {
  return RbtParser::RuleParam;
}


RbtParser::ParamContext* RbtParser::param() {
  ParamContext *_localctx = _tracker.createInstance<ParamContext>(_ctx, getState());
  enterRule(_localctx, 28, RbtParser::RuleParam);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(341);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 29, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(320);
      name();
      setState(323);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COLON) {
        setState(321);
        match(RbtParser::COLON);
        setState(322);
        anyType();
      }
      setState(327);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::ASSIGN) {
        setState(325);
        match(RbtParser::ASSIGN);
        setState(326);
        expression();
      }
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(330);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::FINAL) {
        setState(329);
        match(RbtParser::FINAL);
      }
      setState(332);
      type();
      setState(333);
      name();
      setState(338);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::LBRACK) {
        setState(334);
        match(RbtParser::LBRACK);
        setState(335);
        match(RbtParser::RBRACK);
        setState(340);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- StructDeclContext ------------------------------------------------------------------

RbtParser::StructDeclContext::StructDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::StructDeclContext::STRUCT() {
  return getToken(RbtParser::STRUCT, 0);
}

RbtParser::NameContext* RbtParser::StructDeclContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::StructDeclContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::StructDeclContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<RbtParser::ParamContext *> RbtParser::StructDeclContext::param() {
  return getRuleContexts<RbtParser::ParamContext>();
}

RbtParser::ParamContext* RbtParser::StructDeclContext::param(size_t i) {
  return getRuleContext<RbtParser::ParamContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::StructDeclContext::SEMI() {
  return getTokens(RbtParser::SEMI);
}

tree::TerminalNode* RbtParser::StructDeclContext::SEMI(size_t i) {
  return getToken(RbtParser::SEMI, i);
}

std::vector<tree::TerminalNode *> RbtParser::StructDeclContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::StructDeclContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::StructDeclContext::getRuleIndex() const {
  return RbtParser::RuleStructDecl;
}


RbtParser::StructDeclContext* RbtParser::structDecl() {
  StructDeclContext *_localctx = _tracker.createInstance<StructDeclContext>(_ctx, getState());
  enterRule(_localctx, 30, RbtParser::RuleStructDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(343);
    match(RbtParser::STRUCT);
    setState(344);
    name();
    setState(345);
    match(RbtParser::LBRACE);
    setState(352);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::FINAL)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::SEMI))) != 0)) {
      setState(350);
      _errHandler->sync(this);
      switch (_input->LA(1)) {
        case RbtParser::FINAL:
        case RbtParser::INT_T:
        case RbtParser::DOUBLE_T:
        case RbtParser::BOOL_T:
        case RbtParser::TEST:
        case RbtParser::RECORD:
        case RbtParser::PATH:
        case RbtParser::AS:
        case RbtParser::ID: {
          setState(346);
          param();
          setState(347);
          _la = _input->LA(1);
          if (!(_la == RbtParser::SEMI

          || _la == RbtParser::COMMA)) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          break;
        }

        case RbtParser::SEMI: {
          setState(349);
          match(RbtParser::SEMI);
          break;
        }

      default:
        throw NoViableAltException(this);
      }
      setState(354);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(355);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- EnumDeclContext ------------------------------------------------------------------

RbtParser::EnumDeclContext::EnumDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::EnumDeclContext::ENUM() {
  return getToken(RbtParser::ENUM, 0);
}

std::vector<RbtParser::NameContext *> RbtParser::EnumDeclContext::name() {
  return getRuleContexts<RbtParser::NameContext>();
}

RbtParser::NameContext* RbtParser::EnumDeclContext::name(size_t i) {
  return getRuleContext<RbtParser::NameContext>(i);
}

tree::TerminalNode* RbtParser::EnumDeclContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::EnumDeclContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<tree::TerminalNode *> RbtParser::EnumDeclContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::EnumDeclContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}

std::vector<tree::TerminalNode *> RbtParser::EnumDeclContext::SEMI() {
  return getTokens(RbtParser::SEMI);
}

tree::TerminalNode* RbtParser::EnumDeclContext::SEMI(size_t i) {
  return getToken(RbtParser::SEMI, i);
}


size_t RbtParser::EnumDeclContext::getRuleIndex() const {
  return RbtParser::RuleEnumDecl;
}


RbtParser::EnumDeclContext* RbtParser::enumDecl() {
  EnumDeclContext *_localctx = _tracker.createInstance<EnumDeclContext>(_ctx, getState());
  enterRule(_localctx, 32, RbtParser::RuleEnumDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(357);
    match(RbtParser::ENUM);
    setState(358);
    name();
    setState(359);
    match(RbtParser::LBRACE);
    setState(360);
    name();
    setState(365);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 32, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(361);
        _la = _input->LA(1);
        if (!(_la == RbtParser::SEMI

        || _la == RbtParser::COMMA)) {
        _errHandler->recoverInline(this);
        }
        else {
          _errHandler->reportMatch(this);
          consume();
        }
        setState(362);
        name(); 
      }
      setState(367);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 32, _ctx);
    }
    setState(371);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::SEMI

    || _la == RbtParser::COMMA) {
      setState(368);
      _la = _input->LA(1);
      if (!(_la == RbtParser::SEMI

      || _la == RbtParser::COMMA)) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      setState(373);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(374);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ImportDeclContext ------------------------------------------------------------------

RbtParser::ImportDeclContext::ImportDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::ImportDeclContext::IMPORT() {
  return getToken(RbtParser::IMPORT, 0);
}

tree::TerminalNode* RbtParser::ImportDeclContext::STRING() {
  return getToken(RbtParser::STRING, 0);
}

RbtParser::TypeNameContext* RbtParser::ImportDeclContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}

tree::TerminalNode* RbtParser::ImportDeclContext::AS() {
  return getToken(RbtParser::AS, 0);
}

RbtParser::NameContext* RbtParser::ImportDeclContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}


size_t RbtParser::ImportDeclContext::getRuleIndex() const {
  return RbtParser::RuleImportDecl;
}


RbtParser::ImportDeclContext* RbtParser::importDecl() {
  ImportDeclContext *_localctx = _tracker.createInstance<ImportDeclContext>(_ctx, getState());
  enterRule(_localctx, 34, RbtParser::RuleImportDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(376);
    match(RbtParser::IMPORT);
    setState(379);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::STRING: {
        setState(377);
        match(RbtParser::STRING);
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(378);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(383);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::AS) {
      setState(381);
      match(RbtParser::AS);
      setState(382);
      name();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- TestDeclContext ------------------------------------------------------------------

RbtParser::TestDeclContext::TestDeclContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::TestDeclContext::TEST() {
  return getToken(RbtParser::TEST, 0);
}

tree::TerminalNode* RbtParser::TestDeclContext::STRING() {
  return getToken(RbtParser::STRING, 0);
}

RbtParser::BlockContext* RbtParser::TestDeclContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}


size_t RbtParser::TestDeclContext::getRuleIndex() const {
  return RbtParser::RuleTestDecl;
}


RbtParser::TestDeclContext* RbtParser::testDecl() {
  TestDeclContext *_localctx = _tracker.createInstance<TestDeclContext>(_ctx, getState());
  enterRule(_localctx, 36, RbtParser::RuleTestDecl);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(385);
    match(RbtParser::TEST);
    setState(386);
    match(RbtParser::STRING);
    setState(387);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- TypeContext ------------------------------------------------------------------

RbtParser::TypeContext::TypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::PrimTypeContext* RbtParser::TypeContext::primType() {
  return getRuleContext<RbtParser::PrimTypeContext>(0);
}

RbtParser::TypeNameContext* RbtParser::TypeContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}

std::vector<tree::TerminalNode *> RbtParser::TypeContext::LBRACK() {
  return getTokens(RbtParser::LBRACK);
}

tree::TerminalNode* RbtParser::TypeContext::LBRACK(size_t i) {
  return getToken(RbtParser::LBRACK, i);
}

std::vector<tree::TerminalNode *> RbtParser::TypeContext::RBRACK() {
  return getTokens(RbtParser::RBRACK);
}

tree::TerminalNode* RbtParser::TypeContext::RBRACK(size_t i) {
  return getToken(RbtParser::RBRACK, i);
}


size_t RbtParser::TypeContext::getRuleIndex() const {
  return RbtParser::RuleType;
}


RbtParser::TypeContext* RbtParser::type() {
  TypeContext *_localctx = _tracker.createInstance<TypeContext>(_ctx, getState());
  enterRule(_localctx, 38, RbtParser::RuleType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(391);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        setState(389);
        primType();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(390);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(397);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::LBRACK) {
      setState(393);
      match(RbtParser::LBRACK);
      setState(394);
      match(RbtParser::RBRACK);
      setState(399);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- FnTypeContext ------------------------------------------------------------------

RbtParser::FnTypeContext::FnTypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::FnTypeContext::FN() {
  return getToken(RbtParser::FN, 0);
}

tree::TerminalNode* RbtParser::FnTypeContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

tree::TerminalNode* RbtParser::FnTypeContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

tree::TerminalNode* RbtParser::FnTypeContext::ARROW() {
  return getToken(RbtParser::ARROW, 0);
}

RbtParser::ResultTypeContext* RbtParser::FnTypeContext::resultType() {
  return getRuleContext<RbtParser::ResultTypeContext>(0);
}

std::vector<RbtParser::AnyTypeContext *> RbtParser::FnTypeContext::anyType() {
  return getRuleContexts<RbtParser::AnyTypeContext>();
}

RbtParser::AnyTypeContext* RbtParser::FnTypeContext::anyType(size_t i) {
  return getRuleContext<RbtParser::AnyTypeContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::FnTypeContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::FnTypeContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::FnTypeContext::getRuleIndex() const {
  return RbtParser::RuleFnType;
}


RbtParser::FnTypeContext* RbtParser::fnType() {
  FnTypeContext *_localctx = _tracker.createInstance<FnTypeContext>(_ctx, getState());
  enterRule(_localctx, 40, RbtParser::RuleFnType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(400);
    match(RbtParser::FN);
    setState(401);
    match(RbtParser::LPAREN);
    setState(410);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::FN)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LPAREN))) != 0)) {
      setState(402);
      anyType();
      setState(407);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::COMMA) {
        setState(403);
        match(RbtParser::COMMA);
        setState(404);
        anyType();
        setState(409);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
    }
    setState(412);
    match(RbtParser::RPAREN);
    setState(413);
    match(RbtParser::ARROW);
    setState(414);
    resultType();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ResultTypeContext ------------------------------------------------------------------

RbtParser::ResultTypeContext::ResultTypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::AnyTypeContext* RbtParser::ResultTypeContext::anyType() {
  return getRuleContext<RbtParser::AnyTypeContext>(0);
}

tree::TerminalNode* RbtParser::ResultTypeContext::VOID() {
  return getToken(RbtParser::VOID, 0);
}


size_t RbtParser::ResultTypeContext::getRuleIndex() const {
  return RbtParser::RuleResultType;
}


RbtParser::ResultTypeContext* RbtParser::resultType() {
  ResultTypeContext *_localctx = _tracker.createInstance<ResultTypeContext>(_ctx, getState());
  enterRule(_localctx, 42, RbtParser::RuleResultType);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(418);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID:
      case RbtParser::LPAREN: {
        enterOuterAlt(_localctx, 1);
        setState(416);
        anyType();
        break;
      }

      case RbtParser::VOID: {
        enterOuterAlt(_localctx, 2);
        setState(417);
        match(RbtParser::VOID);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- AnyTypeContext ------------------------------------------------------------------

RbtParser::AnyTypeContext::AnyTypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::FnTypeContext* RbtParser::AnyTypeContext::fnType() {
  return getRuleContext<RbtParser::FnTypeContext>(0);
}

RbtParser::DimTypeContext* RbtParser::AnyTypeContext::dimType() {
  return getRuleContext<RbtParser::DimTypeContext>(0);
}


size_t RbtParser::AnyTypeContext::getRuleIndex() const {
  return RbtParser::RuleAnyType;
}


RbtParser::AnyTypeContext* RbtParser::anyType() {
  AnyTypeContext *_localctx = _tracker.createInstance<AnyTypeContext>(_ctx, getState());
  enterRule(_localctx, 44, RbtParser::RuleAnyType);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(422);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN: {
        enterOuterAlt(_localctx, 1);
        setState(420);
        fnType();
        break;
      }

      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID:
      case RbtParser::LPAREN: {
        enterOuterAlt(_localctx, 2);
        setState(421);
        dimType();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- DimTypeContext ------------------------------------------------------------------

RbtParser::DimTypeContext::DimTypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::DimFactorContext *> RbtParser::DimTypeContext::dimFactor() {
  return getRuleContexts<RbtParser::DimFactorContext>();
}

RbtParser::DimFactorContext* RbtParser::DimTypeContext::dimFactor(size_t i) {
  return getRuleContext<RbtParser::DimFactorContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::DimTypeContext::STAR() {
  return getTokens(RbtParser::STAR);
}

tree::TerminalNode* RbtParser::DimTypeContext::STAR(size_t i) {
  return getToken(RbtParser::STAR, i);
}

std::vector<tree::TerminalNode *> RbtParser::DimTypeContext::SLASH() {
  return getTokens(RbtParser::SLASH);
}

tree::TerminalNode* RbtParser::DimTypeContext::SLASH(size_t i) {
  return getToken(RbtParser::SLASH, i);
}


size_t RbtParser::DimTypeContext::getRuleIndex() const {
  return RbtParser::RuleDimType;
}


RbtParser::DimTypeContext* RbtParser::dimType() {
  DimTypeContext *_localctx = _tracker.createInstance<DimTypeContext>(_ctx, getState());
  enterRule(_localctx, 46, RbtParser::RuleDimType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(424);
    dimFactor();
    setState(429);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::STAR

    || _la == RbtParser::SLASH) {
      setState(425);
      _la = _input->LA(1);
      if (!(_la == RbtParser::STAR

      || _la == RbtParser::SLASH)) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      setState(426);
      dimFactor();
      setState(431);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- DimFactorContext ------------------------------------------------------------------

RbtParser::DimFactorContext::DimFactorContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::TypeContext* RbtParser::DimFactorContext::type() {
  return getRuleContext<RbtParser::TypeContext>(0);
}

tree::TerminalNode* RbtParser::DimFactorContext::CARET() {
  return getToken(RbtParser::CARET, 0);
}

tree::TerminalNode* RbtParser::DimFactorContext::INT() {
  return getToken(RbtParser::INT, 0);
}

tree::TerminalNode* RbtParser::DimFactorContext::MINUS() {
  return getToken(RbtParser::MINUS, 0);
}

RbtParser::InParensContext* RbtParser::DimFactorContext::inParens() {
  return getRuleContext<RbtParser::InParensContext>(0);
}

std::vector<tree::TerminalNode *> RbtParser::DimFactorContext::LBRACK() {
  return getTokens(RbtParser::LBRACK);
}

tree::TerminalNode* RbtParser::DimFactorContext::LBRACK(size_t i) {
  return getToken(RbtParser::LBRACK, i);
}

std::vector<tree::TerminalNode *> RbtParser::DimFactorContext::RBRACK() {
  return getTokens(RbtParser::RBRACK);
}

tree::TerminalNode* RbtParser::DimFactorContext::RBRACK(size_t i) {
  return getToken(RbtParser::RBRACK, i);
}


size_t RbtParser::DimFactorContext::getRuleIndex() const {
  return RbtParser::RuleDimFactor;
}


RbtParser::DimFactorContext* RbtParser::dimFactor() {
  DimFactorContext *_localctx = _tracker.createInstance<DimFactorContext>(_ctx, getState());
  enterRule(_localctx, 48, RbtParser::RuleDimFactor);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(448);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        enterOuterAlt(_localctx, 1);
        setState(432);
        type();
        setState(438);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::CARET) {
          setState(433);
          match(RbtParser::CARET);
          setState(435);
          _errHandler->sync(this);

          _la = _input->LA(1);
          if (_la == RbtParser::MINUS) {
            setState(434);
            match(RbtParser::MINUS);
          }
          setState(437);
          match(RbtParser::INT);
        }
        break;
      }

      case RbtParser::LPAREN: {
        enterOuterAlt(_localctx, 2);
        setState(440);
        inParens();
        setState(445);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::LBRACK) {
          setState(441);
          match(RbtParser::LBRACK);
          setState(442);
          match(RbtParser::RBRACK);
          setState(447);
          _errHandler->sync(this);
          _la = _input->LA(1);
        }
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- InParensContext ------------------------------------------------------------------

RbtParser::InParensContext::InParensContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::InParensContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::AnyTypeContext* RbtParser::InParensContext::anyType() {
  return getRuleContext<RbtParser::AnyTypeContext>(0);
}

tree::TerminalNode* RbtParser::InParensContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}


size_t RbtParser::InParensContext::getRuleIndex() const {
  return RbtParser::RuleInParens;
}


RbtParser::InParensContext* RbtParser::inParens() {
  InParensContext *_localctx = _tracker.createInstance<InParensContext>(_ctx, getState());
  enterRule(_localctx, 50, RbtParser::RuleInParens);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(450);
    match(RbtParser::LPAREN);
    setState(451);
    anyType();
    setState(452);
    match(RbtParser::RPAREN);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- TypeNameContext ------------------------------------------------------------------

RbtParser::TypeNameContext::TypeNameContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::NameContext *> RbtParser::TypeNameContext::name() {
  return getRuleContexts<RbtParser::NameContext>();
}

RbtParser::NameContext* RbtParser::TypeNameContext::name(size_t i) {
  return getRuleContext<RbtParser::NameContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::TypeNameContext::DOT() {
  return getTokens(RbtParser::DOT);
}

tree::TerminalNode* RbtParser::TypeNameContext::DOT(size_t i) {
  return getToken(RbtParser::DOT, i);
}


size_t RbtParser::TypeNameContext::getRuleIndex() const {
  return RbtParser::RuleTypeName;
}


RbtParser::TypeNameContext* RbtParser::typeName() {
  TypeNameContext *_localctx = _tracker.createInstance<TypeNameContext>(_ctx, getState());
  enterRule(_localctx, 52, RbtParser::RuleTypeName);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(454);
    name();
    setState(459);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::DOT) {
      setState(455);
      match(RbtParser::DOT);
      setState(456);
      name();
      setState(461);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- PrimTypeContext ------------------------------------------------------------------

RbtParser::PrimTypeContext::PrimTypeContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::PrimTypeContext::INT_T() {
  return getToken(RbtParser::INT_T, 0);
}

tree::TerminalNode* RbtParser::PrimTypeContext::DOUBLE_T() {
  return getToken(RbtParser::DOUBLE_T, 0);
}

tree::TerminalNode* RbtParser::PrimTypeContext::BOOL_T() {
  return getToken(RbtParser::BOOL_T, 0);
}


size_t RbtParser::PrimTypeContext::getRuleIndex() const {
  return RbtParser::RulePrimType;
}


RbtParser::PrimTypeContext* RbtParser::primType() {
  PrimTypeContext *_localctx = _tracker.createInstance<PrimTypeContext>(_ctx, getState());
  enterRule(_localctx, 54, RbtParser::RulePrimType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(462);
    _la = _input->LA(1);
    if (!((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T))) != 0))) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- IfStmtContext ------------------------------------------------------------------

RbtParser::IfStmtContext::IfStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::IfStmtContext::IF() {
  return getToken(RbtParser::IF, 0);
}

tree::TerminalNode* RbtParser::IfStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::IfStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::IfStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

std::vector<RbtParser::IfBodyContext *> RbtParser::IfStmtContext::ifBody() {
  return getRuleContexts<RbtParser::IfBodyContext>();
}

RbtParser::IfBodyContext* RbtParser::IfStmtContext::ifBody(size_t i) {
  return getRuleContext<RbtParser::IfBodyContext>(i);
}

tree::TerminalNode* RbtParser::IfStmtContext::ELSE() {
  return getToken(RbtParser::ELSE, 0);
}

RbtParser::IfStmtContext* RbtParser::IfStmtContext::ifStmt() {
  return getRuleContext<RbtParser::IfStmtContext>(0);
}


size_t RbtParser::IfStmtContext::getRuleIndex() const {
  return RbtParser::RuleIfStmt;
}


RbtParser::IfStmtContext* RbtParser::ifStmt() {
  IfStmtContext *_localctx = _tracker.createInstance<IfStmtContext>(_ctx, getState());
  enterRule(_localctx, 56, RbtParser::RuleIfStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(464);
    match(RbtParser::IF);
    setState(465);
    match(RbtParser::LPAREN);
    setState(466);
    expression();
    setState(467);
    match(RbtParser::RPAREN);
    setState(468);
    ifBody();
    setState(474);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ELSE) {
      setState(469);
      match(RbtParser::ELSE);
      setState(472);
      _errHandler->sync(this);
      switch (_input->LA(1)) {
        case RbtParser::IF: {
          setState(470);
          ifStmt();
          break;
        }

        case RbtParser::FN:
        case RbtParser::NEW:
        case RbtParser::BREAK:
        case RbtParser::CONTINUE:
        case RbtParser::RETURN:
        case RbtParser::THROW:
        case RbtParser::RETRY:
        case RbtParser::WAIT:
        case RbtParser::TRUE:
        case RbtParser::FALSE:
        case RbtParser::INT_T:
        case RbtParser::DOUBLE_T:
        case RbtParser::BOOL_T:
        case RbtParser::TEST:
        case RbtParser::RECORD:
        case RbtParser::PATH:
        case RbtParser::AS:
        case RbtParser::QUANTITY:
        case RbtParser::FLOAT:
        case RbtParser::INT:
        case RbtParser::FSTRING:
        case RbtParser::STRING:
        case RbtParser::ID:
        case RbtParser::LBRACE:
        case RbtParser::LPAREN:
        case RbtParser::LBRACK:
        case RbtParser::NOT:
        case RbtParser::INC:
        case RbtParser::DEC:
        case RbtParser::PLUS:
        case RbtParser::MINUS: {
          setState(471);
          ifBody();
          break;
        }

      default:
        throw NoViableAltException(this);
      }
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- IfBodyContext ------------------------------------------------------------------

RbtParser::IfBodyContext::IfBodyContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::BlockContext* RbtParser::IfBodyContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

RbtParser::ClosedStmtContext* RbtParser::IfBodyContext::closedStmt() {
  return getRuleContext<RbtParser::ClosedStmtContext>(0);
}


size_t RbtParser::IfBodyContext::getRuleIndex() const {
  return RbtParser::RuleIfBody;
}


RbtParser::IfBodyContext* RbtParser::ifBody() {
  IfBodyContext *_localctx = _tracker.createInstance<IfBodyContext>(_ctx, getState());
  enterRule(_localctx, 58, RbtParser::RuleIfBody);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(478);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 1);
        setState(476);
        block();
        break;
      }

      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::BREAK:
      case RbtParser::CONTINUE:
      case RbtParser::RETURN:
      case RbtParser::THROW:
      case RbtParser::RETRY:
      case RbtParser::WAIT:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::INC:
      case RbtParser::DEC:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        enterOuterAlt(_localctx, 2);
        setState(477);
        closedStmt();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- WhileStmtContext ------------------------------------------------------------------

RbtParser::WhileStmtContext::WhileStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::WhileStmtContext::WHILE() {
  return getToken(RbtParser::WHILE, 0);
}

tree::TerminalNode* RbtParser::WhileStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::WhileStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::WhileStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::StmtContext* RbtParser::WhileStmtContext::stmt() {
  return getRuleContext<RbtParser::StmtContext>(0);
}


size_t RbtParser::WhileStmtContext::getRuleIndex() const {
  return RbtParser::RuleWhileStmt;
}


RbtParser::WhileStmtContext* RbtParser::whileStmt() {
  WhileStmtContext *_localctx = _tracker.createInstance<WhileStmtContext>(_ctx, getState());
  enterRule(_localctx, 60, RbtParser::RuleWhileStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(480);
    match(RbtParser::WHILE);
    setState(481);
    match(RbtParser::LPAREN);
    setState(482);
    expression();
    setState(483);
    match(RbtParser::RPAREN);
    setState(484);
    stmt();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- DoStmtContext ------------------------------------------------------------------

RbtParser::DoStmtContext::DoStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::DoStmtContext::DO() {
  return getToken(RbtParser::DO, 0);
}

RbtParser::BlockContext* RbtParser::DoStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

tree::TerminalNode* RbtParser::DoStmtContext::WHILE() {
  return getToken(RbtParser::WHILE, 0);
}

tree::TerminalNode* RbtParser::DoStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::DoStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::DoStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}


size_t RbtParser::DoStmtContext::getRuleIndex() const {
  return RbtParser::RuleDoStmt;
}


RbtParser::DoStmtContext* RbtParser::doStmt() {
  DoStmtContext *_localctx = _tracker.createInstance<DoStmtContext>(_ctx, getState());
  enterRule(_localctx, 62, RbtParser::RuleDoStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(486);
    match(RbtParser::DO);
    setState(487);
    block();
    setState(488);
    match(RbtParser::WHILE);
    setState(489);
    match(RbtParser::LPAREN);
    setState(490);
    expression();
    setState(491);
    match(RbtParser::RPAREN);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ForStmtContext ------------------------------------------------------------------

RbtParser::ForStmtContext::ForStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::ForStmtContext::FOR() {
  return getToken(RbtParser::FOR, 0);
}

tree::TerminalNode* RbtParser::ForStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ForHeaderContext* RbtParser::ForStmtContext::forHeader() {
  return getRuleContext<RbtParser::ForHeaderContext>(0);
}

tree::TerminalNode* RbtParser::ForStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::StmtContext* RbtParser::ForStmtContext::stmt() {
  return getRuleContext<RbtParser::StmtContext>(0);
}


size_t RbtParser::ForStmtContext::getRuleIndex() const {
  return RbtParser::RuleForStmt;
}


RbtParser::ForStmtContext* RbtParser::forStmt() {
  ForStmtContext *_localctx = _tracker.createInstance<ForStmtContext>(_ctx, getState());
  enterRule(_localctx, 64, RbtParser::RuleForStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(493);
    match(RbtParser::FOR);
    setState(494);
    match(RbtParser::LPAREN);
    setState(495);
    forHeader();
    setState(496);
    match(RbtParser::RPAREN);
    setState(497);
    stmt();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ForHeaderContext ------------------------------------------------------------------

RbtParser::ForHeaderContext::ForHeaderContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::NameContext *> RbtParser::ForHeaderContext::name() {
  return getRuleContexts<RbtParser::NameContext>();
}

RbtParser::NameContext* RbtParser::ForHeaderContext::name(size_t i) {
  return getRuleContext<RbtParser::NameContext>(i);
}

tree::TerminalNode* RbtParser::ForHeaderContext::IN() {
  return getToken(RbtParser::IN, 0);
}

RbtParser::ExpressionContext* RbtParser::ForHeaderContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::ForHeaderContext::COMMA() {
  return getToken(RbtParser::COMMA, 0);
}

RbtParser::TypeContext* RbtParser::ForHeaderContext::type() {
  return getRuleContext<RbtParser::TypeContext>(0);
}

tree::TerminalNode* RbtParser::ForHeaderContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

tree::TerminalNode* RbtParser::ForHeaderContext::FINAL() {
  return getToken(RbtParser::FINAL, 0);
}

std::vector<tree::TerminalNode *> RbtParser::ForHeaderContext::SEMI() {
  return getTokens(RbtParser::SEMI);
}

tree::TerminalNode* RbtParser::ForHeaderContext::SEMI(size_t i) {
  return getToken(RbtParser::SEMI, i);
}

RbtParser::ForInitContext* RbtParser::ForHeaderContext::forInit() {
  return getRuleContext<RbtParser::ForInitContext>(0);
}

RbtParser::ForUpdateContext* RbtParser::ForHeaderContext::forUpdate() {
  return getRuleContext<RbtParser::ForUpdateContext>(0);
}


size_t RbtParser::ForHeaderContext::getRuleIndex() const {
  return RbtParser::RuleForHeader;
}


RbtParser::ForHeaderContext* RbtParser::forHeader() {
  ForHeaderContext *_localctx = _tracker.createInstance<ForHeaderContext>(_ctx, getState());
  enterRule(_localctx, 66, RbtParser::RuleForHeader);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(526);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 56, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(499);
      name();
      setState(502);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(500);
        match(RbtParser::COMMA);
        setState(501);
        name();
      }
      setState(504);
      match(RbtParser::IN);
      setState(505);
      expression();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(508);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::FINAL) {
        setState(507);
        match(RbtParser::FINAL);
      }
      setState(510);
      type();
      setState(511);
      name();
      setState(512);
      match(RbtParser::COLON);
      setState(513);
      expression();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(516);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if ((((_la & ~ 0x3fULL) == 0) &&
        ((1ULL << _la) & ((1ULL << RbtParser::LET)
        | (1ULL << RbtParser::VAR)
        | (1ULL << RbtParser::FN)
        | (1ULL << RbtParser::FINAL)
        | (1ULL << RbtParser::NEW)
        | (1ULL << RbtParser::TRUE)
        | (1ULL << RbtParser::FALSE)
        | (1ULL << RbtParser::INT_T)
        | (1ULL << RbtParser::DOUBLE_T)
        | (1ULL << RbtParser::BOOL_T)
        | (1ULL << RbtParser::TEST)
        | (1ULL << RbtParser::RECORD)
        | (1ULL << RbtParser::PATH)
        | (1ULL << RbtParser::AS)
        | (1ULL << RbtParser::QUANTITY)
        | (1ULL << RbtParser::FLOAT)
        | (1ULL << RbtParser::INT)
        | (1ULL << RbtParser::FSTRING)
        | (1ULL << RbtParser::STRING)
        | (1ULL << RbtParser::ID)
        | (1ULL << RbtParser::LPAREN)
        | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
        ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
        | (1ULL << (RbtParser::INC - 71))
        | (1ULL << (RbtParser::DEC - 71))
        | (1ULL << (RbtParser::PLUS - 71))
        | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
        setState(515);
        forInit();
      }
      setState(518);
      match(RbtParser::SEMI);
      setState(520);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if ((((_la & ~ 0x3fULL) == 0) &&
        ((1ULL << _la) & ((1ULL << RbtParser::FN)
        | (1ULL << RbtParser::NEW)
        | (1ULL << RbtParser::TRUE)
        | (1ULL << RbtParser::FALSE)
        | (1ULL << RbtParser::INT_T)
        | (1ULL << RbtParser::DOUBLE_T)
        | (1ULL << RbtParser::BOOL_T)
        | (1ULL << RbtParser::TEST)
        | (1ULL << RbtParser::RECORD)
        | (1ULL << RbtParser::PATH)
        | (1ULL << RbtParser::AS)
        | (1ULL << RbtParser::QUANTITY)
        | (1ULL << RbtParser::FLOAT)
        | (1ULL << RbtParser::INT)
        | (1ULL << RbtParser::FSTRING)
        | (1ULL << RbtParser::STRING)
        | (1ULL << RbtParser::ID)
        | (1ULL << RbtParser::LPAREN)
        | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
        ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
        | (1ULL << (RbtParser::PLUS - 71))
        | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
        setState(519);
        expression();
      }
      setState(522);
      match(RbtParser::SEMI);
      setState(524);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if ((((_la & ~ 0x3fULL) == 0) &&
        ((1ULL << _la) & ((1ULL << RbtParser::FN)
        | (1ULL << RbtParser::NEW)
        | (1ULL << RbtParser::TRUE)
        | (1ULL << RbtParser::FALSE)
        | (1ULL << RbtParser::INT_T)
        | (1ULL << RbtParser::DOUBLE_T)
        | (1ULL << RbtParser::BOOL_T)
        | (1ULL << RbtParser::TEST)
        | (1ULL << RbtParser::RECORD)
        | (1ULL << RbtParser::PATH)
        | (1ULL << RbtParser::AS)
        | (1ULL << RbtParser::QUANTITY)
        | (1ULL << RbtParser::FLOAT)
        | (1ULL << RbtParser::INT)
        | (1ULL << RbtParser::FSTRING)
        | (1ULL << RbtParser::STRING)
        | (1ULL << RbtParser::ID)
        | (1ULL << RbtParser::LPAREN)
        | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
        ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
        | (1ULL << (RbtParser::INC - 71))
        | (1ULL << (RbtParser::DEC - 71))
        | (1ULL << (RbtParser::PLUS - 71))
        | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
        setState(523);
        forUpdate();
      }
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ForInitContext ------------------------------------------------------------------

RbtParser::ForInitContext::ForInitContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::VarDeclContext* RbtParser::ForInitContext::varDecl() {
  return getRuleContext<RbtParser::VarDeclContext>(0);
}

RbtParser::LetDeclContext* RbtParser::ForInitContext::letDecl() {
  return getRuleContext<RbtParser::LetDeclContext>(0);
}

std::vector<RbtParser::ExprStmtContext *> RbtParser::ForInitContext::exprStmt() {
  return getRuleContexts<RbtParser::ExprStmtContext>();
}

RbtParser::ExprStmtContext* RbtParser::ForInitContext::exprStmt(size_t i) {
  return getRuleContext<RbtParser::ExprStmtContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::ForInitContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::ForInitContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::ForInitContext::getRuleIndex() const {
  return RbtParser::RuleForInit;
}


RbtParser::ForInitContext* RbtParser::forInit() {
  ForInitContext *_localctx = _tracker.createInstance<ForInitContext>(_ctx, getState());
  enterRule(_localctx, 68, RbtParser::RuleForInit);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(538);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 58, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(528);
      varDecl();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(529);
      letDecl();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(530);
      exprStmt();
      setState(535);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::COMMA) {
        setState(531);
        match(RbtParser::COMMA);
        setState(532);
        exprStmt();
        setState(537);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ForUpdateContext ------------------------------------------------------------------

RbtParser::ForUpdateContext::ForUpdateContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ExprStmtContext *> RbtParser::ForUpdateContext::exprStmt() {
  return getRuleContexts<RbtParser::ExprStmtContext>();
}

RbtParser::ExprStmtContext* RbtParser::ForUpdateContext::exprStmt(size_t i) {
  return getRuleContext<RbtParser::ExprStmtContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::ForUpdateContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::ForUpdateContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::ForUpdateContext::getRuleIndex() const {
  return RbtParser::RuleForUpdate;
}


RbtParser::ForUpdateContext* RbtParser::forUpdate() {
  ForUpdateContext *_localctx = _tracker.createInstance<ForUpdateContext>(_ctx, getState());
  enterRule(_localctx, 70, RbtParser::RuleForUpdate);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(540);
    exprStmt();
    setState(545);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::COMMA) {
      setState(541);
      match(RbtParser::COMMA);
      setState(542);
      exprStmt();
      setState(547);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- SwitchStmtContext ------------------------------------------------------------------

RbtParser::SwitchStmtContext::SwitchStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::SwitchStmtContext::SWITCH() {
  return getToken(RbtParser::SWITCH, 0);
}

tree::TerminalNode* RbtParser::SwitchStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::SwitchStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::SwitchStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

tree::TerminalNode* RbtParser::SwitchStmtContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::SwitchStmtContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<tree::TerminalNode *> RbtParser::SwitchStmtContext::SEMI() {
  return getTokens(RbtParser::SEMI);
}

tree::TerminalNode* RbtParser::SwitchStmtContext::SEMI(size_t i) {
  return getToken(RbtParser::SEMI, i);
}

std::vector<RbtParser::SwitchCaseContext *> RbtParser::SwitchStmtContext::switchCase() {
  return getRuleContexts<RbtParser::SwitchCaseContext>();
}

RbtParser::SwitchCaseContext* RbtParser::SwitchStmtContext::switchCase(size_t i) {
  return getRuleContext<RbtParser::SwitchCaseContext>(i);
}


size_t RbtParser::SwitchStmtContext::getRuleIndex() const {
  return RbtParser::RuleSwitchStmt;
}


RbtParser::SwitchStmtContext* RbtParser::switchStmt() {
  SwitchStmtContext *_localctx = _tracker.createInstance<SwitchStmtContext>(_ctx, getState());
  enterRule(_localctx, 72, RbtParser::RuleSwitchStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(548);
    match(RbtParser::SWITCH);
    setState(549);
    match(RbtParser::LPAREN);
    setState(550);
    expression();
    setState(551);
    match(RbtParser::RPAREN);
    setState(552);
    match(RbtParser::LBRACE);
    setState(556);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::SEMI) {
      setState(553);
      match(RbtParser::SEMI);
      setState(558);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(562);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::CASE

    || _la == RbtParser::DEFAULT) {
      setState(559);
      switchCase();
      setState(564);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(565);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- SwitchCaseContext ------------------------------------------------------------------

RbtParser::SwitchCaseContext::SwitchCaseContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::SwitchCaseContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

tree::TerminalNode* RbtParser::SwitchCaseContext::CASE() {
  return getToken(RbtParser::CASE, 0);
}

std::vector<RbtParser::ExpressionContext *> RbtParser::SwitchCaseContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::SwitchCaseContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

tree::TerminalNode* RbtParser::SwitchCaseContext::DEFAULT() {
  return getToken(RbtParser::DEFAULT, 0);
}

std::vector<RbtParser::StmtContext *> RbtParser::SwitchCaseContext::stmt() {
  return getRuleContexts<RbtParser::StmtContext>();
}

RbtParser::StmtContext* RbtParser::SwitchCaseContext::stmt(size_t i) {
  return getRuleContext<RbtParser::StmtContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::SwitchCaseContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::SwitchCaseContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::SwitchCaseContext::getRuleIndex() const {
  return RbtParser::RuleSwitchCase;
}


RbtParser::SwitchCaseContext* RbtParser::switchCase() {
  SwitchCaseContext *_localctx = _tracker.createInstance<SwitchCaseContext>(_ctx, getState());
  enterRule(_localctx, 74, RbtParser::RuleSwitchCase);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(577);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::CASE: {
        setState(567);
        match(RbtParser::CASE);
        setState(568);
        expression();
        setState(573);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::COMMA) {
          setState(569);
          match(RbtParser::COMMA);
          setState(570);
          expression();
          setState(575);
          _errHandler->sync(this);
          _la = _input->LA(1);
        }
        break;
      }

      case RbtParser::DEFAULT: {
        setState(576);
        match(RbtParser::DEFAULT);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(579);
    match(RbtParser::COLON);
    setState(583);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::LET)
      | (1ULL << RbtParser::VAR)
      | (1ULL << RbtParser::FN)
      | (1ULL << RbtParser::STRUCT)
      | (1ULL << RbtParser::ENUM)
      | (1ULL << RbtParser::IMPORT)
      | (1ULL << RbtParser::FINAL)
      | (1ULL << RbtParser::VOID)
      | (1ULL << RbtParser::NEW)
      | (1ULL << RbtParser::IF)
      | (1ULL << RbtParser::WHILE)
      | (1ULL << RbtParser::DO)
      | (1ULL << RbtParser::FOR)
      | (1ULL << RbtParser::SWITCH)
      | (1ULL << RbtParser::BREAK)
      | (1ULL << RbtParser::CONTINUE)
      | (1ULL << RbtParser::RETURN)
      | (1ULL << RbtParser::TRY)
      | (1ULL << RbtParser::THROW)
      | (1ULL << RbtParser::RETRY)
      | (1ULL << RbtParser::PARALLEL)
      | (1ULL << RbtParser::WHEN)
      | (1ULL << RbtParser::EVERY)
      | (1ULL << RbtParser::WAIT)
      | (1ULL << RbtParser::WITH)
      | (1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LBRACE)
      | (1ULL << RbtParser::LPAREN)
      | (1ULL << RbtParser::LBRACK)
      | (1ULL << RbtParser::SEMI))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
      | (1ULL << (RbtParser::INC - 71))
      | (1ULL << (RbtParser::DEC - 71))
      | (1ULL << (RbtParser::PLUS - 71))
      | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
      setState(580);
      stmt();
      setState(585);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- TryStmtContext ------------------------------------------------------------------

RbtParser::TryStmtContext::TryStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::TryStmtContext::TRY() {
  return getToken(RbtParser::TRY, 0);
}

std::vector<RbtParser::BlockContext *> RbtParser::TryStmtContext::block() {
  return getRuleContexts<RbtParser::BlockContext>();
}

RbtParser::BlockContext* RbtParser::TryStmtContext::block(size_t i) {
  return getRuleContext<RbtParser::BlockContext>(i);
}

std::vector<RbtParser::CatchClauseContext *> RbtParser::TryStmtContext::catchClause() {
  return getRuleContexts<RbtParser::CatchClauseContext>();
}

RbtParser::CatchClauseContext* RbtParser::TryStmtContext::catchClause(size_t i) {
  return getRuleContext<RbtParser::CatchClauseContext>(i);
}

tree::TerminalNode* RbtParser::TryStmtContext::FINALLY() {
  return getToken(RbtParser::FINALLY, 0);
}


size_t RbtParser::TryStmtContext::getRuleIndex() const {
  return RbtParser::RuleTryStmt;
}


RbtParser::TryStmtContext* RbtParser::tryStmt() {
  TryStmtContext *_localctx = _tracker.createInstance<TryStmtContext>(_ctx, getState());
  enterRule(_localctx, 76, RbtParser::RuleTryStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(586);
    match(RbtParser::TRY);
    setState(587);
    block();
    setState(591);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::CATCH) {
      setState(588);
      catchClause();
      setState(593);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(596);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::FINALLY) {
      setState(594);
      match(RbtParser::FINALLY);
      setState(595);
      block();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- CatchClauseContext ------------------------------------------------------------------

RbtParser::CatchClauseContext::CatchClauseContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::CatchClauseContext::CATCH() {
  return getToken(RbtParser::CATCH, 0);
}

RbtParser::BlockContext* RbtParser::CatchClauseContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

tree::TerminalNode* RbtParser::CatchClauseContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ParamContext* RbtParser::CatchClauseContext::param() {
  return getRuleContext<RbtParser::ParamContext>(0);
}

tree::TerminalNode* RbtParser::CatchClauseContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}


size_t RbtParser::CatchClauseContext::getRuleIndex() const {
  return RbtParser::RuleCatchClause;
}


RbtParser::CatchClauseContext* RbtParser::catchClause() {
  CatchClauseContext *_localctx = _tracker.createInstance<CatchClauseContext>(_ctx, getState());
  enterRule(_localctx, 78, RbtParser::RuleCatchClause);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(598);
    match(RbtParser::CATCH);
    setState(603);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::LPAREN) {
      setState(599);
      match(RbtParser::LPAREN);
      setState(600);
      param();
      setState(601);
      match(RbtParser::RPAREN);
    }
    setState(605);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ParallelStmtContext ------------------------------------------------------------------

RbtParser::ParallelStmtContext::ParallelStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::ParallelStmtContext::PARALLEL() {
  return getToken(RbtParser::PARALLEL, 0);
}

RbtParser::BlockContext* RbtParser::ParallelStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}


size_t RbtParser::ParallelStmtContext::getRuleIndex() const {
  return RbtParser::RuleParallelStmt;
}


RbtParser::ParallelStmtContext* RbtParser::parallelStmt() {
  ParallelStmtContext *_localctx = _tracker.createInstance<ParallelStmtContext>(_ctx, getState());
  enterRule(_localctx, 80, RbtParser::RuleParallelStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(607);
    match(RbtParser::PARALLEL);
    setState(608);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- WhenStmtContext ------------------------------------------------------------------

RbtParser::WhenStmtContext::WhenStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::WhenStmtContext::WHEN() {
  return getToken(RbtParser::WHEN, 0);
}

tree::TerminalNode* RbtParser::WhenStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::WhenStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::WhenStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::BlockContext* RbtParser::WhenStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}


size_t RbtParser::WhenStmtContext::getRuleIndex() const {
  return RbtParser::RuleWhenStmt;
}


RbtParser::WhenStmtContext* RbtParser::whenStmt() {
  WhenStmtContext *_localctx = _tracker.createInstance<WhenStmtContext>(_ctx, getState());
  enterRule(_localctx, 82, RbtParser::RuleWhenStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(610);
    match(RbtParser::WHEN);
    setState(611);
    match(RbtParser::LPAREN);
    setState(612);
    expression();
    setState(613);
    match(RbtParser::RPAREN);
    setState(614);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- EveryStmtContext ------------------------------------------------------------------

RbtParser::EveryStmtContext::EveryStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::EveryStmtContext::EVERY() {
  return getToken(RbtParser::EVERY, 0);
}

tree::TerminalNode* RbtParser::EveryStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::EveryStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::EveryStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::BlockContext* RbtParser::EveryStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}


size_t RbtParser::EveryStmtContext::getRuleIndex() const {
  return RbtParser::RuleEveryStmt;
}


RbtParser::EveryStmtContext* RbtParser::everyStmt() {
  EveryStmtContext *_localctx = _tracker.createInstance<EveryStmtContext>(_ctx, getState());
  enterRule(_localctx, 84, RbtParser::RuleEveryStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(616);
    match(RbtParser::EVERY);
    setState(617);
    match(RbtParser::LPAREN);
    setState(618);
    expression();
    setState(619);
    match(RbtParser::RPAREN);
    setState(620);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- WaitStmtContext ------------------------------------------------------------------

RbtParser::WaitStmtContext::WaitStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::WaitStmtContext::WAIT() {
  return getToken(RbtParser::WAIT, 0);
}

tree::TerminalNode* RbtParser::WaitStmtContext::UNTIL() {
  return getToken(RbtParser::UNTIL, 0);
}

RbtParser::ExprContext* RbtParser::WaitStmtContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

RbtParser::ExpressionContext* RbtParser::WaitStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

std::vector<tree::TerminalNode *> RbtParser::WaitStmtContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::WaitStmtContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}

std::vector<RbtParser::ArgContext *> RbtParser::WaitStmtContext::arg() {
  return getRuleContexts<RbtParser::ArgContext>();
}

RbtParser::ArgContext* RbtParser::WaitStmtContext::arg(size_t i) {
  return getRuleContext<RbtParser::ArgContext>(i);
}


size_t RbtParser::WaitStmtContext::getRuleIndex() const {
  return RbtParser::RuleWaitStmt;
}


RbtParser::WaitStmtContext* RbtParser::waitStmt() {
  WaitStmtContext *_localctx = _tracker.createInstance<WaitStmtContext>(_ctx, getState());
  enterRule(_localctx, 86, RbtParser::RuleWaitStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(622);
    match(RbtParser::WAIT);
    setState(633);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::UNTIL: {
        setState(623);
        match(RbtParser::UNTIL);
        setState(624);
        expr(0);
        setState(629);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::COMMA) {
          setState(625);
          match(RbtParser::COMMA);
          setState(626);
          arg();
          setState(631);
          _errHandler->sync(this);
          _la = _input->LA(1);
        }
        break;
      }

      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        setState(632);
        expression();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- WithStmtContext ------------------------------------------------------------------

RbtParser::WithStmtContext::WithStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::WithStmtContext::WITH() {
  return getToken(RbtParser::WITH, 0);
}

RbtParser::ArgsContext* RbtParser::WithStmtContext::args() {
  return getRuleContext<RbtParser::ArgsContext>(0);
}

RbtParser::BlockContext* RbtParser::WithStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}


size_t RbtParser::WithStmtContext::getRuleIndex() const {
  return RbtParser::RuleWithStmt;
}


RbtParser::WithStmtContext* RbtParser::withStmt() {
  WithStmtContext *_localctx = _tracker.createInstance<WithStmtContext>(_ctx, getState());
  enterRule(_localctx, 88, RbtParser::RuleWithStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(635);
    match(RbtParser::WITH);
    setState(636);
    args();
    setState(637);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- PathStmtContext ------------------------------------------------------------------

RbtParser::PathStmtContext::PathStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::PathStmtContext::PATH() {
  return getToken(RbtParser::PATH, 0);
}

RbtParser::BlockContext* RbtParser::PathStmtContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

RbtParser::ArgsContext* RbtParser::PathStmtContext::args() {
  return getRuleContext<RbtParser::ArgsContext>(0);
}


size_t RbtParser::PathStmtContext::getRuleIndex() const {
  return RbtParser::RulePathStmt;
}


RbtParser::PathStmtContext* RbtParser::pathStmt() {
  PathStmtContext *_localctx = _tracker.createInstance<PathStmtContext>(_ctx, getState());
  enterRule(_localctx, 90, RbtParser::RulePathStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(639);
    match(RbtParser::PATH);
    setState(641);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::LPAREN) {
      setState(640);
      args();
    }
    setState(643);
    block();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- RecordStmtContext ------------------------------------------------------------------

RbtParser::RecordStmtContext::RecordStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::RecordStmtContext::RECORD() {
  return getToken(RbtParser::RECORD, 0);
}

RbtParser::NameContext* RbtParser::RecordStmtContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::RecordStmtContext::EVERY() {
  return getToken(RbtParser::EVERY, 0);
}

tree::TerminalNode* RbtParser::RecordStmtContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::RecordStmtContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::RecordStmtContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

tree::TerminalNode* RbtParser::RecordStmtContext::LBRACE() {
  return getToken(RbtParser::LBRACE, 0);
}

tree::TerminalNode* RbtParser::RecordStmtContext::RBRACE() {
  return getToken(RbtParser::RBRACE, 0);
}

std::vector<RbtParser::BlockItemContext *> RbtParser::RecordStmtContext::blockItem() {
  return getRuleContexts<RbtParser::BlockItemContext>();
}

RbtParser::BlockItemContext* RbtParser::RecordStmtContext::blockItem(size_t i) {
  return getRuleContext<RbtParser::BlockItemContext>(i);
}


size_t RbtParser::RecordStmtContext::getRuleIndex() const {
  return RbtParser::RuleRecordStmt;
}


RbtParser::RecordStmtContext* RbtParser::recordStmt() {
  RecordStmtContext *_localctx = _tracker.createInstance<RecordStmtContext>(_ctx, getState());
  enterRule(_localctx, 92, RbtParser::RuleRecordStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(645);
    match(RbtParser::RECORD);
    setState(646);
    name();
    setState(647);
    match(RbtParser::EVERY);
    setState(648);
    match(RbtParser::LPAREN);
    setState(649);
    expression();
    setState(650);
    match(RbtParser::RPAREN);
    setState(651);
    match(RbtParser::LBRACE);
    setState(655);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::SEMI))) != 0)) {
      setState(652);
      blockItem();
      setState(657);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(658);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ExprStmtContext ------------------------------------------------------------------

RbtParser::ExprStmtContext::ExprStmtContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ExpressionContext *> RbtParser::ExprStmtContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::ExprStmtContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

RbtParser::AssignTailContext* RbtParser::ExprStmtContext::assignTail() {
  return getRuleContext<RbtParser::AssignTailContext>(0);
}

RbtParser::CompoundOpContext* RbtParser::ExprStmtContext::compoundOp() {
  return getRuleContext<RbtParser::CompoundOpContext>(0);
}

tree::TerminalNode* RbtParser::ExprStmtContext::INC() {
  return getToken(RbtParser::INC, 0);
}

tree::TerminalNode* RbtParser::ExprStmtContext::DEC() {
  return getToken(RbtParser::DEC, 0);
}

RbtParser::ExprContext* RbtParser::ExprStmtContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}


size_t RbtParser::ExprStmtContext::getRuleIndex() const {
  return RbtParser::RuleExprStmt;
}


RbtParser::ExprStmtContext* RbtParser::exprStmt() {
  ExprStmtContext *_localctx = _tracker.createInstance<ExprStmtContext>(_ctx, getState());
  enterRule(_localctx, 94, RbtParser::RuleExprStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(671);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        enterOuterAlt(_localctx, 1);
        setState(660);
        expression();
        setState(667);
        _errHandler->sync(this);
        switch (_input->LA(1)) {
          case RbtParser::ASSIGN: {
            setState(661);
            assignTail();
            break;
          }

          case RbtParser::PLUSEQ:
          case RbtParser::MINUSEQ:
          case RbtParser::STAREQ:
          case RbtParser::SLASHEQ:
          case RbtParser::PERCENTEQ: {
            setState(662);
            compoundOp();
            setState(663);
            expression();
            break;
          }

          case RbtParser::INC: {
            setState(665);
            match(RbtParser::INC);
            break;
          }

          case RbtParser::DEC: {
            setState(666);
            match(RbtParser::DEC);
            break;
          }

          case RbtParser::RPAREN:
          case RbtParser::SEMI:
          case RbtParser::COMMA: {
            break;
          }

        default:
          break;
        }
        break;
      }

      case RbtParser::INC:
      case RbtParser::DEC: {
        enterOuterAlt(_localctx, 2);
        setState(669);
        _la = _input->LA(1);
        if (!(_la == RbtParser::INC

        || _la == RbtParser::DEC)) {
        _errHandler->recoverInline(this);
        }
        else {
          _errHandler->reportMatch(this);
          consume();
        }
        setState(670);
        expr(0);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- AssignTailContext ------------------------------------------------------------------

RbtParser::AssignTailContext::AssignTailContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<tree::TerminalNode *> RbtParser::AssignTailContext::ASSIGN() {
  return getTokens(RbtParser::ASSIGN);
}

tree::TerminalNode* RbtParser::AssignTailContext::ASSIGN(size_t i) {
  return getToken(RbtParser::ASSIGN, i);
}

std::vector<RbtParser::ExpressionContext *> RbtParser::AssignTailContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::AssignTailContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

RbtParser::BraceInitContext* RbtParser::AssignTailContext::braceInit() {
  return getRuleContext<RbtParser::BraceInitContext>(0);
}


size_t RbtParser::AssignTailContext::getRuleIndex() const {
  return RbtParser::RuleAssignTail;
}


RbtParser::AssignTailContext* RbtParser::assignTail() {
  AssignTailContext *_localctx = _tracker.createInstance<AssignTailContext>(_ctx, getState());
  enterRule(_localctx, 96, RbtParser::RuleAssignTail);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    setState(685);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 76, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(675); 
      _errHandler->sync(this);
      alt = 1;
      do {
        switch (alt) {
          case 1: {
                setState(673);
                match(RbtParser::ASSIGN);
                setState(674);
                expression();
                break;
              }

        default:
          throw NoViableAltException(this);
        }
        setState(677); 
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 74, _ctx);
      } while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER);
      setState(681);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::ASSIGN) {
        setState(679);
        match(RbtParser::ASSIGN);
        setState(680);
        braceInit();
      }
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(683);
      match(RbtParser::ASSIGN);
      setState(684);
      braceInit();
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- CompoundOpContext ------------------------------------------------------------------

RbtParser::CompoundOpContext::CompoundOpContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::CompoundOpContext::PLUSEQ() {
  return getToken(RbtParser::PLUSEQ, 0);
}

tree::TerminalNode* RbtParser::CompoundOpContext::MINUSEQ() {
  return getToken(RbtParser::MINUSEQ, 0);
}

tree::TerminalNode* RbtParser::CompoundOpContext::STAREQ() {
  return getToken(RbtParser::STAREQ, 0);
}

tree::TerminalNode* RbtParser::CompoundOpContext::SLASHEQ() {
  return getToken(RbtParser::SLASHEQ, 0);
}

tree::TerminalNode* RbtParser::CompoundOpContext::PERCENTEQ() {
  return getToken(RbtParser::PERCENTEQ, 0);
}


size_t RbtParser::CompoundOpContext::getRuleIndex() const {
  return RbtParser::RuleCompoundOp;
}


RbtParser::CompoundOpContext* RbtParser::compoundOp() {
  CompoundOpContext *_localctx = _tracker.createInstance<CompoundOpContext>(_ctx, getState());
  enterRule(_localctx, 98, RbtParser::RuleCompoundOp);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(687);
    _la = _input->LA(1);
    if (!(((((_la - 72) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 72)) & ((1ULL << (RbtParser::PLUSEQ - 72))
      | (1ULL << (RbtParser::MINUSEQ - 72))
      | (1ULL << (RbtParser::STAREQ - 72))
      | (1ULL << (RbtParser::SLASHEQ - 72))
      | (1ULL << (RbtParser::PERCENTEQ - 72)))) != 0))) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ExpressionContext ------------------------------------------------------------------

RbtParser::ExpressionContext::ExpressionContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::LambdaContext* RbtParser::ExpressionContext::lambda() {
  return getRuleContext<RbtParser::LambdaContext>(0);
}

RbtParser::NewArrayContext* RbtParser::ExpressionContext::newArray() {
  return getRuleContext<RbtParser::NewArrayContext>(0);
}

std::vector<RbtParser::ExprContext *> RbtParser::ExpressionContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::ExpressionContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::ExpressionContext::UNTIL() {
  return getToken(RbtParser::UNTIL, 0);
}


size_t RbtParser::ExpressionContext::getRuleIndex() const {
  return RbtParser::RuleExpression;
}


RbtParser::ExpressionContext* RbtParser::expression() {
  ExpressionContext *_localctx = _tracker.createInstance<ExpressionContext>(_ctx, getState());
  enterRule(_localctx, 100, RbtParser::RuleExpression);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(696);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 78, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(689);
      lambda();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(690);
      newArray();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(691);
      expr(0);
      setState(694);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::UNTIL) {
        setState(692);
        match(RbtParser::UNTIL);
        setState(693);
        expr(0);
      }
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- LambdaContext ------------------------------------------------------------------

RbtParser::LambdaContext::LambdaContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::LambdaContext::FN() {
  return getToken(RbtParser::FN, 0);
}

tree::TerminalNode* RbtParser::LambdaContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

tree::TerminalNode* RbtParser::LambdaContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::BlockContext* RbtParser::LambdaContext::block() {
  return getRuleContext<RbtParser::BlockContext>(0);
}

tree::TerminalNode* RbtParser::LambdaContext::FATARROW() {
  return getToken(RbtParser::FATARROW, 0);
}

RbtParser::ExpressionContext* RbtParser::LambdaContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

RbtParser::ParamsContext* RbtParser::LambdaContext::params() {
  return getRuleContext<RbtParser::ParamsContext>(0);
}

tree::TerminalNode* RbtParser::LambdaContext::ARROW() {
  return getToken(RbtParser::ARROW, 0);
}

RbtParser::ResultTypeContext* RbtParser::LambdaContext::resultType() {
  return getRuleContext<RbtParser::ResultTypeContext>(0);
}


size_t RbtParser::LambdaContext::getRuleIndex() const {
  return RbtParser::RuleLambda;
}


RbtParser::LambdaContext* RbtParser::lambda() {
  LambdaContext *_localctx = _tracker.createInstance<LambdaContext>(_ctx, getState());
  enterRule(_localctx, 102, RbtParser::RuleLambda);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(698);
    match(RbtParser::FN);
    setState(699);
    match(RbtParser::LPAREN);
    setState(701);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::FINAL)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID))) != 0)) {
      setState(700);
      params();
    }
    setState(703);
    match(RbtParser::RPAREN);
    setState(706);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ARROW) {
      setState(704);
      match(RbtParser::ARROW);
      setState(705);
      resultType();
    }
    setState(711);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        setState(708);
        block();
        break;
      }

      case RbtParser::FATARROW: {
        setState(709);
        match(RbtParser::FATARROW);
        setState(710);
        expression();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ExprContext ------------------------------------------------------------------

RbtParser::ExprContext::ExprContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}


size_t RbtParser::ExprContext::getRuleIndex() const {
  return RbtParser::RuleExpr;
}

void RbtParser::ExprContext::copyFrom(ExprContext *ctx) {
  GuardedCtx::copyFrom(ctx);
}

//----------------- AndEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::AndEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::AndEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::AndEContext::ANDAND() {
  return getToken(RbtParser::ANDAND, 0);
}

RbtParser::AndEContext::AndEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- OrEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::OrEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::OrEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::OrEContext::OROR() {
  return getToken(RbtParser::OROR, 0);
}

RbtParser::OrEContext::OrEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- CondEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::CondEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::CondEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::CondEContext::QMARK() {
  return getToken(RbtParser::QMARK, 0);
}

tree::TerminalNode* RbtParser::CondEContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}

RbtParser::CondEContext::CondEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- MemberEContext ------------------------------------------------------------------

RbtParser::ExprContext* RbtParser::MemberEContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

tree::TerminalNode* RbtParser::MemberEContext::DOT() {
  return getToken(RbtParser::DOT, 0);
}

RbtParser::NameContext* RbtParser::MemberEContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

RbtParser::MemberEContext::MemberEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- CastEContext ------------------------------------------------------------------

tree::TerminalNode* RbtParser::CastEContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::PrimTypeContext* RbtParser::CastEContext::primType() {
  return getRuleContext<RbtParser::PrimTypeContext>(0);
}

tree::TerminalNode* RbtParser::CastEContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

RbtParser::ExprContext* RbtParser::CastEContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

RbtParser::CastEContext::CastEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- PrimaryEContext ------------------------------------------------------------------

RbtParser::PrimaryContext* RbtParser::PrimaryEContext::primary() {
  return getRuleContext<RbtParser::PrimaryContext>(0);
}

RbtParser::PrimaryEContext::PrimaryEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- CallEContext ------------------------------------------------------------------

RbtParser::ExprContext* RbtParser::CallEContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

RbtParser::ArgsContext* RbtParser::CallEContext::args() {
  return getRuleContext<RbtParser::ArgsContext>(0);
}

RbtParser::CallEContext::CallEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- AddEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::AddEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::AddEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::AddEContext::PLUS() {
  return getToken(RbtParser::PLUS, 0);
}

tree::TerminalNode* RbtParser::AddEContext::MINUS() {
  return getToken(RbtParser::MINUS, 0);
}

RbtParser::AddEContext::AddEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- EpowEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::EpowEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::EpowEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::EpowEContext::DOTCARET() {
  return getToken(RbtParser::DOTCARET, 0);
}

RbtParser::EpowEContext::EpowEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- MulEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::MulEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::MulEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::MulEContext::STAR() {
  return getToken(RbtParser::STAR, 0);
}

tree::TerminalNode* RbtParser::MulEContext::SLASH() {
  return getToken(RbtParser::SLASH, 0);
}

tree::TerminalNode* RbtParser::MulEContext::PERCENT() {
  return getToken(RbtParser::PERCENT, 0);
}

tree::TerminalNode* RbtParser::MulEContext::BSLASH() {
  return getToken(RbtParser::BSLASH, 0);
}

tree::TerminalNode* RbtParser::MulEContext::DOTSTAR() {
  return getToken(RbtParser::DOTSTAR, 0);
}

tree::TerminalNode* RbtParser::MulEContext::DOTSLASH() {
  return getToken(RbtParser::DOTSLASH, 0);
}

RbtParser::MulEContext::MulEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- UnaryEContext ------------------------------------------------------------------

RbtParser::ExprContext* RbtParser::UnaryEContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

tree::TerminalNode* RbtParser::UnaryEContext::MINUS() {
  return getToken(RbtParser::MINUS, 0);
}

tree::TerminalNode* RbtParser::UnaryEContext::PLUS() {
  return getToken(RbtParser::PLUS, 0);
}

tree::TerminalNode* RbtParser::UnaryEContext::NOT() {
  return getToken(RbtParser::NOT, 0);
}

RbtParser::UnaryEContext::UnaryEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- EqEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::EqEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::EqEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::EqEContext::EQ() {
  return getToken(RbtParser::EQ, 0);
}

tree::TerminalNode* RbtParser::EqEContext::NE() {
  return getToken(RbtParser::NE, 0);
}

RbtParser::EqEContext::EqEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- PowEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::PowEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::PowEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::PowEContext::CARET() {
  return getToken(RbtParser::CARET, 0);
}

RbtParser::PowEContext::PowEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- RelEContext ------------------------------------------------------------------

std::vector<RbtParser::ExprContext *> RbtParser::RelEContext::expr() {
  return getRuleContexts<RbtParser::ExprContext>();
}

RbtParser::ExprContext* RbtParser::RelEContext::expr(size_t i) {
  return getRuleContext<RbtParser::ExprContext>(i);
}

tree::TerminalNode* RbtParser::RelEContext::LT() {
  return getToken(RbtParser::LT, 0);
}

tree::TerminalNode* RbtParser::RelEContext::LE() {
  return getToken(RbtParser::LE, 0);
}

tree::TerminalNode* RbtParser::RelEContext::GT() {
  return getToken(RbtParser::GT, 0);
}

tree::TerminalNode* RbtParser::RelEContext::GE() {
  return getToken(RbtParser::GE, 0);
}

RbtParser::RelEContext::RelEContext(ExprContext *ctx) { copyFrom(ctx); }


//----------------- IndexEContext ------------------------------------------------------------------

RbtParser::ExprContext* RbtParser::IndexEContext::expr() {
  return getRuleContext<RbtParser::ExprContext>(0);
}

tree::TerminalNode* RbtParser::IndexEContext::LBRACK() {
  return getToken(RbtParser::LBRACK, 0);
}

std::vector<RbtParser::IndexItemContext *> RbtParser::IndexEContext::indexItem() {
  return getRuleContexts<RbtParser::IndexItemContext>();
}

RbtParser::IndexItemContext* RbtParser::IndexEContext::indexItem(size_t i) {
  return getRuleContext<RbtParser::IndexItemContext>(i);
}

tree::TerminalNode* RbtParser::IndexEContext::RBRACK() {
  return getToken(RbtParser::RBRACK, 0);
}

std::vector<tree::TerminalNode *> RbtParser::IndexEContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::IndexEContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}

RbtParser::IndexEContext::IndexEContext(ExprContext *ctx) { copyFrom(ctx); }



RbtParser::ExprContext* RbtParser::expr() {
   return expr(0);
}

RbtParser::ExprContext* RbtParser::expr(int precedence) {
  ParserRuleContext *parentContext = _ctx;
  size_t parentState = getState();
  RbtParser::ExprContext *_localctx = _tracker.createInstance<ExprContext>(_ctx, parentState);
  RbtParser::ExprContext *previousContext = _localctx;
  (void)previousContext; // Silence compiler, in case the context is not used by generated code.
  size_t startState = 104;
  enterRecursionRule(_localctx, 104, RbtParser::RuleExpr, precedence);

    size_t _la = 0;

  auto onExit = finally([=] {
    unrollRecursionContexts(parentContext);
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(722);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 82, _ctx)) {
    case 1: {
      _localctx = _tracker.createInstance<PrimaryEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;

      setState(714);
      primary();
      break;
    }

    case 2: {
      _localctx = _tracker.createInstance<UnaryEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;
      setState(715);
      _la = _input->LA(1);
      if (!(((((_la - 71) & ~ 0x3fULL) == 0) &&
        ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
        | (1ULL << (RbtParser::PLUS - 71))
        | (1ULL << (RbtParser::MINUS - 71)))) != 0))) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      setState(716);
      expr(9);
      break;
    }

    case 3: {
      _localctx = _tracker.createInstance<CastEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;
      setState(717);
      match(RbtParser::LPAREN);
      setState(718);
      primType();
      setState(719);
      match(RbtParser::RPAREN);
      setState(720);
      expr(8);
      break;
    }

    }
    _ctx->stop = _input->LT(-1);
    setState(773);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 85, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        if (!_parseListeners.empty())
          triggerExitRuleEvent();
        previousContext = _localctx;
        setState(771);
        _errHandler->sync(this);
        switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 84, _ctx)) {
        case 1: {
          auto newContext = _tracker.createInstance<PowEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(724);

          if (!(precpred(_ctx, 11))) throw FailedPredicateException(this, "precpred(_ctx, 11)");
          setState(725);
          match(RbtParser::CARET);
          setState(726);
          expr(11);
          break;
        }

        case 2: {
          auto newContext = _tracker.createInstance<EpowEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(727);

          if (!(precpred(_ctx, 10))) throw FailedPredicateException(this, "precpred(_ctx, 10)");
          setState(728);
          match(RbtParser::DOTCARET);
          setState(729);
          expr(11);
          break;
        }

        case 3: {
          auto newContext = _tracker.createInstance<MulEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(730);

          if (!(precpred(_ctx, 7))) throw FailedPredicateException(this, "precpred(_ctx, 7)");
          setState(731);
          _la = _input->LA(1);
          if (!(((((_la - 80) & ~ 0x3fULL) == 0) &&
            ((1ULL << (_la - 80)) & ((1ULL << (RbtParser::DOTSTAR - 80))
            | (1ULL << (RbtParser::DOTSLASH - 80))
            | (1ULL << (RbtParser::STAR - 80))
            | (1ULL << (RbtParser::SLASH - 80))
            | (1ULL << (RbtParser::PERCENT - 80))
            | (1ULL << (RbtParser::BSLASH - 80)))) != 0))) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(732);
          expr(8);
          break;
        }

        case 4: {
          auto newContext = _tracker.createInstance<AddEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(733);

          if (!(precpred(_ctx, 6))) throw FailedPredicateException(this, "precpred(_ctx, 6)");
          setState(734);
          _la = _input->LA(1);
          if (!(_la == RbtParser::PLUS

          || _la == RbtParser::MINUS)) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(735);
          expr(7);
          break;
        }

        case 5: {
          auto newContext = _tracker.createInstance<RelEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(736);

          if (!(precpred(_ctx, 5))) throw FailedPredicateException(this, "precpred(_ctx, 5)");
          setState(737);
          _la = _input->LA(1);
          if (!(((((_la - 65) & ~ 0x3fULL) == 0) &&
            ((1ULL << (_la - 65)) & ((1ULL << (RbtParser::LE - 65))
            | (1ULL << (RbtParser::GE - 65))
            | (1ULL << (RbtParser::LT - 65))
            | (1ULL << (RbtParser::GT - 65)))) != 0))) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(738);
          expr(6);
          break;
        }

        case 6: {
          auto newContext = _tracker.createInstance<EqEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(739);

          if (!(precpred(_ctx, 4))) throw FailedPredicateException(this, "precpred(_ctx, 4)");
          setState(740);
          _la = _input->LA(1);
          if (!(_la == RbtParser::EQ

          || _la == RbtParser::NE)) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(741);
          expr(5);
          break;
        }

        case 7: {
          auto newContext = _tracker.createInstance<AndEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(742);

          if (!(precpred(_ctx, 3))) throw FailedPredicateException(this, "precpred(_ctx, 3)");
          setState(743);
          match(RbtParser::ANDAND);
          setState(744);
          expr(4);
          break;
        }

        case 8: {
          auto newContext = _tracker.createInstance<OrEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(745);

          if (!(precpred(_ctx, 2))) throw FailedPredicateException(this, "precpred(_ctx, 2)");
          setState(746);
          match(RbtParser::OROR);
          setState(747);
          expr(3);
          break;
        }

        case 9: {
          auto newContext = _tracker.createInstance<CondEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(748);

          if (!(precpred(_ctx, 1))) throw FailedPredicateException(this, "precpred(_ctx, 1)");
          setState(749);
          match(RbtParser::QMARK);
          setState(750);
          expr(0);
          setState(751);
          match(RbtParser::COLON);
          setState(752);
          expr(1);
          break;
        }

        case 10: {
          auto newContext = _tracker.createInstance<MemberEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(754);

          if (!(precpred(_ctx, 14))) throw FailedPredicateException(this, "precpred(_ctx, 14)");
          setState(755);
          match(RbtParser::DOT);
          setState(756);
          name();
          break;
        }

        case 11: {
          auto newContext = _tracker.createInstance<IndexEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(757);

          if (!(precpred(_ctx, 13))) throw FailedPredicateException(this, "precpred(_ctx, 13)");
          setState(758);
          match(RbtParser::LBRACK);
          setState(759);
          indexItem();
          setState(764);
          _errHandler->sync(this);
          _la = _input->LA(1);
          while (_la == RbtParser::COMMA) {
            setState(760);
            match(RbtParser::COMMA);
            setState(761);
            indexItem();
            setState(766);
            _errHandler->sync(this);
            _la = _input->LA(1);
          }
          setState(767);
          match(RbtParser::RBRACK);
          break;
        }

        case 12: {
          auto newContext = _tracker.createInstance<CallEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(769);

          if (!(precpred(_ctx, 12))) throw FailedPredicateException(this, "precpred(_ctx, 12)");
          setState(770);
          args();
          break;
        }

        } 
      }
      setState(775);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 85, _ctx);
    }
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }
  return _localctx;
}

//----------------- PrimaryContext ------------------------------------------------------------------

RbtParser::PrimaryContext::PrimaryContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::LiteralContext* RbtParser::PrimaryContext::literal() {
  return getRuleContext<RbtParser::LiteralContext>(0);
}

RbtParser::NameContext* RbtParser::PrimaryContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

RbtParser::PrimTypeContext* RbtParser::PrimaryContext::primType() {
  return getRuleContext<RbtParser::PrimTypeContext>(0);
}

RbtParser::ArgsContext* RbtParser::PrimaryContext::args() {
  return getRuleContext<RbtParser::ArgsContext>(0);
}

tree::TerminalNode* RbtParser::PrimaryContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

RbtParser::ExpressionContext* RbtParser::PrimaryContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::PrimaryContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

tree::TerminalNode* RbtParser::PrimaryContext::LBRACK() {
  return getToken(RbtParser::LBRACK, 0);
}

tree::TerminalNode* RbtParser::PrimaryContext::RBRACK() {
  return getToken(RbtParser::RBRACK, 0);
}

std::vector<RbtParser::RowContext *> RbtParser::PrimaryContext::row() {
  return getRuleContexts<RbtParser::RowContext>();
}

RbtParser::RowContext* RbtParser::PrimaryContext::row(size_t i) {
  return getRuleContext<RbtParser::RowContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::PrimaryContext::SEMI() {
  return getTokens(RbtParser::SEMI);
}

tree::TerminalNode* RbtParser::PrimaryContext::SEMI(size_t i) {
  return getToken(RbtParser::SEMI, i);
}

tree::TerminalNode* RbtParser::PrimaryContext::NEW() {
  return getToken(RbtParser::NEW, 0);
}

RbtParser::TypeNameContext* RbtParser::PrimaryContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}


size_t RbtParser::PrimaryContext::getRuleIndex() const {
  return RbtParser::RulePrimary;
}


RbtParser::PrimaryContext* RbtParser::primary() {
  PrimaryContext *_localctx = _tracker.createInstance<PrimaryContext>(_ctx, getState());
  enterRule(_localctx, 106, RbtParser::RulePrimary);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    setState(804);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING: {
        enterOuterAlt(_localctx, 1);
        setState(776);
        literal();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        enterOuterAlt(_localctx, 2);
        setState(777);
        name();
        break;
      }

      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        enterOuterAlt(_localctx, 3);
        setState(778);
        primType();
        setState(779);
        args();
        break;
      }

      case RbtParser::LPAREN: {
        enterOuterAlt(_localctx, 4);
        setState(781);
        match(RbtParser::LPAREN);
        setState(782);
        expression();
        setState(783);
        match(RbtParser::RPAREN);
        break;
      }

      case RbtParser::LBRACK: {
        enterOuterAlt(_localctx, 5);
        setState(785);
        match(RbtParser::LBRACK);
        setState(797);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if ((((_la & ~ 0x3fULL) == 0) &&
          ((1ULL << _la) & ((1ULL << RbtParser::FN)
          | (1ULL << RbtParser::NEW)
          | (1ULL << RbtParser::TRUE)
          | (1ULL << RbtParser::FALSE)
          | (1ULL << RbtParser::INT_T)
          | (1ULL << RbtParser::DOUBLE_T)
          | (1ULL << RbtParser::BOOL_T)
          | (1ULL << RbtParser::TEST)
          | (1ULL << RbtParser::RECORD)
          | (1ULL << RbtParser::PATH)
          | (1ULL << RbtParser::AS)
          | (1ULL << RbtParser::QUANTITY)
          | (1ULL << RbtParser::FLOAT)
          | (1ULL << RbtParser::INT)
          | (1ULL << RbtParser::FSTRING)
          | (1ULL << RbtParser::STRING)
          | (1ULL << RbtParser::ID)
          | (1ULL << RbtParser::LPAREN)
          | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
          ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
          | (1ULL << (RbtParser::PLUS - 71))
          | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
          setState(786);
          row();
          setState(791);
          _errHandler->sync(this);
          alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 86, _ctx);
          while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
            if (alt == 1) {
              setState(787);
              match(RbtParser::SEMI);
              setState(788);
              row(); 
            }
            setState(793);
            _errHandler->sync(this);
            alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 86, _ctx);
          }
          setState(795);
          _errHandler->sync(this);

          _la = _input->LA(1);
          if (_la == RbtParser::SEMI) {
            setState(794);
            match(RbtParser::SEMI);
          }
        }
        setState(799);
        match(RbtParser::RBRACK);
        break;
      }

      case RbtParser::NEW: {
        enterOuterAlt(_localctx, 6);
        setState(800);
        match(RbtParser::NEW);
        setState(801);
        typeName();
        setState(802);
        args();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- RowContext ------------------------------------------------------------------

RbtParser::RowContext::RowContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ExpressionContext *> RbtParser::RowContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::RowContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::RowContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::RowContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::RowContext::getRuleIndex() const {
  return RbtParser::RuleRow;
}


RbtParser::RowContext* RbtParser::row() {
  RowContext *_localctx = _tracker.createInstance<RowContext>(_ctx, getState());
  enterRule(_localctx, 108, RbtParser::RuleRow);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(806);
    expression();
    setState(811);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 90, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(807);
        match(RbtParser::COMMA);
        setState(808);
        expression(); 
      }
      setState(813);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 90, _ctx);
    }
    setState(815);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COMMA) {
      setState(814);
      match(RbtParser::COMMA);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- NewArrayContext ------------------------------------------------------------------

RbtParser::NewArrayContext::NewArrayContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::NewArrayContext::NEW() {
  return getToken(RbtParser::NEW, 0);
}

RbtParser::PrimTypeContext* RbtParser::NewArrayContext::primType() {
  return getRuleContext<RbtParser::PrimTypeContext>(0);
}

RbtParser::TypeNameContext* RbtParser::NewArrayContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}

RbtParser::BraceInitContext* RbtParser::NewArrayContext::braceInit() {
  return getRuleContext<RbtParser::BraceInitContext>(0);
}

std::vector<RbtParser::NewDimContext *> RbtParser::NewArrayContext::newDim() {
  return getRuleContexts<RbtParser::NewDimContext>();
}

RbtParser::NewDimContext* RbtParser::NewArrayContext::newDim(size_t i) {
  return getRuleContext<RbtParser::NewDimContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::NewArrayContext::LBRACK() {
  return getTokens(RbtParser::LBRACK);
}

tree::TerminalNode* RbtParser::NewArrayContext::LBRACK(size_t i) {
  return getToken(RbtParser::LBRACK, i);
}

std::vector<tree::TerminalNode *> RbtParser::NewArrayContext::RBRACK() {
  return getTokens(RbtParser::RBRACK);
}

tree::TerminalNode* RbtParser::NewArrayContext::RBRACK(size_t i) {
  return getToken(RbtParser::RBRACK, i);
}


size_t RbtParser::NewArrayContext::getRuleIndex() const {
  return RbtParser::RuleNewArray;
}


RbtParser::NewArrayContext* RbtParser::newArray() {
  NewArrayContext *_localctx = _tracker.createInstance<NewArrayContext>(_ctx, getState());
  enterRule(_localctx, 110, RbtParser::RuleNewArray);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(817);
    match(RbtParser::NEW);
    setState(820);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        setState(818);
        primType();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(819);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(841);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 96, _ctx)) {
    case 1: {
      setState(823); 
      _errHandler->sync(this);
      alt = 1;
      do {
        switch (alt) {
          case 1: {
                setState(822);
                newDim();
                break;
              }

        default:
          throw NoViableAltException(this);
        }
        setState(825); 
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 93, _ctx);
      } while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER);
      setState(831);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::LBRACK) {
        setState(827);
        match(RbtParser::LBRACK);
        setState(828);
        match(RbtParser::RBRACK);
        setState(833);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
      break;
    }

    case 2: {
      setState(836); 
      _errHandler->sync(this);
      _la = _input->LA(1);
      do {
        setState(834);
        match(RbtParser::LBRACK);
        setState(835);
        match(RbtParser::RBRACK);
        setState(838); 
        _errHandler->sync(this);
        _la = _input->LA(1);
      } while (_la == RbtParser::LBRACK);
      setState(840);
      braceInit();
      break;
    }

    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- NewDimContext ------------------------------------------------------------------

RbtParser::NewDimContext::NewDimContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::NewDimContext::LBRACK() {
  return getToken(RbtParser::LBRACK, 0);
}

RbtParser::ExpressionContext* RbtParser::NewDimContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

tree::TerminalNode* RbtParser::NewDimContext::RBRACK() {
  return getToken(RbtParser::RBRACK, 0);
}


size_t RbtParser::NewDimContext::getRuleIndex() const {
  return RbtParser::RuleNewDim;
}


RbtParser::NewDimContext* RbtParser::newDim() {
  NewDimContext *_localctx = _tracker.createInstance<NewDimContext>(_ctx, getState());
  enterRule(_localctx, 112, RbtParser::RuleNewDim);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(843);
    match(RbtParser::LBRACK);
    setState(844);
    expression();
    setState(845);
    match(RbtParser::RBRACK);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- IndexItemContext ------------------------------------------------------------------

RbtParser::IndexItemContext::IndexItemContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ExpressionContext *> RbtParser::IndexItemContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::IndexItemContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

tree::TerminalNode* RbtParser::IndexItemContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}


size_t RbtParser::IndexItemContext::getRuleIndex() const {
  return RbtParser::RuleIndexItem;
}


RbtParser::IndexItemContext* RbtParser::indexItem() {
  IndexItemContext *_localctx = _tracker.createInstance<IndexItemContext>(_ctx, getState());
  enterRule(_localctx, 114, RbtParser::RuleIndexItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(858);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN:
      case RbtParser::NEW:
      case RbtParser::TRUE:
      case RbtParser::FALSE:
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T:
      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::QUANTITY:
      case RbtParser::FLOAT:
      case RbtParser::INT:
      case RbtParser::FSTRING:
      case RbtParser::STRING:
      case RbtParser::ID:
      case RbtParser::LPAREN:
      case RbtParser::LBRACK:
      case RbtParser::NOT:
      case RbtParser::PLUS:
      case RbtParser::MINUS: {
        enterOuterAlt(_localctx, 1);
        setState(847);
        expression();
        setState(852);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::COLON) {
          setState(848);
          match(RbtParser::COLON);
          setState(850);
          _errHandler->sync(this);

          _la = _input->LA(1);
          if ((((_la & ~ 0x3fULL) == 0) &&
            ((1ULL << _la) & ((1ULL << RbtParser::FN)
            | (1ULL << RbtParser::NEW)
            | (1ULL << RbtParser::TRUE)
            | (1ULL << RbtParser::FALSE)
            | (1ULL << RbtParser::INT_T)
            | (1ULL << RbtParser::DOUBLE_T)
            | (1ULL << RbtParser::BOOL_T)
            | (1ULL << RbtParser::TEST)
            | (1ULL << RbtParser::RECORD)
            | (1ULL << RbtParser::PATH)
            | (1ULL << RbtParser::AS)
            | (1ULL << RbtParser::QUANTITY)
            | (1ULL << RbtParser::FLOAT)
            | (1ULL << RbtParser::INT)
            | (1ULL << RbtParser::FSTRING)
            | (1ULL << RbtParser::STRING)
            | (1ULL << RbtParser::ID)
            | (1ULL << RbtParser::LPAREN)
            | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
            ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
            | (1ULL << (RbtParser::PLUS - 71))
            | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
            setState(849);
            expression();
          }
        }
        break;
      }

      case RbtParser::COLON: {
        enterOuterAlt(_localctx, 2);
        setState(854);
        match(RbtParser::COLON);
        setState(856);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if ((((_la & ~ 0x3fULL) == 0) &&
          ((1ULL << _la) & ((1ULL << RbtParser::FN)
          | (1ULL << RbtParser::NEW)
          | (1ULL << RbtParser::TRUE)
          | (1ULL << RbtParser::FALSE)
          | (1ULL << RbtParser::INT_T)
          | (1ULL << RbtParser::DOUBLE_T)
          | (1ULL << RbtParser::BOOL_T)
          | (1ULL << RbtParser::TEST)
          | (1ULL << RbtParser::RECORD)
          | (1ULL << RbtParser::PATH)
          | (1ULL << RbtParser::AS)
          | (1ULL << RbtParser::QUANTITY)
          | (1ULL << RbtParser::FLOAT)
          | (1ULL << RbtParser::INT)
          | (1ULL << RbtParser::FSTRING)
          | (1ULL << RbtParser::STRING)
          | (1ULL << RbtParser::ID)
          | (1ULL << RbtParser::LPAREN)
          | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
          ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
          | (1ULL << (RbtParser::PLUS - 71))
          | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
          setState(855);
          expression();
        }
        break;
      }

    default:
      throw NoViableAltException(this);
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ArgsContext ------------------------------------------------------------------

RbtParser::ArgsContext::ArgsContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::ArgsContext::LPAREN() {
  return getToken(RbtParser::LPAREN, 0);
}

tree::TerminalNode* RbtParser::ArgsContext::RPAREN() {
  return getToken(RbtParser::RPAREN, 0);
}

std::vector<RbtParser::ArgContext *> RbtParser::ArgsContext::arg() {
  return getRuleContexts<RbtParser::ArgContext>();
}

RbtParser::ArgContext* RbtParser::ArgsContext::arg(size_t i) {
  return getRuleContext<RbtParser::ArgContext>(i);
}

std::vector<tree::TerminalNode *> RbtParser::ArgsContext::COMMA() {
  return getTokens(RbtParser::COMMA);
}

tree::TerminalNode* RbtParser::ArgsContext::COMMA(size_t i) {
  return getToken(RbtParser::COMMA, i);
}


size_t RbtParser::ArgsContext::getRuleIndex() const {
  return RbtParser::RuleArgs;
}


RbtParser::ArgsContext* RbtParser::args() {
  ArgsContext *_localctx = _tracker.createInstance<ArgsContext>(_ctx, getState());
  enterRule(_localctx, 116, RbtParser::RuleArgs);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(860);
    match(RbtParser::LPAREN);
    setState(872);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::FN)
      | (1ULL << RbtParser::NEW)
      | (1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::INT_T)
      | (1ULL << RbtParser::DOUBLE_T)
      | (1ULL << RbtParser::BOOL_T)
      | (1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::LPAREN)
      | (1ULL << RbtParser::LBRACK))) != 0) || ((((_la - 71) & ~ 0x3fULL) == 0) &&
      ((1ULL << (_la - 71)) & ((1ULL << (RbtParser::NOT - 71))
      | (1ULL << (RbtParser::PLUS - 71))
      | (1ULL << (RbtParser::MINUS - 71)))) != 0)) {
      setState(861);
      arg();
      setState(866);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 101, _ctx);
      while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
        if (alt == 1) {
          setState(862);
          match(RbtParser::COMMA);
          setState(863);
          arg(); 
        }
        setState(868);
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 101, _ctx);
      }
      setState(870);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(869);
        match(RbtParser::COMMA);
      }
    }
    setState(874);
    match(RbtParser::RPAREN);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- ArgContext ------------------------------------------------------------------

RbtParser::ArgContext::ArgContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

RbtParser::ExpressionContext* RbtParser::ArgContext::expression() {
  return getRuleContext<RbtParser::ExpressionContext>(0);
}

RbtParser::NameContext* RbtParser::ArgContext::name() {
  return getRuleContext<RbtParser::NameContext>(0);
}

tree::TerminalNode* RbtParser::ArgContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}


size_t RbtParser::ArgContext::getRuleIndex() const {
  return RbtParser::RuleArg;
}


RbtParser::ArgContext* RbtParser::arg() {
  ArgContext *_localctx = _tracker.createInstance<ArgContext>(_ctx, getState());
  enterRule(_localctx, 118, RbtParser::RuleArg);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(879);
    _errHandler->sync(this);

    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 104, _ctx)) {
    case 1: {
      setState(876);
      name();
      setState(877);
      match(RbtParser::COLON);
      break;
    }

    }
    setState(881);
    expression();
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- LiteralContext ------------------------------------------------------------------

RbtParser::LiteralContext::LiteralContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::LiteralContext::INT() {
  return getToken(RbtParser::INT, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::FLOAT() {
  return getToken(RbtParser::FLOAT, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::QUANTITY() {
  return getToken(RbtParser::QUANTITY, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::STRING() {
  return getToken(RbtParser::STRING, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::FSTRING() {
  return getToken(RbtParser::FSTRING, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::TRUE() {
  return getToken(RbtParser::TRUE, 0);
}

tree::TerminalNode* RbtParser::LiteralContext::FALSE() {
  return getToken(RbtParser::FALSE, 0);
}


size_t RbtParser::LiteralContext::getRuleIndex() const {
  return RbtParser::RuleLiteral;
}


RbtParser::LiteralContext* RbtParser::literal() {
  LiteralContext *_localctx = _tracker.createInstance<LiteralContext>(_ctx, getState());
  enterRule(_localctx, 120, RbtParser::RuleLiteral);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(883);
    _la = _input->LA(1);
    if (!((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TRUE)
      | (1ULL << RbtParser::FALSE)
      | (1ULL << RbtParser::QUANTITY)
      | (1ULL << RbtParser::FLOAT)
      | (1ULL << RbtParser::INT)
      | (1ULL << RbtParser::FSTRING)
      | (1ULL << RbtParser::STRING))) != 0))) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- NameContext ------------------------------------------------------------------

RbtParser::NameContext::NameContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::NameContext::ID() {
  return getToken(RbtParser::ID, 0);
}

tree::TerminalNode* RbtParser::NameContext::TEST() {
  return getToken(RbtParser::TEST, 0);
}

tree::TerminalNode* RbtParser::NameContext::RECORD() {
  return getToken(RbtParser::RECORD, 0);
}

tree::TerminalNode* RbtParser::NameContext::PATH() {
  return getToken(RbtParser::PATH, 0);
}

tree::TerminalNode* RbtParser::NameContext::AS() {
  return getToken(RbtParser::AS, 0);
}


size_t RbtParser::NameContext::getRuleIndex() const {
  return RbtParser::RuleName;
}


RbtParser::NameContext* RbtParser::name() {
  NameContext *_localctx = _tracker.createInstance<NameContext>(_ctx, getState());
  enterRule(_localctx, 122, RbtParser::RuleName);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(885);
    _la = _input->LA(1);
    if (!((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID))) != 0))) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

bool RbtParser::sempred(RuleContext *context, size_t ruleIndex, size_t predicateIndex) {
  switch (ruleIndex) {
    case 52: return exprSempred(dynamic_cast<ExprContext *>(context), predicateIndex);

  default:
    break;
  }
  return true;
}

bool RbtParser::exprSempred(ExprContext *_localctx, size_t predicateIndex) {
  switch (predicateIndex) {
    case 0: return precpred(_ctx, 11);
    case 1: return precpred(_ctx, 10);
    case 2: return precpred(_ctx, 7);
    case 3: return precpred(_ctx, 6);
    case 4: return precpred(_ctx, 5);
    case 5: return precpred(_ctx, 4);
    case 6: return precpred(_ctx, 3);
    case 7: return precpred(_ctx, 2);
    case 8: return precpred(_ctx, 1);
    case 9: return precpred(_ctx, 14);
    case 10: return precpred(_ctx, 13);
    case 11: return precpred(_ctx, 12);

  default:
    break;
  }
  return true;
}

// Static vars and initialization.
std::vector<dfa::DFA> RbtParser::_decisionToDFA;
atn::PredictionContextCache RbtParser::_sharedContextCache;

// We own the ATN which in turn owns the ATN states.
atn::ATN RbtParser::_atn;
std::vector<uint16_t> RbtParser::_serializedATN;

std::vector<std::string> RbtParser::_ruleNames = {
  "program", "stmt", "closedStmt", "block", "letDecl", "varDecl", "declarator", 
  "initializer", "braceInit", "blockDecl", "blockItem", "fnDecl", "fnBody", 
  "params", "param", "structDecl", "enumDecl", "importDecl", "testDecl", 
  "type", "fnType", "resultType", "anyType", "dimType", "dimFactor", "inParens", 
  "typeName", "primType", "ifStmt", "ifBody", "whileStmt", "doStmt", "forStmt", 
  "forHeader", "forInit", "forUpdate", "switchStmt", "switchCase", "tryStmt", 
  "catchClause", "parallelStmt", "whenStmt", "everyStmt", "waitStmt", "withStmt", 
  "pathStmt", "recordStmt", "exprStmt", "assignTail", "compoundOp", "expression", 
  "lambda", "expr", "primary", "row", "newArray", "newDim", "indexItem", 
  "args", "arg", "literal", "name"
};

std::vector<std::string> RbtParser::_literalNames = {
  "", "'let'", "'var'", "'fn'", "'struct'", "'enum'", "'import'", "'final'", 
  "'void'", "'new'", "'if'", "'else'", "'while'", "'do'", "'for'", "'in'", 
  "'switch'", "'case'", "'default'", "'break'", "'continue'", "'return'", 
  "'try'", "'catch'", "'finally'", "'throw'", "'retry'", "'parallel'", "'when'", 
  "'every'", "'wait'", "'until'", "'with'", "'true'", "'false'", "", "", 
  "", "'test'", "'record'", "'path'", "'as'", "", "", "", "", "", "", "", 
  "", "'{'", "'}'", "'('", "')'", "'['", "']'", "';'", "','", "'.'", "':'", 
  "'?'", "'->'", "'=>'", "'=='", "'!='", "'<='", "'>='", "'<'", "'>'", "'&&'", 
  "'||'", "'!'", "'+='", "'-='", "'*='", "'/='", "'%='", "'='", "'++'", 
  "'--'", "'.*'", "'./'", "'.^'", "'+'", "'-'", "'*'", "'/'", "'%'", "'\\'", 
  "'^'"
};

std::vector<std::string> RbtParser::_symbolicNames = {
  "", "LET", "VAR", "FN", "STRUCT", "ENUM", "IMPORT", "FINAL", "VOID", "NEW", 
  "IF", "ELSE", "WHILE", "DO", "FOR", "IN", "SWITCH", "CASE", "DEFAULT", 
  "BREAK", "CONTINUE", "RETURN", "TRY", "CATCH", "FINALLY", "THROW", "RETRY", 
  "PARALLEL", "WHEN", "EVERY", "WAIT", "UNTIL", "WITH", "TRUE", "FALSE", 
  "INT_T", "DOUBLE_T", "BOOL_T", "TEST", "RECORD", "PATH", "AS", "QUANTITY", 
  "FLOAT", "INT", "BADNUM", "FSTRING", "STRING", "BADSTR", "ID", "LBRACE", 
  "RBRACE", "LPAREN", "RPAREN", "LBRACK", "RBRACK", "SEMI", "COMMA", "DOT", 
  "COLON", "QMARK", "ARROW", "FATARROW", "EQ", "NE", "LE", "GE", "LT", "GT", 
  "ANDAND", "OROR", "NOT", "PLUSEQ", "MINUSEQ", "STAREQ", "SLASHEQ", "PERCENTEQ", 
  "ASSIGN", "INC", "DEC", "DOTSTAR", "DOTSLASH", "DOTCARET", "PLUS", "MINUS", 
  "STAR", "SLASH", "PERCENT", "BSLASH", "CARET", "BLOCK_COMMENT", "LINE_COMMENT", 
  "NL", "WS", "ERR"
};

dfa::Vocabulary RbtParser::_vocabulary(_literalNames, _symbolicNames);

std::vector<std::string> RbtParser::_tokenNames;

RbtParser::Initializer::Initializer() {
	for (size_t i = 0; i < _symbolicNames.size(); ++i) {
		std::string name = _vocabulary.getLiteralName(i);
		if (name.empty()) {
			name = _vocabulary.getSymbolicName(i);
		}

		if (name.empty()) {
			_tokenNames.push_back("<INVALID>");
		} else {
      _tokenNames.push_back(name);
    }
	}

  _serializedATN = {
    0x3, 0x608b, 0xa72a, 0x8133, 0xb9ed, 0x417c, 0x3be7, 0x7786, 0x5964, 
    0x3, 0x60, 0x37a, 0x4, 0x2, 0x9, 0x2, 0x4, 0x3, 0x9, 0x3, 0x4, 0x4, 
    0x9, 0x4, 0x4, 0x5, 0x9, 0x5, 0x4, 0x6, 0x9, 0x6, 0x4, 0x7, 0x9, 0x7, 
    0x4, 0x8, 0x9, 0x8, 0x4, 0x9, 0x9, 0x9, 0x4, 0xa, 0x9, 0xa, 0x4, 0xb, 
    0x9, 0xb, 0x4, 0xc, 0x9, 0xc, 0x4, 0xd, 0x9, 0xd, 0x4, 0xe, 0x9, 0xe, 
    0x4, 0xf, 0x9, 0xf, 0x4, 0x10, 0x9, 0x10, 0x4, 0x11, 0x9, 0x11, 0x4, 
    0x12, 0x9, 0x12, 0x4, 0x13, 0x9, 0x13, 0x4, 0x14, 0x9, 0x14, 0x4, 0x15, 
    0x9, 0x15, 0x4, 0x16, 0x9, 0x16, 0x4, 0x17, 0x9, 0x17, 0x4, 0x18, 0x9, 
    0x18, 0x4, 0x19, 0x9, 0x19, 0x4, 0x1a, 0x9, 0x1a, 0x4, 0x1b, 0x9, 0x1b, 
    0x4, 0x1c, 0x9, 0x1c, 0x4, 0x1d, 0x9, 0x1d, 0x4, 0x1e, 0x9, 0x1e, 0x4, 
    0x1f, 0x9, 0x1f, 0x4, 0x20, 0x9, 0x20, 0x4, 0x21, 0x9, 0x21, 0x4, 0x22, 
    0x9, 0x22, 0x4, 0x23, 0x9, 0x23, 0x4, 0x24, 0x9, 0x24, 0x4, 0x25, 0x9, 
    0x25, 0x4, 0x26, 0x9, 0x26, 0x4, 0x27, 0x9, 0x27, 0x4, 0x28, 0x9, 0x28, 
    0x4, 0x29, 0x9, 0x29, 0x4, 0x2a, 0x9, 0x2a, 0x4, 0x2b, 0x9, 0x2b, 0x4, 
    0x2c, 0x9, 0x2c, 0x4, 0x2d, 0x9, 0x2d, 0x4, 0x2e, 0x9, 0x2e, 0x4, 0x2f, 
    0x9, 0x2f, 0x4, 0x30, 0x9, 0x30, 0x4, 0x31, 0x9, 0x31, 0x4, 0x32, 0x9, 
    0x32, 0x4, 0x33, 0x9, 0x33, 0x4, 0x34, 0x9, 0x34, 0x4, 0x35, 0x9, 0x35, 
    0x4, 0x36, 0x9, 0x36, 0x4, 0x37, 0x9, 0x37, 0x4, 0x38, 0x9, 0x38, 0x4, 
    0x39, 0x9, 0x39, 0x4, 0x3a, 0x9, 0x3a, 0x4, 0x3b, 0x9, 0x3b, 0x4, 0x3c, 
    0x9, 0x3c, 0x4, 0x3d, 0x9, 0x3d, 0x4, 0x3e, 0x9, 0x3e, 0x4, 0x3f, 0x9, 
    0x3f, 0x3, 0x2, 0x7, 0x2, 0x80, 0xa, 0x2, 0xc, 0x2, 0xe, 0x2, 0x83, 
    0xb, 0x2, 0x3, 0x2, 0x3, 0x2, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x5, 0x3, 
    0xa6, 0xa, 0x3, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 
    0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 
    0x4, 0x3, 0x4, 0x5, 0x4, 0xb6, 0xa, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 
    0x3, 0x4, 0x3, 0x4, 0x5, 0x4, 0xbd, 0xa, 0x4, 0x3, 0x5, 0x3, 0x5, 0x7, 
    0x5, 0xc1, 0xa, 0x5, 0xc, 0x5, 0xe, 0x5, 0xc4, 0xb, 0x5, 0x3, 0x5, 0x3, 
    0x5, 0x3, 0x6, 0x3, 0x6, 0x3, 0x6, 0x3, 0x6, 0x5, 0x6, 0xcc, 0xa, 0x6, 
    0x3, 0x6, 0x3, 0x6, 0x5, 0x6, 0xd0, 0xa, 0x6, 0x3, 0x7, 0x5, 0x7, 0xd3, 
    0xa, 0x7, 0x3, 0x7, 0x3, 0x7, 0x3, 0x7, 0x3, 0x7, 0x7, 0x7, 0xd9, 0xa, 
    0x7, 0xc, 0x7, 0xe, 0x7, 0xdc, 0xb, 0x7, 0x3, 0x8, 0x3, 0x8, 0x3, 0x8, 
    0x7, 0x8, 0xe1, 0xa, 0x8, 0xc, 0x8, 0xe, 0x8, 0xe4, 0xb, 0x8, 0x3, 0x8, 
    0x3, 0x8, 0x5, 0x8, 0xe8, 0xa, 0x8, 0x3, 0x9, 0x3, 0x9, 0x5, 0x9, 0xec, 
    0xa, 0x9, 0x3, 0xa, 0x3, 0xa, 0x3, 0xa, 0x3, 0xa, 0x7, 0xa, 0xf2, 0xa, 
    0xa, 0xc, 0xa, 0xe, 0xa, 0xf5, 0xb, 0xa, 0x3, 0xa, 0x5, 0xa, 0xf8, 0xa, 
    0xa, 0x5, 0xa, 0xfa, 0xa, 0xa, 0x3, 0xa, 0x3, 0xa, 0x3, 0xb, 0x3, 0xb, 
    0x3, 0xb, 0x3, 0xb, 0x7, 0xb, 0x102, 0xa, 0xb, 0xc, 0xb, 0xe, 0xb, 0x105, 
    0xb, 0xb, 0x3, 0xb, 0x3, 0xb, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 
    0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 
    0x5, 0xc, 0x114, 0xa, 0xc, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x5, 
    0xd, 0x11a, 0xa, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x5, 0xd, 0x11f, 
    0xa, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x5, 0xd, 0x125, 0xa, 
    0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x5, 0xd, 0x12a, 0xa, 0xd, 0x3, 0xd, 
    0x3, 0xd, 0x3, 0xd, 0x5, 0xd, 0x12f, 0xa, 0xd, 0x3, 0xe, 0x3, 0xe, 0x3, 
    0xe, 0x3, 0xe, 0x3, 0xe, 0x5, 0xe, 0x136, 0xa, 0xe, 0x3, 0xf, 0x3, 0xf, 
    0x3, 0xf, 0x7, 0xf, 0x13b, 0xa, 0xf, 0xc, 0xf, 0xe, 0xf, 0x13e, 0xb, 
    0xf, 0x3, 0xf, 0x5, 0xf, 0x141, 0xa, 0xf, 0x3, 0x10, 0x3, 0x10, 0x3, 
    0x10, 0x5, 0x10, 0x146, 0xa, 0x10, 0x3, 0x10, 0x3, 0x10, 0x5, 0x10, 
    0x14a, 0xa, 0x10, 0x3, 0x10, 0x5, 0x10, 0x14d, 0xa, 0x10, 0x3, 0x10, 
    0x3, 0x10, 0x3, 0x10, 0x3, 0x10, 0x7, 0x10, 0x153, 0xa, 0x10, 0xc, 0x10, 
    0xe, 0x10, 0x156, 0xb, 0x10, 0x5, 0x10, 0x158, 0xa, 0x10, 0x3, 0x11, 
    0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 0x7, 
    0x11, 0x161, 0xa, 0x11, 0xc, 0x11, 0xe, 0x11, 0x164, 0xb, 0x11, 0x3, 
    0x11, 0x3, 0x11, 0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 
    0x3, 0x12, 0x7, 0x12, 0x16e, 0xa, 0x12, 0xc, 0x12, 0xe, 0x12, 0x171, 
    0xb, 0x12, 0x3, 0x12, 0x7, 0x12, 0x174, 0xa, 0x12, 0xc, 0x12, 0xe, 0x12, 
    0x177, 0xb, 0x12, 0x3, 0x12, 0x3, 0x12, 0x3, 0x13, 0x3, 0x13, 0x3, 0x13, 
    0x5, 0x13, 0x17e, 0xa, 0x13, 0x3, 0x13, 0x3, 0x13, 0x5, 0x13, 0x182, 
    0xa, 0x13, 0x3, 0x14, 0x3, 0x14, 0x3, 0x14, 0x3, 0x14, 0x3, 0x15, 0x3, 
    0x15, 0x5, 0x15, 0x18a, 0xa, 0x15, 0x3, 0x15, 0x3, 0x15, 0x7, 0x15, 
    0x18e, 0xa, 0x15, 0xc, 0x15, 0xe, 0x15, 0x191, 0xb, 0x15, 0x3, 0x16, 
    0x3, 0x16, 0x3, 0x16, 0x3, 0x16, 0x3, 0x16, 0x7, 0x16, 0x198, 0xa, 0x16, 
    0xc, 0x16, 0xe, 0x16, 0x19b, 0xb, 0x16, 0x5, 0x16, 0x19d, 0xa, 0x16, 
    0x3, 0x16, 0x3, 0x16, 0x3, 0x16, 0x3, 0x16, 0x3, 0x17, 0x3, 0x17, 0x5, 
    0x17, 0x1a5, 0xa, 0x17, 0x3, 0x18, 0x3, 0x18, 0x5, 0x18, 0x1a9, 0xa, 
    0x18, 0x3, 0x19, 0x3, 0x19, 0x3, 0x19, 0x7, 0x19, 0x1ae, 0xa, 0x19, 
    0xc, 0x19, 0xe, 0x19, 0x1b1, 0xb, 0x19, 0x3, 0x1a, 0x3, 0x1a, 0x3, 0x1a, 
    0x5, 0x1a, 0x1b6, 0xa, 0x1a, 0x3, 0x1a, 0x5, 0x1a, 0x1b9, 0xa, 0x1a, 
    0x3, 0x1a, 0x3, 0x1a, 0x3, 0x1a, 0x7, 0x1a, 0x1be, 0xa, 0x1a, 0xc, 0x1a, 
    0xe, 0x1a, 0x1c1, 0xb, 0x1a, 0x5, 0x1a, 0x1c3, 0xa, 0x1a, 0x3, 0x1b, 
    0x3, 0x1b, 0x3, 0x1b, 0x3, 0x1b, 0x3, 0x1c, 0x3, 0x1c, 0x3, 0x1c, 0x7, 
    0x1c, 0x1cc, 0xa, 0x1c, 0xc, 0x1c, 0xe, 0x1c, 0x1cf, 0xb, 0x1c, 0x3, 
    0x1d, 0x3, 0x1d, 0x3, 0x1e, 0x3, 0x1e, 0x3, 0x1e, 0x3, 0x1e, 0x3, 0x1e, 
    0x3, 0x1e, 0x3, 0x1e, 0x3, 0x1e, 0x5, 0x1e, 0x1db, 0xa, 0x1e, 0x5, 0x1e, 
    0x1dd, 0xa, 0x1e, 0x3, 0x1f, 0x3, 0x1f, 0x5, 0x1f, 0x1e1, 0xa, 0x1f, 
    0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 
    0x21, 0x3, 0x21, 0x3, 0x21, 0x3, 0x21, 0x3, 0x21, 0x3, 0x21, 0x3, 0x21, 
    0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 
    0x23, 0x3, 0x23, 0x3, 0x23, 0x5, 0x23, 0x1f9, 0xa, 0x23, 0x3, 0x23, 
    0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x5, 0x23, 0x1ff, 0xa, 0x23, 0x3, 0x23, 
    0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x5, 0x23, 0x207, 
    0xa, 0x23, 0x3, 0x23, 0x3, 0x23, 0x5, 0x23, 0x20b, 0xa, 0x23, 0x3, 0x23, 
    0x3, 0x23, 0x5, 0x23, 0x20f, 0xa, 0x23, 0x5, 0x23, 0x211, 0xa, 0x23, 
    0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 0x7, 0x24, 0x218, 
    0xa, 0x24, 0xc, 0x24, 0xe, 0x24, 0x21b, 0xb, 0x24, 0x5, 0x24, 0x21d, 
    0xa, 0x24, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x7, 0x25, 0x222, 0xa, 0x25, 
    0xc, 0x25, 0xe, 0x25, 0x225, 0xb, 0x25, 0x3, 0x26, 0x3, 0x26, 0x3, 0x26, 
    0x3, 0x26, 0x3, 0x26, 0x3, 0x26, 0x7, 0x26, 0x22d, 0xa, 0x26, 0xc, 0x26, 
    0xe, 0x26, 0x230, 0xb, 0x26, 0x3, 0x26, 0x7, 0x26, 0x233, 0xa, 0x26, 
    0xc, 0x26, 0xe, 0x26, 0x236, 0xb, 0x26, 0x3, 0x26, 0x3, 0x26, 0x3, 0x27, 
    0x3, 0x27, 0x3, 0x27, 0x3, 0x27, 0x7, 0x27, 0x23e, 0xa, 0x27, 0xc, 0x27, 
    0xe, 0x27, 0x241, 0xb, 0x27, 0x3, 0x27, 0x5, 0x27, 0x244, 0xa, 0x27, 
    0x3, 0x27, 0x3, 0x27, 0x7, 0x27, 0x248, 0xa, 0x27, 0xc, 0x27, 0xe, 0x27, 
    0x24b, 0xb, 0x27, 0x3, 0x28, 0x3, 0x28, 0x3, 0x28, 0x7, 0x28, 0x250, 
    0xa, 0x28, 0xc, 0x28, 0xe, 0x28, 0x253, 0xb, 0x28, 0x3, 0x28, 0x3, 0x28, 
    0x5, 0x28, 0x257, 0xa, 0x28, 0x3, 0x29, 0x3, 0x29, 0x3, 0x29, 0x3, 0x29, 
    0x3, 0x29, 0x5, 0x29, 0x25e, 0xa, 0x29, 0x3, 0x29, 0x3, 0x29, 0x3, 0x2a, 
    0x3, 0x2a, 0x3, 0x2a, 0x3, 0x2b, 0x3, 0x2b, 0x3, 0x2b, 0x3, 0x2b, 0x3, 
    0x2b, 0x3, 0x2b, 0x3, 0x2c, 0x3, 0x2c, 0x3, 0x2c, 0x3, 0x2c, 0x3, 0x2c, 
    0x3, 0x2c, 0x3, 0x2d, 0x3, 0x2d, 0x3, 0x2d, 0x3, 0x2d, 0x3, 0x2d, 0x7, 
    0x2d, 0x276, 0xa, 0x2d, 0xc, 0x2d, 0xe, 0x2d, 0x279, 0xb, 0x2d, 0x3, 
    0x2d, 0x5, 0x2d, 0x27c, 0xa, 0x2d, 0x3, 0x2e, 0x3, 0x2e, 0x3, 0x2e, 
    0x3, 0x2e, 0x3, 0x2f, 0x3, 0x2f, 0x5, 0x2f, 0x284, 0xa, 0x2f, 0x3, 0x2f, 
    0x3, 0x2f, 0x3, 0x30, 0x3, 0x30, 0x3, 0x30, 0x3, 0x30, 0x3, 0x30, 0x3, 
    0x30, 0x3, 0x30, 0x3, 0x30, 0x7, 0x30, 0x290, 0xa, 0x30, 0xc, 0x30, 
    0xe, 0x30, 0x293, 0xb, 0x30, 0x3, 0x30, 0x3, 0x30, 0x3, 0x31, 0x3, 0x31, 
    0x3, 0x31, 0x3, 0x31, 0x3, 0x31, 0x3, 0x31, 0x3, 0x31, 0x5, 0x31, 0x29e, 
    0xa, 0x31, 0x3, 0x31, 0x3, 0x31, 0x5, 0x31, 0x2a2, 0xa, 0x31, 0x3, 0x32, 
    0x3, 0x32, 0x6, 0x32, 0x2a6, 0xa, 0x32, 0xd, 0x32, 0xe, 0x32, 0x2a7, 
    0x3, 0x32, 0x3, 0x32, 0x5, 0x32, 0x2ac, 0xa, 0x32, 0x3, 0x32, 0x3, 0x32, 
    0x5, 0x32, 0x2b0, 0xa, 0x32, 0x3, 0x33, 0x3, 0x33, 0x3, 0x34, 0x3, 0x34, 
    0x3, 0x34, 0x3, 0x34, 0x3, 0x34, 0x5, 0x34, 0x2b9, 0xa, 0x34, 0x5, 0x34, 
    0x2bb, 0xa, 0x34, 0x3, 0x35, 0x3, 0x35, 0x3, 0x35, 0x5, 0x35, 0x2c0, 
    0xa, 0x35, 0x3, 0x35, 0x3, 0x35, 0x3, 0x35, 0x5, 0x35, 0x2c5, 0xa, 0x35, 
    0x3, 0x35, 0x3, 0x35, 0x3, 0x35, 0x5, 0x35, 0x2ca, 0xa, 0x35, 0x3, 0x36, 
    0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 
    0x36, 0x3, 0x36, 0x5, 0x36, 0x2d5, 0xa, 0x36, 0x3, 0x36, 0x3, 0x36, 
    0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 
    0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 
    0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 
    0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 
    0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 
    0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x7, 0x36, 0x2fd, 0xa, 0x36, 
    0xc, 0x36, 0xe, 0x36, 0x300, 0xb, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 
    0x3, 0x36, 0x7, 0x36, 0x306, 0xa, 0x36, 0xc, 0x36, 0xe, 0x36, 0x309, 
    0xb, 0x36, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 
    0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 
    0x3, 0x37, 0x7, 0x37, 0x318, 0xa, 0x37, 0xc, 0x37, 0xe, 0x37, 0x31b, 
    0xb, 0x37, 0x3, 0x37, 0x5, 0x37, 0x31e, 0xa, 0x37, 0x5, 0x37, 0x320, 
    0xa, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 0x5, 
    0x37, 0x327, 0xa, 0x37, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x7, 0x38, 
    0x32c, 0xa, 0x38, 0xc, 0x38, 0xe, 0x38, 0x32f, 0xb, 0x38, 0x3, 0x38, 
    0x5, 0x38, 0x332, 0xa, 0x38, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x5, 0x39, 
    0x337, 0xa, 0x39, 0x3, 0x39, 0x6, 0x39, 0x33a, 0xa, 0x39, 0xd, 0x39, 
    0xe, 0x39, 0x33b, 0x3, 0x39, 0x3, 0x39, 0x7, 0x39, 0x340, 0xa, 0x39, 
    0xc, 0x39, 0xe, 0x39, 0x343, 0xb, 0x39, 0x3, 0x39, 0x3, 0x39, 0x6, 0x39, 
    0x347, 0xa, 0x39, 0xd, 0x39, 0xe, 0x39, 0x348, 0x3, 0x39, 0x5, 0x39, 
    0x34c, 0xa, 0x39, 0x3, 0x3a, 0x3, 0x3a, 0x3, 0x3a, 0x3, 0x3a, 0x3, 0x3b, 
    0x3, 0x3b, 0x3, 0x3b, 0x5, 0x3b, 0x355, 0xa, 0x3b, 0x5, 0x3b, 0x357, 
    0xa, 0x3b, 0x3, 0x3b, 0x3, 0x3b, 0x5, 0x3b, 0x35b, 0xa, 0x3b, 0x5, 0x3b, 
    0x35d, 0xa, 0x3b, 0x3, 0x3c, 0x3, 0x3c, 0x3, 0x3c, 0x3, 0x3c, 0x7, 0x3c, 
    0x363, 0xa, 0x3c, 0xc, 0x3c, 0xe, 0x3c, 0x366, 0xb, 0x3c, 0x3, 0x3c, 
    0x5, 0x3c, 0x369, 0xa, 0x3c, 0x5, 0x3c, 0x36b, 0xa, 0x3c, 0x3, 0x3c, 
    0x3, 0x3c, 0x3, 0x3d, 0x3, 0x3d, 0x3, 0x3d, 0x5, 0x3d, 0x372, 0xa, 0x3d, 
    0x3, 0x3d, 0x3, 0x3d, 0x3, 0x3e, 0x3, 0x3e, 0x3, 0x3f, 0x3, 0x3f, 0x3, 
    0x3f, 0x2, 0x3, 0x6a, 0x40, 0x2, 0x4, 0x6, 0x8, 0xa, 0xc, 0xe, 0x10, 
    0x12, 0x14, 0x16, 0x18, 0x1a, 0x1c, 0x1e, 0x20, 0x22, 0x24, 0x26, 0x28, 
    0x2a, 0x2c, 0x2e, 0x30, 0x32, 0x34, 0x36, 0x38, 0x3a, 0x3c, 0x3e, 0x40, 
    0x42, 0x44, 0x46, 0x48, 0x4a, 0x4c, 0x4e, 0x50, 0x52, 0x54, 0x56, 0x58, 
    0x5a, 0x5c, 0x5e, 0x60, 0x62, 0x64, 0x66, 0x68, 0x6a, 0x6c, 0x6e, 0x70, 
    0x72, 0x74, 0x76, 0x78, 0x7a, 0x7c, 0x2, 0xf, 0x3, 0x2, 0x3, 0x4, 0x3, 
    0x2, 0x3a, 0x3b, 0x3, 0x2, 0x57, 0x58, 0x3, 0x2, 0x25, 0x27, 0x3, 0x2, 
    0x50, 0x51, 0x3, 0x2, 0x4a, 0x4e, 0x4, 0x2, 0x49, 0x49, 0x55, 0x56, 
    0x4, 0x2, 0x52, 0x53, 0x57, 0x5a, 0x3, 0x2, 0x55, 0x56, 0x3, 0x2, 0x43, 
    0x46, 0x3, 0x2, 0x41, 0x42, 0x5, 0x2, 0x23, 0x24, 0x2c, 0x2e, 0x30, 
    0x31, 0x4, 0x2, 0x28, 0x2b, 0x33, 0x33, 0x2, 0x3d4, 0x2, 0x81, 0x3, 
    0x2, 0x2, 0x2, 0x4, 0xa5, 0x3, 0x2, 0x2, 0x2, 0x6, 0xbc, 0x3, 0x2, 0x2, 
    0x2, 0x8, 0xbe, 0x3, 0x2, 0x2, 0x2, 0xa, 0xc7, 0x3, 0x2, 0x2, 0x2, 0xc, 
    0xd2, 0x3, 0x2, 0x2, 0x2, 0xe, 0xdd, 0x3, 0x2, 0x2, 0x2, 0x10, 0xeb, 
    0x3, 0x2, 0x2, 0x2, 0x12, 0xed, 0x3, 0x2, 0x2, 0x2, 0x14, 0xfd, 0x3, 
    0x2, 0x2, 0x2, 0x16, 0x113, 0x3, 0x2, 0x2, 0x2, 0x18, 0x12e, 0x3, 0x2, 
    0x2, 0x2, 0x1a, 0x135, 0x3, 0x2, 0x2, 0x2, 0x1c, 0x137, 0x3, 0x2, 0x2, 
    0x2, 0x1e, 0x157, 0x3, 0x2, 0x2, 0x2, 0x20, 0x159, 0x3, 0x2, 0x2, 0x2, 
    0x22, 0x167, 0x3, 0x2, 0x2, 0x2, 0x24, 0x17a, 0x3, 0x2, 0x2, 0x2, 0x26, 
    0x183, 0x3, 0x2, 0x2, 0x2, 0x28, 0x189, 0x3, 0x2, 0x2, 0x2, 0x2a, 0x192, 
    0x3, 0x2, 0x2, 0x2, 0x2c, 0x1a4, 0x3, 0x2, 0x2, 0x2, 0x2e, 0x1a8, 0x3, 
    0x2, 0x2, 0x2, 0x30, 0x1aa, 0x3, 0x2, 0x2, 0x2, 0x32, 0x1c2, 0x3, 0x2, 
    0x2, 0x2, 0x34, 0x1c4, 0x3, 0x2, 0x2, 0x2, 0x36, 0x1c8, 0x3, 0x2, 0x2, 
    0x2, 0x38, 0x1d0, 0x3, 0x2, 0x2, 0x2, 0x3a, 0x1d2, 0x3, 0x2, 0x2, 0x2, 
    0x3c, 0x1e0, 0x3, 0x2, 0x2, 0x2, 0x3e, 0x1e2, 0x3, 0x2, 0x2, 0x2, 0x40, 
    0x1e8, 0x3, 0x2, 0x2, 0x2, 0x42, 0x1ef, 0x3, 0x2, 0x2, 0x2, 0x44, 0x210, 
    0x3, 0x2, 0x2, 0x2, 0x46, 0x21c, 0x3, 0x2, 0x2, 0x2, 0x48, 0x21e, 0x3, 
    0x2, 0x2, 0x2, 0x4a, 0x226, 0x3, 0x2, 0x2, 0x2, 0x4c, 0x243, 0x3, 0x2, 
    0x2, 0x2, 0x4e, 0x24c, 0x3, 0x2, 0x2, 0x2, 0x50, 0x258, 0x3, 0x2, 0x2, 
    0x2, 0x52, 0x261, 0x3, 0x2, 0x2, 0x2, 0x54, 0x264, 0x3, 0x2, 0x2, 0x2, 
    0x56, 0x26a, 0x3, 0x2, 0x2, 0x2, 0x58, 0x270, 0x3, 0x2, 0x2, 0x2, 0x5a, 
    0x27d, 0x3, 0x2, 0x2, 0x2, 0x5c, 0x281, 0x3, 0x2, 0x2, 0x2, 0x5e, 0x287, 
    0x3, 0x2, 0x2, 0x2, 0x60, 0x2a1, 0x3, 0x2, 0x2, 0x2, 0x62, 0x2af, 0x3, 
    0x2, 0x2, 0x2, 0x64, 0x2b1, 0x3, 0x2, 0x2, 0x2, 0x66, 0x2ba, 0x3, 0x2, 
    0x2, 0x2, 0x68, 0x2bc, 0x3, 0x2, 0x2, 0x2, 0x6a, 0x2d4, 0x3, 0x2, 0x2, 
    0x2, 0x6c, 0x326, 0x3, 0x2, 0x2, 0x2, 0x6e, 0x328, 0x3, 0x2, 0x2, 0x2, 
    0x70, 0x333, 0x3, 0x2, 0x2, 0x2, 0x72, 0x34d, 0x3, 0x2, 0x2, 0x2, 0x74, 
    0x35c, 0x3, 0x2, 0x2, 0x2, 0x76, 0x35e, 0x3, 0x2, 0x2, 0x2, 0x78, 0x371, 
    0x3, 0x2, 0x2, 0x2, 0x7a, 0x375, 0x3, 0x2, 0x2, 0x2, 0x7c, 0x377, 0x3, 
    0x2, 0x2, 0x2, 0x7e, 0x80, 0x5, 0x4, 0x3, 0x2, 0x7f, 0x7e, 0x3, 0x2, 
    0x2, 0x2, 0x80, 0x83, 0x3, 0x2, 0x2, 0x2, 0x81, 0x7f, 0x3, 0x2, 0x2, 
    0x2, 0x81, 0x82, 0x3, 0x2, 0x2, 0x2, 0x82, 0x84, 0x3, 0x2, 0x2, 0x2, 
    0x83, 0x81, 0x3, 0x2, 0x2, 0x2, 0x84, 0x85, 0x7, 0x2, 0x2, 0x3, 0x85, 
    0x3, 0x3, 0x2, 0x2, 0x2, 0x86, 0xa6, 0x5, 0x8, 0x5, 0x2, 0x87, 0xa6, 
    0x7, 0x3a, 0x2, 0x2, 0x88, 0x89, 0x5, 0xa, 0x6, 0x2, 0x89, 0x8a, 0x7, 
    0x3a, 0x2, 0x2, 0x8a, 0xa6, 0x3, 0x2, 0x2, 0x2, 0x8b, 0x8c, 0x5, 0xc, 
    0x7, 0x2, 0x8c, 0x8d, 0x7, 0x3a, 0x2, 0x2, 0x8d, 0xa6, 0x3, 0x2, 0x2, 
    0x2, 0x8e, 0xa6, 0x5, 0x14, 0xb, 0x2, 0x8f, 0xa6, 0x5, 0x18, 0xd, 0x2, 
    0x90, 0xa6, 0x5, 0x20, 0x11, 0x2, 0x91, 0xa6, 0x5, 0x22, 0x12, 0x2, 
    0x92, 0x93, 0x5, 0x24, 0x13, 0x2, 0x93, 0x94, 0x7, 0x3a, 0x2, 0x2, 0x94, 
    0xa6, 0x3, 0x2, 0x2, 0x2, 0x95, 0xa6, 0x5, 0x26, 0x14, 0x2, 0x96, 0xa6, 
    0x5, 0x3a, 0x1e, 0x2, 0x97, 0xa6, 0x5, 0x3e, 0x20, 0x2, 0x98, 0x99, 
    0x5, 0x40, 0x21, 0x2, 0x99, 0x9a, 0x7, 0x3a, 0x2, 0x2, 0x9a, 0xa6, 0x3, 
    0x2, 0x2, 0x2, 0x9b, 0xa6, 0x5, 0x42, 0x22, 0x2, 0x9c, 0xa6, 0x5, 0x4a, 
    0x26, 0x2, 0x9d, 0xa6, 0x5, 0x4e, 0x28, 0x2, 0x9e, 0xa6, 0x5, 0x52, 
    0x2a, 0x2, 0x9f, 0xa6, 0x5, 0x54, 0x2b, 0x2, 0xa0, 0xa6, 0x5, 0x56, 
    0x2c, 0x2, 0xa1, 0xa6, 0x5, 0x5a, 0x2e, 0x2, 0xa2, 0xa6, 0x5, 0x5c, 
    0x2f, 0x2, 0xa3, 0xa6, 0x5, 0x5e, 0x30, 0x2, 0xa4, 0xa6, 0x5, 0x6, 0x4, 
    0x2, 0xa5, 0x86, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x87, 0x3, 0x2, 0x2, 0x2, 
    0xa5, 0x88, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x8b, 0x3, 0x2, 0x2, 0x2, 0xa5, 
    0x8e, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x8f, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x90, 
    0x3, 0x2, 0x2, 0x2, 0xa5, 0x91, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x92, 0x3, 
    0x2, 0x2, 0x2, 0xa5, 0x95, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x96, 0x3, 0x2, 
    0x2, 0x2, 0xa5, 0x97, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x98, 0x3, 0x2, 0x2, 
    0x2, 0xa5, 0x9b, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x9c, 0x3, 0x2, 0x2, 0x2, 
    0xa5, 0x9d, 0x3, 0x2, 0x2, 0x2, 0xa5, 0x9e, 0x3, 0x2, 0x2, 0x2, 0xa5, 
    0x9f, 0x3, 0x2, 0x2, 0x2, 0xa5, 0xa0, 0x3, 0x2, 0x2, 0x2, 0xa5, 0xa1, 
    0x3, 0x2, 0x2, 0x2, 0xa5, 0xa2, 0x3, 0x2, 0x2, 0x2, 0xa5, 0xa3, 0x3, 
    0x2, 0x2, 0x2, 0xa5, 0xa4, 0x3, 0x2, 0x2, 0x2, 0xa6, 0x5, 0x3, 0x2, 
    0x2, 0x2, 0xa7, 0xa8, 0x5, 0x60, 0x31, 0x2, 0xa8, 0xa9, 0x7, 0x3a, 0x2, 
    0x2, 0xa9, 0xbd, 0x3, 0x2, 0x2, 0x2, 0xaa, 0xab, 0x5, 0x58, 0x2d, 0x2, 
    0xab, 0xac, 0x7, 0x3a, 0x2, 0x2, 0xac, 0xbd, 0x3, 0x2, 0x2, 0x2, 0xad, 
    0xae, 0x7, 0x15, 0x2, 0x2, 0xae, 0xbd, 0x7, 0x3a, 0x2, 0x2, 0xaf, 0xb0, 
    0x7, 0x16, 0x2, 0x2, 0xb0, 0xbd, 0x7, 0x3a, 0x2, 0x2, 0xb1, 0xb2, 0x7, 
    0x1c, 0x2, 0x2, 0xb2, 0xbd, 0x7, 0x3a, 0x2, 0x2, 0xb3, 0xb5, 0x7, 0x17, 
    0x2, 0x2, 0xb4, 0xb6, 0x5, 0x66, 0x34, 0x2, 0xb5, 0xb4, 0x3, 0x2, 0x2, 
    0x2, 0xb5, 0xb6, 0x3, 0x2, 0x2, 0x2, 0xb6, 0xb7, 0x3, 0x2, 0x2, 0x2, 
    0xb7, 0xbd, 0x7, 0x3a, 0x2, 0x2, 0xb8, 0xb9, 0x7, 0x1b, 0x2, 0x2, 0xb9, 
    0xba, 0x5, 0x66, 0x34, 0x2, 0xba, 0xbb, 0x7, 0x3a, 0x2, 0x2, 0xbb, 0xbd, 
    0x3, 0x2, 0x2, 0x2, 0xbc, 0xa7, 0x3, 0x2, 0x2, 0x2, 0xbc, 0xaa, 0x3, 
    0x2, 0x2, 0x2, 0xbc, 0xad, 0x3, 0x2, 0x2, 0x2, 0xbc, 0xaf, 0x3, 0x2, 
    0x2, 0x2, 0xbc, 0xb1, 0x3, 0x2, 0x2, 0x2, 0xbc, 0xb3, 0x3, 0x2, 0x2, 
    0x2, 0xbc, 0xb8, 0x3, 0x2, 0x2, 0x2, 0xbd, 0x7, 0x3, 0x2, 0x2, 0x2, 
    0xbe, 0xc2, 0x7, 0x34, 0x2, 0x2, 0xbf, 0xc1, 0x5, 0x4, 0x3, 0x2, 0xc0, 
    0xbf, 0x3, 0x2, 0x2, 0x2, 0xc1, 0xc4, 0x3, 0x2, 0x2, 0x2, 0xc2, 0xc0, 
    0x3, 0x2, 0x2, 0x2, 0xc2, 0xc3, 0x3, 0x2, 0x2, 0x2, 0xc3, 0xc5, 0x3, 
    0x2, 0x2, 0x2, 0xc4, 0xc2, 0x3, 0x2, 0x2, 0x2, 0xc5, 0xc6, 0x7, 0x35, 
    0x2, 0x2, 0xc6, 0x9, 0x3, 0x2, 0x2, 0x2, 0xc7, 0xc8, 0x9, 0x2, 0x2, 
    0x2, 0xc8, 0xcb, 0x5, 0x7c, 0x3f, 0x2, 0xc9, 0xca, 0x7, 0x3d, 0x2, 0x2, 
    0xca, 0xcc, 0x5, 0x2e, 0x18, 0x2, 0xcb, 0xc9, 0x3, 0x2, 0x2, 0x2, 0xcb, 
    0xcc, 0x3, 0x2, 0x2, 0x2, 0xcc, 0xcf, 0x3, 0x2, 0x2, 0x2, 0xcd, 0xce, 
    0x7, 0x4f, 0x2, 0x2, 0xce, 0xd0, 0x5, 0x10, 0x9, 0x2, 0xcf, 0xcd, 0x3, 
    0x2, 0x2, 0x2, 0xcf, 0xd0, 0x3, 0x2, 0x2, 0x2, 0xd0, 0xb, 0x3, 0x2, 
    0x2, 0x2, 0xd1, 0xd3, 0x7, 0x9, 0x2, 0x2, 0xd2, 0xd1, 0x3, 0x2, 0x2, 
    0x2, 0xd2, 0xd3, 0x3, 0x2, 0x2, 0x2, 0xd3, 0xd4, 0x3, 0x2, 0x2, 0x2, 
    0xd4, 0xd5, 0x5, 0x28, 0x15, 0x2, 0xd5, 0xda, 0x5, 0xe, 0x8, 0x2, 0xd6, 
    0xd7, 0x7, 0x3b, 0x2, 0x2, 0xd7, 0xd9, 0x5, 0xe, 0x8, 0x2, 0xd8, 0xd6, 
    0x3, 0x2, 0x2, 0x2, 0xd9, 0xdc, 0x3, 0x2, 0x2, 0x2, 0xda, 0xd8, 0x3, 
    0x2, 0x2, 0x2, 0xda, 0xdb, 0x3, 0x2, 0x2, 0x2, 0xdb, 0xd, 0x3, 0x2, 
    0x2, 0x2, 0xdc, 0xda, 0x3, 0x2, 0x2, 0x2, 0xdd, 0xe2, 0x5, 0x7c, 0x3f, 
    0x2, 0xde, 0xdf, 0x7, 0x38, 0x2, 0x2, 0xdf, 0xe1, 0x7, 0x39, 0x2, 0x2, 
    0xe0, 0xde, 0x3, 0x2, 0x2, 0x2, 0xe1, 0xe4, 0x3, 0x2, 0x2, 0x2, 0xe2, 
    0xe0, 0x3, 0x2, 0x2, 0x2, 0xe2, 0xe3, 0x3, 0x2, 0x2, 0x2, 0xe3, 0xe7, 
    0x3, 0x2, 0x2, 0x2, 0xe4, 0xe2, 0x3, 0x2, 0x2, 0x2, 0xe5, 0xe6, 0x7, 
    0x4f, 0x2, 0x2, 0xe6, 0xe8, 0x5, 0x10, 0x9, 0x2, 0xe7, 0xe5, 0x3, 0x2, 
    0x2, 0x2, 0xe7, 0xe8, 0x3, 0x2, 0x2, 0x2, 0xe8, 0xf, 0x3, 0x2, 0x2, 
    0x2, 0xe9, 0xec, 0x5, 0x66, 0x34, 0x2, 0xea, 0xec, 0x5, 0x12, 0xa, 0x2, 
    0xeb, 0xe9, 0x3, 0x2, 0x2, 0x2, 0xeb, 0xea, 0x3, 0x2, 0x2, 0x2, 0xec, 
    0x11, 0x3, 0x2, 0x2, 0x2, 0xed, 0xf9, 0x7, 0x34, 0x2, 0x2, 0xee, 0xf3, 
    0x5, 0x10, 0x9, 0x2, 0xef, 0xf0, 0x7, 0x3b, 0x2, 0x2, 0xf0, 0xf2, 0x5, 
    0x10, 0x9, 0x2, 0xf1, 0xef, 0x3, 0x2, 0x2, 0x2, 0xf2, 0xf5, 0x3, 0x2, 
    0x2, 0x2, 0xf3, 0xf1, 0x3, 0x2, 0x2, 0x2, 0xf3, 0xf4, 0x3, 0x2, 0x2, 
    0x2, 0xf4, 0xf7, 0x3, 0x2, 0x2, 0x2, 0xf5, 0xf3, 0x3, 0x2, 0x2, 0x2, 
    0xf6, 0xf8, 0x7, 0x3b, 0x2, 0x2, 0xf7, 0xf6, 0x3, 0x2, 0x2, 0x2, 0xf7, 
    0xf8, 0x3, 0x2, 0x2, 0x2, 0xf8, 0xfa, 0x3, 0x2, 0x2, 0x2, 0xf9, 0xee, 
    0x3, 0x2, 0x2, 0x2, 0xf9, 0xfa, 0x3, 0x2, 0x2, 0x2, 0xfa, 0xfb, 0x3, 
    0x2, 0x2, 0x2, 0xfb, 0xfc, 0x7, 0x35, 0x2, 0x2, 0xfc, 0x13, 0x3, 0x2, 
    0x2, 0x2, 0xfd, 0xfe, 0x5, 0x36, 0x1c, 0x2, 0xfe, 0xff, 0x5, 0x7c, 0x3f, 
    0x2, 0xff, 0x103, 0x7, 0x34, 0x2, 0x2, 0x100, 0x102, 0x5, 0x16, 0xc, 
    0x2, 0x101, 0x100, 0x3, 0x2, 0x2, 0x2, 0x102, 0x105, 0x3, 0x2, 0x2, 
    0x2, 0x103, 0x101, 0x3, 0x2, 0x2, 0x2, 0x103, 0x104, 0x3, 0x2, 0x2, 
    0x2, 0x104, 0x106, 0x3, 0x2, 0x2, 0x2, 0x105, 0x103, 0x3, 0x2, 0x2, 
    0x2, 0x106, 0x107, 0x7, 0x35, 0x2, 0x2, 0x107, 0x15, 0x3, 0x2, 0x2, 
    0x2, 0x108, 0x109, 0x5, 0x7c, 0x3f, 0x2, 0x109, 0x10a, 0x7, 0x3d, 0x2, 
    0x2, 0x10a, 0x10b, 0x5, 0x66, 0x34, 0x2, 0x10b, 0x10c, 0x9, 0x3, 0x2, 
    0x2, 0x10c, 0x114, 0x3, 0x2, 0x2, 0x2, 0x10d, 0x10e, 0x5, 0x7c, 0x3f, 
    0x2, 0x10e, 0x10f, 0x5, 0x7c, 0x3f, 0x2, 0x10f, 0x110, 0x5, 0x76, 0x3c, 
    0x2, 0x110, 0x111, 0x7, 0x3a, 0x2, 0x2, 0x111, 0x114, 0x3, 0x2, 0x2, 
    0x2, 0x112, 0x114, 0x7, 0x3a, 0x2, 0x2, 0x113, 0x108, 0x3, 0x2, 0x2, 
    0x2, 0x113, 0x10d, 0x3, 0x2, 0x2, 0x2, 0x113, 0x112, 0x3, 0x2, 0x2, 
    0x2, 0x114, 0x17, 0x3, 0x2, 0x2, 0x2, 0x115, 0x116, 0x7, 0x5, 0x2, 0x2, 
    0x116, 0x117, 0x5, 0x7c, 0x3f, 0x2, 0x117, 0x119, 0x7, 0x36, 0x2, 0x2, 
    0x118, 0x11a, 0x5, 0x1c, 0xf, 0x2, 0x119, 0x118, 0x3, 0x2, 0x2, 0x2, 
    0x119, 0x11a, 0x3, 0x2, 0x2, 0x2, 0x11a, 0x11b, 0x3, 0x2, 0x2, 0x2, 
    0x11b, 0x11e, 0x7, 0x37, 0x2, 0x2, 0x11c, 0x11d, 0x7, 0x3f, 0x2, 0x2, 
    0x11d, 0x11f, 0x5, 0x2c, 0x17, 0x2, 0x11e, 0x11c, 0x3, 0x2, 0x2, 0x2, 
    0x11e, 0x11f, 0x3, 0x2, 0x2, 0x2, 0x11f, 0x120, 0x3, 0x2, 0x2, 0x2, 
    0x120, 0x121, 0x5, 0x1a, 0xe, 0x2, 0x121, 0x12f, 0x3, 0x2, 0x2, 0x2, 
    0x122, 0x125, 0x5, 0x28, 0x15, 0x2, 0x123, 0x125, 0x7, 0xa, 0x2, 0x2, 
    0x124, 0x122, 0x3, 0x2, 0x2, 0x2, 0x124, 0x123, 0x3, 0x2, 0x2, 0x2, 
    0x125, 0x126, 0x3, 0x2, 0x2, 0x2, 0x126, 0x127, 0x5, 0x7c, 0x3f, 0x2, 
    0x127, 0x129, 0x7, 0x36, 0x2, 0x2, 0x128, 0x12a, 0x5, 0x1c, 0xf, 0x2, 
    0x129, 0x128, 0x3, 0x2, 0x2, 0x2, 0x129, 0x12a, 0x3, 0x2, 0x2, 0x2, 
    0x12a, 0x12b, 0x3, 0x2, 0x2, 0x2, 0x12b, 0x12c, 0x7, 0x37, 0x2, 0x2, 
    0x12c, 0x12d, 0x5, 0x8, 0x5, 0x2, 0x12d, 0x12f, 0x3, 0x2, 0x2, 0x2, 
    0x12e, 0x115, 0x3, 0x2, 0x2, 0x2, 0x12e, 0x124, 0x3, 0x2, 0x2, 0x2, 
    0x12f, 0x19, 0x3, 0x2, 0x2, 0x2, 0x130, 0x136, 0x5, 0x8, 0x5, 0x2, 0x131, 
    0x132, 0x7, 0x40, 0x2, 0x2, 0x132, 0x133, 0x5, 0x66, 0x34, 0x2, 0x133, 
    0x134, 0x7, 0x3a, 0x2, 0x2, 0x134, 0x136, 0x3, 0x2, 0x2, 0x2, 0x135, 
    0x130, 0x3, 0x2, 0x2, 0x2, 0x135, 0x131, 0x3, 0x2, 0x2, 0x2, 0x136, 
    0x1b, 0x3, 0x2, 0x2, 0x2, 0x137, 0x13c, 0x5, 0x1e, 0x10, 0x2, 0x138, 
    0x139, 0x7, 0x3b, 0x2, 0x2, 0x139, 0x13b, 0x5, 0x1e, 0x10, 0x2, 0x13a, 
    0x138, 0x3, 0x2, 0x2, 0x2, 0x13b, 0x13e, 0x3, 0x2, 0x2, 0x2, 0x13c, 
    0x13a, 0x3, 0x2, 0x2, 0x2, 0x13c, 0x13d, 0x3, 0x2, 0x2, 0x2, 0x13d, 
    0x140, 0x3, 0x2, 0x2, 0x2, 0x13e, 0x13c, 0x3, 0x2, 0x2, 0x2, 0x13f, 
    0x141, 0x7, 0x3b, 0x2, 0x2, 0x140, 0x13f, 0x3, 0x2, 0x2, 0x2, 0x140, 
    0x141, 0x3, 0x2, 0x2, 0x2, 0x141, 0x1d, 0x3, 0x2, 0x2, 0x2, 0x142, 0x145, 
    0x5, 0x7c, 0x3f, 0x2, 0x143, 0x144, 0x7, 0x3d, 0x2, 0x2, 0x144, 0x146, 
    0x5, 0x2e, 0x18, 0x2, 0x145, 0x143, 0x3, 0x2, 0x2, 0x2, 0x145, 0x146, 
    0x3, 0x2, 0x2, 0x2, 0x146, 0x149, 0x3, 0x2, 0x2, 0x2, 0x147, 0x148, 
    0x7, 0x4f, 0x2, 0x2, 0x148, 0x14a, 0x5, 0x66, 0x34, 0x2, 0x149, 0x147, 
    0x3, 0x2, 0x2, 0x2, 0x149, 0x14a, 0x3, 0x2, 0x2, 0x2, 0x14a, 0x158, 
    0x3, 0x2, 0x2, 0x2, 0x14b, 0x14d, 0x7, 0x9, 0x2, 0x2, 0x14c, 0x14b, 
    0x3, 0x2, 0x2, 0x2, 0x14c, 0x14d, 0x3, 0x2, 0x2, 0x2, 0x14d, 0x14e, 
    0x3, 0x2, 0x2, 0x2, 0x14e, 0x14f, 0x5, 0x28, 0x15, 0x2, 0x14f, 0x154, 
    0x5, 0x7c, 0x3f, 0x2, 0x150, 0x151, 0x7, 0x38, 0x2, 0x2, 0x151, 0x153, 
    0x7, 0x39, 0x2, 0x2, 0x152, 0x150, 0x3, 0x2, 0x2, 0x2, 0x153, 0x156, 
    0x3, 0x2, 0x2, 0x2, 0x154, 0x152, 0x3, 0x2, 0x2, 0x2, 0x154, 0x155, 
    0x3, 0x2, 0x2, 0x2, 0x155, 0x158, 0x3, 0x2, 0x2, 0x2, 0x156, 0x154, 
    0x3, 0x2, 0x2, 0x2, 0x157, 0x142, 0x3, 0x2, 0x2, 0x2, 0x157, 0x14c, 
    0x3, 0x2, 0x2, 0x2, 0x158, 0x1f, 0x3, 0x2, 0x2, 0x2, 0x159, 0x15a, 0x7, 
    0x6, 0x2, 0x2, 0x15a, 0x15b, 0x5, 0x7c, 0x3f, 0x2, 0x15b, 0x162, 0x7, 
    0x34, 0x2, 0x2, 0x15c, 0x15d, 0x5, 0x1e, 0x10, 0x2, 0x15d, 0x15e, 0x9, 
    0x3, 0x2, 0x2, 0x15e, 0x161, 0x3, 0x2, 0x2, 0x2, 0x15f, 0x161, 0x7, 
    0x3a, 0x2, 0x2, 0x160, 0x15c, 0x3, 0x2, 0x2, 0x2, 0x160, 0x15f, 0x3, 
    0x2, 0x2, 0x2, 0x161, 0x164, 0x3, 0x2, 0x2, 0x2, 0x162, 0x160, 0x3, 
    0x2, 0x2, 0x2, 0x162, 0x163, 0x3, 0x2, 0x2, 0x2, 0x163, 0x165, 0x3, 
    0x2, 0x2, 0x2, 0x164, 0x162, 0x3, 0x2, 0x2, 0x2, 0x165, 0x166, 0x7, 
    0x35, 0x2, 0x2, 0x166, 0x21, 0x3, 0x2, 0x2, 0x2, 0x167, 0x168, 0x7, 
    0x7, 0x2, 0x2, 0x168, 0x169, 0x5, 0x7c, 0x3f, 0x2, 0x169, 0x16a, 0x7, 
    0x34, 0x2, 0x2, 0x16a, 0x16f, 0x5, 0x7c, 0x3f, 0x2, 0x16b, 0x16c, 0x9, 
    0x3, 0x2, 0x2, 0x16c, 0x16e, 0x5, 0x7c, 0x3f, 0x2, 0x16d, 0x16b, 0x3, 
    0x2, 0x2, 0x2, 0x16e, 0x171, 0x3, 0x2, 0x2, 0x2, 0x16f, 0x16d, 0x3, 
    0x2, 0x2, 0x2, 0x16f, 0x170, 0x3, 0x2, 0x2, 0x2, 0x170, 0x175, 0x3, 
    0x2, 0x2, 0x2, 0x171, 0x16f, 0x3, 0x2, 0x2, 0x2, 0x172, 0x174, 0x9, 
    0x3, 0x2, 0x2, 0x173, 0x172, 0x3, 0x2, 0x2, 0x2, 0x174, 0x177, 0x3, 
    0x2, 0x2, 0x2, 0x175, 0x173, 0x3, 0x2, 0x2, 0x2, 0x175, 0x176, 0x3, 
    0x2, 0x2, 0x2, 0x176, 0x178, 0x3, 0x2, 0x2, 0x2, 0x177, 0x175, 0x3, 
    0x2, 0x2, 0x2, 0x178, 0x179, 0x7, 0x35, 0x2, 0x2, 0x179, 0x23, 0x3, 
    0x2, 0x2, 0x2, 0x17a, 0x17d, 0x7, 0x8, 0x2, 0x2, 0x17b, 0x17e, 0x7, 
    0x31, 0x2, 0x2, 0x17c, 0x17e, 0x5, 0x36, 0x1c, 0x2, 0x17d, 0x17b, 0x3, 
    0x2, 0x2, 0x2, 0x17d, 0x17c, 0x3, 0x2, 0x2, 0x2, 0x17e, 0x181, 0x3, 
    0x2, 0x2, 0x2, 0x17f, 0x180, 0x7, 0x2b, 0x2, 0x2, 0x180, 0x182, 0x5, 
    0x7c, 0x3f, 0x2, 0x181, 0x17f, 0x3, 0x2, 0x2, 0x2, 0x181, 0x182, 0x3, 
    0x2, 0x2, 0x2, 0x182, 0x25, 0x3, 0x2, 0x2, 0x2, 0x183, 0x184, 0x7, 0x28, 
    0x2, 0x2, 0x184, 0x185, 0x7, 0x31, 0x2, 0x2, 0x185, 0x186, 0x5, 0x8, 
    0x5, 0x2, 0x186, 0x27, 0x3, 0x2, 0x2, 0x2, 0x187, 0x18a, 0x5, 0x38, 
    0x1d, 0x2, 0x188, 0x18a, 0x5, 0x36, 0x1c, 0x2, 0x189, 0x187, 0x3, 0x2, 
    0x2, 0x2, 0x189, 0x188, 0x3, 0x2, 0x2, 0x2, 0x18a, 0x18f, 0x3, 0x2, 
    0x2, 0x2, 0x18b, 0x18c, 0x7, 0x38, 0x2, 0x2, 0x18c, 0x18e, 0x7, 0x39, 
    0x2, 0x2, 0x18d, 0x18b, 0x3, 0x2, 0x2, 0x2, 0x18e, 0x191, 0x3, 0x2, 
    0x2, 0x2, 0x18f, 0x18d, 0x3, 0x2, 0x2, 0x2, 0x18f, 0x190, 0x3, 0x2, 
    0x2, 0x2, 0x190, 0x29, 0x3, 0x2, 0x2, 0x2, 0x191, 0x18f, 0x3, 0x2, 0x2, 
    0x2, 0x192, 0x193, 0x7, 0x5, 0x2, 0x2, 0x193, 0x19c, 0x7, 0x36, 0x2, 
    0x2, 0x194, 0x199, 0x5, 0x2e, 0x18, 0x2, 0x195, 0x196, 0x7, 0x3b, 0x2, 
    0x2, 0x196, 0x198, 0x5, 0x2e, 0x18, 0x2, 0x197, 0x195, 0x3, 0x2, 0x2, 
    0x2, 0x198, 0x19b, 0x3, 0x2, 0x2, 0x2, 0x199, 0x197, 0x3, 0x2, 0x2, 
    0x2, 0x199, 0x19a, 0x3, 0x2, 0x2, 0x2, 0x19a, 0x19d, 0x3, 0x2, 0x2, 
    0x2, 0x19b, 0x199, 0x3, 0x2, 0x2, 0x2, 0x19c, 0x194, 0x3, 0x2, 0x2, 
    0x2, 0x19c, 0x19d, 0x3, 0x2, 0x2, 0x2, 0x19d, 0x19e, 0x3, 0x2, 0x2, 
    0x2, 0x19e, 0x19f, 0x7, 0x37, 0x2, 0x2, 0x19f, 0x1a0, 0x7, 0x3f, 0x2, 
    0x2, 0x1a0, 0x1a1, 0x5, 0x2c, 0x17, 0x2, 0x1a1, 0x2b, 0x3, 0x2, 0x2, 
    0x2, 0x1a2, 0x1a5, 0x5, 0x2e, 0x18, 0x2, 0x1a3, 0x1a5, 0x7, 0xa, 0x2, 
    0x2, 0x1a4, 0x1a2, 0x3, 0x2, 0x2, 0x2, 0x1a4, 0x1a3, 0x3, 0x2, 0x2, 
    0x2, 0x1a5, 0x2d, 0x3, 0x2, 0x2, 0x2, 0x1a6, 0x1a9, 0x5, 0x2a, 0x16, 
    0x2, 0x1a7, 0x1a9, 0x5, 0x30, 0x19, 0x2, 0x1a8, 0x1a6, 0x3, 0x2, 0x2, 
    0x2, 0x1a8, 0x1a7, 0x3, 0x2, 0x2, 0x2, 0x1a9, 0x2f, 0x3, 0x2, 0x2, 0x2, 
    0x1aa, 0x1af, 0x5, 0x32, 0x1a, 0x2, 0x1ab, 0x1ac, 0x9, 0x4, 0x2, 0x2, 
    0x1ac, 0x1ae, 0x5, 0x32, 0x1a, 0x2, 0x1ad, 0x1ab, 0x3, 0x2, 0x2, 0x2, 
    0x1ae, 0x1b1, 0x3, 0x2, 0x2, 0x2, 0x1af, 0x1ad, 0x3, 0x2, 0x2, 0x2, 
    0x1af, 0x1b0, 0x3, 0x2, 0x2, 0x2, 0x1b0, 0x31, 0x3, 0x2, 0x2, 0x2, 0x1b1, 
    0x1af, 0x3, 0x2, 0x2, 0x2, 0x1b2, 0x1b8, 0x5, 0x28, 0x15, 0x2, 0x1b3, 
    0x1b5, 0x7, 0x5b, 0x2, 0x2, 0x1b4, 0x1b6, 0x7, 0x56, 0x2, 0x2, 0x1b5, 
    0x1b4, 0x3, 0x2, 0x2, 0x2, 0x1b5, 0x1b6, 0x3, 0x2, 0x2, 0x2, 0x1b6, 
    0x1b7, 0x3, 0x2, 0x2, 0x2, 0x1b7, 0x1b9, 0x7, 0x2e, 0x2, 0x2, 0x1b8, 
    0x1b3, 0x3, 0x2, 0x2, 0x2, 0x1b8, 0x1b9, 0x3, 0x2, 0x2, 0x2, 0x1b9, 
    0x1c3, 0x3, 0x2, 0x2, 0x2, 0x1ba, 0x1bf, 0x5, 0x34, 0x1b, 0x2, 0x1bb, 
    0x1bc, 0x7, 0x38, 0x2, 0x2, 0x1bc, 0x1be, 0x7, 0x39, 0x2, 0x2, 0x1bd, 
    0x1bb, 0x3, 0x2, 0x2, 0x2, 0x1be, 0x1c1, 0x3, 0x2, 0x2, 0x2, 0x1bf, 
    0x1bd, 0x3, 0x2, 0x2, 0x2, 0x1bf, 0x1c0, 0x3, 0x2, 0x2, 0x2, 0x1c0, 
    0x1c3, 0x3, 0x2, 0x2, 0x2, 0x1c1, 0x1bf, 0x3, 0x2, 0x2, 0x2, 0x1c2, 
    0x1b2, 0x3, 0x2, 0x2, 0x2, 0x1c2, 0x1ba, 0x3, 0x2, 0x2, 0x2, 0x1c3, 
    0x33, 0x3, 0x2, 0x2, 0x2, 0x1c4, 0x1c5, 0x7, 0x36, 0x2, 0x2, 0x1c5, 
    0x1c6, 0x5, 0x2e, 0x18, 0x2, 0x1c6, 0x1c7, 0x7, 0x37, 0x2, 0x2, 0x1c7, 
    0x35, 0x3, 0x2, 0x2, 0x2, 0x1c8, 0x1cd, 0x5, 0x7c, 0x3f, 0x2, 0x1c9, 
    0x1ca, 0x7, 0x3c, 0x2, 0x2, 0x1ca, 0x1cc, 0x5, 0x7c, 0x3f, 0x2, 0x1cb, 
    0x1c9, 0x3, 0x2, 0x2, 0x2, 0x1cc, 0x1cf, 0x3, 0x2, 0x2, 0x2, 0x1cd, 
    0x1cb, 0x3, 0x2, 0x2, 0x2, 0x1cd, 0x1ce, 0x3, 0x2, 0x2, 0x2, 0x1ce, 
    0x37, 0x3, 0x2, 0x2, 0x2, 0x1cf, 0x1cd, 0x3, 0x2, 0x2, 0x2, 0x1d0, 0x1d1, 
    0x9, 0x5, 0x2, 0x2, 0x1d1, 0x39, 0x3, 0x2, 0x2, 0x2, 0x1d2, 0x1d3, 0x7, 
    0xc, 0x2, 0x2, 0x1d3, 0x1d4, 0x7, 0x36, 0x2, 0x2, 0x1d4, 0x1d5, 0x5, 
    0x66, 0x34, 0x2, 0x1d5, 0x1d6, 0x7, 0x37, 0x2, 0x2, 0x1d6, 0x1dc, 0x5, 
    0x3c, 0x1f, 0x2, 0x1d7, 0x1da, 0x7, 0xd, 0x2, 0x2, 0x1d8, 0x1db, 0x5, 
    0x3a, 0x1e, 0x2, 0x1d9, 0x1db, 0x5, 0x3c, 0x1f, 0x2, 0x1da, 0x1d8, 0x3, 
    0x2, 0x2, 0x2, 0x1da, 0x1d9, 0x3, 0x2, 0x2, 0x2, 0x1db, 0x1dd, 0x3, 
    0x2, 0x2, 0x2, 0x1dc, 0x1d7, 0x3, 0x2, 0x2, 0x2, 0x1dc, 0x1dd, 0x3, 
    0x2, 0x2, 0x2, 0x1dd, 0x3b, 0x3, 0x2, 0x2, 0x2, 0x1de, 0x1e1, 0x5, 0x8, 
    0x5, 0x2, 0x1df, 0x1e1, 0x5, 0x6, 0x4, 0x2, 0x1e0, 0x1de, 0x3, 0x2, 
    0x2, 0x2, 0x1e0, 0x1df, 0x3, 0x2, 0x2, 0x2, 0x1e1, 0x3d, 0x3, 0x2, 0x2, 
    0x2, 0x1e2, 0x1e3, 0x7, 0xe, 0x2, 0x2, 0x1e3, 0x1e4, 0x7, 0x36, 0x2, 
    0x2, 0x1e4, 0x1e5, 0x5, 0x66, 0x34, 0x2, 0x1e5, 0x1e6, 0x7, 0x37, 0x2, 
    0x2, 0x1e6, 0x1e7, 0x5, 0x4, 0x3, 0x2, 0x1e7, 0x3f, 0x3, 0x2, 0x2, 0x2, 
    0x1e8, 0x1e9, 0x7, 0xf, 0x2, 0x2, 0x1e9, 0x1ea, 0x5, 0x8, 0x5, 0x2, 
    0x1ea, 0x1eb, 0x7, 0xe, 0x2, 0x2, 0x1eb, 0x1ec, 0x7, 0x36, 0x2, 0x2, 
    0x1ec, 0x1ed, 0x5, 0x66, 0x34, 0x2, 0x1ed, 0x1ee, 0x7, 0x37, 0x2, 0x2, 
    0x1ee, 0x41, 0x3, 0x2, 0x2, 0x2, 0x1ef, 0x1f0, 0x7, 0x10, 0x2, 0x2, 
    0x1f0, 0x1f1, 0x7, 0x36, 0x2, 0x2, 0x1f1, 0x1f2, 0x5, 0x44, 0x23, 0x2, 
    0x1f2, 0x1f3, 0x7, 0x37, 0x2, 0x2, 0x1f3, 0x1f4, 0x5, 0x4, 0x3, 0x2, 
    0x1f4, 0x43, 0x3, 0x2, 0x2, 0x2, 0x1f5, 0x1f8, 0x5, 0x7c, 0x3f, 0x2, 
    0x1f6, 0x1f7, 0x7, 0x3b, 0x2, 0x2, 0x1f7, 0x1f9, 0x5, 0x7c, 0x3f, 0x2, 
    0x1f8, 0x1f6, 0x3, 0x2, 0x2, 0x2, 0x1f8, 0x1f9, 0x3, 0x2, 0x2, 0x2, 
    0x1f9, 0x1fa, 0x3, 0x2, 0x2, 0x2, 0x1fa, 0x1fb, 0x7, 0x11, 0x2, 0x2, 
    0x1fb, 0x1fc, 0x5, 0x66, 0x34, 0x2, 0x1fc, 0x211, 0x3, 0x2, 0x2, 0x2, 
    0x1fd, 0x1ff, 0x7, 0x9, 0x2, 0x2, 0x1fe, 0x1fd, 0x3, 0x2, 0x2, 0x2, 
    0x1fe, 0x1ff, 0x3, 0x2, 0x2, 0x2, 0x1ff, 0x200, 0x3, 0x2, 0x2, 0x2, 
    0x200, 0x201, 0x5, 0x28, 0x15, 0x2, 0x201, 0x202, 0x5, 0x7c, 0x3f, 0x2, 
    0x202, 0x203, 0x7, 0x3d, 0x2, 0x2, 0x203, 0x204, 0x5, 0x66, 0x34, 0x2, 
    0x204, 0x211, 0x3, 0x2, 0x2, 0x2, 0x205, 0x207, 0x5, 0x46, 0x24, 0x2, 
    0x206, 0x205, 0x3, 0x2, 0x2, 0x2, 0x206, 0x207, 0x3, 0x2, 0x2, 0x2, 
    0x207, 0x208, 0x3, 0x2, 0x2, 0x2, 0x208, 0x20a, 0x7, 0x3a, 0x2, 0x2, 
    0x209, 0x20b, 0x5, 0x66, 0x34, 0x2, 0x20a, 0x209, 0x3, 0x2, 0x2, 0x2, 
    0x20a, 0x20b, 0x3, 0x2, 0x2, 0x2, 0x20b, 0x20c, 0x3, 0x2, 0x2, 0x2, 
    0x20c, 0x20e, 0x7, 0x3a, 0x2, 0x2, 0x20d, 0x20f, 0x5, 0x48, 0x25, 0x2, 
    0x20e, 0x20d, 0x3, 0x2, 0x2, 0x2, 0x20e, 0x20f, 0x3, 0x2, 0x2, 0x2, 
    0x20f, 0x211, 0x3, 0x2, 0x2, 0x2, 0x210, 0x1f5, 0x3, 0x2, 0x2, 0x2, 
    0x210, 0x1fe, 0x3, 0x2, 0x2, 0x2, 0x210, 0x206, 0x3, 0x2, 0x2, 0x2, 
    0x211, 0x45, 0x3, 0x2, 0x2, 0x2, 0x212, 0x21d, 0x5, 0xc, 0x7, 0x2, 0x213, 
    0x21d, 0x5, 0xa, 0x6, 0x2, 0x214, 0x219, 0x5, 0x60, 0x31, 0x2, 0x215, 
    0x216, 0x7, 0x3b, 0x2, 0x2, 0x216, 0x218, 0x5, 0x60, 0x31, 0x2, 0x217, 
    0x215, 0x3, 0x2, 0x2, 0x2, 0x218, 0x21b, 0x3, 0x2, 0x2, 0x2, 0x219, 
    0x217, 0x3, 0x2, 0x2, 0x2, 0x219, 0x21a, 0x3, 0x2, 0x2, 0x2, 0x21a, 
    0x21d, 0x3, 0x2, 0x2, 0x2, 0x21b, 0x219, 0x3, 0x2, 0x2, 0x2, 0x21c, 
    0x212, 0x3, 0x2, 0x2, 0x2, 0x21c, 0x213, 0x3, 0x2, 0x2, 0x2, 0x21c, 
    0x214, 0x3, 0x2, 0x2, 0x2, 0x21d, 0x47, 0x3, 0x2, 0x2, 0x2, 0x21e, 0x223, 
    0x5, 0x60, 0x31, 0x2, 0x21f, 0x220, 0x7, 0x3b, 0x2, 0x2, 0x220, 0x222, 
    0x5, 0x60, 0x31, 0x2, 0x221, 0x21f, 0x3, 0x2, 0x2, 0x2, 0x222, 0x225, 
    0x3, 0x2, 0x2, 0x2, 0x223, 0x221, 0x3, 0x2, 0x2, 0x2, 0x223, 0x224, 
    0x3, 0x2, 0x2, 0x2, 0x224, 0x49, 0x3, 0x2, 0x2, 0x2, 0x225, 0x223, 0x3, 
    0x2, 0x2, 0x2, 0x226, 0x227, 0x7, 0x12, 0x2, 0x2, 0x227, 0x228, 0x7, 
    0x36, 0x2, 0x2, 0x228, 0x229, 0x5, 0x66, 0x34, 0x2, 0x229, 0x22a, 0x7, 
    0x37, 0x2, 0x2, 0x22a, 0x22e, 0x7, 0x34, 0x2, 0x2, 0x22b, 0x22d, 0x7, 
    0x3a, 0x2, 0x2, 0x22c, 0x22b, 0x3, 0x2, 0x2, 0x2, 0x22d, 0x230, 0x3, 
    0x2, 0x2, 0x2, 0x22e, 0x22c, 0x3, 0x2, 0x2, 0x2, 0x22e, 0x22f, 0x3, 
    0x2, 0x2, 0x2, 0x22f, 0x234, 0x3, 0x2, 0x2, 0x2, 0x230, 0x22e, 0x3, 
    0x2, 0x2, 0x2, 0x231, 0x233, 0x5, 0x4c, 0x27, 0x2, 0x232, 0x231, 0x3, 
    0x2, 0x2, 0x2, 0x233, 0x236, 0x3, 0x2, 0x2, 0x2, 0x234, 0x232, 0x3, 
    0x2, 0x2, 0x2, 0x234, 0x235, 0x3, 0x2, 0x2, 0x2, 0x235, 0x237, 0x3, 
    0x2, 0x2, 0x2, 0x236, 0x234, 0x3, 0x2, 0x2, 0x2, 0x237, 0x238, 0x7, 
    0x35, 0x2, 0x2, 0x238, 0x4b, 0x3, 0x2, 0x2, 0x2, 0x239, 0x23a, 0x7, 
    0x13, 0x2, 0x2, 0x23a, 0x23f, 0x5, 0x66, 0x34, 0x2, 0x23b, 0x23c, 0x7, 
    0x3b, 0x2, 0x2, 0x23c, 0x23e, 0x5, 0x66, 0x34, 0x2, 0x23d, 0x23b, 0x3, 
    0x2, 0x2, 0x2, 0x23e, 0x241, 0x3, 0x2, 0x2, 0x2, 0x23f, 0x23d, 0x3, 
    0x2, 0x2, 0x2, 0x23f, 0x240, 0x3, 0x2, 0x2, 0x2, 0x240, 0x244, 0x3, 
    0x2, 0x2, 0x2, 0x241, 0x23f, 0x3, 0x2, 0x2, 0x2, 0x242, 0x244, 0x7, 
    0x14, 0x2, 0x2, 0x243, 0x239, 0x3, 0x2, 0x2, 0x2, 0x243, 0x242, 0x3, 
    0x2, 0x2, 0x2, 0x244, 0x245, 0x3, 0x2, 0x2, 0x2, 0x245, 0x249, 0x7, 
    0x3d, 0x2, 0x2, 0x246, 0x248, 0x5, 0x4, 0x3, 0x2, 0x247, 0x246, 0x3, 
    0x2, 0x2, 0x2, 0x248, 0x24b, 0x3, 0x2, 0x2, 0x2, 0x249, 0x247, 0x3, 
    0x2, 0x2, 0x2, 0x249, 0x24a, 0x3, 0x2, 0x2, 0x2, 0x24a, 0x4d, 0x3, 0x2, 
    0x2, 0x2, 0x24b, 0x249, 0x3, 0x2, 0x2, 0x2, 0x24c, 0x24d, 0x7, 0x18, 
    0x2, 0x2, 0x24d, 0x251, 0x5, 0x8, 0x5, 0x2, 0x24e, 0x250, 0x5, 0x50, 
    0x29, 0x2, 0x24f, 0x24e, 0x3, 0x2, 0x2, 0x2, 0x250, 0x253, 0x3, 0x2, 
    0x2, 0x2, 0x251, 0x24f, 0x3, 0x2, 0x2, 0x2, 0x251, 0x252, 0x3, 0x2, 
    0x2, 0x2, 0x252, 0x256, 0x3, 0x2, 0x2, 0x2, 0x253, 0x251, 0x3, 0x2, 
    0x2, 0x2, 0x254, 0x255, 0x7, 0x1a, 0x2, 0x2, 0x255, 0x257, 0x5, 0x8, 
    0x5, 0x2, 0x256, 0x254, 0x3, 0x2, 0x2, 0x2, 0x256, 0x257, 0x3, 0x2, 
    0x2, 0x2, 0x257, 0x4f, 0x3, 0x2, 0x2, 0x2, 0x258, 0x25d, 0x7, 0x19, 
    0x2, 0x2, 0x259, 0x25a, 0x7, 0x36, 0x2, 0x2, 0x25a, 0x25b, 0x5, 0x1e, 
    0x10, 0x2, 0x25b, 0x25c, 0x7, 0x37, 0x2, 0x2, 0x25c, 0x25e, 0x3, 0x2, 
    0x2, 0x2, 0x25d, 0x259, 0x3, 0x2, 0x2, 0x2, 0x25d, 0x25e, 0x3, 0x2, 
    0x2, 0x2, 0x25e, 0x25f, 0x3, 0x2, 0x2, 0x2, 0x25f, 0x260, 0x5, 0x8, 
    0x5, 0x2, 0x260, 0x51, 0x3, 0x2, 0x2, 0x2, 0x261, 0x262, 0x7, 0x1d, 
    0x2, 0x2, 0x262, 0x263, 0x5, 0x8, 0x5, 0x2, 0x263, 0x53, 0x3, 0x2, 0x2, 
    0x2, 0x264, 0x265, 0x7, 0x1e, 0x2, 0x2, 0x265, 0x266, 0x7, 0x36, 0x2, 
    0x2, 0x266, 0x267, 0x5, 0x66, 0x34, 0x2, 0x267, 0x268, 0x7, 0x37, 0x2, 
    0x2, 0x268, 0x269, 0x5, 0x8, 0x5, 0x2, 0x269, 0x55, 0x3, 0x2, 0x2, 0x2, 
    0x26a, 0x26b, 0x7, 0x1f, 0x2, 0x2, 0x26b, 0x26c, 0x7, 0x36, 0x2, 0x2, 
    0x26c, 0x26d, 0x5, 0x66, 0x34, 0x2, 0x26d, 0x26e, 0x7, 0x37, 0x2, 0x2, 
    0x26e, 0x26f, 0x5, 0x8, 0x5, 0x2, 0x26f, 0x57, 0x3, 0x2, 0x2, 0x2, 0x270, 
    0x27b, 0x7, 0x20, 0x2, 0x2, 0x271, 0x272, 0x7, 0x21, 0x2, 0x2, 0x272, 
    0x277, 0x5, 0x6a, 0x36, 0x2, 0x273, 0x274, 0x7, 0x3b, 0x2, 0x2, 0x274, 
    0x276, 0x5, 0x78, 0x3d, 0x2, 0x275, 0x273, 0x3, 0x2, 0x2, 0x2, 0x276, 
    0x279, 0x3, 0x2, 0x2, 0x2, 0x277, 0x275, 0x3, 0x2, 0x2, 0x2, 0x277, 
    0x278, 0x3, 0x2, 0x2, 0x2, 0x278, 0x27c, 0x3, 0x2, 0x2, 0x2, 0x279, 
    0x277, 0x3, 0x2, 0x2, 0x2, 0x27a, 0x27c, 0x5, 0x66, 0x34, 0x2, 0x27b, 
    0x271, 0x3, 0x2, 0x2, 0x2, 0x27b, 0x27a, 0x3, 0x2, 0x2, 0x2, 0x27c, 
    0x59, 0x3, 0x2, 0x2, 0x2, 0x27d, 0x27e, 0x7, 0x22, 0x2, 0x2, 0x27e, 
    0x27f, 0x5, 0x76, 0x3c, 0x2, 0x27f, 0x280, 0x5, 0x8, 0x5, 0x2, 0x280, 
    0x5b, 0x3, 0x2, 0x2, 0x2, 0x281, 0x283, 0x7, 0x2a, 0x2, 0x2, 0x282, 
    0x284, 0x5, 0x76, 0x3c, 0x2, 0x283, 0x282, 0x3, 0x2, 0x2, 0x2, 0x283, 
    0x284, 0x3, 0x2, 0x2, 0x2, 0x284, 0x285, 0x3, 0x2, 0x2, 0x2, 0x285, 
    0x286, 0x5, 0x8, 0x5, 0x2, 0x286, 0x5d, 0x3, 0x2, 0x2, 0x2, 0x287, 0x288, 
    0x7, 0x29, 0x2, 0x2, 0x288, 0x289, 0x5, 0x7c, 0x3f, 0x2, 0x289, 0x28a, 
    0x7, 0x1f, 0x2, 0x2, 0x28a, 0x28b, 0x7, 0x36, 0x2, 0x2, 0x28b, 0x28c, 
    0x5, 0x66, 0x34, 0x2, 0x28c, 0x28d, 0x7, 0x37, 0x2, 0x2, 0x28d, 0x291, 
    0x7, 0x34, 0x2, 0x2, 0x28e, 0x290, 0x5, 0x16, 0xc, 0x2, 0x28f, 0x28e, 
    0x3, 0x2, 0x2, 0x2, 0x290, 0x293, 0x3, 0x2, 0x2, 0x2, 0x291, 0x28f, 
    0x3, 0x2, 0x2, 0x2, 0x291, 0x292, 0x3, 0x2, 0x2, 0x2, 0x292, 0x294, 
    0x3, 0x2, 0x2, 0x2, 0x293, 0x291, 0x3, 0x2, 0x2, 0x2, 0x294, 0x295, 
    0x7, 0x35, 0x2, 0x2, 0x295, 0x5f, 0x3, 0x2, 0x2, 0x2, 0x296, 0x29d, 
    0x5, 0x66, 0x34, 0x2, 0x297, 0x29e, 0x5, 0x62, 0x32, 0x2, 0x298, 0x299, 
    0x5, 0x64, 0x33, 0x2, 0x299, 0x29a, 0x5, 0x66, 0x34, 0x2, 0x29a, 0x29e, 
    0x3, 0x2, 0x2, 0x2, 0x29b, 0x29e, 0x7, 0x50, 0x2, 0x2, 0x29c, 0x29e, 
    0x7, 0x51, 0x2, 0x2, 0x29d, 0x297, 0x3, 0x2, 0x2, 0x2, 0x29d, 0x298, 
    0x3, 0x2, 0x2, 0x2, 0x29d, 0x29b, 0x3, 0x2, 0x2, 0x2, 0x29d, 0x29c, 
    0x3, 0x2, 0x2, 0x2, 0x29d, 0x29e, 0x3, 0x2, 0x2, 0x2, 0x29e, 0x2a2, 
    0x3, 0x2, 0x2, 0x2, 0x29f, 0x2a0, 0x9, 0x6, 0x2, 0x2, 0x2a0, 0x2a2, 
    0x5, 0x6a, 0x36, 0x2, 0x2a1, 0x296, 0x3, 0x2, 0x2, 0x2, 0x2a1, 0x29f, 
    0x3, 0x2, 0x2, 0x2, 0x2a2, 0x61, 0x3, 0x2, 0x2, 0x2, 0x2a3, 0x2a4, 0x7, 
    0x4f, 0x2, 0x2, 0x2a4, 0x2a6, 0x5, 0x66, 0x34, 0x2, 0x2a5, 0x2a3, 0x3, 
    0x2, 0x2, 0x2, 0x2a6, 0x2a7, 0x3, 0x2, 0x2, 0x2, 0x2a7, 0x2a5, 0x3, 
    0x2, 0x2, 0x2, 0x2a7, 0x2a8, 0x3, 0x2, 0x2, 0x2, 0x2a8, 0x2ab, 0x3, 
    0x2, 0x2, 0x2, 0x2a9, 0x2aa, 0x7, 0x4f, 0x2, 0x2, 0x2aa, 0x2ac, 0x5, 
    0x12, 0xa, 0x2, 0x2ab, 0x2a9, 0x3, 0x2, 0x2, 0x2, 0x2ab, 0x2ac, 0x3, 
    0x2, 0x2, 0x2, 0x2ac, 0x2b0, 0x3, 0x2, 0x2, 0x2, 0x2ad, 0x2ae, 0x7, 
    0x4f, 0x2, 0x2, 0x2ae, 0x2b0, 0x5, 0x12, 0xa, 0x2, 0x2af, 0x2a5, 0x3, 
    0x2, 0x2, 0x2, 0x2af, 0x2ad, 0x3, 0x2, 0x2, 0x2, 0x2b0, 0x63, 0x3, 0x2, 
    0x2, 0x2, 0x2b1, 0x2b2, 0x9, 0x7, 0x2, 0x2, 0x2b2, 0x65, 0x3, 0x2, 0x2, 
    0x2, 0x2b3, 0x2bb, 0x5, 0x68, 0x35, 0x2, 0x2b4, 0x2bb, 0x5, 0x70, 0x39, 
    0x2, 0x2b5, 0x2b8, 0x5, 0x6a, 0x36, 0x2, 0x2b6, 0x2b7, 0x7, 0x21, 0x2, 
    0x2, 0x2b7, 0x2b9, 0x5, 0x6a, 0x36, 0x2, 0x2b8, 0x2b6, 0x3, 0x2, 0x2, 
    0x2, 0x2b8, 0x2b9, 0x3, 0x2, 0x2, 0x2, 0x2b9, 0x2bb, 0x3, 0x2, 0x2, 
    0x2, 0x2ba, 0x2b3, 0x3, 0x2, 0x2, 0x2, 0x2ba, 0x2b4, 0x3, 0x2, 0x2, 
    0x2, 0x2ba, 0x2b5, 0x3, 0x2, 0x2, 0x2, 0x2bb, 0x67, 0x3, 0x2, 0x2, 0x2, 
    0x2bc, 0x2bd, 0x7, 0x5, 0x2, 0x2, 0x2bd, 0x2bf, 0x7, 0x36, 0x2, 0x2, 
    0x2be, 0x2c0, 0x5, 0x1c, 0xf, 0x2, 0x2bf, 0x2be, 0x3, 0x2, 0x2, 0x2, 
    0x2bf, 0x2c0, 0x3, 0x2, 0x2, 0x2, 0x2c0, 0x2c1, 0x3, 0x2, 0x2, 0x2, 
    0x2c1, 0x2c4, 0x7, 0x37, 0x2, 0x2, 0x2c2, 0x2c3, 0x7, 0x3f, 0x2, 0x2, 
    0x2c3, 0x2c5, 0x5, 0x2c, 0x17, 0x2, 0x2c4, 0x2c2, 0x3, 0x2, 0x2, 0x2, 
    0x2c4, 0x2c5, 0x3, 0x2, 0x2, 0x2, 0x2c5, 0x2c9, 0x3, 0x2, 0x2, 0x2, 
    0x2c6, 0x2ca, 0x5, 0x8, 0x5, 0x2, 0x2c7, 0x2c8, 0x7, 0x40, 0x2, 0x2, 
    0x2c8, 0x2ca, 0x5, 0x66, 0x34, 0x2, 0x2c9, 0x2c6, 0x3, 0x2, 0x2, 0x2, 
    0x2c9, 0x2c7, 0x3, 0x2, 0x2, 0x2, 0x2ca, 0x69, 0x3, 0x2, 0x2, 0x2, 0x2cb, 
    0x2cc, 0x8, 0x36, 0x1, 0x2, 0x2cc, 0x2d5, 0x5, 0x6c, 0x37, 0x2, 0x2cd, 
    0x2ce, 0x9, 0x8, 0x2, 0x2, 0x2ce, 0x2d5, 0x5, 0x6a, 0x36, 0xb, 0x2cf, 
    0x2d0, 0x7, 0x36, 0x2, 0x2, 0x2d0, 0x2d1, 0x5, 0x38, 0x1d, 0x2, 0x2d1, 
    0x2d2, 0x7, 0x37, 0x2, 0x2, 0x2d2, 0x2d3, 0x5, 0x6a, 0x36, 0xa, 0x2d3, 
    0x2d5, 0x3, 0x2, 0x2, 0x2, 0x2d4, 0x2cb, 0x3, 0x2, 0x2, 0x2, 0x2d4, 
    0x2cd, 0x3, 0x2, 0x2, 0x2, 0x2d4, 0x2cf, 0x3, 0x2, 0x2, 0x2, 0x2d5, 
    0x307, 0x3, 0x2, 0x2, 0x2, 0x2d6, 0x2d7, 0xc, 0xd, 0x2, 0x2, 0x2d7, 
    0x2d8, 0x7, 0x5b, 0x2, 0x2, 0x2d8, 0x306, 0x5, 0x6a, 0x36, 0xd, 0x2d9, 
    0x2da, 0xc, 0xc, 0x2, 0x2, 0x2da, 0x2db, 0x7, 0x54, 0x2, 0x2, 0x2db, 
    0x306, 0x5, 0x6a, 0x36, 0xd, 0x2dc, 0x2dd, 0xc, 0x9, 0x2, 0x2, 0x2dd, 
    0x2de, 0x9, 0x9, 0x2, 0x2, 0x2de, 0x306, 0x5, 0x6a, 0x36, 0xa, 0x2df, 
    0x2e0, 0xc, 0x8, 0x2, 0x2, 0x2e0, 0x2e1, 0x9, 0xa, 0x2, 0x2, 0x2e1, 
    0x306, 0x5, 0x6a, 0x36, 0x9, 0x2e2, 0x2e3, 0xc, 0x7, 0x2, 0x2, 0x2e3, 
    0x2e4, 0x9, 0xb, 0x2, 0x2, 0x2e4, 0x306, 0x5, 0x6a, 0x36, 0x8, 0x2e5, 
    0x2e6, 0xc, 0x6, 0x2, 0x2, 0x2e6, 0x2e7, 0x9, 0xc, 0x2, 0x2, 0x2e7, 
    0x306, 0x5, 0x6a, 0x36, 0x7, 0x2e8, 0x2e9, 0xc, 0x5, 0x2, 0x2, 0x2e9, 
    0x2ea, 0x7, 0x47, 0x2, 0x2, 0x2ea, 0x306, 0x5, 0x6a, 0x36, 0x6, 0x2eb, 
    0x2ec, 0xc, 0x4, 0x2, 0x2, 0x2ec, 0x2ed, 0x7, 0x48, 0x2, 0x2, 0x2ed, 
    0x306, 0x5, 0x6a, 0x36, 0x5, 0x2ee, 0x2ef, 0xc, 0x3, 0x2, 0x2, 0x2ef, 
    0x2f0, 0x7, 0x3e, 0x2, 0x2, 0x2f0, 0x2f1, 0x5, 0x6a, 0x36, 0x2, 0x2f1, 
    0x2f2, 0x7, 0x3d, 0x2, 0x2, 0x2f2, 0x2f3, 0x5, 0x6a, 0x36, 0x3, 0x2f3, 
    0x306, 0x3, 0x2, 0x2, 0x2, 0x2f4, 0x2f5, 0xc, 0x10, 0x2, 0x2, 0x2f5, 
    0x2f6, 0x7, 0x3c, 0x2, 0x2, 0x2f6, 0x306, 0x5, 0x7c, 0x3f, 0x2, 0x2f7, 
    0x2f8, 0xc, 0xf, 0x2, 0x2, 0x2f8, 0x2f9, 0x7, 0x38, 0x2, 0x2, 0x2f9, 
    0x2fe, 0x5, 0x74, 0x3b, 0x2, 0x2fa, 0x2fb, 0x7, 0x3b, 0x2, 0x2, 0x2fb, 
    0x2fd, 0x5, 0x74, 0x3b, 0x2, 0x2fc, 0x2fa, 0x3, 0x2, 0x2, 0x2, 0x2fd, 
    0x300, 0x3, 0x2, 0x2, 0x2, 0x2fe, 0x2fc, 0x3, 0x2, 0x2, 0x2, 0x2fe, 
    0x2ff, 0x3, 0x2, 0x2, 0x2, 0x2ff, 0x301, 0x3, 0x2, 0x2, 0x2, 0x300, 
    0x2fe, 0x3, 0x2, 0x2, 0x2, 0x301, 0x302, 0x7, 0x39, 0x2, 0x2, 0x302, 
    0x306, 0x3, 0x2, 0x2, 0x2, 0x303, 0x304, 0xc, 0xe, 0x2, 0x2, 0x304, 
    0x306, 0x5, 0x76, 0x3c, 0x2, 0x305, 0x2d6, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x2d9, 0x3, 0x2, 0x2, 0x2, 0x305, 0x2dc, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x2df, 0x3, 0x2, 0x2, 0x2, 0x305, 0x2e2, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x2e5, 0x3, 0x2, 0x2, 0x2, 0x305, 0x2e8, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x2eb, 0x3, 0x2, 0x2, 0x2, 0x305, 0x2ee, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x2f4, 0x3, 0x2, 0x2, 0x2, 0x305, 0x2f7, 0x3, 0x2, 0x2, 0x2, 0x305, 
    0x303, 0x3, 0x2, 0x2, 0x2, 0x306, 0x309, 0x3, 0x2, 0x2, 0x2, 0x307, 
    0x305, 0x3, 0x2, 0x2, 0x2, 0x307, 0x308, 0x3, 0x2, 0x2, 0x2, 0x308, 
    0x6b, 0x3, 0x2, 0x2, 0x2, 0x309, 0x307, 0x3, 0x2, 0x2, 0x2, 0x30a, 0x327, 
    0x5, 0x7a, 0x3e, 0x2, 0x30b, 0x327, 0x5, 0x7c, 0x3f, 0x2, 0x30c, 0x30d, 
    0x5, 0x38, 0x1d, 0x2, 0x30d, 0x30e, 0x5, 0x76, 0x3c, 0x2, 0x30e, 0x327, 
    0x3, 0x2, 0x2, 0x2, 0x30f, 0x310, 0x7, 0x36, 0x2, 0x2, 0x310, 0x311, 
    0x5, 0x66, 0x34, 0x2, 0x311, 0x312, 0x7, 0x37, 0x2, 0x2, 0x312, 0x327, 
    0x3, 0x2, 0x2, 0x2, 0x313, 0x31f, 0x7, 0x38, 0x2, 0x2, 0x314, 0x319, 
    0x5, 0x6e, 0x38, 0x2, 0x315, 0x316, 0x7, 0x3a, 0x2, 0x2, 0x316, 0x318, 
    0x5, 0x6e, 0x38, 0x2, 0x317, 0x315, 0x3, 0x2, 0x2, 0x2, 0x318, 0x31b, 
    0x3, 0x2, 0x2, 0x2, 0x319, 0x317, 0x3, 0x2, 0x2, 0x2, 0x319, 0x31a, 
    0x3, 0x2, 0x2, 0x2, 0x31a, 0x31d, 0x3, 0x2, 0x2, 0x2, 0x31b, 0x319, 
    0x3, 0x2, 0x2, 0x2, 0x31c, 0x31e, 0x7, 0x3a, 0x2, 0x2, 0x31d, 0x31c, 
    0x3, 0x2, 0x2, 0x2, 0x31d, 0x31e, 0x3, 0x2, 0x2, 0x2, 0x31e, 0x320, 
    0x3, 0x2, 0x2, 0x2, 0x31f, 0x314, 0x3, 0x2, 0x2, 0x2, 0x31f, 0x320, 
    0x3, 0x2, 0x2, 0x2, 0x320, 0x321, 0x3, 0x2, 0x2, 0x2, 0x321, 0x327, 
    0x7, 0x39, 0x2, 0x2, 0x322, 0x323, 0x7, 0xb, 0x2, 0x2, 0x323, 0x324, 
    0x5, 0x36, 0x1c, 0x2, 0x324, 0x325, 0x5, 0x76, 0x3c, 0x2, 0x325, 0x327, 
    0x3, 0x2, 0x2, 0x2, 0x326, 0x30a, 0x3, 0x2, 0x2, 0x2, 0x326, 0x30b, 
    0x3, 0x2, 0x2, 0x2, 0x326, 0x30c, 0x3, 0x2, 0x2, 0x2, 0x326, 0x30f, 
    0x3, 0x2, 0x2, 0x2, 0x326, 0x313, 0x3, 0x2, 0x2, 0x2, 0x326, 0x322, 
    0x3, 0x2, 0x2, 0x2, 0x327, 0x6d, 0x3, 0x2, 0x2, 0x2, 0x328, 0x32d, 0x5, 
    0x66, 0x34, 0x2, 0x329, 0x32a, 0x7, 0x3b, 0x2, 0x2, 0x32a, 0x32c, 0x5, 
    0x66, 0x34, 0x2, 0x32b, 0x329, 0x3, 0x2, 0x2, 0x2, 0x32c, 0x32f, 0x3, 
    0x2, 0x2, 0x2, 0x32d, 0x32b, 0x3, 0x2, 0x2, 0x2, 0x32d, 0x32e, 0x3, 
    0x2, 0x2, 0x2, 0x32e, 0x331, 0x3, 0x2, 0x2, 0x2, 0x32f, 0x32d, 0x3, 
    0x2, 0x2, 0x2, 0x330, 0x332, 0x7, 0x3b, 0x2, 0x2, 0x331, 0x330, 0x3, 
    0x2, 0x2, 0x2, 0x331, 0x332, 0x3, 0x2, 0x2, 0x2, 0x332, 0x6f, 0x3, 0x2, 
    0x2, 0x2, 0x333, 0x336, 0x7, 0xb, 0x2, 0x2, 0x334, 0x337, 0x5, 0x38, 
    0x1d, 0x2, 0x335, 0x337, 0x5, 0x36, 0x1c, 0x2, 0x336, 0x334, 0x3, 0x2, 
    0x2, 0x2, 0x336, 0x335, 0x3, 0x2, 0x2, 0x2, 0x337, 0x34b, 0x3, 0x2, 
    0x2, 0x2, 0x338, 0x33a, 0x5, 0x72, 0x3a, 0x2, 0x339, 0x338, 0x3, 0x2, 
    0x2, 0x2, 0x33a, 0x33b, 0x3, 0x2, 0x2, 0x2, 0x33b, 0x339, 0x3, 0x2, 
    0x2, 0x2, 0x33b, 0x33c, 0x3, 0x2, 0x2, 0x2, 0x33c, 0x341, 0x3, 0x2, 
    0x2, 0x2, 0x33d, 0x33e, 0x7, 0x38, 0x2, 0x2, 0x33e, 0x340, 0x7, 0x39, 
    0x2, 0x2, 0x33f, 0x33d, 0x3, 0x2, 0x2, 0x2, 0x340, 0x343, 0x3, 0x2, 
    0x2, 0x2, 0x341, 0x33f, 0x3, 0x2, 0x2, 0x2, 0x341, 0x342, 0x3, 0x2, 
    0x2, 0x2, 0x342, 0x34c, 0x3, 0x2, 0x2, 0x2, 0x343, 0x341, 0x3, 0x2, 
    0x2, 0x2, 0x344, 0x345, 0x7, 0x38, 0x2, 0x2, 0x345, 0x347, 0x7, 0x39, 
    0x2, 0x2, 0x346, 0x344, 0x3, 0x2, 0x2, 0x2, 0x347, 0x348, 0x3, 0x2, 
    0x2, 0x2, 0x348, 0x346, 0x3, 0x2, 0x2, 0x2, 0x348, 0x349, 0x3, 0x2, 
    0x2, 0x2, 0x349, 0x34a, 0x3, 0x2, 0x2, 0x2, 0x34a, 0x34c, 0x5, 0x12, 
    0xa, 0x2, 0x34b, 0x339, 0x3, 0x2, 0x2, 0x2, 0x34b, 0x346, 0x3, 0x2, 
    0x2, 0x2, 0x34c, 0x71, 0x3, 0x2, 0x2, 0x2, 0x34d, 0x34e, 0x7, 0x38, 
    0x2, 0x2, 0x34e, 0x34f, 0x5, 0x66, 0x34, 0x2, 0x34f, 0x350, 0x7, 0x39, 
    0x2, 0x2, 0x350, 0x73, 0x3, 0x2, 0x2, 0x2, 0x351, 0x356, 0x5, 0x66, 
    0x34, 0x2, 0x352, 0x354, 0x7, 0x3d, 0x2, 0x2, 0x353, 0x355, 0x5, 0x66, 
    0x34, 0x2, 0x354, 0x353, 0x3, 0x2, 0x2, 0x2, 0x354, 0x355, 0x3, 0x2, 
    0x2, 0x2, 0x355, 0x357, 0x3, 0x2, 0x2, 0x2, 0x356, 0x352, 0x3, 0x2, 
    0x2, 0x2, 0x356, 0x357, 0x3, 0x2, 0x2, 0x2, 0x357, 0x35d, 0x3, 0x2, 
    0x2, 0x2, 0x358, 0x35a, 0x7, 0x3d, 0x2, 0x2, 0x359, 0x35b, 0x5, 0x66, 
    0x34, 0x2, 0x35a, 0x359, 0x3, 0x2, 0x2, 0x2, 0x35a, 0x35b, 0x3, 0x2, 
    0x2, 0x2, 0x35b, 0x35d, 0x3, 0x2, 0x2, 0x2, 0x35c, 0x351, 0x3, 0x2, 
    0x2, 0x2, 0x35c, 0x358, 0x3, 0x2, 0x2, 0x2, 0x35d, 0x75, 0x3, 0x2, 0x2, 
    0x2, 0x35e, 0x36a, 0x7, 0x36, 0x2, 0x2, 0x35f, 0x364, 0x5, 0x78, 0x3d, 
    0x2, 0x360, 0x361, 0x7, 0x3b, 0x2, 0x2, 0x361, 0x363, 0x5, 0x78, 0x3d, 
    0x2, 0x362, 0x360, 0x3, 0x2, 0x2, 0x2, 0x363, 0x366, 0x3, 0x2, 0x2, 
    0x2, 0x364, 0x362, 0x3, 0x2, 0x2, 0x2, 0x364, 0x365, 0x3, 0x2, 0x2, 
    0x2, 0x365, 0x368, 0x3, 0x2, 0x2, 0x2, 0x366, 0x364, 0x3, 0x2, 0x2, 
    0x2, 0x367, 0x369, 0x7, 0x3b, 0x2, 0x2, 0x368, 0x367, 0x3, 0x2, 0x2, 
    0x2, 0x368, 0x369, 0x3, 0x2, 0x2, 0x2, 0x369, 0x36b, 0x3, 0x2, 0x2, 
    0x2, 0x36a, 0x35f, 0x3, 0x2, 0x2, 0x2, 0x36a, 0x36b, 0x3, 0x2, 0x2, 
    0x2, 0x36b, 0x36c, 0x3, 0x2, 0x2, 0x2, 0x36c, 0x36d, 0x7, 0x37, 0x2, 
    0x2, 0x36d, 0x77, 0x3, 0x2, 0x2, 0x2, 0x36e, 0x36f, 0x5, 0x7c, 0x3f, 
    0x2, 0x36f, 0x370, 0x7, 0x3d, 0x2, 0x2, 0x370, 0x372, 0x3, 0x2, 0x2, 
    0x2, 0x371, 0x36e, 0x3, 0x2, 0x2, 0x2, 0x371, 0x372, 0x3, 0x2, 0x2, 
    0x2, 0x372, 0x373, 0x3, 0x2, 0x2, 0x2, 0x373, 0x374, 0x5, 0x66, 0x34, 
    0x2, 0x374, 0x79, 0x3, 0x2, 0x2, 0x2, 0x375, 0x376, 0x9, 0xd, 0x2, 0x2, 
    0x376, 0x7b, 0x3, 0x2, 0x2, 0x2, 0x377, 0x378, 0x9, 0xe, 0x2, 0x2, 0x378, 
    0x7d, 0x3, 0x2, 0x2, 0x2, 0x6b, 0x81, 0xa5, 0xb5, 0xbc, 0xc2, 0xcb, 
    0xcf, 0xd2, 0xda, 0xe2, 0xe7, 0xeb, 0xf3, 0xf7, 0xf9, 0x103, 0x113, 
    0x119, 0x11e, 0x124, 0x129, 0x12e, 0x135, 0x13c, 0x140, 0x145, 0x149, 
    0x14c, 0x154, 0x157, 0x160, 0x162, 0x16f, 0x175, 0x17d, 0x181, 0x189, 
    0x18f, 0x199, 0x19c, 0x1a4, 0x1a8, 0x1af, 0x1b5, 0x1b8, 0x1bf, 0x1c2, 
    0x1cd, 0x1da, 0x1dc, 0x1e0, 0x1f8, 0x1fe, 0x206, 0x20a, 0x20e, 0x210, 
    0x219, 0x21c, 0x223, 0x22e, 0x234, 0x23f, 0x243, 0x249, 0x251, 0x256, 
    0x25d, 0x277, 0x27b, 0x283, 0x291, 0x29d, 0x2a1, 0x2a7, 0x2ab, 0x2af, 
    0x2b8, 0x2ba, 0x2bf, 0x2c4, 0x2c9, 0x2d4, 0x2fe, 0x305, 0x307, 0x319, 
    0x31d, 0x31f, 0x326, 0x32d, 0x331, 0x336, 0x33b, 0x341, 0x348, 0x34b, 
    0x354, 0x356, 0x35a, 0x35c, 0x364, 0x368, 0x36a, 0x371, 
  };

  TableReader deserializer;
  _atn = deserializer.deserialize(_serializedATN);

  size_t count = _atn.getNumberOfDecisions();
  _decisionToDFA.reserve(count);
  for (size_t i = 0; i < count; i++) { 
    _decisionToDFA.emplace_back(_atn.getDecisionState(i), i);
  }
}

void RbtParser::prepare() {
  static Initializer tables;
}
