#include "check/scopes/uses.hpp"

#include <algorithm>

namespace armlet::lang {

void Use::add(hir::Variable* variable) {
  if (known.insert(variable).second) globals.push_back(variable);
}

void Use::add(const hir::Function* function) {
  if (known.insert(function).second) calls.push_back(function);
}

void Use::add(const Use& other) {
  for (hir::Variable* variable : other.globals) add(variable);
  for (const hir::Function* function : other.calls) add(function);
  pauses = pauses || other.pauses;
}

bool Uses::may_pause(const Use& use) {
  if (!pausing_) {
    // The callers of each function, for the propagation of pauses from functions to their callers.
    std::unordered_map<const hir::Function*, std::vector<const hir::Function*>> callers;
    std::vector<const hir::Function*> open;
    for (const auto& [function, mentioned] : uses_) {
      if (mentioned.pauses) open.push_back(function);
      for (const hir::Function* called : mentioned.calls) callers[called].push_back(function);
    }
    auto& pausing = pausing_.emplace(open.begin(), open.end());
    while (!open.empty()) {
      const hir::Function* called = open.back();
      open.pop_back();
      for (const hir::Function* caller : callers[called]) {
        if (pausing.insert(caller).second) open.push_back(caller);
      }
    }
  }
  return use.pauses || std::ranges::any_of(use.calls, [this](const hir::Function* called) {
           return pausing_->contains(called);
         });
}

}  // namespace armlet::lang
