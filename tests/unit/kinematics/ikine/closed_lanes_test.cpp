#include "kinematics/closed_form/closed_lanes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "armlet/math/angles.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/model/catalog.hpp"
#include "kinematics/closed_form/closed_form_families.hpp"
#include "math/det_atan2_lanes.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

// One arm of each family that has a kernel, with right angles and with others.
Robot six_joints(const std::vector<DhRow>& rows) {
  RobotSpec spec;
  for (const DhRow& row : rows) {
    Joint joint;
    joint.dh = row;
    spec.joints.push_back(joint);
  }
  spec.T_world_base = pose_from_rpy({0.1, -0.2, 0.3}, {0.4, -0.5, 0.6});
  spec.T_flange_tool = pose_from_rpy({0.05, 0.02, 0.1}, {0.7, 0.2, -0.3});
  return Robot(spec);
}

std::vector<Robot> arms() {
  constexpr double kRight = 1.5707963267948966;
  return {*make_robot("puma560"),
          *make_robot("ur5"),
          *make_robot("pa10_6"),
          six_joints({{0, 0.3, 0, -kRight},
                      {0.1, 0, 0.3, kRight},
                      {0.2, 0.1, -0.1, -kRight},
                      {0, 0.4, 0, kRight},
                      {-3.0, 0, 0, -kRight},
                      {0, 0.1, 0, 0}}),
          six_joints({{0, 0.3, 0, 0.7},
                      {0.1, 0.2, 0.3, -1.1},
                      {0.2, 0.1, 0.4, 1.0},
                      {0.3, 0.35, 0, 0.9},
                      {0, 0, 0, -1.2},
                      {0, 0.126, 0.02, 0.3}}),
          six_joints({{0, 0.3, 0.1, 0.7},
                      {0.1, 0.2, -0.3, 2.0 * kRight},
                      {0.2, 0.1, 0.4, 1.0},
                      {0.3, 0.35, 0, 0.9},
                      {0, 0, 0, -1.2},
                      {0, 0.126, 0.02, 0.3}}),
          six_joints({{0, 0.3, 0.1, 1.2},
                      {0, 0, 0.4, 0},
                      {0.2, 0.1, 0.35, 2.0 * kRight},
                      {0.3, 0.1, 0.05, -1.2},
                      {0, 0.1, 0, 1.4},
                      {0, 0.126, 0.02, 0.3}})};
}

// Poses that the arm takes, and poses next to them that it may not reach.
Eigen::Isometry3d goal_of(const Robot& robot, Random& random) {
  Eigen::VectorXd q(6);
  for (double& value : q) value = random.uniform(-3.1, 3.1);
  Eigen::Isometry3d T = forward(robot, q);
  if (random.below(3) == 0) T.translation() *= random.uniform(0.5, 2.0);
  return T;
}

}  // namespace

TEST_CASE("closed forms in lanes have the same bits on every instruction set of this machine") {
  for (const Robot& robot : arms()) {
    const CanonicalRows rows = canonical_rows(robot.chain(), false);
    const auto form = LaneForm::make(closed_form(robot).kind(), rows, robot.chain());
    REQUIRE(form != nullptr);
    Random random(3);
    int different = 0;
    for (int k = 0; k < 500; ++k) {
      const Eigen::Isometry3d goal = goal_of(robot, random);
      ClosedLanes small{}, large{};
      const bool small_ok = form->solve(goal, small, *kBaselineClosed);
      for (const InstructionSet set : {InstructionSet::kAvx2, InstructionSet::kAvx512}) {
        if (!is_supported(set)) continue;
        if (form->solve(goal, large, *closed_kernel_for(set)) != small_ok) ++different;
        for (std::size_t way = 0; way < kSolutions && small_ok; ++way) {
          const double a = small.miss2[way], b = large.miss2[way];
          bool same = same_bits(a, b) || (std::isnan(a) && std::isnan(b));
          for (std::size_t i = 0; i < kSixJoints && !std::isnan(a); ++i)
            same = same && same_bits(small.q[i][way], large.q[i][way]);
          different += same ? 0 : 1;
        }
      }
    }
    CHECK(different == 0);
  }
}

TEST_CASE("the lanes find the solutions that the functions with branches find, and no others") {
  for (const Robot& arm : arms()) {
    const ClosedForm& closed = closed_form(arm);
    const CanonicalRows rows = canonical_rows(arm.chain(), false);
    const auto form = LaneForm::make(closed.kind(), rows, arm.chain());
    const auto family = closed.kind() == ClosedFormKind::kThreeParallel ? solve_three_parallel
                                                                        : solve_spherical_wrist;
    Random random(4);
    int asked = 0, missing = 0, more = 0;
    double worst = 0.0;
    for (int k = 0; k < 2000; ++k) {
      const Eigen::Isometry3d goal = goal_of(arm, random);
      ClosedLanes lanes;
      if (!form->solve(goal, lanes)) continue;
      ++asked;
      Branches branches;
      family(rows, rows.goal(goal), {}, branches);
      for (const double miss2 : lanes.miss2) more += miss2 < 1e-18 ? 1 : 0;
      more -= branches.count;
      for (int b = 0; b < branches.count; ++b) {
        const Branch& branch = branches.at[static_cast<std::size_t>(b)];
        const std::size_t way = static_cast<std::size_t>(branch.bits);
        missing += lanes.miss2[way] < 1e-18 ? 0 : 1;
        for (std::size_t i = 0; i < kSixJoints; ++i) {
          const double q =
              rows.sign[i] * det::atan2(branch.phi[i].s, branch.phi[i].c) - rows.offset[i];
          worst = std::max(worst, std::abs(angle_difference(lanes.q[i][way], q)));
        }
      }
    }
    CHECK(asked > 1950);
    CHECK(missing == 0);
    CHECK(more == 0);
    CHECK(worst < 1e-8);
  }
}

TEST_CASE("borders between solutions are left to the functions with branches") {
  const auto puma = make_robot("puma560");
  const auto form = LaneForm::make(closed_form(*puma).kind(), canonical_rows(puma->chain(), false),
                                   puma->chain());
  ClosedLanes lanes;
  Eigen::VectorXd q(6);
  q << 0.3, 0.4, -0.7, 1.1, 0.5, -0.6;
  CHECK(form->solve(forward(*puma, q), lanes));
  q[4] = 1e-6;  // the wrist is straight
  CHECK_FALSE(form->solve(forward(*puma, q), lanes));
}

TEST_CASE("the angles of lanes are those of atan2 to two units in the last place") {
  using Lanes = det::Lanes;
  Random random(5);
  double worst = 0.0;
  for (int k = 0; k < 100'000; ++k) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
    const double x = scale * random.uniform(-1.0, 1.0);
    const double y = scale * random.uniform(-1.0, 1.0) * (random.below(4) == 0 ? 1e-6 : 1.0);
    const double angle = det::atan2_lanes(Lanes{y, y}, Lanes{x, x})[1];
    const double exact = det::atan2(y, x);
    worst = std::max(worst, std::abs(angle - exact) / std::abs(exact));
  }
  CHECK(worst < 2.3e-16 * 2);
  const Lanes zero = {0.0, -0.0};
  CHECK(same_bits(det::atan2_lanes(zero, Lanes{1.0, 1.0})[0], 0.0));
  CHECK(same_bits(det::atan2_lanes(zero, Lanes{1.0, 1.0})[1], -0.0));
  CHECK(det::atan2_lanes(zero, Lanes{-1.0, -1.0})[0] == std::numbers::pi);
  CHECK(det::atan2_lanes(zero, Lanes{-1.0, -1.0})[1] == -std::numbers::pi);
  CHECK(det::atan2_lanes(Lanes{2.0, -2.0}, zero)[0] == std::numbers::pi / 2);
}
