#pragma once

#include "chain/by_joints.hpp"

namespace armlet {

// The kernels of kinematics: functions of plain arrays, with one instance per number of joints.
// Sizes are not checked.
//
// q        n joint values.
// T, J     4x4 and 6xn matrices by columns.
// throws   ArgumentError if a joint value is not finite.
using PoseKernel = void(const WalkPlan& plan, const double* q, double* T_world_tool);
using QuickPoseKernel = void(const WalkPlan& plan, const double* q, double* columns);
using FramesKernel = void(const WalkPlan& plan, const double* q, double* frames,
                          double* T_world_tool);
using JacobianKernel = void(const WalkPlan& plan, const double* q, double* J);
using PoseAndJacobianKernel = void(const WalkPlan& plan, const double* q, double* J,
                                   double* T_world_tool);

extern const KernelTable<PoseKernel> kPoseKernels;
extern const KernelTable<FramesKernel> kFramesKernels;
extern const KernelTable<JacobianKernel> kJacobianKernels;
extern const KernelTable<PoseAndJacobianKernel> kPoseAndJacobianKernels;

// A batch of one configuration, with the bits that it has in every batch: axes x, y, z and origin
// of the tool, and the columns of the Jacobian.
extern const KernelTable<QuickPoseKernel> kQuickPoseKernels;
extern const KernelTable<JacobianKernel> kQuickJacobianKernels;

}  // namespace armlet
