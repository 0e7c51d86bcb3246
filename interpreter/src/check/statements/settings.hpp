#pragma once
// with (name: value, ...) { }, and the settings of blocks like it.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// before: what is computed outside of the block; inside: the settings.
struct CheckedSettings {
  std::vector<hir::Stmt*> before{};
  std::vector<hir::Stmt*> inside{};
};

// The settings behind `word`, "with" or "path": each is a function of the host, such as
// "with.speed".
[[nodiscard]] CheckedSettings check_settings(Checker& checker, std::string_view word,
                                             ast::Seq<ast::Arg> settings);

// A call of a function of the host without arguments, as a statement of `span`; `mark` is what
// failures of it mark.
[[nodiscard]] hir::Stmt* host_call(Checker& checker, std::string_view name, Span mark, Span span);

hir::Stmt* check_with(Checker& checker, const ast::WithStmt& stmt);

}  // namespace armlet::lang
