#pragma once

#include "branches.hpp"

namespace armlet {

// Arms of one to four revolute joints, whatever their twists and lengths.

// The family; kNone if two neighbouring axes are one line, or if there are more joints than the
// task needs: four parallel axes, four that meet in a point.
ClosedFormKind recognised_few(const CanonicalRows& rows);

// The joint angles that bring the tool point to the position of a goal: one to three joints.
void solve_few_position(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                        Branches& out);

// The joint angles that bring the tool to a pose: the joints before the last one bring a point on
// the last axis to its position, and the last one makes the remaining rotation.
void solve_few_pose(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                    Branches& out);

// The family of an arm of five or six revolute joints whose first three, of any structure, bring
// the point where the last axes meet to its position; kNone if they cannot.
ClosedFormKind recognised_wrist(const CanonicalRows& rows);
void solve_any_wrist(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                     Branches& out);

}  // namespace armlet
