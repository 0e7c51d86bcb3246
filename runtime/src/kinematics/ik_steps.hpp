#pragma once

#include "kernels.hpp"

namespace armlet {

// The lower triangle of J^T J, and J^T e; only the first n rows count.
struct NormalEquations {
  double A[kMaxJoints][kMaxJoints];
  double b[kMaxJoints];
};

// J by columns, 6 x n; e has 6 elements.
using NormalKernel = void(int n, const double* J, const double* e, NormalEquations& normal);

// step = (A + damping I)^-1 b.
using StepKernel = void(int n, const NormalEquations& normal, double damping, double* step);

extern const KernelTable<NormalKernel> kNormalKernels;
extern const KernelTable<StepKernel> kStepKernels;

}  // namespace armlet
