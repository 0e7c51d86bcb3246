// A host program: one function of its own, one script, and the robot library without the language.
#include <armlet/interpreter/define.hpp>
#include <armlet/interpreter/engine.hpp>
#include <armlet/kinematics/forward.hpp>
#include <armlet/model/catalog.hpp>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

double twice(double x) { return 2.0 * x; }

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
  const std::string printed = printed_by(engine, "print(twice(1.5))");
  const auto robot = armlet::make_robot("scara");
  const double reach = armlet::forward(*robot, Eigen::VectorXd::Zero(robot->n())).translation().x();
  std::printf("%s%.3f\n", printed.c_str(), reach);
  return printed == "3.0\n" && std::abs(reach - 0.7) < 1e-12 ? 0 : 1;
}
