#pragma once

#include "batch_plan.hpp"
#include "joint_sines.hpp"
#include "math/det_quick_lanes.hpp"

namespace armlet {

// Sines and cosines with the bits of a batch, for one configuration: two joints at a time, as in
// JointSines, beginning with those that the recursion needs first.
template <int N, bool from_tool>
class QuickJointSines {
 public:
  [[gnu::always_inline]] QuickJointSines(const WalkPlan& plan, const double* q) {
    const int n = joint_count<N>(plan);
    const det::QuickTable<Lanes> numbers;
    det::QuickCheck<Lanes> check;
    const int pairs = (n + 1) / 2;
#pragma GCC unroll 8
    for (int k = 0; k < pairs; ++k) {
      const int pair = from_tool ? pairs - 1 - k : k;
      const int i = std::max(0, std::min(2 * pair, n - 2));
      const Lanes values = n == 1 ? both(q[0]) : load_pair(q + i);
      const Lanes angles =
          values * load_pair(plan.q_to_theta.data() + i) + load_pair(plan.theta.data() + i);
      const auto angle = det::quick_sincos(angles, check, numbers);
      store_pair(sine_ + i, angle.sin);
      store_pair(cosine_ + i, angle.cos);
    }
    if (check.any_too_large()) [[unlikely]]
      careful_batch_sines(batch_arm(plan), q, 1, {0, 1, 1, sine_, cosine_});
  }

  Lanes sine(int i) const { return both(sine_[i]); }
  Lanes cosine(int i) const { return both(cosine_[i]); }

 private:
  static constexpr std::size_t kCapacity = N == 1 ? 2 : kJointCapacity<N>;
  double sine_[kCapacity], cosine_[kCapacity];
};

}  // namespace armlet
