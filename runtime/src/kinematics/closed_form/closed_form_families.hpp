#pragma once

#include "armlet/kinematics/closed_form.hpp"
#include "branches.hpp"

namespace armlet {

// One function per family; `near` has an angle or height per joint for what the goal leaves free.
using FamilySolver = void (*)(const CanonicalRows& rows, const Eigen::Isometry3d& G,
                              const Branch& near, Branches& out);

void solve_plane(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                 Branches& out);
void solve_scara(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                 Branches& out);
void solve_shoulder(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                    Branches& out);
void solve_planar_arm_twist(const CanonicalRows& rows, const Eigen::Isometry3d& G,
                            const Branch& near, Branches& out);
void solve_spherical_wrist(const CanonicalRows& rows, const Eigen::Isometry3d& G,
                           const Branch& near, Branches& out);
void solve_three_parallel(const CanonicalRows& rows, const Eigen::Isometry3d& G, const Branch& near,
                          Branches& out);
void solve_shoulder_elbow_wrist(const CanonicalRows& rows, const Eigen::Isometry3d& G,
                                const Branch& near, Branches& out);

// The first three joint angles that bring the point w, fixed after joint 3, to the position u;
// added to `out` with the rest of `near`. Axes 2 and 3 are parallel, or axes 1 and 2 meet.
void reach_position(const CanonicalRows& rows, const Eigen::Vector3d& u, const Eigen::Vector3d& w,
                    const Branch& near, Branches& out);
// The orientation of a goal in the frame before joint 4, after the first three angles of a branch.
Eigen::Matrix3d left_for_wrist(const CanonicalRows& rows, const Branch& branch, Eigen::Matrix3d M);
// Adds both solutions of the wrist to the branch: joints 4, 5 and 6, whose axes meet in a point,
// make the remaining rotation.
void solve_wrist(const CanonicalRows& rows, const Eigen::Matrix3d& M, const Branch& near,
                 Branch branch, Branches& out);

// The first joint angle of an arm whose axes 2, 3 (and 4) are parallel: it brings the position u to
// the distance `height` along them. For each angle there is the position in the plane across these
// axes, (X, Y); if every angle does so, the branches become free, and joint 1 open.
struct PlaneView {
  Angle theta;  // of joint 1
  double X = 0.0;
  double Y = 0.0;
};
int rotate_into_plane(const CanonicalRows& rows, const Eigen::Vector3d& u, double height,
                      const Angle& near, std::array<PlaneView, 2>& out, Branches& branches);

}  // namespace armlet
