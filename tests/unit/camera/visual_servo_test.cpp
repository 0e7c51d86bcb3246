#include "armlet/camera/visual_servo.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "servo_loop.hpp"

using namespace armlet;
using namespace armlet::servoing;

// Closed forms for a rotation about the optical axis over a symmetric target, to 4 digits and more.
TEST_CASE("the first twist of a rotation about the optical axis is that of each law") {
  const double gain = 0.7, Z = 0.5;
  for (const double turn : {0.1, 0.4, 0.8}) {
    CAPTURE(turn);
    const auto first = [&](ServoLaw law) {
      Loop loop = from_turn(law, turn);
      loop.options.gain = {gain, gain, 1.0};
      return loop.run().rows().front().twist;
    };
    const auto check = [&](ServoLaw law, double v_z, double w_z) {
      const Vector6d twist = first(law);
      CHECK(twist[2] == doctest::Approx(v_z).epsilon(1e-6).scale(1.0));
      CHECK(twist[5] == doctest::Approx(-w_z).epsilon(1e-6).scale(1.0));
      CHECK(twist.head<2>().norm() + twist.segment<2>(3).norm() < 1e-6);
    };
    check(ServoLaw::kCurrent, -gain * Z * (1 - std::cos(turn)), gain * std::sin(turn));
    check(ServoLaw::kDesired, gain * Z * (1 - std::cos(turn)), gain * std::sin(turn));
    check(ServoLaw::kMean, 0.0, 2 * gain * std::tan(turn / 2));
    check(ServoLaw::kPosition, 0.0, gain * turn);
    check(ServoLaw::kHybrid, 0.0, gain * turn);
  }
}

TEST_CASE("the interaction matrix at the goal has the known singular values") {
  Loop loop;
  const VisualServo servo = loop.run();
  REQUIRE(servo.end() == ServoEnd::kConverged);
  CHECK(servo.rows().size() == 1);
  CHECK(servo.rows()[0].smallest == doctest::Approx(0.0710).epsilon(1e-3));
  CHECK(servo.rows()[0].condition == doctest::Approx(4.5086 / 0.0710).epsilon(1e-3));
}

TEST_CASE("rotations of 150, 179 and 180 degrees end as they are known to under each law") {
  const auto end_of = [](ServoLaw law, double degrees, Loop& loop) {
    loop = from_turn(law, degrees * kDegree);
    return loop.run();
  };
  Loop loop;
  CHECK(end_of(ServoLaw::kCurrent, 150, loop).end() == ServoEnd::kConverged);
  CHECK(loop.highest == doctest::Approx(2.04).epsilon(0.01));
  CHECK(end_of(ServoLaw::kDesired, 150, loop).end() == ServoEnd::kOutOfImage);
  CHECK(loop.lowest < 0.4);
  for (const ServoLaw law : {ServoLaw::kMean, ServoLaw::kPosition, ServoLaw::kHybrid}) {
    for (const double turn : {150.0, 179.0}) {
      CAPTURE(static_cast<int>(law));
      CHECK(end_of(law, turn, loop).end() == ServoEnd::kConverged);
      CHECK(loop.lowest == doctest::Approx(0.5).epsilon(1e-4));
      CHECK(loop.highest == doctest::Approx(0.5).epsilon(1e-4));
    }
  }
  const VisualServo far = end_of(ServoLaw::kCurrent, 179, loop);
  CHECK(far.end() == ServoEnd::kOutOfImage);
  CHECK(loop.highest > 50.0);
  CHECK(far.why().find("the camera sees from 0.01 m to 50 m") != std::string::npos);

  CHECK(end_of(ServoLaw::kCurrent, 180, loop).end() == ServoEnd::kOutOfImage);
  CHECK(loop.highest > 50.0);
  CHECK(end_of(ServoLaw::kDesired, 180, loop).end() == ServoEnd::kOutOfImage);
  const VisualServo blind = end_of(ServoLaw::kMean, 180, loop);
  CHECK(blind.end() == ServoEnd::kSingular);
  CHECK(blind.rows().size() == 1);
}

TEST_CASE("every law converges from moderate displacements as fast as its gain says") {
  Random random(17);
  for (int trial = 0; trial < 150; ++trial) {
    CAPTURE(trial);
    Loop loop;
    loop.lens = lens_of(350.0);  // no start is outside of the picture
    loop.options.law = static_cast<ServoLaw>(trial % 5);
    loop.knows_points = loop.options.law >= ServoLaw::kPosition || trial % 2 == 0;
    loop.T = displaced(loop.wanted, any_vector(random, 0.12), any_vector(random, 0.05));
    const VisualServo servo = loop.run();
    CHECK(servo.end() == ServoEnd::kConverged);
    // Its error falls by 1 - gain * period in each period.
    const double steps = std::log(servo.rows().front().error / 1e-3) / -std::log(1 - 0.04);
    CHECK(static_cast<double>(servo.rows().size()) == doctest::Approx(steps).epsilon(0.15));
  }
}

TEST_CASE("under noise of one pixel the error stays where theory puts it") {
  // e' = (1 - a) e - a n in the six directions that a camera controls, and n alone in the other
  // two: E |e + n|^2 = sigma^2 (8 + 6 a / (2 - a)).
  for (const double gain : {5.0, 12.5}) {
    Random random(23);
    Loop loop;
    loop.options.law = ServoLaw::kDesired;
    loop.options.gain = {gain, gain, 1.0};
    loop.options.within = 1e-6;
    loop.options.timeout = 800.0;
    loop.spoil = [&](ServoSight& sight, int) {
      *sight.pixels += PlanePoints::NullaryExpr(4, 2, [&] { return noise(random); });
    };
    const VisualServo servo = loop.run();
    CHECK(servo.end() == ServoEnd::kTimeout);
    double sum = 0.0;
    for (const ServoRow& row : servo.rows()) sum += row.error * row.error;
    const double a = gain * loop.options.period;
    const double theory = 8 + 6 * a / (2 - a);
    CHECK(sum / static_cast<double>(servo.rows().size()) == doctest::Approx(theory).epsilon(0.03));
  }
}

TEST_CASE("half and twice the depth change the speed only") {
  Random random(29);
  for (int trial = 0; trial < 40; ++trial) {
    CAPTURE(trial);
    const Vector3d rotation = any_vector(random, 0.12), translation = any_vector(random, 0.05);
    for (const double factor : {0.5, 1.0, 2.0}) {
      Loop loop;
      loop.lens = lens_of(350.0);
      loop.options.law = ServoLaw::kDesired;
      loop.knows_depths = false;
      loop.depth_factor = factor;
      loop.T = displaced(loop.wanted, rotation, translation);
      CHECK(loop.run().end() == ServoEnd::kConverged);
      CHECK((loop.wanted.inverse() * loop.T).translation().norm() < 1e-4);
    }
  }
}

TEST_CASE("a fifth of the depth takes points out of the picture where the right one does not") {
  int left = 0, converged = 0;
  Random random(31);
  for (int trial = 0; trial < 200; ++trial) {
    Loop loop;
    loop.options.law = ServoLaw::kDesired;
    loop.knows_depths = false;
    loop.T = displaced(loop.wanted, any_vector(random, 0.4), any_vector(random, 0.2));
    const Loop start = loop;
    if (loop.run().end() != ServoEnd::kConverged) continue;
    ++converged;
    loop = start;
    loop.depth_factor = 0.2;
    if (loop.run().end() == ServoEnd::kOutOfImage) ++left;
  }
  CHECK(converged >= 20);
  CHECK(left >= 5);
}
