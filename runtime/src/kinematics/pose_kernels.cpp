#include "kernels.hpp"
#include "turns.hpp"

namespace armlet {
namespace {

// Two columns of a pose side by side: their parts along the axes of the frame reached so far.
using Columns = Parts<Lanes>;

// As two columns of a 4x4 matrix.
[[gnu::always_inline]] inline void store(const Columns& columns, double* T, double last) {
  store_pair(T, Lanes{columns.x[0], columns.y[0]});
  store_pair(T + 2, Lanes{columns.z[0], 0.0});
  store_pair(T + 4, Lanes{columns.x[1], columns.y[1]});
  store_pair(T + 6, Lanes{columns.z[1], last});
}

// T and the last Z. The usual tool is a distance along the last axis, which leaves nothing to
// compute.
[[gnu::always_inline]] inline void start(const WalkPlan& plan, Lanes sine, Lanes cosine,
                                         Columns& xy, Columns& zp) {
  const double* T = plan.tool.data();
  if (plan.tool_on_axis) {
    const double flip = T[5];
    xy.x = Lanes{cosine[0], sine[0]} * Lanes{1.0, -flip};
    xy.y = Lanes{sine[0], cosine[0]} * Lanes{1.0, flip};
    xy.z = zp.x = zp.y = both(0.0);
    zp.z = load_pair(T + 10);
    return;
  }
  xy = {load_pair(T), load_pair(T + 4), load_pair(T + 8)};
  zp = {load_pair(T + 2), load_pair(T + 6), load_pair(T + 10)};
  xy.turn_z(sine, cosine);
  zp.turn_z(sine, cosine);
}

// Along the axis of joint i and to the one before it. The position is the right-hand of two
// columns; adding -0 changes nothing.
[[gnu::always_inline]] inline void move(const WalkPlan& plan, const double* q, std::size_t i,
                                        Columns& zp) {
  if (plan.has_d[i]) zp.z += Lanes{-0.0, plan.d[i] + q[i] * plan.slide[i]};
  if (i > 0 && plan.has_a[i]) zp.x += Lanes{-0.0, plan.a[i]};
}

// Z_i behind X_{i+1}.
[[gnu::always_inline]] inline void step(const WalkPlan& plan, std::size_t i, Lanes sine,
                                        Lanes cosine, Columns& xy, Columns& zp) {
  if (plan.right_angle(i + 1)) {
    xy.turn_right_z(sine, cosine);
    zp.turn_right_z(sine, cosine);
    return;
  }
  if (plan.any_angle(i + 1)) {
    const Lanes sin_alpha = both(plan.sin_alpha[i + 1]);
    const Lanes cos_alpha = both(plan.cos_alpha[i + 1]);
    xy.turn_x(sin_alpha, cos_alpha);
    zp.turn_x(sin_alpha, cos_alpha);
  }
  xy.turn_z(sine, cosine);
  zp.turn_z(sine, cosine);
}

// From the tool back to the base: four columns fill two pairs of lanes, whereas a walk out has
// three rows.
template <int N>
void pose_kernel(const WalkPlan& plan, const double* q, double* T_world_tool) {
  const Turns<N> turns(plan, q);
  Columns xy, zp;
  const int n = joint_count<N>(plan);
  start(plan, turns.sine(n - 1), turns.cosine(n - 1), xy, zp);
  move(plan, q, static_cast<std::size_t>(n - 1), zp);
#pragma GCC unroll 8
  for (int joint = n - 2; joint >= 0; --joint) {
    const std::size_t i = static_cast<std::size_t>(joint);
    step(plan, i, turns.sine(joint), turns.cosine(joint), xy, zp);
    move(plan, q, i, zp);
  }
  if (!plan.base_is_none) {
    const double* B = plan.base.data();
    xy.turn_base(B);
    zp.turn_base(B);
    zp.x += Lanes{-0.0, B[9]};
    zp.y += Lanes{-0.0, B[10]};
    zp.z += Lanes{-0.0, B[11]};
  }
  store(xy, T_world_tool, 0.0);
  store(zp, T_world_tool + 8, 1.0);
}

}  // namespace

const KernelTable<PoseKernel> kPoseKernels = {
    pose_kernel<kAnyCount>, pose_kernel<1>, pose_kernel<2>, pose_kernel<3>, pose_kernel<4>,
    pose_kernel<5>,         pose_kernel<6>, pose_kernel<7>, pose_kernel<8>};

}  // namespace armlet
