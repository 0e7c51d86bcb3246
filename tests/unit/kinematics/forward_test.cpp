#include "armlet/kinematics/forward.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "reference_samples.hpp"

using namespace armlet;

namespace {

Robot arm_of(std::vector<std::vector<double>> rows, std::string_view kinds) {
  RobotSpec spec;
  spec.joints = joints_from_table(rows, kinds);
  return Robot(spec);
}

Eigen::VectorXd joints(std::initializer_list<double> values) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.begin());
  return q;
}

constexpr double kHalfPi = 1.5707963267948966;

}  // namespace

TEST_CASE("tool pose and link frames of fourteen arms agree with other libraries") {
  reference::for_each_sample(
      [](const Robot& robot, const reference::Json& sample, const Eigen::VectorXd& q) {
        const Eigen::Isometry3d T = reference::pose_of(sample.at("T"));
        CHECK((forward(robot, q).matrix() - T.matrix()).cwiseAbs().maxCoeff() < 1e-10);
        const std::vector<Eigen::Isometry3d> frames = link_frames(robot, q);
        for (int k = 1; k <= robot.n(); ++k) {
          const std::size_t i = static_cast<std::size_t>(k - 1);
          const Eigen::Isometry3d expected = reference::pose_of(sample.at("frames").at(i));
          CHECK((frames[i].matrix() - expected.matrix()).cwiseAbs().maxCoeff() < 1e-10);
          CHECK(link_frame(robot, q, k).matrix() == frames[i].matrix());
        }
      });
}

// P. Corke, Robotics Toolbox: the nominal configuration of the Puma, here without its pedestal.
TEST_CASE("the Puma in its nominal configuration is where the textbook says") {
  const Robot puma = arm_of({{0, 0, 0, kHalfPi},
                             {0, 0, .4318, 0},
                             {0, .15005, .0203, -kHalfPi},
                             {0, .4318, 0, kHalfPi},
                             {0, 0, 0, -kHalfPi},
                             {0, 0, 0, 0}},
                            "RRRRRR");
  const Eigen::Vector3d p =
      forward(puma, joints({0, kHalfPi / 2, 2 * kHalfPi, 0, kHalfPi / 2, 0})).translation();
  CHECK((p - Eigen::Vector3d(0.596303, -0.150050, -0.014354)).norm() < 1e-6);
}

TEST_CASE("UR5, SCARA, Scorbot and PA-10 are where independent programs put them") {
  const auto place = [](const Robot& robot, const Eigen::VectorXd& q) {
    return Eigen::Vector3d(forward(robot, q).translation());
  };
  CHECK((place(*make_robot("ur5"), joints({.4, -1.1, 1.3, -.7, .9, .2})) -
         Eigen::Vector3d(-0.563123, -0.412132, 0.337838))
            .norm() < 1e-6);
  const Robot scara =
      arm_of({{0, .4, .35, 0}, {0, 0, .25, 2 * kHalfPi}, {0, 0, 0, 0}, {0, .05, 0, 0}}, "RRPR");
  const Eigen::VectorXd q = joints({.5, -.8, .1, .3});
  CHECK((place(scara, q) - Eigen::Vector3d(0.545988019, 0.093918887, 0.25)).norm() < 1e-9);
  CHECK(rpy_from_R(forward(scara, q).linear()).z() == doctest::Approx(-0.6));
  const Robot scorbot = arm_of({{0, .364, .016, kHalfPi},
                                {0, 0, .221, 0},
                                {0, 0, .221, 0},
                                {kHalfPi, 0, 0, kHalfPi},
                                {0, .145, 0, 0}},
                               "RRRRR");
  const Eigen::Isometry3d T = forward(scorbot, joints({.3, .4, -.7, -.2, .5}));
  CHECK((T.translation() - Eigen::Vector3d(0.533014, 0.164881, 0.315235)).norm() < 1e-6);
  CHECK((T.linear().col(2) - Eigen::Vector3d(0.838387, 0.259343, -0.479426)).norm() < 1e-6);
  CHECK((place(*make_robot("pa10"), joints({.3, .5, .2, .9, -.4, .6, .1})) -
         Eigen::Vector3d(0.691839, 0.290529, 0.770217))
            .norm() < 1e-6);
}

TEST_CASE("the product of the single rows is the tool pose") {
  Random random(1);
  for (const std::string_view name : catalog_names()) {
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 100; ++k) {
      Eigen::VectorXd q(robot.n());
      Eigen::Isometry3d T = robot.T_world_base();
      for (int i = 0; i < robot.n(); ++i) {
        q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
        DhRow row = robot.joint(i).dh;
        (robot.is_revolute(i) ? row.theta : row.d) += q[i];
        T = T * dh_pose(robot.spec().convention, row);
      }
      T = T * robot.T_flange_tool();
      CHECK((forward(robot, q).matrix() - T.matrix()).norm() < 1e-13);
      CHECK(is_rotation(forward(robot, q).linear(), 1e-14));
    }
  }
}

TEST_CASE("frame 0 is the base and other numbers are refused") {
  const Robot robot = make_robot("scara")->with_base(make_translation({1, 2, 3}));
  CHECK(link_frame(robot, robot.home(), 0).translation() == Eigen::Vector3d(1, 2, 3));
  CHECK_THROWS_AS(link_frame(robot, robot.home(), 5), ArgumentError);
  CHECK_THROWS_AS(link_frame(robot, robot.home(), -1), ArgumentError);
  CHECK_THROWS_WITH_AS(forward(robot, Eigen::Vector3d::Zero()), "`q` has 3 elements; expected 4.",
                       ArgumentError);
  std::vector<Eigen::Isometry3d> too_few(3);
  CHECK_THROWS_AS(link_frames(robot, robot.home(), too_few), ArgumentError);
}
