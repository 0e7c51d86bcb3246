#include "armlet/kinematics/closed_form.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "backwards.hpp"

namespace armlet {
namespace {

constexpr double kRight = std::numbers::pi / 2;
constexpr double kHalf = std::numbers::pi;

Eigen::VectorXd joints_within_a_turn(const Robot& robot, Random& random) {
  Eigen::VectorXd q(robot.n());
  for (int i = 0; i < robot.n(); ++i)
    q[i] = random.uniform(std::max(robot.lower()[i], -3.1), std::min(robot.upper()[i], 3.1));
  return q;
}

double distance(const Robot& robot, const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  double largest = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    const double change = a[i] - b[i];
    largest = std::max(largest,
                       std::abs(robot.is_revolute(i) ? std::remainder(change, 2 * kHalf) : change));
  }
  return largest;
}

// How often q itself is not among the solutions of forward(q), and the largest error of any
// solution.
struct RoundTrip {
  int missing = 0;
  double worst = 0.0;
};
RoundTrip round_trips(const Robot& robot, int count) {
  const ClosedForm& closed = closed_form(robot);
  const bool position_only = closed.kind() == ClosedFormKind::kShoulder;
  Random random(20);
  RoundTrip out;
  ClosedSolutions solutions;
  for (int k = 0; k < count; ++k) {
    const Eigen::VectorXd q = joints_within_a_turn(robot, random);
    const Eigen::Isometry3d T = forward(robot, q);
    closed.solve(T, q, solutions);
    const auto is_q = [&](const ClosedSolution& s) {
      return distance(robot, q, s.joints()) < 1e-6;
    };
    out.missing += std::ranges::none_of(solutions, is_q) ? 1 : 0;
    for (const ClosedSolution& s : solutions) {
      const Eigen::Isometry3d back = forward(robot, s.joints());
      out.worst = std::max(out.worst, (back.translation() - T.translation()).norm());
      if (!position_only)
        out.worst =
            std::max(out.worst, rotation_log(back.linear() * T.linear().transpose()).norm());
    }
  }
  return out;
}

Robot arm(std::vector<DhRow> rows, std::string_view kinds,
          DhConvention convention = DhConvention::kStandard) {
  RobotSpec spec;
  spec.convention = convention;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Joint joint;
    joint.dh = rows[i];
    joint.kind = kinds[i] == 'R' ? JointKind::kRevolute : JointKind::kPrismatic;
    if (kinds[i] == 'P') {
      joint.lower = 0.0;
      joint.upper = 0.5;
    }
    spec.joints.push_back(joint);
  }
  return Robot(spec);
}

void check_round_trips(const Robot& robot, ClosedFormKind kind, bool reversed, int count) {
  const ClosedForm& closed = closed_form(robot);
  CHECK(closed.kind() == kind);
  CHECK(closed.reversed() == reversed);
  const RoundTrip result = round_trips(robot, count);
  CHECK(result.missing == 0);
  CHECK(result.worst <= 1e-9);
}

}  // namespace

TEST_CASE("the arms of the catalogue are recognised, and every pose gives back its joints") {
  using enum ClosedFormKind;
  const std::pair<std::string_view, ClosedFormKind> arms[] = {{"planar3", kPlane},
                                                              {"rrr3", kShoulder},
                                                              {"scara", kScara},
                                                              {"scorbot", kPlanarArmTwist},
                                                              {"puma560", kSphericalParallel},
                                                              {"stanford", kSphericalMeeting},
                                                              {"pa10_6", kSphericalParallel},
                                                              {"kr6", kSphericalParallel},
                                                              {"pa10", kShoulderElbowWrist},
                                                              {"ur5", kThreeParallel}};
  for (const auto& [name, kind] : arms) {
    const auto& shown = name;  // clang 14 captures no binding
    CAPTURE(shown);
    check_round_trips(*make_robot(name), kind, false, 20'000);
  }
}

TEST_CASE("arms of seven joints without a spherical wrist are solved with an outer joint held") {
  const auto panda = make_robot("panda");
  CHECK(closed_form(*panda).held_joint() == 6);
  check_round_trips(*panda, ClosedFormKind::kSphericalMeeting, true, 20'000);
  const Robot rotated_half = backwards(*panda);
  CHECK(closed_form(rotated_half).held_joint() == 0);
  check_round_trips(rotated_half, ClosedFormKind::kSphericalMeeting, false, 5'000);
}

TEST_CASE("arms read backwards are recognised too") {
  check_round_trips(backwards(*make_robot("puma560")), ClosedFormKind::kSphericalParallel, true,
                    20'000);
  check_round_trips(backwards(*make_robot("ur5")), ClosedFormKind::kThreeParallel, true, 20'000);
}

TEST_CASE("structure counts, not right angles: skew arms with offsets are solved as well") {
  using enum ClosedFormKind;
  check_round_trips(arm({{0, 0.3, 0, 0.7},
                         {0.1, 0.2, 0.3, -1.1},
                         {0.2, 0.1, 0.4, 1.0},
                         {0.3, 0.35, 0, 0.9},
                         {0, 0, 0, -1.2},
                         {0, 0.126, 0.02, 0.3}},
                        "RRRRRR"),
                    kSphericalMeeting, false, 20'000);
  check_round_trips(arm({{0, 0.3, 0.1, 0.7},
                         {0.1, 0.2, 0.3, kHalf},
                         {0.2, 0.1, 0.4, 1.0},
                         {0.3, 0.35, 0, 0.9},
                         {0, 0, 0, -1.2},
                         {0, 0.126, 0.02, 0.3}},
                        "RRRRRR"),
                    kSphericalParallel, false, 20'000);
  check_round_trips(arm({{0, 0.34, 0, -kRight},
                         {0, 0, 0, kRight},
                         {0, 0.4, 0.05, kRight},
                         {0, 0, -0.05, -kRight},
                         {0, 0.4, 0, -kRight},
                         {0, 0, 0, kRight},
                         {0, 0.126, 0, 0}},
                        "RRRRRRR"),
                    kShoulderElbowWrist, false, 20'000);
}

TEST_CASE("a SCARA may have its sliding joint anywhere and axes that point up or down") {
  using enum ClosedFormKind;
  check_round_trips(
      arm({{0.3, 0, 0.1, 0}, {0, 0.2, 0.3, kHalf}, {0, 0.1, 0.25, 0}, {0, 0.1, 0.02, 0}}, "PRRR"),
      kScara, false, 20'000);
  check_round_trips(
      arm({{0.3, 0.1, 0.1, 0}, {0.4, 0, 0.3, kHalf}, {0, 0.1, 0.25, 0}, {0, 0.1, 0.02, 0}}, "RPRR"),
      kScara, false, 20'000);
  check_round_trips(
      arm({{0.3, 0.1, 0.3, 0}, {0.4, 0.1, 0.3, kHalf}, {0, 0.1, 0.25, 0}, {0.3, 0, 0.02, 0}},
          "RRRP"),
      kScara, false, 20'000);
}

TEST_CASE("arms without such a structure have no closed form") {
  const Robot skew = arm({{0, 0.3, 0.1, 0.7},
                          {0, 0.2, 0.3, -1.1},
                          {0, 0.1, 0.4, 1.0},
                          {0, 0.35, 0.1, 0.9},
                          {0, 0.1, 0.1, -1.2},
                          {0, 0.126, 0.02, 0.3}},
                         "RRRRRR");
  const ClosedForm& closed = closed_form(skew);
  CHECK_FALSE(closed.exists());
  ClosedSolutions solutions;
  CHECK(closed.solve(Eigen::Isometry3d::Identity(), skew.home(), solutions) == 0);
}

TEST_CASE("a wrist on a path into the singularity keeps its pose") {
  const auto puma = make_robot("puma560");
  const ClosedForm& closed = closed_form(*puma);
  ClosedSolutions solutions;
  for (double turn = 1.0; turn > 1e-17; turn *= 0.1) {
    Eigen::VectorXd q(6);
    q << 0.3, 0.4, -0.7, 1.1, turn, -0.6;
    const Eigen::Isometry3d T = forward(*puma, q);
    CAPTURE(turn);
    REQUIRE(closed.solve(T, q, solutions) >= 4);
    double nearest = 10.0;
    for (const ClosedSolution& s : solutions)
      nearest = std::min(nearest, distance(*puma, q, s.joints()));
    CHECK(nearest < 1e-6);
  }
}

TEST_CASE("a stretched arm is solved to all digits") {
  for (const std::string_view name : {"rrr3", "scara", "planar3"}) {
    const auto robot = make_robot(name);
    const ClosedForm& closed = closed_form(*robot);
    Eigen::VectorXd q = Eigen::VectorXd::Constant(robot->n(), 0.1);
    q[name == "rrr3" ? 2 : 1] = 0.0;
    ClosedSolutions solutions;
    CAPTURE(name);
    REQUIRE(closed.solve(forward(*robot, q), q, solutions) >= 1);
    CHECK(distance(*robot, q, solutions.at[0].joints()) < 1e-6);
  }
}

TEST_CASE("what is out of reach has no solution") {
  ClosedSolutions solutions;
  for (const std::string_view name :
       {"rrr3", "scara", "scorbot", "puma560", "pa10", "ur5", "panda"}) {
    const auto robot = make_robot(name);
    CAPTURE(name);
    Eigen::Isometry3d T = forward(*robot, robot->home());
    T.translation() += Eigen::Vector3d(5.0, 0.0, 0.1);
    CHECK(closed_form(*robot).solve(T, robot->home(), solutions) == 0);
  }
}

}  // namespace armlet
