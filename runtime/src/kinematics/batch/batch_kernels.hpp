#pragma once

#include "batch_table.hpp"
#include "chain/batch_walk.hpp"

// Tool poses and Jacobians of many configurations, one per lane. Compiled once per instruction set,
// in sources that include nothing else; all give the same bits.
namespace armlet {

template <class V>
[[gnu::always_inline]] inline Parts<V> tool_column(const double* T, std::size_t c) {
  return {all_lanes<V>(T[c]), all_lanes<V>(T[4 + c]), all_lanes<V>(T[8 + c])};
}

// Three columns of a pose; y is computed from them at the end.
template <class V>
struct BatchColumns {
  Parts<V> x, z, p;

  [[gnu::always_inline]] void rotate_z(V sine, V cosine) {
    x.rotate_z(sine, cosine);
    z.rotate_z(sine, cosine);
    p.rotate_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_right_z(V sine, V cosine) {
    x.rotate_right_z(sine, cosine);
    z.rotate_right_z(sine, cosine);
    p.rotate_right_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_x(double sine, double cosine) {
    const V sin_alpha = all_lanes<V>(sine), cos_alpha = all_lanes<V>(cosine);
    x.rotate_x(sin_alpha, cos_alpha);
    z.rotate_x(sin_alpha, cos_alpha);
    p.rotate_x(sin_alpha, cos_alpha);
  }

  [[gnu::always_inline]] void start(const BatchArm& arm, V sine, V cosine) {
    z = tool_column<V>(arm.tool, 2);
    p = tool_column<V>(arm.tool, 3);
    if (arm.tool_on_axis) {
      x = {cosine, sine, V{}};
      z.x = z.y = p.x = p.y = V{};
      return;
    }
    x = tool_column<V>(arm.tool, 0);
    rotate_z(sine, cosine);
  }

  [[gnu::always_inline]] void shift_z(V d) { p.z += d; }
  [[gnu::always_inline]] void shift_x(V a) { p.x += a; }

  [[gnu::always_inline]] void place(const double* base) {
    x.rotate_base(base);
    z.rotate_base(base);
    p.rotate_base(base);
    p.x += base[9];
    p.y += base[10];
    p.z += base[11];
  }
};

struct Poses {
  template <class Block>
  [[gnu::always_inline]] static void write(const Block& block, double* out) {
    const std::size_t count = block.count();
    BatchColumns<typename Block::Vector> T;
    walk_in(block, T);
    store_parts(out, count, T.x);
    store_parts(out + 3 * count, count, cross(T.z, T.x));
    store_parts(out + 6 * count, count, T.z);
    store_parts(out + 9 * count, count, T.p);
  }
};

struct Jacobians {
  template <class Block>
  [[gnu::always_inline]] static void write(const Block& block, double* out) {
    using V = typename Block::Vector;
    const BatchArm& arm = block.arm();
    const std::size_t count = block.count();
    Parts<V> axis[kBatchJoints], point[kBatchJoints];
    BatchFrame<V> frame(arm);
    walk_out(
        block, frame,
        [&](std::size_t i, const Parts<V>& z, const Parts<V>& at) __attribute__((always_inline)) {
          axis[i] = z;
          point[i] = at;
        });
    const Parts<V> tool = all_lanes<V>(arm.tool[3]) * frame.x +
                          all_lanes<V>(arm.tool[7]) * frame.y +
                          all_lanes<V>(arm.tool[11]) * frame.z;
    const Parts<V> p = frame.p + tool;
    for (std::size_t i = 0; i < arm.n; ++i) {
      double* v_out = out + 6 * i * count;
      double* w_out = v_out + 3 * count;
      if (arm.slides(i)) {
        store_parts(v_out, count, all_lanes<V>(arm.q_to_d[i]) * axis[i]);
        store_parts(w_out, count, Parts<V>{});
        continue;
      }
      const Parts<V> w = block.q_to_theta(i) * axis[i];
      store_parts(v_out, count, cross(w, p - point[i]));
      store_parts(w_out, count, w);
    }
  }
};

template <class V>
inline constexpr BatchKernels kBatchKernels = {kLanesOf<V>, batch_kernel<V, Poses>,
                                               batch_kernel<V, Jacobians>};

}  // namespace armlet
