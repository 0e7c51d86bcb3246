#pragma once
// Cameras as values of programs, and points of their pictures as matrices.

#include <string>
#include <string_view>

#include "armlet/cell/cameras.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/image.hpp"
#include "armlet/vision/plane_points.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// A camera of the cell, by its index.
struct CameraRef {
  int id = 0;
};

// The sentence of an error in a form that can follow other words.
[[nodiscard]] inline std::string clause_of(const Error& error) {
  return clause_of(ArgumentError(error.message));
}

// R0684: "this camera cannot see that: ...".
Failed fail_blind(Vm& vm, std::string_view clause, CallPart part = {}, std::string fix = {});

// An N x 2 matrix of pixels, x first; R0613 for another number of columns or no rows, R0612 for a
// coordinate that is not finite: "pixel 3" and `origin`.
Answer<PlanePoints> pixels_of(Vm& vm, const MatrixObj& matrix, CallPart part,
                              std::string_view origin = {});

// Rows of [x, y, z], m; R0613 for another number of values or no rows.
using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;
Answer<Points> points_of(Vm& vm, std::span<const Slot> rows, CallPart part);

// The present pose of the camera.
Answer<Eigen::Isometry3d> pose_now(Vm& vm, const CameraRef& camera);

}  // namespace armlet::bind

namespace armlet {
template <>
inline constexpr const HostType* kHostType<bind::CameraRef> = &bind::kCamera;
}  // namespace armlet
