#pragma once
// Which alternative of a rule the next tokens belong to. ANTLR interprets the grammar to find out,
// and remembers; what it finds for up to five tokens is in generated/RbtTables.h.

#include "antlr4-runtime.h"

namespace armlet::lang {

// Answers from the tables, otherwise as ANTLR does, which reads the grammar first. Threads parse at
// once; only ANTLR's own answers, which few programs need, come one after the other.
class TablePrediction : public antlr4::atn::ParserATNSimulator {
 public:
  TablePrediction(antlr4::Parser* of, ParserATNSimulator& other)
      : ParserATNSimulator(of, other.atn, other.decisionToDFA, other.getSharedContextCache()) {}

  std::size_t adaptivePredict(antlr4::TokenStream* input, std::size_t decision,
                              antlr4::ParserRuleContext* outer) override;

 private:
  std::size_t from_tables(antlr4::TokenStream& input, std::size_t decision) const;
};

// Whether a statement of a block, or its end, may begin with a token of this kind.
[[nodiscard]] bool may_stand_in_block(std::size_t kind);

}  // namespace armlet::lang
