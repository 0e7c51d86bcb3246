// A host program: one function and one type of its own, a script for each, and the robot library
// without the language.
#include <armlet/interpreter/define_type.hpp>
#include <armlet/interpreter/engine.hpp>
#include <armlet/kinematics/forward.hpp>
#include <armlet/model/catalog.hpp>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace {

double twice(double x) { return 2.0 * x; }

struct Gripper {
  double width = 0.0;  // m
  [[nodiscard]] Gripper open(std::optional<double> by) const { return {width + by.value_or(0.01)}; }
  [[nodiscard]] bool operator==(const Gripper&) const = default;
};
Gripper make_gripper(double width) { return {width}; }

std::string printed_by(const armlet::Engine& engine, const char* text) {
  const armlet::Compilation compilation = engine.compile(text, "host.rbt");
  if (!compilation.program) return "rejected";
  std::string printed;
  armlet::Vm vm(compilation.program, {.output = [&](std::string_view part) { printed += part; }});
  return vm.run().status == armlet::RunStatus::kDone ? printed : "failed";
}

}  // namespace

int main() {
  armlet::Engine engine;
  engine.define(armlet::def("twice(x: double) -> double", &twice, "Two times x.", "twice(1.5)"));
  engine.define(armlet::type<Gripper>("Gripper", "A gripper with two fingers.")
                    .constructor("(width: length = 80mm)", &make_gripper, "A gripper.", "Gripper()")
                    .assignable("width: length", &Gripper::width, "Between the fingers.")
                    .method("open(by: length?) -> Gripper", &Gripper::open, "Opened wider."));
  const std::string printed = printed_by(engine, "print(twice(1.5))");
  const std::string widths = printed_by(engine,
                                        "var g = Gripper(50mm)\n"
                                        "g.width += 5mm\n"
                                        "print(g.width, g.open(by: 20mm) == Gripper(75mm))\n");
  const auto robot = armlet::make_robot("scara");
  const double reach = armlet::forward(*robot, Eigen::VectorXd::Zero(robot->n())).translation().x();
  std::printf("%s%s%.3f\n", printed.c_str(), widths.c_str(), reach);
  const bool is_right = printed == "3.0\n" && widths == "55 mm true\n";
  return is_right && std::abs(reach - 0.7) < 1e-12 ? 0 : 1;
}
