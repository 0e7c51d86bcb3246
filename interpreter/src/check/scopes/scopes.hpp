#pragma once
// Where in a file the check is: in which function, and which variables can be seen there.

#include <string_view>
#include <utility>

#include "check/scopes/scope.hpp"
#include "check/scopes/uses.hpp"

namespace armlet::lang {

class Earlier;
class Names;

class Scopes {
 public:
  // A function, and where its uses are collected.
  struct Position {
    FunctionContext* function = nullptr;
    Use* use = nullptr;
  };

  // Variables of the entries before are found by what the file's names say of them.
  void follow(const Names& names, Earlier& earlier) {
    names_ = &names;
    earlier_names_ = &earlier;
  }
  // `program` is the file's top level as a function; before anything is checked.
  void begin(hir::Function* program, Use& use);

  [[nodiscard]] FunctionContext& here() { return *here_; }
  [[nodiscard]] const FunctionContext& here() const { return *here_; }
  // The top level.
  [[nodiscard]] FunctionContext& main() { return main_; }
  [[nodiscard]] const FunctionContext& main() const { return main_; }
  // What the text that is checked mentions.
  [[nodiscard]] Use& use() { return *use_; }

  // Whether this is the top level itself, outside of all blocks.
  [[nodiscard]] bool at_top_level() const { return here_ == &main_ && main_.blocks.size() == 1; }
  // Whether this is part of the top level, in lambdas and tasks too, but not in functions and
  // tests.
  [[nodiscard]] bool in_program() const { return &here_->root() == &main_; }

  // Into a function; gives where to come back to.
  [[nodiscard]] Position enter(FunctionContext& function, Use& use) {
    return {std::exchange(here_, &function), std::exchange(use_, &use)};
  }
  void come_back(Position to) {
    here_ = to.function;
    use_ = to.use;
  }
  // Uses are collected there from now on; gives where they were until now.
  Use& collect_in(Use& use) { return *std::exchange(use_, &use); }

  // While a default value is checked only the top level can be seen. Gives what held until now.
  bool see_top_level_only(bool only) { return std::exchange(only_top_level_, only); }

  // The variable of that name and the function that it belongs to; null if none can be seen.
  [[nodiscard]] Local* find(std::string_view name, FunctionContext*& where);
  // The same for the top level alone, as other files see it.
  [[nodiscard]] Local* find_top(std::string_view name, FunctionContext*& where);
  Local* add(hir::Variable* variable, Declared how, Span keyword);
  void open_block() { here_->blocks.push_back(here_->locals.size()); }
  // Of the innermost block; gives where its variables begin.
  [[nodiscard]] std::size_t close_block();
  // Forgets variables, except of the top level, which stay visible to functions checked later.
  void forget(std::size_t first);

 private:
  Local* find_here(std::string_view name, FunctionContext*& where);
  Local* find_earlier(std::string_view name, FunctionContext*& where);

  FunctionContext main_;
  FunctionContext earlier_;  // the variables of the entries before that were mentioned
  const Names* names_ = nullptr;
  Earlier* earlier_names_ = nullptr;
  FunctionContext* here_ = &main_;
  bool only_top_level_ = false;
  Use unused_{};
  Use* use_ = &unused_;
};

}  // namespace armlet::lang
