
// Generated from RbtParser.g4 by ANTLR 4.7.2



#include "RbtParser.h"


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
    setState(133);
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
      setState(130);
      stmt();
      setState(135);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(136);
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
    setState(169);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 1, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(138);
      block();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(139);
      match(RbtParser::SEMI);
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(140);
      letDecl();
      setState(141);
      match(RbtParser::SEMI);
      break;
    }

    case 4: {
      enterOuterAlt(_localctx, 4);
      setState(143);
      varDecl();
      setState(144);
      match(RbtParser::SEMI);
      break;
    }

    case 5: {
      enterOuterAlt(_localctx, 5);
      setState(146);
      blockDecl();
      break;
    }

    case 6: {
      enterOuterAlt(_localctx, 6);
      setState(147);
      fnDecl();
      break;
    }

    case 7: {
      enterOuterAlt(_localctx, 7);
      setState(148);
      structDecl();
      break;
    }

    case 8: {
      enterOuterAlt(_localctx, 8);
      setState(149);
      enumDecl();
      break;
    }

    case 9: {
      enterOuterAlt(_localctx, 9);
      setState(150);
      importDecl();
      setState(151);
      match(RbtParser::SEMI);
      break;
    }

    case 10: {
      enterOuterAlt(_localctx, 10);
      setState(153);
      testDecl();
      break;
    }

    case 11: {
      enterOuterAlt(_localctx, 11);
      setState(154);
      ifStmt();
      break;
    }

    case 12: {
      enterOuterAlt(_localctx, 12);
      setState(155);
      whileStmt();
      break;
    }

    case 13: {
      enterOuterAlt(_localctx, 13);
      setState(156);
      doStmt();
      setState(157);
      match(RbtParser::SEMI);
      break;
    }

    case 14: {
      enterOuterAlt(_localctx, 14);
      setState(159);
      forStmt();
      break;
    }

    case 15: {
      enterOuterAlt(_localctx, 15);
      setState(160);
      switchStmt();
      break;
    }

    case 16: {
      enterOuterAlt(_localctx, 16);
      setState(161);
      tryStmt();
      break;
    }

    case 17: {
      enterOuterAlt(_localctx, 17);
      setState(162);
      parallelStmt();
      break;
    }

    case 18: {
      enterOuterAlt(_localctx, 18);
      setState(163);
      whenStmt();
      break;
    }

    case 19: {
      enterOuterAlt(_localctx, 19);
      setState(164);
      everyStmt();
      break;
    }

    case 20: {
      enterOuterAlt(_localctx, 20);
      setState(165);
      withStmt();
      break;
    }

    case 21: {
      enterOuterAlt(_localctx, 21);
      setState(166);
      pathStmt();
      break;
    }

    case 22: {
      enterOuterAlt(_localctx, 22);
      setState(167);
      recordStmt();
      break;
    }

    case 23: {
      enterOuterAlt(_localctx, 23);
      setState(168);
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
    setState(192);
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
        setState(171);
        exprStmt();
        setState(172);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::WAIT: {
        enterOuterAlt(_localctx, 2);
        setState(174);
        waitStmt();
        setState(175);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::BREAK: {
        enterOuterAlt(_localctx, 3);
        setState(177);
        match(RbtParser::BREAK);
        setState(178);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::CONTINUE: {
        enterOuterAlt(_localctx, 4);
        setState(179);
        match(RbtParser::CONTINUE);
        setState(180);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::RETRY: {
        enterOuterAlt(_localctx, 5);
        setState(181);
        match(RbtParser::RETRY);
        setState(182);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::RETURN: {
        enterOuterAlt(_localctx, 6);
        setState(183);
        match(RbtParser::RETURN);
        setState(185);
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
          setState(184);
          expression();
        }
        setState(187);
        match(RbtParser::SEMI);
        break;
      }

      case RbtParser::THROW: {
        enterOuterAlt(_localctx, 7);
        setState(188);
        match(RbtParser::THROW);
        setState(189);
        expression();
        setState(190);
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
    setState(194);
    match(RbtParser::LBRACE);
    setState(198);
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
      setState(195);
      stmt();
      setState(200);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(201);
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
    setState(203);
    _la = _input->LA(1);
    if (!(_la == RbtParser::LET

    || _la == RbtParser::VAR)) {
    _errHandler->recoverInline(this);
    }
    else {
      _errHandler->reportMatch(this);
      consume();
    }
    setState(204);
    name();
    setState(207);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COLON) {
      setState(205);
      match(RbtParser::COLON);
      setState(206);
      anyType();
    }
    setState(211);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ASSIGN) {
      setState(209);
      match(RbtParser::ASSIGN);
      setState(210);
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
    setState(214);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::FINAL) {
      setState(213);
      match(RbtParser::FINAL);
    }
    setState(216);
    type();
    setState(217);
    declarator();
    setState(222);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::COMMA) {
      setState(218);
      match(RbtParser::COMMA);
      setState(219);
      declarator();
      setState(224);
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
    setState(225);
    name();
    setState(230);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::LBRACK) {
      setState(226);
      match(RbtParser::LBRACK);
      setState(227);
      match(RbtParser::RBRACK);
      setState(232);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(235);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ASSIGN) {
      setState(233);
      match(RbtParser::ASSIGN);
      setState(234);
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
    setState(239);
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
        setState(237);
        expression();
        break;
      }

      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 2);
        setState(238);
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

std::vector<RbtParser::BraceItemContext *> RbtParser::BraceInitContext::braceItem() {
  return getRuleContexts<RbtParser::BraceItemContext>();
}

RbtParser::BraceItemContext* RbtParser::BraceInitContext::braceItem(size_t i) {
  return getRuleContext<RbtParser::BraceItemContext>(i);
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
    setState(241);
    match(RbtParser::LBRACE);
    setState(253);
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
      setState(242);
      braceItem();
      setState(247);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 12, _ctx);
      while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
        if (alt == 1) {
          setState(243);
          match(RbtParser::COMMA);
          setState(244);
          braceItem(); 
        }
        setState(249);
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 12, _ctx);
      }
      setState(251);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(250);
        match(RbtParser::COMMA);
      }
    }
    setState(255);
    match(RbtParser::RBRACE);
   
  }
  catch (RecognitionException &e) {
    _errHandler->reportError(this, e);
    _localctx->exception = std::current_exception();
    _errHandler->recover(this, _localctx->exception);
  }

  return _localctx;
}

//----------------- BraceItemContext ------------------------------------------------------------------

RbtParser::BraceItemContext::BraceItemContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::InitializerContext *> RbtParser::BraceItemContext::initializer() {
  return getRuleContexts<RbtParser::InitializerContext>();
}

RbtParser::InitializerContext* RbtParser::BraceItemContext::initializer(size_t i) {
  return getRuleContext<RbtParser::InitializerContext>(i);
}

tree::TerminalNode* RbtParser::BraceItemContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}


size_t RbtParser::BraceItemContext::getRuleIndex() const {
  return RbtParser::RuleBraceItem;
}


RbtParser::BraceItemContext* RbtParser::braceItem() {
  BraceItemContext *_localctx = _tracker.createInstance<BraceItemContext>(_ctx, getState());
  enterRule(_localctx, 18, RbtParser::RuleBraceItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(257);
    initializer();
    setState(260);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COLON) {
      setState(258);
      match(RbtParser::COLON);
      setState(259);
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
  enterRule(_localctx, 20, RbtParser::RuleBlockDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(262);
    typeName();
    setState(263);
    name();
    setState(264);
    match(RbtParser::LBRACE);
    setState(268);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::SEMI))) != 0)) {
      setState(265);
      blockItem();
      setState(270);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(271);
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
  enterRule(_localctx, 22, RbtParser::RuleBlockItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(284);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 17, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(273);
      name();
      setState(274);
      match(RbtParser::COLON);
      setState(275);
      expression();
      setState(276);
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
      setState(278);
      name();
      setState(279);
      name();
      setState(280);
      args();
      setState(281);
      match(RbtParser::SEMI);
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(283);
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
  enterRule(_localctx, 24, RbtParser::RuleFnDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(311);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN: {
        enterOuterAlt(_localctx, 1);
        setState(286);
        match(RbtParser::FN);
        setState(287);
        name();
        setState(288);
        match(RbtParser::LPAREN);
        setState(290);
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
          setState(289);
          params();
        }
        setState(292);
        match(RbtParser::RPAREN);
        setState(295);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::ARROW) {
          setState(293);
          match(RbtParser::ARROW);
          setState(294);
          resultType();
        }
        setState(297);
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
        setState(301);
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
            setState(299);
            type();
            break;
          }

          case RbtParser::VOID: {
            setState(300);
            match(RbtParser::VOID);
            break;
          }

        default:
          throw NoViableAltException(this);
        }
        setState(303);
        name();
        setState(304);
        match(RbtParser::LPAREN);
        setState(306);
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
          setState(305);
          params();
        }
        setState(308);
        match(RbtParser::RPAREN);
        setState(309);
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
  enterRule(_localctx, 26, RbtParser::RuleFnBody);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(318);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 1);
        setState(313);
        block();
        break;
      }

      case RbtParser::FATARROW: {
        enterOuterAlt(_localctx, 2);
        setState(314);
        match(RbtParser::FATARROW);
        setState(315);
        expression();
        setState(316);
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
  enterRule(_localctx, 28, RbtParser::RuleParams);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(320);
    param();
    setState(325);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 24, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(321);
        match(RbtParser::COMMA);
        setState(322);
        param(); 
      }
      setState(327);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 24, _ctx);
    }
    setState(329);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COMMA) {
      setState(328);
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
  enterRule(_localctx, 30, RbtParser::RuleParam);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(352);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 30, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(331);
      name();
      setState(334);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COLON) {
        setState(332);
        match(RbtParser::COLON);
        setState(333);
        anyType();
      }
      setState(338);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::ASSIGN) {
        setState(336);
        match(RbtParser::ASSIGN);
        setState(337);
        expression();
      }
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(341);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::FINAL) {
        setState(340);
        match(RbtParser::FINAL);
      }
      setState(343);
      type();
      setState(344);
      name();
      setState(349);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::LBRACK) {
        setState(345);
        match(RbtParser::LBRACK);
        setState(346);
        match(RbtParser::RBRACK);
        setState(351);
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
  enterRule(_localctx, 32, RbtParser::RuleStructDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(354);
    match(RbtParser::STRUCT);
    setState(355);
    name();
    setState(356);
    match(RbtParser::LBRACE);
    setState(363);
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
      setState(361);
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
          setState(357);
          param();
          setState(358);
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
          setState(360);
          match(RbtParser::SEMI);
          break;
        }

      default:
        throw NoViableAltException(this);
      }
      setState(365);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(366);
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
  enterRule(_localctx, 34, RbtParser::RuleEnumDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(368);
    match(RbtParser::ENUM);
    setState(369);
    name();
    setState(370);
    match(RbtParser::LBRACE);
    setState(371);
    name();
    setState(376);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 33, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(372);
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
        name(); 
      }
      setState(378);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 33, _ctx);
    }
    setState(382);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::SEMI

    || _la == RbtParser::COMMA) {
      setState(379);
      _la = _input->LA(1);
      if (!(_la == RbtParser::SEMI

      || _la == RbtParser::COMMA)) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      setState(384);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(385);
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
  enterRule(_localctx, 36, RbtParser::RuleImportDecl);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(387);
    match(RbtParser::IMPORT);
    setState(390);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::STRING: {
        setState(388);
        match(RbtParser::STRING);
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(389);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(394);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::AS) {
      setState(392);
      match(RbtParser::AS);
      setState(393);
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
  enterRule(_localctx, 38, RbtParser::RuleTestDecl);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(396);
    match(RbtParser::TEST);
    setState(397);
    match(RbtParser::STRING);
    setState(398);
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

std::vector<RbtParser::BracketPairContext *> RbtParser::TypeContext::bracketPair() {
  return getRuleContexts<RbtParser::BracketPairContext>();
}

RbtParser::BracketPairContext* RbtParser::TypeContext::bracketPair(size_t i) {
  return getRuleContext<RbtParser::BracketPairContext>(i);
}


size_t RbtParser::TypeContext::getRuleIndex() const {
  return RbtParser::RuleType;
}


RbtParser::TypeContext* RbtParser::type() {
  TypeContext *_localctx = _tracker.createInstance<TypeContext>(_ctx, getState());
  enterRule(_localctx, 40, RbtParser::RuleType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(402);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        setState(400);
        primType();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(401);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(407);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::LBRACK) {
      setState(404);
      bracketPair();
      setState(409);
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

//----------------- BracketPairContext ------------------------------------------------------------------

RbtParser::BracketPairContext::BracketPairContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

tree::TerminalNode* RbtParser::BracketPairContext::LBRACK() {
  return getToken(RbtParser::LBRACK, 0);
}

tree::TerminalNode* RbtParser::BracketPairContext::RBRACK() {
  return getToken(RbtParser::RBRACK, 0);
}

RbtParser::PrimTypeContext* RbtParser::BracketPairContext::primType() {
  return getRuleContext<RbtParser::PrimTypeContext>(0);
}

RbtParser::TypeNameContext* RbtParser::BracketPairContext::typeName() {
  return getRuleContext<RbtParser::TypeNameContext>(0);
}


size_t RbtParser::BracketPairContext::getRuleIndex() const {
  return RbtParser::RuleBracketPair;
}


RbtParser::BracketPairContext* RbtParser::bracketPair() {
  BracketPairContext *_localctx = _tracker.createInstance<BracketPairContext>(_ctx, getState());
  enterRule(_localctx, 42, RbtParser::RuleBracketPair);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(410);
    match(RbtParser::LBRACK);
    setState(413);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        setState(411);
        primType();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(412);
        typeName();
        break;
      }

      case RbtParser::RBRACK: {
        break;
      }

    default:
      break;
    }
    setState(415);
    match(RbtParser::RBRACK);
   
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
  enterRule(_localctx, 44, RbtParser::RuleFnType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(417);
    match(RbtParser::FN);
    setState(418);
    match(RbtParser::LPAREN);
    setState(427);
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
      setState(419);
      anyType();
      setState(424);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::COMMA) {
        setState(420);
        match(RbtParser::COMMA);
        setState(421);
        anyType();
        setState(426);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
    }
    setState(429);
    match(RbtParser::RPAREN);
    setState(430);
    match(RbtParser::ARROW);
    setState(431);
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
  enterRule(_localctx, 46, RbtParser::RuleResultType);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(435);
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
        setState(433);
        anyType();
        break;
      }

      case RbtParser::VOID: {
        enterOuterAlt(_localctx, 2);
        setState(434);
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
  enterRule(_localctx, 48, RbtParser::RuleAnyType);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(439);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::FN: {
        enterOuterAlt(_localctx, 1);
        setState(437);
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
        setState(438);
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
  enterRule(_localctx, 50, RbtParser::RuleDimType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(441);
    dimFactor();
    setState(446);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::STAR

    || _la == RbtParser::SLASH) {
      setState(442);
      _la = _input->LA(1);
      if (!(_la == RbtParser::STAR

      || _la == RbtParser::SLASH)) {
      _errHandler->recoverInline(this);
      }
      else {
        _errHandler->reportMatch(this);
        consume();
      }
      setState(443);
      dimFactor();
      setState(448);
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

std::vector<RbtParser::BracketPairContext *> RbtParser::DimFactorContext::bracketPair() {
  return getRuleContexts<RbtParser::BracketPairContext>();
}

RbtParser::BracketPairContext* RbtParser::DimFactorContext::bracketPair(size_t i) {
  return getRuleContext<RbtParser::BracketPairContext>(i);
}


size_t RbtParser::DimFactorContext::getRuleIndex() const {
  return RbtParser::RuleDimFactor;
}


RbtParser::DimFactorContext* RbtParser::dimFactor() {
  DimFactorContext *_localctx = _tracker.createInstance<DimFactorContext>(_ctx, getState());
  enterRule(_localctx, 52, RbtParser::RuleDimFactor);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(464);
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
        setState(449);
        type();
        setState(455);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::CARET) {
          setState(450);
          match(RbtParser::CARET);
          setState(452);
          _errHandler->sync(this);

          _la = _input->LA(1);
          if (_la == RbtParser::MINUS) {
            setState(451);
            match(RbtParser::MINUS);
          }
          setState(454);
          match(RbtParser::INT);
        }
        break;
      }

      case RbtParser::LPAREN: {
        enterOuterAlt(_localctx, 2);
        setState(457);
        inParens();
        setState(461);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::LBRACK) {
          setState(458);
          bracketPair();
          setState(463);
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
  enterRule(_localctx, 54, RbtParser::RuleInParens);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(466);
    match(RbtParser::LPAREN);
    setState(467);
    anyType();
    setState(468);
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
  enterRule(_localctx, 56, RbtParser::RuleTypeName);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(470);
    name();
    setState(475);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::DOT) {
      setState(471);
      match(RbtParser::DOT);
      setState(472);
      name();
      setState(477);
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
  enterRule(_localctx, 58, RbtParser::RulePrimType);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(478);
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
  enterRule(_localctx, 60, RbtParser::RuleIfStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(480);
    match(RbtParser::IF);
    setState(481);
    match(RbtParser::LPAREN);
    setState(482);
    expression();
    setState(483);
    match(RbtParser::RPAREN);
    setState(484);
    ifBody();
    setState(490);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ELSE) {
      setState(485);
      match(RbtParser::ELSE);
      setState(488);
      _errHandler->sync(this);
      switch (_input->LA(1)) {
        case RbtParser::IF: {
          setState(486);
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
          setState(487);
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
  enterRule(_localctx, 62, RbtParser::RuleIfBody);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(494);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        enterOuterAlt(_localctx, 1);
        setState(492);
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
        setState(493);
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
  enterRule(_localctx, 64, RbtParser::RuleWhileStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(496);
    match(RbtParser::WHILE);
    setState(497);
    match(RbtParser::LPAREN);
    setState(498);
    expression();
    setState(499);
    match(RbtParser::RPAREN);
    setState(500);
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
  enterRule(_localctx, 66, RbtParser::RuleDoStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(502);
    match(RbtParser::DO);
    setState(503);
    block();
    setState(504);
    match(RbtParser::WHILE);
    setState(505);
    match(RbtParser::LPAREN);
    setState(506);
    expression();
    setState(507);
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
  enterRule(_localctx, 68, RbtParser::RuleForStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(509);
    match(RbtParser::FOR);
    setState(510);
    match(RbtParser::LPAREN);
    setState(511);
    forHeader();
    setState(512);
    match(RbtParser::RPAREN);
    setState(513);
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
  enterRule(_localctx, 70, RbtParser::RuleForHeader);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(542);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 58, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(515);
      name();
      setState(518);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(516);
        match(RbtParser::COMMA);
        setState(517);
        name();
      }
      setState(520);
      match(RbtParser::IN);
      setState(521);
      expression();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(524);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::FINAL) {
        setState(523);
        match(RbtParser::FINAL);
      }
      setState(526);
      type();
      setState(527);
      name();
      setState(528);
      match(RbtParser::COLON);
      setState(529);
      expression();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(532);
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
        setState(531);
        forInit();
      }
      setState(534);
      match(RbtParser::SEMI);
      setState(536);
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
        setState(535);
        expression();
      }
      setState(538);
      match(RbtParser::SEMI);
      setState(540);
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
        setState(539);
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
  enterRule(_localctx, 72, RbtParser::RuleForInit);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(554);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 60, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(544);
      varDecl();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(545);
      letDecl();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(546);
      exprStmt();
      setState(551);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::COMMA) {
        setState(547);
        match(RbtParser::COMMA);
        setState(548);
        exprStmt();
        setState(553);
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
  enterRule(_localctx, 74, RbtParser::RuleForUpdate);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(556);
    exprStmt();
    setState(561);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::COMMA) {
      setState(557);
      match(RbtParser::COMMA);
      setState(558);
      exprStmt();
      setState(563);
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
  enterRule(_localctx, 76, RbtParser::RuleSwitchStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(564);
    match(RbtParser::SWITCH);
    setState(565);
    match(RbtParser::LPAREN);
    setState(566);
    expression();
    setState(567);
    match(RbtParser::RPAREN);
    setState(568);
    match(RbtParser::LBRACE);
    setState(572);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::SEMI) {
      setState(569);
      match(RbtParser::SEMI);
      setState(574);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(578);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::CASE

    || _la == RbtParser::DEFAULT) {
      setState(575);
      switchCase();
      setState(580);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(581);
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
  enterRule(_localctx, 78, RbtParser::RuleSwitchCase);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(593);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::CASE: {
        setState(583);
        match(RbtParser::CASE);
        setState(584);
        expression();
        setState(589);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::COMMA) {
          setState(585);
          match(RbtParser::COMMA);
          setState(586);
          expression();
          setState(591);
          _errHandler->sync(this);
          _la = _input->LA(1);
        }
        break;
      }

      case RbtParser::DEFAULT: {
        setState(592);
        match(RbtParser::DEFAULT);
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(595);
    match(RbtParser::COLON);
    setState(599);
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
      setState(596);
      stmt();
      setState(601);
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
  enterRule(_localctx, 80, RbtParser::RuleTryStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(602);
    match(RbtParser::TRY);
    setState(603);
    block();
    setState(607);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while (_la == RbtParser::CATCH) {
      setState(604);
      catchClause();
      setState(609);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(612);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::FINALLY) {
      setState(610);
      match(RbtParser::FINALLY);
      setState(611);
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
  enterRule(_localctx, 82, RbtParser::RuleCatchClause);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(614);
    match(RbtParser::CATCH);
    setState(619);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::LPAREN) {
      setState(615);
      match(RbtParser::LPAREN);
      setState(616);
      param();
      setState(617);
      match(RbtParser::RPAREN);
    }
    setState(621);
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
  enterRule(_localctx, 84, RbtParser::RuleParallelStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(623);
    match(RbtParser::PARALLEL);
    setState(624);
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
  enterRule(_localctx, 86, RbtParser::RuleWhenStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(626);
    match(RbtParser::WHEN);
    setState(627);
    match(RbtParser::LPAREN);
    setState(628);
    expression();
    setState(629);
    match(RbtParser::RPAREN);
    setState(630);
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
  enterRule(_localctx, 88, RbtParser::RuleEveryStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(632);
    match(RbtParser::EVERY);
    setState(633);
    match(RbtParser::LPAREN);
    setState(634);
    expression();
    setState(635);
    match(RbtParser::RPAREN);
    setState(636);
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
  enterRule(_localctx, 90, RbtParser::RuleWaitStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(638);
    match(RbtParser::WAIT);
    setState(649);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::UNTIL: {
        setState(639);
        match(RbtParser::UNTIL);
        setState(640);
        expr(0);
        setState(645);
        _errHandler->sync(this);
        _la = _input->LA(1);
        while (_la == RbtParser::COMMA) {
          setState(641);
          match(RbtParser::COMMA);
          setState(642);
          arg();
          setState(647);
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
        setState(648);
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
  enterRule(_localctx, 92, RbtParser::RuleWithStmt);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(651);
    match(RbtParser::WITH);
    setState(652);
    args();
    setState(653);
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
  enterRule(_localctx, 94, RbtParser::RulePathStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(655);
    match(RbtParser::PATH);
    setState(657);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::LPAREN) {
      setState(656);
      args();
    }
    setState(659);
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
  enterRule(_localctx, 96, RbtParser::RuleRecordStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(661);
    match(RbtParser::RECORD);
    setState(662);
    name();
    setState(663);
    match(RbtParser::EVERY);
    setState(664);
    match(RbtParser::LPAREN);
    setState(665);
    expression();
    setState(666);
    match(RbtParser::RPAREN);
    setState(667);
    match(RbtParser::LBRACE);
    setState(671);
    _errHandler->sync(this);
    _la = _input->LA(1);
    while ((((_la & ~ 0x3fULL) == 0) &&
      ((1ULL << _la) & ((1ULL << RbtParser::TEST)
      | (1ULL << RbtParser::RECORD)
      | (1ULL << RbtParser::PATH)
      | (1ULL << RbtParser::AS)
      | (1ULL << RbtParser::ID)
      | (1ULL << RbtParser::SEMI))) != 0)) {
      setState(668);
      blockItem();
      setState(673);
      _errHandler->sync(this);
      _la = _input->LA(1);
    }
    setState(674);
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
  enterRule(_localctx, 98, RbtParser::RuleExprStmt);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(687);
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
        setState(676);
        expression();
        setState(683);
        _errHandler->sync(this);
        switch (_input->LA(1)) {
          case RbtParser::ASSIGN: {
            setState(677);
            assignTail();
            break;
          }

          case RbtParser::PLUSEQ:
          case RbtParser::MINUSEQ:
          case RbtParser::STAREQ:
          case RbtParser::SLASHEQ:
          case RbtParser::PERCENTEQ: {
            setState(678);
            compoundOp();
            setState(679);
            expression();
            break;
          }

          case RbtParser::INC: {
            setState(681);
            match(RbtParser::INC);
            break;
          }

          case RbtParser::DEC: {
            setState(682);
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
        setState(685);
        _la = _input->LA(1);
        if (!(_la == RbtParser::INC

        || _la == RbtParser::DEC)) {
        _errHandler->recoverInline(this);
        }
        else {
          _errHandler->reportMatch(this);
          consume();
        }
        setState(686);
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
  enterRule(_localctx, 100, RbtParser::RuleAssignTail);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    setState(701);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 78, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(691); 
      _errHandler->sync(this);
      alt = 1;
      do {
        switch (alt) {
          case 1: {
                setState(689);
                match(RbtParser::ASSIGN);
                setState(690);
                expression();
                break;
              }

        default:
          throw NoViableAltException(this);
        }
        setState(693); 
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 76, _ctx);
      } while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER);
      setState(697);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::ASSIGN) {
        setState(695);
        match(RbtParser::ASSIGN);
        setState(696);
        braceInit();
      }
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(699);
      match(RbtParser::ASSIGN);
      setState(700);
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
  enterRule(_localctx, 102, RbtParser::RuleCompoundOp);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(703);
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
  enterRule(_localctx, 104, RbtParser::RuleExpression);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(712);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 80, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(705);
      lambda();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(706);
      newArray();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(707);
      expr(0);
      setState(710);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::UNTIL) {
        setState(708);
        match(RbtParser::UNTIL);
        setState(709);
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
  enterRule(_localctx, 106, RbtParser::RuleLambda);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(714);
    match(RbtParser::FN);
    setState(715);
    match(RbtParser::LPAREN);
    setState(717);
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
      setState(716);
      params();
    }
    setState(719);
    match(RbtParser::RPAREN);
    setState(722);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::ARROW) {
      setState(720);
      match(RbtParser::ARROW);
      setState(721);
      resultType();
    }
    setState(727);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::LBRACE: {
        setState(724);
        block();
        break;
      }

      case RbtParser::FATARROW: {
        setState(725);
        match(RbtParser::FATARROW);
        setState(726);
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
  size_t startState = 108;
  enterRecursionRule(_localctx, 108, RbtParser::RuleExpr, precedence);

    size_t _la = 0;

  auto onExit = finally([=] {
    unrollRecursionContexts(parentContext);
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(738);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 84, _ctx)) {
    case 1: {
      _localctx = _tracker.createInstance<PrimaryEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;

      setState(730);
      primary();
      break;
    }

    case 2: {
      _localctx = _tracker.createInstance<UnaryEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;
      setState(731);
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
      setState(732);
      expr(9);
      break;
    }

    case 3: {
      _localctx = _tracker.createInstance<CastEContext>(_localctx);
      _ctx = _localctx;
      previousContext = _localctx;
      setState(733);
      match(RbtParser::LPAREN);
      setState(734);
      primType();
      setState(735);
      match(RbtParser::RPAREN);
      setState(736);
      expr(8);
      break;
    }

    }
    _ctx->stop = _input->LT(-1);
    setState(789);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 87, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        if (!_parseListeners.empty())
          triggerExitRuleEvent();
        previousContext = _localctx;
        setState(787);
        _errHandler->sync(this);
        switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 86, _ctx)) {
        case 1: {
          auto newContext = _tracker.createInstance<PowEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(740);

          if (!(precpred(_ctx, 11))) throw FailedPredicateException(this, "precpred(_ctx, 11)");
          setState(741);
          match(RbtParser::CARET);
          setState(742);
          expr(11);
          break;
        }

        case 2: {
          auto newContext = _tracker.createInstance<EpowEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(743);

          if (!(precpred(_ctx, 10))) throw FailedPredicateException(this, "precpred(_ctx, 10)");
          setState(744);
          match(RbtParser::DOTCARET);
          setState(745);
          expr(11);
          break;
        }

        case 3: {
          auto newContext = _tracker.createInstance<MulEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(746);

          if (!(precpred(_ctx, 7))) throw FailedPredicateException(this, "precpred(_ctx, 7)");
          setState(747);
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
          setState(748);
          expr(8);
          break;
        }

        case 4: {
          auto newContext = _tracker.createInstance<AddEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(749);

          if (!(precpred(_ctx, 6))) throw FailedPredicateException(this, "precpred(_ctx, 6)");
          setState(750);
          _la = _input->LA(1);
          if (!(_la == RbtParser::PLUS

          || _la == RbtParser::MINUS)) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(751);
          expr(7);
          break;
        }

        case 5: {
          auto newContext = _tracker.createInstance<RelEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(752);

          if (!(precpred(_ctx, 5))) throw FailedPredicateException(this, "precpred(_ctx, 5)");
          setState(753);
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
          setState(754);
          expr(6);
          break;
        }

        case 6: {
          auto newContext = _tracker.createInstance<EqEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(755);

          if (!(precpred(_ctx, 4))) throw FailedPredicateException(this, "precpred(_ctx, 4)");
          setState(756);
          _la = _input->LA(1);
          if (!(_la == RbtParser::EQ

          || _la == RbtParser::NE)) {
          _errHandler->recoverInline(this);
          }
          else {
            _errHandler->reportMatch(this);
            consume();
          }
          setState(757);
          expr(5);
          break;
        }

        case 7: {
          auto newContext = _tracker.createInstance<AndEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(758);

          if (!(precpred(_ctx, 3))) throw FailedPredicateException(this, "precpred(_ctx, 3)");
          setState(759);
          match(RbtParser::ANDAND);
          setState(760);
          expr(4);
          break;
        }

        case 8: {
          auto newContext = _tracker.createInstance<OrEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(761);

          if (!(precpred(_ctx, 2))) throw FailedPredicateException(this, "precpred(_ctx, 2)");
          setState(762);
          match(RbtParser::OROR);
          setState(763);
          expr(3);
          break;
        }

        case 9: {
          auto newContext = _tracker.createInstance<CondEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(764);

          if (!(precpred(_ctx, 1))) throw FailedPredicateException(this, "precpred(_ctx, 1)");
          setState(765);
          match(RbtParser::QMARK);
          setState(766);
          expr(0);
          setState(767);
          match(RbtParser::COLON);
          setState(768);
          expr(1);
          break;
        }

        case 10: {
          auto newContext = _tracker.createInstance<MemberEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(770);

          if (!(precpred(_ctx, 14))) throw FailedPredicateException(this, "precpred(_ctx, 14)");
          setState(771);
          match(RbtParser::DOT);
          setState(772);
          name();
          break;
        }

        case 11: {
          auto newContext = _tracker.createInstance<IndexEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(773);

          if (!(precpred(_ctx, 13))) throw FailedPredicateException(this, "precpred(_ctx, 13)");
          setState(774);
          match(RbtParser::LBRACK);
          setState(775);
          indexItem();
          setState(780);
          _errHandler->sync(this);
          _la = _input->LA(1);
          while (_la == RbtParser::COMMA) {
            setState(776);
            match(RbtParser::COMMA);
            setState(777);
            indexItem();
            setState(782);
            _errHandler->sync(this);
            _la = _input->LA(1);
          }
          setState(783);
          match(RbtParser::RBRACK);
          break;
        }

        case 12: {
          auto newContext = _tracker.createInstance<CallEContext>(_tracker.createInstance<ExprContext>(parentContext, parentState));
          _localctx = newContext;
          pushNewRecursionContext(newContext, startState, RuleExpr);
          setState(785);

          if (!(precpred(_ctx, 12))) throw FailedPredicateException(this, "precpred(_ctx, 12)");
          setState(786);
          args();
          break;
        }

        } 
      }
      setState(791);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 87, _ctx);
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

tree::TerminalNode* RbtParser::PrimaryContext::COLON() {
  return getToken(RbtParser::COLON, 0);
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
  enterRule(_localctx, 110, RbtParser::RulePrimary);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    setState(823);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 91, _ctx)) {
    case 1: {
      enterOuterAlt(_localctx, 1);
      setState(792);
      literal();
      break;
    }

    case 2: {
      enterOuterAlt(_localctx, 2);
      setState(793);
      name();
      break;
    }

    case 3: {
      enterOuterAlt(_localctx, 3);
      setState(794);
      primType();
      setState(795);
      args();
      break;
    }

    case 4: {
      enterOuterAlt(_localctx, 4);
      setState(797);
      match(RbtParser::LPAREN);
      setState(798);
      expression();
      setState(799);
      match(RbtParser::RPAREN);
      break;
    }

    case 5: {
      enterOuterAlt(_localctx, 5);
      setState(801);
      match(RbtParser::LBRACK);
      setState(813);
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
        setState(802);
        row();
        setState(807);
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 88, _ctx);
        while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
          if (alt == 1) {
            setState(803);
            match(RbtParser::SEMI);
            setState(804);
            row(); 
          }
          setState(809);
          _errHandler->sync(this);
          alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 88, _ctx);
        }
        setState(811);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::SEMI) {
          setState(810);
          match(RbtParser::SEMI);
        }
      }
      setState(815);
      match(RbtParser::RBRACK);
      break;
    }

    case 6: {
      enterOuterAlt(_localctx, 6);
      setState(816);
      match(RbtParser::LBRACK);
      setState(817);
      match(RbtParser::COLON);
      setState(818);
      match(RbtParser::RBRACK);
      break;
    }

    case 7: {
      enterOuterAlt(_localctx, 7);
      setState(819);
      match(RbtParser::NEW);
      setState(820);
      typeName();
      setState(821);
      args();
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

//----------------- RowContext ------------------------------------------------------------------

RbtParser::RowContext::RowContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ItemContext *> RbtParser::RowContext::item() {
  return getRuleContexts<RbtParser::ItemContext>();
}

RbtParser::ItemContext* RbtParser::RowContext::item(size_t i) {
  return getRuleContext<RbtParser::ItemContext>(i);
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
  enterRule(_localctx, 112, RbtParser::RuleRow);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(825);
    item();
    setState(830);
    _errHandler->sync(this);
    alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 92, _ctx);
    while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
      if (alt == 1) {
        setState(826);
        match(RbtParser::COMMA);
        setState(827);
        item(); 
      }
      setState(832);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 92, _ctx);
    }
    setState(834);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COMMA) {
      setState(833);
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

//----------------- ItemContext ------------------------------------------------------------------

RbtParser::ItemContext::ItemContext(ParserRuleContext *parent, size_t invokingState)
  : GuardedCtx(parent, invokingState) {
}

std::vector<RbtParser::ExpressionContext *> RbtParser::ItemContext::expression() {
  return getRuleContexts<RbtParser::ExpressionContext>();
}

RbtParser::ExpressionContext* RbtParser::ItemContext::expression(size_t i) {
  return getRuleContext<RbtParser::ExpressionContext>(i);
}

tree::TerminalNode* RbtParser::ItemContext::COLON() {
  return getToken(RbtParser::COLON, 0);
}


size_t RbtParser::ItemContext::getRuleIndex() const {
  return RbtParser::RuleItem;
}


RbtParser::ItemContext* RbtParser::item() {
  ItemContext *_localctx = _tracker.createInstance<ItemContext>(_ctx, getState());
  enterRule(_localctx, 114, RbtParser::RuleItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(836);
    expression();
    setState(839);
    _errHandler->sync(this);

    _la = _input->LA(1);
    if (_la == RbtParser::COLON) {
      setState(837);
      match(RbtParser::COLON);
      setState(838);
      expression();
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
  enterRule(_localctx, 116, RbtParser::RuleNewArray);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(841);
    match(RbtParser::NEW);
    setState(844);
    _errHandler->sync(this);
    switch (_input->LA(1)) {
      case RbtParser::INT_T:
      case RbtParser::DOUBLE_T:
      case RbtParser::BOOL_T: {
        setState(842);
        primType();
        break;
      }

      case RbtParser::TEST:
      case RbtParser::RECORD:
      case RbtParser::PATH:
      case RbtParser::AS:
      case RbtParser::ID: {
        setState(843);
        typeName();
        break;
      }

    default:
      throw NoViableAltException(this);
    }
    setState(865);
    _errHandler->sync(this);
    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 99, _ctx)) {
    case 1: {
      setState(847); 
      _errHandler->sync(this);
      alt = 1;
      do {
        switch (alt) {
          case 1: {
                setState(846);
                newDim();
                break;
              }

        default:
          throw NoViableAltException(this);
        }
        setState(849); 
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 96, _ctx);
      } while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER);
      setState(855);
      _errHandler->sync(this);
      _la = _input->LA(1);
      while (_la == RbtParser::LBRACK) {
        setState(851);
        match(RbtParser::LBRACK);
        setState(852);
        match(RbtParser::RBRACK);
        setState(857);
        _errHandler->sync(this);
        _la = _input->LA(1);
      }
      break;
    }

    case 2: {
      setState(860); 
      _errHandler->sync(this);
      _la = _input->LA(1);
      do {
        setState(858);
        match(RbtParser::LBRACK);
        setState(859);
        match(RbtParser::RBRACK);
        setState(862); 
        _errHandler->sync(this);
        _la = _input->LA(1);
      } while (_la == RbtParser::LBRACK);
      setState(864);
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
  enterRule(_localctx, 118, RbtParser::RuleNewDim);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(867);
    match(RbtParser::LBRACK);
    setState(868);
    expression();
    setState(869);
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
  enterRule(_localctx, 120, RbtParser::RuleIndexItem);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    setState(882);
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
        setState(871);
        expression();
        setState(876);
        _errHandler->sync(this);

        _la = _input->LA(1);
        if (_la == RbtParser::COLON) {
          setState(872);
          match(RbtParser::COLON);
          setState(874);
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
            setState(873);
            expression();
          }
        }
        break;
      }

      case RbtParser::COLON: {
        enterOuterAlt(_localctx, 2);
        setState(878);
        match(RbtParser::COLON);
        setState(880);
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
          setState(879);
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
  enterRule(_localctx, 122, RbtParser::RuleArgs);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    size_t alt;
    enterOuterAlt(_localctx, 1);
    setState(884);
    match(RbtParser::LPAREN);
    setState(896);
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
      setState(885);
      arg();
      setState(890);
      _errHandler->sync(this);
      alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 104, _ctx);
      while (alt != 2 && alt != atn::ATN::INVALID_ALT_NUMBER) {
        if (alt == 1) {
          setState(886);
          match(RbtParser::COMMA);
          setState(887);
          arg(); 
        }
        setState(892);
        _errHandler->sync(this);
        alt = getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 104, _ctx);
      }
      setState(894);
      _errHandler->sync(this);

      _la = _input->LA(1);
      if (_la == RbtParser::COMMA) {
        setState(893);
        match(RbtParser::COMMA);
      }
    }
    setState(898);
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
  enterRule(_localctx, 124, RbtParser::RuleArg);

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(903);
    _errHandler->sync(this);

    switch (getInterpreter<atn::ParserATNSimulator>()->adaptivePredict(_input, 107, _ctx)) {
    case 1: {
      setState(900);
      name();
      setState(901);
      match(RbtParser::COLON);
      break;
    }

    }
    setState(905);
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
  enterRule(_localctx, 126, RbtParser::RuleLiteral);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(907);
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
  enterRule(_localctx, 128, RbtParser::RuleName);
  size_t _la = 0;

  auto onExit = finally([=] {
    exitRule();
  });
  try {
    enterOuterAlt(_localctx, 1);
    setState(909);
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
    case 54: return exprSempred(dynamic_cast<ExprContext *>(context), predicateIndex);

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
  "initializer", "braceInit", "braceItem", "blockDecl", "blockItem", "fnDecl", 
  "fnBody", "params", "param", "structDecl", "enumDecl", "importDecl", "testDecl", 
  "type", "bracketPair", "fnType", "resultType", "anyType", "dimType", "dimFactor", 
  "inParens", "typeName", "primType", "ifStmt", "ifBody", "whileStmt", "doStmt", 
  "forStmt", "forHeader", "forInit", "forUpdate", "switchStmt", "switchCase", 
  "tryStmt", "catchClause", "parallelStmt", "whenStmt", "everyStmt", "waitStmt", 
  "withStmt", "pathStmt", "recordStmt", "exprStmt", "assignTail", "compoundOp", 
  "expression", "lambda", "expr", "primary", "row", "item", "newArray", 
  "newDim", "indexItem", "args", "arg", "literal", "name"
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
    0x3, 0x60, 0x392, 0x4, 0x2, 0x9, 0x2, 0x4, 0x3, 0x9, 0x3, 0x4, 0x4, 
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
    0x3f, 0x4, 0x40, 0x9, 0x40, 0x4, 0x41, 0x9, 0x41, 0x4, 0x42, 0x9, 0x42, 
    0x3, 0x2, 0x7, 0x2, 0x86, 0xa, 0x2, 0xc, 0x2, 0xe, 0x2, 0x89, 0xb, 0x2, 
    0x3, 0x2, 0x3, 0x2, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 
    0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x3, 0x5, 0x3, 0xac, 0xa, 
    0x3, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 
    0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 
    0x4, 0x5, 0x4, 0xbc, 0xa, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 0x3, 0x4, 
    0x3, 0x4, 0x5, 0x4, 0xc3, 0xa, 0x4, 0x3, 0x5, 0x3, 0x5, 0x7, 0x5, 0xc7, 
    0xa, 0x5, 0xc, 0x5, 0xe, 0x5, 0xca, 0xb, 0x5, 0x3, 0x5, 0x3, 0x5, 0x3, 
    0x6, 0x3, 0x6, 0x3, 0x6, 0x3, 0x6, 0x5, 0x6, 0xd2, 0xa, 0x6, 0x3, 0x6, 
    0x3, 0x6, 0x5, 0x6, 0xd6, 0xa, 0x6, 0x3, 0x7, 0x5, 0x7, 0xd9, 0xa, 0x7, 
    0x3, 0x7, 0x3, 0x7, 0x3, 0x7, 0x3, 0x7, 0x7, 0x7, 0xdf, 0xa, 0x7, 0xc, 
    0x7, 0xe, 0x7, 0xe2, 0xb, 0x7, 0x3, 0x8, 0x3, 0x8, 0x3, 0x8, 0x7, 0x8, 
    0xe7, 0xa, 0x8, 0xc, 0x8, 0xe, 0x8, 0xea, 0xb, 0x8, 0x3, 0x8, 0x3, 0x8, 
    0x5, 0x8, 0xee, 0xa, 0x8, 0x3, 0x9, 0x3, 0x9, 0x5, 0x9, 0xf2, 0xa, 0x9, 
    0x3, 0xa, 0x3, 0xa, 0x3, 0xa, 0x3, 0xa, 0x7, 0xa, 0xf8, 0xa, 0xa, 0xc, 
    0xa, 0xe, 0xa, 0xfb, 0xb, 0xa, 0x3, 0xa, 0x5, 0xa, 0xfe, 0xa, 0xa, 0x5, 
    0xa, 0x100, 0xa, 0xa, 0x3, 0xa, 0x3, 0xa, 0x3, 0xb, 0x3, 0xb, 0x3, 0xb, 
    0x5, 0xb, 0x107, 0xa, 0xb, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x3, 0xc, 0x7, 
    0xc, 0x10d, 0xa, 0xc, 0xc, 0xc, 0xe, 0xc, 0x110, 0xb, 0xc, 0x3, 0xc, 
    0x3, 0xc, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 
    0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x3, 0xd, 0x5, 0xd, 0x11f, 0xa, 
    0xd, 0x3, 0xe, 0x3, 0xe, 0x3, 0xe, 0x3, 0xe, 0x5, 0xe, 0x125, 0xa, 0xe, 
    0x3, 0xe, 0x3, 0xe, 0x3, 0xe, 0x5, 0xe, 0x12a, 0xa, 0xe, 0x3, 0xe, 0x3, 
    0xe, 0x3, 0xe, 0x3, 0xe, 0x5, 0xe, 0x130, 0xa, 0xe, 0x3, 0xe, 0x3, 0xe, 
    0x3, 0xe, 0x5, 0xe, 0x135, 0xa, 0xe, 0x3, 0xe, 0x3, 0xe, 0x3, 0xe, 0x5, 
    0xe, 0x13a, 0xa, 0xe, 0x3, 0xf, 0x3, 0xf, 0x3, 0xf, 0x3, 0xf, 0x3, 0xf, 
    0x5, 0xf, 0x141, 0xa, 0xf, 0x3, 0x10, 0x3, 0x10, 0x3, 0x10, 0x7, 0x10, 
    0x146, 0xa, 0x10, 0xc, 0x10, 0xe, 0x10, 0x149, 0xb, 0x10, 0x3, 0x10, 
    0x5, 0x10, 0x14c, 0xa, 0x10, 0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 0x5, 0x11, 
    0x151, 0xa, 0x11, 0x3, 0x11, 0x3, 0x11, 0x5, 0x11, 0x155, 0xa, 0x11, 
    0x3, 0x11, 0x5, 0x11, 0x158, 0xa, 0x11, 0x3, 0x11, 0x3, 0x11, 0x3, 0x11, 
    0x3, 0x11, 0x7, 0x11, 0x15e, 0xa, 0x11, 0xc, 0x11, 0xe, 0x11, 0x161, 
    0xb, 0x11, 0x5, 0x11, 0x163, 0xa, 0x11, 0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 
    0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 0x3, 0x12, 0x7, 0x12, 0x16c, 0xa, 0x12, 
    0xc, 0x12, 0xe, 0x12, 0x16f, 0xb, 0x12, 0x3, 0x12, 0x3, 0x12, 0x3, 0x13, 
    0x3, 0x13, 0x3, 0x13, 0x3, 0x13, 0x3, 0x13, 0x3, 0x13, 0x7, 0x13, 0x179, 
    0xa, 0x13, 0xc, 0x13, 0xe, 0x13, 0x17c, 0xb, 0x13, 0x3, 0x13, 0x7, 0x13, 
    0x17f, 0xa, 0x13, 0xc, 0x13, 0xe, 0x13, 0x182, 0xb, 0x13, 0x3, 0x13, 
    0x3, 0x13, 0x3, 0x14, 0x3, 0x14, 0x3, 0x14, 0x5, 0x14, 0x189, 0xa, 0x14, 
    0x3, 0x14, 0x3, 0x14, 0x5, 0x14, 0x18d, 0xa, 0x14, 0x3, 0x15, 0x3, 0x15, 
    0x3, 0x15, 0x3, 0x15, 0x3, 0x16, 0x3, 0x16, 0x5, 0x16, 0x195, 0xa, 0x16, 
    0x3, 0x16, 0x7, 0x16, 0x198, 0xa, 0x16, 0xc, 0x16, 0xe, 0x16, 0x19b, 
    0xb, 0x16, 0x3, 0x17, 0x3, 0x17, 0x3, 0x17, 0x5, 0x17, 0x1a0, 0xa, 0x17, 
    0x3, 0x17, 0x3, 0x17, 0x3, 0x18, 0x3, 0x18, 0x3, 0x18, 0x3, 0x18, 0x3, 
    0x18, 0x7, 0x18, 0x1a9, 0xa, 0x18, 0xc, 0x18, 0xe, 0x18, 0x1ac, 0xb, 
    0x18, 0x5, 0x18, 0x1ae, 0xa, 0x18, 0x3, 0x18, 0x3, 0x18, 0x3, 0x18, 
    0x3, 0x18, 0x3, 0x19, 0x3, 0x19, 0x5, 0x19, 0x1b6, 0xa, 0x19, 0x3, 0x1a, 
    0x3, 0x1a, 0x5, 0x1a, 0x1ba, 0xa, 0x1a, 0x3, 0x1b, 0x3, 0x1b, 0x3, 0x1b, 
    0x7, 0x1b, 0x1bf, 0xa, 0x1b, 0xc, 0x1b, 0xe, 0x1b, 0x1c2, 0xb, 0x1b, 
    0x3, 0x1c, 0x3, 0x1c, 0x3, 0x1c, 0x5, 0x1c, 0x1c7, 0xa, 0x1c, 0x3, 0x1c, 
    0x5, 0x1c, 0x1ca, 0xa, 0x1c, 0x3, 0x1c, 0x3, 0x1c, 0x7, 0x1c, 0x1ce, 
    0xa, 0x1c, 0xc, 0x1c, 0xe, 0x1c, 0x1d1, 0xb, 0x1c, 0x5, 0x1c, 0x1d3, 
    0xa, 0x1c, 0x3, 0x1d, 0x3, 0x1d, 0x3, 0x1d, 0x3, 0x1d, 0x3, 0x1e, 0x3, 
    0x1e, 0x3, 0x1e, 0x7, 0x1e, 0x1dc, 0xa, 0x1e, 0xc, 0x1e, 0xe, 0x1e, 
    0x1df, 0xb, 0x1e, 0x3, 0x1f, 0x3, 0x1f, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 
    0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x3, 0x20, 0x5, 0x20, 0x1eb, 
    0xa, 0x20, 0x5, 0x20, 0x1ed, 0xa, 0x20, 0x3, 0x21, 0x3, 0x21, 0x5, 0x21, 
    0x1f1, 0xa, 0x21, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 0x3, 0x22, 
    0x3, 0x22, 0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x3, 0x23, 0x3, 
    0x23, 0x3, 0x23, 0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 0x3, 0x24, 
    0x3, 0x24, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x5, 0x25, 0x209, 0xa, 0x25, 
    0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x5, 0x25, 0x20f, 0xa, 0x25, 
    0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x3, 0x25, 0x5, 
    0x25, 0x217, 0xa, 0x25, 0x3, 0x25, 0x3, 0x25, 0x5, 0x25, 0x21b, 0xa, 
    0x25, 0x3, 0x25, 0x3, 0x25, 0x5, 0x25, 0x21f, 0xa, 0x25, 0x5, 0x25, 
    0x221, 0xa, 0x25, 0x3, 0x26, 0x3, 0x26, 0x3, 0x26, 0x3, 0x26, 0x3, 0x26, 
    0x7, 0x26, 0x228, 0xa, 0x26, 0xc, 0x26, 0xe, 0x26, 0x22b, 0xb, 0x26, 
    0x5, 0x26, 0x22d, 0xa, 0x26, 0x3, 0x27, 0x3, 0x27, 0x3, 0x27, 0x7, 0x27, 
    0x232, 0xa, 0x27, 0xc, 0x27, 0xe, 0x27, 0x235, 0xb, 0x27, 0x3, 0x28, 
    0x3, 0x28, 0x3, 0x28, 0x3, 0x28, 0x3, 0x28, 0x3, 0x28, 0x7, 0x28, 0x23d, 
    0xa, 0x28, 0xc, 0x28, 0xe, 0x28, 0x240, 0xb, 0x28, 0x3, 0x28, 0x7, 0x28, 
    0x243, 0xa, 0x28, 0xc, 0x28, 0xe, 0x28, 0x246, 0xb, 0x28, 0x3, 0x28, 
    0x3, 0x28, 0x3, 0x29, 0x3, 0x29, 0x3, 0x29, 0x3, 0x29, 0x7, 0x29, 0x24e, 
    0xa, 0x29, 0xc, 0x29, 0xe, 0x29, 0x251, 0xb, 0x29, 0x3, 0x29, 0x5, 0x29, 
    0x254, 0xa, 0x29, 0x3, 0x29, 0x3, 0x29, 0x7, 0x29, 0x258, 0xa, 0x29, 
    0xc, 0x29, 0xe, 0x29, 0x25b, 0xb, 0x29, 0x3, 0x2a, 0x3, 0x2a, 0x3, 0x2a, 
    0x7, 0x2a, 0x260, 0xa, 0x2a, 0xc, 0x2a, 0xe, 0x2a, 0x263, 0xb, 0x2a, 
    0x3, 0x2a, 0x3, 0x2a, 0x5, 0x2a, 0x267, 0xa, 0x2a, 0x3, 0x2b, 0x3, 0x2b, 
    0x3, 0x2b, 0x3, 0x2b, 0x3, 0x2b, 0x5, 0x2b, 0x26e, 0xa, 0x2b, 0x3, 0x2b, 
    0x3, 0x2b, 0x3, 0x2c, 0x3, 0x2c, 0x3, 0x2c, 0x3, 0x2d, 0x3, 0x2d, 0x3, 
    0x2d, 0x3, 0x2d, 0x3, 0x2d, 0x3, 0x2d, 0x3, 0x2e, 0x3, 0x2e, 0x3, 0x2e, 
    0x3, 0x2e, 0x3, 0x2e, 0x3, 0x2e, 0x3, 0x2f, 0x3, 0x2f, 0x3, 0x2f, 0x3, 
    0x2f, 0x3, 0x2f, 0x7, 0x2f, 0x286, 0xa, 0x2f, 0xc, 0x2f, 0xe, 0x2f, 
    0x289, 0xb, 0x2f, 0x3, 0x2f, 0x5, 0x2f, 0x28c, 0xa, 0x2f, 0x3, 0x30, 
    0x3, 0x30, 0x3, 0x30, 0x3, 0x30, 0x3, 0x31, 0x3, 0x31, 0x5, 0x31, 0x294, 
    0xa, 0x31, 0x3, 0x31, 0x3, 0x31, 0x3, 0x32, 0x3, 0x32, 0x3, 0x32, 0x3, 
    0x32, 0x3, 0x32, 0x3, 0x32, 0x3, 0x32, 0x3, 0x32, 0x7, 0x32, 0x2a0, 
    0xa, 0x32, 0xc, 0x32, 0xe, 0x32, 0x2a3, 0xb, 0x32, 0x3, 0x32, 0x3, 0x32, 
    0x3, 0x33, 0x3, 0x33, 0x3, 0x33, 0x3, 0x33, 0x3, 0x33, 0x3, 0x33, 0x3, 
    0x33, 0x5, 0x33, 0x2ae, 0xa, 0x33, 0x3, 0x33, 0x3, 0x33, 0x5, 0x33, 
    0x2b2, 0xa, 0x33, 0x3, 0x34, 0x3, 0x34, 0x6, 0x34, 0x2b6, 0xa, 0x34, 
    0xd, 0x34, 0xe, 0x34, 0x2b7, 0x3, 0x34, 0x3, 0x34, 0x5, 0x34, 0x2bc, 
    0xa, 0x34, 0x3, 0x34, 0x3, 0x34, 0x5, 0x34, 0x2c0, 0xa, 0x34, 0x3, 0x35, 
    0x3, 0x35, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x3, 0x36, 0x5, 
    0x36, 0x2c9, 0xa, 0x36, 0x5, 0x36, 0x2cb, 0xa, 0x36, 0x3, 0x37, 0x3, 
    0x37, 0x3, 0x37, 0x5, 0x37, 0x2d0, 0xa, 0x37, 0x3, 0x37, 0x3, 0x37, 
    0x3, 0x37, 0x5, 0x37, 0x2d5, 0xa, 0x37, 0x3, 0x37, 0x3, 0x37, 0x3, 0x37, 
    0x5, 0x37, 0x2da, 0xa, 0x37, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 
    0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x5, 0x38, 0x2e5, 
    0xa, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 
    0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 
    0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 
    0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 
    0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 
    0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 
    0x7, 0x38, 0x30d, 0xa, 0x38, 0xc, 0x38, 0xe, 0x38, 0x310, 0xb, 0x38, 
    0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x3, 0x38, 0x7, 0x38, 0x316, 0xa, 0x38, 
    0xc, 0x38, 0xe, 0x38, 0x319, 0xb, 0x38, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 
    0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 
    0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x7, 0x39, 0x328, 0xa, 0x39, 
    0xc, 0x39, 0xe, 0x39, 0x32b, 0xb, 0x39, 0x3, 0x39, 0x5, 0x39, 0x32e, 
    0xa, 0x39, 0x5, 0x39, 0x330, 0xa, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 
    0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x3, 0x39, 0x5, 0x39, 0x33a, 
    0xa, 0x39, 0x3, 0x3a, 0x3, 0x3a, 0x3, 0x3a, 0x7, 0x3a, 0x33f, 0xa, 0x3a, 
    0xc, 0x3a, 0xe, 0x3a, 0x342, 0xb, 0x3a, 0x3, 0x3a, 0x5, 0x3a, 0x345, 
    0xa, 0x3a, 0x3, 0x3b, 0x3, 0x3b, 0x3, 0x3b, 0x5, 0x3b, 0x34a, 0xa, 0x3b, 
    0x3, 0x3c, 0x3, 0x3c, 0x3, 0x3c, 0x5, 0x3c, 0x34f, 0xa, 0x3c, 0x3, 0x3c, 
    0x6, 0x3c, 0x352, 0xa, 0x3c, 0xd, 0x3c, 0xe, 0x3c, 0x353, 0x3, 0x3c, 
    0x3, 0x3c, 0x7, 0x3c, 0x358, 0xa, 0x3c, 0xc, 0x3c, 0xe, 0x3c, 0x35b, 
    0xb, 0x3c, 0x3, 0x3c, 0x3, 0x3c, 0x6, 0x3c, 0x35f, 0xa, 0x3c, 0xd, 0x3c, 
    0xe, 0x3c, 0x360, 0x3, 0x3c, 0x5, 0x3c, 0x364, 0xa, 0x3c, 0x3, 0x3d, 
    0x3, 0x3d, 0x3, 0x3d, 0x3, 0x3d, 0x3, 0x3e, 0x3, 0x3e, 0x3, 0x3e, 0x5, 
    0x3e, 0x36d, 0xa, 0x3e, 0x5, 0x3e, 0x36f, 0xa, 0x3e, 0x3, 0x3e, 0x3, 
    0x3e, 0x5, 0x3e, 0x373, 0xa, 0x3e, 0x5, 0x3e, 0x375, 0xa, 0x3e, 0x3, 
    0x3f, 0x3, 0x3f, 0x3, 0x3f, 0x3, 0x3f, 0x7, 0x3f, 0x37b, 0xa, 0x3f, 
    0xc, 0x3f, 0xe, 0x3f, 0x37e, 0xb, 0x3f, 0x3, 0x3f, 0x5, 0x3f, 0x381, 
    0xa, 0x3f, 0x5, 0x3f, 0x383, 0xa, 0x3f, 0x3, 0x3f, 0x3, 0x3f, 0x3, 0x40, 
    0x3, 0x40, 0x3, 0x40, 0x5, 0x40, 0x38a, 0xa, 0x40, 0x3, 0x40, 0x3, 0x40, 
    0x3, 0x41, 0x3, 0x41, 0x3, 0x42, 0x3, 0x42, 0x3, 0x42, 0x2, 0x3, 0x6e, 
    0x43, 0x2, 0x4, 0x6, 0x8, 0xa, 0xc, 0xe, 0x10, 0x12, 0x14, 0x16, 0x18, 
    0x1a, 0x1c, 0x1e, 0x20, 0x22, 0x24, 0x26, 0x28, 0x2a, 0x2c, 0x2e, 0x30, 
    0x32, 0x34, 0x36, 0x38, 0x3a, 0x3c, 0x3e, 0x40, 0x42, 0x44, 0x46, 0x48, 
    0x4a, 0x4c, 0x4e, 0x50, 0x52, 0x54, 0x56, 0x58, 0x5a, 0x5c, 0x5e, 0x60, 
    0x62, 0x64, 0x66, 0x68, 0x6a, 0x6c, 0x6e, 0x70, 0x72, 0x74, 0x76, 0x78, 
    0x7a, 0x7c, 0x7e, 0x80, 0x82, 0x2, 0xf, 0x3, 0x2, 0x3, 0x4, 0x3, 0x2, 
    0x3a, 0x3b, 0x3, 0x2, 0x57, 0x58, 0x3, 0x2, 0x25, 0x27, 0x3, 0x2, 0x50, 
    0x51, 0x3, 0x2, 0x4a, 0x4e, 0x4, 0x2, 0x49, 0x49, 0x55, 0x56, 0x4, 0x2, 
    0x52, 0x53, 0x57, 0x5a, 0x3, 0x2, 0x55, 0x56, 0x3, 0x2, 0x43, 0x46, 
    0x3, 0x2, 0x41, 0x42, 0x5, 0x2, 0x23, 0x24, 0x2c, 0x2e, 0x30, 0x31, 
    0x4, 0x2, 0x28, 0x2b, 0x33, 0x33, 0x2, 0x3ee, 0x2, 0x87, 0x3, 0x2, 0x2, 
    0x2, 0x4, 0xab, 0x3, 0x2, 0x2, 0x2, 0x6, 0xc2, 0x3, 0x2, 0x2, 0x2, 0x8, 
    0xc4, 0x3, 0x2, 0x2, 0x2, 0xa, 0xcd, 0x3, 0x2, 0x2, 0x2, 0xc, 0xd8, 
    0x3, 0x2, 0x2, 0x2, 0xe, 0xe3, 0x3, 0x2, 0x2, 0x2, 0x10, 0xf1, 0x3, 
    0x2, 0x2, 0x2, 0x12, 0xf3, 0x3, 0x2, 0x2, 0x2, 0x14, 0x103, 0x3, 0x2, 
    0x2, 0x2, 0x16, 0x108, 0x3, 0x2, 0x2, 0x2, 0x18, 0x11e, 0x3, 0x2, 0x2, 
    0x2, 0x1a, 0x139, 0x3, 0x2, 0x2, 0x2, 0x1c, 0x140, 0x3, 0x2, 0x2, 0x2, 
    0x1e, 0x142, 0x3, 0x2, 0x2, 0x2, 0x20, 0x162, 0x3, 0x2, 0x2, 0x2, 0x22, 
    0x164, 0x3, 0x2, 0x2, 0x2, 0x24, 0x172, 0x3, 0x2, 0x2, 0x2, 0x26, 0x185, 
    0x3, 0x2, 0x2, 0x2, 0x28, 0x18e, 0x3, 0x2, 0x2, 0x2, 0x2a, 0x194, 0x3, 
    0x2, 0x2, 0x2, 0x2c, 0x19c, 0x3, 0x2, 0x2, 0x2, 0x2e, 0x1a3, 0x3, 0x2, 
    0x2, 0x2, 0x30, 0x1b5, 0x3, 0x2, 0x2, 0x2, 0x32, 0x1b9, 0x3, 0x2, 0x2, 
    0x2, 0x34, 0x1bb, 0x3, 0x2, 0x2, 0x2, 0x36, 0x1d2, 0x3, 0x2, 0x2, 0x2, 
    0x38, 0x1d4, 0x3, 0x2, 0x2, 0x2, 0x3a, 0x1d8, 0x3, 0x2, 0x2, 0x2, 0x3c, 
    0x1e0, 0x3, 0x2, 0x2, 0x2, 0x3e, 0x1e2, 0x3, 0x2, 0x2, 0x2, 0x40, 0x1f0, 
    0x3, 0x2, 0x2, 0x2, 0x42, 0x1f2, 0x3, 0x2, 0x2, 0x2, 0x44, 0x1f8, 0x3, 
    0x2, 0x2, 0x2, 0x46, 0x1ff, 0x3, 0x2, 0x2, 0x2, 0x48, 0x220, 0x3, 0x2, 
    0x2, 0x2, 0x4a, 0x22c, 0x3, 0x2, 0x2, 0x2, 0x4c, 0x22e, 0x3, 0x2, 0x2, 
    0x2, 0x4e, 0x236, 0x3, 0x2, 0x2, 0x2, 0x50, 0x253, 0x3, 0x2, 0x2, 0x2, 
    0x52, 0x25c, 0x3, 0x2, 0x2, 0x2, 0x54, 0x268, 0x3, 0x2, 0x2, 0x2, 0x56, 
    0x271, 0x3, 0x2, 0x2, 0x2, 0x58, 0x274, 0x3, 0x2, 0x2, 0x2, 0x5a, 0x27a, 
    0x3, 0x2, 0x2, 0x2, 0x5c, 0x280, 0x3, 0x2, 0x2, 0x2, 0x5e, 0x28d, 0x3, 
    0x2, 0x2, 0x2, 0x60, 0x291, 0x3, 0x2, 0x2, 0x2, 0x62, 0x297, 0x3, 0x2, 
    0x2, 0x2, 0x64, 0x2b1, 0x3, 0x2, 0x2, 0x2, 0x66, 0x2bf, 0x3, 0x2, 0x2, 
    0x2, 0x68, 0x2c1, 0x3, 0x2, 0x2, 0x2, 0x6a, 0x2ca, 0x3, 0x2, 0x2, 0x2, 
    0x6c, 0x2cc, 0x3, 0x2, 0x2, 0x2, 0x6e, 0x2e4, 0x3, 0x2, 0x2, 0x2, 0x70, 
    0x339, 0x3, 0x2, 0x2, 0x2, 0x72, 0x33b, 0x3, 0x2, 0x2, 0x2, 0x74, 0x346, 
    0x3, 0x2, 0x2, 0x2, 0x76, 0x34b, 0x3, 0x2, 0x2, 0x2, 0x78, 0x365, 0x3, 
    0x2, 0x2, 0x2, 0x7a, 0x374, 0x3, 0x2, 0x2, 0x2, 0x7c, 0x376, 0x3, 0x2, 
    0x2, 0x2, 0x7e, 0x389, 0x3, 0x2, 0x2, 0x2, 0x80, 0x38d, 0x3, 0x2, 0x2, 
    0x2, 0x82, 0x38f, 0x3, 0x2, 0x2, 0x2, 0x84, 0x86, 0x5, 0x4, 0x3, 0x2, 
    0x85, 0x84, 0x3, 0x2, 0x2, 0x2, 0x86, 0x89, 0x3, 0x2, 0x2, 0x2, 0x87, 
    0x85, 0x3, 0x2, 0x2, 0x2, 0x87, 0x88, 0x3, 0x2, 0x2, 0x2, 0x88, 0x8a, 
    0x3, 0x2, 0x2, 0x2, 0x89, 0x87, 0x3, 0x2, 0x2, 0x2, 0x8a, 0x8b, 0x7, 
    0x2, 0x2, 0x3, 0x8b, 0x3, 0x3, 0x2, 0x2, 0x2, 0x8c, 0xac, 0x5, 0x8, 
    0x5, 0x2, 0x8d, 0xac, 0x7, 0x3a, 0x2, 0x2, 0x8e, 0x8f, 0x5, 0xa, 0x6, 
    0x2, 0x8f, 0x90, 0x7, 0x3a, 0x2, 0x2, 0x90, 0xac, 0x3, 0x2, 0x2, 0x2, 
    0x91, 0x92, 0x5, 0xc, 0x7, 0x2, 0x92, 0x93, 0x7, 0x3a, 0x2, 0x2, 0x93, 
    0xac, 0x3, 0x2, 0x2, 0x2, 0x94, 0xac, 0x5, 0x16, 0xc, 0x2, 0x95, 0xac, 
    0x5, 0x1a, 0xe, 0x2, 0x96, 0xac, 0x5, 0x22, 0x12, 0x2, 0x97, 0xac, 0x5, 
    0x24, 0x13, 0x2, 0x98, 0x99, 0x5, 0x26, 0x14, 0x2, 0x99, 0x9a, 0x7, 
    0x3a, 0x2, 0x2, 0x9a, 0xac, 0x3, 0x2, 0x2, 0x2, 0x9b, 0xac, 0x5, 0x28, 
    0x15, 0x2, 0x9c, 0xac, 0x5, 0x3e, 0x20, 0x2, 0x9d, 0xac, 0x5, 0x42, 
    0x22, 0x2, 0x9e, 0x9f, 0x5, 0x44, 0x23, 0x2, 0x9f, 0xa0, 0x7, 0x3a, 
    0x2, 0x2, 0xa0, 0xac, 0x3, 0x2, 0x2, 0x2, 0xa1, 0xac, 0x5, 0x46, 0x24, 
    0x2, 0xa2, 0xac, 0x5, 0x4e, 0x28, 0x2, 0xa3, 0xac, 0x5, 0x52, 0x2a, 
    0x2, 0xa4, 0xac, 0x5, 0x56, 0x2c, 0x2, 0xa5, 0xac, 0x5, 0x58, 0x2d, 
    0x2, 0xa6, 0xac, 0x5, 0x5a, 0x2e, 0x2, 0xa7, 0xac, 0x5, 0x5e, 0x30, 
    0x2, 0xa8, 0xac, 0x5, 0x60, 0x31, 0x2, 0xa9, 0xac, 0x5, 0x62, 0x32, 
    0x2, 0xaa, 0xac, 0x5, 0x6, 0x4, 0x2, 0xab, 0x8c, 0x3, 0x2, 0x2, 0x2, 
    0xab, 0x8d, 0x3, 0x2, 0x2, 0x2, 0xab, 0x8e, 0x3, 0x2, 0x2, 0x2, 0xab, 
    0x91, 0x3, 0x2, 0x2, 0x2, 0xab, 0x94, 0x3, 0x2, 0x2, 0x2, 0xab, 0x95, 
    0x3, 0x2, 0x2, 0x2, 0xab, 0x96, 0x3, 0x2, 0x2, 0x2, 0xab, 0x97, 0x3, 
    0x2, 0x2, 0x2, 0xab, 0x98, 0x3, 0x2, 0x2, 0x2, 0xab, 0x9b, 0x3, 0x2, 
    0x2, 0x2, 0xab, 0x9c, 0x3, 0x2, 0x2, 0x2, 0xab, 0x9d, 0x3, 0x2, 0x2, 
    0x2, 0xab, 0x9e, 0x3, 0x2, 0x2, 0x2, 0xab, 0xa1, 0x3, 0x2, 0x2, 0x2, 
    0xab, 0xa2, 0x3, 0x2, 0x2, 0x2, 0xab, 0xa3, 0x3, 0x2, 0x2, 0x2, 0xab, 
    0xa4, 0x3, 0x2, 0x2, 0x2, 0xab, 0xa5, 0x3, 0x2, 0x2, 0x2, 0xab, 0xa6, 
    0x3, 0x2, 0x2, 0x2, 0xab, 0xa7, 0x3, 0x2, 0x2, 0x2, 0xab, 0xa8, 0x3, 
    0x2, 0x2, 0x2, 0xab, 0xa9, 0x3, 0x2, 0x2, 0x2, 0xab, 0xaa, 0x3, 0x2, 
    0x2, 0x2, 0xac, 0x5, 0x3, 0x2, 0x2, 0x2, 0xad, 0xae, 0x5, 0x64, 0x33, 
    0x2, 0xae, 0xaf, 0x7, 0x3a, 0x2, 0x2, 0xaf, 0xc3, 0x3, 0x2, 0x2, 0x2, 
    0xb0, 0xb1, 0x5, 0x5c, 0x2f, 0x2, 0xb1, 0xb2, 0x7, 0x3a, 0x2, 0x2, 0xb2, 
    0xc3, 0x3, 0x2, 0x2, 0x2, 0xb3, 0xb4, 0x7, 0x15, 0x2, 0x2, 0xb4, 0xc3, 
    0x7, 0x3a, 0x2, 0x2, 0xb5, 0xb6, 0x7, 0x16, 0x2, 0x2, 0xb6, 0xc3, 0x7, 
    0x3a, 0x2, 0x2, 0xb7, 0xb8, 0x7, 0x1c, 0x2, 0x2, 0xb8, 0xc3, 0x7, 0x3a, 
    0x2, 0x2, 0xb9, 0xbb, 0x7, 0x17, 0x2, 0x2, 0xba, 0xbc, 0x5, 0x6a, 0x36, 
    0x2, 0xbb, 0xba, 0x3, 0x2, 0x2, 0x2, 0xbb, 0xbc, 0x3, 0x2, 0x2, 0x2, 
    0xbc, 0xbd, 0x3, 0x2, 0x2, 0x2, 0xbd, 0xc3, 0x7, 0x3a, 0x2, 0x2, 0xbe, 
    0xbf, 0x7, 0x1b, 0x2, 0x2, 0xbf, 0xc0, 0x5, 0x6a, 0x36, 0x2, 0xc0, 0xc1, 
    0x7, 0x3a, 0x2, 0x2, 0xc1, 0xc3, 0x3, 0x2, 0x2, 0x2, 0xc2, 0xad, 0x3, 
    0x2, 0x2, 0x2, 0xc2, 0xb0, 0x3, 0x2, 0x2, 0x2, 0xc2, 0xb3, 0x3, 0x2, 
    0x2, 0x2, 0xc2, 0xb5, 0x3, 0x2, 0x2, 0x2, 0xc2, 0xb7, 0x3, 0x2, 0x2, 
    0x2, 0xc2, 0xb9, 0x3, 0x2, 0x2, 0x2, 0xc2, 0xbe, 0x3, 0x2, 0x2, 0x2, 
    0xc3, 0x7, 0x3, 0x2, 0x2, 0x2, 0xc4, 0xc8, 0x7, 0x34, 0x2, 0x2, 0xc5, 
    0xc7, 0x5, 0x4, 0x3, 0x2, 0xc6, 0xc5, 0x3, 0x2, 0x2, 0x2, 0xc7, 0xca, 
    0x3, 0x2, 0x2, 0x2, 0xc8, 0xc6, 0x3, 0x2, 0x2, 0x2, 0xc8, 0xc9, 0x3, 
    0x2, 0x2, 0x2, 0xc9, 0xcb, 0x3, 0x2, 0x2, 0x2, 0xca, 0xc8, 0x3, 0x2, 
    0x2, 0x2, 0xcb, 0xcc, 0x7, 0x35, 0x2, 0x2, 0xcc, 0x9, 0x3, 0x2, 0x2, 
    0x2, 0xcd, 0xce, 0x9, 0x2, 0x2, 0x2, 0xce, 0xd1, 0x5, 0x82, 0x42, 0x2, 
    0xcf, 0xd0, 0x7, 0x3d, 0x2, 0x2, 0xd0, 0xd2, 0x5, 0x32, 0x1a, 0x2, 0xd1, 
    0xcf, 0x3, 0x2, 0x2, 0x2, 0xd1, 0xd2, 0x3, 0x2, 0x2, 0x2, 0xd2, 0xd5, 
    0x3, 0x2, 0x2, 0x2, 0xd3, 0xd4, 0x7, 0x4f, 0x2, 0x2, 0xd4, 0xd6, 0x5, 
    0x10, 0x9, 0x2, 0xd5, 0xd3, 0x3, 0x2, 0x2, 0x2, 0xd5, 0xd6, 0x3, 0x2, 
    0x2, 0x2, 0xd6, 0xb, 0x3, 0x2, 0x2, 0x2, 0xd7, 0xd9, 0x7, 0x9, 0x2, 
    0x2, 0xd8, 0xd7, 0x3, 0x2, 0x2, 0x2, 0xd8, 0xd9, 0x3, 0x2, 0x2, 0x2, 
    0xd9, 0xda, 0x3, 0x2, 0x2, 0x2, 0xda, 0xdb, 0x5, 0x2a, 0x16, 0x2, 0xdb, 
    0xe0, 0x5, 0xe, 0x8, 0x2, 0xdc, 0xdd, 0x7, 0x3b, 0x2, 0x2, 0xdd, 0xdf, 
    0x5, 0xe, 0x8, 0x2, 0xde, 0xdc, 0x3, 0x2, 0x2, 0x2, 0xdf, 0xe2, 0x3, 
    0x2, 0x2, 0x2, 0xe0, 0xde, 0x3, 0x2, 0x2, 0x2, 0xe0, 0xe1, 0x3, 0x2, 
    0x2, 0x2, 0xe1, 0xd, 0x3, 0x2, 0x2, 0x2, 0xe2, 0xe0, 0x3, 0x2, 0x2, 
    0x2, 0xe3, 0xe8, 0x5, 0x82, 0x42, 0x2, 0xe4, 0xe5, 0x7, 0x38, 0x2, 0x2, 
    0xe5, 0xe7, 0x7, 0x39, 0x2, 0x2, 0xe6, 0xe4, 0x3, 0x2, 0x2, 0x2, 0xe7, 
    0xea, 0x3, 0x2, 0x2, 0x2, 0xe8, 0xe6, 0x3, 0x2, 0x2, 0x2, 0xe8, 0xe9, 
    0x3, 0x2, 0x2, 0x2, 0xe9, 0xed, 0x3, 0x2, 0x2, 0x2, 0xea, 0xe8, 0x3, 
    0x2, 0x2, 0x2, 0xeb, 0xec, 0x7, 0x4f, 0x2, 0x2, 0xec, 0xee, 0x5, 0x10, 
    0x9, 0x2, 0xed, 0xeb, 0x3, 0x2, 0x2, 0x2, 0xed, 0xee, 0x3, 0x2, 0x2, 
    0x2, 0xee, 0xf, 0x3, 0x2, 0x2, 0x2, 0xef, 0xf2, 0x5, 0x6a, 0x36, 0x2, 
    0xf0, 0xf2, 0x5, 0x12, 0xa, 0x2, 0xf1, 0xef, 0x3, 0x2, 0x2, 0x2, 0xf1, 
    0xf0, 0x3, 0x2, 0x2, 0x2, 0xf2, 0x11, 0x3, 0x2, 0x2, 0x2, 0xf3, 0xff, 
    0x7, 0x34, 0x2, 0x2, 0xf4, 0xf9, 0x5, 0x14, 0xb, 0x2, 0xf5, 0xf6, 0x7, 
    0x3b, 0x2, 0x2, 0xf6, 0xf8, 0x5, 0x14, 0xb, 0x2, 0xf7, 0xf5, 0x3, 0x2, 
    0x2, 0x2, 0xf8, 0xfb, 0x3, 0x2, 0x2, 0x2, 0xf9, 0xf7, 0x3, 0x2, 0x2, 
    0x2, 0xf9, 0xfa, 0x3, 0x2, 0x2, 0x2, 0xfa, 0xfd, 0x3, 0x2, 0x2, 0x2, 
    0xfb, 0xf9, 0x3, 0x2, 0x2, 0x2, 0xfc, 0xfe, 0x7, 0x3b, 0x2, 0x2, 0xfd, 
    0xfc, 0x3, 0x2, 0x2, 0x2, 0xfd, 0xfe, 0x3, 0x2, 0x2, 0x2, 0xfe, 0x100, 
    0x3, 0x2, 0x2, 0x2, 0xff, 0xf4, 0x3, 0x2, 0x2, 0x2, 0xff, 0x100, 0x3, 
    0x2, 0x2, 0x2, 0x100, 0x101, 0x3, 0x2, 0x2, 0x2, 0x101, 0x102, 0x7, 
    0x35, 0x2, 0x2, 0x102, 0x13, 0x3, 0x2, 0x2, 0x2, 0x103, 0x106, 0x5, 
    0x10, 0x9, 0x2, 0x104, 0x105, 0x7, 0x3d, 0x2, 0x2, 0x105, 0x107, 0x5, 
    0x10, 0x9, 0x2, 0x106, 0x104, 0x3, 0x2, 0x2, 0x2, 0x106, 0x107, 0x3, 
    0x2, 0x2, 0x2, 0x107, 0x15, 0x3, 0x2, 0x2, 0x2, 0x108, 0x109, 0x5, 0x3a, 
    0x1e, 0x2, 0x109, 0x10a, 0x5, 0x82, 0x42, 0x2, 0x10a, 0x10e, 0x7, 0x34, 
    0x2, 0x2, 0x10b, 0x10d, 0x5, 0x18, 0xd, 0x2, 0x10c, 0x10b, 0x3, 0x2, 
    0x2, 0x2, 0x10d, 0x110, 0x3, 0x2, 0x2, 0x2, 0x10e, 0x10c, 0x3, 0x2, 
    0x2, 0x2, 0x10e, 0x10f, 0x3, 0x2, 0x2, 0x2, 0x10f, 0x111, 0x3, 0x2, 
    0x2, 0x2, 0x110, 0x10e, 0x3, 0x2, 0x2, 0x2, 0x111, 0x112, 0x7, 0x35, 
    0x2, 0x2, 0x112, 0x17, 0x3, 0x2, 0x2, 0x2, 0x113, 0x114, 0x5, 0x82, 
    0x42, 0x2, 0x114, 0x115, 0x7, 0x3d, 0x2, 0x2, 0x115, 0x116, 0x5, 0x6a, 
    0x36, 0x2, 0x116, 0x117, 0x9, 0x3, 0x2, 0x2, 0x117, 0x11f, 0x3, 0x2, 
    0x2, 0x2, 0x118, 0x119, 0x5, 0x82, 0x42, 0x2, 0x119, 0x11a, 0x5, 0x82, 
    0x42, 0x2, 0x11a, 0x11b, 0x5, 0x7c, 0x3f, 0x2, 0x11b, 0x11c, 0x7, 0x3a, 
    0x2, 0x2, 0x11c, 0x11f, 0x3, 0x2, 0x2, 0x2, 0x11d, 0x11f, 0x7, 0x3a, 
    0x2, 0x2, 0x11e, 0x113, 0x3, 0x2, 0x2, 0x2, 0x11e, 0x118, 0x3, 0x2, 
    0x2, 0x2, 0x11e, 0x11d, 0x3, 0x2, 0x2, 0x2, 0x11f, 0x19, 0x3, 0x2, 0x2, 
    0x2, 0x120, 0x121, 0x7, 0x5, 0x2, 0x2, 0x121, 0x122, 0x5, 0x82, 0x42, 
    0x2, 0x122, 0x124, 0x7, 0x36, 0x2, 0x2, 0x123, 0x125, 0x5, 0x1e, 0x10, 
    0x2, 0x124, 0x123, 0x3, 0x2, 0x2, 0x2, 0x124, 0x125, 0x3, 0x2, 0x2, 
    0x2, 0x125, 0x126, 0x3, 0x2, 0x2, 0x2, 0x126, 0x129, 0x7, 0x37, 0x2, 
    0x2, 0x127, 0x128, 0x7, 0x3f, 0x2, 0x2, 0x128, 0x12a, 0x5, 0x30, 0x19, 
    0x2, 0x129, 0x127, 0x3, 0x2, 0x2, 0x2, 0x129, 0x12a, 0x3, 0x2, 0x2, 
    0x2, 0x12a, 0x12b, 0x3, 0x2, 0x2, 0x2, 0x12b, 0x12c, 0x5, 0x1c, 0xf, 
    0x2, 0x12c, 0x13a, 0x3, 0x2, 0x2, 0x2, 0x12d, 0x130, 0x5, 0x2a, 0x16, 
    0x2, 0x12e, 0x130, 0x7, 0xa, 0x2, 0x2, 0x12f, 0x12d, 0x3, 0x2, 0x2, 
    0x2, 0x12f, 0x12e, 0x3, 0x2, 0x2, 0x2, 0x130, 0x131, 0x3, 0x2, 0x2, 
    0x2, 0x131, 0x132, 0x5, 0x82, 0x42, 0x2, 0x132, 0x134, 0x7, 0x36, 0x2, 
    0x2, 0x133, 0x135, 0x5, 0x1e, 0x10, 0x2, 0x134, 0x133, 0x3, 0x2, 0x2, 
    0x2, 0x134, 0x135, 0x3, 0x2, 0x2, 0x2, 0x135, 0x136, 0x3, 0x2, 0x2, 
    0x2, 0x136, 0x137, 0x7, 0x37, 0x2, 0x2, 0x137, 0x138, 0x5, 0x8, 0x5, 
    0x2, 0x138, 0x13a, 0x3, 0x2, 0x2, 0x2, 0x139, 0x120, 0x3, 0x2, 0x2, 
    0x2, 0x139, 0x12f, 0x3, 0x2, 0x2, 0x2, 0x13a, 0x1b, 0x3, 0x2, 0x2, 0x2, 
    0x13b, 0x141, 0x5, 0x8, 0x5, 0x2, 0x13c, 0x13d, 0x7, 0x40, 0x2, 0x2, 
    0x13d, 0x13e, 0x5, 0x6a, 0x36, 0x2, 0x13e, 0x13f, 0x7, 0x3a, 0x2, 0x2, 
    0x13f, 0x141, 0x3, 0x2, 0x2, 0x2, 0x140, 0x13b, 0x3, 0x2, 0x2, 0x2, 
    0x140, 0x13c, 0x3, 0x2, 0x2, 0x2, 0x141, 0x1d, 0x3, 0x2, 0x2, 0x2, 0x142, 
    0x147, 0x5, 0x20, 0x11, 0x2, 0x143, 0x144, 0x7, 0x3b, 0x2, 0x2, 0x144, 
    0x146, 0x5, 0x20, 0x11, 0x2, 0x145, 0x143, 0x3, 0x2, 0x2, 0x2, 0x146, 
    0x149, 0x3, 0x2, 0x2, 0x2, 0x147, 0x145, 0x3, 0x2, 0x2, 0x2, 0x147, 
    0x148, 0x3, 0x2, 0x2, 0x2, 0x148, 0x14b, 0x3, 0x2, 0x2, 0x2, 0x149, 
    0x147, 0x3, 0x2, 0x2, 0x2, 0x14a, 0x14c, 0x7, 0x3b, 0x2, 0x2, 0x14b, 
    0x14a, 0x3, 0x2, 0x2, 0x2, 0x14b, 0x14c, 0x3, 0x2, 0x2, 0x2, 0x14c, 
    0x1f, 0x3, 0x2, 0x2, 0x2, 0x14d, 0x150, 0x5, 0x82, 0x42, 0x2, 0x14e, 
    0x14f, 0x7, 0x3d, 0x2, 0x2, 0x14f, 0x151, 0x5, 0x32, 0x1a, 0x2, 0x150, 
    0x14e, 0x3, 0x2, 0x2, 0x2, 0x150, 0x151, 0x3, 0x2, 0x2, 0x2, 0x151, 
    0x154, 0x3, 0x2, 0x2, 0x2, 0x152, 0x153, 0x7, 0x4f, 0x2, 0x2, 0x153, 
    0x155, 0x5, 0x6a, 0x36, 0x2, 0x154, 0x152, 0x3, 0x2, 0x2, 0x2, 0x154, 
    0x155, 0x3, 0x2, 0x2, 0x2, 0x155, 0x163, 0x3, 0x2, 0x2, 0x2, 0x156, 
    0x158, 0x7, 0x9, 0x2, 0x2, 0x157, 0x156, 0x3, 0x2, 0x2, 0x2, 0x157, 
    0x158, 0x3, 0x2, 0x2, 0x2, 0x158, 0x159, 0x3, 0x2, 0x2, 0x2, 0x159, 
    0x15a, 0x5, 0x2a, 0x16, 0x2, 0x15a, 0x15f, 0x5, 0x82, 0x42, 0x2, 0x15b, 
    0x15c, 0x7, 0x38, 0x2, 0x2, 0x15c, 0x15e, 0x7, 0x39, 0x2, 0x2, 0x15d, 
    0x15b, 0x3, 0x2, 0x2, 0x2, 0x15e, 0x161, 0x3, 0x2, 0x2, 0x2, 0x15f, 
    0x15d, 0x3, 0x2, 0x2, 0x2, 0x15f, 0x160, 0x3, 0x2, 0x2, 0x2, 0x160, 
    0x163, 0x3, 0x2, 0x2, 0x2, 0x161, 0x15f, 0x3, 0x2, 0x2, 0x2, 0x162, 
    0x14d, 0x3, 0x2, 0x2, 0x2, 0x162, 0x157, 0x3, 0x2, 0x2, 0x2, 0x163, 
    0x21, 0x3, 0x2, 0x2, 0x2, 0x164, 0x165, 0x7, 0x6, 0x2, 0x2, 0x165, 0x166, 
    0x5, 0x82, 0x42, 0x2, 0x166, 0x16d, 0x7, 0x34, 0x2, 0x2, 0x167, 0x168, 
    0x5, 0x20, 0x11, 0x2, 0x168, 0x169, 0x9, 0x3, 0x2, 0x2, 0x169, 0x16c, 
    0x3, 0x2, 0x2, 0x2, 0x16a, 0x16c, 0x7, 0x3a, 0x2, 0x2, 0x16b, 0x167, 
    0x3, 0x2, 0x2, 0x2, 0x16b, 0x16a, 0x3, 0x2, 0x2, 0x2, 0x16c, 0x16f, 
    0x3, 0x2, 0x2, 0x2, 0x16d, 0x16b, 0x3, 0x2, 0x2, 0x2, 0x16d, 0x16e, 
    0x3, 0x2, 0x2, 0x2, 0x16e, 0x170, 0x3, 0x2, 0x2, 0x2, 0x16f, 0x16d, 
    0x3, 0x2, 0x2, 0x2, 0x170, 0x171, 0x7, 0x35, 0x2, 0x2, 0x171, 0x23, 
    0x3, 0x2, 0x2, 0x2, 0x172, 0x173, 0x7, 0x7, 0x2, 0x2, 0x173, 0x174, 
    0x5, 0x82, 0x42, 0x2, 0x174, 0x175, 0x7, 0x34, 0x2, 0x2, 0x175, 0x17a, 
    0x5, 0x82, 0x42, 0x2, 0x176, 0x177, 0x9, 0x3, 0x2, 0x2, 0x177, 0x179, 
    0x5, 0x82, 0x42, 0x2, 0x178, 0x176, 0x3, 0x2, 0x2, 0x2, 0x179, 0x17c, 
    0x3, 0x2, 0x2, 0x2, 0x17a, 0x178, 0x3, 0x2, 0x2, 0x2, 0x17a, 0x17b, 
    0x3, 0x2, 0x2, 0x2, 0x17b, 0x180, 0x3, 0x2, 0x2, 0x2, 0x17c, 0x17a, 
    0x3, 0x2, 0x2, 0x2, 0x17d, 0x17f, 0x9, 0x3, 0x2, 0x2, 0x17e, 0x17d, 
    0x3, 0x2, 0x2, 0x2, 0x17f, 0x182, 0x3, 0x2, 0x2, 0x2, 0x180, 0x17e, 
    0x3, 0x2, 0x2, 0x2, 0x180, 0x181, 0x3, 0x2, 0x2, 0x2, 0x181, 0x183, 
    0x3, 0x2, 0x2, 0x2, 0x182, 0x180, 0x3, 0x2, 0x2, 0x2, 0x183, 0x184, 
    0x7, 0x35, 0x2, 0x2, 0x184, 0x25, 0x3, 0x2, 0x2, 0x2, 0x185, 0x188, 
    0x7, 0x8, 0x2, 0x2, 0x186, 0x189, 0x7, 0x31, 0x2, 0x2, 0x187, 0x189, 
    0x5, 0x3a, 0x1e, 0x2, 0x188, 0x186, 0x3, 0x2, 0x2, 0x2, 0x188, 0x187, 
    0x3, 0x2, 0x2, 0x2, 0x189, 0x18c, 0x3, 0x2, 0x2, 0x2, 0x18a, 0x18b, 
    0x7, 0x2b, 0x2, 0x2, 0x18b, 0x18d, 0x5, 0x82, 0x42, 0x2, 0x18c, 0x18a, 
    0x3, 0x2, 0x2, 0x2, 0x18c, 0x18d, 0x3, 0x2, 0x2, 0x2, 0x18d, 0x27, 0x3, 
    0x2, 0x2, 0x2, 0x18e, 0x18f, 0x7, 0x28, 0x2, 0x2, 0x18f, 0x190, 0x7, 
    0x31, 0x2, 0x2, 0x190, 0x191, 0x5, 0x8, 0x5, 0x2, 0x191, 0x29, 0x3, 
    0x2, 0x2, 0x2, 0x192, 0x195, 0x5, 0x3c, 0x1f, 0x2, 0x193, 0x195, 0x5, 
    0x3a, 0x1e, 0x2, 0x194, 0x192, 0x3, 0x2, 0x2, 0x2, 0x194, 0x193, 0x3, 
    0x2, 0x2, 0x2, 0x195, 0x199, 0x3, 0x2, 0x2, 0x2, 0x196, 0x198, 0x5, 
    0x2c, 0x17, 0x2, 0x197, 0x196, 0x3, 0x2, 0x2, 0x2, 0x198, 0x19b, 0x3, 
    0x2, 0x2, 0x2, 0x199, 0x197, 0x3, 0x2, 0x2, 0x2, 0x199, 0x19a, 0x3, 
    0x2, 0x2, 0x2, 0x19a, 0x2b, 0x3, 0x2, 0x2, 0x2, 0x19b, 0x199, 0x3, 0x2, 
    0x2, 0x2, 0x19c, 0x19f, 0x7, 0x38, 0x2, 0x2, 0x19d, 0x1a0, 0x5, 0x3c, 
    0x1f, 0x2, 0x19e, 0x1a0, 0x5, 0x3a, 0x1e, 0x2, 0x19f, 0x19d, 0x3, 0x2, 
    0x2, 0x2, 0x19f, 0x19e, 0x3, 0x2, 0x2, 0x2, 0x19f, 0x1a0, 0x3, 0x2, 
    0x2, 0x2, 0x1a0, 0x1a1, 0x3, 0x2, 0x2, 0x2, 0x1a1, 0x1a2, 0x7, 0x39, 
    0x2, 0x2, 0x1a2, 0x2d, 0x3, 0x2, 0x2, 0x2, 0x1a3, 0x1a4, 0x7, 0x5, 0x2, 
    0x2, 0x1a4, 0x1ad, 0x7, 0x36, 0x2, 0x2, 0x1a5, 0x1aa, 0x5, 0x32, 0x1a, 
    0x2, 0x1a6, 0x1a7, 0x7, 0x3b, 0x2, 0x2, 0x1a7, 0x1a9, 0x5, 0x32, 0x1a, 
    0x2, 0x1a8, 0x1a6, 0x3, 0x2, 0x2, 0x2, 0x1a9, 0x1ac, 0x3, 0x2, 0x2, 
    0x2, 0x1aa, 0x1a8, 0x3, 0x2, 0x2, 0x2, 0x1aa, 0x1ab, 0x3, 0x2, 0x2, 
    0x2, 0x1ab, 0x1ae, 0x3, 0x2, 0x2, 0x2, 0x1ac, 0x1aa, 0x3, 0x2, 0x2, 
    0x2, 0x1ad, 0x1a5, 0x3, 0x2, 0x2, 0x2, 0x1ad, 0x1ae, 0x3, 0x2, 0x2, 
    0x2, 0x1ae, 0x1af, 0x3, 0x2, 0x2, 0x2, 0x1af, 0x1b0, 0x7, 0x37, 0x2, 
    0x2, 0x1b0, 0x1b1, 0x7, 0x3f, 0x2, 0x2, 0x1b1, 0x1b2, 0x5, 0x30, 0x19, 
    0x2, 0x1b2, 0x2f, 0x3, 0x2, 0x2, 0x2, 0x1b3, 0x1b6, 0x5, 0x32, 0x1a, 
    0x2, 0x1b4, 0x1b6, 0x7, 0xa, 0x2, 0x2, 0x1b5, 0x1b3, 0x3, 0x2, 0x2, 
    0x2, 0x1b5, 0x1b4, 0x3, 0x2, 0x2, 0x2, 0x1b6, 0x31, 0x3, 0x2, 0x2, 0x2, 
    0x1b7, 0x1ba, 0x5, 0x2e, 0x18, 0x2, 0x1b8, 0x1ba, 0x5, 0x34, 0x1b, 0x2, 
    0x1b9, 0x1b7, 0x3, 0x2, 0x2, 0x2, 0x1b9, 0x1b8, 0x3, 0x2, 0x2, 0x2, 
    0x1ba, 0x33, 0x3, 0x2, 0x2, 0x2, 0x1bb, 0x1c0, 0x5, 0x36, 0x1c, 0x2, 
    0x1bc, 0x1bd, 0x9, 0x4, 0x2, 0x2, 0x1bd, 0x1bf, 0x5, 0x36, 0x1c, 0x2, 
    0x1be, 0x1bc, 0x3, 0x2, 0x2, 0x2, 0x1bf, 0x1c2, 0x3, 0x2, 0x2, 0x2, 
    0x1c0, 0x1be, 0x3, 0x2, 0x2, 0x2, 0x1c0, 0x1c1, 0x3, 0x2, 0x2, 0x2, 
    0x1c1, 0x35, 0x3, 0x2, 0x2, 0x2, 0x1c2, 0x1c0, 0x3, 0x2, 0x2, 0x2, 0x1c3, 
    0x1c9, 0x5, 0x2a, 0x16, 0x2, 0x1c4, 0x1c6, 0x7, 0x5b, 0x2, 0x2, 0x1c5, 
    0x1c7, 0x7, 0x56, 0x2, 0x2, 0x1c6, 0x1c5, 0x3, 0x2, 0x2, 0x2, 0x1c6, 
    0x1c7, 0x3, 0x2, 0x2, 0x2, 0x1c7, 0x1c8, 0x3, 0x2, 0x2, 0x2, 0x1c8, 
    0x1ca, 0x7, 0x2e, 0x2, 0x2, 0x1c9, 0x1c4, 0x3, 0x2, 0x2, 0x2, 0x1c9, 
    0x1ca, 0x3, 0x2, 0x2, 0x2, 0x1ca, 0x1d3, 0x3, 0x2, 0x2, 0x2, 0x1cb, 
    0x1cf, 0x5, 0x38, 0x1d, 0x2, 0x1cc, 0x1ce, 0x5, 0x2c, 0x17, 0x2, 0x1cd, 
    0x1cc, 0x3, 0x2, 0x2, 0x2, 0x1ce, 0x1d1, 0x3, 0x2, 0x2, 0x2, 0x1cf, 
    0x1cd, 0x3, 0x2, 0x2, 0x2, 0x1cf, 0x1d0, 0x3, 0x2, 0x2, 0x2, 0x1d0, 
    0x1d3, 0x3, 0x2, 0x2, 0x2, 0x1d1, 0x1cf, 0x3, 0x2, 0x2, 0x2, 0x1d2, 
    0x1c3, 0x3, 0x2, 0x2, 0x2, 0x1d2, 0x1cb, 0x3, 0x2, 0x2, 0x2, 0x1d3, 
    0x37, 0x3, 0x2, 0x2, 0x2, 0x1d4, 0x1d5, 0x7, 0x36, 0x2, 0x2, 0x1d5, 
    0x1d6, 0x5, 0x32, 0x1a, 0x2, 0x1d6, 0x1d7, 0x7, 0x37, 0x2, 0x2, 0x1d7, 
    0x39, 0x3, 0x2, 0x2, 0x2, 0x1d8, 0x1dd, 0x5, 0x82, 0x42, 0x2, 0x1d9, 
    0x1da, 0x7, 0x3c, 0x2, 0x2, 0x1da, 0x1dc, 0x5, 0x82, 0x42, 0x2, 0x1db, 
    0x1d9, 0x3, 0x2, 0x2, 0x2, 0x1dc, 0x1df, 0x3, 0x2, 0x2, 0x2, 0x1dd, 
    0x1db, 0x3, 0x2, 0x2, 0x2, 0x1dd, 0x1de, 0x3, 0x2, 0x2, 0x2, 0x1de, 
    0x3b, 0x3, 0x2, 0x2, 0x2, 0x1df, 0x1dd, 0x3, 0x2, 0x2, 0x2, 0x1e0, 0x1e1, 
    0x9, 0x5, 0x2, 0x2, 0x1e1, 0x3d, 0x3, 0x2, 0x2, 0x2, 0x1e2, 0x1e3, 0x7, 
    0xc, 0x2, 0x2, 0x1e3, 0x1e4, 0x7, 0x36, 0x2, 0x2, 0x1e4, 0x1e5, 0x5, 
    0x6a, 0x36, 0x2, 0x1e5, 0x1e6, 0x7, 0x37, 0x2, 0x2, 0x1e6, 0x1ec, 0x5, 
    0x40, 0x21, 0x2, 0x1e7, 0x1ea, 0x7, 0xd, 0x2, 0x2, 0x1e8, 0x1eb, 0x5, 
    0x3e, 0x20, 0x2, 0x1e9, 0x1eb, 0x5, 0x40, 0x21, 0x2, 0x1ea, 0x1e8, 0x3, 
    0x2, 0x2, 0x2, 0x1ea, 0x1e9, 0x3, 0x2, 0x2, 0x2, 0x1eb, 0x1ed, 0x3, 
    0x2, 0x2, 0x2, 0x1ec, 0x1e7, 0x3, 0x2, 0x2, 0x2, 0x1ec, 0x1ed, 0x3, 
    0x2, 0x2, 0x2, 0x1ed, 0x3f, 0x3, 0x2, 0x2, 0x2, 0x1ee, 0x1f1, 0x5, 0x8, 
    0x5, 0x2, 0x1ef, 0x1f1, 0x5, 0x6, 0x4, 0x2, 0x1f0, 0x1ee, 0x3, 0x2, 
    0x2, 0x2, 0x1f0, 0x1ef, 0x3, 0x2, 0x2, 0x2, 0x1f1, 0x41, 0x3, 0x2, 0x2, 
    0x2, 0x1f2, 0x1f3, 0x7, 0xe, 0x2, 0x2, 0x1f3, 0x1f4, 0x7, 0x36, 0x2, 
    0x2, 0x1f4, 0x1f5, 0x5, 0x6a, 0x36, 0x2, 0x1f5, 0x1f6, 0x7, 0x37, 0x2, 
    0x2, 0x1f6, 0x1f7, 0x5, 0x4, 0x3, 0x2, 0x1f7, 0x43, 0x3, 0x2, 0x2, 0x2, 
    0x1f8, 0x1f9, 0x7, 0xf, 0x2, 0x2, 0x1f9, 0x1fa, 0x5, 0x8, 0x5, 0x2, 
    0x1fa, 0x1fb, 0x7, 0xe, 0x2, 0x2, 0x1fb, 0x1fc, 0x7, 0x36, 0x2, 0x2, 
    0x1fc, 0x1fd, 0x5, 0x6a, 0x36, 0x2, 0x1fd, 0x1fe, 0x7, 0x37, 0x2, 0x2, 
    0x1fe, 0x45, 0x3, 0x2, 0x2, 0x2, 0x1ff, 0x200, 0x7, 0x10, 0x2, 0x2, 
    0x200, 0x201, 0x7, 0x36, 0x2, 0x2, 0x201, 0x202, 0x5, 0x48, 0x25, 0x2, 
    0x202, 0x203, 0x7, 0x37, 0x2, 0x2, 0x203, 0x204, 0x5, 0x4, 0x3, 0x2, 
    0x204, 0x47, 0x3, 0x2, 0x2, 0x2, 0x205, 0x208, 0x5, 0x82, 0x42, 0x2, 
    0x206, 0x207, 0x7, 0x3b, 0x2, 0x2, 0x207, 0x209, 0x5, 0x82, 0x42, 0x2, 
    0x208, 0x206, 0x3, 0x2, 0x2, 0x2, 0x208, 0x209, 0x3, 0x2, 0x2, 0x2, 
    0x209, 0x20a, 0x3, 0x2, 0x2, 0x2, 0x20a, 0x20b, 0x7, 0x11, 0x2, 0x2, 
    0x20b, 0x20c, 0x5, 0x6a, 0x36, 0x2, 0x20c, 0x221, 0x3, 0x2, 0x2, 0x2, 
    0x20d, 0x20f, 0x7, 0x9, 0x2, 0x2, 0x20e, 0x20d, 0x3, 0x2, 0x2, 0x2, 
    0x20e, 0x20f, 0x3, 0x2, 0x2, 0x2, 0x20f, 0x210, 0x3, 0x2, 0x2, 0x2, 
    0x210, 0x211, 0x5, 0x2a, 0x16, 0x2, 0x211, 0x212, 0x5, 0x82, 0x42, 0x2, 
    0x212, 0x213, 0x7, 0x3d, 0x2, 0x2, 0x213, 0x214, 0x5, 0x6a, 0x36, 0x2, 
    0x214, 0x221, 0x3, 0x2, 0x2, 0x2, 0x215, 0x217, 0x5, 0x4a, 0x26, 0x2, 
    0x216, 0x215, 0x3, 0x2, 0x2, 0x2, 0x216, 0x217, 0x3, 0x2, 0x2, 0x2, 
    0x217, 0x218, 0x3, 0x2, 0x2, 0x2, 0x218, 0x21a, 0x7, 0x3a, 0x2, 0x2, 
    0x219, 0x21b, 0x5, 0x6a, 0x36, 0x2, 0x21a, 0x219, 0x3, 0x2, 0x2, 0x2, 
    0x21a, 0x21b, 0x3, 0x2, 0x2, 0x2, 0x21b, 0x21c, 0x3, 0x2, 0x2, 0x2, 
    0x21c, 0x21e, 0x7, 0x3a, 0x2, 0x2, 0x21d, 0x21f, 0x5, 0x4c, 0x27, 0x2, 
    0x21e, 0x21d, 0x3, 0x2, 0x2, 0x2, 0x21e, 0x21f, 0x3, 0x2, 0x2, 0x2, 
    0x21f, 0x221, 0x3, 0x2, 0x2, 0x2, 0x220, 0x205, 0x3, 0x2, 0x2, 0x2, 
    0x220, 0x20e, 0x3, 0x2, 0x2, 0x2, 0x220, 0x216, 0x3, 0x2, 0x2, 0x2, 
    0x221, 0x49, 0x3, 0x2, 0x2, 0x2, 0x222, 0x22d, 0x5, 0xc, 0x7, 0x2, 0x223, 
    0x22d, 0x5, 0xa, 0x6, 0x2, 0x224, 0x229, 0x5, 0x64, 0x33, 0x2, 0x225, 
    0x226, 0x7, 0x3b, 0x2, 0x2, 0x226, 0x228, 0x5, 0x64, 0x33, 0x2, 0x227, 
    0x225, 0x3, 0x2, 0x2, 0x2, 0x228, 0x22b, 0x3, 0x2, 0x2, 0x2, 0x229, 
    0x227, 0x3, 0x2, 0x2, 0x2, 0x229, 0x22a, 0x3, 0x2, 0x2, 0x2, 0x22a, 
    0x22d, 0x3, 0x2, 0x2, 0x2, 0x22b, 0x229, 0x3, 0x2, 0x2, 0x2, 0x22c, 
    0x222, 0x3, 0x2, 0x2, 0x2, 0x22c, 0x223, 0x3, 0x2, 0x2, 0x2, 0x22c, 
    0x224, 0x3, 0x2, 0x2, 0x2, 0x22d, 0x4b, 0x3, 0x2, 0x2, 0x2, 0x22e, 0x233, 
    0x5, 0x64, 0x33, 0x2, 0x22f, 0x230, 0x7, 0x3b, 0x2, 0x2, 0x230, 0x232, 
    0x5, 0x64, 0x33, 0x2, 0x231, 0x22f, 0x3, 0x2, 0x2, 0x2, 0x232, 0x235, 
    0x3, 0x2, 0x2, 0x2, 0x233, 0x231, 0x3, 0x2, 0x2, 0x2, 0x233, 0x234, 
    0x3, 0x2, 0x2, 0x2, 0x234, 0x4d, 0x3, 0x2, 0x2, 0x2, 0x235, 0x233, 0x3, 
    0x2, 0x2, 0x2, 0x236, 0x237, 0x7, 0x12, 0x2, 0x2, 0x237, 0x238, 0x7, 
    0x36, 0x2, 0x2, 0x238, 0x239, 0x5, 0x6a, 0x36, 0x2, 0x239, 0x23a, 0x7, 
    0x37, 0x2, 0x2, 0x23a, 0x23e, 0x7, 0x34, 0x2, 0x2, 0x23b, 0x23d, 0x7, 
    0x3a, 0x2, 0x2, 0x23c, 0x23b, 0x3, 0x2, 0x2, 0x2, 0x23d, 0x240, 0x3, 
    0x2, 0x2, 0x2, 0x23e, 0x23c, 0x3, 0x2, 0x2, 0x2, 0x23e, 0x23f, 0x3, 
    0x2, 0x2, 0x2, 0x23f, 0x244, 0x3, 0x2, 0x2, 0x2, 0x240, 0x23e, 0x3, 
    0x2, 0x2, 0x2, 0x241, 0x243, 0x5, 0x50, 0x29, 0x2, 0x242, 0x241, 0x3, 
    0x2, 0x2, 0x2, 0x243, 0x246, 0x3, 0x2, 0x2, 0x2, 0x244, 0x242, 0x3, 
    0x2, 0x2, 0x2, 0x244, 0x245, 0x3, 0x2, 0x2, 0x2, 0x245, 0x247, 0x3, 
    0x2, 0x2, 0x2, 0x246, 0x244, 0x3, 0x2, 0x2, 0x2, 0x247, 0x248, 0x7, 
    0x35, 0x2, 0x2, 0x248, 0x4f, 0x3, 0x2, 0x2, 0x2, 0x249, 0x24a, 0x7, 
    0x13, 0x2, 0x2, 0x24a, 0x24f, 0x5, 0x6a, 0x36, 0x2, 0x24b, 0x24c, 0x7, 
    0x3b, 0x2, 0x2, 0x24c, 0x24e, 0x5, 0x6a, 0x36, 0x2, 0x24d, 0x24b, 0x3, 
    0x2, 0x2, 0x2, 0x24e, 0x251, 0x3, 0x2, 0x2, 0x2, 0x24f, 0x24d, 0x3, 
    0x2, 0x2, 0x2, 0x24f, 0x250, 0x3, 0x2, 0x2, 0x2, 0x250, 0x254, 0x3, 
    0x2, 0x2, 0x2, 0x251, 0x24f, 0x3, 0x2, 0x2, 0x2, 0x252, 0x254, 0x7, 
    0x14, 0x2, 0x2, 0x253, 0x249, 0x3, 0x2, 0x2, 0x2, 0x253, 0x252, 0x3, 
    0x2, 0x2, 0x2, 0x254, 0x255, 0x3, 0x2, 0x2, 0x2, 0x255, 0x259, 0x7, 
    0x3d, 0x2, 0x2, 0x256, 0x258, 0x5, 0x4, 0x3, 0x2, 0x257, 0x256, 0x3, 
    0x2, 0x2, 0x2, 0x258, 0x25b, 0x3, 0x2, 0x2, 0x2, 0x259, 0x257, 0x3, 
    0x2, 0x2, 0x2, 0x259, 0x25a, 0x3, 0x2, 0x2, 0x2, 0x25a, 0x51, 0x3, 0x2, 
    0x2, 0x2, 0x25b, 0x259, 0x3, 0x2, 0x2, 0x2, 0x25c, 0x25d, 0x7, 0x18, 
    0x2, 0x2, 0x25d, 0x261, 0x5, 0x8, 0x5, 0x2, 0x25e, 0x260, 0x5, 0x54, 
    0x2b, 0x2, 0x25f, 0x25e, 0x3, 0x2, 0x2, 0x2, 0x260, 0x263, 0x3, 0x2, 
    0x2, 0x2, 0x261, 0x25f, 0x3, 0x2, 0x2, 0x2, 0x261, 0x262, 0x3, 0x2, 
    0x2, 0x2, 0x262, 0x266, 0x3, 0x2, 0x2, 0x2, 0x263, 0x261, 0x3, 0x2, 
    0x2, 0x2, 0x264, 0x265, 0x7, 0x1a, 0x2, 0x2, 0x265, 0x267, 0x5, 0x8, 
    0x5, 0x2, 0x266, 0x264, 0x3, 0x2, 0x2, 0x2, 0x266, 0x267, 0x3, 0x2, 
    0x2, 0x2, 0x267, 0x53, 0x3, 0x2, 0x2, 0x2, 0x268, 0x26d, 0x7, 0x19, 
    0x2, 0x2, 0x269, 0x26a, 0x7, 0x36, 0x2, 0x2, 0x26a, 0x26b, 0x5, 0x20, 
    0x11, 0x2, 0x26b, 0x26c, 0x7, 0x37, 0x2, 0x2, 0x26c, 0x26e, 0x3, 0x2, 
    0x2, 0x2, 0x26d, 0x269, 0x3, 0x2, 0x2, 0x2, 0x26d, 0x26e, 0x3, 0x2, 
    0x2, 0x2, 0x26e, 0x26f, 0x3, 0x2, 0x2, 0x2, 0x26f, 0x270, 0x5, 0x8, 
    0x5, 0x2, 0x270, 0x55, 0x3, 0x2, 0x2, 0x2, 0x271, 0x272, 0x7, 0x1d, 
    0x2, 0x2, 0x272, 0x273, 0x5, 0x8, 0x5, 0x2, 0x273, 0x57, 0x3, 0x2, 0x2, 
    0x2, 0x274, 0x275, 0x7, 0x1e, 0x2, 0x2, 0x275, 0x276, 0x7, 0x36, 0x2, 
    0x2, 0x276, 0x277, 0x5, 0x6a, 0x36, 0x2, 0x277, 0x278, 0x7, 0x37, 0x2, 
    0x2, 0x278, 0x279, 0x5, 0x8, 0x5, 0x2, 0x279, 0x59, 0x3, 0x2, 0x2, 0x2, 
    0x27a, 0x27b, 0x7, 0x1f, 0x2, 0x2, 0x27b, 0x27c, 0x7, 0x36, 0x2, 0x2, 
    0x27c, 0x27d, 0x5, 0x6a, 0x36, 0x2, 0x27d, 0x27e, 0x7, 0x37, 0x2, 0x2, 
    0x27e, 0x27f, 0x5, 0x8, 0x5, 0x2, 0x27f, 0x5b, 0x3, 0x2, 0x2, 0x2, 0x280, 
    0x28b, 0x7, 0x20, 0x2, 0x2, 0x281, 0x282, 0x7, 0x21, 0x2, 0x2, 0x282, 
    0x287, 0x5, 0x6e, 0x38, 0x2, 0x283, 0x284, 0x7, 0x3b, 0x2, 0x2, 0x284, 
    0x286, 0x5, 0x7e, 0x40, 0x2, 0x285, 0x283, 0x3, 0x2, 0x2, 0x2, 0x286, 
    0x289, 0x3, 0x2, 0x2, 0x2, 0x287, 0x285, 0x3, 0x2, 0x2, 0x2, 0x287, 
    0x288, 0x3, 0x2, 0x2, 0x2, 0x288, 0x28c, 0x3, 0x2, 0x2, 0x2, 0x289, 
    0x287, 0x3, 0x2, 0x2, 0x2, 0x28a, 0x28c, 0x5, 0x6a, 0x36, 0x2, 0x28b, 
    0x281, 0x3, 0x2, 0x2, 0x2, 0x28b, 0x28a, 0x3, 0x2, 0x2, 0x2, 0x28c, 
    0x5d, 0x3, 0x2, 0x2, 0x2, 0x28d, 0x28e, 0x7, 0x22, 0x2, 0x2, 0x28e, 
    0x28f, 0x5, 0x7c, 0x3f, 0x2, 0x28f, 0x290, 0x5, 0x8, 0x5, 0x2, 0x290, 
    0x5f, 0x3, 0x2, 0x2, 0x2, 0x291, 0x293, 0x7, 0x2a, 0x2, 0x2, 0x292, 
    0x294, 0x5, 0x7c, 0x3f, 0x2, 0x293, 0x292, 0x3, 0x2, 0x2, 0x2, 0x293, 
    0x294, 0x3, 0x2, 0x2, 0x2, 0x294, 0x295, 0x3, 0x2, 0x2, 0x2, 0x295, 
    0x296, 0x5, 0x8, 0x5, 0x2, 0x296, 0x61, 0x3, 0x2, 0x2, 0x2, 0x297, 0x298, 
    0x7, 0x29, 0x2, 0x2, 0x298, 0x299, 0x5, 0x82, 0x42, 0x2, 0x299, 0x29a, 
    0x7, 0x1f, 0x2, 0x2, 0x29a, 0x29b, 0x7, 0x36, 0x2, 0x2, 0x29b, 0x29c, 
    0x5, 0x6a, 0x36, 0x2, 0x29c, 0x29d, 0x7, 0x37, 0x2, 0x2, 0x29d, 0x2a1, 
    0x7, 0x34, 0x2, 0x2, 0x29e, 0x2a0, 0x5, 0x18, 0xd, 0x2, 0x29f, 0x29e, 
    0x3, 0x2, 0x2, 0x2, 0x2a0, 0x2a3, 0x3, 0x2, 0x2, 0x2, 0x2a1, 0x29f, 
    0x3, 0x2, 0x2, 0x2, 0x2a1, 0x2a2, 0x3, 0x2, 0x2, 0x2, 0x2a2, 0x2a4, 
    0x3, 0x2, 0x2, 0x2, 0x2a3, 0x2a1, 0x3, 0x2, 0x2, 0x2, 0x2a4, 0x2a5, 
    0x7, 0x35, 0x2, 0x2, 0x2a5, 0x63, 0x3, 0x2, 0x2, 0x2, 0x2a6, 0x2ad, 
    0x5, 0x6a, 0x36, 0x2, 0x2a7, 0x2ae, 0x5, 0x66, 0x34, 0x2, 0x2a8, 0x2a9, 
    0x5, 0x68, 0x35, 0x2, 0x2a9, 0x2aa, 0x5, 0x6a, 0x36, 0x2, 0x2aa, 0x2ae, 
    0x3, 0x2, 0x2, 0x2, 0x2ab, 0x2ae, 0x7, 0x50, 0x2, 0x2, 0x2ac, 0x2ae, 
    0x7, 0x51, 0x2, 0x2, 0x2ad, 0x2a7, 0x3, 0x2, 0x2, 0x2, 0x2ad, 0x2a8, 
    0x3, 0x2, 0x2, 0x2, 0x2ad, 0x2ab, 0x3, 0x2, 0x2, 0x2, 0x2ad, 0x2ac, 
    0x3, 0x2, 0x2, 0x2, 0x2ad, 0x2ae, 0x3, 0x2, 0x2, 0x2, 0x2ae, 0x2b2, 
    0x3, 0x2, 0x2, 0x2, 0x2af, 0x2b0, 0x9, 0x6, 0x2, 0x2, 0x2b0, 0x2b2, 
    0x5, 0x6e, 0x38, 0x2, 0x2b1, 0x2a6, 0x3, 0x2, 0x2, 0x2, 0x2b1, 0x2af, 
    0x3, 0x2, 0x2, 0x2, 0x2b2, 0x65, 0x3, 0x2, 0x2, 0x2, 0x2b3, 0x2b4, 0x7, 
    0x4f, 0x2, 0x2, 0x2b4, 0x2b6, 0x5, 0x6a, 0x36, 0x2, 0x2b5, 0x2b3, 0x3, 
    0x2, 0x2, 0x2, 0x2b6, 0x2b7, 0x3, 0x2, 0x2, 0x2, 0x2b7, 0x2b5, 0x3, 
    0x2, 0x2, 0x2, 0x2b7, 0x2b8, 0x3, 0x2, 0x2, 0x2, 0x2b8, 0x2bb, 0x3, 
    0x2, 0x2, 0x2, 0x2b9, 0x2ba, 0x7, 0x4f, 0x2, 0x2, 0x2ba, 0x2bc, 0x5, 
    0x12, 0xa, 0x2, 0x2bb, 0x2b9, 0x3, 0x2, 0x2, 0x2, 0x2bb, 0x2bc, 0x3, 
    0x2, 0x2, 0x2, 0x2bc, 0x2c0, 0x3, 0x2, 0x2, 0x2, 0x2bd, 0x2be, 0x7, 
    0x4f, 0x2, 0x2, 0x2be, 0x2c0, 0x5, 0x12, 0xa, 0x2, 0x2bf, 0x2b5, 0x3, 
    0x2, 0x2, 0x2, 0x2bf, 0x2bd, 0x3, 0x2, 0x2, 0x2, 0x2c0, 0x67, 0x3, 0x2, 
    0x2, 0x2, 0x2c1, 0x2c2, 0x9, 0x7, 0x2, 0x2, 0x2c2, 0x69, 0x3, 0x2, 0x2, 
    0x2, 0x2c3, 0x2cb, 0x5, 0x6c, 0x37, 0x2, 0x2c4, 0x2cb, 0x5, 0x76, 0x3c, 
    0x2, 0x2c5, 0x2c8, 0x5, 0x6e, 0x38, 0x2, 0x2c6, 0x2c7, 0x7, 0x21, 0x2, 
    0x2, 0x2c7, 0x2c9, 0x5, 0x6e, 0x38, 0x2, 0x2c8, 0x2c6, 0x3, 0x2, 0x2, 
    0x2, 0x2c8, 0x2c9, 0x3, 0x2, 0x2, 0x2, 0x2c9, 0x2cb, 0x3, 0x2, 0x2, 
    0x2, 0x2ca, 0x2c3, 0x3, 0x2, 0x2, 0x2, 0x2ca, 0x2c4, 0x3, 0x2, 0x2, 
    0x2, 0x2ca, 0x2c5, 0x3, 0x2, 0x2, 0x2, 0x2cb, 0x6b, 0x3, 0x2, 0x2, 0x2, 
    0x2cc, 0x2cd, 0x7, 0x5, 0x2, 0x2, 0x2cd, 0x2cf, 0x7, 0x36, 0x2, 0x2, 
    0x2ce, 0x2d0, 0x5, 0x1e, 0x10, 0x2, 0x2cf, 0x2ce, 0x3, 0x2, 0x2, 0x2, 
    0x2cf, 0x2d0, 0x3, 0x2, 0x2, 0x2, 0x2d0, 0x2d1, 0x3, 0x2, 0x2, 0x2, 
    0x2d1, 0x2d4, 0x7, 0x37, 0x2, 0x2, 0x2d2, 0x2d3, 0x7, 0x3f, 0x2, 0x2, 
    0x2d3, 0x2d5, 0x5, 0x30, 0x19, 0x2, 0x2d4, 0x2d2, 0x3, 0x2, 0x2, 0x2, 
    0x2d4, 0x2d5, 0x3, 0x2, 0x2, 0x2, 0x2d5, 0x2d9, 0x3, 0x2, 0x2, 0x2, 
    0x2d6, 0x2da, 0x5, 0x8, 0x5, 0x2, 0x2d7, 0x2d8, 0x7, 0x40, 0x2, 0x2, 
    0x2d8, 0x2da, 0x5, 0x6a, 0x36, 0x2, 0x2d9, 0x2d6, 0x3, 0x2, 0x2, 0x2, 
    0x2d9, 0x2d7, 0x3, 0x2, 0x2, 0x2, 0x2da, 0x6d, 0x3, 0x2, 0x2, 0x2, 0x2db, 
    0x2dc, 0x8, 0x38, 0x1, 0x2, 0x2dc, 0x2e5, 0x5, 0x70, 0x39, 0x2, 0x2dd, 
    0x2de, 0x9, 0x8, 0x2, 0x2, 0x2de, 0x2e5, 0x5, 0x6e, 0x38, 0xb, 0x2df, 
    0x2e0, 0x7, 0x36, 0x2, 0x2, 0x2e0, 0x2e1, 0x5, 0x3c, 0x1f, 0x2, 0x2e1, 
    0x2e2, 0x7, 0x37, 0x2, 0x2, 0x2e2, 0x2e3, 0x5, 0x6e, 0x38, 0xa, 0x2e3, 
    0x2e5, 0x3, 0x2, 0x2, 0x2, 0x2e4, 0x2db, 0x3, 0x2, 0x2, 0x2, 0x2e4, 
    0x2dd, 0x3, 0x2, 0x2, 0x2, 0x2e4, 0x2df, 0x3, 0x2, 0x2, 0x2, 0x2e5, 
    0x317, 0x3, 0x2, 0x2, 0x2, 0x2e6, 0x2e7, 0xc, 0xd, 0x2, 0x2, 0x2e7, 
    0x2e8, 0x7, 0x5b, 0x2, 0x2, 0x2e8, 0x316, 0x5, 0x6e, 0x38, 0xd, 0x2e9, 
    0x2ea, 0xc, 0xc, 0x2, 0x2, 0x2ea, 0x2eb, 0x7, 0x54, 0x2, 0x2, 0x2eb, 
    0x316, 0x5, 0x6e, 0x38, 0xd, 0x2ec, 0x2ed, 0xc, 0x9, 0x2, 0x2, 0x2ed, 
    0x2ee, 0x9, 0x9, 0x2, 0x2, 0x2ee, 0x316, 0x5, 0x6e, 0x38, 0xa, 0x2ef, 
    0x2f0, 0xc, 0x8, 0x2, 0x2, 0x2f0, 0x2f1, 0x9, 0xa, 0x2, 0x2, 0x2f1, 
    0x316, 0x5, 0x6e, 0x38, 0x9, 0x2f2, 0x2f3, 0xc, 0x7, 0x2, 0x2, 0x2f3, 
    0x2f4, 0x9, 0xb, 0x2, 0x2, 0x2f4, 0x316, 0x5, 0x6e, 0x38, 0x8, 0x2f5, 
    0x2f6, 0xc, 0x6, 0x2, 0x2, 0x2f6, 0x2f7, 0x9, 0xc, 0x2, 0x2, 0x2f7, 
    0x316, 0x5, 0x6e, 0x38, 0x7, 0x2f8, 0x2f9, 0xc, 0x5, 0x2, 0x2, 0x2f9, 
    0x2fa, 0x7, 0x47, 0x2, 0x2, 0x2fa, 0x316, 0x5, 0x6e, 0x38, 0x6, 0x2fb, 
    0x2fc, 0xc, 0x4, 0x2, 0x2, 0x2fc, 0x2fd, 0x7, 0x48, 0x2, 0x2, 0x2fd, 
    0x316, 0x5, 0x6e, 0x38, 0x5, 0x2fe, 0x2ff, 0xc, 0x3, 0x2, 0x2, 0x2ff, 
    0x300, 0x7, 0x3e, 0x2, 0x2, 0x300, 0x301, 0x5, 0x6e, 0x38, 0x2, 0x301, 
    0x302, 0x7, 0x3d, 0x2, 0x2, 0x302, 0x303, 0x5, 0x6e, 0x38, 0x3, 0x303, 
    0x316, 0x3, 0x2, 0x2, 0x2, 0x304, 0x305, 0xc, 0x10, 0x2, 0x2, 0x305, 
    0x306, 0x7, 0x3c, 0x2, 0x2, 0x306, 0x316, 0x5, 0x82, 0x42, 0x2, 0x307, 
    0x308, 0xc, 0xf, 0x2, 0x2, 0x308, 0x309, 0x7, 0x38, 0x2, 0x2, 0x309, 
    0x30e, 0x5, 0x7a, 0x3e, 0x2, 0x30a, 0x30b, 0x7, 0x3b, 0x2, 0x2, 0x30b, 
    0x30d, 0x5, 0x7a, 0x3e, 0x2, 0x30c, 0x30a, 0x3, 0x2, 0x2, 0x2, 0x30d, 
    0x310, 0x3, 0x2, 0x2, 0x2, 0x30e, 0x30c, 0x3, 0x2, 0x2, 0x2, 0x30e, 
    0x30f, 0x3, 0x2, 0x2, 0x2, 0x30f, 0x311, 0x3, 0x2, 0x2, 0x2, 0x310, 
    0x30e, 0x3, 0x2, 0x2, 0x2, 0x311, 0x312, 0x7, 0x39, 0x2, 0x2, 0x312, 
    0x316, 0x3, 0x2, 0x2, 0x2, 0x313, 0x314, 0xc, 0xe, 0x2, 0x2, 0x314, 
    0x316, 0x5, 0x7c, 0x3f, 0x2, 0x315, 0x2e6, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x2e9, 0x3, 0x2, 0x2, 0x2, 0x315, 0x2ec, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x2ef, 0x3, 0x2, 0x2, 0x2, 0x315, 0x2f2, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x2f5, 0x3, 0x2, 0x2, 0x2, 0x315, 0x2f8, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x2fb, 0x3, 0x2, 0x2, 0x2, 0x315, 0x2fe, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x304, 0x3, 0x2, 0x2, 0x2, 0x315, 0x307, 0x3, 0x2, 0x2, 0x2, 0x315, 
    0x313, 0x3, 0x2, 0x2, 0x2, 0x316, 0x319, 0x3, 0x2, 0x2, 0x2, 0x317, 
    0x315, 0x3, 0x2, 0x2, 0x2, 0x317, 0x318, 0x3, 0x2, 0x2, 0x2, 0x318, 
    0x6f, 0x3, 0x2, 0x2, 0x2, 0x319, 0x317, 0x3, 0x2, 0x2, 0x2, 0x31a, 0x33a, 
    0x5, 0x80, 0x41, 0x2, 0x31b, 0x33a, 0x5, 0x82, 0x42, 0x2, 0x31c, 0x31d, 
    0x5, 0x3c, 0x1f, 0x2, 0x31d, 0x31e, 0x5, 0x7c, 0x3f, 0x2, 0x31e, 0x33a, 
    0x3, 0x2, 0x2, 0x2, 0x31f, 0x320, 0x7, 0x36, 0x2, 0x2, 0x320, 0x321, 
    0x5, 0x6a, 0x36, 0x2, 0x321, 0x322, 0x7, 0x37, 0x2, 0x2, 0x322, 0x33a, 
    0x3, 0x2, 0x2, 0x2, 0x323, 0x32f, 0x7, 0x38, 0x2, 0x2, 0x324, 0x329, 
    0x5, 0x72, 0x3a, 0x2, 0x325, 0x326, 0x7, 0x3a, 0x2, 0x2, 0x326, 0x328, 
    0x5, 0x72, 0x3a, 0x2, 0x327, 0x325, 0x3, 0x2, 0x2, 0x2, 0x328, 0x32b, 
    0x3, 0x2, 0x2, 0x2, 0x329, 0x327, 0x3, 0x2, 0x2, 0x2, 0x329, 0x32a, 
    0x3, 0x2, 0x2, 0x2, 0x32a, 0x32d, 0x3, 0x2, 0x2, 0x2, 0x32b, 0x329, 
    0x3, 0x2, 0x2, 0x2, 0x32c, 0x32e, 0x7, 0x3a, 0x2, 0x2, 0x32d, 0x32c, 
    0x3, 0x2, 0x2, 0x2, 0x32d, 0x32e, 0x3, 0x2, 0x2, 0x2, 0x32e, 0x330, 
    0x3, 0x2, 0x2, 0x2, 0x32f, 0x324, 0x3, 0x2, 0x2, 0x2, 0x32f, 0x330, 
    0x3, 0x2, 0x2, 0x2, 0x330, 0x331, 0x3, 0x2, 0x2, 0x2, 0x331, 0x33a, 
    0x7, 0x39, 0x2, 0x2, 0x332, 0x333, 0x7, 0x38, 0x2, 0x2, 0x333, 0x334, 
    0x7, 0x3d, 0x2, 0x2, 0x334, 0x33a, 0x7, 0x39, 0x2, 0x2, 0x335, 0x336, 
    0x7, 0xb, 0x2, 0x2, 0x336, 0x337, 0x5, 0x3a, 0x1e, 0x2, 0x337, 0x338, 
    0x5, 0x7c, 0x3f, 0x2, 0x338, 0x33a, 0x3, 0x2, 0x2, 0x2, 0x339, 0x31a, 
    0x3, 0x2, 0x2, 0x2, 0x339, 0x31b, 0x3, 0x2, 0x2, 0x2, 0x339, 0x31c, 
    0x3, 0x2, 0x2, 0x2, 0x339, 0x31f, 0x3, 0x2, 0x2, 0x2, 0x339, 0x323, 
    0x3, 0x2, 0x2, 0x2, 0x339, 0x332, 0x3, 0x2, 0x2, 0x2, 0x339, 0x335, 
    0x3, 0x2, 0x2, 0x2, 0x33a, 0x71, 0x3, 0x2, 0x2, 0x2, 0x33b, 0x340, 0x5, 
    0x74, 0x3b, 0x2, 0x33c, 0x33d, 0x7, 0x3b, 0x2, 0x2, 0x33d, 0x33f, 0x5, 
    0x74, 0x3b, 0x2, 0x33e, 0x33c, 0x3, 0x2, 0x2, 0x2, 0x33f, 0x342, 0x3, 
    0x2, 0x2, 0x2, 0x340, 0x33e, 0x3, 0x2, 0x2, 0x2, 0x340, 0x341, 0x3, 
    0x2, 0x2, 0x2, 0x341, 0x344, 0x3, 0x2, 0x2, 0x2, 0x342, 0x340, 0x3, 
    0x2, 0x2, 0x2, 0x343, 0x345, 0x7, 0x3b, 0x2, 0x2, 0x344, 0x343, 0x3, 
    0x2, 0x2, 0x2, 0x344, 0x345, 0x3, 0x2, 0x2, 0x2, 0x345, 0x73, 0x3, 0x2, 
    0x2, 0x2, 0x346, 0x349, 0x5, 0x6a, 0x36, 0x2, 0x347, 0x348, 0x7, 0x3d, 
    0x2, 0x2, 0x348, 0x34a, 0x5, 0x6a, 0x36, 0x2, 0x349, 0x347, 0x3, 0x2, 
    0x2, 0x2, 0x349, 0x34a, 0x3, 0x2, 0x2, 0x2, 0x34a, 0x75, 0x3, 0x2, 0x2, 
    0x2, 0x34b, 0x34e, 0x7, 0xb, 0x2, 0x2, 0x34c, 0x34f, 0x5, 0x3c, 0x1f, 
    0x2, 0x34d, 0x34f, 0x5, 0x3a, 0x1e, 0x2, 0x34e, 0x34c, 0x3, 0x2, 0x2, 
    0x2, 0x34e, 0x34d, 0x3, 0x2, 0x2, 0x2, 0x34f, 0x363, 0x3, 0x2, 0x2, 
    0x2, 0x350, 0x352, 0x5, 0x78, 0x3d, 0x2, 0x351, 0x350, 0x3, 0x2, 0x2, 
    0x2, 0x352, 0x353, 0x3, 0x2, 0x2, 0x2, 0x353, 0x351, 0x3, 0x2, 0x2, 
    0x2, 0x353, 0x354, 0x3, 0x2, 0x2, 0x2, 0x354, 0x359, 0x3, 0x2, 0x2, 
    0x2, 0x355, 0x356, 0x7, 0x38, 0x2, 0x2, 0x356, 0x358, 0x7, 0x39, 0x2, 
    0x2, 0x357, 0x355, 0x3, 0x2, 0x2, 0x2, 0x358, 0x35b, 0x3, 0x2, 0x2, 
    0x2, 0x359, 0x357, 0x3, 0x2, 0x2, 0x2, 0x359, 0x35a, 0x3, 0x2, 0x2, 
    0x2, 0x35a, 0x364, 0x3, 0x2, 0x2, 0x2, 0x35b, 0x359, 0x3, 0x2, 0x2, 
    0x2, 0x35c, 0x35d, 0x7, 0x38, 0x2, 0x2, 0x35d, 0x35f, 0x7, 0x39, 0x2, 
    0x2, 0x35e, 0x35c, 0x3, 0x2, 0x2, 0x2, 0x35f, 0x360, 0x3, 0x2, 0x2, 
    0x2, 0x360, 0x35e, 0x3, 0x2, 0x2, 0x2, 0x360, 0x361, 0x3, 0x2, 0x2, 
    0x2, 0x361, 0x362, 0x3, 0x2, 0x2, 0x2, 0x362, 0x364, 0x5, 0x12, 0xa, 
    0x2, 0x363, 0x351, 0x3, 0x2, 0x2, 0x2, 0x363, 0x35e, 0x3, 0x2, 0x2, 
    0x2, 0x364, 0x77, 0x3, 0x2, 0x2, 0x2, 0x365, 0x366, 0x7, 0x38, 0x2, 
    0x2, 0x366, 0x367, 0x5, 0x6a, 0x36, 0x2, 0x367, 0x368, 0x7, 0x39, 0x2, 
    0x2, 0x368, 0x79, 0x3, 0x2, 0x2, 0x2, 0x369, 0x36e, 0x5, 0x6a, 0x36, 
    0x2, 0x36a, 0x36c, 0x7, 0x3d, 0x2, 0x2, 0x36b, 0x36d, 0x5, 0x6a, 0x36, 
    0x2, 0x36c, 0x36b, 0x3, 0x2, 0x2, 0x2, 0x36c, 0x36d, 0x3, 0x2, 0x2, 
    0x2, 0x36d, 0x36f, 0x3, 0x2, 0x2, 0x2, 0x36e, 0x36a, 0x3, 0x2, 0x2, 
    0x2, 0x36e, 0x36f, 0x3, 0x2, 0x2, 0x2, 0x36f, 0x375, 0x3, 0x2, 0x2, 
    0x2, 0x370, 0x372, 0x7, 0x3d, 0x2, 0x2, 0x371, 0x373, 0x5, 0x6a, 0x36, 
    0x2, 0x372, 0x371, 0x3, 0x2, 0x2, 0x2, 0x372, 0x373, 0x3, 0x2, 0x2, 
    0x2, 0x373, 0x375, 0x3, 0x2, 0x2, 0x2, 0x374, 0x369, 0x3, 0x2, 0x2, 
    0x2, 0x374, 0x370, 0x3, 0x2, 0x2, 0x2, 0x375, 0x7b, 0x3, 0x2, 0x2, 0x2, 
    0x376, 0x382, 0x7, 0x36, 0x2, 0x2, 0x377, 0x37c, 0x5, 0x7e, 0x40, 0x2, 
    0x378, 0x379, 0x7, 0x3b, 0x2, 0x2, 0x379, 0x37b, 0x5, 0x7e, 0x40, 0x2, 
    0x37a, 0x378, 0x3, 0x2, 0x2, 0x2, 0x37b, 0x37e, 0x3, 0x2, 0x2, 0x2, 
    0x37c, 0x37a, 0x3, 0x2, 0x2, 0x2, 0x37c, 0x37d, 0x3, 0x2, 0x2, 0x2, 
    0x37d, 0x380, 0x3, 0x2, 0x2, 0x2, 0x37e, 0x37c, 0x3, 0x2, 0x2, 0x2, 
    0x37f, 0x381, 0x7, 0x3b, 0x2, 0x2, 0x380, 0x37f, 0x3, 0x2, 0x2, 0x2, 
    0x380, 0x381, 0x3, 0x2, 0x2, 0x2, 0x381, 0x383, 0x3, 0x2, 0x2, 0x2, 
    0x382, 0x377, 0x3, 0x2, 0x2, 0x2, 0x382, 0x383, 0x3, 0x2, 0x2, 0x2, 
    0x383, 0x384, 0x3, 0x2, 0x2, 0x2, 0x384, 0x385, 0x7, 0x37, 0x2, 0x2, 
    0x385, 0x7d, 0x3, 0x2, 0x2, 0x2, 0x386, 0x387, 0x5, 0x82, 0x42, 0x2, 
    0x387, 0x388, 0x7, 0x3d, 0x2, 0x2, 0x388, 0x38a, 0x3, 0x2, 0x2, 0x2, 
    0x389, 0x386, 0x3, 0x2, 0x2, 0x2, 0x389, 0x38a, 0x3, 0x2, 0x2, 0x2, 
    0x38a, 0x38b, 0x3, 0x2, 0x2, 0x2, 0x38b, 0x38c, 0x5, 0x6a, 0x36, 0x2, 
    0x38c, 0x7f, 0x3, 0x2, 0x2, 0x2, 0x38d, 0x38e, 0x9, 0xd, 0x2, 0x2, 0x38e, 
    0x81, 0x3, 0x2, 0x2, 0x2, 0x38f, 0x390, 0x9, 0xe, 0x2, 0x2, 0x390, 0x83, 
    0x3, 0x2, 0x2, 0x2, 0x6e, 0x87, 0xab, 0xbb, 0xc2, 0xc8, 0xd1, 0xd5, 
    0xd8, 0xe0, 0xe8, 0xed, 0xf1, 0xf9, 0xfd, 0xff, 0x106, 0x10e, 0x11e, 
    0x124, 0x129, 0x12f, 0x134, 0x139, 0x140, 0x147, 0x14b, 0x150, 0x154, 
    0x157, 0x15f, 0x162, 0x16b, 0x16d, 0x17a, 0x180, 0x188, 0x18c, 0x194, 
    0x199, 0x19f, 0x1aa, 0x1ad, 0x1b5, 0x1b9, 0x1c0, 0x1c6, 0x1c9, 0x1cf, 
    0x1d2, 0x1dd, 0x1ea, 0x1ec, 0x1f0, 0x208, 0x20e, 0x216, 0x21a, 0x21e, 
    0x220, 0x229, 0x22c, 0x233, 0x23e, 0x244, 0x24f, 0x253, 0x259, 0x261, 
    0x266, 0x26d, 0x287, 0x28b, 0x293, 0x2a1, 0x2ad, 0x2b1, 0x2b7, 0x2bb, 
    0x2bf, 0x2c8, 0x2ca, 0x2cf, 0x2d4, 0x2d9, 0x2e4, 0x30e, 0x315, 0x317, 
    0x329, 0x32d, 0x32f, 0x339, 0x340, 0x344, 0x349, 0x34e, 0x353, 0x359, 
    0x360, 0x363, 0x36c, 0x36e, 0x372, 0x374, 0x37c, 0x380, 0x382, 0x389, 
  };

  atn::ATNDeserializer deserializer;
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
