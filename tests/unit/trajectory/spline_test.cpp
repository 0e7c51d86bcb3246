#include "armlet/trajectory/spline.hpp"

#include <doctest/doctest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <random>

#include "armlet/core/error.hpp"
#include "armlet/trajectory/profile.hpp"

using namespace armlet;

namespace {

struct Points {
  std::vector<double> t, q;
  PathEnds ends{};
};

Points random_points(std::mt19937_64& generator, std::size_t count) {
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
  Points points{.t = {0.0}, .q = {2.0 * number() - 1.0}};
  while (points.t.size() < count) {
    points.t.push_back(points.t.back() + 0.3 + number());
    points.q.push_back(2.0 * number() - 1.0);
  }
  points.ends = {number(), -number(), 2.0 * number(), -2.0 * number()};
  return points;
}

// The highest order up to which one-sided derivatives agree at every inner knot.
int smoothness(const std::vector<Segment>& pieces) {
  for (int order = 0; order <= Segment::kMaxDegree; ++order) {
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      const double before = pieces[i].value(pieces[i].duration, order);
      const double behind = pieces[i + 1].value(0.0, order);
      if (std::abs(before - behind) > 1e-8 * (1.0 + std::abs(before))) return order - 1;
    }
  }
  return Segment::kMaxDegree;
}

void check_ends(const std::vector<Segment>& pieces, const Points& points, bool accelerations) {
  const Segment& first = pieces.front();
  const Segment& last = pieces.back();
  CHECK(first.value(0.0, 1) == doctest::Approx(points.ends.v_start).epsilon(1e-11).scale(1.0));
  CHECK(last.value(last.duration, 1) ==
        doctest::Approx(points.ends.v_end).epsilon(1e-11).scale(1.0));
  if (!accelerations) return;
  CHECK(first.value(0.0, 2) == doctest::Approx(points.ends.a_start).epsilon(1e-11).scale(1.0));
  CHECK(last.value(last.duration, 2) ==
        doctest::Approx(points.ends.a_end).epsilon(1e-10).scale(1.0));
}

// The value at time t of pieces that may be finer than the points.
double at(const std::vector<Segment>& pieces, double t) {
  std::size_t k = 0;
  while (k + 1 < pieces.size() && pieces[k + 1].start <= t) ++k;
  return pieces[k].value(std::min(t - pieces[k].start, pieces[k].duration));
}

double integral_of_square(const std::vector<Segment>& pieces, int order) {
  double sum = 0.0;
  constexpr int kSteps = 2000;
  for (const Segment& piece : pieces) {
    for (int k = 0; k < kSteps; ++k) {
      const double value = piece.value((k + 0.5) / kSteps * piece.duration, order);
      sum += value * value * piece.duration / kSteps;
    }
  }
  return sum;
}

}  // namespace

// Speeds at the points from SciPy 1.10, CubicSpline(t, q, bc_type='clamped').
TEST_CASE("a clamped spline has the speeds that SciPy computes") {
  const std::array t{0.0, 1.0, 2.5, 3.0, 4.2};
  const std::array q{0.0, 1.0, 0.5, 2.0, 1.0};
  const std::array v{0.0, 0.199389, 2.503054, 1.925393, 0.0};
  const std::vector<Segment> pieces = cubic_spline(t, q);
  REQUIRE(pieces.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(pieces[i].value(0.0, 1) == doctest::Approx(v[i]).epsilon(1e-6));
  }
}

// Worked out in whole fractions (Gaussian elimination over Python's fractions.Fraction), from the
// definition alone: one polynomial of degree 5 for each leg, written in powers of the time since
// its start; 8 values at its ends, speed and acceleration zero at both ends, and derivatives 1 to 4
// equal on both sides of the three inner points are 24 equations for the 24 coefficients.
TEST_CASE("a quintic spline has the derivatives that an exact solution gives") {
  const std::array t{0.0, 1.0, 2.5, 3.0, 4.2};
  const std::array q{0.0, 1.0, 0.5, 2.0, 1.0};
  const std::array v{38306715955.0 / 84504550932.0, 2055319682635.0 / 676036407456.0,
                     16343810655.0 / 9389394548.0};
  const std::array a{-700071228125.0 / 126756826398.0, 1192506394385.0 / 253513652796.0,
                     -125649622715.0 / 14084091822.0};
  const std::array jerk{-84866014535.0 / 14084091822.0, -162662900530.0 / 7042045911.0,
                        -478655085725.0 / 42252275466.0};
  const std::array middle{1390773238643.0 / 4056218444736.0, 1656980620591.0 / 14422110025728.0,
                          173288843892595.0 / 129798990231552.0, 1221104958327.0 / 751151563840.0};
  const std::vector<Segment> pieces = quintic_spline(t, q, {});
  REQUIRE(pieces.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(pieces[i].value(0.5 * pieces[i].duration) == doctest::Approx(middle[i]).epsilon(1e-13));
    if (i == 0) continue;
    CHECK(pieces[i].value(0.0, 1) == doctest::Approx(v[i - 1]).epsilon(1e-12));
    CHECK(pieces[i].value(0.0, 2) == doctest::Approx(a[i - 1]).epsilon(1e-12));
    CHECK(pieces[i].value(0.0, 3) == doctest::Approx(jerk[i - 1]).epsilon(1e-12));
  }
}

// Likewise: degrees 4, 3, 3 and 4, and derivatives 1 and 2 equal at the inner points.
TEST_CASE("a spline with quartic ends has the derivatives that an exact solution gives") {
  const std::array t{0.0, 1.0, 2.5, 3.0, 4.2};
  const std::array q{0.0, 1.0, 0.5, 2.0, 1.0};
  const std::array v{37.0 / 45.0, 239.0 / 90.0, 59.0 / 45.0};
  const std::array a{-106.0 / 15.0, 428.0 / 45.0, -134.0 / 9.0};
  const std::array middle{47.0 / 180.0, 13.0 / 32.0, 1921.0 / 1440.0, 1693.0 / 1200.0};
  const std::vector<Segment> pieces = quartic_spline(t, q, {});
  REQUIRE(pieces.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(pieces[i].value(0.5 * pieces[i].duration) == doctest::Approx(middle[i]).epsilon(1e-13));
    if (i == 0) continue;
    CHECK(pieces[i].value(0.0, 1) == doctest::Approx(v[i - 1]).epsilon(1e-13));
    CHECK(pieces[i].value(0.0, 2) == doctest::Approx(a[i - 1]).epsilon(1e-13));
  }
}

TEST_CASE("position, speed and acceleration agree on both sides of every point") {
  std::mt19937_64 generator(5);
  const auto number = [&] { return static_cast<double>(generator() >> 11) * 0x1.0p-53; };
  for (int k = 0; k < 100; ++k) {
    std::vector<double> t = {0.0};
    std::vector<double> q = {number()};
    const std::size_t points = 2 + generator() % 12;
    while (t.size() < points) {
      t.push_back(t.back() + 0.1 + number());
      q.push_back(2.0 * number() - 1.0);
    }
    const std::vector<Segment> pieces = cubic_spline(t, q, 0.3, -0.4);
    CHECK(pieces.front().value(0.0, 1) == 0.3);
    CHECK(pieces.back().value(pieces.back().duration, 1) == doctest::Approx(-0.4).epsilon(1e-9));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      CHECK(pieces[i].value(0.0) == q[i]);
      CHECK(pieces[i].value(pieces[i].duration) == doctest::Approx(q[i + 1]).epsilon(1e-12));
      if (i + 1 == pieces.size()) continue;
      for (int order = 1; order <= 2; ++order) {
        CHECK(pieces[i].value(pieces[i].duration, order) ==
              doctest::Approx(pieces[i + 1].value(0.0, order)).epsilon(1e-9).scale(10.0));
      }
    }
  }
}

TEST_CASE("points that make no spline are refused") {
  const std::array one{0.0};
  const std::array late{0.1, 0.2};
  const std::array equal{0.0, 0.0};
  const std::array q{1.0, 2.0};
  CHECK_THROWS_AS((void)cubic_spline(one, one), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(one, q), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(late, q), ArgumentError);
  CHECK_THROWS_AS((void)cubic_spline(equal, q), ArgumentError);
}

TEST_CASE("every curve goes through its points and is as smooth as it promises") {
  std::mt19937_64 generator(6);
  using Curve =
      std::vector<Segment> (*)(std::span<const double>, std::span<const double>, const PathEnds&);
  const struct {
    Curve curve;
    int smooth;
    bool four;
    bool accelerations;
  } curves[] = {{cubic_interpolator, 1, false, false},
                {quartic_spline, 2, false, true},
                {quintic_spline, 4, false, true},
                {path_353, 2, true, true},
                {path_five_cubics, 2, true, true}};
  for (const auto& [curve, smooth, four, accelerations] : curves) {
    const auto& shown = smooth;  // clang 14 captures no binding
    CAPTURE(shown);
    for (int k = 0; k < 200; ++k) {
      const Points points = random_points(generator, four ? 4 : 3 + generator() % 10);
      const std::vector<Segment> pieces = curve(points.t, points.q, points.ends);
      CHECK(smoothness(pieces) == smooth);
      check_ends(pieces, points, accelerations);
      for (std::size_t i = 0; i < points.t.size(); ++i) {
        CHECK(std::abs(at(pieces, points.t[i]) - points.q[i]) < 1e-11);
      }
    }
  }
}

TEST_CASE("points and times in reverse give the same curve backwards") {
  std::mt19937_64 generator(16);
  for (const auto curve : {quartic_spline, quintic_spline, path_353, path_five_cubics}) {
    for (int k = 0; k < 50; ++k) {
      const Points there = random_points(generator, 4);
      Points back{.q = {there.q.rbegin(), there.q.rend()}};
      for (auto t = there.t.rbegin(); t != there.t.rend(); ++t) {
        back.t.push_back(there.t.back() - *t);
      }
      const auto& e = there.ends;
      back.ends = {-e.v_end, -e.v_start, e.a_end, e.a_start};
      const auto forth = curve(there.t, there.q, there.ends);
      const auto reverse = curve(back.t, back.q, back.ends);
      for (int i = 0; i <= 40; ++i) {
        const double t = there.t.back() * i / 40.0;
        CHECK(std::abs(at(forth, t) - at(reverse, there.t.back() - t)) < 1e-10);
      }
    }
  }
}

// Worked by hand from the 14 conditions; the same as Fu, Gonzalez, Lee, Robotics (1987), section
// 4.3 with this lift-off and set-down.
TEST_CASE("the textbook 4-3-4 has its coefficients") {
  const std::array t{0.0, 0.5, 1.5, 2.0};
  const std::array q{0.0, 0.1, 0.9, 1.0};
  const std::vector<Segment> pieces = quartic_spline(t, q);
  const double s = 8.0 / 15.0;
  const std::array<std::array<double, 5>, 3> c{
      {{0.0, 0.0, 0.0, 2.0 * s, -s}, {0.1, s, 0.8, -s, 0.0}, {0.9, s, -0.8, 0.0, s}}};
  REQUIRE(pieces.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 5; ++k) CHECK(std::abs(pieces[i].c[k] - c[i][k]) < 1e-14);
  }
  CHECK(pieces[1].value(0.5, 1) == doctest::Approx(14.0 / 15.0).epsilon(1e-14));
  CHECK(pieces[1].value(0.0, 2) == doctest::Approx(1.6).epsilon(1e-14));
}

TEST_CASE("the 3-5-3 on the same points has its coefficients") {
  const std::array t{0.0, 0.5, 1.5, 2.0};
  const std::array q{0.0, 0.1, 0.9, 1.0};
  const std::vector<Segment> pieces = path_353(t, q);
  const std::array<std::array<double, 6>, 3> c{{{0.0, 0.0, 0.0, 0.8, 0.0, 0.0},
                                                {0.1, 0.6, 1.2, -2.8, 3.0, -1.2},
                                                {0.9, 0.6, -1.2, 0.8, 0.0, 0.0}}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 6; ++k) CHECK(std::abs(pieces[i].c[k] - c[i][k]) < 1e-13);
  }
  CHECK(pieces[1].value(0.5, 1) == doctest::Approx(0.825).epsilon(1e-14));
}

// Closed form of Fu, Gonzalez, Lee: the coefficients of the fourth powers x and y from two
// equations.
TEST_CASE("the 4-3-4 is the solution of its closed form") {
  std::mt19937_64 generator(17);
  for (int k = 0; k < 200; ++k) {
    const Points p = random_points(generator, 4);
    const auto& [v0, vf, a0, af] = p.ends;
    const double T1 = p.t[1], T2 = p.t[2] - p.t[1], T3 = p.t[3] - p.t[2];
    const double D1 = p.q[1] - p.q[0] - v0 * T1 - 0.5 * a0 * T1 * T1;
    const double D3 = p.q[2] - p.q[3] + vf * T3 - 0.5 * af * T3 * T3;
    const double d = p.q[2] - p.q[1];
    const double V1 = v0 + a0 * T1 + 3.0 * D1 / T1, V2 = vf - af * T3 - 3.0 * D3 / T3;
    Eigen::Matrix2d M;
    M << 6.0 * T1 * T1 + 4.0 * T1 * T1 * T1 / T2, -2.0 * T3 * T3 * T3 / T2,
        -2.0 * T1 * T1 * T1 / T2, 6.0 * T3 * T3 + 4.0 * T3 * T3 * T3 / T2;
    const Eigen::Vector2d r{
        6.0 * d / (T2 * T2) - (4.0 * V1 + 2.0 * V2) / T2 - a0 - 6.0 * D1 / (T1 * T1),
        -6.0 * d / (T2 * T2) + (2.0 * V1 + 4.0 * V2) / T2 - af - 6.0 * D3 / (T3 * T3)};
    const Eigen::Vector2d xy = M.inverse() * r;
    const std::vector<Segment> pieces = quartic_spline(p.t, p.q, p.ends);
    CHECK(pieces[0].c[4] == doctest::Approx(xy[0]).epsilon(1e-9).scale(1.0));
    CHECK(pieces[2].c[4] == doctest::Approx(xy[1]).epsilon(1e-9).scale(1.0));
  }
}

TEST_CASE("the quintic spline has less squared jerk than any other quintic through its points") {
  std::mt19937_64 generator(18);
  for (int k = 0; k < 20; ++k) {
    const Points p = random_points(generator, 4);
    const auto best = quintic_spline(p.t, p.q, p.ends);
    const double least = integral_of_square(best, 3);
    std::vector<Segment> other;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto state = [&](std::size_t j) {
        const bool end = j == 3;
        const Segment& piece = end ? best[2] : best[j];
        const double u = end ? piece.duration : 0.0;
        const double nudge = j == 1 || j == 2 ? 0.1 : 0.0;
        return AxisState{p.q[j], piece.value(u, 1) + nudge, piece.value(u, 2) - nudge};
      };
      other.push_back(quintic_segment(state(i), state(i + 1), p.t[i + 1] - p.t[i]));
    }
    CHECK(least < integral_of_square(other, 3));
  }
}

TEST_CASE("two points are joined by two quartics with continuous jerk") {
  const std::array t{0.0, 2.0};
  const std::array q{0.0, 1.0};
  const std::vector<Segment> pieces = quartic_spline(t, q);
  CHECK(pieces.size() == 2);
  CHECK(smoothness(pieces) == 3);
  CHECK(pieces[0].value(1.0) == 0.5);
  CHECK(pieces[0].value(1.0, 1) == doctest::Approx(1.0).epsilon(1e-14));
  const Points any{.t = {0.0, 1.3}, .q = {0.2, -0.7}, .ends = {0.3, -0.2, 0.9, 0.4}};
  const auto general = quartic_spline(any.t, any.q, any.ends);
  CHECK(smoothness(general) == 3);
  check_ends(general, any, true);
}

TEST_CASE("lift-off, travel and set-down need four points") {
  const std::array t{0.0, 1.0, 2.0};
  const std::array q{0.0, 1.0, 2.0};
  CHECK_THROWS_AS((void)path_353(t, q), ArgumentError);
  CHECK_THROWS_AS((void)path_five_cubics(t, q), ArgumentError);
}

TEST_CASE("a natural spline has no acceleration at its ends and goes through its points") {
  std::mt19937_64 generator(19);
  for (int k = 0; k < 100; ++k) {
    const Points p = random_points(generator, 2 + generator() % 9);
    const std::vector<Segment> pieces = natural_spline(p.t, p.q);
    CHECK(smoothness(pieces) >= 2);
    CHECK(pieces.front().value(0.0, 2) == 0.0);
    CHECK(std::abs(pieces.back().value(pieces.back().duration, 2)) < 1e-11);
    for (std::size_t i = 0; i < p.t.size(); ++i) {
      CHECK(std::abs(at(pieces, p.t[i]) - p.q[i]) < 1e-12);
    }
  }
}
