#pragma once
// The functions of a program as they are made, and the forms of its named functions whose bodies
// wait to be checked.

#include <deque>
#include <string_view>
#include <vector>

#include "armlet/interpreter/type.hpp"
#include "base/arena.hpp"
#include "check/scopes/declared.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

class Instances {
 public:
  Instances(Arena& arena, const TypePool& types) : arena_(arena), types_(types) {}

  // A function without a body, numbered in the order of making.
  hir::Function* make_function(std::string_view name, Span span);
  [[nodiscard]] const std::vector<hir::Function*>& functions() const { return functions_; }

  // The form of a function for the types of a call.
  Instance& add(FunctionDecl& declaration, std::vector<const Type*> types, Span call);

  // Its body is checked later, as its result is declared.
  void wait(Instance& instance) { waiting_.push_back(&instance); }
  [[nodiscard]] const std::vector<Instance*>& waiting() const { return waiting_; }
  // The one that has waited longest comes next, and then the others as they began to wait.
  void turn_round();
  // Null if none waits.
  [[nodiscard]] Instance* next();

 private:
  Arena& arena_;
  const TypePool& types_;
  std::vector<hir::Function*> functions_;
  std::deque<Instance> instances_;
  std::vector<Instance*> waiting_;  // the next one last
};

}  // namespace armlet::lang
