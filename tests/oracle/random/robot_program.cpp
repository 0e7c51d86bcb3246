#include "random/robot_program.hpp"

#include <fmt/format.h>

namespace armlet::oracle {

std::string RobotProgram::text() {
  out_ = R"(robot left = robots.scara(base: xyz(y: -600mm))
robot right = robots.scara(base: xyz(y: 600mm))
object cube { shape: box(40mm, 40mm, 40mm); at: xyz(350mm, -450mm, 20mm); mass: 200g }
object brick { shape: box(30mm, 30mm, 50mm); at: xyz(350mm, 650mm, 25mm); mass: 300g }
struct Visit { who: string = "nobody"; at: time = 0s; joints: angle[] = [] }
var n = 0
var seen: int[string] = ["left": 0]
var visits: Visit[] = []
fn note(who: string, first: angle) {
  if (seen.has(who)) { seen[who] += 1 } else { seen[who] = 1 }
  visits.push(Visit(who: who, at: now(), joints: [first]))
  print(who, seen[who], now(), first)
}
fn hop(r: robot, times: int, by: angle) -> int {
  let again = fn(k: int) => k * times
  if (times == 0) { return 0 }
  r.moveJ(r.home() + [by * times / 1rad, 0, 0, 0], time: 1500ms)
  return again(1) + hop(r, times - 1, by: by)
}
)";
  statements_left_ = 5 + below(10);
  if (one_in(3)) line(fmt::format("seed({})", below(1000)));
  if (one_in(4)) {
    line("record run every (" + between(5, 40, "ms") + ") { q: left.joints().q; count: n }");
  }
  while (statements_left_ > 0) statement(Arms::kBoth);
  line("print(n, seen, visits.length, now(), left.joints(), right.joints())");
  return out_;
}

std::string RobotProgram::arm_of(Arms arms) {
  if (arms == Arms::kBoth) return one_in(2) ? "left" : "right";
  return arms == Arms::kLeft ? "left" : "right";
}

std::string RobotProgram::between(double low, double high, const char* unit) {
  const double part = static_cast<double>(below(1000)) / 999.0;
  return fmt::format("{:.4g}{}", low + (high - low) * part, unit);
}

std::string RobotProgram::goal(const std::string& arm) {
  return fmt::format("{}.home() + [{}, {}, {}, {}]", arm, between(-1.5, 1.5, ""),
                     between(-1.5, 0.8, ""), between(0.0, 0.12, ""), between(-2.0, 2.0, ""));
}

void RobotProgram::block(Arms arms, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) statement(arms);
}

void RobotProgram::statement(Arms arms) {
  if (statements_left_ > 0) --statements_left_;
  const bool may_nest = depth_ < 4 && statements_left_ > 0;
  switch (below(arms == Arms::kNone ? 4 : 12)) {
    case 0:
      return line("wait(" + (one_in(5) ? "0s" : between(0.3, 300, "ms")) + ")");
    case 1:
      return compute();
    case 2:
      return may_nest ? attempt(arms) : compute();
    case 3:
      if (!may_nest) return compute();
      open(one_in(2) ? fmt::format("for (k{} in range(3))", ++names_) : "if (n % 2 == 0)");
      block(arms, 1 + below(2));
      return close();
    case 4:
      return may_nest ? branches(arms) : act(arm_of(arms));
    case 5:
      if (!may_nest) return act(arm_of(arms));
      open("");
      watch();
      block(arms, 1 + below(2));
      return close();
    case 6: {
      if (!may_nest) return act(arm_of(arms));
      const std::string arm = arm_of(arms);
      open(fmt::format("with (robot: {}, speed: {})", arm, between(0.2, 1.0, "")));
      line(fmt::format("moveJ({})", goal(arm)));
      block(arm == "left" ? Arms::kLeft : Arms::kRight, 1);
      return close();
    }
    default:
      return act(arm_of(arms));
  }
}

// A command to one arm.
void RobotProgram::act(const std::string& arm) {
  switch (below(8)) {
    case 0:
      return line(fmt::format("{}.moveJ({}, time: {}) until {}.joints()[0] > {}", arm, goal(arm),
                              between(1.5, 3.0, "s"), arm, between(-0.5, 0.5, "")));
    case 1:
      return line(
          fmt::format("try {{ {}.moveL({}.here() * xyz({}, {}, {}), speed: {}) }} catch (e) {{ "
                      "print(e.kind) }}",
                      arm, arm, between(-60, 60, "mm"), between(-60, 60, "mm"),
                      between(-30, 30, "mm"), between(50, 300, "mm/s")));
    case 2:
      return line(fmt::format("{}.speedJ([{}, {}, 0.0, {}], during: {})", arm,
                              between(-0.6, 0.6, ""), between(-0.6, 0.6, ""),
                              between(-0.6, 0.6, ""), between(20, 700, "ms")));
    case 3: {
      const char* thing = arm == "left" ? "cube" : "brick";
      open("try");
      line(fmt::format("{}.moveJ(above(poseOf({}), {}))", arm, thing, between(40, 90, "mm")));
      line(fmt::format("{}.moveL(poseOf({}), speed: 150mm/s)", arm, thing));
      line(fmt::format("{}.grasp({})", arm, thing));
      line(fmt::format("{}.moveJ({})", arm, goal(arm)));
      if (one_in(2)) line(fmt::format("{}.release()", arm));
      return close(fmt::format(" catch (e) {{ print(e.kind, {}.holding({})) }}", arm, thing));
    }
    case 4:
      return line(
          fmt::format("n += hop({}, {}, by: {})", arm, 1 + below(3), between(-20, 20, "deg")));
    case 5:
      return line(fmt::format("note(\"{}\", {}.joints()[0] * 1rad)", arm, arm));
    case 6: {
      open("try");
      open(fmt::format("with (robot: {})", arm));
      open("path (blend: 10mm)");
      for (int i = 0; i < 3; ++i) {
        line(fmt::format("moveL({}.here() * xyz({}, {}, 0mm), speed: 120mm/s)", arm,
                         between(-50, 50, "mm"), between(-50, 50, "mm")));
      }
      close();
      close();
      return close(" catch (e) { print(e.kind, now()) }");
    }
    default:
      return line(fmt::format("{}.moveJ({})", arm, goal(arm)));
  }
}

void RobotProgram::compute() {
  switch (below(6)) {
    case 0:
      return line("n += 1");
    case 1:
      return line("print(n, now(), random() < 0.5, seen)");
    case 2:
      return line(fmt::format("setSignal(\"gate\", {})", one_in(2) ? "true" : "!signal(\"gate\")"));
    case 3:
      return line(fmt::format("for (k{0} in range(40)) {{ n += k{0} % 3 }}", ++names_));
    case 4:
      return line("if (visits.length > 0) { visits[visits.length - 1].who += \"!\" }");
    default:
      return line("note(\"nobody\", (left.joints()[1] - right.joints()[0]) * 1rad)");
  }
}

void RobotProgram::branches(Arms arms) {
  open("parallel");
  for (const Arms each : {Arms::kLeft, Arms::kRight, Arms::kNone}) {
    if (each != Arms::kNone && arms != Arms::kBoth && arms != each) continue;
    open("");
    block(each, 1 + below(2));
    close();
  }
  if (one_in(4)) line("{ wait(" + between(50, 900, "ms") + "); " + arm_of(arms) + ".halt() }");
  close();
}

void RobotProgram::watch() {
  if (one_in(2)) {
    open("every (" + between(3, 200, "ms") + ")");
  } else {
    open(fmt::format("when ({}.joints()[{}] > {})", one_in(2) ? "left" : "right", below(2),
                     between(-0.4, 0.6, "")));
  }
  compute();
  if (one_in(6)) line(fmt::format("if (n % 7 == 3) {{ throw error(\"enough {}\") }}", ++names_));
  close();
}

void RobotProgram::attempt(Arms arms) {
  open("try");
  block(arms, 1 + below(2));
  if (one_in(2))
    line(fmt::format("if (n % 3 == 0) {{ throw error(\"stop {}\", kind: \"mine\") }}", ++names_));
  close(" catch (e) { print(e.kind, e.message, e.time) } finally { n += 2 }");
}

}  // namespace armlet::oracle
