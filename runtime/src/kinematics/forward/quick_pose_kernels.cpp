#include "chain/quick_sines.hpp"
#include "chain/walk_in.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

// Axes x and z of the tool side by side, and its origin, in the axes of the current frame. Axis y
// is computed from them at the end.
struct QuickColumns {
  Parts<Lanes> xz;
  Parts<double> p;

  [[gnu::always_inline]] void start(const WalkPlan& plan, Lanes sine, Lanes cosine) {
    const double* T = plan.tool.data();
    if (plan.tool_on_axis) {
      xz = {Lanes{cosine[0], 0.0}, Lanes{sine[0], 0.0}, Lanes{0.0, T[10]}};
      p = {0.0, 0.0, T[11]};
      return;
    }
    xz = {Lanes{T[0], T[2]}, Lanes{T[4], T[6]}, Lanes{T[8], T[10]}};
    p = {T[3], T[7], T[11]};
    rotate_z(sine, cosine);
  }

  [[gnu::always_inline]] void rotate_z(Lanes sine, Lanes cosine) {
    xz.rotate_z(sine, cosine);
    p.rotate_z(sine[0], cosine[0]);
  }
  [[gnu::always_inline]] void rotate_right_z(Lanes sine, Lanes cosine) {
    xz.rotate_right_z(sine, cosine);
    p.rotate_right_z(sine[0], cosine[0]);
  }
  [[gnu::always_inline]] void rotate_x(double sin_alpha, double cos_alpha) {
    xz.rotate_x(both(sin_alpha), both(cos_alpha));
    p.rotate_x(sin_alpha, cos_alpha);
  }

  [[gnu::always_inline]] void shift_z(double d) { p.z += d; }
  [[gnu::always_inline]] void shift_x(double a) { p.x += a; }

  [[gnu::always_inline]] void place(const double* B) {
    xz.rotate_base(B);
    p.rotate_base(B);
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

// The operations of the batch's kernel, with the same rounding.
template <int N>
void quick_pose_kernel(const WalkPlan& plan, const double* q, double* columns) {
  const QuickJointSines<N, true> angles(plan, q);
  QuickColumns T;
  walk_in(plan, joint_count<N>(plan), q, angles, T);
  T.store(columns);
}

}  // namespace

constinit const KernelTable<QuickPoseKernel> kQuickPoseKernels =
    kernel_table<QuickPoseKernel>([]<int N>() { return &quick_pose_kernel<N>; });

}  // namespace armlet
