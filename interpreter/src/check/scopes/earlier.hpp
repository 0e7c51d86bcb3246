#pragma once
// The declarations of earlier entries of a session, as objects of the current check. They are made
// at the first use: the kept declarations are shared by all sessions that continue from there, and
// do not change.

#include <deque>
#include <memory>
#include <string_view>
#include <unordered_map>

#include "hir/kept.hpp"

namespace armlet::lang {

struct Checker;
struct Shared;

class Earlier {
 public:
  // kept  the names of the entry before; null for the first entry and for programs.
  Earlier(Shared& shared, const KeptNames* kept);
  ~Earlier();
  Earlier(const Earlier&) = delete;
  Earlier& operator=(const Earlier&) = delete;

  [[nodiscard]] const KeptNames* kept() const { return kept_; }

  // The file in its state at the end of its entry; functions that it declares are checked in it.
  Checker& file(const KeptFile& kept);
  FunctionDecl& function(const std::shared_ptr<const KeptFunction>& kept);
  const Import& import(const KeptName& kept);
  // The global variable with the number of the earlier one.
  hir::Variable* variable(const KeptName& kept);
  // The kept struct or enum; null if earlier entries do not declare it.
  [[nodiscard]] const KeptType* type(const void* info) const;

  // The forms that this entry added to functions of earlier entries.
  struct Grown {
    std::shared_ptr<const KeptFunction> from;
    const FunctionDecl* function;
  };
  [[nodiscard]] std::vector<Grown> grown() const;

 private:
  struct File;
  Shared& shared_;
  const KeptNames* kept_;
  std::unordered_map<const KeptFile*, std::unique_ptr<File>> files_;
  struct Function {
    std::shared_ptr<const KeptFunction> kept;
    FunctionDecl made;
    std::deque<Instance> instances;
  };
  std::unordered_map<const KeptFunction*, std::unique_ptr<Function>> functions_;
  std::unordered_map<const KeptName*, Import> imports_;
  std::unordered_map<const hir::Variable*, hir::Variable*> variables_;
};

}  // namespace armlet::lang
