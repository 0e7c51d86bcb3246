// Visual servoing with a camera on the arm (language reference, section 15).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "armlet/kinematics/forward.hpp"
#include "rules/rules_settings.hpp"
#include "values/setting_words.hpp"
#include "values/time_left.hpp"
#include "vision/servo_waiting.hpp"

namespace armlet::bind {
namespace {

// A gain in a program: a number, or a ServoGain.
AdaptiveGain gain_of(double gain) {
  if (!(gain > 0.0)) {
    throw ArgumentError(fmt::format("`gain` is {}; it must be greater than zero.",
                                    std::isnan(gain) ? "not a number" : fmt::format("{:g}", gain)));
  }
  return {gain, gain, 1.0};
}
AdaptiveGain gain_of(const RecordObj& gain) {
  const Slot* fields = gain.fields();
  return {fields[0].d, fields[1].d, fields[2].d};
}

// Depths of the points: none, one for all, or one for each.
Eigen::VectorXd depths_of(std::optional<double> depth) {
  return depth ? Eigen::VectorXd::Constant(1, *depth) : Eigen::VectorXd();
}
Eigen::VectorXd depths_of(std::span<const double> depths) {
  return Eigen::Map<const Eigen::VectorXd>(depths.data(), static_cast<Eigen::Index>(depths.size()));
}

Answer<ServoLaw> law_of(Vm& vm, std::string_view word) {
  const auto* found = std::ranges::find(kServoLaws, word);
  if (found == kServoLaws.end()) {
    return fail_servo(
        vm, fmt::format("there is no law \"{}\"; expected {}", word, choice_of(kServoLaws)),
        at("law"));
  }
  return static_cast<ServoLaw>(found - kServoLaws.begin());
}

// What a camera stands on: "is on `right`", "stands in the world".
std::string mount_text(const Cell& cell, const Mount& on, int carrier) {
  const std::string robot = carrier >= 0 ? cell.robot(carrier).name : std::string();
  if (on.base == FrameBase::kWorld) return "stands in the world, on no robot";
  if (on.base == FrameBase::kCarrier) return fmt::format("is on `{}`", robot);
  const char* const kind = on.base == FrameBase::kObject ? "object" : "frame";
  return fmt::format("is on the {} `{}`, which {}", kind, on.on,
                     carrier >= 0 ? fmt::format("is on `{}`", robot) : "no robot carries");
}

// The arm whose flange carries the camera; fails if it may not be moved now.
Answer<void> check_carrier(Vm& vm, const RobotRef& r, const CameraRef& camera) {
  if (!check_arm(vm, r.id)) return Failed{};
  Cell& cell = Host::of(vm).cell();
  const Mount& on = cell.cameras().at(camera.id).on;
  const int carrier =
      on.base == FrameBase::kFrame ? cell.world().mount_of_frame(on.on).carrier : on.carrier;
  if (carrier < 0 || (carrier != r.id && cell.robot(carrier).on != r.id)) {
    const std::string& arm = cell.robot(r.id).name;
    const std::string& eye = cell.cameras().at(camera.id).name;
    const std::string mount = fmt::format("mount it there: camera {} {{ on: {} }}", eye, arm);
    return fail_servo(vm,
                      fmt::format("`{}` does not carry the camera `{}`, which {}", arm, eye,
                                  mount_text(cell, on, carrier)),
                      at("c"),
                      carrier < 0 ? mount
                                  : fmt::format("move the robot that carries it, `{}`, or {}",
                                                cell.robot(carrier).name, mount));
  }
  try {
    (void)cell.cameras().T_world_camera_for(cell, camera.id, cell.T_world_tool(r.id));
  } catch (const ArgumentError& error) {
    return fail_servo(vm, clause_of(error), at("c"));
  }
  if (cell.can_drive(r.id)) return {};
  return check_idle(vm, r.id);
}

// The period in whole nanoseconds; above 0 and at most an hour. Of a camera with a rate it is the
// next whole number of its pictures.
Answer<std::int64_t> period_of(Vm& vm, double seconds, double rate) {
  constexpr double kLongest = 3600.0, kRounding = 1e-6;
  if (!std::isfinite(seconds)) return not_finite(vm, "`period`", seconds, at("period"));
  const std::int64_t ns = seconds > 0.0 && seconds <= kLongest ? to_ns(seconds) : 0;
  if (ns == 0) {
    return fail_servo(
        vm, fmt::format("`period` is {:g} s; expected a time above 0 and up to an hour", seconds),
        at("period"));
  }
  if (rate == 0.0) return ns;
  const double pictures = std::max(1.0, std::ceil(seconds * rate - kRounding));
  if (pictures <= kLongest * rate) return to_ns(pictures / rate);
  return fail_servo(vm,
                    fmt::format("the camera takes a picture every {:g} s; the loop needs one in an "
                                "hour at least",
                                1.0 / rate),
                    at("c"));
}

Answer<void> check_numbers(Vm& vm, double within, double timeout, double smooth) {
  if (!std::isfinite(within)) return not_finite(vm, "`within`", within, at("within"));
  if (!std::isfinite(timeout)) return not_finite(vm, "`timeout`", timeout, at("timeout"));
  if (!std::isfinite(smooth)) return not_finite(vm, "`smooth`", smooth, at("smooth"));
  return {};
}

// The goal of a call, with its sizes checked.
Answer<ServoGoal> goal_of(Vm& vm, const MatrixObj& wanted, Eigen::VectorXd depths,
                          std::optional<std::span<const Slot>> rows) {
  const auto pixels = pixels_of(vm, wanted, at("wanted"), " of `wanted`");
  if (!pixels) return Failed{};
  if (!depths.allFinite()) return not_finite(vm, "a depth", depths.sum(), at("depth"));
  ServoGoal goal{.wanted = *pixels, .depths = std::move(depths)};
  if (rows) {
    const auto points = points_of(vm, *rows, at("points"));
    if (!points) return Failed{};
    goal.points = *points;
  }
  return goal;
}

// The expected points in the first picture.
Answer<PlanePoints> start_of(Vm& vm, std::optional<Slot> start, const PlanePoints& wanted) {
  if (!start) return wanted;
  auto points = pixels_of(vm, matrix_value(*start), at("start"), " of `start`");
  if (points && points->rows() != wanted.rows()) {
    return fail_servo(
        vm, fmt::format("`start` has {} points and {} are wanted", points->rows(), wanted.rows()),
        at("start"));
  }
  return points;
}

template <bool kExpected, class Gain, class Depth>
Started visual_servo(Vm& vm, const RobotRef& r, const CameraRef& camera, FunctionValue features,
                     const MatrixObj& wanted, std::string_view law, Gain gain, Depth depth,
                     std::optional<std::span<const Slot>> points, std::optional<Slot> start,
                     double within, double timeout, double period, std::int64_t patience,
                     double smooth) try {
  const auto known_law = law_of(vm, law);
  if (!known_law || !check_carrier(vm, r, camera)) return Failed{};
  const double rate = Host::of(vm).cell().cameras().at(camera.id).rate;
  const auto period_ns = period_of(vm, period, rate);
  if (!period_ns || !check_numbers(vm, within, timeout, smooth)) return Failed{};
  if (!check_time_left(vm, "a motion", timeout, at("timeout"))) return Failed{};
  auto goal = goal_of(vm, wanted, depths_of(depth), points);
  if (!goal) return Failed{};
  auto first = start_of(vm, start, goal->wanted);
  if (!first) return Failed{};
  Cell& cell = Host::of(vm).cell();
  const Eigen::Isometry3d T_tool_camera = cell.T_world_tool(r.id).inverse(Eigen::Isometry) *
                                          cell.cameras().T_world_camera(cell, camera.id);
  const ServoOptions options{
      .law = *known_law,
      .gain = gain_of(gain),
      .period = to_seconds(*period_ns),
      .within = within,
      .timeout = timeout,
      .patience = static_cast<int>(std::clamp<std::int64_t>(patience, -1, 1'000'000)),
      .smooth = smooth};
  VisualServo servo(cell.cameras().at(camera.id).lens, *std::move(goal),
                    servo_arm(model_of(vm, r), T_tool_camera), options);
  return start_servo(vm,
                     {.robot = r.id,
                      .camera = camera,
                      .features = features.object,
                      .expected = kExpected,
                      .start = *std::move(first),
                      .period_ns = *period_ns},
                     std::move(servo));
} catch (const ArgumentError& error) {
  return fail_servo(vm, clause_of(error));
}

Answer<RecordObj*> adaptive(Vm& vm, double at_zero, double at_infinity, double slope) try {
  const double numbers[] = {at_zero, at_infinity, slope};
  const CallPart parts[] = {at("atZero"), at("atInfinity"), at("slope")};
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(numbers[i]))
      return not_finite(vm, fmt::format("`{}`", parts[i].parameter()), numbers[i], parts[i]);
    if (numbers[i] > 0.0) continue;
    return fail_servo(
        vm,
        fmt::format("`{}` is {:g}; it must be greater than zero", parts[i].parameter(), numbers[i]),
        parts[i]);
  }
  (void)AdaptiveGain{at_zero, at_infinity, slope}.at(0.0);
  RecordObj* record = new_record(vm, vm.program().library_record("ServoGain"));
  if (record == nullptr) return Failed{};
  record->fields()[0] = slot_of(at_zero);
  record->fields()[1] = slot_of(at_infinity);
  record->fields()[2] = slot_of(slope);
  return record;
} catch (const ArgumentError& error) {
  return fail_servo(vm, clause_of(error));
}

std::string explain_run(const RecordObj& run) {
  constexpr std::size_t kExplanation = 10;  // index of a field of ServoRun
  return std::string(text_value(run.fields()[kExplanation]));
}

constexpr std::string_view kServoHelp =
    "Moves the arm until the camera that it carries sees points where they are wanted, and gives "
    "what happened. features finds the points in a picture, in the order of wanted, N x 2 pixels "
    "each; with a second parameter it gets where they are expected, at first start or else wanted. "
    "law: \"current\", \"desired\" and \"mean\" take the interaction matrix of now, of the goal or "
    "the mean of both; \"position\" moves straight by the pose of the points; \"hybrid\" moves one "
    "point straight through the picture. gain: a number in 1/s or adaptive(...). depth: of the "
    "points along the axis of the camera; without it, and for the last two laws, points: of a flat "
    "object, in a frame in which they rest. It ends when the norm of all differences is at most "
    "within px. A picture is taken every period; by a camera with a rate, each time after as many "
    "of its pictures as fill a period. Where features fails with FeatureLost or "
    "NoFeatures, points are predicted for at most patience pictures; those that corners or update "
    "found in it still count. smooth: 1/s, the speeds begin at 0 like 1 - "
    "exp(-smooth t). The reason of the result is Converged, Timeout, FeatureLost, LocalMinimum, "
    "Singular, JointLimit, OutOfImage or Stopped, and why says it with numbers; t, error, twist, "
    "features, smallest and condition (singular values of L, at the predicted points where they "
    "are lost) and qd have a row for each picture.";

#define ARMLET_SERVO_HEAD "visualServo(r: robot, c: camera, features: "
#define ARMLET_SERVO_PLAIN "fn(image) -> matrix"
#define ARMLET_SERVO_EXPECTED "fn(image, matrix) -> matrix"
#define ARMLET_SERVO_LAW ", wanted: matrix, law: string = \"mean\", gain: "
#define ARMLET_SERVO_NUMBER "double = 0.5"
#define ARMLET_SERVO_ADAPTIVE "ServoGain"
#define ARMLET_SERVO_REST                                                                      \
  ", points: length[][]?, start: matrix?, within: double = 0.5, timeout: time = 20s, period: " \
  "time = 40ms, patience: int = 5, smooth: double = 0.0) -> ServoRun"
#define ARMLET_SHOWN_SERVO_SETUP                                                              \
  "robot one = robots.ur5(); one.setJoints(posJ(10deg, -70deg, 100deg, -120deg, -90deg, "     \
  "20deg)); camera eye { on: one; size: [160, 120] } let s = [60, 40; 100, 40; 100, 80; 60, " \
  "80]; "
#define ARMLET_SHOWN_SERVO(features, rest)                                                       \
  ARMLET_SHOWN_SERVO_SETUP "print(one.visualServo(eye, features: " features ", wanted: s, " rest \
                           ").reason)"

#define ARMLET_SERVO_ROW(kExpected, Gain, Depth, fn, gain, depth, shown)                          \
  def<visual_servo<kExpected, Gain, Depth>>(                                                      \
      ARMLET_SERVO_HEAD fn ARMLET_SERVO_LAW gain ", depth: " depth ARMLET_SERVO_REST, kServoHelp, \
      shown, {.check = check_word<"law", kServoLaws>, .pauses = true})

using OneDepth = std::optional<double>;
using Depths = std::span<const double>;
using Adaptive = const RecordObj&;

constexpr NativeFunction kServoFunctions[] = {
    ARMLET_SERVO_ROW(false, double, OneDepth, ARMLET_SERVO_PLAIN, ARMLET_SERVO_NUMBER, "length?",
                     ARMLET_SHOWN_SERVO("fn(img) => s", "depth: 400mm")),
    ARMLET_SERVO_ROW(false, double, Depths, ARMLET_SERVO_PLAIN, ARMLET_SERVO_NUMBER, "length[]",
                     ARMLET_SHOWN_SERVO("fn(img) => s", "depth: [400mm, 400mm, 420mm, 420mm]")),
    ARMLET_SERVO_ROW(
        false, Adaptive, OneDepth, ARMLET_SERVO_PLAIN, ARMLET_SERVO_ADAPTIVE, "length?",
        ARMLET_SHOWN_SERVO("fn(img) => s", "gain: adaptive(4.0, 0.4, 30.0), depth: 400mm")),
    ARMLET_SERVO_ROW(false, Adaptive, Depths, ARMLET_SERVO_PLAIN, ARMLET_SERVO_ADAPTIVE, "length[]",
                     ARMLET_SHOWN_SERVO("fn(img) => s",
                                        "gain: adaptive(4.0, 0.4, 30.0), depth: [400mm, 400mm, "
                                        "420mm, 420mm]")),
    ARMLET_SERVO_ROW(true, double, OneDepth, ARMLET_SERVO_EXPECTED, ARMLET_SERVO_NUMBER, "length?",
                     ARMLET_SHOWN_SERVO("fn(img, near) => near", "depth: 400mm")),
    ARMLET_SERVO_ROW(
        true, double, Depths, ARMLET_SERVO_EXPECTED, ARMLET_SERVO_NUMBER, "length[]",
        ARMLET_SHOWN_SERVO("fn(img, near) => near", "depth: [400mm, 400mm, 420mm, 420mm]")),
    ARMLET_SERVO_ROW(true, Adaptive, OneDepth, ARMLET_SERVO_EXPECTED, ARMLET_SERVO_ADAPTIVE,
                     "length?",
                     ARMLET_SHOWN_SERVO("fn(img, near) => near",
                                        "gain: adaptive(4.0, 0.4, 30.0), depth: 400mm")),
    ARMLET_SERVO_ROW(true, Adaptive, Depths, ARMLET_SERVO_EXPECTED, ARMLET_SERVO_ADAPTIVE,
                     "length[]",
                     ARMLET_SHOWN_SERVO("fn(img, near) => near",
                                        "gain: adaptive(4.0, 0.4, 30.0), depth: [400mm, 400mm, "
                                        "420mm, 420mm]")),
    def<adaptive>(
        "adaptive(atZero: double, atInfinity: double, slope: double) -> ServoGain",
        "A gain of visualServo that is atZero at the goal and atInfinity far from it, in 1/s: "
        "(atZero - atInfinity) exp(-slope x / (atZero - atInfinity)) + atInfinity, where x is the "
        "largest element of the error of the law, in normalised coordinates or in m and rad.",
        "print(adaptive(4.0, 0.4, 30.0).slope)"),
    def<explain_run>(
        "explain(run: ServoRun) -> string",
        "Why visual servoing ended, the rank of L J, and the directions in which the picture could "
        "be controlled by a camera that moves freely but not by this arm, point by point.",
        ARMLET_SHOWN_SERVO_SETUP
        "let run = one.visualServo(eye, features: fn(img) => s, wanted: s, depth: 400mm); "
        "explain(run)"),
};

}  // namespace

std::span<const NativeFunction> servo_functions() { return kServoFunctions; }

}  // namespace armlet::bind
