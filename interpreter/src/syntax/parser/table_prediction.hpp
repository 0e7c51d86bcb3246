#pragma once
// Predicts the alternative of a rule that the next tokens belong to. ANTLR finds it by interpreting
// the grammar and caches it; for up to five tokens the results are in generated/RbtTables.h.

#include "antlr4-runtime.h"

namespace armlet::lang {

// Predicts from the tables, otherwise with ANTLR, which reads the grammar first. Threads may parse
// at the same time; only predictions by ANTLR, which few programs need, wait for each other.
class TablePrediction : public antlr4::atn::ParserATNSimulator {
 public:
  TablePrediction(antlr4::Parser* of, ParserATNSimulator& other)
      : ParserATNSimulator(of, other.atn, other.decisionToDFA, other.getSharedContextCache()) {}

  std::size_t adaptivePredict(antlr4::TokenStream* input, std::size_t decision,
                              antlr4::ParserRuleContext* outer) override;

 private:
  std::size_t from_tables(antlr4::TokenStream& input, std::size_t decision) const;
};

// Whether a statement of a block, or the end of the block, may begin with a token of this kind.
[[nodiscard]] bool may_stand_in_block(std::size_t kind);

}  // namespace armlet::lang
