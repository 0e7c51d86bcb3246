#pragma once

#include "batch_arm.hpp"
#include "lane_steps.hpp"

// Kernels for many configurations, one per lane. Compiled once per instruction set, in sources that
// include nothing else; every operation is that of the kernels for one configuration, so the bits
// are the same too.
namespace armlet {

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

// What does not change from block to block, in every lane.
template <class V>
struct BatchLanes {
  V theta[kBatchJoints], turn[kBatchJoints], d[kBatchJoints], a[kBatchJoints];

  [[gnu::always_inline]] explicit BatchLanes(const BatchArm& arm) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      theta[i] = all_lanes<V>(arm.theta[i]);
      turn[i] = all_lanes<V>(arm.turn[i]);
      d[i] = all_lanes<V>(arm.d[i]);
      a[i] = all_lanes<V>(arm.a[i]);
    }
  }
};

// A block: `lanes` configurations from number k on.
template <class V>
struct Block {
  const BatchArm& arm;
  const BatchLanes<V>& lanes;
  const double* q;
  std::size_t count, k;

  [[gnu::always_inline]] V values(std::size_t i) const { return load_lanes<V>(q + i * count + k); }
  // Of the last part of Z_i.
  [[gnu::always_inline]] V distance(std::size_t i) const {
    return arm.slides[i] ? lanes.d[i] + values(i) * arm.slide[i] : lanes.d[i];
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

  [[gnu::always_inline]] explicit BatchTurns(const Block<V>& block) {
    det::LaneCheck<V> check;
    for (std::size_t i = 0; i < block.arm.n; ++i) {
      const V values = block.values(i);
      const V angle =
          block.arm.plain[i] ? values : block.lanes.theta[i] + values * block.lanes.turn[i];
      const auto turn = det::sincos_lanes(angle, check);
      store_lanes(sines + i * kLanes, turn.sin);
      store_lanes(cosines + i * kLanes, turn.cos);
    }
    if (!check.all_settled()) {
      careful_batch_turns(block.arm, block.q, block.count, block.k, kLanes, sines, cosines);
    }
  }
};

// Two of the four columns of a pose; six vectors and a sine and cosine fit into the registers.
template <class V>
struct TwoColumns {
  Parts<V> left, right;

  [[gnu::always_inline]] void turn_z(V sine, V cosine) {
    left.turn_z(sine, cosine);
    right.turn_z(sine, cosine);
  }

  // Z_i behind X_{i+1}.
  [[gnu::always_inline]] void step(const BatchArm& arm, std::size_t i, V sine, V cosine) {
    if (arm.right_angle[i + 1]) {
      left.turn_right_z(sine, cosine);
      right.turn_right_z(sine, cosine);
      return;
    }
    if (arm.any_angle[i + 1]) {
      const V sin_alpha = all_lanes<V>(arm.sin_alpha[i + 1]);
      const V cos_alpha = all_lanes<V>(arm.cos_alpha[i + 1]);
      left.turn_x(sin_alpha, cos_alpha);
      right.turn_x(sin_alpha, cos_alpha);
    }
    turn_z(sine, cosine);
  }
};

template <class V>
[[gnu::always_inline]] inline Parts<V> tool_column(const double* T, std::size_t c) {
  return {all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
}

// The x and y axes of the tools.
template <class V>
[[gnu::always_inline]] inline TwoColumns<V> walk_axes(const Block<V>& block,
                                                      const BatchTurns<V>& turns) {
  const BatchArm& arm = block.arm;
  const V sine = turns.sine(arm.n - 1);
  const V cosine = turns.cosine(arm.n - 1);
  TwoColumns<V> xy;
  if (arm.tool_on_axis) {
    const double flip = arm.tool[5];
    xy = {{cosine, sine, V{}}, {sine * -flip, cosine * flip, V{}}};
  } else {
    xy = {tool_column<V>(arm.tool, 0), tool_column<V>(arm.tool, 1)};
    xy.turn_z(sine, cosine);
  }
  for (std::size_t i = arm.n - 1; i-- > 0;) xy.step(arm, i, turns.sine(i), turns.cosine(i));
  if (!arm.base_is_none) {
    xy.left.turn_base(arm.base);
    xy.right.turn_base(arm.base);
  }
  return xy;
}

// Along the axis of joint i and to the one before it.
template <class V>
[[gnu::always_inline]] inline void move(const Block<V>& block, std::size_t i, Parts<V>& p) {
  if (block.arm.has_d[i]) p.z += block.distance(i);
  if (i > 0 && block.arm.has_a[i]) p.x += block.lanes.a[i];
}

// The z axes and origins of the tools.
template <class V>
[[gnu::always_inline]] inline TwoColumns<V> walk_origins(const Block<V>& block,
                                                         const BatchTurns<V>& turns) {
  const BatchArm& arm = block.arm;
  TwoColumns<V> zp = {tool_column<V>(arm.tool, 2), tool_column<V>(arm.tool, 3)};
  if (arm.tool_on_axis) {
    zp.left.x = zp.left.y = zp.right.x = zp.right.y = V{};
  } else {
    zp.turn_z(turns.sine(arm.n - 1), turns.cosine(arm.n - 1));
  }
  move(block, arm.n - 1, zp.right);
  for (std::size_t i = arm.n - 1; i-- > 0;) {
    zp.step(arm, i, turns.sine(i), turns.cosine(i));
    move(block, i, zp.right);
  }
  if (!arm.base_is_none) {
    zp.left.turn_base(arm.base);
    zp.right.turn_base(arm.base);
    zp.right.x += arm.base[9];
    zp.right.y += arm.base[10];
    zp.right.z += arm.base[11];
  }
  return zp;
}

template <class V>
[[gnu::always_inline]] inline void store_parts(double* out, std::size_t count, const Parts<V>& v) {
  store_lanes(out, v.x);
  store_lanes(out + count, v.y);
  store_lanes(out + 2 * count, v.z);
}

template <class V>
[[gnu::always_inline]] inline void poses_of_block(const Block<V>& block, double* out) {
  const BatchTurns<V> turns(block);
  const TwoColumns<V> xy = walk_axes(block, turns);
  store_parts(out, block.count, xy.left);
  store_parts(out + 3 * block.count, block.count, xy.right);
  const TwoColumns<V> zp = walk_origins(block, turns);
  store_parts(out + 6 * block.count, block.count, zp.left);
  store_parts(out + 9 * block.count, block.count, zp.right);
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
[[gnu::always_inline]] inline void jacobians_of_block(const Block<V>& block, double* out) {
  const BatchArm& arm = block.arm;
  const BatchTurns<V> turns(block);
  Parts<V> axis[kBatchJoints], point[kBatchJoints];
  BatchFrame<V> frame = {parts<V>(arm.base), parts<V>(arm.base + 3), parts<V>(arm.base + 6),
                         parts<V>(arm.base + 9)};
  for (std::size_t i = 0; i < arm.n; ++i) {
    if (i > 0) frame.step_x(arm, i);
    if (arm.has_d[i]) frame.p = frame.p + block.distance(i) * frame.z;
    frame.turn_z(turns.sine(i), turns.cosine(i));
    axis[i] = frame.z;
    point[i] = frame.p;
  }
  const Parts<V> tool = all_lanes<V>(arm.tool[3]) * frame.x + all_lanes<V>(arm.tool[7]) * frame.y +
                        all_lanes<V>(arm.tool[11]) * frame.z;
  const Parts<V> p = frame.p + tool;
  for (std::size_t i = 0; i < arm.n; ++i) {
    double* v_out = out + 6 * i * block.count;
    double* w_out = v_out + 3 * block.count;
    if (arm.slides[i]) {
      store_parts(v_out, block.count, all_lanes<V>(arm.slide[i]) * axis[i]);
      store_parts(w_out, block.count, Parts<V>{});
      continue;
    }
    const Parts<V> w = block.lanes.turn[i] * axis[i];
    const Parts<V> r = p - point[i];
    const Parts<V> v = {w.y * r.z - w.z * r.y, -(w.x * r.z - w.z * r.x), w.x * r.y - w.y * r.x};
    store_parts(v_out, block.count, v);
    store_parts(w_out, block.count, w);
  }
}

template <class V>
void batch_poses(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  const BatchLanes<V> lanes(arm);
  for (std::size_t begin = 0; begin < count; begin += kLanesOf<V>) {
    const std::size_t k = block_start<V>(begin, count);
    poses_of_block<V>({arm, lanes, q, count, k}, out + k);
  }
}

template <class V>
void batch_jacobians(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  const BatchLanes<V> lanes(arm);
  for (std::size_t begin = 0; begin < count; begin += kLanesOf<V>) {
    const std::size_t k = block_start<V>(begin, count);
    jacobians_of_block<V>({arm, lanes, q, count, k}, out + k);
  }
}

}  // namespace armlet
