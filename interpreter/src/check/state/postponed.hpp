#pragma once
// Checks that need the whole program, in the order of the text.

#include <string_view>
#include <utility>
#include <vector>

#include "ast/ast.hpp"
#include "check/scopes/uses.hpp"
#include "hir/hir.hpp"

namespace armlet::lang {

// The postponed checks of all files.
class Postponed {
 public:
  // A function that is called at each instant while time stands still.
  struct Condition {
    const hir::Function* function;
    Span span;
  };
  // A script function that is an argument of a library function, which calls it.
  struct Callback {
    std::string_view called_by;
    const hir::Function* function;
    Span span;
    // The host calls it at any time (read_function), so it must not change anything.
    bool is_read = false;
  };
  // A text with the units of a value, which is empty until all functions are checked.
  struct Units {
    hir::TextExpr* text;
    const hir::Expr* value;
  };
  struct Path {
    const hir::Block* body;
    Span head;  // the start of the statement
  };

  void add(const Condition& condition) { conditions_.push_back(condition); }
  void add(const Callback& callback) { callbacks_.push_back(callback); }
  void add(const Units& units) { units_.push_back(units); }
  void add(const Path& path) { paths_.push_back(path); }

  [[nodiscard]] const std::vector<Condition>& conditions() const { return conditions_; }
  [[nodiscard]] const std::vector<Callback>& callbacks() const { return callbacks_; }
  [[nodiscard]] const std::vector<Units>& units() const { return units_; }
  [[nodiscard]] const std::vector<Path>& paths() const { return paths_; }

 private:
  std::vector<Condition> conditions_;
  std::vector<Callback> callbacks_;
  std::vector<Units> units_;
  std::vector<Path> paths_;
};

// The postponed checks of one file: tests, and statements that an imported file must not have.
class PostponedStatements {
 public:
  struct Active {
    Span span;
    Use use;
  };

  void add_test(const ast::TestStmt& stmt) { waiting_tests_.push_back(&stmt); }
  [[nodiscard]] const std::vector<const ast::TestStmt*>& waiting_tests() const {
    return waiting_tests_;
  }
  void add_checked_test(hir::Test test) { tests_.push_back(test); }
  [[nodiscard]] const std::vector<hir::Test>& tests() const { return tests_; }

  // Notes a statement that is not a declaration.
  void add_active(Span span, Use use) { active_.push_back({span, std::move(use)}); }
  [[nodiscard]] const std::vector<Active>& active() const { return active_; }

 private:
  std::vector<const ast::TestStmt*> waiting_tests_;
  std::vector<hir::Test> tests_;
  std::vector<Active> active_;
};

}  // namespace armlet::lang
