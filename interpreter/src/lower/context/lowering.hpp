#pragma once
// One function of the checked program on its way to bytecode.
//
// The rules, one for each kind of node, are functions of lower_*.cpp that take this first. Numbers
// are evaluated into number registers, destination first, so that few moves are needed. References
// are either borrowed, when someone else keeps them alive while they are needed, or counted into a
// reference register.

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
  Span marked{};  // the statement whose MARK was made last
};

}  // namespace armlet::lang
