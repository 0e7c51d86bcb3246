#pragma once

#include <cstddef>

#include "lane_steps.hpp"

// Kernels for many configurations, one per lane. Compiled once per instruction set, in sources that
// include nothing else; every operation is that of the kernels for one configuration, so the bits
// are the same too.
namespace armlet {

// A plan as plain pointers.
struct BatchArm {
  std::size_t n;
  bool base_is_none;
  const double *theta, *turn, *d, *slide, *a, *sin_alpha, *cos_alpha, *base, *tool;
  const bool *has_d, *has_a, *right_angle, *any_angle;
};

// Entry e of configuration k is at [e * count + k] of `q` and of what is written: the entries of
// axes x, y, z and origin of the tool, or the columns of the Jacobian. `count` is at least `lanes`.
using BatchKernel = void(const BatchArm& arm, const double* q, std::size_t count, double* out);
struct BatchKernels {
  std::size_t lanes;
  BatchKernel* poses;
  BatchKernel* jacobians;
};
extern const BatchKernels kBaselineBatch, kAvx2Batch, kAvx512Batch;

// Sines and cosines [joint * lanes + lane] of the block that starts at configuration k, one by one.
//
// throws  ArgumentError if a joint value is not finite.
void careful_batch_turns(const BatchArm& arm, const double* q, std::size_t count, std::size_t k,
                         std::size_t lanes, double* sine, double* cosine);

inline constexpr std::size_t kBatchJoints = 12;

template <class V>
inline constexpr std::size_t kLanesOf = sizeof(V) / sizeof(double);

// Where the block begins that would begin at k; the last one overlaps the one before.
template <class V>
[[gnu::always_inline]] inline std::size_t block_start(std::size_t k, std::size_t count) {
  return k + kLanesOf<V> <= count ? k : count - kLanesOf<V>;
}

// The same number in every lane; subtracting 0 keeps the sign of -0.
template <class V>
[[gnu::always_inline]] inline V all_lanes(double value) {
  return value - V{};
}

// Offsets and signs of the angles in every lane, which do not change from block to block.
template <class V>
struct BatchAngles {
  V theta[kBatchJoints], turn[kBatchJoints];

  [[gnu::always_inline]] explicit BatchAngles(const BatchArm& arm) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      theta[i] = all_lanes<V>(arm.theta[i]);
      turn[i] = all_lanes<V>(arm.turn[i]);
    }
  }
};

template <class V>
struct BatchTurns {
  static constexpr std::size_t kLanes = kLanesOf<V>;
  alignas(V) double sines[kBatchJoints * kLanes];
  alignas(V) double cosines[kBatchJoints * kLanes];

  [[gnu::always_inline]] V sine(std::size_t i) const { return load_lanes<V>(sines + i * kLanes); }
  [[gnu::always_inline]] V cosine(std::size_t i) const {
    return load_lanes<V>(cosines + i * kLanes);
  }

  [[gnu::always_inline]] BatchTurns(const BatchArm& arm, const BatchAngles<V>& angles,
                                    const double* q, std::size_t count, std::size_t k) {
    auto settled = V{} == V{};
    for (std::size_t i = 0; i < arm.n; ++i) {
      const V values = load_lanes<V>(q + i * count + k);
      const auto turn = det::sincos_lanes(angles.theta[i] + values * angles.turn[i]);
      store_lanes(sines + i * kLanes, turn.sin);
      store_lanes(cosines + i * kLanes, turn.cos);
      settled &= turn.settled;
    }
    auto all = settled[0];
    for (std::size_t lane = 1; lane < kLanes; ++lane) all &= settled[lane];
    if (all == 0) careful_batch_turns(arm, q, count, k, kLanes, sines, cosines);
  }
};

// Where the last part of Z_i moves along the axis.
template <class V>
[[gnu::always_inline]] inline V distance(const BatchArm& arm, const double* q, std::size_t count,
                                         std::size_t k, std::size_t i) {
  return arm.d[i] + load_lanes<V>(q + i * count + k) * arm.slide[i];
}

// The four columns of a pose; as variables of their own they stay in registers.
template <class V>
struct BatchPose {
  Parts<V> x, y, z, p;

  [[gnu::always_inline]] static Parts<V> column(const double* T, std::size_t c) {
    return {all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
  }
  [[gnu::always_inline]] explicit BatchPose(const double* T)
      : x(column(T, 0)), y(column(T, 1)), z(column(T, 2)), p(column(T, 3)) {}

  [[gnu::always_inline]] void turn_x(V sine, V cosine) {
    x.turn_x(sine, cosine);
    y.turn_x(sine, cosine);
    z.turn_x(sine, cosine);
    p.turn_x(sine, cosine);
  }
  [[gnu::always_inline]] void turn_z(V sine, V cosine) {
    x.turn_z(sine, cosine);
    y.turn_z(sine, cosine);
    z.turn_z(sine, cosine);
    p.turn_z(sine, cosine);
  }
  [[gnu::always_inline]] void turn_right_z(V sine, V cosine) {
    x.turn_right_z(sine, cosine);
    y.turn_right_z(sine, cosine);
    z.turn_right_z(sine, cosine);
    p.turn_right_z(sine, cosine);
  }
  [[gnu::always_inline]] void step_base(const double* B) {
    x.turn_base(B);
    y.turn_base(B);
    z.turn_base(B);
    p.turn_base(B);
    p.x += B[9];
    p.y += B[10];
    p.z += B[11];
  }
};

template <class V>
[[gnu::always_inline]] inline void store_parts(double* out, std::size_t count, const Parts<V>& v) {
  store_lanes(out, v.x);
  store_lanes(out + count, v.y);
  store_lanes(out + 2 * count, v.z);
}

template <class V>
[[gnu::always_inline]] inline void poses_of_block(const BatchArm& arm, const BatchAngles<V>& angles,
                                                  const double* q, std::size_t count, std::size_t k,
                                                  double* out) {
  const BatchTurns<V> turns(arm, angles, q, count, k);
  BatchPose<V> pose(arm.tool);
  for (std::size_t i = arm.n; i-- > 0;) {
    const V sine = turns.sine(i);
    const V cosine = turns.cosine(i);
    if (i + 1 < arm.n && arm.right_angle[i + 1]) {
      pose.turn_right_z(sine, cosine);
    } else {
      if (i + 1 < arm.n && arm.any_angle[i + 1]) {
        pose.turn_x(all_lanes<V>(arm.sin_alpha[i + 1]), all_lanes<V>(arm.cos_alpha[i + 1]));
      }
      pose.turn_z(sine, cosine);
    }
    if (arm.has_d[i]) pose.p.z += distance<V>(arm, q, count, k, i);
    if (i > 0 && arm.has_a[i]) pose.p.x += arm.a[i];
  }
  if (!arm.base_is_none) pose.step_base(arm.base);
  store_parts(out + k, count, pose.x);
  store_parts(out + 3 * count + k, count, pose.y);
  store_parts(out + 6 * count + k, count, pose.z);
  store_parts(out + 9 * count + k, count, pose.p);
}

template <class V>
[[gnu::always_inline]] inline Parts<V> parts(const double* column) {
  return {all_lanes<V>(column[0]), all_lanes<V>(column[1]), all_lanes<V>(column[2])};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> operator+(const Parts<V>& a, const Parts<V>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> operator-(const Parts<V>& a, const Parts<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
[[gnu::always_inline]] inline Parts<V> operator*(V s, const Parts<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

// Frames from the base outwards, as in walk_out.hpp.
template <class V>
struct BatchFrame {
  Parts<V> x, y, z, p;

  [[gnu::always_inline]] void step_x(const BatchArm& arm, std::size_t i) {
    if (arm.has_a[i]) p = p + all_lanes<V>(arm.a[i]) * x;
    const Parts<V> y_before = y;
    if (arm.right_angle[i]) {
      y = z;
      z = {-y_before.x, -y_before.y, -y_before.z};
    } else if (arm.any_angle[i]) {
      const V sine = all_lanes<V>(arm.sin_alpha[i]);
      const V cosine = all_lanes<V>(arm.cos_alpha[i]);
      y = cosine * y_before + sine * z;
      z = cosine * z - sine * y_before;
    }
  }

  [[gnu::always_inline]] void turn_z(V sine, V cosine) {
    const Parts<V> x_before = x;
    x = cosine * x_before + sine * y;
    y = cosine * y - sine * x_before;
  }
};

template <class V>
[[gnu::always_inline]] inline void jacobians_of_block(const BatchArm& arm,
                                                      const BatchAngles<V>& angles, const double* q,
                                                      std::size_t count, std::size_t k,
                                                      double* out) {
  const BatchTurns<V> turns(arm, angles, q, count, k);
  Parts<V> axis[kBatchJoints], point[kBatchJoints];
  BatchFrame<V> frame = {parts<V>(arm.base), parts<V>(arm.base + 3), parts<V>(arm.base + 6),
                         parts<V>(arm.base + 9)};
  for (std::size_t i = 0; i < arm.n; ++i) {
    if (i > 0) frame.step_x(arm, i);
    if (arm.has_d[i]) frame.p = frame.p + distance<V>(arm, q, count, k, i) * frame.z;
    frame.turn_z(turns.sine(i), turns.cosine(i));
    axis[i] = frame.z;
    point[i] = frame.p;
  }
  const Parts<V> tool = all_lanes<V>(arm.tool[3]) * frame.x + all_lanes<V>(arm.tool[7]) * frame.y +
                        all_lanes<V>(arm.tool[11]) * frame.z;
  const Parts<V> p = frame.p + tool;
  for (std::size_t i = 0; i < arm.n; ++i) {
    double* column = out + 6 * i * count + k;
    if (arm.turn[i] == 0.0) {
      store_parts(column, count, all_lanes<V>(arm.slide[i]) * axis[i]);
      store_parts(column + 3 * count, count, Parts<V>{});
      continue;
    }
    const Parts<V> w = all_lanes<V>(arm.turn[i]) * axis[i];
    const Parts<V> r = p - point[i];
    const Parts<V> v = {w.y * r.z - w.z * r.y, -(w.x * r.z - w.z * r.x), w.x * r.y - w.y * r.x};
    store_parts(column, count, v);
    store_parts(column + 3 * count, count, w);
  }
}

template <class V>
void batch_poses(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  const BatchAngles<V> angles(arm);
  for (std::size_t k = 0; k < count; k += kLanesOf<V>) {
    poses_of_block<V>(arm, angles, q, count, block_start<V>(k, count), out);
  }
}

template <class V>
void batch_jacobians(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  const BatchAngles<V> angles(arm);
  for (std::size_t k = 0; k < count; k += kLanesOf<V>) {
    jacobians_of_block<V>(arm, angles, q, count, block_start<V>(k, count), out);
  }
}

}  // namespace armlet
