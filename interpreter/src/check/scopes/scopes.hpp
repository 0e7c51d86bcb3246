#pragma once
// The position of the check in a file: the current function, and its visible variables.

#include <string_view>
#include <utility>

#include "check/scopes/scope.hpp"
#include "check/scopes/uses.hpp"

namespace armlet::lang {

class Earlier;
class Names;

class Scopes {
 public:
  // A function, and the object that collects its uses.
  struct Position {
    FunctionContext* function = nullptr;
    Use* use = nullptr;
  };

  // Adds the variables of earlier entries, which the file's names refer to.
  void follow(const Names& names, Earlier& earlier) {
    names_ = &names;
    earlier_names_ = &earlier;
  }
  // `program` is the top level of the file as a function. Called before the check begins.
  void begin(hir::Function* program, Use& use);

  [[nodiscard]] FunctionContext& here() { return *here_; }
  [[nodiscard]] const FunctionContext& here() const { return *here_; }
  // The context of the top level.
  [[nodiscard]] FunctionContext& main() { return main_; }
  [[nodiscard]] const FunctionContext& main() const { return main_; }
  // Collects the names that the current text uses.
  [[nodiscard]] Use& use() { return *use_; }

  // Whether the position is at the top level, outside of all blocks.
  [[nodiscard]] bool at_top_level() const { return here_ == &main_ && main_.blocks.size() == 1; }
  // Whether the position is part of the top level, also inside lambdas and tasks, but not inside
  // functions and tests.
  [[nodiscard]] bool in_program() const { return &here_->root() == &main_; }

  // Enters a function; returns the old position, to restore it.
  [[nodiscard]] Position enter(FunctionContext& function, Use& use) {
    return {std::exchange(here_, &function), std::exchange(use_, &use)};
  }
  void come_back(Position to) {
    here_ = to.function;
    use_ = to.use;
  }
  // Collects uses in `use` from now on; returns the previous object.
  Use& collect_in(Use& use) { return *std::exchange(use_, &use); }

  // While a default value is checked only the top level is visible. Returns the previous setting.
  bool see_top_level_only(bool only) { return std::exchange(only_top_level_, only); }

  // The visible variable with that name and the function that it belongs to; null if there is none.
  [[nodiscard]] Local* find(std::string_view name, FunctionContext*& where);
  // The variable of the top level with that name, as other files use it; null if there is none.
  [[nodiscard]] Local* find_top(std::string_view name, FunctionContext*& where);
  Local* add(hir::Variable* variable, Declared how, Span keyword);
  void open_block() { here_->blocks.push_back(here_->locals.size()); }
  // Closes the innermost block; returns the index of its first variable.
  [[nodiscard]] std::size_t close_block();
  // Removes variables, except those of the top level, which stay visible in functions checked
  // later.
  void forget(std::size_t first);

 private:
  Local* find_here(std::string_view name, FunctionContext*& where);
  Local* find_earlier(std::string_view name, FunctionContext*& where);

  FunctionContext main_;
  FunctionContext earlier_;  // variables of earlier entries that the text uses
  const Names* names_ = nullptr;
  Earlier* earlier_names_ = nullptr;
  FunctionContext* here_ = &main_;
  bool only_top_level_ = false;
  Use unused_{};
  Use* use_ = &unused_;
};

}  // namespace armlet::lang
