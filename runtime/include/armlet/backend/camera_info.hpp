// Cameras of a run, and the pictures that they take.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// The link of a CameraInfo that is the flange.
inline constexpr int kCameraFlange = -1;

// A camera of the run. Its frame: z forward, x right, y down; pixel centres are integers.
//
// width, height, fx, fy, cx, cy  pixels.
// distortion  k1, k2, p1, p2, k3 of Brown and Conrady.
// near, far   smallest and largest depth that is seen, m.
// rate        pictures a second; 0: whenever one is asked for.
// robot       index of the robot that carries it; -1: none. `link`: the joint that moves its link,
//             0: the base; or kCameraFlange.
// object, frame  name of the object or the frame of the world that it is mounted on; empty: none.
// T_on_camera    its pose there, or in the world.
struct CameraInfo {
  std::string name;
  int width = 0;
  int height = 0;
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;
  std::array<double, 5> distortion{};
  double near = 0.0;
  double far = 0.0;
  double rate = 0.0;
  int robot = -1;
  int link = kCameraFlange;
  std::string object;
  std::string frame;
  Eigen::Isometry3d T_on_camera = Eigen::Isometry3d::Identity();
};

// A picture that a camera has taken. Its pixels and names are valid only during the call.
//
// camera    name of the camera.
// frame     number among the pictures of that camera, from 0.
// channels  1: grey, 3: red, green and blue; a byte each.
// pixels    width * height * channels bytes: rows from the top, each from the left.
// T_world_camera  pose of the camera.
// file      path written by FrameFiles; empty: none.
struct ImageFrame {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  std::string_view camera;
  std::uint64_t frame = 0;
  int width = 0;
  int height = 0;
  int channels = 3;
  std::span<const std::uint8_t> pixels;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::string_view file;
};

// The FNV-1a hash of the pixels.
[[nodiscard]] std::uint64_t pixel_hash(const ImageFrame& frame);
[[nodiscard]] std::uint64_t pixel_hash(std::span<const std::uint8_t> pixels);

}  // namespace armlet
