#include "kernels.hpp"
#include "turns.hpp"

namespace armlet {
namespace {

// Two columns of a pose side by side: their parts along the axes of the frame reached so far.
using Columns = Parts<Lanes>;

// Z behind X_next.
[[gnu::always_inline]] inline void step(Columns& columns, const WalkPlan& plan, std::size_t next,
                                        Twist twist, Lanes sine, Lanes cosine) {
  if (twist == Twist::kRightAngle) {
    columns.turn_right_z(sine, cosine);
    return;
  }
  if (twist == Twist::kAny) columns.turn_x(both(plan.sin_alpha[next]), both(plan.cos_alpha[next]));
  columns.turn_z(sine, cosine);
}

// As two columns of a 4x4 matrix.
[[gnu::always_inline]] inline void store(const Columns& columns, double* T, double last) {
  store_pair(T, Lanes{columns.x[0], columns.y[0]});
  store_pair(T + 2, Lanes{columns.z[0], 0.0});
  store_pair(T + 4, Lanes{columns.x[1], columns.y[1]});
  store_pair(T + 6, Lanes{columns.z[1], last});
}

// What moves the position, the right-hand one of two columns; adding -0 changes nothing.
inline Lanes moved(double distance) { return Lanes{-0.0, distance}; }

// From the tool back to the base: four columns fill two pairs of lanes, whereas a walk out has
// three rows.
template <int N>
void pose_kernel(const WalkPlan& plan, const double* q, double* T_world_tool) {
  const Turns<N> turns(plan, q);
  const double* T = plan.tool.data();
  Columns xy = {load_pair(T), load_pair(T + 4), load_pair(T + 8)};
  Columns zp = {load_pair(T + 2), load_pair(T + 6), load_pair(T + 10)};
  const int n = joint_count<N>(plan);
#pragma GCC unroll 8
  for (int joint = n - 1; joint >= 0; --joint) {
    const std::size_t i = static_cast<std::size_t>(joint);
    const Lanes s = turns.sine(joint);
    const Lanes c = turns.cosine(joint);
    const Twist twist = joint + 1 < n ? plan.twist[i + 1] : Twist::kNone;
    step(xy, plan, i + 1, twist, s, c);
    step(zp, plan, i + 1, twist, s, c);
    if (plan.has_d[i]) zp.z += moved(plan.d[i] + q[i] * plan.slide[i]);
    if (joint > 0 && plan.has_a[i]) zp.x += moved(plan.a[i]);
  }
  if (!plan.base_is_none) {
    const double* B = plan.base.data();
    xy.turn_base(B);
    zp.turn_base(B);
    zp.x += moved(B[9]);
    zp.y += moved(B[10]);
    zp.z += moved(B[11]);
  }
  store(xy, T_world_tool, 0.0);
  store(zp, T_world_tool + 8, 1.0);
}

}  // namespace

const KernelTable<PoseKernel> kPoseKernels = {
    pose_kernel<kAnyCount>, pose_kernel<1>, pose_kernel<2>, pose_kernel<3>, pose_kernel<4>,
    pose_kernel<5>,         pose_kernel<6>, pose_kernel<7>, pose_kernel<8>};

}  // namespace armlet
