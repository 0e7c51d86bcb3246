// Positions and frames (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Refuses infinite and undefined numbers before they get into a position.
bool all_finite(Vm& vm, Slot* args, int count, std::string_view what) {
  for (int i = 0; i < count; ++i) {
    if (!std::isfinite(args[i].d)) {
      static_cast<void>(not_finite(vm, what, args[i].d, i));
      return false;
    }
  }
  return true;
}

Signal give_pose(Vm& vm, Slot* args, const Isometry3d& T, bool has_orientation) {
  return give(args, new_posc(vm, {T, has_orientation}));
}

Signal xyz(Vm& vm, Slot* args) {
  if (!all_finite(vm, args, 3, "a coordinate")) return Signal::kFail;
  return give_pose(vm, args, make_translation({args[0].d, args[1].d, args[2].d}), false);
}
template <Eigen::Matrix3d (*kRotate)(double)>
Signal turn(Vm& vm, Slot* args) {
  if (!all_finite(vm, args, 1, "the angle")) return Signal::kFail;
  return give_pose(vm, args, make_pose(kRotate(args[0].d), Vector3d::Zero()), true);
}
Signal rpy(Vm& vm, Slot* args) {
  if (!all_finite(vm, args, 3, "an angle")) return Signal::kFail;
  return give_pose(vm, args, pose_from_rpy(Vector3d::Zero(), {args[0].d, args[1].d, args[2].d}),
                   true);
}
Signal pose(Vm& vm, Slot* args) {
  if (!all_finite(vm, args, 6, "a coordinate or angle")) return Signal::kFail;
  return give_pose(
      vm, args, pose_from_rpy({args[0].d, args[1].d, args[2].d}, {args[3].d, args[4].d, args[5].d}),
      true);
}
Signal quaternion(Vm& vm, Slot* args) {
  if (!all_finite(vm, args, 4, "a value of the quaternion")) return Signal::kFail;
  Eigen::Vector4d q(args[0].d, args[1].d, args[2].d, args[3].d);
  if (!std::isfinite(q.norm())) q /= q.cwiseAbs().maxCoeff();  // its length does not matter
  if (q.norm() < 1e-9) return failure(vm, "R0609", "a quaternion of zeros has no direction");
  return give_pose(vm, args, make_pose(R_from_quaternion(q), Vector3d::Zero()), true);
}
Signal axis_angle(Vm& vm, Slot* args) {
  const auto axis = reals_value(args[0]);
  if (axis.size() != 3)
    return failure(vm, "R0613", fmt::format("an axis has 3 values, not {}", axis.size()), 0);
  Vector3d v(axis[0], axis[1], axis[2]);
  if (!v.allFinite()) return not_finite(vm, "a value of the axis", v.sum(), 0);
  if (!std::isfinite(v.norm())) v /= v.cwiseAbs().maxCoeff();
  if (!std::isfinite(args[1].d)) return not_finite(vm, "the angle", args[1].d, 1);
  if (v.norm() < 1e-12) return failure(vm, "R0609", "an axis of zeros has no direction", 0);
  return give_pose(vm, args, make_pose(R_from_axis_angle(v, args[1].d), Vector3d::Zero()), true);
}

Signal inverse(Vm& vm, Slot* args) {
  const PosC& p = posc(args[0]);
  return give_pose(vm, args, p.T.inverse(), p.has_orientation);
}
Signal compose(Vm& vm, Slot* args) {
  const PosC& a = posc(args[0]);
  const PosC& b = posc(args[1]);
  return give_pose(vm, args, renormalised(a.T * b.T), a.has_orientation || b.has_orientation);
}
Signal above(Vm& vm, Slot* args) {
  PosC p = posc(args[0]);
  if (!std::isfinite(args[1].d)) return not_finite(vm, "the height", args[1].d, 1);
  p.T.translation().z() += args[1].d;
  return give(args, new_posc(vm, p));
}
Signal distance(Vm&, Slot* args) {
  return give(args, (posc(args[0]).T.translation() - posc(args[1]).T.translation()).norm());
}
Signal angle_of_turn(Vm&, Slot* args) {
  return give(args, angle_between(posc(args[0]).T, posc(args[1]).T));
}

// The frame at `from` whose z axis looks at `to` and whose x axis stays level (a camera's axes).
Signal look_at(Vm& vm, Slot* args) {
  const auto a = reals_value(args[0]);
  const auto b = reals_value(args[1]);
  if (a.size() != 3 || b.size() != 3)
    return size_failure(vm, "lookAt needs two places of 3 values", a.size(), b.size());
  const Vector3d from(a[0], a[1], a[2]);
  const Vector3d to(b[0], b[1], b[2]);
  const Vector3d way = to - from;
  if (!way.allFinite() || way.norm() < 1e-12)
    return failure(vm, "R0609", "lookAt needs two different places");
  const Vector3d z = way.normalized();
  Vector3d x = z.cross(Vector3d::UnitZ());
  if (x.norm() < 1e-9) x = Vector3d::UnitX();
  x.normalize();
  Eigen::Matrix3d R;
  R << x, z.cross(x), z;
  return give_pose(vm, args, make_pose(R, from), true);
}

Signal near_places(Vm& vm, Slot* args) {
  const PosC& a = posc(args[0]);
  const PosC& b = posc(args[1]);
  static_cast<void>(vm);
  const bool near = (a.T.translation() - b.T.translation()).norm() <= args[2].d;
  return give(args, near && (is_absent(args[3]) || angle_between(a.T, b.T) <= args[3].d));
}
// Places that are compared have the same digits.
std::string place_text(const PosC& p, int digits) {
  const Eigen::Vector3d mm = p.T.translation() * 1000.0;
  return fmt::format("({:.{}f}, {:.{}f}, {:.{}f}) mm", mm.x(), digits, mm.y(), digits, mm.z(),
                     digits);
}
Signal explain_near_places(Vm& vm, Slot* args) {
  const PosC& a = posc(args[0]);
  const PosC& b = posc(args[1]);
  const double gap = (a.T.translation() - b.T.translation()).norm();
  if (!is_absent(args[3]) && gap <= args[2].d) {
    return give(args, new_text(vm, fmt::format("the orientations differ by {}",
                                               format_deg(angle_between(a.T, b.T)))));
  }
  const int digits = gap < 0.0001 ? 4 : 1;
  return give(args, new_text(vm, fmt::format("the positions differ by {} mm\n{}\n{}",
                                             format_number(gap * 1000.0, digits),
                                             place_text(a, digits), place_text(b, digits))));
}
Signal near_joints(Vm&, Slot* args) {
  const PosJ& a = posj(args[0]);
  const PosJ& b = posj(args[1]);
  if (a.n != b.n) return give(args, false);
  for (int i = 0; i < a.n; ++i) {
    if (!(std::abs(a.q[i] - b.q[i]) <= args[2].d)) return give(args, false);
  }
  return give(args, true);
}

Signal lerp_places(Vm& vm, Slot* args) {
  const PosC& a = posc(args[0]);
  const PosC& b = posc(args[1]);
  if (!std::isfinite(args[2].d)) return not_finite(vm, "the fraction", args[2].d, 2);
  return give_pose(vm, args, interpolate(a.T, b.T, args[2].d),
                   a.has_orientation || b.has_orientation);
}

template <int kAxis>
Signal coordinate(Vm&, Slot* args) {
  return give(args, posc(args[0]).T.translation()[kAxis]);
}
template <int kAngle>
Signal rpy_part(Vm&, Slot* args) {
  return give(args, rpy_from_R(posc(args[0]).T.linear())[kAngle]);
}
Signal place(Vm& vm, Slot* args) {
  const Vector3d p = posc(args[0]).T.translation();
  return give(args, new_reals(vm, {p.data(), 3}));
}

// ---- posJ
// ------------------------------------------------------------------------------------------------------

Signal posj_from(Vm& vm, Slot* args) {
  const auto values = reals_value(args[0]);
  if (values.empty() || values.size() > kMaxJoints) {
    return failure(vm, "R0613",
                   fmt::format("a posJ has 1 to {} values, not {}", kMaxJoints, values.size()), 0);
  }
  PosJ p;
  p.n = static_cast<std::uint8_t>(values.size());
  for (int i = 0; i < p.n; ++i) {
    if (!std::isfinite(values[i]))
      return not_finite(vm, fmt::format("value {} of the posJ", i + 1), values[i], 0);
    p.q[i] = values[i];
  }
  if (const Robot* robot = Host::of(vm).only_robot(); robot != nullptr && robot->n() == p.n) {
    p.kinds_known = true;
    for (int i = 0; i < p.n; ++i) p.turns[i] = robot->is_revolute(i);
  }
  return give(args, new_posj(vm, p));
}

Signal posj_element(Vm& vm, Slot* args) {
  const PosJ& p = posj(args[0]);
  const std::int64_t i = args[1].i;
  if (i < 0 || i >= p.n)
    return failure(vm, "R0606", fmt::format("index {} is outside 0 to {}", i, p.n - 1), 1);
  return give(args, p.q[i]);
}
enum class Stored : std::uint8_t { kNumber, kAngle, kLength };

// The joint values with one of them changed.
template <Stored kStored>
Signal posj_with(Vm& vm, Slot* args) {
  PosJ p = posj(args[0]);
  const std::int64_t i = args[1].i;
  if (i < 0 || i >= p.n)
    return failure(vm, "R0606", fmt::format("index {} is outside 0 to {}", i, p.n - 1), 1);
  if (!std::isfinite(args[2].d)) return not_finite(vm, "a joint value", args[2].d, 2);
  const auto joint = static_cast<std::size_t>(i);
  const bool turns = p.turns[joint];
  if (kStored != Stored::kNumber && p.kinds_known && turns != (kStored == Stored::kAngle)) {
    return failure(
        vm, "R0609",
        fmt::format("joint {} {}: its value is {}, not {}", i + 1, turns ? "turns" : "slides",
                    turns ? "an angle" : "a length", turns ? "a length" : "an angle"),
        2);
  }
  p.q[joint] = args[2].d;
  return give(args, new_posj(vm, p));
}

template <int kAxis>
Signal posc_with_place(Vm& vm, Slot* args) {
  if (!std::isfinite(args[1].d)) return not_finite(vm, "a coordinate", args[1].d, 1);
  PosC p = posc(args[0]);
  p.T.translation()[kAxis] = args[1].d;
  return give(args, new_posc(vm, p));
}

// Three angles turn one orientation: one alone does not say what becomes of the others.
void refuse_one_angle(CheckCall& call) {
  const std::string place = call.text_of(call.callee_span());
  const std::string pose = place.substr(0, place.rfind('.'));
  Diagnostic d = make_diagnostic("E0328", call.callee_span());
  d.why = "roll, pitch and yaw are read from the orientation, and belong together";
  d.fix = Fix{.text = fmt::format("write {}.R = rpy(roll, pitch, yaw).R", pose)};
  call.report(std::move(d));
}

Signal posj_values(Vm& vm, Slot* args) {
  const PosJ& p = posj(args[0]);
  return give(args, new_reals(vm, {p.q.data(), p.n}));
}
Signal posj_length(Vm&, Slot* args) {
  return give(args, static_cast<std::int64_t>(posj(args[0]).n));
}

template <class F>
Signal combine(Vm& vm, Slot* args, F f) {
  PosJ p = posj(args[0]);
  const PosJ& q = posj(args[1]);
  if (p.n != q.n) return size_failure(vm, "joint values", p.n, q.n);
  for (int i = 0; i < p.n; ++i) p.q[i] = f(p.q[i], q.q[i]);
  return give(args, new_posj(vm, p));
}
Signal posj_add(Vm& vm, Slot* args) {
  return combine(vm, args, [](double a, double b) { return a + b; });
}
Signal posj_subtract(Vm& vm, Slot* args) {
  return combine(vm, args, [](double a, double b) { return a - b; });
}
Signal posj_add_list(Vm& vm, Slot* args) {
  PosJ p = posj(args[0]);
  const auto d = reals_value(args[1]);
  if (p.n != d.size()) return size_failure(vm, "joint values", p.n, d.size());
  for (int i = 0; i < p.n; ++i) {
    p.q[i] += d[i];
    if (!std::isfinite(p.q[i]))
      return not_finite(vm, fmt::format("value {} of the posJ", i + 1), p.q[i], 1);
  }
  return give(args, new_posj(vm, p));
}
Signal scale(Vm& vm, Slot* args, const PosJ& by, double k) {
  PosJ p = by;
  if (!std::isfinite(k)) return not_finite(vm, "the factor", k, -1);
  for (int i = 0; i < p.n; ++i) p.q[i] *= k;
  return give(args, new_posj(vm, p));
}
Signal number_times_posj(Vm& vm, Slot* args) { return scale(vm, args, posj(args[1]), args[0].d); }
Signal posj_times_number(Vm& vm, Slot* args) { return scale(vm, args, posj(args[0]), args[1].d); }
Signal lerp_joints(Vm& vm, Slot* args) {
  const double s = args[2].d;
  if (!std::isfinite(s)) return not_finite(vm, "the fraction", s, 2);
  return combine(vm, args, [s](double a, double b) { return a + (b - a) * s; });
}

constexpr NativeFunction kPoseFunctions[] = {
    {"xyz", "(x: length = 0m, y: length = 0m, z: length = 0m) -> posC",
     "A place, without an orientation of its own.", "xyz(300mm, 120mm, 20mm)", xyz},
    {"rotX", "(a: angle) -> posC", "A turn about the x axis.", "rotX(180deg)", turn<rot_x>},
    {"rotY", "(a: angle) -> posC", "A turn about the y axis.", "rotY(90deg)", turn<rot_y>},
    {"rotZ", "(a: angle) -> posC", "A turn about the z axis.", "rotZ(45deg)", turn<rot_z>},
    {"rpy", "(roll: angle, pitch: angle, yaw: angle) -> posC",
     "Turns about the fixed x, then y, then z axis.", "rpy(180deg, 0deg, 90deg)", rpy},
    {"pose",
     "(x: length = 0m, y: length = 0m, z: length = 0m, roll: angle = 0rad, pitch: angle = 0rad, "
     "yaw: angle = 0rad) -> posC",
     "A place and an orientation.", "pose(x: 300mm, z: 100mm, roll: 180deg)", pose},
    {"quat", "(w: double, x: double, y: double, z: double) -> posC",
     "A turn by a quaternion; its length does not matter.", "quat(1.0, 0.0, 0.0, 0.0)", quaternion},
    {"axisAngle", "(axis: double[], a: angle) -> posC", "A turn about any axis.",
     "axisAngle([0.0, 0.0, 1.0], 90deg)", axis_angle},
    {"lookAt", "(from: length[], to: length[]) -> posC",
     "The frame at `from` whose z axis points to `to`.",
     "lookAt([0mm, 0mm, 500mm], [0mm, 100mm, 0mm])", look_at},
    {"inv", "(p: posC) -> posC", "The inverse: where the world is, seen from p.",
     "inv(rotZ(90deg))", inverse},
    {"operator*", "(a: posC, b: posC) -> posC", "b as seen from a.",
     "xyz(1m, 0m, 0m) * rotZ(90deg)", compose},
    {"above", "(p: posC, h: length) -> posC", "p moved up by h along the world's z axis.",
     "above(xyz(300mm, 0mm, 0mm), 60mm)", above},
    {"distance", "(a: posC, b: posC) -> length", "How far apart two places are.",
     "distance(xyz(0mm, 0mm, 0mm), xyz(3mm, 4mm, 0mm))", distance},
    {"angleBetween", "(a: posC, b: posC) -> angle",
     "The angle of the turn from one orientation to the other.",
     "angleBetween(rotX(10deg), rotX(30deg))", angle_of_turn},
    {"near", "(a: posC, b: posC, tol: length, tolAngle: angle?) -> bool",
     "Whether two places (and orientations, with tolAngle) agree.",
     "near(xyz(1mm, 0mm, 0mm), xyz(0mm, 0mm, 0mm), tol: 2mm)", near_places, nullptr, nullptr,
     nullptr, explain_near_places},
    {"near", "(a: posJ, b: posJ, tol: double) -> bool", "Whether all joint values agree.",
     "near(joints(), home(), tol: 0.2)", near_joints},
    {"lerp", "(a: posC, b: posC, s: double) -> posC",
     "The pose the fraction s of the way: straight line, even turn.",
     "lerp(xyz(0mm, 0mm, 0mm), xyz(10mm, 0mm, 0mm), 0.5)", lerp_places},
    {"posC.x", "(p: posC) -> length", "The place along x.", "xyz(1mm, 2mm, 3mm).x", coordinate<0>},
    {"posC.y", "(p: posC) -> length", "The place along y.", "xyz(1mm, 2mm, 3mm).y", coordinate<1>},
    {"posC.z", "(p: posC) -> length", "The place along z.", "xyz(1mm, 2mm, 3mm).z", coordinate<2>},
    {"posC.p", "(p: posC) -> length[]", "The place as three lengths.", "xyz(1mm, 2mm, 3mm).p",
     place},
    {"posC.roll", "(p: posC) -> angle", "The turn about the fixed x axis.", "rotX(10deg).roll",
     rpy_part<0>},
    {"posC.pitch", "(p: posC) -> angle", "The turn about the fixed y axis.", "rotY(10deg).pitch",
     rpy_part<1>},
    {"posC.yaw", "(p: posC) -> angle", "The turn about the fixed z axis.", "rotZ(10deg).yaw",
     rpy_part<2>},
    {"posJ", "(values: double[]) -> posJ",
     "Joint values from numbers: radians for turning joints, metres for sliding ones.",
     "posJ([0.0, 0.5, 0.1, 0.0])", posj_from, nullptr, nullptr, check_posj_list},
    {"posJ", "(values: number...) -> posJ", "Joint values with a unit each.",
     "posJ(10deg, 20deg, 30mm, 0deg)", posj_from, nullptr, nullptr, check_posj_values},
    {"posJ[]", "(p: posJ, i: int) -> double", "One joint value, SI.", "joints()[0]", posj_element},
    {"posJ[]=", "(p: posJ, i: int, value: double) -> posJ", "One joint value changed, SI.",
     "var q = joints(); q[0] = 0.5", posj_with<Stored::kNumber>},
    {"posJ[]=", "(p: posJ, i: int, value: angle) -> posJ", "The value of a turning joint changed.",
     "var q = joints(); q[0] = 30deg", posj_with<Stored::kAngle>},
    {"posJ[]=", "(p: posJ, i: int, value: length) -> posJ", "The value of a sliding joint changed.",
     "var q = joints(); q[2] = 30mm", posj_with<Stored::kLength>},
    {"posC.x=", "(p: posC, value: length) -> posC", "The place along x changed.",
     "var p = here(); p.x = 10mm", posc_with_place<0>},
    {"posC.y=", "(p: posC, value: length) -> posC", "The place along y changed.",
     "var p = here(); p.y = 10mm", posc_with_place<1>},
    {"posC.z=", "(p: posC, value: length) -> posC", "The place along z changed.",
     "var p = here(); p.z = 10mm", posc_with_place<2>},
    {"posC.roll=", "(p: posC, value: angle) -> posC",
     "Refused: one angle says nothing of the others; p.R stores all three.",
     "var p = here(); p.R = rpy(10deg, 0deg, 0deg).R", nullptr, nullptr, nullptr, refuse_one_angle},
    {"posC.pitch=", "(p: posC, value: angle) -> posC",
     "Refused: one angle says nothing of the others; p.R stores all three.",
     "var p = here(); p.R = rpy(10deg, 0deg, 0deg).R", nullptr, nullptr, nullptr, refuse_one_angle},
    {"posC.yaw=", "(p: posC, value: angle) -> posC",
     "Refused: one angle says nothing of the others; p.R stores all three.",
     "var p = here(); p.R = rpy(10deg, 0deg, 0deg).R", nullptr, nullptr, nullptr, refuse_one_angle},
    {"posJ.q", "(p: posJ) -> double[]", "All joint values, SI.", "joints().q", posj_values},
    {"posJ.length", "(p: posJ) -> int", "How many joint values there are.", "joints().length",
     posj_length},
    {"operator+", "(p: posJ, d: posJ) -> posJ", "Adds joint by joint.", "joints() + joints()",
     posj_add},
    {"operator-", "(p: posJ, q: posJ) -> posJ", "Subtracts joint by joint.", "joints() - home()",
     posj_subtract},
    {"operator+", "(p: posJ, d: double[]) -> posJ", "Adds SI numbers joint by joint.",
     "joints() + [0.1, 0.0, 0.0, 0.0]", posj_add_list},
    {"operator*", "(k: double, p: posJ) -> posJ", "Every joint value times a number.",
     "2.0 * joints()", number_times_posj},
    {"operator*", "(p: posJ, k: double) -> posJ", "Every joint value times a number.",
     "joints() * 2.0", posj_times_number},
    {"lerp", "(a: posJ, b: posJ, s: double) -> posJ", "The joint values the fraction s of the way.",
     "lerp(joints(), home(), 0.5)", lerp_joints},
};

}  // namespace

std::span<const NativeFunction> pose_functions() { return kPoseFunctions; }

}  // namespace armlet::bind
