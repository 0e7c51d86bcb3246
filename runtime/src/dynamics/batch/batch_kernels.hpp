#pragma once

#include "batch_table.hpp"
#include "chain/batch_blocks.hpp"
#include "dynamics/newton_euler.hpp"

// Inverse dynamics of many motions, one per lane. Compiled once per instruction set, in sources
// that include nothing else; all give the same bits.
namespace armlet {

// Multiplication by the sign of a joint, 1 or -1: the same bits without a multiplication.
template <class V>
[[gnu::always_inline]] inline V signed_by(const PlanLink& link, V value) {
  return link.sign < 0.0 ? -value : value;
}

// The motions of a block, with the signs of the plan.
template <class V>
struct BlockMotion {
  const MotionBatch& batch;
  std::size_t k;

  [[gnu::always_inline]] V plain(const double* values, int i) const {
    return load_lanes<V>(values + static_cast<std::size_t>(i) * batch.count + k);
  }
  [[gnu::always_inline]] V of(const double* values, int i) const {
    return signed_by<V>(batch.plan.links[i], plain(values, i));
  }
  [[gnu::always_inline]] V q(int i) const { return of(batch.q, i); }
  [[gnu::always_inline]] V qd(int i) const { return of(batch.qd, i); }
  [[gnu::always_inline]] V qdd(int i) const { return of(batch.qdd, i); }
};

template <class V, class Block>
struct BlockSinesByNumber {
  const Block& block;
  [[gnu::always_inline]] V sine(int i) const { return block.sine(static_cast<std::size_t>(i)); }
  [[gnu::always_inline]] V cosine(int i) const { return block.cosine(static_cast<std::size_t>(i)); }
};

template <class V>
[[gnu::always_inline]] inline V lane_friction(const PlanLink& link, V qd) {
  const V zero = V{};
  const V plus = qd > zero ? all_lanes<V>(link.friction.coulomb_plus) : zero;
  const V dry = qd < zero ? all_lanes<V>(link.friction.coulomb_minus) : plus;
  return all_lanes<V>(link.friction.viscous) * qd + dry;
}

// Whether all forces are finite. If their sums by lane are finite, all are; sums of very large
// forces may overflow, and then each force is tested.
template <class V>
[[gnu::always_inline]] inline bool are_finite(const MotionBatch& batch, V sums, const double* tau) {
  double doubt = 0.0;
  for (std::size_t lane = 0; lane < kLanesOf<V>; ++lane) doubt += sums[lane] - sums[lane];
  if (doubt == 0.0) return true;
  doubt = 0.0;
#pragma GCC unroll 1
  for (std::size_t at = 0; at < batch.plan.n * batch.count; ++at) doubt += tau[at] - tau[at];
  return doubt == 0.0;
}

// sums  of all forces, by lane.
template <class V, bool kSlides>
struct InverseBlock {
  const MotionBatch& batch;
  double* tau;
  V& sums;

  template <class Block>
  [[gnu::always_inline]] void operator()(const Block& block, std::size_t k) const {
    const BlockMotion<V> motion = {batch, k};
    const DynamicsPlan& plan = batch.plan;
    newton_euler<V, 0, kSlides, true>(
        plan, BlockSinesByNumber<V, Block>{block}, motion,
        plan.base_acceleration, [&](int i, V force) __attribute__((always_inline)) {
          const PlanLink& link = plan.links[i];
          V sum = signed_by<V>(link, force) +
                  all_lanes<V>(link.motor_inertia) * motion.plain(batch.qdd, i);
          if (plan.friction == FrictionKind::kCoulomb) {
            sum = sum + lane_friction(link, motion.plain(batch.qd, i));
          }
          store_lanes(tau + static_cast<std::size_t>(i) * batch.count + k, sum);
          sums = sums + sum;
        });
  }
};

template <class V, bool kSlides>
[[gnu::noinline]] static bool inverse_few(const MotionBatch& batch, double* tau) {
  V sums{};
  few_configurations<V>(batch.arm, batch.q, batch.count,
                        InverseBlock<V, kSlides>{batch, tau, sums});
  return are_finite<V>(batch, sums, tau);
}

template <class V, bool kSlides>
[[gnu::noinline]] static bool inverse_many(const MotionBatch& batch, double* tau) {
  V sums{};
  all_configurations<V>(batch.arm, batch.q, batch.count,
                        InverseBlock<V, kSlides>{batch, tau, sums});
  return are_finite<V>(batch, sums, tau);
}

template <class V>
bool inverse_batch_kernel(const MotionBatch& batch, double* tau) {
  if (are_few<V>(batch.count)) {
    return batch.plan.is_mixed() ? inverse_few<V, true>(batch, tau)
                                 : inverse_few<V, false>(batch, tau);
  }
  return batch.plan.is_mixed() ? inverse_many<V, true>(batch, tau)
                               : inverse_many<V, false>(batch, tau);
}

template <class V>
inline constexpr DynamicsBatchKernels kDynamicsKernels = {kLanesOf<V>, inverse_batch_kernel<V>};

}  // namespace armlet
