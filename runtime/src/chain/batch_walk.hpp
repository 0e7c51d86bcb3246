#pragma once

#include "batch_blocks.hpp"
#include "walk_in.hpp"

// The recursions of walk_out.hpp and walk_in.hpp with one configuration per lane.
namespace armlet {

// Applies the last part of Z_i.
template <class Block>
[[gnu::always_inline]] inline auto distance(const Block& block, std::size_t i) {
  const auto d = block.d(i);
  return block.arm().slides(i) ? d + block.q(i) * block.arm().q_to_d[i] : d;
}

// The inward recursion from the tool to the base (walk_in.hpp).
template <class Block, class Carried>
[[gnu::always_inline]] inline void walk_in(const Block& block, Carried& carried) {
  const BatchArm& arm = block.arm();
  const auto shift = [&](std::size_t i) __attribute__((always_inline)) {
    if (arm.has_d[i]) carried.shift_z(distance(block, i));
    if (i > 0 && arm.has_a[i]) carried.shift_x(block.a(i));
  };
  carried.start(arm, block.sine(arm.n - 1), block.cosine(arm.n - 1));
  shift(arm.n - 1);
  for (std::size_t i = arm.n - 1; i-- > 0;) {
    step_in(arm, i, block.sine(i), block.cosine(i), carried);
    shift(i);
  }
  if (!arm.base_is_none) carried.place(arm.base);
}

// A frame as four vectors: its axes and its origin in the world.
template <class V>
struct BatchFrame {
  Parts<V> x, y, z, p;

  // At the base.
  [[gnu::always_inline]] explicit BatchFrame(const BatchArm& arm)
      : x(all_lanes_of<V>(arm.base)),
        y(all_lanes_of<V>(arm.base + 3)),
        z(all_lanes_of<V>(arm.base + 6)),
        p(all_lanes_of<V>(arm.base + 9)) {}

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

  [[gnu::always_inline]] void rotate_z(V sine, V cosine) {
    const Parts<V> x_before = x;
    x = cosine * x_before + sine * y;
    y = cosine * y - sine * x_before;
  }
};

// The outward recursion from the base frame to the last joint.
//
// at_axis(i, z, p)  is called after Z_i: the axis of joint i and a point on it.
template <class Block, class AtAxis>
[[gnu::always_inline]] inline void walk_out(const Block& block,
                                            BatchFrame<typename Block::Vector>& frame,
                                            const AtAxis& at_axis) {
  const BatchArm& arm = block.arm();
  for (std::size_t i = 0; i < arm.n; ++i) {
    if (i > 0) frame.step_x(arm, i);
    if (arm.has_d[i]) frame.p = frame.p + distance(block, i) * frame.z;
    frame.rotate_z(block.sine(i), block.cosine(i));
    at_axis(i, frame.z, frame.p);
  }
}

}  // namespace armlet
