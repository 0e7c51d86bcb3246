#pragma once
// Reads the tables of a generated parser or lexer, like antlr4::atn::ATNDeserializer, but in a
// third of the time, which is a part of every start of a program. ANTLR's reader determines the
// class of each state repeatedly by casts; this one uses the type in the table. The tables are part
// of the program, so they are not checked.

#include <antlr4-runtime.h>

#include <cstdint>
#include <vector>

class TableReader : public antlr4::atn::ATNDeserializer {
 public:
  antlr4::atn::ATN deserialize(const std::vector<std::uint16_t>& table) override;
};
