#pragma once
// The functions of a program in the order of their creation, and the forms of named functions whose
// bodies are not checked yet.

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

  // Makes a function without a body; its number is the count of functions before.
  hir::Function* make_function(std::string_view name, Span span);
  [[nodiscard]] const std::vector<hir::Function*>& functions() const { return functions_; }

  // Adds a form of the function for the types of a call.
  Instance& add(FunctionDecl& declaration, std::vector<const Type*> types, Span call);

  // Postpones the check of the body, which is possible because the result type is declared.
  void wait(Instance& instance) { waiting_.push_back(&instance); }
  [[nodiscard]] const std::vector<Instance*>& waiting() const { return waiting_; }
  // Reverses the order of the postponed forms, so that the oldest one comes next.
  void turn_round();
  // The next postponed form; null if there is none.
  [[nodiscard]] Instance* next();

 private:
  Arena& arena_;
  const TypePool& types_;
  std::vector<hir::Function*> functions_;
  std::deque<Instance> instances_;
  std::vector<Instance*> waiting_;  // in reverse order
};

}  // namespace armlet::lang
