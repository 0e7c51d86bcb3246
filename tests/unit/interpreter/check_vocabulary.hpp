#pragma once
// A small made-up vocabulary, and programs checked against it: for the tests of the checker.

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "armlet/interpreter/render.hpp"
#include "armlet/interpreter/resource.hpp"
#include "check/check.hpp"
#include "syntax/parse.hpp"
#include "vm/host/language_functions.hpp"

namespace armlet::lang {

struct RobotFact : Fact {
  int joints = 0;
};

inline void check_ready_robot(CheckCall& call) {
  auto fact = std::make_shared<RobotFact>();
  fact->joints = 2;
  call.set_result_fact(std::move(fact));
}

inline constexpr CatalogEntry kJointCount{
    .code = "E0302", .kind = {}, .headline = "{} for a robot with {}", .page = {}};

// Every joint of the robot gets one value.
inline void check_move(CheckCall& call) {
  const auto fact = std::static_pointer_cast<const RobotFact>(
      call.given(at("r")) ? call.fact(at("r")) : call.ambient_fact("robot"));
  if (fact == nullptr) return;
  int values = 0;
  while (!call.origin(at("target"), values).empty()) ++values;
  if (values == 0 || values == fact->joints) return;
  call.report(make_diagnostic(
      kJointCount, call.span(at("target")),
      {std::to_string(values) + " joint values", std::to_string(fact->joints) + " joints"}));
}

inline bool same_value(const void*, const void*) { return true; }
inline void as_text(const void*, std::string& out) { out += "value"; }

inline const HostType kPosJ = {.name = "posJ",
                               .size = 8,
                               .equal = same_value,
                               .text = as_text,
                               .noun = "a position",
                               .use = "moves to a posJ, an object made from the numbers"};
inline const HostType kPosC = {.name = "posC", .size = 8, .text = as_text};
inline constexpr ResourceWords kRobotWords = {.plural = "robots",
                                              .act = "move",
                                              .acts = "the moves",
                                              .act_on_one = "move the robot",
                                              .busy = "is already moving"};
inline const HostType kRobot = {
    .name = "robot", .size = 8, .is_handle = true, .is_ambient = true, .resource = &kRobotWords};
inline const HostType kRow = {.name = "jointRow", .size = 8};

inline const NativeFunction kWords[] = {
    {.name = "sin", .signature = "(x: angle) -> double"},
    {.name = "sin", .signature = "(x: double) -> double"},
    {.name = "sqrt", .signature = "(x: D^2) -> D"},
    {.name = "pow", .signature = "(x: double, y: double) -> double"},
    {.name = "abs", .signature = "(x: int) -> int"},
    {.name = "abs", .signature = "(x: D) -> D"},
    {.name = "min", .signature = "(a: int, b: int) -> int"},
    {.name = "min", .signature = "(a: D, b: D) -> D"},
    {.name = "min", .signature = "(xs: D[]) -> D"},
    {.name = "sum", .signature = "(xs: int[]) -> int"},
    {.name = "sum", .signature = "(xs: D[]) -> D"},
    {.name = "trapz", .signature = "(y: D[], x: E[]) -> D*E"},
    {.name = "random", .signature = "() -> double"},
    {.name = "now", .signature = "() -> time"},
    {.name = "map", .signature = "(xs: T[], f: fn(T) -> U) -> U[]"},
    {.name = "solve", .signature = "(f: fn(double) -> double, lo: double, hi: double) -> double"},
    {.name = "reverse", .signature = "(xs: T[]) -> T[]"},
    {.name = "range", .signature = "(n: int) -> int[]"},
    {.name = "operator+", .signature = "(a: D[], b: D[]) -> D[]"},
    {.name = "operator*", .signature = "(k: D, a: E[]) -> D*E[]"},
    {.name = "operator.*", .signature = "(a: D[], b: E[]) -> D*E[]"},
    {.name = "operator*", .signature = "(a: posC, b: posC) -> posC"},
    {.name = "posJ", .signature = "(values: double[]) -> posJ"},
    {.name = "posJ", .signature = "(values: number...) -> posJ"},
    {.name = "posJ[]", .signature = "(p: posJ, i: int) -> double"},
    {.name = "xyz", .signature = "(x: length = 0mm, y: length = 0mm, z: length = 0mm) -> posC"},
    {.name = "posC.z", .signature = "(p: posC) -> length"},
    {.name = "near", .signature = "(a: D, b: D, tol: D) -> bool"},
    {.name = "robots.two", .signature = "() -> robot", .check = check_ready_robot},
    {.name = "robot()", .signature = "() -> robot", .check = check_ready_robot},
    {.name = "robot{}", .signature = "(name: string, joint: jointRow[], base: posC?) -> robot"},
    {.name = "robot.joint.revolute", .signature = "(a: length = 0m, limits: angle[]?) -> jointRow"},
    {.name = "moveJ",
     .signature = "(r: robot, target: posJ, time: time?, speed: double?) -> Move",
     .check = check_move,
     .pauses = true},
    {.name = "moveJ",
     .signature = "(r: robot, traj: string, target: posJ, time: double) -> Move",
     .pauses = true},
    {.name = "moveL",
     .signature = "(r: robot, target: posC, time: time?, speed: speed?) -> Move",
     .pauses = true},
    {.name = "joints", .signature = "(r: robot) -> posJ"},
    {.name = "force", .signature = "(r: robot) -> force"},
};
inline const NativeConstant kNumbers[] = {{.name = "PI", .value = 3.141592653589793}};

struct Checked {
  std::shared_ptr<SourceSet> sources = std::make_shared<SourceSet>();
  CheckedProgram program;
  std::vector<Diagnostic> messages;
  bool ok = false;

  // The codes in the order of the text: "E0201 W0709".
  [[nodiscard]] std::string codes() const {
    std::string out;
    for (const Diagnostic& message : messages) out += (out.empty() ? "" : " ") + message.code;
    return out;
  }
  [[nodiscard]] std::string text() const {
    std::string out;
    for (const Diagnostic& message : messages) out += render_text(message, *sources);
    return out;
  }
  [[nodiscard]] const hir::Function* function(std::string_view name) const {
    for (const hir::Function* function : program.module.functions) {
      if (function->name == name) return function;
    }
    return nullptr;
  }
  // The variable that statement `index` of the program declares.
  [[nodiscard]] const hir::Variable& variable(std::size_t index) const {
    return *program.module.main->body->body[index]->as<hir::InitStmt>().variable;
  }
};

inline std::unique_ptr<Checked> check_text(const std::string& text,
                                           const std::string& name = "cell.rbt") {
  static const auto registry = [] {
    auto made = std::make_unique<Registry>(kLanguageFunctions);
    made->add_functions(kWords);
    for (const NativeConstant& number : kNumbers) made->add_constant(number);
    for (const HostType* type : {&kPosJ, &kPosC, &kRobot, &kRow}) made->add_type(*type);
    made->add_record("Move", "reached: bool, stopped: bool, time: time");
    return made;
  }();
  auto out = std::make_unique<Checked>();
  out->program.sources = out->sources;
  const Source& source = out->sources->add(name, text);
  Arena tree;
  DiagnosticSink sink;
  const Parsed parsed = parse(source, tree, sink);
  FileTree file{.program = {}, .ok = parsed.ok};
  file.program.span = {0, static_cast<std::uint32_t>(text.size()), 0};
  file.program.body = tree.copy(parsed.statements);
  out->ok = check_program({&file, 1}, out->program, *registry, {.open = false}, sink) && parsed.ok;
  out->messages = sink.take_sorted();
  return out;
}

// The type of `let x = <expression>`, or the codes of its messages.
inline std::string type_of(const std::string& expression, const std::string& before = "") {
  const auto checked = check_text(before + "\nlet probe = " + expression + "\n");
  if (!checked->ok) return checked->codes();
  const auto& body = checked->program.module.main->body->body;
  return type_name(body[body.size() - 1]->as<hir::InitStmt>().variable->type);
}

}  // namespace armlet::lang
