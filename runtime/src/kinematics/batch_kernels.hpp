#pragma once

#include "batch_few.hpp"

// Kernels for many configurations, one per lane.
namespace armlet {

// The configurations from number k on: block b of its group.
template <class V>
struct GroupBlock {
  using Vector = V;
  const BatchGroup<V>& group;
  const BatchTurns<V>& turns;
  std::size_t b, k;

  [[gnu::always_inline]] const BatchArm& arm() const { return group.arm; }
  [[gnu::always_inline]] std::size_t count() const { return group.count; }
  [[gnu::always_inline]] V sine(std::size_t i) const { return turns.sine(i, b); }
  [[gnu::always_inline]] V cosine(std::size_t i) const { return turns.cosine(i, b); }
  [[gnu::always_inline]] V turn(std::size_t i) const { return group.lanes.turn[i]; }
  [[gnu::always_inline]] V a(std::size_t i) const { return group.lanes.a[i]; }
  [[gnu::always_inline]] V d(std::size_t i) const { return group.lanes.d[i]; }
  [[gnu::always_inline]] V q(std::size_t i) const {
    return load_lanes<V>(group.q + i * group.count + k);
  }
};

// Of the last part of Z_i.
template <class Block>
[[gnu::always_inline]] inline auto distance(const Block& block, std::size_t i) {
  const auto d = block.d(i);
  return block.arm().slides(i) ? d + block.q(i) * block.arm().slide[i] : d;
}

template <class V>
[[gnu::always_inline]] inline Parts<V> tool_column(const double* T, std::size_t c) {
  return {all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
}

template <class V>
[[gnu::always_inline]] inline Parts<V> cross(const Parts<V>& a, const Parts<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Three columns of a pose; y follows from them at the end.
template <class V>
struct Columns {
  Parts<V> x, z, p;

  [[gnu::always_inline]] void turn_z(V sine, V cosine) {
    x.turn_z(sine, cosine);
    z.turn_z(sine, cosine);
    p.turn_z(sine, cosine);
  }
  [[gnu::always_inline]] void turn_x(V sin_alpha, V cos_alpha) {
    x.turn_x(sin_alpha, cos_alpha);
    z.turn_x(sin_alpha, cos_alpha);
    p.turn_x(sin_alpha, cos_alpha);
  }

  // T and the last Z.
  [[gnu::always_inline]] void start(const BatchArm& arm, V sine, V cosine) {
    z = tool_column<V>(arm.tool, 2);
    p = tool_column<V>(arm.tool, 3);
    if (arm.tool_on_axis) {
      x = {cosine, sine, V{}};
      z.x = z.y = p.x = p.y = V{};
      return;
    }
    x = tool_column<V>(arm.tool, 0);
    turn_z(sine, cosine);
  }

  // Z_i behind X_{i+1}.
  [[gnu::always_inline]] void step(const BatchArm& arm, std::size_t i, V sine, V cosine) {
    if (arm.right_angle(i + 1)) {
      x.turn_right_z(sine, cosine);
      z.turn_right_z(sine, cosine);
      p.turn_right_z(sine, cosine);
      return;
    }
    if (arm.any_angle(i + 1))
      turn_x(all_lanes<V>(arm.sin_alpha[i + 1]), all_lanes<V>(arm.cos_alpha[i + 1]));
    turn_z(sine, cosine);
  }

  // Along the axis of joint i and to the one before it.
  template <class Block>
  [[gnu::always_inline]] void move(const Block& block, std::size_t i) {
    if (block.arm().has_d[i]) p.z += distance(block, i);
    if (i > 0 && block.arm().has_a[i]) p.x += block.a(i);
  }

  [[gnu::always_inline]] void place(const double* base) {
    x.turn_base(base);
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

template <class Block>
[[gnu::always_inline]] inline void poses_of_block(const Block& block, double* out) {
  const BatchArm& arm = block.arm();
  const std::size_t count = block.count();
  Columns<typename Block::Vector> T;
  T.start(arm, block.sine(arm.n - 1), block.cosine(arm.n - 1));
  T.move(block, arm.n - 1);
  for (std::size_t i = arm.n - 1; i-- > 0;) {
    T.step(arm, i, block.sine(i), block.cosine(i));
    T.move(block, i);
  }
  if (!arm.base_is_none) T.place(arm.base);
  store_parts(out, count, T.x);
  store_parts(out + 3 * count, count, cross(T.z, T.x));
  store_parts(out + 6 * count, count, T.z);
  store_parts(out + 9 * count, count, T.p);
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
    if (arm.right_angle(i)) {
      y = z;
      z = {-y_before.x, -y_before.y, -y_before.z};
    } else if (arm.any_angle(i)) {
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

template <class Block>
[[gnu::always_inline]] inline void jacobians_of_block(const Block& block, double* out) {
  using V = typename Block::Vector;
  const BatchArm& arm = block.arm();
  const std::size_t count = block.count();
  Parts<V> axis[kBatchJoints], point[kBatchJoints];
  BatchFrame<V> frame = {parts<V>(arm.base), parts<V>(arm.base + 3), parts<V>(arm.base + 6),
                         parts<V>(arm.base + 9)};
  for (std::size_t i = 0; i < arm.n; ++i) {
    if (i > 0) frame.step_x(arm, i);
    if (arm.has_d[i]) frame.p = frame.p + distance(block, i) * frame.z;
    frame.turn_z(block.sine(i), block.cosine(i));
    axis[i] = frame.z;
    point[i] = frame.p;
  }
  const Parts<V> tool = all_lanes<V>(arm.tool[3]) * frame.x + all_lanes<V>(arm.tool[7]) * frame.y +
                        all_lanes<V>(arm.tool[11]) * frame.z;
  const Parts<V> p = frame.p + tool;
  for (std::size_t i = 0; i < arm.n; ++i) {
    double* v_out = out + 6 * i * count;
    double* w_out = v_out + 3 * count;
    if (arm.slides(i)) {
      store_parts(v_out, count, all_lanes<V>(arm.slide[i]) * axis[i]);
      store_parts(w_out, count, Parts<V>{});
      continue;
    }
    const Parts<V> w = block.turn(i) * axis[i];
    store_parts(v_out, count, cross(w, p - point[i]));
    store_parts(w_out, count, w);
  }
}

struct Poses {
  template <class Block>
  [[gnu::always_inline]] static void write(const Block& block, double* out) {
    poses_of_block(block, out);
  }
};
struct Jacobians {
  template <class Block>
  [[gnu::always_inline]] static void write(const Block& block, double* out) {
    jacobians_of_block(block, out);
  }
};

// Fewer configurations than a group.
template <class V, class What>
[[gnu::noinline]] static void few(const BatchArm& arm, const double* q, std::size_t count,
                                  double* out) {
  const FewBlocks<V> blocks = {arm, q, count};
  const FewTurns<V> turns(blocks);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    What::write(FewBlock<V>{blocks, turns, b}, out + blocks.start(b));
  }
}

// All configurations, a group of blocks at a time.
template <class V, class What>
void batch(const BatchArm& arm, const double* q, std::size_t count, double* out) {
  constexpr std::size_t kLanes = kLanesOf<V>;
  if (count <= (kGroupBlocks - 1) * kLanes) return few<V, What>(arm, q, count, out);
  const BatchLanes<V> lanes(arm);
  for (std::size_t begin = 0; begin < count; begin += kGroupBlocks * kLanes) {
    const BatchGroup<V> group = {arm, lanes, q, count, begin};
    const BatchTurns<V> turns(group);
    for (std::size_t b = 0; b < kGroupBlocks && begin + b * kLanes < count; ++b) {
      const std::size_t k = group.start(b);
      What::write(GroupBlock<V>{group, turns, b, k}, out + k);
    }
  }
}

template <class V>
inline constexpr BatchKernels kBatchKernels = {kLanesOf<V>, batch<V, Poses>, batch<V, Jacobians>};

}  // namespace armlet
