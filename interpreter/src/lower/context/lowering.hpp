#pragma once
// The state while one function of the checked program is compiled to bytecode.
//
// The rules, one for each kind of node, are functions of lower_*.cpp that take this state first.
// Numbers are evaluated into number registers, directly into the destination where possible, so
// that few moves are needed. References are either borrowed, while another owner keeps them alive,
// or counted and kept in a reference register.

#include "lower/context/emitter.hpp"
#include "lower/context/homes.hpp"
#include "lower/context/last_uses.hpp"
#include "lower/context/loops.hpp"
#include "lower/context/options.hpp"
#include "lower/context/tables.hpp"
#include "lower/context/terms.hpp"
#include "lower/context/ways_out.hpp"

namespace armlet::lang {

struct Lowering {
  Lowering(Tables& tables_of_program, const hir::Function& lowered, LowerOptions how)
      : tables(tables_of_program), function(lowered), options(how), code(lowered.span) {}

  [[nodiscard]] bool is_program() const { return &function == tables.program().module.main; }

  Tables& tables;
  const hir::Function& function;
  const LowerOptions options;
  Emitter code;
  Homes homes;
  Loops loops;
  WaysOut ways;
  LastUses uses;
  Span marked{};  // the statement of the last MARK instruction
};

}  // namespace armlet::lang
