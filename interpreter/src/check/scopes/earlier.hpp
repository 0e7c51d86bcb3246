#pragma once
// What an entry finds of the entries before it, made for its own check when it is first mentioned:
// the kept things are shared by all who go on from there, and are not touched.

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
  // kept  of the entry before; null: this is the first one, or no entry at all.
  Earlier(Shared& shared, const KeptNames* kept);
  ~Earlier();
  Earlier(const Earlier&) = delete;
  Earlier& operator=(const Earlier&) = delete;

  [[nodiscard]] const KeptNames* kept() const { return kept_; }

  // The file as it was at the end of its entry: functions declared there are checked in it.
  Checker& file(const KeptFile& kept);
  FunctionDecl& function(const std::shared_ptr<const KeptFunction>& kept);
  const Import& import(const KeptName& kept);
  // A variable of the program with the number of the earlier one.
  hir::Variable* variable(const KeptName& kept);
  // Of a struct that earlier entries declare; nothing: they do not.
  [[nodiscard]] const KeptType* type(const void* info) const;

  // Forms that this entry added to functions of earlier ones.
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
