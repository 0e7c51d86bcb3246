#pragma once
// with (name: value, ...) { }, and the settings of similar blocks.

#include <string_view>
#include <vector>

#include "check/state/checker.hpp"

namespace armlet::lang {

// before: statements that run before the block; inside: the settings.
struct CheckedSettings {
  std::vector<hir::Stmt*> before{};
  std::vector<hir::Stmt*> inside{};
};

// The settings after `word`, "with" or "path": each is a function of the host, such as
// "with.speed".
[[nodiscard]] CheckedSettings check_settings(Checker& checker, std::string_view word,
                                             ast::Seq<ast::Arg> settings);

// A call of the host function for an event of the block `word`, as a statement with the span `span`;
// messages of its failures mark `mark`.
[[nodiscard]] hir::Stmt* event_call(Checker& checker, BlockEvent event, std::string_view word,
                                    Span mark, Span span);

hir::Stmt* check_with(Checker& checker, const ast::WithStmt& stmt);

}  // namespace armlet::lang
