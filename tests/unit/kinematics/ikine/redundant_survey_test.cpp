// Arms of seven and eight joints without any structure: the nearest solution and the best posture
// against a dense search. ARMLET_SURVEY=400 ARMLET_SEED=1 ARMLET_STARTS=240 runs it over so many
// arms, half of them of each kind, with so many starts of the search.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "armlet/math/decompose.hpp"
#include "general_arm.hpp"
#include "nearest_search.hpp"
#include "sanitized.hpp"
#include "survey.hpp"

using namespace armlet;
using namespace armlet::nearest;

namespace {

constexpr int kArms = kSanitized ? 2 : 16;

// What is searched for: how bad joint values are, with each joint at its best copy; what lies
// beyond limits counts as very bad, the worse the farther.
using Cost = std::function<double(const VectorXd&)>;

constexpr double kBeyond = 100.0;

// The least of f over the copies of a joint inside its limits.
template <class Function>
double best_copy(const Robot& robot, int i, double value, const Function& f) {
  double best = INFINITY, beyond = INFINITY;
  for (int k = robot.is_revolute(i) ? -3 : 0; k <= (robot.is_revolute(i) ? 3 : 0); ++k) {
    const double copy = value + 2.0 * kPi * k;
    const double outside = std::max({robot.lower()[i] - copy, copy - robot.upper()[i], 0.0});
    if (outside <= 1e-12) best = std::min(best, f(copy));
    beyond = std::min(beyond, outside);
  }
  return best < INFINITY ? best : kBeyond * (1.0 + beyond);
}

Cost farthest_from(const Robot& robot, const VectorXd& seed) {
  return [&](const VectorXd& q) {
    double most = 0.0;
    for (int i = 0; i < robot.n(); ++i) {
      most = std::max(most,
                      best_copy(robot, i, q[i], [&](double x) { return std::abs(x - seed[i]); }));
    }
    return most;
  };
}

// Liegeois 1977, equation of the distance from the middle of the ranges.
Cost off_middle(const Robot& robot) {
  return [&](const VectorXd& q) {
    double sum = 0.0;
    for (int i = 0; i < robot.n(); ++i) {
      const double middle = 0.5 * (robot.lower()[i] + robot.upper()[i]);
      const double range = robot.upper()[i] - robot.lower()[i];
      sum += best_copy(robot, i, q[i], [&](double x) { return std::pow((x - middle) / range, 2); });
    }
    return sum / (2.0 * robot.n());
  };
}

// Random starts, each brought to the goal and then downhill on the solutions in random directions
// with ever smaller steps.
class DenseSearch {
 public:
  DenseSearch(const Robot& robot, const Isometry3d& goal, const Cost& cost, Random& random)
      : robot_(robot), goal_(goal), cost_(cost), random_(random) {}

  double least(int starts, const std::vector<VectorXd>& known) {
    double best = INFINITY;
    for (const VectorXd& q : known) best = std::min(best, downhill(q));
    for (int k = 0; k < starts; ++k) {
      VectorXd q = random_joints(robot_, random_);
      if (to_goal(q, 40)) best = std::min(best, downhill(q));
    }
    return best;
  }

 private:
  bool to_goal(VectorXd& q, int rounds) const {
    double damping = 1e-3;
    for (int k = 0; k < rounds; ++k) {
      Jacobian J;
      const Vector6d e = error(q, J);
      if (e.norm() < 1e-11) return true;
      Eigen::Matrix<double, 6, 6> H = J * J.transpose();
      H.diagonal().array() += damping * std::min(e.squaredNorm(), 1.0) + 1e-14;
      const VectorXd more = J.transpose() * H.ldlt().solve(e);
      q += more * std::min(1.0, 0.5 / std::max(more.cwiseAbs().maxCoeff(), 1e-12));
    }
    return false;
  }

  Vector6d error(const VectorXd& q, Jacobian& J) const {
    const Isometry3d T = forward_and_jacobian(robot_, q, J);
    Vector6d e;
    e << goal_.translation() - T.translation(),
        rotation_log(goal_.linear() * T.linear().transpose());
    return e;
  }

  double downhill(VectorXd q) const {
    double best = cost_(q), step = 0.3;
    while (step > 1e-6) {
      Jacobian J;
      (void)error(q, J);
      VectorXd way(robot_.n());
      for (double& value : way) value = random_.uniform(-1.0, 1.0);
      Eigen::Matrix<double, 6, 6> H = J * J.transpose();
      H.diagonal().array() += 1e-14;
      way -= J.transpose() * H.ldlt().solve(J * way);
      way /= std::max(way.cwiseAbs().maxCoeff(), 1e-12);
      bool better = false;
      for (const double length : {step, -step}) {
        VectorXd tried = q + length * way;
        if (!to_goal(tried, 6)) continue;
        const double cost = cost_(tried);
        if (cost >= best) continue;
        best = cost;
        q = tried;
        better = true;
        break;
      }
      step *= better ? 1.3 : 0.7;
    }
    return best;
  }

  const Robot& robot_;
  const Isometry3d& goal_;
  const Cost& cost_;
  Random& random_;
};

struct Misses {
  int count = 0, unsolved = 0;
  double worst = 0.0;

  void add(double more) {
    count += more > 1e-3 ? 1 : 0;
    worst = std::max(worst, more);
  }
};

}  // namespace

TEST_CASE("survey of redundant arms: the nearest solution and the middle of the ranges") {
  const int starts = static_cast<int>(number_from_environment("ARMLET_STARTS", 120));
  Random random(survey_seed(78));
  Misses near, middle;
  const int count = survey_count(kArms);
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const Robot robot = general_arm(random, k % 4 == 3, k % 2 == 0 ? 7 : 8);
    const VectorXd q = random_joints(robot, random), seed = perturbed(robot, q, random);
    const Isometry3d goal = forward(robot, q);
    const IkResult nearest = solve_ik(robot, goal, {.seed = seed});
    const IkResult best = solve_ik(robot, goal, {.seed = seed, .posture = Posture::kMidRange});
    for (const auto& [result, misses, cost] :
         {std::tuple(&nearest, &near, farthest_from(robot, seed)),
          std::tuple(&best, &middle, off_middle(robot))}) {
      if (!result->ok() || !within_limits(robot, result->q, 0.0) ||
          (forward(robot, result->q).translation() - goal.translation()).norm() > 1.001e-6) {
        ++misses->unsolved;
        continue;
      }
      const double least = DenseSearch(robot, goal, cost, random).least(starts, {q});
      const double more = cost(result->q) - least;
      misses->add(more);
      if (more > 1e-3)
        MESSAGE(std::string(misses == &near ? "near" : "midRange")
                << ", arm " << k << ": " << more << " more than " << least);
    }
  }
  CHECK(near.unsolved + middle.unsolved == 0);
  CHECK(near.count == 0);
  CHECK(middle.count == 0);
  MESSAGE(count << " arms: near " << near.count << " off, at most " << near.worst << "; midRange "
                << middle.count << " off, at most " << middle.worst);
}
