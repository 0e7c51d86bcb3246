#include "armlet/kinematics/ik.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

VectorXd joints(std::initializer_list<double> values) {
  VectorXd q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.begin());
  return q;
}

// Goals of which solve_ik misses one of the tolerances or a limit.
int failures(const Robot& robot, int count, auto choose_goal, IkChoice choice = IkChoice::kFirst) {
  Random random(11);
  int failed = 0;
  for (int k = 0; k < count; ++k) {
    const VectorXd q = choose_goal(random);
    const Isometry3d goal = forward(robot, q);
    const IkResult ik =
        solve_ik(robot, goal, {.seed = random_joints(robot, random), .choice = choice});
    const Isometry3d reached = forward(robot, ik.q);
    const bool good = ik.ok() && within_limits(robot, ik.q) &&
                      (reached.translation() - goal.translation()).norm() < 1.001e-6 &&
                      angle_between(reached, goal) < 1.001e-6;
    failed += good ? 0 : 1;
  }
  return failed;
}

bool contains(const std::vector<VectorXd>& solutions, const VectorXd& q) {
  for (const VectorXd& solution : solutions) {
    double worst = 0.0;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      worst = std::max(worst, std::abs(angle_difference(solution[i], q[i])));
    }
    if (worst < 1e-4) return true;  // the reference is given to five decimals
  }
  return false;
}

}  // namespace

TEST_CASE("each of 10,000 poses that an arm takes is found again within its limits") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    CHECK(failures(robot, 10'000, [&](Random& r) { return random_joints(robot, r); }) == 0);
  }
}

TEST_CASE("the nearest solution is found for 10,000 poses of every arm that has a closed form") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    if (!closed_form(robot).complete()) continue;
    const auto any = [&](Random& r) { return random_joints(robot, r); };
    CHECK(failures(robot, 10'000, any, IkChoice::kNearest) == 0);
    const auto on_limits = [&](Random& r) {
      VectorXd q = random_joints(robot, r);
      for (int i = 0; i < robot.n(); ++i) {
        if (r.below(2) == 0) q[i] = r.below(2) == 0 ? robot.lower()[i] : robot.upper()[i];
      }
      return q;
    };
    CHECK(failures(robot, 2'000, on_limits, IkChoice::kNearest) == 0);
    const auto singular = [&](Random& r) {  // some joints exactly where axes line up
      VectorXd q = random_joints(robot, r);
      for (int i = 0; i < robot.n(); ++i) {
        if (robot.is_revolute(i) && r.below(2) == 0) q[i] = 0.0;
      }
      return clamp_to_limits(robot, q);
    };
    // Where three axes are parallel most of these leave a joint free, which costs a search each;
    // nearest_test.cpp has more of them.
    const bool parallel = closed_form(robot).kind() == ClosedFormKind::kThreeParallel;
    CHECK(failures(robot, parallel ? 250 : 2'000, singular, IkChoice::kNearest) == 0);
  }
}

TEST_CASE("the closed form finds nearer solutions than the iterations") {
  Random random(12);
  for (const std::string_view name :
       {"scara", "scorbot", "puma560", "stanford", "ur5", "pa10", "panda"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    double sum_formula = 0.0, sum_search = 0.0;
    for (int k = 0; k < 60; ++k) {
      const VectorXd seed = random_joints(robot, random);
      const Isometry3d goal = forward(robot, random_joints(robot, random));
      const IkResult formula = solve_ik(robot, goal, {.seed = seed});
      const IkResult search = solve_ik(robot, goal, {.seed = seed, .method = IkMethod::kNumeric});
      REQUIRE(formula.ok());
      REQUIRE(search.ok());
      const double change = (formula.q - seed).cwiseAbs().maxCoeff();
      const double change_search = (search.q - seed).cwiseAbs().maxCoeff();
      // Next to a singularity a pose within the tolerance may have joints that differ by 1e-4.
      if (robot.n() <= 6) CHECK(change <= change_search + 1e-4);
      sum_formula += change;
      sum_search += change_search;
    }
    // Arm angles are tried in steps, so a few of the nearest solutions of seven joints are missed.
    CHECK(sum_formula <= sum_search + 1e-3);
  }
}

TEST_CASE("all branches are listed, with limits only those within") {
  Random random(13);
  for (const char* name : {"rrr3", "scara", "scorbot", "puma560", "stanford", "ur5", "pa10"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 50; ++k) {
      const VectorXd q = random_joints(robot, random);
      const Isometry3d goal = forward(robot, q);
      const auto within = solve_ik_all(robot, goal, {.seed = q});
      const auto all = solve_ik_all(robot, goal, {.seed = q, .respect_limits = false});
      REQUIRE_FALSE(within.empty());
      CHECK((within.front() - q).cwiseAbs().maxCoeff() < 1e-5);
      CHECK(all.size() >= within.size());
      if (robot.n() == 6) CHECK(all.size() % 2 == 0);
      for (const VectorXd& solution : within) CHECK(within_limits(robot, solution, 0.0));
      for (const VectorXd& solution : all) {
        CHECK((forward(robot, solution).matrix() - goal.matrix()).norm() < 1e-8);
      }
    }
  }
}

TEST_CASE("a result names its formula, its branch and the distance to each limit") {
  const Robot robot = *make_robot("puma560");
  // The wrist in front of the shoulder, the elbow above the line from shoulder to wrist.
  const VectorXd q = joints({0.1, kPi / 4, -kPi / 2, 0.2, 0.5, 0.3});
  const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = q});
  REQUIRE(ik.ok());
  CHECK(ik.solver == "six joints, spherical wrist, axes 2 and 3 parallel");
  CHECK(ik.iterations == 0);
  CHECK(branch_name(robot, ik).find("shoulder ") == 0);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double margin = std::min(q[i] - robot.lower()[i], robot.upper()[i] - q[i]);
    CHECK(ik.margins[i] == doctest::Approx(margin));
  }
  const IkResult search =
      solve_ik(robot, forward(robot, q), {.seed = q, .method = IkMethod::kNumeric});
  CHECK(search.solver == "numeric");
  CHECK(search.branch == -1);
  CHECK(branch_name(robot, search).empty());
}

TEST_CASE("elbow up means that the elbow is above the line from shoulder to wrist") {
  Random random(14);
  for (const std::string_view name : {"rrr3", "scorbot", "puma560", "ur5", "pa10_6"}) {
    CAPTURE(name);
    const Robot standing = *make_robot(name);
    const Robot hanging = standing.with_base(standing.T_world_base() *
                                             make_pose(rot_x(kPi), Eigen::Vector3d::Zero()));
    for (const Robot& robot : {standing, hanging}) {
      for (int k = 0; k < 100; ++k) {
        const VectorXd q = random_joints(robot, random);
        CAPTURE(q.transpose());
        const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = q});
        REQUIRE(ik.ok());
        const auto elbow_axis = [&](int i) -> Eigen::Vector3d {
          return link_frame(robot, ik.q, i).translation();
        };
        // Joint 2 rotates about the origin of frame 1, joint 3 about that of frame 2; the wrist is
        // that of frame 3 or, behind a spherical wrist, of frame 4.
        const bool spherical = name.starts_with("p");
        const Eigen::Vector3d shoulder = elbow_axis(1), elbow = elbow_axis(2);
        const Eigen::Vector3d wrist = elbow_axis(spherical ? 4 : 3);
        const Eigen::Vector3d line = wrist - shoulder;
        const Eigen::Vector3d out =
            elbow - shoulder - line * (elbow - shoulder).dot(line) / line.squaredNorm();
        const Eigen::Vector2d level = line.head<2>();
        if (std::abs(out.z()) < 0.02 || level.norm() < 0.2 || std::abs(line.z()) > level.norm())
          continue;
        const std::string branch = branch_name(robot, ik);
        CHECK((branch.find("elbow up") != std::string::npos) == (out.z() > 0.0));
      }
    }
  }
}

TEST_CASE("goals with one joint or all joints on a limit are found") {
  for (const std::string_view name : catalog_names()) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const auto on_limit = [&](Random& r, int i) {
      return r.below(2) == 0 ? robot.lower()[i] : robot.upper()[i];
    };
    CHECK(failures(robot, 300, [&](Random& r) {
            VectorXd q = random_joints(robot, r);
            const int i = static_cast<int>(r.below(static_cast<std::uint64_t>(robot.n())));
            q[i] = on_limit(r, i);
            return q;
          }) == 0);
    CHECK(failures(robot, 200, [&](Random& r) {
            VectorXd q(robot.n());
            for (int i = 0; i < robot.n(); ++i) q[i] = on_limit(r, i);
            return q;
          }) == 0);
  }
}

TEST_CASE("a solution at a regular goal is polished far below the tolerance") {
  const Robot robot = *make_robot("ur5");
  const VectorXd q = joints({.4, -1.1, 1.3, -.7, .9, .2});
  const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = robot.home()});
  REQUIRE(ik.ok());
  CHECK(ik.position_error < 1e-11);
  CHECK(ik.rotation_error < 1e-11);
}

TEST_CASE("the nearest solution is the present one when the arm is already there") {
  Random random(5);
  for (const char* name : {"scara", "scorbot", "puma560", "pa10", "ur5", "panda"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    for (int k = 0; k < 20; ++k) {
      const VectorXd q = random_joints(robot, random);
      VectorXd seed = q;
      for (double& value : seed) value += random.uniform(-0.01, 0.01);
      seed = clamp_to_limits(robot, seed);
      const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = seed});
      REQUIRE(ik.ok());
      CHECK((ik.q - seed).cwiseAbs().maxCoeff() < 0.05 + 2.0 * (q - seed).cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("of the two elbows of a SCARA the nearer one is taken") {
  const Robot scara = *make_robot("scara");
  Random random(6);
  for (int k = 0; k < 200; ++k) {
    VectorXd q = random_joints(scara, random);
    q[2] = 0.1;
    const VectorXd seed = random_joints(scara, random);
    const Isometry3d goal = forward(scara, q);
    const std::vector<VectorXd> all = solve_ik_all(scara, goal, {.seed = seed});
    const IkResult ik = solve_ik(scara, goal, {.seed = seed});
    REQUIRE(ik.ok());
    REQUIRE_FALSE(all.empty());
    for (const VectorXd& other : all) {
      CHECK((ik.q - seed).cwiseAbs().maxCoeff() <= (other - seed).cwiseAbs().maxCoeff() + 1e-8);
    }
  }
}

TEST_CASE("between equally near solutions the positive elbow wins") {
  const Robot scara = *make_robot("scara");
  // Straight ahead and seen from the stretched arm both elbows are equally far.
  const Isometry3d goal = make_pose(rot_x(kPi), {0.5, 0.0, 0.3});
  const IkResult ik = solve_ik(scara, goal, {.seed = VectorXd::Zero(4)});
  REQUIRE(ik.ok());
  CHECK(ik.q[1] > 0.0);
}

// Independent closed forms: the Puma at FK(0, 45, 180, 0, 45, 0 deg) and the UR5 have 8 solutions.
TEST_CASE("all eight solutions of a Puma and of a UR5 are found") {
  RobotSpec spec;
  spec.joints = joints_from_table({{0, 0, 0, kPi / 2},
                                   {0, 0, .4318, 0},
                                   {0, .15005, .0203, -kPi / 2},
                                   {0, .4318, 0, kPi / 2},
                                   {0, 0, 0, -kPi / 2},
                                   {0, 0, 0, 0}},
                                  "RRRRRR");
  const Robot puma(spec);
  const IkOptions options{.seed = VectorXd::Zero(6), .respect_limits = false};
  const std::vector<VectorXd> of_puma =
      solve_ik_all(puma, forward(puma, joints({0, kPi / 4, kPi, 0, kPi / 4, 0})), options);
  CHECK(of_puma.size() == 8);
  CHECK(contains(of_puma, joints({0, -0.83353, 0.09396, 0, -0.83122, 0})));
  CHECK(contains(of_puma, joints({2.64856, 2.35619, 0.09396, -0.60903, -0.97435, -2.76819})));

  const Robot ur5 = *make_robot("ur5");
  const std::vector<VectorXd> of_ur5 =
      solve_ik_all(ur5, forward(ur5, joints({.4, -1.1, 1.3, -.7, .9, .2})), options);
  CHECK(of_ur5.size() == 8);
  CHECK(contains(of_ur5, joints({.4, 0.13909, -1.3, 0.66091, .9, .2})));
  CHECK(contains(of_ur5, joints({-2.39449, 3.01808, 1.26613, 2.41160, -1.92910, 0.02496})));
}

TEST_CASE("a point out of reach is reported with its exact distance") {
  const Robot arm = *make_robot("planar3");
  RobotSpec spec = make_robot("anthropomorphic")->spec();
  for (Joint& joint : spec.joints) {
    joint.lower = -kPi;
    joint.upper = kPi;
  }
  const Robot elbow(spec);
  Random random(7);
  for (int k = 0; k < 1000; ++k) {
    Eigen::Vector3d u(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    u.normalize();
    const double excess = random.uniform(0.01, 1.0);
    // The sphere around the shoulder has the radius a2 + a3 = 0.8 m.
    const Eigen::Vector3d p = Eigen::Vector3d(0, 0, 0.4) + (0.8 + excess) * u;
    const IkResult ik =
        solve_ik(elbow, make_translation(p), {.task = IkTask::kPosition, .starts = 5});
    CHECK(ik.status == IkStatus::kUnreachable);
    CHECK(std::abs(ik.diagnosis.distance - excess) < 5e-7);
    const Eigen::Vector3d nearest = Eigen::Vector3d(0, 0, 0.4) + 0.8 * u;
    CHECK((ik.diagnosis.nearest.translation() - nearest).norm() < 1e-3);
  }
  const IkResult ik = solve_ik(arm, make_translation({1.2, 0, 0}), {.task = IkTask::kPosition});
  CHECK(explain(arm, make_translation({1.2, 0, 0}), ik).find("out of reach by 300 mm") !=
        std::string::npos);
}

TEST_CASE("a pose beyond a joint limit names the joint") {
  const Robot scara = *make_robot("scara");
  const Isometry3d goal = make_pose(rot_x(kPi), {0.4, 0.2, 0.10});  // 250 mm below the arm
  const IkResult ik = solve_ik(scara, goal);
  CHECK(ik.status == IkStatus::kJointLimit);
  REQUIRE(ik.diagnosis.violations.size() == 1);
  CHECK(ik.diagnosis.violations[0].joint == 2);
  CHECK(ik.diagnosis.violations[0].value == doctest::Approx(0.25));
  CHECK(ik.diagnosis.distance == doctest::Approx(0.05));
  CHECK(explain(scara, goal, ik) ==
        "The pose can be reached only outside the limits: joint 3 would slide to 250 mm; its range "
        "is 0 mm to 200 mm.");
}

TEST_CASE("an orientation that the arm cannot take is reported with the smallest angle") {
  const Robot scara = *make_robot("scara");
  const double tilt = deg_to_rad(12.3);
  const Isometry3d goal = make_pose(rot_x(kPi - tilt), {0.5, 0.1, 0.25});
  const IkResult ik = solve_ik(scara, goal);
  CHECK(ik.status == IkStatus::kOrientationUnreachable);
  CHECK(ik.diagnosis.distance == 0.0);
  CHECK(ik.diagnosis.angle == doctest::Approx(tilt).epsilon(1e-6));
  CHECK(explain(scara, goal, ik).find("differs by 12.3 deg") != std::string::npos);
}

TEST_CASE("a question that cannot be asked is answered by a status") {
  const Robot scara = *make_robot("scara");
  Isometry3d goal = forward(scara, scara.home());
  CHECK(solve_ik(scara, goal, {.seed = VectorXd::Zero(3)}).status == IkStatus::kBadSize);
  CHECK(solve_ik(scara, goal, {.seed = joints({0, 0, NAN, 0})}).status == IkStatus::kNotFinite);
  goal.matrix()(0, 0) = 3.0;
  CHECK(solve_ik(scara, goal).status == IkStatus::kBadRotation);
  CHECK(solve_ik_all(scara, goal).empty());
  for (const double x : {HUGE_VAL, 1e300, -2e6}) {
    goal.matrix()(0, 3) = x;
    CHECK(solve_ik(scara, goal).status == IkStatus::kNotFinite);
  }
  CHECK(solve_ik(scara, forward(scara, scara.home()), {.seed = joints({0, 1e9, 0, 0})}).status ==
        IkStatus::kNotFinite);
  CHECK(to_text(IkStatus::kOrientationUnreachable) == "orientation unreachable");
}

TEST_CASE("the position and rotation of a SCARA need no tilt in the goal") {
  const Robot scara = *make_robot("scara");
  Random random(8);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_joints(scara, random);
    const Isometry3d pose = forward(scara, q);
    const double turn = rpy_from_R(pose.linear()).z();
    const Isometry3d goal = make_pose(rot_z(turn), pose.translation());  // z up, like an object
    const IkResult ik =
        solve_ik(scara, goal, {.seed = random_joints(scara, random), .task = IkTask::kHeading});
    REQUIRE(ik.ok());
    CHECK((forward(scara, ik.q).matrix() - pose.matrix()).norm() < 1e-6);
  }
}

TEST_CASE("a position keeps the orientation where the arm can") {
  for (const char* name : {"scara", "puma560", "pa10", "ur5"}) {
    CAPTURE(name);
    const Robot robot = *make_robot(name);
    const Isometry3d start = forward(robot, robot.home());
    const Eigen::Vector3d p = start.translation() + Eigen::Vector3d(-0.03, 0.02, -0.02);
    const IkResult ik = solve_ik(robot, make_translation(p), {.task = IkTask::kPositionFirst});
    REQUIRE(ik.ok());
    CHECK((forward(robot, ik.q).translation() - p).norm() < 1e-6);
    CHECK(angle_between(forward(robot, ik.q), start) < 1e-6);
  }
}

TEST_CASE("a position rotates the tool as little as possible where the arm must rotate it") {
  const Robot scorbot = *make_robot("scorbot");
  const Isometry3d start = forward(scorbot, scorbot.home());
  // A step sideways rotates the tool with the base of the arm: by atan(50 / 180 mm) about z, of
  // which the roll can take back only a part.
  const Eigen::Vector3d p = start.translation() + Eigen::Vector3d(0, 0.05, 0);
  const double heading = std::atan2(p.y(), p.x());
  const IkResult ik = solve_ik(scorbot, make_translation(p), {.task = IkTask::kPositionFirst});
  REQUIRE(ik.ok());
  CHECK((forward(scorbot, ik.q).translation() - p).norm() < 1e-6);
  const double angle = angle_between(forward(scorbot, ik.q), start);
  CHECK(angle < heading);
  // No neighbouring configuration with the same position has a smaller rotation error.
  for (double change = -0.2; change <= 0.2; change += 0.02) {
    const Eigen::Matrix3d R = rot_z(heading) * rot_y(change) * rot_z(-heading);
    const Isometry3d other = make_pose(R * forward(scorbot, ik.q).linear(), p);
    const IkResult tilted = solve_ik(scorbot, other, {.seed = ik.q, .diagnose = false});
    if (tilted.ok()) CHECK(angle_between(forward(scorbot, tilted.q), start) > angle - 1e-6);
  }
}

TEST_CASE("masked rows are free in the axes that were chosen") {
  const Robot robot = *make_robot("puma560");
  Random random(9);
  for (int k = 0; k < 100; ++k) {
    const Isometry3d goal = forward(robot, random_joints(robot, random));
    IkOptions options{.seed = random_joints(robot, random), .task = IkTask::kMasked};
    options.mask = {true, true, true, true, true, false};  // free to roll about the tool's z axis
    options.mask_frame = IkMaskFrame::kTool;
    options.choice = IkChoice::kFirst;
    const IkResult ik = solve_ik(robot, goal, options);
    REQUIRE(ik.ok());
    const Isometry3d reached = forward(robot, ik.q);
    CHECK((reached.translation() - goal.translation()).norm() < 1e-6);
    const Eigen::Vector3d z = reached.linear().col(2), z_goal = goal.linear().col(2);
    CHECK(std::abs(std::abs(z.dot(z_goal)) - 1.0) < 1e-9);
  }
}

TEST_CASE("the same question has the same answer, bit by bit") {
  const Robot robot = *make_robot("panda");
  const Isometry3d goal = pose_from_rpy({0.4, 0.2, 0.4}, {kPi, 0.1, 0.3});
  const IkResult a = solve_ik(robot, goal), b = solve_ik(robot, goal);
  REQUIRE(a.ok());
  CHECK(a.q == b.q);
  CHECK(a.iterations == b.iterations);
}
