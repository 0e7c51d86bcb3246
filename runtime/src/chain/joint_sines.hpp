#pragma once

#include <algorithm>
#include <array>

#include "by_joints.hpp"
#include "lane_pairs.hpp"
#include "math/det_quick_lanes.hpp"

namespace armlet {

// Sines and cosines of the joint angles of a plan one by one, for angles that the lanes cannot
// handle.
//
// throws  ArgumentError if a joint value is not finite.
void careful_joint_sines(const WalkPlan& plan, const double* q, double* sine, double* cosine);

// Sines and cosines of full accuracy.
class ExactSines {
 public:
  [[gnu::always_inline]] det::LaneSinCos<Lanes> operator()(Lanes angles) {
    return det::sincos_lanes(angles, check_);
  }
  [[gnu::always_inline]] bool all_settled() const { return check_.all_settled(); }

 private:
  det::LaneCheck<Lanes> check_;
};

// Sines and cosines of lowest latency, for iterations, each of which waits for the one before.
class PromptSines {
 public:
  [[gnu::always_inline]] det::LaneSinCos<Lanes> operator()(Lanes angles) {
    return det::prompt_sincos(angles, check_, det::QuickTable<Lanes>());
  }
  [[gnu::always_inline]] bool all_settled() const { return !check_.any_too_large(); }

 private:
  det::QuickCheck<Lanes> check_;
};

// Sines and cosines of all joints, two at a time. Of an odd number the last pair overlaps the one
// before, which is faster than padding.
template <int N, class Sines = ExactSines>
class JointSinesBy {
 public:
  [[gnu::always_inline]] JointSinesBy(const WalkPlan& plan, const double* q)
      : n_(joint_count<N>(plan)) {
    Sines sines;
    const int pairs = (n_ + 1) / 2;
#pragma GCC unroll 8
    for (int pair = 0; pair < pairs; ++pair) {
      const int i = first(pair);
      const Lanes values = n_ == 1 ? both(q[0]) : load_pair(q + i);
      const Lanes angles =
          load_pair(plan.theta.data() + i) + values * load_pair(plan.q_to_theta.data() + i);
      const auto both_of = sines(angles);
      sine_[pair] = both_of.sin;
      cosine_[pair] = both_of.cos;
    }
    if (!sines.all_settled()) [[unlikely]] {
      std::array<double, kMaxJoints> s{}, c{};
      careful_joint_sines(plan, q, s.data(), c.data());
#pragma GCC unroll 8
      for (int pair = 0; pair < pairs; ++pair) {
        sine_[pair] = load_pair(s.data() + first(pair));
        cosine_[pair] = load_pair(c.data() + first(pair));
      }
    }
  }

  Lanes sine(int i) const { return both(sine_[i / 2][i - first(i / 2)]); }
  Lanes cosine(int i) const { return both(cosine_[i / 2][i - first(i / 2)]); }

 private:
  static constexpr std::size_t kPairs = (kJointCapacity<N> + 1) / 2;
  int first(int pair) const { return std::max(0, std::min(2 * pair, n_ - 2)); }

  int n_;
  Lanes sine_[kPairs] = {}, cosine_[kPairs] = {};
};

template <int N>
using JointSines = JointSinesBy<N>;
template <int N>
using PromptJointSines = JointSinesBy<N, PromptSines>;

}  // namespace armlet
