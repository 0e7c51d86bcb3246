#pragma once
// The tables of a program that all functions share, such as constants and layouts. Each entry
// exists once and is found by its contents.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_set>
#include <utility>

#include "program/program.hpp"

namespace armlet::lang {

class Tables {
 public:
  explicit Tables(CompiledProgram& program) : program_(program) {}

  [[nodiscard]] std::uint32_t native(const NativeFunction* function);
  [[nodiscard]] std::uint32_t text(std::string_view text);
  [[nodiscard]] std::uint32_t layout(const Type* record);
  [[nodiscard]] std::uint32_t format(const Format& format);
  [[nodiscard]] std::uint32_t add_assert(const hir::AssertStmt& statement);
  [[nodiscard]] std::uint32_t add_expect(const hir::AssertThrowsStmt& statement);
  [[nodiscard]] std::uint32_t add_wait(const hir::WaitUntilStmt& statement);

  // Functions whose calls are inlined: inlining.hpp.
  void inline_calls(std::unordered_set<const hir::Function*> functions) {
    inlined_ = std::move(functions);
  }
  [[nodiscard]] const std::unordered_set<const hir::Function*>& inlined() const { return inlined_; }
  [[nodiscard]] bool inlines(const hir::Function& function) const {
    return inlined_.contains(&function);
  }

  // Sets the pointers from layouts to their lists of references, after the last list was added.
  void finish();
  [[nodiscard]] CompiledProgram& program() { return program_; }

 private:
  using FormatKey = std::tuple<const Type*, TextStyle, std::string, double>;

  NotedStatements& noted();

  CompiledProgram& program_;
  std::map<const NativeFunction*, std::uint32_t> natives_;
  std::map<std::string, std::uint32_t, std::less<>> texts_;
  std::map<const Type*, std::uint32_t> layouts_;
  std::map<FormatKey, std::uint32_t> formats_;
  std::unordered_set<const hir::Function*> inlined_;
};

}  // namespace armlet::lang
