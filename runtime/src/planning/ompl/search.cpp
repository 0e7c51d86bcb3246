// The folder of OMPL: RRT-Connect.
//
// The same bits on every run, whatever ran before in the process: the caller samples
// configurations, neighbours are found by a linear search, the search ends after a number of steps,
// and there is one thread. OMPL's own random numbers are not used; they are seeded all the same,
// before any planner exists.
//
// source  J. J. Kuffner, S. M. LaValle, RRT-Connect: an efficient approach to single-query path
//         planning, ICRA 2000. I. A. Sucan, M. Moll, L. E. Kavraki, The Open Motion Planning
//         Library, IEEE Robotics & Automation Magazine 19(4), 2012.

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <exception>
#include <memory>

#include "planning/sampling_door.hpp"

namespace armlet {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using Numbers = ob::RealVectorStateSpace::StateType;

double* numbers_of(ob::State* state) { return state->as<Numbers>()->values; }
const double* numbers_of(const ob::State* state) { return state->as<Numbers>()->values; }

// Its arithmetic is compiled here, without fused operations, for equal bits.
class Space : public ob::RealVectorStateSpace {
 public:
  using ob::RealVectorStateSpace::RealVectorStateSpace;
  double distance(const ob::State* a, const ob::State* b) const override {
    const double *x = numbers_of(a), *y = numbers_of(b);
    double sum = 0.0;
    for (unsigned i = 0; i < dimension_; ++i) sum += (y[i] - x[i]) * (y[i] - x[i]);
    return std::sqrt(sum);
  }
  void interpolate(const ob::State* from, const ob::State* to, double t,
                   ob::State* state) const override {
    const double *x = numbers_of(from), *y = numbers_of(to);
    double* at = numbers_of(state);
    for (unsigned i = 0; i < dimension_; ++i) at[i] = x[i] + t * (y[i] - x[i]);
  }
};

class Sampler : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, const SamplingSearch& search)
      : ob::StateSampler(space), search_(search) {}
  void sampleUniform(ob::State* state) override {
    search_.sample(search_.context, numbers_of(state));
  }
  // RRT-Connect uses neither of these.
  void sampleUniformNear(ob::State* state, const ob::State*, double) override {
    sampleUniform(state);
  }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  const SamplingSearch& search_;
};

class Validity : public ob::StateValidityChecker {
 public:
  Validity(const ob::SpaceInformationPtr& space, const SamplingSearch& search)
      : ob::StateValidityChecker(space), search_(search) {}
  bool isValid(const ob::State* state) const override {
    return search_.is_free(search_.context, numbers_of(state));
  }

 private:
  const SamplingSearch& search_;
};

class Straight : public ob::MotionValidator {
 public:
  Straight(const ob::SpaceInformationPtr& space, const SamplingSearch& search)
      : ob::MotionValidator(space), search_(search) {}
  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return search_.is_free_between(search_.context, numbers_of(from), numbers_of(to));
  }
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>&) const override {
    return checkMotion(from, to);
  }

 private:
  const SamplingSearch& search_;
};

void fill(ob::ScopedState<ob::RealVectorStateSpace>& state, const double* x, int n) {
  for (int i = 0; i < n; ++i) state[static_cast<unsigned>(i)] = x[i];
}

bool search_with_rrt_connect(const SamplingSearch& search) {
  const auto space = std::make_shared<Space>(static_cast<unsigned>(search.n));
  ob::RealVectorBounds bounds(static_cast<unsigned>(search.n));
  for (int i = 0; i < search.n; ++i) {
    bounds.setLow(static_cast<unsigned>(i), search.lower[i]);
    bounds.setHigh(static_cast<unsigned>(i), search.upper[i]);
  }
  space->setBounds(bounds);
  space->setStateSamplerAllocator(
      [&search](const ob::StateSpace* s) { return std::make_shared<Sampler>(s, search); });
  const auto info = std::make_shared<ob::SpaceInformation>(space);
  info->setStateValidityChecker(std::make_shared<Validity>(info, search));
  info->setMotionValidator(std::make_shared<Straight>(info, search));
  info->setup();

  const auto problem = std::make_shared<ob::ProblemDefinition>(info);
  ob::ScopedState<ob::RealVectorStateSpace> state(space);
  fill(state, search.start, search.n);
  problem->addStartState(state);
  const auto goals = std::make_shared<ob::GoalStates>(info);
  for (int k = 0; k < search.goal_count; ++k) {
    fill(state, search.goals + k * search.n, search.n);
    goals->addState(state);
  }
  problem->setGoal(goals);

  og::RRTConnect planner(info);
  planner.setProblemDefinition(problem);
  planner.setRange(search.longest);
  planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();
  const ob::PlannerTerminationCondition end([&search] { return !search.go_on(search.context); });
  if (planner.solve(end) != ob::PlannerStatus::EXACT_SOLUTION) return false;
  for (const ob::State* each : problem->getSolutionPath()->as<og::PathGeometric>()->getStates())
    search.found(search.context, numbers_of(each));
  return true;
}

}  // namespace
}  // namespace armlet

extern "C" __attribute__((visibility("default"))) bool armlet_search_by_sampling(
    const armlet::SamplingSearch* search) {
  static const bool prepared = [] {
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(1);
    return true;
  }();
  (void)prepared;
  try {
    return armlet::search_with_rrt_connect(*search);
  } catch (const std::exception&) {
    return false;
  }
}
