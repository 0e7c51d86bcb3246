#include "armlet/math/minimise.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "matrices.hpp"

using namespace armlet;
using Eigen::VectorXd;
using Status = Minimum::Status;

namespace {

double square(double x) { return x * x; }

// A problem of J. J. More, B. S. Garbow, K. E. Hillstrom, Testing Unconstrained Optimization
// Software, ACM Transactions on Mathematical Software 7(1), 1981: its start and its smallest value.
struct Problem {
  std::string name;
  VectorXd start;
  double smallest;
  std::function<double(const VectorXd&)> f;
};

double bard(const VectorXd& x) {
  constexpr double kData[15] = {0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39,
                                0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39};
  double sum = 0.0;
  for (int i = 1; i <= 15; ++i) {
    const double u = i, v = 16 - i, w = std::min(u, v);
    sum += square(kData[i - 1] - (x[0] + u / (v * x[1] + w * x[2])));
  }
  return sum;
}

double gaussian(const VectorXd& x) {
  constexpr double kData[15] = {0.0009, 0.0044, 0.0175, 0.0540, 0.1295, 0.2420, 0.3521, 0.3989,
                                0.3521, 0.2420, 0.1295, 0.0540, 0.0175, 0.0044, 0.0009};
  double sum = 0.0;
  for (int i = 1; i <= 15; ++i) {
    const double t = (8.0 - i) / 2.0;
    sum += square(x[0] * std::exp(-x[1] * square(t - x[2]) / 2.0) - kData[i - 1]);
  }
  return sum;
}

double helical_valley(const VectorXd& x) {
  double theta = std::atan(x[1] / x[0]) / (2.0 * std::numbers::pi);
  if (x[0] < 0.0) theta += 0.5;
  return square(10.0 * (x[2] - 10.0 * theta)) + square(10.0 * (std::hypot(x[0], x[1]) - 1.0)) +
         square(x[2]);
}

double kowalik_osborne(const VectorXd& x) {
  constexpr double kY[11] = {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627,
                             0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
  constexpr double kU[11] = {4.0, 2.0, 1.0, 0.5, 0.25, 0.167, 0.125, 0.1, 0.0833, 0.0714, 0.0625};
  double sum = 0.0;
  for (int i = 0; i < 11; ++i) {
    const double u = kU[i];
    sum += square(kY[i] - x[0] * (u * u + u * x[1]) / (u * u + u * x[2] + x[3]));
  }
  return sum;
}

double brown_dennis(const VectorXd& x) {
  double sum = 0.0;
  for (int i = 1; i <= 20; ++i) {
    const double t = i / 5.0;
    sum += square(square(x[0] + t * x[1] - std::exp(t)) +
                  square(x[2] + x[3] * std::sin(t) - std::cos(t)));
  }
  return sum;
}

double jennrich_sampson(const VectorXd& x) {
  double sum = 0.0;
  for (int i = 1; i <= 10; ++i)
    sum += square(2.0 + 2.0 * i - (std::exp(i * x[0]) + std::exp(i * x[1])));
  return sum;
}

double box(const VectorXd& x) {
  double sum = 0.0;
  for (int i = 1; i <= 10; ++i) {
    const double t = 0.1 * i;
    sum += square(std::exp(-t * x[0]) - std::exp(-t * x[1]) -
                  x[2] * (std::exp(-t) - std::exp(-10.0 * t)));
  }
  return sum;
}

double wood(const VectorXd& x) {
  return 100.0 * square(x[1] - x[0] * x[0]) + square(1.0 - x[0]) +
         90.0 * square(x[3] - x[2] * x[2]) + square(1.0 - x[2]) + 10.0 * square(x[1] + x[3] - 2.0) +
         0.1 * square(x[1] - x[3]);
}

std::vector<Problem> problems() {
  return {
      {"Rosenbrock", vec({-1.2, 1.0}), 0.0,
       [](const VectorXd& x) { return square(10.0 * (x[1] - x[0] * x[0])) + square(1.0 - x[0]); }},
      {"Freudenstein and Roth", vec({0.5, -2.0}), 48.98425,
       [](const VectorXd& x) {
         return square(-13.0 + x[0] + ((5.0 - x[1]) * x[1] - 2.0) * x[1]) +
                square(-29.0 + x[0] + ((x[1] + 1.0) * x[1] - 14.0) * x[1]);
       }},
      {"Powell badly scaled", vec({0.0, 1.0}), 0.0,
       [](const VectorXd& x) {
         return square(1e4 * x[0] * x[1] - 1.0) +
                square(std::exp(-x[0]) + std::exp(-x[1]) - 1.0001);
       }},
      {"Brown badly scaled", vec({1.0, 1.0}), 0.0,
       [](const VectorXd& x) {
         return square(x[0] - 1e6) + square(x[1] - 2e-6) + square(x[0] * x[1] - 2.0);
       }},
      {"Beale", vec({1.0, 1.0}), 0.0,
       [](const VectorXd& x) {
         return square(1.5 - x[0] * (1.0 - x[1])) + square(2.25 - x[0] * (1.0 - square(x[1]))) +
                square(2.625 - x[0] * (1.0 - x[1] * x[1] * x[1]));
       }},
      {"Jennrich and Sampson", vec({0.3, 0.4}), 124.362, jennrich_sampson},
      {"helical valley", vec({-1.0, 0.0, 0.0}), 0.0, helical_valley},
      {"Bard", vec({1.0, 1.0, 1.0}), 8.21487e-3, bard},
      {"Gaussian", vec({0.4, 1.0, 0.0}), 1.12793e-8, gaussian},
      {"Box", vec({0.0, 10.0, 20.0}), 0.0, box},
      {"Powell singular", vec({3.0, -1.0, 0.0, 1.0}), 0.0,
       [](const VectorXd& x) {
         return square(x[0] + 10.0 * x[1]) + 5.0 * square(x[2] - x[3]) +
                square(square(x[1] - 2.0 * x[2])) + 10.0 * square(square(x[0] - x[3]));
       }},
      {"Wood", vec({-3.0, -1.0, -3.0, -1.0}), 0.0, wood},
      {"Kowalik and Osborne", vec({0.25, 0.39, 0.415, 0.39}), 3.07505e-4, kowalik_osborne},
      {"Brown and Dennis", vec({25.0, 5.0, -5.0, -1.0}), 85822.2, brown_dennis},
  };
}

Minimum run(const std::function<double(const VectorXd&)>& f, const VectorXd& start,
            MinimiseOptions options = {}) {
  return minimise(
      [&](const VectorXd& x, double& value) {
        value = f(x);
        return true;
      },
      start, options);
}

}  // namespace

TEST_CASE("the problems of More, Garbow and Hillstrom are solved from their starts") {
  for (const Problem& problem : problems()) {
    CAPTURE(problem.name);
    const Minimum found = run(problem.f, problem.start);
    CAPTURE(found.evaluations);
    CHECK(found.status == Status::kFound);
    CHECK(found.value == problem.f(found.x));
    // The table has six digits. Of the sums whose minimum is zero a rest of 1e-10 is left where the
    // valley is flat.
    CHECK(std::abs(found.value - problem.smallest) <= 1e-10 + 2e-6 * problem.smallest);
  }
}

TEST_CASE("the valley of Rosenbrock ends at (1, 1)") {
  const Minimum found = run(problems()[0].f, vec({-1.2, 1.0}));
  CHECK(std::abs(found.x[0] - 1.0) < 1e-6);
  CHECK(std::abs(found.x[1] - 1.0) < 1e-6);
}

TEST_CASE("random bowls of one to six variables are followed to their bottom") {
  Random random(11);
  for (int trial = 0; trial < 60; ++trial) {
    const int n = 1 + trial % 6;
    VectorXd bottom(n), width(n), start(n);
    for (int i = 0; i < n; ++i) {
      bottom[i] = random.uniform(-5.0, 5.0);
      width[i] = random.uniform(0.5, 5.0);
      start[i] = random.uniform(-5.0, 5.0);
    }
    const auto bowl = [&](const VectorXd& x) {
      return 3.0 + (x - bottom).cwiseQuotient(width).squaredNorm();
    };
    const Minimum found = run(bowl, start);
    REQUIRE(found.status == Status::kFound);
    // A change of x by 1e-7 changes the value 3 by its last bits.
    CHECK((found.x - bottom).norm() < 2e-6);
    CHECK(std::abs(found.value - 3.0) < 1e-12);
  }
}

TEST_CASE("the same start gives the same bits") {
  const Problem wood_problem = problems()[11];
  CHECK(run(wood_problem.f, wood_problem.start).x == run(wood_problem.f, wood_problem.start).x);
}

TEST_CASE("infinity is a wall") {
  const auto f = [](const VectorXd& x) { return x[0] < 1.0 ? INFINITY : x[0]; };
  const Minimum found = run(f, vec({3.0}));
  CHECK(found.status == Status::kFound);
  CHECK(found.x[0] == doctest::Approx(1.0).epsilon(1e-7));
}

TEST_CASE("functions that cannot be minimised are distinguished") {
  CHECK(run([](const VectorXd& x) { return x[0] < 0.9 ? NAN : x[0]; }, vec({1.0})).status ==
        Status::kUndefined);
  CHECK(run([](const VectorXd&) { return INFINITY; }, vec({1.0})).status == Status::kUndefined);
  const Minimum falling = run([](const VectorXd& x) { return -std::exp(x[0]); }, vec({1.0}));
  CHECK(falling.status == Status::kBottomless);
  const Minimum few = run(wood, vec({-3.0, -1.0, -3.0, -1.0}), {.most_evaluations = 20});
  CHECK(few.status == Status::kTooMany);
  CHECK(few.evaluations < 100);
  const auto stopping = [](const VectorXd&, double&) { return false; };
  CHECK(minimise(stopping, vec({1.0})).status == Status::kStopped);
  CHECK_THROWS_AS(run(wood, VectorXd()), ArgumentError);
  CHECK_THROWS_AS(run(wood, vec({1.0, NAN, 1.0, 1.0})), ArgumentError);
}
