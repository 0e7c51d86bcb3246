#pragma once

#include "armlet/vision/planar_pose.hpp"

namespace armlet {

// The pose of points that need not lie in a plane from one picture of them, by OpenCV (opencv.hpp),
// refined by least squares.
//
// points  n x 3, 4 <= n <= 100,000, of the object in its own frame, m.
// seen    n x 2, x = X/Z and y = Y/Z, without distortion.
// returns the pose with its error like planar_pose, or an error "degenerate" if no pose has all
// points in front of the camera.
// throws  ArgumentError for lists of different or other length, numbers that are not finite, and
//         without OpenCV.
// source  G. Terzakis, M. Lourakis, A consistently fast and globally optimal solution to the
//         perspective-n-point problem, ECCV 2020 (SQPnP).
Result<FoundPose> solid_pose(const Eigen::Matrix<double, Eigen::Dynamic, 3>& points,
                             const PlanePoints& seen);

}  // namespace armlet
