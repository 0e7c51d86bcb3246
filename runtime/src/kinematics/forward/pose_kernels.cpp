#include "chain/joint_sines.hpp"
#include "chain/walk_in.hpp"
#include "kernels.hpp"

namespace armlet {
namespace {

// The columns of a pose, two side by side: axes x and y, axis z and the origin.
struct PoseColumns {
  Parts<Lanes> xy, zp;

  // The usual tool is a distance along the last axis, for which nothing is computed.
  [[gnu::always_inline]] void start(const WalkPlan& plan, Lanes sine, Lanes cosine) {
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
    rotate_z(sine, cosine);
  }

  [[gnu::always_inline]] void rotate_z(Lanes sine, Lanes cosine) {
    xy.rotate_z(sine, cosine);
    zp.rotate_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_right_z(Lanes sine, Lanes cosine) {
    xy.rotate_right_z(sine, cosine);
    zp.rotate_right_z(sine, cosine);
  }
  [[gnu::always_inline]] void rotate_x(double sin_alpha, double cos_alpha) {
    const Lanes sine = both(sin_alpha), cosine = both(cos_alpha);
    xy.rotate_x(sine, cosine);
    zp.rotate_x(sine, cosine);
  }

  // The origin is the second of two columns; adding -0 does not change the first one.
  [[gnu::always_inline]] void shift_z(double d) { zp.z += Lanes{-0.0, d}; }
  [[gnu::always_inline]] void shift_x(double a) { zp.x += Lanes{-0.0, a}; }

  [[gnu::always_inline]] void place(const double* B) {
    xy.rotate_base(B);
    zp.rotate_base(B);
    zp.x += Lanes{-0.0, B[9]};
    zp.y += Lanes{-0.0, B[10]};
    zp.z += Lanes{-0.0, B[11]};
  }
};

// As two columns of a 4x4 matrix.
[[gnu::always_inline]] inline void store(const Parts<Lanes>& columns, double* T, double last) {
  store_pair(T, Lanes{columns.x[0], columns.y[0]});
  store_pair(T + 2, Lanes{columns.z[0], 0.0});
  store_pair(T + 4, Lanes{columns.x[1], columns.y[1]});
  store_pair(T + 6, Lanes{columns.z[1], last});
}

// From the tool to the base: four columns fill two pairs of lanes, whereas the outward recursion
// has three rows.
template <int N>
void pose_kernel(const WalkPlan& plan, const double* q, double* T_world_tool) {
  const JointSines<N> angles(plan, q);
  PoseColumns T;
  walk_in(plan, joint_count<N>(plan), q, angles, T);
  store(T.xy, T_world_tool, 0.0);
  store(T.zp, T_world_tool + 8, 1.0);
}

}  // namespace

constinit const KernelTable<PoseKernel> kPoseKernels =
    kernel_table<PoseKernel>([]<int N>() { return &pose_kernel<N>; });

}  // namespace armlet
