#pragma once
// Names of the kinds of tokens, for code outside of the parser.

#include <RbtLexer.h>

#include <cstdint>

namespace armlet::lang::sign {

inline constexpr std::uint16_t kPoint = RbtLexer::DOT;
inline constexpr std::uint16_t kColon = RbtLexer::COLON;
inline constexpr std::uint16_t kComma = RbtLexer::COMMA;
inline constexpr std::uint16_t kSemicolon = RbtLexer::SEMI;
inline constexpr std::uint16_t kOpenParenthesis = RbtLexer::LPAREN;
inline constexpr std::uint16_t kOpenBrace = RbtLexer::LBRACE;
inline constexpr std::uint16_t kText = RbtLexer::STRING;
inline constexpr std::uint16_t kFormattedText = RbtLexer::FSTRING;
inline constexpr std::uint16_t kUnclosedText = RbtLexer::BADSTR;
inline constexpr std::uint16_t kBadNumber = RbtLexer::BADNUM;
inline constexpr std::uint16_t kWith = RbtLexer::WITH;
inline constexpr std::uint16_t kPath = RbtLexer::PATH;

}  // namespace armlet::lang::sign
