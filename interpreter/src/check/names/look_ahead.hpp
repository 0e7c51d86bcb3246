#pragma once
// What can be seen in a program without checking it: names it mentions, and names it changes.

#include <set>
#include <string_view>

#include "ast/ast.hpp"

namespace armlet::lang {

struct Sights {
  std::set<std::string_view> mentioned;  // names in front of a call, behind a point, or alone
  std::set<std::string_view> settings;   // of `with`
  std::set<std::string_view>
      changed;  // variables that some statement may change after their declaration
};

[[nodiscard]] Sights look_over(const ast::Block& program);

// Whether some `return` in it has a value; lambdas inside do not count.
[[nodiscard]] bool returns_a_value(const ast::Block& body);

}  // namespace armlet::lang
