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
  det::LaneTable<V> numbers;

  [[gnu::always_inline]] explicit BatchLanes(const BatchArm& arm) {
    for (std::size_t i = 0; i < arm.n; ++i) {
      theta[i] = all_lanes<V>(arm.theta[i]);
      turn[i] = all_lanes<V>(arm.turn[i]);
      d[i] = all_lanes<V>(arm.d[i]);
      a[i] = all_lanes<V>(arm.a[i]);
    }
  }

  // The compiler must not know that they are constants: it would bring each into a register again.
  [[gnu::always_inline]] const det::LaneTable<V>& hidden_numbers() const {
    const det::LaneTable<V>* hidden = &numbers;
    asm("" : "+r"(hidden));
    return *hidden;
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
  [[gnu::always_inline]] V angle(std::size_t i) const {
    return arm.plain[i] ? values(i) : lanes.theta[i] + values(i) * lanes.turn[i];
  }
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

  [[gnu::always_inline]] void put(std::size_t i, const det::LaneSinCos<V>& turn) {
    store_lanes(sines + i * kLanes, turn.sin);
    store_lanes(cosines + i * kLanes, turn.cos);
  }

  [[gnu::always_inline]] explicit BatchTurns(const Block<V>& block) {
    const det::LaneTable<V>& numbers = block.lanes.hidden_numbers();
    det::LaneCheck<V> check;
    const std::size_t n = block.arm.n;
    for (std::size_t i = 0; i + 1 < n; i += 2) {
      const auto turns =
          det::sincos_lanes(det::TwoLanes<V>{block.angle(i), block.angle(i + 1)}, check, numbers);
      put(i, turns.a);
      put(i + 1, turns.b);
    }
    if (n % 2 != 0) put(n - 1, det::sincos_lanes(block.angle(n - 1), check, numbers));
    if (!check.all_settled()) {
      careful_batch_turns(block.arm, block.q, block.count, block.k, kLanes, sines, cosines);
    }
  }
};

template <class V>
[[gnu::always_inline]] inline Parts<V> tool_column(const double* T, std::size_t c) {
  return {all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
}

// The four columns of a pose.
template <class V>
struct Columns {
  Parts<V> x, y, z, p;

  [[gnu::always_inline]] void turn_z(V sine, V cosine) {
    x.turn_z(sine, cosine);
    y.turn_z(sine, cosine);
    z.turn_z(sine, cosine);
    p.turn_z(sine, cosine);
  }
  [[gnu::always_inline]] void turn_x(V sin_alpha, V cos_alpha) {
    x.turn_x(sin_alpha, cos_alpha);
    y.turn_x(sin_alpha, cos_alpha);
    z.turn_x(sin_alpha, cos_alpha);
    p.turn_x(sin_alpha, cos_alpha);
  }

  // T and the last Z.
  [[gnu::always_inline]] void start(const BatchArm& arm, V sine, V cosine) {
    z = tool_column<V>(arm.tool, 2);
    p = tool_column<V>(arm.tool, 3);
    if (arm.tool_on_axis) {
      const double flip = arm.tool[5];
      x = {cosine, sine, V{}};
      y = {sine * -flip, cosine * flip, V{}};
      z.x = z.y = p.x = p.y = V{};
      return;
    }
    x = tool_column<V>(arm.tool, 0);
    y = tool_column<V>(arm.tool, 1);
    turn_z(sine, cosine);
  }

  // Z_i behind X_{i+1}.
  [[gnu::always_inline]] void step(const BatchArm& arm, std::size_t i, V sine, V cosine) {
    if (arm.right_angle[i + 1]) {
      x.turn_right_z(sine, cosine);
      y.turn_right_z(sine, cosine);
      z.turn_right_z(sine, cosine);
      p.turn_right_z(sine, cosine);
      return;
    }
    if (arm.any_angle[i + 1])
      turn_x(all_lanes<V>(arm.sin_alpha[i + 1]), all_lanes<V>(arm.cos_alpha[i + 1]));
    turn_z(sine, cosine);
  }

  // Along the axis of joint i and to the one before it.
  [[gnu::always_inline]] void move(const Block<V>& block, std::size_t i) {
    if (block.arm.has_d[i]) p.z += block.distance(i);
    if (i > 0 && block.arm.has_a[i]) p.x += block.lanes.a[i];
  }

  [[gnu::always_inline]] void place(const double* base) {
    x.turn_base(base);
    y.turn_base(base);
    z.turn_base(base);
    p.turn_base(base);
    p.x += base[9];
    p.y += base[10];
    p.z += base[11];
  }
};

template <class V>
[[gnu::always_inline]] inline void store_parts(double* out, std::size_t count, const Parts<V>& v) {
  store_lanes(out, v.x);
  store_lanes(out + count, v.y);
  store_lanes(out + 2 * count, v.z);
}

template <class V>
[[gnu::always_inline]] inline void poses_of_block(const Block<V>& block, double* out) {
  const BatchArm& arm = block.arm;
  const BatchTurns<V> turns(block);
  Columns<V> T;
  T.start(arm, turns.sine(arm.n - 1), turns.cosine(arm.n - 1));
  T.move(block, arm.n - 1);
  for (std::size_t i = arm.n - 1; i-- > 0;) {
    T.step(arm, i, turns.sine(i), turns.cosine(i));
    T.move(block, i);
  }
  if (!arm.base_is_none) T.place(arm.base);
  store_parts(out, block.count, T.x);
  store_parts(out + 3 * block.count, block.count, T.y);
  store_parts(out + 6 * block.count, block.count, T.z);
  store_parts(out + 9 * block.count, block.count, T.p);
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
