// Other forms of orientations: Euler angles of all twelve sequences, quaternions, axis and angle,
// and the exponential of SE(3) (language reference, section 8).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/math/twist.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/eigen_results.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Eigen::Vector3d;

template <std::size_t kSequence>
Answer<PosC> from_euler(Vm& vm, double a, double b, double c) {
  for (const auto& [angle, part] : {std::pair(a, at("a")), {b, at("b")}, {c, at("c")}})
    if (!std::isfinite(angle)) return not_finite(vm, "an angle", angle, part);
  return PosC{make_pose(R_from_euler(kEulerSequences[kSequence], {a, b, c}), Vector3d::Zero()),
              true};
}

Answer<void> require_sequence(Vm& vm, std::string_view name) {
  if (std::ranges::find(kEulerSequences, name) != kEulerSequences.end()) return {};
  return failure(
      vm, "R0609", fmt::format("\"{}\" is not a sequence of Euler angles", name), at("sequence"),
      "a sequence is three of the axes X, Y and Z of which no two neighbours are the same",
      "write one such as \"ZYZ\" or \"ZYX\"");
}

Answer<Vector3d> euler(Vm& vm, const PosC& p, std::string_view sequence) {
  if (!require_sequence(vm, sequence)) return Failed{};
  return euler_from_R(sequence, p.T.linear());
}
Answer<bool> singular(Vm& vm, const PosC& p, std::string_view sequence) {
  if (!require_sequence(vm, sequence)) return Failed{};
  return is_euler_singular(sequence, p.T.linear());
}

Eigen::Vector4d quaternion_of(const PosC& p) { return quaternion_from_R(p.T.linear()); }
Vector3d axis(const PosC& p) { return axis_of_rotation(p.T.linear()); }
double angle(const PosC& p) {
  return angle_between(Eigen::Matrix3d::Identity(), Eigen::Matrix3d(p.T.linear()));
}

Vector6d log_pose(const PosC& p) { return pose_log(p.T); }
Answer<PosC> exp_pose(Vm& vm, std::span<const double> v) {
  if (v.size() != 6) {
    return failure(vm, "R0613", fmt::format("a twist has 6 values, not {}", v.size()), at("v"),
                   "they are v (m) and w (rad), as logPose gives them");
  }
  const Vector6d xi = Eigen::Map<const Vector6d>(v.data());
  for (const double x : v) {
    if (!std::isfinite(x)) return not_finite(vm, "a value of the twist", x, at("v"));
  }
  const bool turns = std::isfinite(xi.tail<3>().norm());
  const Eigen::Isometry3d T = turns ? pose_exp(xi) : Eigen::Isometry3d::Identity();
  if (!turns || !T.matrix().allFinite())
    return failure(vm, "R0612", "the pose of this twist is not finite: its values are too large",
                   at("v"));
  return PosC{T, true};
}

Eigen::MatrixXd adjoint_of(const PosC& p) { return adjoint(p.T); }
Answer<Eigen::Matrix3d> hat_of(Vm& vm, std::span<const double> v) {
  if (v.size() != 3)
    return failure(vm, "R0613", fmt::format("hat is of 3 values, not {}", v.size()), at("v"));
  return Eigen::Matrix3d(hat({v[0], v[1], v[2]}));
}

Answer<double> wrapped(Vm& vm, double a) {
  if (!std::isfinite(a)) return not_finite(vm, "the angle", a, at("a"));
  return wrap_angle(a);
}
Answer<double> angle_from_to(Vm& vm, double from, double to) {
  if (!std::isfinite(from)) return not_finite(vm, "an angle", from, at("from"));
  if (!std::isfinite(to)) return not_finite(vm, "an angle", to, at("to"));
  return angle_difference(to, from);
}

// (p, point)
Answer<Vector3d> move_point(Vm& vm, const PosC& p, std::span<const double> v) {
  if (v.size() != 3)
    return failure(vm, "R0613", fmt::format("a point has 3 values, not {}", v.size()), at("point"));
  return Vector3d(p.T * Vector3d(v[0], v[1], v[2]));
}

constexpr NativeFunction kRotationFunctions[] = {
    def<from_euler<0>>("eulerXYX(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes x, y, x.", "eulerXYX(10deg, 20deg, 30deg)"),
    def<from_euler<1>>("eulerXZX(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes x, z, x.", "eulerXZX(10deg, 20deg, 30deg)"),
    def<from_euler<2>>("eulerYXY(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes y, x, y.", "eulerYXY(10deg, 20deg, 30deg)"),
    def<from_euler<3>>("eulerYZY(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes y, z, y.", "eulerYZY(10deg, 20deg, 30deg)"),
    def<from_euler<4>>("eulerZXZ(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes z, x, z.", "eulerZXZ(10deg, 20deg, 30deg)"),
    def<from_euler<5>>("eulerZYZ(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes z, y, z.", "eulerZYZ(10deg, 20deg, 30deg)"),
    def<from_euler<6>>("eulerXYZ(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes x, y, z.", "eulerXYZ(10deg, 20deg, 30deg)"),
    def<from_euler<7>>("eulerXZY(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes x, z, y.", "eulerXZY(10deg, 20deg, 30deg)"),
    def<from_euler<8>>("eulerYXZ(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes y, x, z.", "eulerYXZ(10deg, 20deg, 30deg)"),
    def<from_euler<9>>("eulerYZX(a: angle, b: angle, c: angle) -> posC",
                       "Turns about the moving axes y, z, x.", "eulerYZX(10deg, 20deg, 30deg)"),
    def<from_euler<10>>("eulerZXY(a: angle, b: angle, c: angle) -> posC",
                        "Turns about the moving axes z, x, y.", "eulerZXY(10deg, 20deg, 30deg)"),
    def<from_euler<11>>("eulerZYX(a: angle, b: angle, c: angle) -> posC",
                        "Turns about the moving axes z, y, x.", "eulerZYX(10deg, 20deg, 30deg)"),
    def<euler>(
        "posC.euler(p: posC, sequence: string) -> angle[]",
        "The three Euler angles of an orientation, about moving axes. The middle one lies in 0 to "
        "180 "
        "deg where the first and third axis are the same, otherwise in -90 to 90 deg; where the "
        "angles are not unique the first is 0.",
        "eulerZYZ(10deg, 20deg, 30deg).euler(\"ZYX\")",
        {.check = check_word<"sequence", kEulerSequences>}),
    def<singular>("posC.singular(p: posC, sequence: string) -> bool",
                  "Whether the Euler angles of this sequence are not unique: the first and third "
                  "axis coincide.",
                  "rotY(90deg).singular(\"ZYX\")",
                  {.check = check_word<"sequence", kEulerSequences>}),
    def<quaternion_of>("posC.quat(p: posC) -> double[]",
                       "The orientation as a unit quaternion w, x, y, z with w >= 0.",
                       "rotZ(90deg).quat"),
    def<axis>("posC.axis(p: posC) -> double[]",
              "The axis of the turn, a unit vector; that of no turn at all is z.",
              "rotX(20deg).axis"),
    def<angle>("posC.angle(p: posC) -> angle",
               "The angle of the turn about its axis, 0 to 180 deg.", "rotX(20deg).angle"),
    def<log_pose>("logPose(p: posC) -> double[]",
                  "The twist [v; w] (m and rad) that leads from the origin to p in a unit of time.",
                  "logPose(xyz(1m, 0m, 0m) * rotZ(90deg))"),
    def<exp_pose>("expPose(v: double[]) -> posC",
                  "The pose to which a twist [v; w] leads: undoes logPose.",
                  "expPose([0.1, 0.0, 0.0, 0.0, 0.0, 0.5])"),
    def<adjoint_of>(
        "adjoint(p: posC) -> matrix",
        "The 6x6 matrix that takes a twist [v; w] seen in p to the same motion seen in the world's "
        "axes at its origin.",
        "adjoint(xyz(1m, 0m, 0m)) * [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]"),
    def<hat_of>("hat(v: double[]) -> matrix",
                "The cross product as a matrix: hat(a) * b is cross(a, b).",
                "hat([1.0, 2.0, 3.0])"),
    def<wrapped>("wrapAngle(a: angle) -> angle", "The same direction between -180 and 180 deg.",
                 "wrapAngle(350deg)"),
    def<angle_from_to>("angleDifference(from: angle, to: angle) -> angle",
                       "The shortest turn from one angle to another.",
                       "angleDifference(350deg, 10deg)"),
    def<move_point>("operator*(p: posC, point: length[]) -> length[]",
                    "The point as the world sees it that is given as p sees it.",
                    "rotZ(90deg) * [10mm, 0mm, 0mm]"),
    def<move_point>("operator*(p: posC, point: double[]) -> double[]",
                    "The point as the world sees it that is given as p sees it, in metres.",
                    "rotZ(90deg) * [0.1, 0.0, 0.0]"),
};

}  // namespace

std::span<const NativeFunction> rotation_functions() { return kRotationFunctions; }

}  // namespace armlet::bind
