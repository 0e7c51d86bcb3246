#include "armlet/kinematics/manipulability.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"
#include "reference_samples.hpp"

using namespace armlet;

namespace {

double worst_sigma(const Robot& robot, int joint, double value) {
  Random random(1);
  double worst = 0.0;
  for (int k = 0; k < 100; ++k) {
    Eigen::VectorXd q = random_joints(robot, random);
    q[joint] = value;
    worst = std::max(worst, singularity(robot, q).sigma_min);
  }
  return worst;
}

}  // namespace

TEST_CASE("manipulability agrees with other libraries") {
  reference::for_each_sample([](const Robot& robot, const reference::Json& sample,
                                const Eigen::VectorXd& q) {
    const reference::Json& all = sample.at("manip_all");
    if (!all.is_null()) {
      CHECK(std::abs(manipulability(robot, q) - all.get<double>()) < 1e-10);
    } else if (robot.n() >= 3) {
      CHECK(std::abs(manipulability(robot, q) - sample.at("manip_trans").get<double>()) < 1e-10);
    }
  });
}

// T. Yoshikawa 1985: w = a1 a2 |sin q2| for the planar arm with two joints.
TEST_CASE("the planar arm with two joints has the manipulability of the textbook") {
  const Robot arm = *make_robot("planar2");
  for (double q2 = -3.0; q2 <= 3.0; q2 += 0.1) {
    const double w = manipulability(arm, Eigen::Vector2d(0.7, q2));
    CHECK(std::abs(w - std::abs(std::sin(q2))) < 1e-14);
  }
}

TEST_CASE("known singular configurations are singular and others are not") {
  CHECK(worst_sigma(*make_robot("planar2"), 1, 0.0) < 1e-15);
  CHECK(worst_sigma(*make_robot("scara"), 1, 0.0) < 1e-15);
  CHECK(worst_sigma(*make_robot("anthropomorphic"), 2, 0.0) < 1e-15);
  CHECK(worst_sigma(*make_robot("puma560"), 4, 0.0) < 1e-15);
  CHECK(worst_sigma(*make_robot("pa10"), 3, 0.0) < 1e-15);
  CHECK(worst_sigma(*make_robot("pa10"), 1, 0.0) >
        0.01);  // one joint at zero alone is regular here
  CHECK(singularity(*make_robot("puma560"), make_robot("puma560")->home()).sigma_min > 0.05);
}

TEST_CASE("the lost motion of a stretched arm is along the arm") {
  const Singularity stretched = singularity(*make_robot("scara"), Eigen::Vector4d(0, 0, 0.1, 0));
  CHECK(std::abs(stretched.direction[0]) == doctest::Approx(1.0));
  CHECK(describe(stretched) == "cannot move along (1.00, 0.00, 0.00)");
  const Singularity planar = singularity(*make_robot("planar2"), Eigen::Vector2d(0.0, 0.0));
  CHECK(describe(planar) == "cannot move along (1.00, 0.00, 0.00)");
}

// The squares of the singular values add up to the squares of the entries of the scaled Jacobian.
TEST_CASE("singular values come with the length that scales the rotations") {
  Random random(2);
  for (const char* name : {"puma560", "ur5", "panda"}) {
    const Robot robot = *make_robot(name);
    const Eigen::VectorXd q = random_joints(robot, random);
    const Singularity s = singularity(robot, q);
    CHECK(s.length == robot.length());
    CHECK(s.sigma.size() == 6);
    CHECK(s.sigma[5] == s.sigma_min);
    Eigen::MatrixXd J = jacobian(robot, q);
    J.bottomRows<3>() *= s.length;
    CHECK(s.sigma.squaredNorm() == doctest::Approx(J.squaredNorm()));
    // What the joints give to the lost motion: |J^T u| is the smallest singular value.
    CHECK((J.transpose() * s.direction).norm() == doctest::Approx(s.sigma_min));
  }
}

TEST_CASE("in an aligned wrist joints 4 and 6 fight each other") {
  Eigen::VectorXd q = make_robot("puma560")->home();
  q[4] = 0.0;
  const Singularity aligned = singularity(*make_robot("puma560"), q);
  CHECK(aligned.sigma_min < 1e-15);
  // Joints 4 and 6 rotate against each other without moving the tool.
  CHECK(std::abs(aligned.joints[3] + aligned.joints[5]) < 1e-9);
}

TEST_CASE("the gradient of the manipulability is its derivative") {
  Random random(4);
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 20; ++k) {
      const Eigen::VectorXd q = random_joints(robot, random);
      const Eigen::VectorXd gradient = manipulability_gradient(robot, q);
      for (int i = 0; i < robot.n(); ++i) {
        Eigen::VectorXd above = q, below = q;
        above[i] += 1e-5;
        below[i] -= 1e-5;
        const double slope = (manipulability(robot, above) - manipulability(robot, below)) / 2e-5;
        // The error of a central difference is that of its rounding, 1e-16 / 1e-5, and of its step.
        CHECK(std::abs(gradient[i] - slope) < 1e-8);
      }
    }
  }
}
