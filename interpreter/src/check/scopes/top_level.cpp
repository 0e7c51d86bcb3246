#include "check/scopes/top_level.hpp"

#include <utility>

namespace armlet::lang {

void TopLevel::add(hir::Variable* variable, hir::InitStmt* init, Use use) {
  if (keeps_all_) variable->storage = hir::Storage::kGlobal;
  entries_.push_back({variable, init});
  uses_[variable] = std::move(use);
}

const Use* TopLevel::use_of(const hir::Variable* variable) const {
  const auto found = uses_.find(variable);
  return found == uses_.end() ? nullptr : &found->second;
}

void TopLevel::make_global(hir::Variable& variable) {
  if (std::exchange(variable.storage, hir::Storage::kGlobal) == hir::Storage::kGlobal) return;
  if (!uses_.contains(&variable)) inner_globals_.push_back(&variable);
}

void TopLevel::open(std::uint32_t main_source) {
  for (const auto& [variable, init] : entries_) {
    if (variable->declared.source != main_source || variable->name.empty()) continue;
    variable->storage = hir::Storage::kGlobal;
    variable->is_open = true;
  }
}

std::vector<hir::Variable*> TopLevel::number_globals() const {
  std::vector<hir::Variable*> out;
  for (const auto& [variable, init] : entries_) {
    if (variable->storage == hir::Storage::kGlobal) out.push_back(variable);
  }
  out.insert(out.end(), inner_globals_.begin(), inner_globals_.end());
  for (std::size_t i = 0; i < out.size(); ++i) out[i]->index = static_cast<std::uint32_t>(i);
  return out;
}

}  // namespace armlet::lang
