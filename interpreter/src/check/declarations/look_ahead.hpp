#pragma once
// Facts about the names of a program that are known before it is checked: names it uses, and names
// it changes.

#include <set>
#include <string_view>

#include "ast/ast.hpp"

namespace armlet::lang {

struct Sights {
  std::set<std::string_view> mentioned;  // names before a call, after a point, or alone
  std::set<std::string_view> settings;   // of `with`
  std::set<std::string_view>
      changed;  // variables that a statement may change after their declaration
};

[[nodiscard]] Sights look_over(const ast::Block& program);

// Whether a `return` in the body has a value; lambdas inside do not count.
[[nodiscard]] bool returns_a_value(const ast::Block& body);

}  // namespace armlet::lang
