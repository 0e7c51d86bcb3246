// Evaluates an expression of the program at the position where a run is paused.
//
// The expression becomes a function whose parameters are its local variables; the function is
// compiled and called like others.

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "armlet/core/ample_stack.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/host/inspection.hpp"
#include "hir/walk.hpp"
#include "lower/lower.hpp"
#include "vm/host/frames.hpp"
#include "vm/host/no_trace.hpp"
#include "vm/host/seen.hpp"
#include "vm/state/turn.hpp"

namespace armlet::lang {
namespace {

using namespace hir;

Error refusal(std::string why) { return {"value", std::move(why)}; }

std::string quoted(std::string_view name) { return '`' + std::string(name) + '`'; }

bool has(Span span, Span byte) {
  return span.source == byte.source && span.begin <= byte.begin && byte.begin < span.end;
}

// ---- where ----------------------------------------------------------------------------------

// A function of the program, with its frame if it is running.
struct Scene {
  const Function* function = nullptr;
  std::optional<Frame> frame{};
};

// The innermost functions whose text contains the byte. There are several if a function was checked
// for several argument types.
std::vector<const Function*> functions_at(const VmState& state, Span byte) {
  std::vector<const Function*> found;
  const auto length = [](const Function& f) { return f.span.end - f.span.begin; };
  const auto look = [&](const CompiledProgram& program) {
    for (const Function* function : program.module.functions) {
      if (!has(function->span, byte)) continue;
      if (!found.empty() && length(*function) < length(*found[0])) found.clear();
      if (found.empty() || length(*function) == length(*found[0])) found.push_back(function);
    }
  };
  for (const auto& unit : state.programs.units) look(*unit->program);
  if (found.empty()) look(*state.programs.newest);
  return found;
}

void find_in(const VmState& state, const Task& task, std::span<const Function* const> functions,
             Scene& scene) {
  for (const Frame* frame = task.stack.top; frame > task.stack.frames; --frame) {
    if (scene.frame || frame->is_host()) continue;
    const Function* function = frame->callee->function->function;
    if (std::ranges::find(functions, function) == functions.end()) continue;
    scene = {function, as_it_stands(state, task, *frame)};
  }
}

Scene scene_of(const Vm& vm, const VmState& state, Span byte) {
  const std::vector<const Function*> functions = functions_at(state, byte);
  Scene scene;
  if (functions.empty()) return scene;
  scene.function = functions[0];
  if (vm.result().status != Progress::kPaused) return scene;
  find_in(state, *state.running, functions, scene);
  find_in(state, state.main, functions, scene);
  for (const auto& task : state.tree.all())
    if (!task->has_ended) find_in(state, *task, functions, scene);
  return scene;
}

// Finds the innermost expression around a byte; null if there is none.
class Innermost {
 public:
  Innermost(const Function& function, Span byte) : byte_(byte) { look(*function.body); }
  [[nodiscard]] Expr* found() const { return const_cast<Expr*>(found_); }

 private:
  void look(const Stmt& stmt) {
    for_each_child(
        stmt, [this](const Expr& each) { look(each); }, [this](const Stmt& each) { look(each); });
  }
  void look(const Expr& root) {
    any_part(root, [this](const Expr& each) {
      // Absent arguments have the span of the function's name.
      if (is_name_) return false;
      const CallSite* site = site_of(each);
      is_name_ = site != nullptr && has(site->callee, byte_);
      if (is_name_ || (has(each.span, byte_) && is_inner(each))) found_ = &each;
      return false;
    });
  }

  static const CallSite* site_of(const Expr& expr) {
    if (expr.kind == ExprKind::kCall) return &expr.as<CallExpr>().site;
    if (expr.kind == ExprKind::kCallNative) return &expr.as<CallNativeExpr>().site;
    return expr.kind == ExprKind::kOverList ? &expr.as<OverListExpr>().site : nullptr;
  }
  // Of two expressions with the same text the outer one is taken, unless it is only a conversion of
  // the inner one.
  [[nodiscard]] bool is_inner(const Expr& expr) const {
    const auto length = [](const Expr& e) { return e.span.end - e.span.begin; };
    if (found_ == nullptr || length(expr) < length(*found_)) return true;
    return length(expr) == length(*found_) && found_->kind == ExprKind::kConvert;
  }

  Span byte_;
  const Expr* found_ = nullptr;
  bool is_name_ = false;  // the byte is in the name of a called function
};

// ---- whether ----------------------------------------------------------------------------------

// Finds a change that the evaluation of an expression would make, also in the functions that it
// calls.
class Changes {
 public:
  // The change as text for a message; empty if there is none.
  std::string of(const Expr& root) {
    look(root, nullptr);
    return std::move(why_);
  }

 private:
  void look(const Expr& root, const Function* in) {
    any_part(root, [&](const Expr& each) {
      if (why_.empty()) look_at(each, in);
      return !why_.empty();
    });
  }
  void look(const Stmt& stmt, const Function* in) {
    if (!why_.empty()) return;
    switch (stmt.kind) {
      case StmtKind::kWait:
      case StmtKind::kWaitUntil:
      case StmtKind::kParallel:
      case StmtKind::kWhen:
      case StmtKind::kEvery:
        why_ = quoted(in->name) + " takes time, so it is not called to look at its value.";
        return;
      case StmtKind::kAssign: {
        const Place& place = stmt.as<AssignStmt>().place;
        if (place.variable->storage != Storage::kLocal || !place.steps.empty())
          return changes(place, in);
        break;
      }
      case StmtKind::kStorePart:
        return changes(stmt.as<StorePartStmt>().place, in);
      case StmtKind::kBlock:
      case StmtKind::kInit:
      case StmtKind::kExpr:
      case StmtKind::kIf:
      case StmtKind::kLoop:
      case StmtKind::kRange:
      case StmtKind::kForList:
      case StmtKind::kSwitch:
      case StmtKind::kTry:
      case StmtKind::kThrow:
      case StmtKind::kJump:
      case StmtKind::kReturn:
      case StmtKind::kAssert:
      case StmtKind::kAssertThrows:
        break;
    }
    for_each_child(
        stmt, [&](const Expr& each) { look(each, in); }, [&](const Stmt& each) { look(each, in); });
  }
  void look_at(const Expr& expr, const Function* in) {
    if (expr.kind == ExprKind::kCallNative) {
      const NativeFunction& native = *expr.as<CallNativeExpr>().function;
      if (native.pauses || native.commands || native.acts || native.starts || native.interrupts ||
          native.timed != nullptr || expr.type->is(Kind::kVoid))
        why_ = quoted(native.name) + " acts or takes time, so it is not called to look at a value.";
    } else if (expr.kind == ExprKind::kGuarded) {
      why_ = "A motion is not started to look at its value.";
    } else if (expr.kind == ExprKind::kMutate) {
      changes(expr.as<MutateExpr>().place, in);
    } else if (expr.kind == ExprKind::kCallValue) {
      why_ = "Which function is called there shows only when the program runs it.";
    } else if (expr.kind == ExprKind::kCall) {
      enter(*expr.as<CallExpr>().function);
    } else if (expr.kind == ExprKind::kClosure) {
      enter(*expr.as<ClosureExpr>().function);
    } else if (expr.kind == ExprKind::kFunctionValue) {
      enter(*expr.as<FunctionValueExpr>().function);
    }
  }
  void enter(const Function& function) {
    if (met_.insert(&function).second && function.body != nullptr) look(*function.body, &function);
  }
  void changes(const Place& place, const Function* in) {
    why_ = (in != nullptr && !in->name.empty() ? quoted(in->name) : std::string("This")) +
           " changes " + quoted(place.variable->name) +
           ", so it is not called to look at its value.";
  }

  std::set<const Function*> met_;
  std::string why_;
};

// The local variables of an expression, each once, including those that a function inside of it
// captures.
std::vector<Variable*> locals_of(const Expr& root) {
  std::vector<Variable*> found;
  const auto add = [&found](Variable* variable) {
    const bool is_new = std::ranges::find(found, variable) == found.end();
    if (variable->storage != Storage::kGlobal && is_new) found.push_back(variable);
  };
  any_part(root, [&](const Expr& each) {
    if (each.kind == ExprKind::kVariable) add(each.as<VariableExpr>().variable);
    if (each.kind == ExprKind::kClosure)
      for (const Capture& each_one : each.as<ClosureExpr>().function->captures) add(each_one.outer);
    return false;
  });
  return found;
}

// A global variable without a value that the expression uses, also in called functions; null if
// there is none.
const Variable* unset_global(const VmState& state, const Expr& root) {
  const Variable* unset = nullptr;
  any_part(root, [&](const Expr& each) {
    if (each.kind != ExprKind::kVariable) return false;
    const Variable* variable = each.as<VariableExpr>().variable;
    if (variable->storage == Storage::kGlobal && state.globals.is_set[variable->index] == 0)
      unset = variable;
    return unset != nullptr;
  });
  return unset;
}

std::string without_value(std::string_view name) {
  return name.empty() ? "A part of this is computed on the way, and is not kept."
                      : quoted(name) + " has no value here.";
}

// ---- computing --------------------------------------------------------------------------------

// A program with one function, fn(locals) => expression.
CheckedProgram make_probe(const CompiledProgram& program, Expr& expr,
                          const std::vector<Variable*>& locals) {
  CheckedProgram probe;
  probe.sources = program.sources;
  probe.types = program.types;
  probe.messages = program.messages;
  probe.what_takes_time = program.what_takes_time;
  probe.language = program.language;
  Arena& arena = *probe.arena;
  const auto make = [&](std::vector<Stmt*> body, std::uint32_t index) {
    auto* function = arena.make<Function>();
    function->name = "";
    function->span = expr.span;
    function->result = index == 0 ? probe.types->void_type() : expr.type;
    function->body = arena.make<Block>(Block{{StmtKind::kBlock, expr.span}, arena.copy(body)});
    function->index = index;
    return function;
  };
  Function* nothing = make({}, 0);
  Function* gives =
      make({arena.make<ReturnStmt>(ReturnStmt{{StmtKind::kReturn, expr.span}, &expr})}, 1);
  gives->parameters = arena.copy(locals);
  probe.module.main = nothing;
  probe.module.functions = arena.copy(std::vector<Function*>{nothing, gives});
  probe.module.unset = program.module.unset;
  probe.entry.is_one = program.entry.is_one;
  return probe;
}

// Creates the text objects of a program for its lifetime.
class Texts {
 public:
  Texts(VmState& state, const CompiledProgram& program) : state_(state) {
    for (const std::string& text : program.texts) {
      Obj* object = state.heap.new_text(text);
      if (object == nullptr) return;
      slots_.push_back(slot_of(object));
    }
    is_whole_ = true;
  }
  ~Texts() {
    for (const Slot slot : slots_) state_.heap.release(slot.o);
  }
  Texts(const Texts&) = delete;
  Texts& operator=(const Texts&) = delete;
  [[nodiscard]] const Slot* slots() const { return slots_.data(); }
  [[nodiscard]] bool is_whole() const { return is_whole_; }

 private:
  VmState& state_;
  std::vector<Slot> slots_;
  bool is_whole_ = false;
};

Result<SeenValue> compute(VmState& state, const Expr& expr, const CompiledProgram& probe,
                          std::span<const Slot> arguments) {
  const NoTrace no_trace(state);
  const auto error = std::exchange(state.host.error, std::nullopt);
  struct Finally {
    VmState& state;
    const std::optional<Diagnostic>& error;
    ~Finally() {
      state.heap.drain();  // objects of the expression refer to layouts of the probe
      state.host.error = error;
    }
  };
  const Finally at_the_end{state, error};
  const Texts texts(state, probe);
  if (!texts.is_whole()) return refusal("The program has no memory left.");
  Callee callee = callee_of(probe, probe.functions[1], texts.slots());
  callee.own = &callee;
  Slot result{.i = 0};
  if (!run_for_host(state, callee, arguments, result)) {
    const auto& failure = state.host.error;
    return refusal("This fails: " + (failure ? failure->message : std::string("without a reason")));
  }
  SeenValue seen{expr.span, type_name(expr.type), seen_text(result, *expr.type)};
  if (expr.type->is_reference()) state.heap.release(result.o);
  return seen;
}

Result<SeenValue> value_at(const Vm& vm, VmState& state, Span byte) {
  const Scene scene = scene_of(vm, state, byte);
  Expr* expr = scene.function == nullptr || scene.function->body == nullptr
                   ? nullptr
                   : Innermost(*scene.function, byte).found();
  if (expr == nullptr) return refusal("No expression of the program stands there.");
  if (expr->type->is(Kind::kVoid)) return refusal("What stands there gives no value.");
  if (std::string why = Changes().of(*expr); !why.empty()) return refusal(std::move(why));
  if (const Variable* variable = unset_global(state, *expr))
    return refusal(without_value(variable->name));
  const std::vector<Variable*> locals = locals_of(*expr);
  std::vector<Slot> arguments;
  for (const Variable* variable : locals) {
    Slot value{.o = nullptr};
    const auto is_it = [&](const ScopedVariable& each) {
      return each.variable == variable &&
             find_value(each, *scene.frame, span_of(*scene.frame), value);
    };
    const bool is_there =
        scene.frame && std::ranges::any_of(scene.frame->callee->function->scopes, is_it);
    if (!is_there || (variable->type->is_reference() && value.o == nullptr))
      return refusal(without_value(variable->name));
    arguments.push_back(value);
  }
  const CompiledProgram& program = scene.frame && scene.frame->callee->program != nullptr
                                       ? *scene.frame->callee->program
                                       : *state.programs.newest;
  const Lowered probe = lower(make_probe(program, *expr, locals), {.optimise = false});
  if (probe.too_large) return refusal("The expression is too large.");
  return compute(state, *expr, *probe.program, arguments);
}

}  // namespace
}  // namespace armlet::lang

namespace armlet {

Result<SeenValue> value_at(Vm& vm, std::uint32_t source, std::uint32_t byte) {
  lang::VmState& state = vm.state();
  const lang::Turn turn(state);
  lang::require_seen(state);
  std::optional<Result<SeenValue>> out;
  on_ample_stack([&] { out = lang::value_at(vm, state, {byte, byte, source}); });
  return *std::move(out);
}

}  // namespace armlet
