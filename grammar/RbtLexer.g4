// The tokens of the .rbt language (docs/language.md, section 3).
//
// The lexer never fails: invalid text becomes a token BADNUM, BADSTR or ERR, which is reported with the words of the
// program before the parser runs. Line breaks are tokens on a channel of their own; syntax/tokens/line_ends.cpp of the
// interpreter replaces those that end a statement by SEMI, so that the parser sees no line breaks.
lexer grammar RbtLexer;

options { language = Cpp; }

channels { LINE_BREAKS }

@members {
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
}

// ---------------------------------------------------------------- words
LET : 'let' ;
VAR : 'var' ;
FN : 'fn' ;
STRUCT : 'struct' ;
ENUM : 'enum' ;
IMPORT : 'import' ;
FINAL : 'final' ;
VOID : 'void' ;
NEW : 'new' ;
IF : 'if' ;
ELSE : 'else' ;
WHILE : 'while' ;
DO : 'do' ;
FOR : 'for' ;
IN : 'in' ;
SWITCH : 'switch' ;
CASE : 'case' ;
DEFAULT : 'default' ;
BREAK : 'break' ;
CONTINUE : 'continue' ;
RETURN : 'return' ;
TRY : 'try' ;
CATCH : 'catch' ;
FINALLY : 'finally' ;
THROW : 'throw' ;
RETRY : 'retry' ;
PARALLEL : 'parallel' ;
WHEN : 'when' ;
EVERY : 'every' ;
WAIT : 'wait' ;
UNTIL : 'until' ;
WITH : 'with' ;
TRUE : 'true' ;
FALSE : 'false' ;
INT_T : 'int' | 'long' ;
DOUBLE_T : 'double' | 'float' ;
BOOL_T : 'bool' | 'boolean' ;

// soft words: names everywhere except where the parser expects them
TEST : 'test' ;
RECORD : 'record' ;
PATH : 'path' ;
AS : 'as' ;

// ---------------------------------------------------------------- numbers
QUANTITY : NUM UNIT UEXP? ([*/] UNIT UEXP?)* ;                              // 90deg  9.81m/s^2
FLOAT : (DIG '.' DIG? | '.' DIG) EXP? [fFdD]? | DIG EXP [fFdD]? | DIG [fFdD] ;  // 0.5  .5  2.  1e-3
INT : DIG [lL]? | '0' [xX] [0-9a-fA-F]+ [lL]? ;                             // 42  1_000  0x1F
BADNUM : NUM LETTER (LETTER | [0-9])* ;                                     // 5cmm

fragment NUM : DIG ('.' DIG?)? EXP? | '.' DIG EXP? ;
fragment DIG : [0-9] ('_'? [0-9])* ;
fragment EXP : [eE] [+-]? [0-9]+ ;
fragment UEXP : '^' '-'? [0-9] ;
fragment UNIT
  : 'deg' | '\u00B0' | 'rad' | 'mrad' | 'rev'
  | 'um' | '\u00B5m' | '\u03BCm' | 'mm' | 'cm' | 'dm' | 'm' | 'km' | 'inch'
  | 'us' | '\u00B5s' | '\u03BCs' | 'ms' | 's' | 'min' | 'h'
  | 'g' | 'kg' | 'mN' | 'N' | 'kN' | 'Nm'
  | 'rpm' | 'Hz' | 'kHz' | 'J' | 'W' | 'Pa' | 'kPa' | 'MPa' | 'bar' | 'px'
  ;

// ---------------------------------------------------------------- text and names
// A text in three quotes may have several lines. Without closing quotes it contains the rest of the program.
FSTRING : 'f' '"' (~["\\\r\n] | '\\' ~[\r\n])* '"' | 'f' '"""' LONG_PART* '"""' ;
STRING
  : '"' (~["\\\r\n] | '\\' ~[\r\n])* '"'
  | '\'' (~['\\\r\n] | '\\' ~[\r\n])* '\''
  | '"""' LONG_PART* '"""'
  ;
BADSTR
  : 'f'? '"' (~["\\\r\n] | '\\' ~[\r\n])*
  | '\'' (~['\\\r\n] | '\\' ~[\r\n])*
  | 'f'? '"""' LONG_PART*
  ;
ID : LETTER (LETTER | [0-9])* ;

fragment LONG_PART : ('"' '"'?)? (~["\\] | '\\' .) ;

fragment LETTER : [a-zA-Z_\u00C0-\u00D6\u00D8-\u00F6\u00F8-\u024F\u0370-\u03FF] ;

// ---------------------------------------------------------------- marks
LBRACE : '{' ;
RBRACE : '}' ;
LPAREN : '(' ;
RPAREN : ')' ;
LBRACK : '[' ;
RBRACK : ']' ;
SEMI : ';' ;
COMMA : ',' ;
DOT : '.' ;
COLON : ':' ;
QMARK : '?' ;
ARROW : '->' ;
FATARROW : '=>' ;
EQ : '==' ;
NE : '!=' ;
LE : '<=' ;
GE : '>=' ;
LT : '<' ;
GT : '>' ;
ANDAND : '&&' ;
OROR : '||' ;
NOT : '!' ;
PLUSEQ : '+=' ;
MINUSEQ : '-=' ;
STAREQ : '*=' ;
SLASHEQ : '/=' ;
PERCENTEQ : '%=' ;
ASSIGN : '=' ;
INC : '++' ;
DEC : '--' ;
DOTSTAR : '.*' ;
DOTSLASH : './' ;
DOTCARET : '.^' ;
PLUS : '+' ;
MINUS : '-' ;
STAR : '*' ;
SLASH : '/' ;
PERCENT : '%' ;
BSLASH : '\\' ;
CARET : '^' ;

// ---------------------------------------------------------------- comments, blanks and line breaks
BLOCK_COMMENT : '/*' .*? '*/' -> channel(HIDDEN) ;
LINE_COMMENT : '//' ~[\r\n]* -> channel(HIDDEN) ;
NL : ('\r'? '\n' | '\r') -> channel(LINE_BREAKS) ;
WS : [ \t\f\u00A0\uFEFF]+ -> skip ;
ERR : . ;
