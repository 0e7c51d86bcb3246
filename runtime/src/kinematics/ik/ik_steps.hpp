#pragma once

#include "kinematics/forward/kernels.hpp"

namespace armlet {

// The lower triangle of J^T J, and J^T e; only the first n rows are used.
struct NormalEquations {
  double A[kMaxJoints][kMaxJoints];
  double b[kMaxJoints];
};

// J by columns, 6 x n; e has 6 elements.
using NormalKernel = void(int n, const double* J, const double* e, NormalEquations& normal);

// step = (A + damping I)^-1 b.
using StepKernel = void(int n, const NormalEquations& normal, double damping, double* step);

// The results of one iteration at a configuration.
struct alignas(64) IkIterate {
  std::array<std::array<double, 6>, kMaxJoints> J;
  std::array<double, 6> error;  // position, then rotation; with weights
  NormalEquations normal;
  double energy;              // half the squared error
  double position, rotation;  // sizes of the errors that count, m and rad
  std::array<double, kMaxJoints> step;
  double largest;  // of the step, without sign
};

// All results for a goal p, R (by columns) with equal weights for all rows: error, normal equations
// and the step, in one function, because the latency of an iteration is its cost. The damping is
// damping_ratio times the energy, with the chord of the rotation instead of its angle up to a right
// angle.
using IterationKernel = void(const WalkPlan& plan, const double* q, const double* p,
                             const double* R, double damping_ratio, IkIterate& at);

// The exact rotation vector from T (4x4 by columns) to R. Up to a right angle the iterations use
// half the sum of the cross products of the axes, which has the same direction; a factor makes its
// length exact at zero and correct to half a percent up to there.
void far_rotation_error(const double* T, const double* R, double* w);

extern const KernelTable<IterationKernel> kIterationKernels;
extern const KernelTable<NormalKernel> kNormalKernels;
extern const KernelTable<StepKernel> kStepKernels;

}  // namespace armlet
