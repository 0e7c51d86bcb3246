// path (name: value, ...) { }: the host collects the moves of the block and executes them as one
// motion at its end. After an error before the end nothing has moved.

#include "check/statements/paths.hpp"

#include <algorithm>
#include <unordered_set>

#include "armlet/interpreter/resource.hpp"
#include "check/names/variables.hpp"
#include "check/statements/settings.hpp"
#include "hir/walk.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kWord = "path";

using hir::ExprKind;
using hir::StmtKind;

const hir::Function* written_function(const hir::Expr& value) {
  if (value.kind == ExprKind::kFunctionValue) return value.as<hir::FunctionValueExpr>().function;
  return value.kind == ExprKind::kClosure ? value.as<hir::ClosureExpr>().function : nullptr;
}

// A script function that is used as a value, with its type.
struct FunctionOfType {
  const Type* type;
  const hir::Function* function;
};

std::vector<FunctionOfType> function_values(const std::vector<hir::Function*>& functions) {
  std::vector<FunctionOfType> out;
  const auto look = [&](const hir::Expr& whole) {
    (void)any_part(whole, [&](const hir::Expr& e) {
      if (const hir::Function* function = written_function(e)) out.push_back({e.type, function});
      return false;
    });
  };
  for (const hir::Function* function : functions) {
    if (function->body == nullptr) continue;
    std::vector<const hir::Stmt*> open{function->body};
    while (!open.empty()) {
      const hir::Stmt& s = *open.back();
      open.pop_back();
      for_each_child(s, look, [&](const hir::Stmt& child) { open.push_back(&child); });
    }
  }
  return out;
}

// The variable of the resource that a motion commands, if the text shows it; null for the resource
// of the host, or for none.
const hir::Variable* resource_variable(const hir::CallNativeExpr& call) {
  const bool known = !call.arguments.empty() && call.arguments[0]->kind == ExprKind::kVariable;
  return known ? call.arguments[0]->as<hir::VariableExpr>().variable : nullptr;
}

// The host's words for the resource that a call commands; null if it commands none.
const ResourceWords* words_of(const hir::CallNativeExpr& call) {
  const bool has_host = !call.arguments.empty() && call.arguments[0]->type->is(Kind::kHost);
  return has_host ? call.arguments[0]->type->host->resource : nullptr;
}

// Checks one path with the functions that it calls.
class PathRules {
 public:
  PathRules(Checker& checker, const Postponed::Path& path) : checker_(checker), path_(path) {}

  void check() { look(*path_.body); }

 private:
  using Words = ResourceWords::Refusal;

  void refuse(Span span) {
    refuse(span, {{},
                  "the whole path is planned before it starts, so nothing can happen in the middle",
                  "move this line out of the path"});
  }
  void refuse(Span span, const Words& words) {
    if (outer_ != nullptr && told_ == outer_) return;
    told_ = outer_;
    Diagnostic diagnostic = make_diagnostic("E0502", outer_ != nullptr ? outer_->span : span);
    if (!words.message.empty()) diagnostic.message = words.message;
    diagnostic.related.push_back({path_.head, {}});  // to show its line
    if (outer_ != nullptr) diagnostic.related.push_back({span, "called for by this path"});
    diagnostic.why = words.why;
    diagnostic.fix = Fix{.text = std::string(words.fix)};
    checker_.messages.begin_statement();
    checker_.report(std::move(diagnostic));
  }

  void look(const hir::Stmt& s) {
    switch (s.kind) {
      case StmtKind::kWait:
      case StmtKind::kWaitUntil:
      case StmtKind::kWhen:
      case StmtKind::kEvery:
        return refuse(s.span);
      case StmtKind::kParallel:
        return refuse(s.as<hir::ParallelStmt>().word);
      case StmtKind::kExpr:
        return statement(*s.as<hir::ExprStmt>().value);
      case StmtKind::kReturn:
        if (const hir::Expr* value = s.as<hir::ReturnStmt>().value) {
          statement(*value);
          if (is_move(*value)) gives_move_.insert(function_);
        }
        return;
      case StmtKind::kBlock:
      case StmtKind::kInit:
      case StmtKind::kAssign:
      case StmtKind::kIf:
      case StmtKind::kLoop:
      case StmtKind::kRange:
      case StmtKind::kForList:
      case StmtKind::kSwitch:
      case StmtKind::kTry:
      case StmtKind::kThrow:
      case StmtKind::kJump:
      case StmtKind::kAssert:
      case StmtKind::kAssertThrows:
      case StmtKind::kStorePart:
        for_each_child(
            s, [&](const hir::Expr& e) { value(e); }, [&](const hir::Stmt& child) { look(child); });
    }
  }

  // Whether the expression is a call whose result is a planned move that is not executed yet.
  [[nodiscard]] bool is_move(const hir::Expr& e) const {
    if (e.kind == ExprKind::kCallNative)
      return e.as<hir::CallNativeExpr>().function->in_path && !e.type->is(Kind::kVoid);
    return e.kind == ExprKind::kCall && gives_move_.contains(e.as<hir::CallExpr>().function);
  }

  // Checks an expression statement or a returned value, which may be a move.
  void statement(const hir::Expr& e) {
    one(e);
    if (e.kind == ExprKind::kGuarded) return;
    for_each_operand(e, [&](const hir::Expr& operand) { value(operand); });
  }

  void value(const hir::Expr& whole) {
    (void)any_part(whole, [&](const hir::Expr& e) {
      one(e);
      if (is_move(e)) {
        refuse(e.span, {"a move inside a `path` has no result yet",
                        "it is made when the path ends, so there is nothing to know about it here",
                        "call it without using its result"});
      }
      return false;
    });
  }

  // Checks one expression without its operands.
  void one(const hir::Expr& e) {
    if (e.kind == ExprKind::kGuarded)
      return refuse(e.span, {"a move inside a `path` cannot have a condition",
                             "the path is one motion, and no part of it can be stopped by itself",
                             "move this line out of the path, or leave `until` out"});
    if (e.kind == ExprKind::kCallNative) return native(e.as<hir::CallNativeExpr>());
    if (e.kind == ExprKind::kCall) return enter(*e.as<hir::CallExpr>().function, e);
    if (e.kind == ExprKind::kCallValue) return handed(*e.as<hir::CallValueExpr>().function, e);
    if (e.kind != ExprKind::kOverList) return;
    for (const hir::Expr* operand : e.as<hir::OverListExpr>().operands) handed(*operand, e);
  }

  void native(const hir::CallNativeExpr& call) {
    const NativeFunction& function = *call.function;
    if (function.in_path) return call.type->is(Kind::kVoid) ? void() : same_resource(call);
    if (function.event == BlockEvent::kPathMoves) {
      return refuse(call.span, {"a `path` cannot contain another one", "a path is one motion",
                                "write the moves of both in one path"});
    }
    if (function.event == BlockEvent::kPathBegins || function.event == BlockEvent::kPathEnds)
      return;
    if (function.name.starts_with("with.")) {
      return refuse(call.span,
                    {"this setting cannot change inside a `path`", "it holds for the whole motion",
                     "write the `with` around the path"});
    }
    if (function.pauses && !call.type->is(Kind::kVoid)) {
      const ResourceWords* words = words_of(call);
      return words != nullptr ? refuse(call.span, words->not_in_path) : refuse(call.span);
    }
    if (function.pauses || function.commands || function.acts || call.type->is(Kind::kVoid))
      return refuse(call.span);
    for (const hir::Expr* argument : call.arguments) handed(*argument, call);
  }

  // Checks a function value that is called, or passed to a function that calls it: every script
  // function that it can be.
  void handed(const hir::Expr& value, const hir::Expr& call) {
    if (!value.type->is(Kind::kFunction)) return;
    if (const hir::Function* function = written_function(value)) return enter(*function, call);
    if (!values_known_) values_ = function_values(checker_.shared.instances.functions());
    values_known_ = true;
    for (const FunctionOfType& other : values_) {
      if (other.type == value.type) enter(*other.function, call);
    }
  }

  void enter(const hir::Function& function, const hir::Expr& call) {
    if (function.body == nullptr || !entered_.insert(&function).second) return;
    const hir::Expr* const outer = outer_;
    const hir::Function* const around = std::exchange(function_, &function);
    if (outer_ == nullptr) outer_ = &call;
    look(*function.body);
    outer_ = outer;
    function_ = around;
  }

  // Checks that all moves command one resource, only in the text of the path itself: a function may
  // be called with any resource.
  void same_resource(const hir::CallNativeExpr& call) {
    const hir::Variable* resource = resource_variable(call);
    const ResourceWords* words = words_of(call);
    if (outer_ != nullptr || resource == nullptr || words == nullptr) return;
    if (resource_ == nullptr) resource_ = resource;
    if (resource == resource_ || checker_.names.is_changed(resource->name)) return;
    refuse(call.span, words->two_in_path);
  }

  Checker& checker_;
  const Postponed::Path& path_;
  const hir::Expr* outer_ = nullptr;  // the call in the path that leads to the current function
  const hir::Expr* told_ = nullptr;
  const hir::Function* function_ = nullptr;  // the current function; null: the path itself
  const hir::Variable* resource_ = nullptr;
  std::unordered_set<const hir::Function*> entered_;
  std::unordered_set<const hir::Function*> gives_move_;
  std::vector<FunctionOfType> values_;
  bool values_known_ = false;
};

}  // namespace

Diagnostic leaves_path(const std::string& word, Span span) {
  Diagnostic diagnostic = make_diagnostic("E0502", span);
  diagnostic.message = '`' + word + "` cannot leave a `path`";
  diagnostic.why = "the path is made when its end is reached, so half of it would never be made";
  diagnostic.fix = Fix{.text = "decide before the path which moves it has"};
  return diagnostic;
}

hir::Stmt* check_path(Checker& checker, const ast::PathStmt& stmt) {
  const std::uint32_t begin = stmt.span.begin;
  const Span word{begin, begin + static_cast<std::uint32_t>(kWord.size()), stmt.span.source};
  if (checker.registry.functions(BlockEvent::kPathMoves).empty()) {
    checker.report(make_diagnostic("E0201", word, {std::string(kWord)}));
    return checker.check_block(stmt.body->body, stmt.body->span);
  }
  checker.scopes.open_block();
  CheckedSettings settings = check_settings(checker, kWord, stmt.settings);
  checker.scopes.here().targets.push_back({JumpTarget::Kind::kPath, nullptr});
  hir::Block* body = checker.check_block(stmt.body->body, stmt.body->span);
  checker.scopes.here().targets.pop_back();
  close_block(checker);
  checker.shared.postponed.add(Postponed::Path{body, {begin, begin, stmt.span.source}});
  const auto block = [&](const std::vector<hir::Stmt*>& parts) {
    return checker.make<hir::Block>(StmtKind::kBlock, stmt.span, checker.seq(parts));
  };
  const auto call = [&](BlockEvent event) {
    return event_call(checker, event, kWord, word, stmt.span);
  };
  settings.inside.push_back(body);
  settings.inside.push_back(call(BlockEvent::kPathMoves));
  settings.before.push_back(call(BlockEvent::kPathBegins));
  settings.before.push_back(checker.make<hir::TryStmt>(StmtKind::kTry, stmt.span,
                                                       block(settings.inside), nullptr, nullptr,
                                                       block({call(BlockEvent::kPathEnds)})));
  return block(settings.before);
}

void check_paths(Checker& checker) {
  for (const Postponed::Path& path : checker.shared.postponed.paths())
    PathRules(checker, path).check();
}

}  // namespace armlet::lang
