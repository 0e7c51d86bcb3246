#pragma once
// The variables of the top level of all files.

#include <unordered_map>
#include <vector>

#include "check/scopes/uses.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

class TopLevel {
 public:
  struct Entry {
    hir::Variable* variable;
    hir::InitStmt* init;
  };

  // An entry: all variables stay for the entries behind it.
  void keep_all() { keeps_all_ = true; }

  // use: what its first value mentions.
  void add(hir::Variable* variable, hir::InitStmt* init, Use use);
  [[nodiscard]] std::size_t count() const { return entries_.size(); }
  // In their order.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  // null: it is no variable of the top level.
  [[nodiscard]] const Use* use_of(const hir::Variable* variable) const;

  // Functions use the variable, which may stand in a block of the top level too.
  void make_global(hir::Variable& variable);
  // Shows those of the main file, which has this number, to the host.
  void open(std::uint32_t main_source);
  // All global variables, numbered.
  [[nodiscard]] std::vector<hir::Variable*> number_globals() const;

 private:
  bool keeps_all_ = false;
  std::vector<Entry> entries_;
  std::unordered_map<const hir::Variable*, Use> uses_;
  std::vector<hir::Variable*> inner_globals_;  // of blocks
};

}  // namespace armlet::lang
