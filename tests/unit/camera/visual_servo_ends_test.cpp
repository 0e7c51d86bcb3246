#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "refusal_of.hpp"
#include "servo_loop.hpp"

using namespace armlet;
using namespace armlet::servoing;

TEST_CASE("points that are not found are predicted for a while, then the loop ends") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.1, -0.05, 0.2}, {0.03, 0.02, -0.05});
  const Loop start = loop;
  const VisualServo whole = loop.run();
  for (const int gap : {1, 5, 6}) {
    CAPTURE(gap);
    loop = start;
    loop.spoil = [gap](ServoSight& sight, int k) {
      if (k < 10 || k >= 10 + gap) return;
      sight.pixels.reset();
      sight.lost = "nothing was found";
    };
    const VisualServo servo = loop.run();
    if (gap == 6) {
      CHECK(servo.end() == ServoEnd::kFeatureLost);
      CHECK(servo.why() ==
            "the points were not found in 6 pictures one after the other; at most 5 are bridged: "
            "nothing was found");
      CHECK(servo.rows().back().twist.isZero(0.0));
      continue;
    }
    CHECK(servo.end() == ServoEnd::kConverged);
    CHECK(servo.rows()[10].held);
    // A prediction over one period is wrong by the second derivative of the motion.
    CHECK((servo.rows()[10].points - whole.rows()[10].points).norm() < 0.5);
    CHECK(static_cast<double>(servo.rows().size()) ==
          doctest::Approx(static_cast<double>(whole.rows().size())).epsilon(0.05));
  }
  loop = start;
  loop.spoil = [](ServoSight& sight, int) { sight.pixels.reset(); };
  const VisualServo never = loop.run();
  CHECK(never.end() == ServoEnd::kFeatureLost);
  CHECK(never.rows().empty());
  CHECK(never.uncontrollable().cols() == 0);
}

TEST_CASE("of a picture in which one point is missing the others count") {
  Random random(11);
  for (int trial = 0; trial < 40; ++trial) {
    Loop loop;
    const auto part = [&random](double most) { return random.uniform(-most, most); };
    loop.T = displaced(loop.wanted, {part(0.05), part(0.05), part(0.15)},
                       {part(0.03), part(0.03), random.uniform(-0.2, 0.02)});
    const auto point = static_cast<Eigen::Index>(random.below(4));
    const int from = 5 + static_cast<int>(random.below(10));
    const int gap = 1 + static_cast<int>(random.below(5));
    PlanePoints seen;
    loop.spoil = [&](ServoSight& sight, int k) {
      if (k < from || k >= from + gap) return;
      if (k == from) seen = *sight.pixels;
      sight.pixels->row(point).setConstant(3.0);  // does not count
      sight.missing = {point};
    };
    const VisualServo servo = loop.run();
    CAPTURE(trial);
    REQUIRE(servo.end() == ServoEnd::kConverged);
    const ServoRow& row = servo.rows()[static_cast<std::size_t>(from)];
    CHECK(row.held);
    for (Eigen::Index i = 0; i < 4; ++i) {
      const double wrong = (row.points.row(i) - seen.row(i)).norm();
      if (i == point) {
        CHECK(wrong > 0.0);
        CHECK(wrong < 1.0);  // by the second derivative of the motion
      } else {
        CHECK(wrong == 0.0);
      }
    }
    CHECK_FALSE(servo.rows()[static_cast<std::size_t>(from + gap)].held);
  }
}

TEST_CASE("points that take turns to be missing do not end the loop, one that stays away does") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.1, -0.05, 0.2}, {0.03, 0.02, -0.05});
  const Loop start = loop;
  loop.spoil = [](ServoSight& sight, int k) {
    if (k > 5 && k < 60) sight.missing = {k % 4};
  };
  const VisualServo turns = loop.run();
  CHECK(turns.end() == ServoEnd::kConverged);
  CHECK(turns.rows()[59].held);
  CHECK_FALSE(turns.rows().back().held);  // a predicted point does not end it
  loop = start;
  loop.spoil = [](ServoSight& sight, int k) {
    if (k > 5) sight.missing = {2};
    if (k > 8) sight.missing = {0, 2};
    sight.lost = "too dark";
  };
  const VisualServo one = loop.run();
  CHECK(one.end() == ServoEnd::kFeatureLost);
  CHECK(one.why() ==
        "point 2 was not found in 6 pictures one after the other; at most 5 are bridged: too dark");
  CHECK(one.rows().size() == 12);
  loop = start;
  loop.spoil = [](ServoSight& sight, int k) {
    if (k < 3) sight.missing = {1};
  };
  const VisualServo late = loop.run();  // there is nothing to predict from
  CHECK(late.end() == ServoEnd::kConverged);
  CHECK(late.rows().front().t == doctest::Approx(0.12));
  CHECK_FALSE(late.rows().front().held);
}

TEST_CASE("a row that ends the loop has the singular values of its points") {
  for (const ServoLaw law : {ServoLaw::kCurrent, ServoLaw::kDesired, ServoLaw::kMean,
                             ServoLaw::kPosition, ServoLaw::kHybrid}) {
    CAPTURE(static_cast<int>(law));
    Loop loop;
    loop.options.law = law;
    loop.knows_points = law >= ServoLaw::kPosition;
    loop.T = displaced(loop.wanted, {0.1, -0.05, 0.2}, {0.03, 0.02, -0.05});
    const Loop start = loop;
    loop.spoil = [](ServoSight& sight, int k) {
      if (k >= 10) sight.pixels.reset();
    };
    const VisualServo lost = loop.run();
    REQUIRE(lost.end() == ServoEnd::kFeatureLost);
    const std::vector<ServoRow>& rows = lost.rows();
    // The points are predicted in the last seven rows, and move by a few pixels from row to row.
    for (std::size_t i = rows.size() - 7; i < rows.size(); ++i) {
      CHECK(rows[i].smallest == doctest::Approx(rows[i - 1].smallest).epsilon(0.05));
      CHECK(rows[i].condition == doctest::Approx(rows[i - 1].condition).epsilon(0.05));
    }
    for (const double outside : {-1.0, 1e4, 1e300}) {
      loop = start;
      loop.spoil = [outside](ServoSight& sight, int k) {
        if (k == 10) (*sight.pixels)(2, 0) = outside;
      };
      const VisualServo out = loop.run();
      REQUIRE(out.end() == ServoEnd::kOutOfImage);
      CHECK(out.rows().size() == 11);
      CHECK(out.rows().back().smallest > 0.0);
      CHECK(out.rows().back().condition >= 1.0);
      CHECK(std::isfinite(out.rows().back().condition));
    }
  }
}

TEST_CASE("a picture that no pose gives ends in a local minimum") {
  Loop loop;
  ServoGoal goal = loop.goal();
  goal.wanted(0, 0) += 30.0;  // no longer the picture of a square
  VisualServo servo(loop.lens, goal, loop.arm, loop.options);
  VectorXd qd = VectorXd::Zero(6);
  for (int k = 0; servo.end() == ServoEnd::kNone; ++k) {
    const Seen seen = *seen_by(loop.lens, loop.T, loop.points);
    qd = servo.look({.t = 0.04 * k,
                     .pixels = seen.pixels,
                     .J_camera = loop.J,
                     .q = VectorXd::Zero(6),
                     .qd = qd,
                     .depths = seen.depths});
    loop.T = loop.T * pose_exp(Vector6d(0.04 * qd));
  }
  CHECK(servo.end() == ServoEnd::kLocalMinimum);
  CHECK(servo.rows().back().error > 1.0);
  CHECK(servo.rows().back().error < 30.0);
}

TEST_CASE("a joint limit ends the loop of an arm that cannot avoid it") {
  Loop loop;
  loop.T = displaced(loop.wanted, Vector3d::Zero(), {0.06, 0, 0});
  loop.arm.lower[0] = -0.03;  // half of the travel back
  loop.arm.turns.assign(6, false);
  const VisualServo servo = loop.run();
  CHECK(servo.end() == ServoEnd::kJointLimit);
  CHECK(loop.q[0] >= -0.03);
  CHECK(loop.q[0] < -0.0299);
  CHECK(servo.why().find("joint 1 ") == 0);
  CHECK(servo.why().find(" its limit of -30 mm") != std::string::npos);
}

TEST_CASE("an arm with a joint to spare goes on at a joint limit, and keeps away from it") {
  Random random(37);
  for (int trial = 0; trial < 50; ++trial) {
    CAPTURE(trial);
    Loop loop;
    loop.arm = free_arm(7);
    loop.J = MatrixXd::Zero(6, 7);
    loop.J.leftCols(6).setIdentity();
    loop.J.col(6) = 0.7 * Vector6d::Unit(0) + 0.2 * Vector6d::Unit(1);
    loop.q = VectorXd::Zero(7);
    loop.arm.lower[0] = -0.03;
    loop.arm.upper[0] = 0.5;
    loop.T = displaced(loop.wanted, any_vector(random, 0.1), {0.08, 0.01, -0.02});
    const VisualServo servo = loop.run();
    CHECK(servo.end() == ServoEnd::kConverged);
    CHECK(loop.q[0] >= -0.03);
    CHECK((loop.wanted.inverse() * loop.T).translation().norm() < 1e-4);
  }
}

TEST_CASE("speeds of joints are scaled alike where one is too fast") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.1, 0.05, 0.3}, {0.04, 0.02, 0.05});
  const Vector6d asked = Loop(loop).run().rows().front().twist;
  loop.arm.max_speed = VectorXd::Constant(6, 0.05);
  const VisualServo servo = loop.run();
  const Vector6d first = servo.rows().front().twist;
  CHECK(first.lpNorm<Eigen::Infinity>() == doctest::Approx(0.05));
  CHECK((first.normalized() - asked.normalized()).norm() < 1e-9);
  for (const ServoRow& row : servo.rows())
    CHECK(row.qd.lpNorm<Eigen::Infinity>() <= 0.05 * (1 + 1e-12));
  CHECK(servo.end() == ServoEnd::kConverged);
}

TEST_CASE("points near the edge slow the camera down instead of leaving the picture") {
  Loop loop = from_turn(ServoLaw::kDesired, 150 * kDegree);  // advances until they would leave
  const VisualServo servo = loop.run();
  CHECK(servo.end() == ServoEnd::kOutOfImage);
  for (const ServoRow& row : servo.rows()) {
    for (Eigen::Index i = 0; i < 4; ++i) CHECK(loop.lens.is_inside(row.points.row(i).transpose()));
  }
  CHECK(servo.why().find("the law moves it out by") != std::string::npos);
  // A point that is given outside ends the loop at once.
  Loop outside;
  outside.spoil = [](ServoSight& sight, int) { (*sight.pixels)(2, 0) = 640.0; };
  const VisualServo at_once = outside.run();
  CHECK(at_once.end() == ServoEnd::kOutOfImage);
  CHECK(at_once.why().find("point 2 is at (640.0, ") == 0);
}

TEST_CASE("points on a line do not determine the motion") {
  Loop loop;
  loop.points = ObjectPoints{{-0.1, 0, 0}, {-0.03, 0, 0}, {0.04, 0, 0}, {0.1, 0, 0}};
  loop.T = displaced(loop.wanted, {0.05, 0, 0.1}, {0.02, 0.01, 0});
  const VisualServo servo = loop.run();
  CHECK(servo.end() == ServoEnd::kSingular);
  CHECK(servo.why().find("determines 5 of 6 directions") != std::string::npos);
}

TEST_CASE("an arm that loses a direction of motion ends the loop") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.05, 0, 0.1}, {0.02, 0.01, 0});
  loop.J(4, 4) = 1e-5;
  const VisualServo servo = loop.run();
  CHECK(servo.end() == ServoEnd::kSingular);
  CHECK(servo.why().find("in 5 directions of 6") != std::string::npos);
}

TEST_CASE("an arm of four joints says what it cannot control") {
  // Moves along three axes and rotates about the optical one.
  Loop loop;
  loop.arm = free_arm(4);
  loop.J = MatrixXd::Zero(6, 4);
  loop.J.topLeftCorner(3, 3).setIdentity();
  loop.J(5, 3) = 1.0;
  loop.q = VectorXd::Zero(4);
  const Loop start = loop;
  loop.T = displaced(loop.wanted, {0, 0, 0.3}, {0.03, 0.02, 0.05});
  const VisualServo level = loop.run();
  CHECK(level.end() == ServoEnd::kConverged);
  const MatrixXd blind = level.uncontrollable();
  REQUIRE(blind.cols() == 2);
  CHECK((blind.transpose() * blind - MatrixXd::Identity(2, 2)).norm() < 1e-9);
  CHECK(level.explanation().find("in 6 directions, this arm in 4 (rank of L J)") !=
        std::string::npos);
  CHECK(
      level.explanation().find(
          "The joints cannot rotate the camera about its x axis or rotate it about its y axis.") !=
      std::string::npos);

  loop = start;
  loop.T = displaced(loop.wanted, {0.1, 0, 0}, {0, 0, 0});
  const VisualServo tilted = loop.run();
  CHECK(tilted.end() == ServoEnd::kLocalMinimum);
  // What is left lies in the directions that are not controlled, but for what bends.
  const ServoRow& last = tilted.rows().back();
  const PlanePoints rest = last.points - loop.goal().wanted;
  const Eigen::Map<const VectorXd> error(rest.data(), 8);
  const MatrixXd B = tilted.uncontrollable();
  CHECK((B * (B.transpose() * error)).norm() > 0.5 * error.norm());
}

TEST_CASE("a smooth start begins at rest and ends the same") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.1, -0.05, 0.2}, {0.03, 0.02, -0.05});
  const Loop start = loop;
  loop.options.smooth = 4.0;
  const VisualServo servo = loop.run();
  CHECK(servo.rows().front().twist.norm() < 1e-12);
  CHECK(servo.rows()[5].twist.norm() > 0.0);
  CHECK(servo.end() == ServoEnd::kConverged);
  CHECK(Loop(start).run().rows().front().twist.norm() > 0.1);
}

TEST_CASE("the adaptive gain needs fewer pictures than its smallest value alone") {
  Loop loop;
  loop.T = displaced(loop.wanted, {0.1, -0.05, 0.2}, {0.03, 0.02, -0.05});
  const Loop start = loop;
  loop.options.gain = {4.0, 0.4, 30.0};
  const std::size_t adaptive = loop.run().rows().size();
  loop = start;
  loop.options.gain = {0.4, 0.4, 30.0};
  CHECK(2 * adaptive < loop.run().rows().size());
}

TEST_CASE("what cannot be servoed is refused with its numbers") {
  const Loop loop;
  const auto refused = [&](const std::function<void(ServoGoal&, ServoOptions&)>& change) {
    ServoGoal goal = loop.goal();
    ServoOptions options = loop.options;
    change(goal, options);
    return refusal_of([&] { VisualServo(loop.lens, goal, loop.arm, options); });
  };
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused([](ServoGoal& goal, ServoOptions&) {
          goal.wanted.conservativeResize(3, 2);
          goal.depths = VectorXd::Ones(1);
        }) == "3 points are wanted; expected 4 to 200.");
  CHECK(refused([](ServoGoal& goal, ServoOptions&) {
          goal.wanted(2, 0) = 700.0;
        }).find("Point 2 is wanted at (700, ") == 0);
  CHECK(refused([](ServoGoal& goal, ServoOptions&) { goal.depths = VectorXd::Ones(3); }) ==
        "There are 3 depths for 4 points; expected one or as many.");
  CHECK(refused([](ServoGoal& goal, ServoOptions&) { goal.depths.resize(0); }) ==
        "Neither the depth of the points is given, nor the points of the object.");
  CHECK(refused([](ServoGoal&, ServoOptions& options) { options.law = ServoLaw::kHybrid; }) ==
        "The laws \"position\" and \"hybrid\" need the points of the object.");
  CHECK(refused([](ServoGoal&, ServoOptions& options) {
          options.gain = {60.0, 1.0, 1.0};
        }) ==
        "A gain of 60 1/s with a period of 0.04 s does not settle: their product is 2.4, and has "
        "to be below 2, better below 1.");
  CHECK(refused([](ServoGoal& goal, ServoOptions&) { goal.points = square().topRows(3); }) ==
        "3 points of the object are given and 4 are wanted in the picture.");
  CHECK_FALSE(refused([](ServoGoal& goal, ServoOptions&) {
                goal.points = square();
                goal.points(0, 2) = 0.1;
              }).empty());
  for (double ServoOptions::*number : {&ServoOptions::period, &ServoOptions::within,
                                       &ServoOptions::timeout, &ServoOptions::smooth}) {
    CHECK_FALSE(
        refused([&](ServoGoal&, ServoOptions& options) { options.*number = nothing; }).empty());
    CHECK_FALSE(
        refused([&](ServoGoal&, ServoOptions& options) { options.*number = -1.0; }).empty());
  }
  CHECK_FALSE(
      refused([&](ServoGoal&, ServoOptions& options) { options.gain.at_zero = nothing; }).empty());
  CHECK_FALSE(
      refused([&](ServoGoal& goal, ServoOptions&) { goal.wanted(1, 1) = nothing; }).empty());
  CHECK_FALSE(refused([&](ServoGoal& goal, ServoOptions&) { goal.depths[1] = nothing; }).empty());
  CHECK_FALSE(refused([](ServoGoal& goal, ServoOptions&) { goal.depths[1] = 0.0; }).empty());
}

TEST_CASE("a picture that does not fit is refused, and the loop stays as it was") {
  Loop loop;
  VisualServo servo(loop.lens, loop.goal(), loop.arm, loop.options);
  const Seen seen = *seen_by(loop.lens, above(0.5, 0.1), loop.points);
  const ServoSight good{
      .pixels = seen.pixels, .J_camera = loop.J, .q = VectorXd::Zero(6), .qd = VectorXd::Zero(6)};
  ServoSight few = good;
  few.pixels = PlanePoints(seen.pixels.topRows(3));
  CHECK(refusal_of([&] { servo.look(few); }) == "3 points are seen and 4 are wanted.");
  ServoSight nothing = good;
  (*nothing.pixels)(0, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(refusal_of([&] { servo.look(nothing); }).empty());
  ServoSight joints = good;
  joints.q = VectorXd::Zero(5);
  CHECK_FALSE(refusal_of([&] { servo.look(joints); }).empty());
  CHECK(servo.rows().empty());
  servo.look(good);
  CHECK(servo.rows().size() == 1);
  servo.finish(ServoEnd::kJointLimit, "joint 1 is at its limit");
  servo.finish(ServoEnd::kConverged, "no");
  CHECK(servo.end() == ServoEnd::kJointLimit);
  CHECK(servo.explanation().find("JointLimit: joint 1 is at its limit.") == 0);
  CHECK_FALSE(refusal_of([&] { servo.look(good); }).empty());
}
