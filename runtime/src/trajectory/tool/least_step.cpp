#include "trajectory/tool/least_step.hpp"

#include <vector>

#include "math/solvers.hpp"

namespace armlet {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The step of the joints in `free`; the others are held at their values in x.
VectorXd step_of(const StepTask& task, const std::vector<Eigen::Index>& free, const VectorXd& x) {
  const MatrixXd A = task.A(Eigen::all, free);
  const SymmetricFactors<Eigen::Dynamic> cost(task.W(free, free));
  const MatrixXd moving = cost.solve_all(A.transpose());
  const VectorXd wished = cost.solve(VectorXd((task.g - task.W * x)(free)));
  const VectorXd left = task.b - task.A * x - A * wished;
  return wished + moving * SymmetricFactors<Eigen::Dynamic>(A * moving).solve(left);
}

}  // namespace

std::optional<VectorXd> least_step(const StepTask& task, const VectorXd& lower,
                                   const VectorXd& upper) {
  std::vector<Eigen::Index> free(static_cast<std::size_t>(task.g.size()));
  for (std::size_t i = 0; i < free.size(); ++i) free[i] = static_cast<Eigen::Index>(i);
  VectorXd held = VectorXd::Zero(task.g.size());
  while (static_cast<Eigen::Index>(free.size()) >= task.b.size()) {
    const VectorXd step = step_of(task, free, held);
    if (!step.allFinite()) return std::nullopt;
    std::size_t worst = free.size();
    double most = 0.0;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const double x = step[static_cast<Eigen::Index>(k)];
      const double beyond = std::max(lower[free[k]] - x, x - upper[free[k]]);
      if (beyond <= most) continue;
      most = beyond;
      worst = k;
    }
    if (worst == free.size()) {
      held(free) = step;
      return held;
    }
    const Eigen::Index i = free[worst];
    held[i] = step[static_cast<Eigen::Index>(worst)] > upper[i] ? upper[i] : lower[i];
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  return std::nullopt;
}

}  // namespace armlet
