// Finds resources of the host that two branches of one `parallel` would command at the same time,
// as far as the text shows it.

#include <algorithm>
#include <iterator>

#include "check/statements/tasks.hpp"
#include "hir/walk.hpp"

namespace armlet::lang {

namespace {

using hir::ExprKind;
using hir::StmtKind;

bool commands_a_resource(const hir::CallNativeExpr& call) {
  if (call.arguments.empty() || !call.arguments[0]->type->is(Kind::kHost)) return false;
  const NativeFunction& function = *call.function;
  return call.arguments[0]->type->host->resource != nullptr && !function.interrupts &&
         (function.pauses || function.commands);
}

// The first commands of a branch.
struct Beginning {
  const hir::CallNativeExpr* command = nullptr;
  bool is_known = true;  // false: the branch may take time before its first command
};

void look(const hir::Expr& whole, Beginning& out) {
  (void)any_part(whole, [&](const hir::Expr& e) {
    if (e.kind == ExprKind::kCall || e.kind == ExprKind::kCallValue) out.is_known = false;
    if (e.kind != ExprKind::kCallNative) return false;
    const auto& call = e.as<hir::CallNativeExpr>();
    if (!commands_a_resource(call)) return false;
    out.command = &call;
    return true;
  });
}

void look(const hir::Stmt& stmt, Beginning& out) {
  if (stmt.kind == StmtKind::kBlock) {
    for (const hir::Stmt* inner : stmt.as<hir::Block>().body) {
      if (out.command == nullptr && out.is_known) look(*inner, out);
    }
  } else if (stmt.kind == StmtKind::kTry) {
    look(*stmt.as<hir::TryStmt>().body, out);
  } else if (stmt.kind == StmtKind::kInit || stmt.kind == StmtKind::kAssign ||
             stmt.kind == StmtKind::kExpr) {
    for_each_child(
        stmt,
        [&](const hir::Expr& e) {
          if (out.command == nullptr && out.is_known) look(e, out);
        },
        [](const hir::Stmt&) {});
  } else {
    out.is_known = false;
  }
}

// The variable that declares a resource, found through the tasks that share it; null for the
// resource of the host.
const hir::Variable* declared_resource(const hir::Expr& resource) {
  if (resource.kind != ExprKind::kVariable) return nullptr;
  const hir::Variable* variable = resource.as<hir::VariableExpr>().variable;
  while (variable->outer != nullptr) variable = variable->outer;
  return variable;
}

// The span of `left.run`, without the arguments.
Span command_span(const hir::CallNativeExpr& call) {
  const Span resource = call.arguments[0]->span;
  const bool is_method = !resource.empty() && resource.begin < call.site.callee.begin;
  return is_method ? cover(resource, call.site.callee) : call.site.callee;
}

// The text of a command for the fix; several arguments are omitted.
std::string in_short(const Checker& checker, const hir::CallNativeExpr& call) {
  std::size_t written = 0;
  for (const Span argument : call.site.arguments) {
    const bool is_resource = argument.begin == call.arguments[0]->span.begin;
    if (!argument.empty() && !is_resource) ++written;
  }
  const std::string head = checker.text_of(command_span(call));
  if (written > 1) return head + "(...)";
  return checker.text_of(cover(command_span(call), call.site.call));
}

}  // namespace

void refuse_busy_resources(Checker& checker, Span word,
                           const std::vector<const hir::Function*>& branches) {
  struct Command {
    const hir::CallNativeExpr* call;
    const hir::Variable* resource;
    std::string branch;
    std::size_t index;  // index of the branch
  };
  static constexpr const char* kOrdinals[] = {"first", "second", "third", "fourth", "fifth"};
  std::vector<Command> commands;
  // Indices of the commands, by resource.
  std::unordered_map<const hir::Variable*, std::size_t> places;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    Beginning beginning;
    look(*branches[i]->body, beginning);
    if (beginning.command == nullptr || !beginning.is_known) continue;
    const hir::Expr& resource = *beginning.command->arguments[0];
    const hir::Variable* variable = declared_resource(resource);
    if (variable == nullptr && resource.kind != ExprKind::kCallNative) continue;
    if (variable != nullptr && checker.names.is_changed(variable->name)) continue;
    const auto [place, is_new] = places.try_emplace(variable, commands.size());
    const std::string branch = i < std::size(kOrdinals) ? std::string(kOrdinals[i]) + " branch"
                                                        : "branch " + std::to_string(i + 1);
    if (is_new) {
      commands.push_back({beginning.command, variable, branch, i});
      continue;
    }
    const Command* const same = &commands[place->second];
    const std::string name(variable != nullptr ? variable->name : resource.type->host->name);
    Diagnostic diagnostic = make_diagnostic("E0501", command_span(*beginning.command), {name});
    diagnostic.mark.label = branch;
    diagnostic.related.push_back({{word.begin, word.begin, word.source}, {}});  // to show its line
    diagnostic.related.push_back({command_span(*same->call), same->branch});
    diagnostic.why =
        "each statement directly inside `parallel` runs at the same time as the others";
    diagnostic.fix = Fix{.text = "group steps that follow each other: parallel { { " +
                                 in_short(checker, *same->call) + "; " +
                                 in_short(checker, *beginning.command) + " } ... }"};
    if (same->index + 1 == i) {
      const Span first = branches[same->index]->span;
      const Span second = branches[i]->span;
      diagnostic.fix->edits = {{{first.begin, first.begin, first.source}, "{ "},
                               {{second.end, second.end, second.source}, " }"}};
    }
    checker.report(std::move(diagnostic));
    return;
  }
}

}  // namespace armlet::lang
