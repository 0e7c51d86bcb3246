#include "armlet/model/dh.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"

using namespace armlet;

// The matrix of the textbooks (Paul 1981): rows as printed there.
TEST_CASE("a standard row is the matrix of the textbooks") {
  const DhRow row{0.3, 0.1, 0.4, -1.1};
  const double ct = std::cos(0.3), st = std::sin(0.3), ca = std::cos(-1.1), sa = std::sin(-1.1);
  Eigen::Matrix4d expected;
  expected << ct, -st * ca, st * sa, 0.4 * ct,  //
      st, ct * ca, -ct * sa, 0.4 * st,          //
      0, sa, ca, 0.1,                           //
      0, 0, 0, 1;
  CHECK((dh_pose(DhConvention::kStandard, row).matrix() - expected).norm() < 1e-15);
}

// J. Craig, Introduction to Robotics, equation 3.6.
TEST_CASE("a modified row is the matrix of Craig") {
  const DhRow row{0.3, 0.1, 0.4, -1.1};
  const double ct = std::cos(0.3), st = std::sin(0.3), ca = std::cos(-1.1), sa = std::sin(-1.1);
  Eigen::Matrix4d expected;
  expected << ct, -st, 0, 0.4,           //
      st * ca, ct * ca, -sa, -sa * 0.1,  //
      st * sa, ct * sa, ca, ca * 0.1,    //
      0, 0, 0, 1;
  CHECK((dh_pose(DhConvention::kModified, row).matrix() - expected).norm() < 1e-15);
}

TEST_CASE("rounded right angles count as right angles") {
  CHECK(snapped_sin_cos(1.5707963267949).cos == 0.0);
  CHECK(snapped_sin_cos(1.5707963267949).sin == 1.0);
  CHECK(snapped_sin_cos(kPi).sin == 0.0);
  CHECK(snapped_sin_cos(kPi).cos == -1.0);
  CHECK(snapped_sin_cos(1.57).cos == doctest::Approx(7.963e-4).epsilon(1e-3));
}

TEST_CASE("an arm converted to the modified convention moves its tool alike") {
  Random random(1);
  for (int arm = 0; arm < 20; ++arm) {
    RobotSpec standard;
    std::vector<DhRow> rows;
    for (int i = 0; i < 6; ++i) {
      Joint joint;
      joint.kind = random.below(3) == 0 ? JointKind::kPrismatic : JointKind::kRevolute;
      joint.dh = {random.uniform(-3, 3), random.uniform(-1, 1), random.uniform(-1, 1),
                  random.uniform(-3, 3)};
      standard.joints.push_back(joint);
      rows.push_back(joint.dh);
    }
    standard.T_flange_tool = pose_from_rpy({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6});
    const ModifiedDh converted = to_modified(rows);
    RobotSpec modified = standard;
    modified.convention = DhConvention::kModified;
    for (std::size_t i = 0; i < 6; ++i) modified.joints[i].dh = converted.rows[i];
    modified.T_flange_tool = converted.T_last_flange * standard.T_flange_tool;
    const Robot a(standard), b(modified);
    for (int i = 0; i < 50; ++i) {
      Eigen::VectorXd q(6);
      for (double& value : q) value = random.uniform(-3, 3);
      CHECK((forward(a, q).matrix() - forward(b, q).matrix()).norm() < 1e-12);
    }
  }
}
