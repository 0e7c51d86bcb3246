#pragma once
// Parameters of a camera and its pose on an arm, from pictures of a known pattern, by OpenCV
// (opencv.hpp).

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"
#include "armlet/math/eigen_layout.hpp"
#include "armlet/vision/plane_points.hpp"

namespace armlet {

// The lens of a camera with the parameters of camera/pinhole.hpp: focal lengths and axis in px, and
// k1, k2, p1, p2, k3.
struct LensNumbers {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  std::array<double, 5> distortion{};
};

// The result of calibrate_camera.
//
// error            root of the mean square distance between observed and computed points, px.
// deviation        standard deviations of fx, fy, cx, cy, k1, k2, p1, p2, k3.
// T_camera_target  pose of the pattern in each view.
struct CameraCalibration {
  LensNumbers lens;
  double error = 0.0;
  std::array<double, 9> deviation{};
  std::vector<Eigen::Isometry3d> T_camera_target;
};

// The lens that fits several views of a flat pattern best, in the least squares of pixels.
//
// views          3 to 30, each n x 2, px: the points of the pattern in their order.
// points         n x 3, n >= 4, m, all with z = 0 and not on a line; at most 2,000 in all views.
// width, height  of the pictures, px.
// terms          number of coefficients k1, k2, p1, p2, k3 that are found: 0, 1, 2, 4 or 5; the
//                others are 0.
// returns  the calibration, or an error "degenerate" if the views do not determine it, because they
//          are all from the same side.
// throws   ArgumentError for lists of different length, counts out of range, numbers that are not
//          finite, and where there is no OpenCV.
// source   Z. Zhang, A flexible new technique for camera calibration, IEEE Trans. PAMI 22, 2000.
Result<CameraCalibration> calibrate_camera(std::span<const PlanePoints> views,
                                           const Eigen::Matrix<double, Eigen::Dynamic, 3>& points,
                                           int width, int height, int terms);

enum class HandEyeMethod : std::uint8_t { kTsai, kPark, kHoraud, kDaniilidis };

// Pose of a camera on the tool; and the root of the mean square distance, m, and angle, rad,
// between the pose of the target found at a station and the mean pose.
struct HandEye {
  Eigen::Isometry3d T_tool_camera = Eigen::Isometry3d::Identity();
  double error = 0.0;
  double tilt = 0.0;
};

// The pose X of the camera on the tool, from stations at which the camera saw a fixed target:
// T_world_tool X T_camera_target is the same for all.
//
// T_world_tool, T_camera_target  3 to 100, in the same order.
// returns  the pose, or an error "degenerate" if the tool did not rotate about two axes that differ
//          by 5 degrees or more.
// throws   ArgumentError for lists of different or other length, matrices that are not poses, and
//          without OpenCV.
// source   R. Tsai, R. Lenz 1989; F. Park, B. Martin 1994; R. Horaud, F. Dornaika 1995;
//          K. Daniilidis 1999.
Result<HandEye> hand_eye(std::span<const Eigen::Isometry3d> T_world_tool,
                         std::span<const Eigen::Isometry3d> T_camera_target,
                         HandEyeMethod method = HandEyeMethod::kPark);

// The picture of a camera without distortion but otherwise equal; black where it shows what this
// picture does not.
//
// image   8 bits.
// throws  ArgumentError for a picture of depths, more than 4,194,304 pixels, focal lengths that are
//         not above 0, numbers that are not finite, and where there is no OpenCV.
Image undistorted(const Image& image, const LensNumbers& lens);

}  // namespace armlet
