// What a cell sends to its backend.
#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/backend/fan_out.hpp"
#include "armlet/backend/trace_format.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

struct Heard {
  EventKind kind{};
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
};

class Listener : public Backend {
 public:
  void on(const Event& event) override {
    heard.push_back({kind_of(event), time_of(event), number_of(event)});
  }
  std::vector<Heard> heard;
};

// Keeps the last description of a robot, and of samples the motions and the frames of the links.
class Drawer : public Backend {
 public:
  explicit Drawer(bool wants) : wants_(wants) {}
  void on(const Event& event) override {
    std::visit(Overload{[this](const BeginRun& each) { robots = each.run.robots; },
                        [this](const RobotAdded& each) { robots.push_back(each.robot); },
                        [this](const RobotChanged& each) {
                          robots[static_cast<std::size_t>(each.index)] = each.robot;
                        },
                        [this](const JointSample& each) { draw(each); }, [](const auto&) {}},
               event);
  }
  [[nodiscard]] bool wants_link_poses() const override { return wants_; }

  std::vector<RobotInfo> robots;
  std::vector<int> motions;
  std::size_t frames = 0;
  double error = 0.0;  // the largest difference of a frame in a sample to that of the description

 private:
  void draw(const JointSample& sample);

  bool wants_;
};

// The frames of the links by the description alone, in the world; behind them the tool point.
std::vector<Eigen::Isometry3d> frames_of(const RobotInfo& robot, std::span<const double> q) {
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d T = robot.T_world_base;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const JointInfo& joint = robot.joints[i];
    T = T * joint.T_before_joint;
    if (joint.unit == JointUnit::kRadian) {
      T.rotate(Eigen::AngleAxisd(q[i], Eigen::Vector3d::UnitZ()));
    } else {
      T.translate(q[i] * Eigen::Vector3d::UnitZ());
    }
    T = T * joint.T_joint_link;
    frames.push_back(T);
  }
  frames.push_back(T * robot.tool.T_flange_tool);
  return frames;
}

double difference(const Eigen::Isometry3d& one, const Eigen::Isometry3d& other) {
  return (one.matrix() - other.matrix()).cwiseAbs().maxCoeff();
}

void Drawer::draw(const JointSample& sample) {
  motions.push_back(sample.motion);
  frames += sample.T_world_links.size();
  const auto expected = frames_of(robots.at(static_cast<std::size_t>(sample.robot)), sample.q);
  for (std::size_t i = 0; i < sample.T_world_links.size(); ++i)
    error = std::max(error, difference(sample.T_world_links[i], expected[i]));
  error = std::max(error, difference(sample.T_world_tool, expected.back()));
}

// Two moves of one arm after another, for a backend.
void run_two_moves(Backend& backend) {
  Cell cell;
  cell.set_backend(&backend);
  cell.add_robot(make_robot("puma560"));
  const PlannerSet planners;
  for (const double step : {0.3, -0.2}) {
    const CellRobot& arm = cell.robot(0);
    const Eigen::VectorXd q = arm.q.array() + step;
    const JointMove move{.q0 = arm.q, .q1 = q, .time = 1.0, .enforce_limits = false};
    cell.start(0, *plan_joint_move(planners, *arm.model, move).trajectory);
    cell.advance_to(cell.now_ns() + 1'500'000'000);
  }
  cell.end();
}

}  // namespace

TEST_CASE("events are numbered from 0 in the order in which they are sent") {
  Cell cell;
  Listener listener;
  cell.set_backend(&listener);
  cell.add_robot(make_robot("scara"));
  cell.note(NoteKind::kOutput, "before the run begins");
  cell.insert({.name = "cube", .shape = Box{{0.04, 0.04, 0.04}}, .mass = 0.2});
  cell.advance_to(5'000'000);
  cell.add_robot(make_robot("puma560"));
  cell.insert({.name = "ball", .shape = Sphere{0.02}, .mass = 0.1});
  cell.take(0, "ball");
  cell.let_go(0);
  cell.remove("cube");
  cell.figure(Figure{.title = "speed"});
  cell.end();
  REQUIRE(listener.heard.size() > 10);
  CHECK(listener.heard.front().kind == EventKind::kBeginRun);
  CHECK(listener.heard.back().kind == EventKind::kEndRun);
  for (std::size_t i = 0; i < listener.heard.size(); ++i) {
    CAPTURE(i);
    CHECK(listener.heard[i].number == i);
    CHECK((i == 0 || listener.heard[i].t_ns >= listener.heard[i - 1].t_ns));
  }
}

TEST_CASE("the description of an arm gives the frames of its links") {
  Random random(7);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const auto base = Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3) *
                                        Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
    const auto robot = std::make_shared<const Robot>(make_robot(name)->with_base(base));
    Cell cell;
    Drawer drawing(false);
    cell.set_backend(&drawing);
    cell.add_robot(robot);
    cell.begin();
    const RobotInfo& info = drawing.robots.at(0);
    REQUIRE(static_cast<int>(info.joints.size()) == robot->n());
    for (int k = 0; k < 20; ++k) {
      Eigen::VectorXd q(robot->n());
      for (int i = 0; i < robot->n(); ++i) q[i] = random.uniform(-3, 3);
      const auto frames = frames_of(info, {q.data(), static_cast<std::size_t>(q.size())});
      // Rounding: some ten products of matrices with numbers below 10.
      for (int i = 0; i < robot->n(); ++i)
        CHECK(difference(frames[static_cast<std::size_t>(i)], link_frame(*robot, q, i + 1)) <
              1e-12);
      CHECK(difference(frames.back(), forward(*robot, q)) < 1e-12);
    }
    for (int i = 0; i < robot->n(); ++i) {
      CHECK(info.joints[static_cast<std::size_t>(i)].lower == robot->lower()[i]);
      CHECK(info.joints[static_cast<std::size_t>(i)].upper == robot->upper()[i]);
      CHECK(info.joints[static_cast<std::size_t>(i)].max_speed == robot->max_speed()[i]);
      CHECK(info.home[static_cast<std::size_t>(i)] == robot->home()[i]);
    }
  }
}

TEST_CASE("another tool during the run is reported, with the tool point") {
  Cell cell;
  Drawer drawing(false);
  cell.set_backend(&drawing);
  cell.add_robot(make_robot("puma560"));
  cell.set_model(
      0, std::make_shared<const Robot>(make_robot("puma560")->with_tool(suction_cup(0.01, 0.05))));
  cell.begin();
  CHECK(drawing.robots.at(0).tool.kind == "suction cup");
  cell.set_model(0, std::make_shared<const Robot>(
                        make_robot("puma560")->with_tool(parallel_gripper(0.1, 0.125))));
  CHECK(drawing.robots[0].tool.kind == "gripper");
  CHECK(drawing.robots[0].tool.stroke == 0.1);
  CHECK(drawing.robots[0].tool.T_flange_tool.translation().z() == 0.125);
}

TEST_CASE("samples carry the frames of the links for a backend that wants them, and only then") {
  Drawer with(true), without(false);
  run_two_moves(with);
  run_two_moves(without);
  CHECK(with.motions.size() > 200);
  CHECK(with.frames == 6 * with.motions.size());
  CHECK(with.error < 1e-12);
  CHECK(without.frames == 0);
}

TEST_CASE("what one backend wants changes no trace of another") {
  for (const TraceFormat& format : trace_formats()) {
    std::ostringstream alone, beside;
    const auto one = format.make(alone), other = format.make(beside);
    run_two_moves(*one);
    Drawer drawing(true);
    FanOut both({&drawing, other.get()});
    run_two_moves(both);
    CHECK(alone.str() == beside.str());
  }
}

TEST_CASE("figures that change before the run are sent when it begins, the last state of each") {
  class Figures : public Backend {
   public:
    explicit Figures(EventKinds ignored) : ignored_(ignored) {}
    void on(const Event& event) override {
      last = number_of(event);
      if (const auto* changed = std::get_if<FigureChanged>(&event))
        told.push_back(changed->figure->title + std::to_string(changed->index));
    }
    [[nodiscard]] EventKinds ignores() const override { return ignored_; }
    std::vector<std::string> told;
    std::uint64_t last = 0;

   private:
    EventKinds ignored_;
  };
  Figures listener({}), ignoring(EventKinds::of<FigureChanged>());
  for (Figures* each : {&listener, &ignoring}) {
    Cell cell;
    cell.set_backend(each);
    cell.figure_changed({.title = "a"});
    cell.figure_changed({.title = "b", .index = 1});
    cell.figure_changed({.title = "c"});
    CHECK(each->told.empty());
    cell.begin();
    cell.figure_changed({.title = "d", .index = 1});
    cell.end();
  }
  CHECK(listener.told == std::vector<std::string>{"c0", "b1", "d1"});
  CHECK(listener.last == ignoring.last);
}

TEST_CASE("samples say which motion they belong to") {
  Drawer drawing(false);
  run_two_moves(drawing);
  // Standing before the first; the second begins half a second after the end of the first.
  CHECK(drawing.motions.front() == -1);
  CHECK(std::ranges::is_sorted(drawing.motions));
  CHECK(std::ranges::count(drawing.motions, 0) == 100);
  CHECK(std::ranges::count(drawing.motions, 1) == 101);
}
