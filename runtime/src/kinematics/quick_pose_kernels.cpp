#include "kernels.hpp"
#include "quick_turns.hpp"

namespace armlet {
namespace {

// Axes x and z of the tool side by side, and its origin: their parts along the axes of the frame
// reached so far. Axis y follows from them at the end.
struct QuickColumns {
  Parts<Lanes> xz;
  Parts<double> p;

  [[gnu::always_inline]] QuickColumns(const WalkPlan& plan, Lanes sine, Lanes cosine) {
    const double* T = plan.tool.data();
    if (plan.tool_on_axis) {
      xz = {Lanes{cosine[0], 0.0}, Lanes{sine[0], 0.0}, Lanes{0.0, T[10]}};
      p = {0.0, 0.0, T[11]};
      return;
    }
    xz = {Lanes{T[0], T[2]}, Lanes{T[4], T[6]}, Lanes{T[8], T[10]}};
    p = {T[3], T[7], T[11]};
    turn_z(sine, cosine);
  }

  [[gnu::always_inline]] void turn_z(Lanes sine, Lanes cosine) {
    xz.turn_z(sine, cosine);
    p.turn_z(sine[0], cosine[0]);
  }

  // Z_i behind X_{i+1}.
  [[gnu::always_inline]] void step(const WalkPlan& plan, std::size_t i, Lanes sine, Lanes cosine) {
    if (plan.right_angle(i + 1)) {
      xz.turn_right_z(sine, cosine);
      p.turn_right_z(sine[0], cosine[0]);
      return;
    }
    if (plan.any_angle(i + 1)) {
      const double sin_alpha = plan.sin_alpha[i + 1], cos_alpha = plan.cos_alpha[i + 1];
      xz.turn_x(both(sin_alpha), both(cos_alpha));
      p.turn_x(sin_alpha, cos_alpha);
    }
    turn_z(sine, cosine);
  }

  // Along the axis of joint i and to the one before it.
  [[gnu::always_inline]] void move(const WalkPlan& plan, const double* q, std::size_t i) {
    if (plan.has_d[i]) p.z += plan.d[i] + q[i] * plan.slide[i];
    if (i > 0 && plan.has_a[i]) p.x += plan.a[i];
  }

  [[gnu::always_inline]] void place(const WalkPlan& plan) {
    if (plan.base_is_none) return;
    const double* B = plan.base.data();
    xz.turn_base(B);
    p.turn_base(B);
    p.x += B[9];
    p.y += B[10];
    p.z += B[11];
  }

  [[gnu::always_inline]] void store(double* out) const {
    const double x[] = {xz.x[0], xz.y[0], xz.z[0]};
    const double z[] = {xz.x[1], xz.y[1], xz.z[1]};
    store_pair(out, Lanes{x[0], x[1]});
    store_pair(out + 2, Lanes{x[2], z[1] * x[2] - z[2] * x[1]});
    store_pair(out + 4, Lanes{z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]});
    store_pair(out + 6, Lanes{z[0], z[1]});
    store_pair(out + 8, Lanes{z[2], p.x});
    store_pair(out + 10, Lanes{p.y, p.z});
  }
};

// The operations of the batch's kernel, each rounded like there.
template <int N>
void quick_pose_kernel(const WalkPlan& plan, const double* q, double* columns) {
  const QuickTurns<N, true> turns(plan, q);
  const int n = joint_count<N>(plan);
  QuickColumns T(plan, turns.sine(n - 1), turns.cosine(n - 1));
  T.move(plan, q, static_cast<std::size_t>(n - 1));
#pragma GCC unroll 8
  for (int joint = n - 2; joint >= 0; --joint) {
    const std::size_t i = static_cast<std::size_t>(joint);
    T.step(plan, i, turns.sine(joint), turns.cosine(joint));
    T.move(plan, q, i);
  }
  T.place(plan);
  T.store(columns);
}

}  // namespace

const KernelTable<QuickPoseKernel> kQuickPoseKernels = {
    quick_pose_kernel<kAnyCount>, quick_pose_kernel<1>, quick_pose_kernel<2>,
    quick_pose_kernel<3>,         quick_pose_kernel<4>, quick_pose_kernel<5>,
    quick_pose_kernel<6>,         quick_pose_kernel<7>, quick_pose_kernel<8>};

}  // namespace armlet
