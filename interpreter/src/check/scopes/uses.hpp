#pragma once
// The functions and variables that each function uses, and conclusions from them: functions that
// take time, and variables that calls of the top level may read too early.

#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "hir/hir.hpp"

namespace armlet::lang {

// The global variables and functions that the text of a function uses.
struct Use {
  std::vector<hir::Variable*> globals{};
  std::vector<const hir::Function*> calls{};
  std::unordered_set<const void*> known{};
  bool pauses = false;

  void add(hir::Variable* variable);
  void add(const hir::Function* function);
  void add(const Use& other);
};

// The uses of all functions of the program.
class Uses {
 public:
  [[nodiscard]] Use& of(const hir::Function* function) { return uses_[function]; }

  // A call of the top level, after this count of its variables.
  struct MainCall {
    const hir::Function* function;
    std::size_t declared;
  };
  void add_main_call(const hir::Function* function, std::size_t declared) {
    main_calls_.push_back({function, declared});
  }
  [[nodiscard]] const std::vector<MainCall>& main_calls() const { return main_calls_; }

  // Whether the code that `use` describes may wait or move. Valid once all functions have been
  // checked.
  [[nodiscard]] bool may_pause(const Use& use);

 private:
  std::unordered_map<const hir::Function*, Use> uses_;
  std::vector<MainCall> main_calls_;
  // Functions that may wait or move, directly or through others.
  std::optional<std::unordered_set<const hir::Function*>> pausing_;
};

}  // namespace armlet::lang
