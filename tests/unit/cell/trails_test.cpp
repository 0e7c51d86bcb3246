#include "armlet/cell/trails.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

// A backend that receives all events and does nothing.
class AnyListener : public Backend {
 public:
  void on(const Event&) override {}
};

void start(Cell& cell, int arm, const Eigen::VectorXd& to) {
  const PlannerSet planners;
  const CellRobot& robot = cell.robot(arm);
  cell.start(arm, *plan_joint_move(planners, *robot.model,
                                   {.q0 = robot.q, .q1 = to, .time = 1.5, .enforce_limits = false})
                       .trajectory);
}

void move(Cell& cell, int arm, const Eigen::VectorXd& to) {
  start(cell, arm, to);
  cell.advance_to(*cell.next_event());
}

struct Pieces {
  double length = 0.0;
  Vector3d first, last;
  int count = 0;
};

// The pieces one behind the other.
Pieces pieces_of(const Cell& cell) {
  Pieces out;
  for (int i = 0;; ++i) {
    const Drawing* each = cell.drawings().find("trail of arm " + std::to_string(i));
    if (each == nullptr) break;
    const Vector3d begin = each->T_on_drawing.translation();
    const Vector3d end = each->T_on_drawing * Vector3d(0.0, 0.0, each->size[0]);
    if (i == 0) out.first = begin;
    if (i > 0) CHECK((begin - out.last).norm() < 1e-9);
    out.last = end;
    out.length += each->size[0];
    ++out.count;
  }
  return out;
}

}  // namespace

TEST_CASE("a trail leads from where it began to where the tool point is, without gaps") {
  for (const bool heard : {false, true}) {
    CAPTURE(heard);
    Cell cell;
    AnyListener listener;
    if (heard) cell.set_backend(&listener);
    const int arm = cell.add_robot(make_robot("scara"), "arm");
    const Vector3d begin = cell.T_world_tool(arm).translation();
    move(cell, arm, Eigen::Vector4d(0.3, 0.2, 0.02, 0.0));
    CHECK(cell.drawings().size() == 0);
    const Vector3d from = cell.T_world_tool(arm).translation();
    CHECK((from - begin).norm() > 0.05);
    cell.trails().begin(cell, arm, "red", 0.004);
    move(cell, arm, Eigen::Vector4d(0.9, -0.4, 0.1, 0.5));
    const Pieces pieces = pieces_of(cell);
    REQUIRE(pieces.count > 10);
    CHECK((pieces.first - from).norm() < 1e-9);
    CHECK((pieces.last - cell.T_world_tool(arm).translation()).norm() < 1e-3);
    CHECK(pieces.length >= (cell.T_world_tool(arm).translation() - from).norm() - 1e-3);
    CHECK(pieces.count == static_cast<int>(cell.drawings().size()));
    const Drawing* piece = cell.drawings().find("trail of arm 3");
    CHECK(piece->color == "red");
    CHECK(piece->size[1] == 0.004);
  }
}

TEST_CASE("a trail is the same whether somebody listens or not, and in however many steps") {
  const auto drawn = [](bool heard, std::int64_t step) {
    Cell cell;
    AnyListener listener;
    if (heard) cell.set_backend(&listener);
    const int arm = cell.add_robot(make_robot("scara"), "arm");
    cell.trails().begin(cell, arm, "red", 0.004);
    start(cell, arm, Eigen::Vector4d(0.9, -0.4, 0.1, 0.5));
    for (std::int64_t t = step; cell.is_moving(arm); t += step) cell.advance_to(t);
    return pieces_of(cell).length;
  };
  const double wanted = drawn(false, 60 * kSecond);
  CHECK(drawn(true, 60 * kSecond) == wanted);
  CHECK(drawn(false, 7'000'000) == wanted);
  CHECK(drawn(true, 130'000'000) == wanted);
}

TEST_CASE("bounds of trails") {
  Cell cell;
  const int arm = cell.add_robot(make_robot("scara"), "arm");
  for (const double width : {0.0, -0.1, 1.5, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS(cell.trails().begin(cell, arm, "red", width), ArgumentError);
  CHECK_THROWS_AS(cell.trails().begin(cell, 3, "red", 0.004), ArgumentError);
  CHECK(cell.trails().empty());
}
