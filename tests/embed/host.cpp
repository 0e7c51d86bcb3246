// A host program: one function and one type of its own, a script for each, and the robot library
// without the language, with a listener of its own.
#include <algorithm>
#include <armlet/backend/bounded_queue.hpp>
#include <armlet/cell/cell.hpp>
#include <armlet/interpreter/define_type.hpp>
#include <armlet/interpreter/engine.hpp>
#include <armlet/kinematics/forward.hpp>
#include <armlet/model/catalog.hpp>
#include <armlet/trajectory/joint_move.hpp>
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

// How high the tool point gets, and what is said.
class Watcher : public armlet::Backend {
 public:
  void on(const armlet::Event& event) override {
    std::visit(armlet::Overload{[this](const armlet::JointSample& sample) { watch(sample); },
                                [this](const armlet::Note& note) { said += note.text; }, kIgnored},
               event);
  }
  [[nodiscard]] armlet::EventKinds ignores() const override { return kIgnored.kinds(); }

  double highest = -1.0;  // m
  int samples = 0;
  std::string said;

 private:
  static constexpr armlet::Ignore<armlet::BeginRun, armlet::RobotAdded, armlet::RobotChanged,
                                  armlet::ObjectAdded, armlet::ObjectSample, armlet::ObjectEvent,
                                  armlet::FigureChanged, armlet::FinalFigure, armlet::Undone,
                                  armlet::EndRun, armlet::DrawingChanged, armlet::CameraAdded,
                                  armlet::ImageFrame>
      kIgnored{};

  void watch(const armlet::JointSample& sample) {
    highest = std::max(highest, sample.T_world_tool.translation().z());
    ++samples;
  }
};

// Moves a robot for two seconds while a watcher looks on that takes what there is once a second.
bool is_watched() {
  Watcher watcher;
  armlet::BoundedQueue queue(watcher, 64);
  armlet::Cell cell;
  cell.set_backend(&queue);
  cell.add_robot(armlet::make_robot("puma560"));
  cell.note(armlet::NoteKind::kOutput, "up");
  const armlet::CellRobot& arm = cell.robot(0);
  const armlet::JointMove move{.q0 = arm.q, .q1 = arm.q.array() + 0.2, .time = 2.0};
  cell.start(0, *armlet::plan_joint_move({}, *arm.model, move).trajectory);
  for (const double second : {1.0, 2.0}) {
    cell.advance_to(armlet::to_ns(second));
    queue.deliver();
  }
  cell.end();
  queue.deliver();
  const auto told = watcher.samples + static_cast<int>(queue.thinned().joint_samples);
  return watcher.said == "up" && watcher.samples >= 64 && told == 201;
}

std::string printed_by(const armlet::Engine& engine, const char* text) {
  const armlet::Compilation compilation = engine.compile(text, "host.rbt");
  if (!compilation.program) return "rejected";
  std::string printed;
  armlet::Vm vm(compilation.program, {.output = [&](std::string_view part) { printed += part; }});
  return vm.run().status == armlet::Progress::kDone ? printed : "failed";
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
  return is_right && std::abs(reach - 0.7) < 1e-12 && is_watched() ? 0 : 1;
}
