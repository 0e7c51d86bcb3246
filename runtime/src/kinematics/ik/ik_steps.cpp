#include "ik_steps.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/math/rotation.hpp"
#include "kinematics/forward/walk_jacobian.hpp"

namespace armlet {
namespace {

// Six numbers.
struct Six {
  Lanes a, b, c;

  explicit Six(const double* p) : a(load_pair(p)), b(load_pair(p + 2)), c(load_pair(p + 4)) {}
  // The sums of even and odd products.
  friend Lanes operator*(const Six& x, const Six& y) { return x.a * y.a + x.b * y.b + x.c * y.c; }
};

// The sums of both lanes of p and of q.
inline Lanes sums(Lanes p, Lanes q) { return Lanes{p[0], q[0]} + Lanes{p[1], q[1]}; }

template <int N>
[[gnu::always_inline]] inline void form_normal(int joints, const double* J, const double* e,
                                               NormalEquations& normal) {
  const std::size_t n = static_cast<std::size_t>(joint_count<N>(joints));
  const Six error(e);
#pragma GCC unroll 8
  for (std::size_t i = 0; i < n; ++i) {
    const Six column(J + 6 * i);
#pragma GCC unroll 8
    for (std::size_t k = 0; k < i; k += 2) {
      store_pair(normal.A[i] + k, sums(column * Six(J + 6 * k), column * Six(J + 6 * (k + 1))));
    }
    const Lanes last = sums(column * column, column * error);
    normal.A[i][i] = last[0];
    normal.b[i] = last[1];
  }
}

// L D L^T (G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed., 2013, section 4.1.2), two
// columns at a time. The second column is stored multiplied by the pivot of the first, so its pivot
// need not wait for a division and both divisions run in parallel. A pivot that is only rounding
// belongs to a joint that is linearly dependent on the others, in a redundant or singular arm: this
// joint does not move. Dividing by such a pivot would make the next ones grow without bound.
template <int N>
class Elimination {
 public:
  [[gnu::always_inline]] Elimination(int joints, const NormalEquations& normal, double damping)
      : n_(static_cast<std::size_t>(joint_count<N>(joints))) {
    double trace = 0.0;
#pragma GCC unroll 8
    for (std::size_t i = 0; i < n_; ++i) {
      trace += normal.A[i][i];
#pragma GCC unroll 8
      for (std::size_t k = 0; k < i; ++k) A_[i][k] = normal.A[i][k];
      A_[i][i] = normal.A[i][i] + damping;
      x_[i] = normal.b[i];
    }
    floor_ = 1e-14 * trace + 1e-300;
  }

  [[gnu::always_inline]] void solve(double* step) {
#pragma GCC unroll 8
    for (std::size_t k = 0; k + 1 < n_; k += 2) eliminate(k);
    if (n_ % 2 == 1) {
      const double pivot = A_[n_ - 1][n_ - 1];
      x_[n_ - 1] *= pivot > floor_ ? 1.0 / pivot : 0.0;
    }
#pragma GCC unroll 8
    for (std::size_t behind = n_ % 2; behind + 1 < n_; behind += 2) substitute(n_ - 2 - behind);
    // Stored in pairs, because pairs are loaded next: single stores would stall the load.
    if (n_ % 2 == 1) step[n_ - 1] = x_[n_ - 1];
#pragma GCC unroll 8
    for (std::size_t i = 0; i + 1 < n_; i += 2) store_pair(step + i, Lanes{x_[i], x_[i + 1]});
  }

 private:
  // Eliminates columns k and k + 1 from the rows below, and stores L there.
  [[gnu::always_inline]] void eliminate(std::size_t k) {
    double a = A_[k][k], b = A_[k + 1][k];
    const bool first = a > floor_;
    const double by_a = first ? 1.0 / a : 0.0;
    if (!first) [[unlikely]] {
      a = 1.0;
      b = 0.0;
    }
    const double determinant = a * A_[k + 1][k + 1] - b * b;
    const double by_both = determinant > floor_ * a ? 1.0 / (a * determinant) : 0.0;
    double u[kJointCapacity<N>], v[kJointCapacity<N>];
    const double x_second = a * x_[k + 1] - b * x_[k];
#pragma GCC unroll 8
    for (std::size_t i = k + 2; i < n_; ++i) {
      A_[i][k + 1] = a * A_[i][k + 1] - b * A_[i][k];
      u[i] = by_a * A_[i][k];
      v[i] = by_both * A_[i][k + 1];
      x_[i] -= u[i] * x_[k] + v[i] * x_second;
#pragma GCC unroll 8
      for (std::size_t j = k + 2; j <= i; ++j) A_[i][j] -= u[i] * A_[j][k] + v[i] * A_[j][k + 1];
    }
#pragma GCC unroll 8
    for (std::size_t i = k + 2; i < n_; ++i) {
      A_[i][k] = u[i];
      A_[i][k + 1] = a * v[i];
    }
    A_[k + 1][k] = by_a * b;
    x_[k] *= by_a;
    x_[k + 1] = (a * by_both) * x_second;
  }

  [[gnu::always_inline]] void substitute(std::size_t k) {
#pragma GCC unroll 8
    for (std::size_t i = n_ - 1; i > k + 1; --i) {
      x_[k] -= A_[i][k] * x_[i];
      x_[k + 1] -= A_[i][k + 1] * x_[i];
    }
    x_[k] -= A_[k + 1][k] * x_[k + 1];
  }

  std::size_t n_;
  double floor_;
  double A_[kJointCapacity<N>][kJointCapacity<N>], x_[kJointCapacity<N>];
};

template <int N>
[[gnu::always_inline]] inline void solve_normal(int joints, const NormalEquations& normal,
                                                double damping, double* step) {
  Elimination<N>(joints, normal, damping).solve(step);
}

template <int N>
void normal_kernel(int joints, const double* J, const double* e, NormalEquations& normal) {
  form_normal<N>(joints, J, e, normal);
}

template <int N>
void step_kernel(int joints, const NormalEquations& normal, double damping, double* step) {
  solve_normal<N>(joints, normal, damping, step);
}

// Adds one axis to twice the cosine of the rotation error, and to its cross products.
//
// source  J. Y. S. Luh, M. W. Walker, R. P. C. Paul, Resolved-acceleration control of mechanical
//         manipulators, IEEE TAC 25(3), 1980: the error of an orientation from its three axes.
[[gnu::always_inline]] inline double add_axis(const WalkAxis& axis, const double* goal, Lanes& w_xy,
                                              double& w_z) {
  const Lanes goal_xy = load_pair(goal);
  const Lanes products = axis.xy * goal_xy;
  const Lanes crossed = axis.xy * Lanes{goal_xy[1], goal_xy[0]};
  w_xy += Lanes{axis.xy[1], axis.z} * Lanes{goal[2], goal[0]} -
          Lanes{axis.z, axis.xy[0]} * Lanes{goal[1], goal[2]};
  w_z += crossed[0] - crossed[1];
  return (products[0] + products[1]) + axis.z * goal[2];
}

template <int N>
void iteration_kernel(const WalkPlan& plan, const double* q, const double* p, const double* R,
                      double damping_ratio, IkIterate& at) {
  const WalkFrame f = walk_jacobian<N, PromptJointSines>(plan, q, at.J[0].data());
  Lanes w_xy = both(0.0);
  double w_z = 0.0;
  const double first = add_axis(f.x, R, w_xy, w_z), second = add_axis(f.y, R + 3, w_xy, w_z),
               third = add_axis(f.z, R + 6, w_xy, w_z);
  const double twice_cosine = (first + second) + (third - 1.0);
  // The damping, on which all else depends, uses the squared chord instead of the squared angle.
  double square_of_angle = std::max(0.0, 2.0 - twice_cosine);
  if (twice_cosine < 0.0) [[unlikely]] {
    double T[16], w[3];
    f.store(T, 1.0);
    far_rotation_error(T, R, w);
    w_xy = Lanes{w[0], w[1]};
    w_z = w[2];
    square_of_angle = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
  } else {
    const double factor = 1.0 / (1.28 + 0.36 * twice_cosine);
    w_xy = both(factor) * w_xy;
    w_z = factor * w_z;
  }
  const Lanes e_0 = load_pair(p) - f.p.xy, e_2 = {p[2] - f.p.z, w_xy[0]}, e_4 = {w_xy[1], w_z};
  store_pair(at.error.data(), e_0);
  store_pair(at.error.data() + 2, e_2);
  store_pair(at.error.data() + 4, e_4);
  const Lanes s_0 = e_0 * e_0, s_2 = e_2 * e_2, s_4 = e_4 * e_4;
  const Lanes squares = {(s_0[0] + s_0[1]) + s_2[0], (s_4[0] + s_4[1]) + s_2[1]};
  const Lanes sizes = det::root(squares);
  at.position = sizes[0];
  at.rotation = sizes[1];
  at.energy = 0.5 * (squares[0] + squares[1]);
  const double damping = (0.5 * damping_ratio) * (squares[0] + square_of_angle);
  const int n = joint_count<N>(plan);
  form_normal<N>(n, at.J[0].data(), at.error.data(), at.normal);
  solve_normal<N>(n, at.normal, damping, at.step.data());
  at.largest = 0.0;
#pragma GCC unroll 8
  for (int i = 0; i < n; ++i)
    at.largest = std::max(at.largest, std::abs(at.step[static_cast<std::size_t>(i)]));
}

}  // namespace

void far_rotation_error(const double* T, const double* R, double* w) {
  const Eigen::Map<const Eigen::Matrix4d> T_world_tool(T);
  const Eigen::Map<const Eigen::Matrix3d> R_goal(R);
  Eigen::Map<Eigen::Vector3d> error(w);
  error = rotation_log(R_goal * T_world_tool.topLeftCorner<3, 3>().transpose());
}

constinit const KernelTable<IterationKernel> kIterationKernels =
    kernel_table<IterationKernel>([]<int N>() { return &iteration_kernel<N>; });

constinit const KernelTable<NormalKernel> kNormalKernels =
    kernel_table<NormalKernel>([]<int N>() { return &normal_kernel<N>; });

constinit const KernelTable<StepKernel> kStepKernels =
    kernel_table<StepKernel>([]<int N>() { return &step_kernel<N>; });

}  // namespace armlet
