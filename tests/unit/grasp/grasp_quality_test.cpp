#include "armlet/grasp/grasp_quality.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/rotation.hpp"

using namespace armlet;

namespace {

using Eigen::Vector3d;

std::vector<GraspContact> on_sphere(const std::vector<Vector3d>& directions, double radius,
                                    double friction) {
  std::vector<GraspContact> contacts;
  for (const Vector3d& each : directions) {
    const Vector3d n = each.normalized();
    contacts.push_back({radius * n, -n, friction});
  }
  return contacts;
}

// Evenly around the z axis.
std::vector<Vector3d> around(int count) {
  std::vector<Vector3d> all;
  for (int i = 0; i < count; ++i)
    all.push_back({std::cos(2.0 * kPi * i / count), std::sin(2.0 * kPi * i / count), 0.0});
  return all;
}

const std::vector<Vector3d> kTetrahedron = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

// Of every plane through as many points as there are dimensions that has all others on one side.
double ball_by_trying(const Eigen::MatrixXd& points) {
  const int d = static_cast<int>(points.rows()), n = static_cast<int>(points.cols());
  double least = std::numeric_limits<double>::infinity();
  std::vector<int> chosen(static_cast<std::size_t>(d));
  const auto look = [&] {
    Eigen::MatrixXd edges(d - 1, d);
    for (int i = 1; i < d; ++i)
      edges.row(i - 1) = (points.col(chosen[static_cast<std::size_t>(i)]) - points.col(chosen[0]));
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(edges);
    if (lu.rank() < d - 1) return;
    Eigen::VectorXd normal = lu.kernel().col(0).normalized();
    double offset = normal.dot(points.col(chosen[0]));
    const Eigen::RowVectorXd along = normal.transpose() * points;
    if (along.maxCoeff() <= offset + 1e-9) least = std::min(least, offset);
    if (along.minCoeff() >= offset - 1e-9) least = std::min(least, -offset);
  };
  const auto choose = [&](auto&& self, int from, int count) -> void {
    if (count == d) return look();
    for (int i = from; i < n; ++i) {
      chosen[static_cast<std::size_t>(count)] = i;
      self(self, i + 1, count + 1);
    }
  };
  choose(choose, 0, 0);
  return std::max(least, 0.0);
}

}  // namespace

TEST_CASE("the ball in a cube and in a cross of any dimension is the one of the textbook") {
  for (int d = 2; d <= 6; ++d) {
    CAPTURE(d);
    Eigen::MatrixXd cube(d, 1 << d), cross(d, 2 * d);
    for (int k = 0; k < (1 << d); ++k) {
      for (int i = 0; i < d; ++i) cube(i, k) = (k >> i & 1) != 0 ? 3.0 : -3.0;
    }
    cross << Eigen::MatrixXd::Identity(d, d), -Eigen::MatrixXd::Identity(d, d);
    CHECK(ball_in_hull(cube) == doctest::Approx(3.0).epsilon(1e-6));
    CHECK(ball_in_hull(cross) == doctest::Approx(1.0 / std::sqrt(d)).epsilon(1e-6));
    CHECK(ball_in_hull(cube.colwise() + Eigen::VectorXd::Constant(d, 4.0)) == 0.0);
    cross.row(0).setZero();  // flat
    CHECK(ball_in_hull(cross) == 0.0);
  }
}

TEST_CASE("the ball in a hull is that of all its planes tried one by one") {
  Random random(91);
  int inside = 0;
  for (int round = 0; round < 300; ++round) {
    const int d = 2 + static_cast<int>(random.below(5));
    const int n = d + 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(d + 3)));
    Eigen::MatrixXd points(d, n);
    for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = random.uniform(-1.0, 1.0);
    const double expected = ball_by_trying(points);
    CAPTURE(round);
    CHECK(std::abs(ball_in_hull(points) - expected) < 2e-6);
    if (expected > 0.0) ++inside;
  }
  CHECK(inside > 50);
}

// The hull of what k evenly placed contacts exert on a disc of radius 1 is a twisted prism: a ring
// of k points with the moment m, rotated by atan m from the inward normals, and one with -m
// in the opposite direction. Its top is m from the middle; the planes of its sides are worked out
// by hand.
double disc_by_hand(int k, double m) {
  const double phi = std::atan(m), half = kPi / k, r = std::sqrt(1.0 + m * m);
  const double c = r * (std::cos(half) - std::cos(2.0 * phi - half)) / (2.0 * m);
  const double d = r * (std::cos(half) + std::cos(2.0 * phi - half)) / 2.0;
  return std::min(m, d / std::sqrt(1.0 + c * c));
}

TEST_CASE("two, three and four contacts on a disc hold as well as worked out by hand") {
  for (const double m : {0.2, 0.5, 0.8}) {
    CAPTURE(m);
    CHECK(disc_by_hand(2, m) == doctest::Approx(m / std::sqrt(m * m + 2.0)));
    for (const int k : {2, 3, 4}) {
      CAPTURE(k);
      const auto quality =
          planar_grasp_quality(on_sphere(around(k), 0.04, m), Eigen::Vector2d::Zero(), 0.04);
      CHECK(quality.epsilon == doctest::Approx(disc_by_hand(k, m)).epsilon(1e-6));
      CHECK(quality.force_closure);
      CHECK(quality.contacts == k);
      // G G' = diag(k, k, k): half of each force acts along x and y, and friction alone has a
      // moment.
      const double along = k == 2 ? std::sqrt(2.0) : std::sqrt(k);
      CHECK(quality.min_singular == doctest::Approx(along));
    }
  }
  CHECK(disc_by_hand(2, 0.5) == doctest::Approx(1.0 / 3.0));
}

TEST_CASE("contacts without friction cannot hold a disc against rotation") {
  for (const int k : {2, 3, 4}) {
    const auto quality =
        planar_grasp_quality(on_sphere(around(k), 0.04, 0.0), Eigen::Vector2d::Zero(), 0.04);
    CHECK(quality.epsilon == 0.0);
    CHECK_FALSE(quality.force_closure);
    CHECK(quality.min_singular == 0.0);
  }
}

TEST_CASE("singular values of grasps of a sphere are those of symmetry") {
  // G G' = diag(k I, sum (I - p p')), moments divided by the radius.
  const auto least = [](const std::vector<Vector3d>& directions) {
    return grasp_quality(on_sphere(directions, 0.05, 0.6), Vector3d::Zero(), 0.05);
  };
  const GraspQuality two = least({{0, 0, 1}, {0, 0, -1}}), three = least(around(3)),
                     four = least(kTetrahedron);
  CHECK(two.min_singular == 0.0);  // nothing rotates it about the line between both
  CHECK(two.epsilon == 0.0);
  CHECK_FALSE(two.force_closure);
  CHECK(three.min_singular == doctest::Approx(std::sqrt(1.5)));
  CHECK(four.min_singular == doctest::Approx(std::sqrt(8.0 / 3.0)));
  CHECK(three.force_closure);
  CHECK(four.force_closure);
  CHECK(four.epsilon > three.epsilon);
}

// With the whole cone, u on the unit sphere: the largest u . w of a contact is in closed form, and
// its smallest value over u is epsilon. Any u bounds it from above.
TEST_CASE("no load is withstood less than the ball says, up to what the pyramid leaves out") {
  Random random(1992);
  for (int round = 0; round < 12; ++round) {
    const double friction = random.uniform(0.3, 0.9);
    std::vector<Vector3d> directions = round % 3 == 0 ? around(3) : kTetrahedron;
    if (round % 3 == 2) {
      for (Vector3d& each : directions)
        each += 0.4 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    }
    const auto contacts = on_sphere(directions, 0.03, friction);
    const double epsilon = grasp_quality(contacts, Vector3d::Zero(), 0.03).epsilon;
    const auto withstood = [&](const Vector6d& u) {
      double most = -1e9;
      for (const GraspContact& each : contacts) {
        const Vector3d f = u.head<3>() + u.tail<3>().cross(each.p / 0.03);
        const double pressed = f.dot(each.inward);
        most = std::max(most, pressed + friction * (f - pressed * each.inward).norm());
      }
      return most;
    };
    // A search that takes smaller steps whenever nothing near is lower.
    double best = 1e9;
    for (int start = 0; start < 40; ++start) {
      Vector6d u;
      for (int i = 0; i < 6; ++i) u[i] = random.uniform(-1.0, 1.0);
      u.normalize();
      double value = withstood(u);
      for (double step = 0.5; step > 1e-5;) {
        bool found = false;
        for (int i = 0; i < 60 && !found; ++i) {
          Vector6d v = u;
          for (int k = 0; k < 6; ++k) v[k] += step * random.uniform(-1.0, 1.0);
          v.normalize();
          const double there = withstood(v);
          if (there >= value) continue;
          u = v;
          value = there;
          found = true;
        }
        if (!found) step *= 0.5;
      }
      best = std::min(best, value);
    }
    CAPTURE(round);
    CHECK(epsilon > 0.0);
    CHECK(epsilon <= best * (1.0 + 1e-6));
    CHECK(epsilon >= best * 0.95);  // the pyramid and the search
  }
}

TEST_CASE("more friction and more contacts never hold worse, and size and position do not matter") {
  Random random(7);
  for (int round = 0; round < 30; ++round) {
    std::vector<Vector3d> directions;
    for (int i = 0; i < 4; ++i)
      directions.push_back({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
    const auto quality = [&](int count, double radius, double friction, const Vector3d& centre) {
      auto contacts = on_sphere({directions.begin(), directions.begin() + count}, radius, friction);
      for (GraspContact& each : contacts) each.p += centre;
      return grasp_quality(contacts, centre, radius).epsilon;
    };
    const double three = quality(3, 0.03, 0.4, Vector3d::Zero());
    const double four = quality(4, 0.03, 0.4, Vector3d::Zero());
    CAPTURE(round);
    CHECK(four >= three - 1e-6);
    CHECK(quality(4, 0.03, 0.7, Vector3d::Zero()) >= four - 1e-6);
    CHECK(quality(4, 2.0, 0.4, {0.4, -0.3, 1.0}) == doctest::Approx(four).epsilon(1e-5));
  }
}

TEST_CASE("a box between two fingers slips when its weight exceeds twice the friction") {
  const std::vector<GraspContact> contacts = {{{0.02, 0, 0}, {-1, 0, 0}, 0.5},
                                              {{-0.02, 0, 0}, {1, 0, 0}, 0.5}};
  const std::vector<double> presses = {4.0, 4.0};
  const auto factor = [&](double weight, const std::vector<double>& with) {
    Vector6d load = Vector6d::Zero();
    load[2] = -weight;
    return load_factor(contacts, with, Vector3d::Zero(), 0.02, load);
  };
  // mu N of each of both, straight along an edge of the pyramid: 4 N in all.
  CHECK(factor(4.0, presses) == doctest::Approx(1.0).epsilon(1e-4));
  CHECK(factor(8.0, presses) == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(factor(1.0, presses) == doctest::Approx(4.0).epsilon(1e-4));
  // One finger that presses less limits the other one: they push against each other.
  CHECK(factor(4.0, {4.0, 2.0}) == doctest::Approx(0.5).epsilon(1e-4));
  CHECK(factor(4.0, {4.0, 0.0}) == doctest::Approx(0.0));
  Vector6d turning = Vector6d::Zero();
  turning[3] = 0.01;  // about the line between both: points cannot
  CHECK(load_factor(contacts, presses, Vector3d::Zero(), 0.02, turning) < 1e-5);
  CHECK(load_factor(contacts, presses, Vector3d::Zero(), 0.02, Vector6d::Zero()) >= 1.0);
}

TEST_CASE("a body that rests on contacts from below needs no friction") {
  std::vector<GraspContact> contacts;
  for (const Vector3d& each : around(3)) contacts.push_back({0.03 * each, {0, 0, 1}, 0.0});
  Vector6d load = Vector6d::Zero();
  load[2] = -6.0;
  const std::vector<double> presses = {3.0, 3.0, 3.0};
  CHECK(load_factor(contacts, presses, Vector3d::Zero(), 0.03, load) ==
        doctest::Approx(1.5).epsilon(1e-4));
}

TEST_CASE("no contacts hold nothing, and impossible ones are refused") {
  const GraspQuality none = grasp_quality({}, Vector3d::Zero(), 0.02);
  CHECK(none.epsilon == 0.0);
  CHECK(none.min_singular == 0.0);
  CHECK(none.contacts == 0);
  CHECK_FALSE(none.force_closure);
  std::vector<GraspContact> contacts = {{{0.02, 0, 0}, {-1, 0, 0}, 0.5}};
  CHECK_THROWS_AS((void)grasp_quality(contacts, Vector3d::Zero(), 0.0), ArgumentError);
  contacts[0].friction = -0.1;
  CHECK_THROWS_AS((void)grasp_quality(contacts, Vector3d::Zero(), 0.02), ArgumentError);
  contacts[0] = {{0.02, 0, 0}, {-2, 0, 0}, 0.5};
  CHECK_THROWS_AS((void)grasp_quality(contacts, Vector3d::Zero(), 0.02), ArgumentError);
  contacts[0] = {{std::nan(""), 0, 0}, {-1, 0, 0}, 0.5};
  CHECK_THROWS_AS((void)grasp_quality(contacts, Vector3d::Zero(), 0.02), ArgumentError);
}
