
// Generated from RbtLexer.g4 by ANTLR 4.7.2

#pragma once


#include "antlr4-runtime.h"




class  RbtLexer : public antlr4::Lexer {
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
    LINE_BREAKS = 2
  };

  RbtLexer(antlr4::CharStream *input);
  ~RbtLexer();


    // `10mm/speed` is `10mm`, `/`, `speed`: a quantity gives back what would stop inside a word. Done here rather than
    // by a predicate, which would keep quantities out of the lexer's cache and make them twice as slow.
    antlr4::Token *emit() override {
      if (type == QUANTITY) trimQuantity();
      return antlr4::Lexer::emit();
    }

    void trimQuantity() {
      const size_t whole = _input->index();
      while (continuesWord(_input->LA(1))) {
        size_t end = _input->index();
        do {
          if (end == tokenStartCharIndex) return takeWord(whole);
          _input->seek(--end);
        } while (!startsUnitPart(_input->LA(1)));
      }
    }

    // A number with a degree sign and letters can give back nothing: the sign of degrees is no letter, so it is not a BADNUM by itself.
    void takeWord(size_t end) {
      _input->seek(end);
      while (continuesWord(_input->LA(1))) _input->consume();
      type = BADNUM;
    }

    static bool startsUnitPart(size_t c) { return c == '*' || c == '/' || c == '^'; }

    static bool continuesWord(size_t c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
             (c >= 0xC0 && c <= 0x24F && c != 0xD7 && c != 0xF7) || (c >= 0x370 && c <= 0x3FF);
    }

  virtual std::string getGrammarFileName() const override;
  virtual const std::vector<std::string>& getRuleNames() const override;

  virtual const std::vector<std::string>& getChannelNames() const override;
  virtual const std::vector<std::string>& getModeNames() const override;
  virtual const std::vector<std::string>& getTokenNames() const override; // deprecated, use vocabulary instead
  virtual antlr4::dfa::Vocabulary& getVocabulary() const override;

  virtual const std::vector<uint16_t> getSerializedATN() const override;
  virtual const antlr4::atn::ATN& getATN() const override;

private:
  static std::vector<antlr4::dfa::DFA> _decisionToDFA;
  static antlr4::atn::PredictionContextCache _sharedContextCache;
  static std::vector<std::string> _ruleNames;
  static std::vector<std::string> _tokenNames;
  static std::vector<std::string> _channelNames;
  static std::vector<std::string> _modeNames;

  static std::vector<std::string> _literalNames;
  static std::vector<std::string> _symbolicNames;
  static antlr4::dfa::Vocabulary _vocabulary;
  static antlr4::atn::ATN _atn;
  static std::vector<uint16_t> _serializedATN;


  // Individual action functions triggered by action() above.

  // Individual semantic predicate functions triggered by sempred() above.

  struct Initializer {
    Initializer();
  };
  
public:
  static void prepare();  // reads the tables
};

