#pragma once
// The global variables of all files.

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

  // For an entry of a session: all variables stay for later entries.
  void keep_all() { keeps_all_ = true; }

  // use: the names that its first value uses.
  void add(hir::Variable* variable, hir::InitStmt* init, Use use);
  [[nodiscard]] std::size_t count() const { return entries_.size(); }
  // The variables in their order.
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  // The uses of a variable's first value; null if it is not global.
  [[nodiscard]] const Use* use_of(const hir::Variable* variable) const;

  // Makes a variable global because functions use it; it may be in a block of the top level.
  void make_global(hir::Variable& variable);
  // Makes those of the main file, which has this number, visible to the host.
  void open(std::uint32_t main_source);
  // Numbers all global variables and returns them.
  [[nodiscard]] std::vector<hir::Variable*> number_globals() const;

 private:
  bool keeps_all_ = false;
  std::vector<Entry> entries_;
  std::unordered_map<const hir::Variable*, Use> uses_;
  std::vector<hir::Variable*> inner_globals_;  // of blocks
};

}  // namespace armlet::lang
