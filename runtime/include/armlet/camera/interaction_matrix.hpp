#pragma once
// Motion of points in a picture when the camera moves.

#include "armlet/camera/pinhole.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// ds/dt = L [v; w] for k fixed points, in pixels. For a normalised point (x, y) at depth Z
//   L = [ -1/Z   0    x/Z   x y      -(1 + x^2)   y ]
//       [  0   -1/Z   y/Z   1 + y^2  -x y        -x ],
// which d(pixel)/d(x, y) of the camera, distortion included, converts to pixels per second.
//
// pixels   k x 2.
// depth    z of each point in the camera's frame, m, > 0: k numbers, or one for all.
// returns  2k x 6 [u1; v1; u2; ...], for the twist [v; w] of the camera in its own frame.
// errors   those of Pinhole::ray.
// throws   ArgumentError for no points, another number of columns or depths, a depth that is not
//          above zero, a number that is not finite.
// source   F. Chaumette and S. Hutchinson, Visual servo control part I, IEEE Robotics and
//          Automation Magazine 13(4), 2006, eq. 11.
Result<Eigen::MatrixXd> interaction_matrix(const Pinhole& camera, const Eigen::MatrixXd& pixels,
                                           const Eigen::VectorXd& depth);

}  // namespace armlet
