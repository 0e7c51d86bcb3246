// A robot program with a listener of the host, which finds the largest height of the tool and
// prints the program's output. The listener handles each event and names the kinds that it ignores.
#include <algorithm>
#include <armlet/backend/backend.hpp>
#include <armlet/interpreter/render.hpp>
#include <armlet/stdlib/install.hpp>
#include <armlet/stdlib/session.hpp>
#include <cstdio>
#include <iostream>

namespace {

class Watcher : public armlet::Backend {
 public:
  void on(const armlet::Event& event) override {
    std::visit(armlet::Overload{[this](const armlet::JointSample& sample) { watch(sample); },
                                [](const armlet::Note& note) { std::cout << note.text; }, kIgnored},
               event);
  }
  [[nodiscard]] armlet::EventKinds ignores() const override { return kIgnored.kinds(); }

  double highest = -1.0;  // m
  int samples = 0;

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

}  // namespace

int main() {
  Watcher watcher;
  armlet::SessionOptions options;
  options.backends = {&watcher};
  armlet::Session session(armlet::library_engine(), options);
  const bool can_run = session.compile(R"(
    robot arm = robots.puma560()
    arm.moveJ(posJ([0, -30deg, -50deg, 0, -85deg, 0]), time: 2s)
    print("up")
  )",
                                       "lift.rbt");
  for (const armlet::Problem& problem : session.problems())
    std::cout << armlet::render_text(problem.diagnostic, *problem.sources);
  if (!can_run || session.run().status != armlet::Progress::kDone) return 1;
  std::printf("%d samples, %.3f m high\n", watcher.samples, watcher.highest);
}

// Prints:
// up
// 201 samples, 0.511 m high
