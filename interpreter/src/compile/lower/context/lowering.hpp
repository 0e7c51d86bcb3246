#pragma once
// One function of the checked program on its way to bytecode.
//
// The rules, one for each kind of node, are functions of lower_*.cpp that take this first. Numbers
// are evaluated into number registers, destination first, so that few moves are needed. References
// are either borrowed, when someone else keeps them alive while they are needed, or counted into a
// reference register.

#include "compile/code/emitter.hpp"
#include "compile/code/tables.hpp"
#include "compile/lower/context/homes.hpp"
#include "compile/lower/context/last_uses.hpp"
#include "compile/lower/context/loops.hpp"
#include "compile/lower/context/terms.hpp"
#include "compile/lower/context/ways_out.hpp"
#include "compile/lower/lower.hpp"

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
