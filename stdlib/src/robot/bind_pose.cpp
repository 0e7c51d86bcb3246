// Poses and frames (language reference, sections 8 and 19).

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/host.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/formats.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// Refuses infinite and undefined numbers in a pose.
Answer<void> require_finite(Vm& vm, std::string_view what,
                            std::initializer_list<std::pair<double, CallPart>> values) {
  for (const auto& [value, part] : values)
    if (!std::isfinite(value)) return not_finite(vm, what, value, part);
  return {};
}

// For formatted texts: f"{p:.1f mm}".
std::string format_posc_value(Vm&, const PosC& p, std::string_view style, std::string_view unit) {
  return format_posc(p, style, unit);
}
std::string format_posj_value(Vm&, const PosJ& q, std::string_view style, std::string_view unit) {
  return format_posj(q, style, unit);
}

PosC placed(const Isometry3d& T) { return {T, false}; }
PosC turned(const Eigen::Matrix3d& R) { return {make_pose(R, Vector3d::Zero()), true}; }

Answer<PosC> xyz(Vm& vm, double x, double y, double z) {
  if (!require_finite(vm, "a coordinate", {{x, at("x")}, {y, at("y")}, {z, at("z")}}))
    return Failed{};
  return placed(make_translation({x, y, z}));
}
template <Eigen::Matrix3d (*kRotate)(double)>
Answer<PosC> turn(Vm& vm, double angle) {
  if (!require_finite(vm, "the angle", {{angle, at("a")}})) return Failed{};
  return turned(kRotate(angle));
}
Answer<PosC> rpy(Vm& vm, double roll, double pitch, double yaw) {
  if (!require_finite(vm, "an angle", {{roll, at("roll")}, {pitch, at("pitch")}, {yaw, at("yaw")}}))
    return Failed{};
  return PosC{pose_from_rpy(Vector3d::Zero(), {roll, pitch, yaw}), true};
}
Answer<PosC> pose(Vm& vm, double x, double y, double z, double roll, double pitch, double yaw) {
  if (!require_finite(vm, "a coordinate or angle",
                      {{x, at("x")},
                       {y, at("y")},
                       {z, at("z")},
                       {roll, at("roll")},
                       {pitch, at("pitch")},
                       {yaw, at("yaw")}}))
    return Failed{};
  return PosC{pose_from_rpy({x, y, z}, {roll, pitch, yaw}), true};
}
Answer<PosC> quaternion(Vm& vm, double w, double x, double y, double z) {
  if (!require_finite(vm, "a value of the quaternion",
                      {{w, at("w")}, {x, at("x")}, {y, at("y")}, {z, at("z")}}))
    return Failed{};
  Eigen::Vector4d q(w, x, y, z);
  if (!std::isfinite(q.norm())) q /= q.cwiseAbs().maxCoeff();  // its length does not matter
  if (q.norm() < 1e-9) return failure(vm, "R0609", "a quaternion of zeros has no direction");
  return turned(R_from_quaternion(q));
}
Answer<PosC> axis_angle(Vm& vm, std::span<const double> axis, double angle) {
  if (axis.size() != 3)
    return failure(vm, "R0613", fmt::format("an axis has 3 values, not {}", axis.size()),
                   at("axis"));
  Vector3d v(axis[0], axis[1], axis[2]);
  if (!v.allFinite()) return not_finite(vm, "a value of the axis", v.sum(), at("axis"));
  if (!std::isfinite(v.norm())) v /= v.cwiseAbs().maxCoeff();
  if (!std::isfinite(angle)) return not_finite(vm, "the angle", angle, at("a"));
  if (v.norm() < 1e-12)
    return failure(vm, "R0609", "an axis of zeros has no direction", at("axis"));
  return turned(R_from_axis_angle(v, angle));
}

PosC inverse(const PosC& p) { return {p.T.inverse(), p.has_orientation}; }
PosC compose(const PosC& a, const PosC& b) {
  return {renormalised(a.T * b.T), a.has_orientation || b.has_orientation};
}
Answer<PosC> above(Vm& vm, const PosC& p, double height) {
  if (!std::isfinite(height)) return not_finite(vm, "the height", height, at("h"));
  PosC raised = p;
  raised.T.translation().z() += height;
  return raised;
}
double distance(const PosC& a, const PosC& b) {
  return (a.T.translation() - b.T.translation()).norm();
}
double angle_of_rotation(const PosC& a, const PosC& b) { return angle_between(a.T, b.T); }

// The frame at `from` whose z axis points to `to` and whose x axis is level (axes of a camera).
Answer<PosC> look_at(Vm& vm, std::span<const double> a, std::span<const double> b) {
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
  return PosC{make_pose(R, from), true};
}

bool near_positions(const PosC& a, const PosC& b, double tol, std::optional<double> tol_angle) {
  return distance(a, b) <= tol && (!tol_angle || angle_of_rotation(a, b) <= *tol_angle);
}
// Positions that are compared are printed with the same digits.
std::string position_text(const PosC& p, int digits) {
  const Eigen::Vector3d mm = p.T.translation() * 1000.0;
  return fmt::format("({:.{}f}, {:.{}f}, {:.{}f}) mm", mm.x(), digits, mm.y(), digits, mm.z(),
                     digits);
}
std::string explain_near_positions(const PosC& a, const PosC& b, double tol,
                                   std::optional<double> tol_angle) {
  const double gap = distance(a, b);
  if (tol_angle && gap <= tol)
    return fmt::format("the orientations differ by {}", format_deg(angle_of_rotation(a, b)));
  const int digits = gap < 0.0001 ? 4 : 1;
  return fmt::format("the positions differ by {} mm\n{}\n{}", format_number(gap * 1000.0, digits),
                     position_text(a, digits), position_text(b, digits));
}
bool near_joints(const PosJ& a, const PosJ& b, double tol) {
  if (a.n != b.n) return false;
  for (int i = 0; i < a.n; ++i) {
    if (!(std::abs(a.q[i] - b.q[i]) <= tol)) return false;
  }
  return true;
}

Answer<PosC> lerp_positions(Vm& vm, const PosC& a, const PosC& b, double s) {
  if (!std::isfinite(s)) return not_finite(vm, "the fraction", s, at("s"));
  return PosC{interpolate(a.T, b.T, s), a.has_orientation || b.has_orientation};
}

template <int kAxis>
double coordinate(const PosC& p) {
  return p.T.translation()[kAxis];
}
template <int kAngle>
double rpy_part(const PosC& p) {
  return rpy_from_R(p.T.linear())[kAngle];
}
std::vector<double> place(const PosC& p) {
  const Vector3d at = p.T.translation();
  return {at.x(), at.y(), at.z()};
}

// ---- posJ ---------------------------------------------------------------------------------------

Answer<PosJ> posj_from(Vm& vm, std::span<const double> values) {
  if (values.empty() || values.size() > kMaxJoints) {
    return failure(vm, "R0613",
                   fmt::format("a posJ has 1 to {} values, not {}", kMaxJoints, values.size()),
                   at("values"));
  }
  PosJ p;
  p.n = static_cast<std::uint8_t>(values.size());
  for (int i = 0; i < p.n; ++i) {
    if (!std::isfinite(values[i]))
      return not_finite(vm, fmt::format("value {} of the posJ", i + 1), values[i], at("values"));
    p.q[i] = values[i];
  }
  if (const Robot* robot = Host::of(vm).only_robot(); robot != nullptr && robot->n() == p.n) {
    p.kinds_known = true;
    for (int i = 0; i < p.n; ++i) p.turns[i] = robot->is_revolute(i);
  }
  return p;
}

// Checks index i: fails unless there is such a joint.
Answer<int> joint_of(Vm& vm, const PosJ& p, std::int64_t i) {
  if (i < 0 || i >= p.n)
    return failure(vm, "R0606", fmt::format("index {} is outside 0 to {}", i, p.n - 1), at("i"));
  return static_cast<int>(i);
}
Answer<double> posj_element(Vm& vm, const PosJ& p, std::int64_t i) {
  const auto joint = joint_of(vm, p, i);
  if (!joint) return Failed{};
  return p.q[*joint];
}
enum class Stored : std::uint8_t { kNumber, kAngle, kLength };

// The joint values with one of them changed.
template <Stored kStored>
Answer<PosJ> posj_with(Vm& vm, const PosJ& before, std::int64_t i, double value) {
  const auto joint = joint_of(vm, before, i);
  if (!joint) return Failed{};
  if (!std::isfinite(value)) return not_finite(vm, "a joint value", value, at("value"));
  const bool turns = before.turns[*joint];
  if (kStored != Stored::kNumber && before.kinds_known && turns != (kStored == Stored::kAngle)) {
    return failure(
        vm, "R0609",
        fmt::format("joint {} {}: its value is {}, not {}", i + 1, turns ? "turns" : "slides",
                    turns ? "an angle" : "a length", turns ? "a length" : "an angle"),
        at("value"));
  }
  PosJ p = before;
  p.q[*joint] = value;
  return p;
}

template <int kAxis>
Answer<PosC> posc_with_position(Vm& vm, const PosC& before, double value) {
  if (!std::isfinite(value)) return not_finite(vm, "a coordinate", value, at("value"));
  PosC p = before;
  p.T.translation()[kAxis] = value;
  return p;
}
// An orientation has three angles; one alone would leave the others undefined.
void refuse_one_angle(CheckCall& call) {
  const std::string place = call.text_of(call.callee_span());
  const std::string pose = place.substr(0, place.rfind('.'));
  Diagnostic d = make_diagnostic("E0328", call.callee_span());
  d.why = "roll, pitch and yaw are read from the orientation, and belong together";
  d.fix = Fix{.text = fmt::format("write {}.R = rpy(roll, pitch, yaw).R", pose)};
  call.report(std::move(d));
}

std::vector<double> posj_values(const PosJ& p) { return {p.q.data(), p.q.data() + p.n}; }
std::int64_t posj_length(const PosJ& p) { return p.n; }

template <class F>
Answer<PosJ> combine(Vm& vm, const PosJ& a, const PosJ& b, F f) {
  if (a.n != b.n) return size_failure(vm, "joint values", a.n, b.n);
  PosJ p = a;
  for (int i = 0; i < p.n; ++i) p.q[i] = f(a.q[i], b.q[i]);
  return p;
}
Answer<PosJ> posj_add(Vm& vm, const PosJ& p, const PosJ& d) {
  return combine(vm, p, d, [](double a, double b) { return a + b; });
}
Answer<PosJ> posj_subtract(Vm& vm, const PosJ& p, const PosJ& q) {
  return combine(vm, p, q, [](double a, double b) { return a - b; });
}
Answer<PosJ> posj_add_list(Vm& vm, const PosJ& before, std::span<const double> d) {
  PosJ p = before;
  if (p.n != d.size()) return size_failure(vm, "joint values", p.n, d.size());
  for (int i = 0; i < p.n; ++i) {
    p.q[i] += d[i];
    if (!std::isfinite(p.q[i]))
      return not_finite(vm, fmt::format("value {} of the posJ", i + 1), p.q[i], at("d"));
  }
  return p;
}
Answer<PosJ> posj_times_number(Vm& vm, const PosJ& before, double k) {
  if (!std::isfinite(k)) return not_finite(vm, "the factor", k, {});
  PosJ p = before;
  for (int i = 0; i < p.n; ++i) p.q[i] *= k;
  return p;
}
Answer<PosJ> number_times_posj(Vm& vm, double k, const PosJ& p) {
  return posj_times_number(vm, p, k);
}
Answer<PosJ> lerp_joints(Vm& vm, const PosJ& p, const PosJ& q, double s) {
  if (!std::isfinite(s)) return not_finite(vm, "the fraction", s, at("s"));
  return combine(vm, p, q, [s](double a, double b) { return a + (b - a) * s; });
}

constexpr std::string_view kOneAngle =
    "Refused: one angle says nothing of the others; p.R stores all three.";
constexpr std::string_view kAllAngles = "var p = here(); p.R = rpy(10deg, 0deg, 0deg).R";

constexpr NativeFunction kPoseFunctions[] = {
    def<xyz>("xyz(x: length = 0m, y: length = 0m, z: length = 0m) -> posC",
             "A place, without an orientation of its own.", "xyz(300mm, 120mm, 20mm)",
             {.check = note_upright}),
    def<turn<rot_x>>("rotX(a: angle) -> posC", "A turn about the x axis.", "rotX(180deg)"),
    def<turn<rot_y>>("rotY(a: angle) -> posC", "A turn about the y axis.", "rotY(90deg)"),
    def<turn<rot_z>>("rotZ(a: angle) -> posC", "A turn about the z axis.", "rotZ(45deg)",
                     {.check = note_upright}),
    def<rpy>("rpy(roll: angle, pitch: angle, yaw: angle) -> posC",
             "Turns about the fixed x, then y, then z axis.", "rpy(180deg, 0deg, 90deg)"),
    def<pose>("pose(x: length = 0m, y: length = 0m, z: length = 0m, roll: angle = 0rad, pitch: "
              "angle = 0rad, "
              "yaw: angle = 0rad) -> posC",
              "A place and an orientation.", "pose(x: 300mm, z: 100mm, roll: 180deg)"),
    def<quaternion>("quat(w: double, x: double, y: double, z: double) -> posC",
                    "A turn by a quaternion; its length does not matter.",
                    "quat(1.0, 0.0, 0.0, 0.0)"),
    def<axis_angle>("axisAngle(axis: double[], a: angle) -> posC", "A turn about any axis.",
                    "axisAngle([0.0, 0.0, 1.0], 90deg)"),
    def<look_at>("lookAt(from: length[], to: length[]) -> posC",
                 "The frame at `from` whose z axis points to `to`.",
                 "lookAt([0mm, 0mm, 500mm], [0mm, 100mm, 0mm])"),
    def<inverse>("inv(p: posC) -> posC", "The inverse: where the world is, seen from p.",
                 "inv(rotZ(90deg))"),
    def<compose>("operator*(a: posC, b: posC) -> posC", "b as seen from a.",
                 "xyz(1m, 0m, 0m) * rotZ(90deg)"),
    def<above>("above(p: posC, h: length) -> posC", "p moved up by h along the world's z axis.",
               "above(xyz(300mm, 0mm, 0mm), 60mm)"),
    def<distance>("distance(a: posC, b: posC) -> length", "How far apart two places are.",
                  "distance(xyz(0mm, 0mm, 0mm), xyz(3mm, 4mm, 0mm))"),
    def<angle_of_rotation>("angleBetween(a: posC, b: posC) -> angle",
                           "The angle of the turn from one orientation to the other.",
                           "angleBetween(rotX(10deg), rotX(30deg))"),
    def<near_positions>("near(a: posC, b: posC, tol: length, tolAngle: angle?) -> bool",
                        "Whether two places (and orientations, with tolAngle) agree.",
                        "near(xyz(1mm, 0mm, 0mm), xyz(0mm, 0mm, 0mm), tol: 2mm)",
                        {.explain = explained_by<explain_near_positions>}),
    def<near_joints>("near(a: posJ, b: posJ, tol: double) -> bool",
                     "Whether all joint values agree.", "near(joints(), home(), tol: 0.2)"),
    def<lerp_positions>("lerp(a: posC, b: posC, s: double) -> posC",
                        "The pose the fraction s of the way: straight line, even turn.",
                        "lerp(xyz(0mm, 0mm, 0mm), xyz(10mm, 0mm, 0mm), 0.5)"),
    def<format_posc_value>("posC{:}(p: posC, style: string, unit: string) -> string", "", ""),
    def<format_posj_value>("posJ{:}(q: posJ, style: string, unit: string) -> string", "", ""),
    def<coordinate<0>>("posC.x(p: posC) -> length", "The place along x.", "xyz(1mm, 2mm, 3mm).x"),
    def<coordinate<1>>("posC.y(p: posC) -> length", "The place along y.", "xyz(1mm, 2mm, 3mm).y"),
    def<coordinate<2>>("posC.z(p: posC) -> length", "The place along z.", "xyz(1mm, 2mm, 3mm).z"),
    def<place>("posC.p(p: posC) -> length[]", "The place as three lengths.",
               "xyz(1mm, 2mm, 3mm).p"),
    def<rpy_part<0>>("posC.roll(p: posC) -> angle", "The turn about the fixed x axis.",
                     "rotX(10deg).roll"),
    def<rpy_part<1>>("posC.pitch(p: posC) -> angle", "The turn about the fixed y axis.",
                     "rotY(10deg).pitch"),
    def<rpy_part<2>>("posC.yaw(p: posC) -> angle", "The turn about the fixed z axis.",
                     "rotZ(10deg).yaw"),
    def<posj_from>(
        "posJ(values: double[]) -> posJ",
        "Joint values from numbers: radians for turning joints, metres for sliding ones.",
        "posJ([0.0, 0.5, 0.1, 0.0])", {.check = check_posj_list}),
    def<posj_from>("posJ(values: number...) -> posJ", "Joint values with a unit each.",
                   "posJ(10deg, 20deg, 30mm, 0deg)", {.check = check_posj_values}),
    def<posj_element>("posJ[](p: posJ, i: int) -> double", "One joint value, SI.", "joints()[0]"),
    def<posj_with<Stored::kNumber>, posj_with<Stored::kAngle>, posj_with<Stored::kLength>>(
        "posJ[]=(p: posJ, i: int, value: double | angle | length) -> posJ",
        "One joint value changed: a number in SI, the angle of a turning joint, or the length of a "
        "sliding one.",
        "var q = joints(); q[0] = 0.5; q[0] = 30deg; q[2] = 30mm"),
    def<posc_with_position<0>>("posC.x=(p: posC, value: length) -> posC",
                               "The place along x changed.", "var p = here(); p.x = 10mm"),
    def<posc_with_position<1>>("posC.y=(p: posC, value: length) -> posC",
                               "The place along y changed.", "var p = here(); p.y = 10mm"),
    def<posc_with_position<2>>("posC.z=(p: posC, value: length) -> posC",
                               "The place along z changed.", "var p = here(); p.z = 10mm"),
    declare("posC.roll=(p: posC, value: angle) -> posC", kOneAngle, kAllAngles, refuse_one_angle),
    declare("posC.pitch=(p: posC, value: angle) -> posC", kOneAngle, kAllAngles, refuse_one_angle),
    declare("posC.yaw=(p: posC, value: angle) -> posC", kOneAngle, kAllAngles, refuse_one_angle),
    def<posj_values>("posJ.q(p: posJ) -> double[]", "All joint values, SI.", "joints().q",
                     {.check = note_same_numbers}),
    def<posj_length>("posJ.length(p: posJ) -> int", "How many joint values there are.",
                     "joints().length"),
    def<posj_add>("operator+(p: posJ, d: posJ) -> posJ", "Adds joint by joint.",
                  "joints() + joints()"),
    def<posj_subtract>("operator-(p: posJ, q: posJ) -> posJ", "Subtracts joint by joint.",
                       "joints() - home()"),
    def<posj_add_list>("operator+(p: posJ, d: double[]) -> posJ", "Adds SI numbers joint by joint.",
                       "joints() + [0.1, 0.0, 0.0, 0.0]"),
    def<number_times_posj>("operator*(k: double, p: posJ) -> posJ",
                           "Every joint value times a number.", "2.0 * joints()"),
    def<posj_times_number>("operator*(p: posJ, k: double) -> posJ",
                           "Every joint value times a number.", "joints() * 2.0"),
    def<lerp_joints>("lerp(a: posJ, b: posJ, s: double) -> posJ",
                     "The joint values the fraction s of the way.", "lerp(joints(), home(), 0.5)"),
};

}  // namespace

std::span<const NativeFunction> pose_functions() { return kPoseFunctions; }

}  // namespace armlet::bind
