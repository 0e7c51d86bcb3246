#include "armlet/math/rotation.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/math/det_math.hpp"

namespace armlet {
namespace {

// Below this cosine of the middle angle the outer two angles are not determined separately.
constexpr double kGimbalLock = 1e-9;

Eigen::Matrix3d rotation_about(int axis, double angle) {
  if (axis == 0) return rot_x(angle);
  return axis == 1 ? rot_y(angle) : rot_z(angle);
}

std::array<int, 3> parse_sequence(std::string_view sequence) {
  std::array<int, 3> axes{};
  bool good = sequence.size() == 3;
  for (std::size_t i = 0; good && i < 3; ++i) {
    axes[i] = sequence[i] - 'X';
    good = axes[i] >= 0 && axes[i] <= 2 && (i == 0 || axes[i] != axes[i - 1]);
  }
  if (!good) {
    throw ArgumentError(fmt::format(
        "\"{}\" is not a sequence of Euler angles; expected three letters X, Y, Z of which no two "
        "neighbours are equal, such as ZYZ.",
        sequence));
  }
  return axes;
}

// +1 if j follows i in the cycle X Y Z, else -1.
double cyclic_sign(int i, int j) { return (i + 1) % 3 == j ? 1.0 : -1.0; }

// The last angle follows from R_i(-a) R, the rotation without the first angle a, of which row j is
// needed. Computed from R itself it would lose digits near gimbal lock, where only the sum of the
// two angles is well defined.
Eigen::RowVector3d row_without_first(const Eigen::Matrix3d& R, double a, int i, int j) {
  const auto [s, c] = det::sincos(a);
  return c * R.row(j) + cyclic_sign(i, j) * s * R.row(3 - i - j);
}

// R = R_i(a) R_j(b) R_i(c); l is the third axis.
Eigen::Vector3d proper_euler(const Eigen::Matrix3d& R, int i, int j) {
  const int l = 3 - i - j;
  const double sign = cyclic_sign(i, j);
  const double sin_b = det::hypot(R(i, j), R(i, l));
  const double a = sin_b <= kGimbalLock ? 0.0 : det::atan2(R(j, i), -sign * R(l, i));
  const Eigen::RowVector3d row = row_without_first(R, a, i, j);
  return {a, det::atan2(sin_b, R(i, i)), det::atan2(-sign * row[l], row[j])};
}

// R = R_i(a) R_j(b) R_k(c) with three different axes.
Eigen::Vector3d three_axis_euler(const Eigen::Matrix3d& R, int i, int j, int k) {
  const double sign = cyclic_sign(i, j);
  const double cos_b = det::hypot(R(i, i), R(i, j));
  const double a = cos_b <= kGimbalLock ? 0.0 : det::atan2(-sign * R(j, k), R(k, k));
  const Eigen::RowVector3d row = row_without_first(R, a, i, j);
  return {a, det::atan2(sign * R(i, k), cos_b), det::atan2(sign * row[i], row[j])};
}

}  // namespace

Eigen::Matrix3d rot_x(double angle) {
  const auto [s, c] = det::sincos(angle);
  Eigen::Matrix3d R;
  R << 1, 0, 0, 0, c, -s, 0, s, c;
  return R;
}

Eigen::Matrix3d rot_y(double angle) {
  const auto [s, c] = det::sincos(angle);
  Eigen::Matrix3d R;
  R << c, 0, s, 0, 1, 0, -s, 0, c;
  return R;
}

Eigen::Matrix3d rot_z(double angle) {
  const auto [s, c] = det::sincos(angle);
  Eigen::Matrix3d R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R;
}

Eigen::Matrix3d R_from_rpy(const Eigen::Vector3d& rpy) {
  return rot_z(rpy.z()) * rot_y(rpy.y()) * rot_x(rpy.x());
}

Eigen::Vector3d rpy_from_R(const Eigen::Matrix3d& R) {
  const double h = det::hypot(R(0, 0), R(1, 0));
  const double roll = h <= kGimbalLock ? 0.0 : det::atan2(R(2, 1), R(2, 2));
  // The y axis of R Rx(-roll) = Rz(yaw) Ry(pitch); near gimbal lock R alone would lose digits.
  const auto [s, c] = det::sincos(roll);
  const Eigen::Vector3d y_axis = c * R.col(1) - s * R.col(2);
  return {roll, det::atan2(-R(2, 0), h), det::atan2(-y_axis.x(), y_axis.y())};
}

Eigen::Matrix3d R_from_euler(std::string_view sequence, const Eigen::Vector3d& angles) {
  const auto [i, j, k] = parse_sequence(sequence);
  return rotation_about(i, angles[0]) * rotation_about(j, angles[1]) * rotation_about(k, angles[2]);
}

Eigen::Vector3d euler_from_R(std::string_view sequence, const Eigen::Matrix3d& R) {
  const auto [i, j, k] = parse_sequence(sequence);
  return i == k ? proper_euler(R, i, j) : three_axis_euler(R, i, j, k);
}

bool is_euler_singular(std::string_view sequence, const Eigen::Matrix3d& R) {
  const auto [i, j, k] = parse_sequence(sequence);
  const int other = i == k ? 3 - i - j : i;
  return det::hypot(R(i, j), R(i, other)) <= kGimbalLock;
}

Eigen::Matrix3d R_from_axis_angle(const Eigen::Vector3d& axis, double angle) {
  const double length = axis.norm();
  if (!(length > 1e-300) || !std::isfinite(length)) {
    throw ArgumentError(
        fmt::format("The axis ({}, {}, {}) has no direction.", axis.x(), axis.y(), axis.z()));
  }
  const auto [s, c] = det::sincos(angle);
  const Eigen::Vector3d k = axis / length;
  const double t = 1.0 - c;
  Eigen::Matrix3d R;
  R << c + t * k.x() * k.x(), t * k.x() * k.y() - s * k.z(), t * k.x() * k.z() + s * k.y(),
      t * k.x() * k.y() + s * k.z(), c + t * k.y() * k.y(), t * k.y() * k.z() - s * k.x(),
      t * k.x() * k.z() - s * k.y(), t * k.y() * k.z() + s * k.x(), c + t * k.z() * k.z();
  return R;
}

Eigen::Matrix3d rotation_exp(const Eigen::Vector3d& phi) {
  const double half = 0.5 * phi.norm();
  const auto [s, c] = det::sincos(half);
  // The ratio of the sine to the half angle tends to 1; half of phi keeps tiny rotations exact.
  const double ratio = half < 1e-12 ? 1.0 : s / half;
  const Eigen::Vector3d v = 0.5 * ratio * phi;
  return R_from_quaternion({c, v.x(), v.y(), v.z()});
}

Eigen::Vector3d rotation_log(const Eigen::Matrix3d& R) {
  const Eigen::Vector4d q = quaternion_from_R(R);
  const Eigen::Vector3d v = q.tail<3>();
  const double length = v.norm();
  if (length < 1e-12) return 2.0 * v;
  return (2.0 * det::atan2(length, q[0]) / length) * v;
}

Eigen::Vector3d axis_of_rotation(const Eigen::Matrix3d& R) {
  const Eigen::Vector3d v = quaternion_from_R(R).tail<3>();
  const double length = v.norm();
  return length == 0.0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(v / length);
}

Eigen::Vector4d quaternion_from_R(const Eigen::Matrix3d& R) {
  // Four times the squares of w, x, y, z; the square root of the largest is accurate.
  const double trace = R.trace();
  const Eigen::Vector4d squares(1.0 + trace, 1.0 - trace + 2.0 * R(0, 0),
                                1.0 - trace + 2.0 * R(1, 1), 1.0 - trace + 2.0 * R(2, 2));
  Eigen::Index largest = 0;
  squares.maxCoeff(&largest);
  Eigen::Vector4d q;
  if (largest == 0) {
    q << squares[0], R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1);
  } else if (largest == 1) {
    q << R(2, 1) - R(1, 2), squares[1], R(1, 0) + R(0, 1), R(0, 2) + R(2, 0);
  } else if (largest == 2) {
    q << R(0, 2) - R(2, 0), R(1, 0) + R(0, 1), squares[2], R(2, 1) + R(1, 2);
  } else {
    q << R(1, 0) - R(0, 1), R(0, 2) + R(2, 0), R(2, 1) + R(1, 2), squares[3];
  }
  q /= q.norm();
  if (q[0] < 0.0) q = -q;
  // Half a revolution about an axis is the same as one about the opposite axis; w is then only a
  // rounding error.
  if (q[0] <= 1e-15) {
    const int first = std::abs(q[1]) > 1e-9 ? 1 : (std::abs(q[2]) > 1e-9 ? 2 : 3);
    if (q[first] < 0.0) q = -q;
    q[0] = std::abs(q[0]);
  }
  return q;
}

Eigen::Matrix3d R_from_quaternion(const Eigen::Vector4d& wxyz) {
  const double length = wxyz.norm();
  if (!(length > 1e-150) || !std::isfinite(length)) {
    throw ArgumentError(fmt::format("The quaternion ({}, {}, {}, {}) has no direction.", wxyz[0],
                                    wxyz[1], wxyz[2], wxyz[3]));
  }
  const Eigen::Vector4d q = wxyz / length;
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  Eigen::Matrix3d R;
  R << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return R;
}

double angle_between(const Eigen::Matrix3d& R_1, const Eigen::Matrix3d& R_2) {
  const Eigen::Vector4d q = quaternion_from_R(R_1.transpose() * R_2);
  return 2.0 * det::atan2(q.tail<3>().norm(), q[0]);
}

Eigen::Matrix3d interpolate(const Eigen::Matrix3d& R_0, const Eigen::Matrix3d& R_1, double s) {
  return R_0 * rotation_exp(s * rotation_log(R_0.transpose() * R_1));
}

Eigen::Matrix3d renormalised(const Eigen::Matrix3d& R) {
  return R_from_quaternion(quaternion_from_R(R));
}

}  // namespace armlet
