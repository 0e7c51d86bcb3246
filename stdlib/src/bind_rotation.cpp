// Orientations by other names: Euler angles of all twelve sequences, quaternions, axis and angle,
// and the exponential of SE(3) (language reference, section 8).

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/math/twist.hpp"
#include "bind.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

using Eigen::Vector3d;

constexpr std::array<std::string_view, 12> kSequences = {"XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ",
                                                         "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};

template <std::size_t kSequence>
Signal from_euler(Vm& vm, Slot* args) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(args[i].d)) return not_finite(vm, "an angle", args[i].d, i);
  }
  const Eigen::Matrix3d R = R_from_euler(kSequences[kSequence], {args[0].d, args[1].d, args[2].d});
  return give(args, new_posc(vm, {make_pose(R, Vector3d::Zero()), true}));
}

// (p, sequence): false if there is no such sequence, and the failure is set.
bool is_sequence(Vm& vm, Slot sequence) {
  const std::string_view name = text_value(sequence);
  for (const std::string_view known : kSequences) {
    if (name == known) return true;
  }
  static_cast<void>(
      failure(vm, "R0609", fmt::format("\"{}\" is not a sequence of Euler angles", name), 1,
              "a sequence is three of the axes X, Y and Z of which no two neighbours are the same",
              "write one such as \"ZYZ\" or \"ZYX\""));
  return false;
}

Signal euler(Vm& vm, Slot* args) {
  if (!is_sequence(vm, args[1])) return Signal::kFail;
  const Vector3d angles = euler_from_R(text_value(args[1]), posc(args[0]).T.linear());
  return give(args, new_reals(vm, {angles.data(), 3}));
}
Signal singular(Vm& vm, Slot* args) {
  if (!is_sequence(vm, args[1])) return Signal::kFail;
  return give(args, is_euler_singular(text_value(args[1]), posc(args[0]).T.linear()));
}

Obj* quaternion(Vm& vm, const PosC& p) {
  const Eigen::Vector4d q = quaternion_from_R(p.T.linear());
  return new_reals(vm, {q.data(), 4});
}
Obj* axis(Vm& vm, const PosC& p) {
  const Vector3d k = axis_of_rotation(p.T.linear());
  return new_reals(vm, {k.data(), 3});
}
Signal angle(Vm&, Slot* args) {
  return give(
      args, angle_between(Eigen::Matrix3d::Identity(), Eigen::Matrix3d(posc(args[0]).T.linear())));
}

Obj* log_pose(Vm& vm, const PosC& p) {
  const Vector6d xi = pose_log(p.T);
  return new_reals(vm, {xi.data(), 6});
}
Answer<PosC> exp_pose(Vm& vm, std::span<const double> v) {
  if (v.size() != 6) {
    return failure(vm, "R0613", fmt::format("a twist has 6 values, not {}", v.size()), 0,
                   "they are v (m) and w (rad), as logPose gives them");
  }
  const Vector6d xi = Eigen::Map<const Vector6d>(v.data());
  for (const double x : v) {
    if (!std::isfinite(x)) return not_finite(vm, "a value of the twist", x, 0);
  }
  const bool turns = std::isfinite(xi.tail<3>().norm());
  const Eigen::Isometry3d T = turns ? pose_exp(xi) : Eigen::Isometry3d::Identity();
  if (!turns || !T.matrix().allFinite())
    return failure(vm, "R0612", "the pose of this twist is not finite: its values are too large",
                   0);
  return PosC{T, true};
}

Signal give_matrix(Vm& vm, Slot* args, const Eigen::Ref<const Eigen::MatrixXd>& A) {
  MatrixObj* matrix =
      new_matrix(vm, static_cast<std::uint32_t>(A.rows()), static_cast<std::uint32_t>(A.cols()));
  if (matrix == nullptr) return Signal::kFail;
  for (Eigen::Index i = 0; i < A.size(); ++i) matrix->data()[i] = A(i / A.cols(), i % A.cols());
  return give(args, matrix);
}

Signal adjoint_of(Vm& vm, Slot* args) { return give_matrix(vm, args, adjoint(posc(args[0]).T)); }
Signal hat_of(Vm& vm, Slot* args) {
  const auto v = reals_value(args[0]);
  if (v.size() != 3)
    return failure(vm, "R0613", fmt::format("hat is of 3 values, not {}", v.size()), 0);
  return give_matrix(vm, args, hat({v[0], v[1], v[2]}));
}

Answer<double> wrapped(Vm& vm, double a) {
  if (!std::isfinite(a)) return not_finite(vm, "the angle", a, 0);
  return wrap_angle(a);
}
Signal turn_between(Vm& vm, Slot* args) {
  for (int i = 0; i < 2; ++i) {
    if (!std::isfinite(args[i].d)) return not_finite(vm, "an angle", args[i].d, i);
  }
  return give(args, angle_difference(args[1].d, args[0].d));
}

// (p, point)
Answer<Obj*> move_point(Vm& vm, const PosC& p, std::span<const double> v) {
  if (v.size() != 3)
    return failure(vm, "R0613", fmt::format("a point has 3 values, not {}", v.size()), 1);
  const Vector3d moved = p.T * Vector3d(v[0], v[1], v[2]);
  return new_reals(vm, {moved.data(), 3});
}

constexpr std::string_view kEuler = "(a: angle, b: angle, c: angle) -> posC";

constexpr NativeFunction kRotationFunctions[] = {
    {"eulerXYX", kEuler, "Turns about the moving axes x, y, x.", "eulerXYX(10deg, 20deg, 30deg)",
     from_euler<0>},
    {"eulerXZX", kEuler, "Turns about the moving axes x, z, x.", "eulerXZX(10deg, 20deg, 30deg)",
     from_euler<1>},
    {"eulerYXY", kEuler, "Turns about the moving axes y, x, y.", "eulerYXY(10deg, 20deg, 30deg)",
     from_euler<2>},
    {"eulerYZY", kEuler, "Turns about the moving axes y, z, y.", "eulerYZY(10deg, 20deg, 30deg)",
     from_euler<3>},
    {"eulerZXZ", kEuler, "Turns about the moving axes z, x, z.", "eulerZXZ(10deg, 20deg, 30deg)",
     from_euler<4>},
    {"eulerZYZ", kEuler, "Turns about the moving axes z, y, z.", "eulerZYZ(10deg, 20deg, 30deg)",
     from_euler<5>},
    {"eulerXYZ", kEuler, "Turns about the moving axes x, y, z.", "eulerXYZ(10deg, 20deg, 30deg)",
     from_euler<6>},
    {"eulerXZY", kEuler, "Turns about the moving axes x, z, y.", "eulerXZY(10deg, 20deg, 30deg)",
     from_euler<7>},
    {"eulerYXZ", kEuler, "Turns about the moving axes y, x, z.", "eulerYXZ(10deg, 20deg, 30deg)",
     from_euler<8>},
    {"eulerYZX", kEuler, "Turns about the moving axes y, z, x.", "eulerYZX(10deg, 20deg, 30deg)",
     from_euler<9>},
    {"eulerZXY", kEuler, "Turns about the moving axes z, x, y.", "eulerZXY(10deg, 20deg, 30deg)",
     from_euler<10>},
    {"eulerZYX", kEuler, "Turns about the moving axes z, y, x.", "eulerZYX(10deg, 20deg, 30deg)",
     from_euler<11>},
    {"posC.euler", "(p: posC, sequence: string) -> angle[]",
     "The three Euler angles of an orientation, about moving axes. The middle one lies in 0 to 180 "
     "deg where the first and third axis are the same, otherwise in -90 to 90 deg; where the "
     "angles are not unique the first is 0.",
     "eulerZYZ(10deg, 20deg, 30deg).euler(\"ZYX\")", euler},
    {"posC.singular", "(p: posC, sequence: string) -> bool",
     "Whether the Euler angles of this sequence are not unique: the first and third axis coincide.",
     "rotY(90deg).singular(\"ZYX\")", singular},
    def<quaternion>("posC.quat(p: posC) -> double[]",
                    "The orientation as a unit quaternion w, x, y, z with w >= 0.",
                    "rotZ(90deg).quat"),
    def<axis>("posC.axis(p: posC) -> double[]",
              "The axis of the turn, a unit vector; that of no turn at all is z.",
              "rotX(20deg).axis"),
    {"posC.angle", "(p: posC) -> angle", "The angle of the turn about its axis, 0 to 180 deg.",
     "rotX(20deg).angle", angle},
    def<log_pose>("logPose(p: posC) -> double[]",
                  "The twist [v; w] (m and rad) that leads from the origin to p in a unit of time.",
                  "logPose(xyz(1m, 0m, 0m) * rotZ(90deg))"),
    def<exp_pose>("expPose(v: double[]) -> posC",
                  "The pose to which a twist [v; w] leads: undoes logPose.",
                  "expPose([0.1, 0.0, 0.0, 0.0, 0.0, 0.5])"),
    {"adjoint", "(p: posC) -> matrix",
     "The 6x6 matrix that takes a twist [v; w] seen in p to the same motion seen in the world's "
     "axes at its origin.",
     "adjoint(xyz(1m, 0m, 0m)) * [0.0, 0.0, 0.0, 0.0, 0.0, 1.0]", adjoint_of},
    {"hat", "(v: double[]) -> matrix", "The cross product as a matrix: hat(a) * b is cross(a, b).",
     "hat([1.0, 2.0, 3.0])", hat_of},
    def<wrapped>("wrapAngle(a: angle) -> angle", "The same direction between -180 and 180 deg.",
                 "wrapAngle(350deg)"),
    {"angleDifference", "(from: angle, to: angle) -> angle",
     "The shortest turn from one angle to another.", "angleDifference(350deg, 10deg)",
     turn_between},
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
