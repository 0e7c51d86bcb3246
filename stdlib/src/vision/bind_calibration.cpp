// Calibration of cameras, and pictures without distortion, by OpenCV (language reference, section
// 15).

#include <fmt/format.h>

#include <algorithm>

#include "armlet/stdlib/host.hpp"
#include "armlet/vision/calibration.hpp"
#include "rules/rules_settings.hpp"
#include "values/eigen_results.hpp"
#include "values/matrices.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "vision/features.hpp"
#include "vision/opencv_needed.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {
namespace {

RecordObj* new_calibration(Vm& vm, const CameraCalibration& found) {
  RecordObj* record = new_record(vm, vm.program().library_record("Calibration"));
  if (record == nullptr) return nullptr;
  Slot* fields = record->fields();
  const LensNumbers& lens = found.lens;
  MatrixObj* K = new_matrix_unset(vm, 3, 3);
  fields[0].o = K;
  if (K != nullptr) {
    const double values[] = {lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1};
    std::copy(std::begin(values), std::end(values), K->data());
    fields[1].o = new_reals(vm, lens.distortion);
  }
  fields[2].d = found.error;
  if (fields[1].o != nullptr) fields[3].o = new_reals(vm, found.deviation);
  if (fields[3].o != nullptr) {
    ListMaker poses(vm);
    bool complete = true;
    for (const Eigen::Isometry3d& T : found.T_camera_target)
      complete = complete && poses.push(new_posc(vm, {T, true}));
    fields[4].o = complete ? poses.take() : nullptr;
  }
  if (fields[4].o != nullptr) return record;
  release(vm, record);
  return nullptr;
}

Answer<Obj*> calibrate(Vm& vm, std::span<const Slot> matrices, std::span<const Slot> rows,
                       std::span<const Slot> size, std::int64_t terms) {
  if (!opencv_for(vm, "calibrateCamera")) return Failed{};
  if (size.size() != 2) {
    return failure(vm, "R0613", fmt::format("a size has 2 values, not {}", size.size()),
                   at("size"));
  }
  std::vector<PlanePoints> views;
  for (const Slot& each : matrices) {
    const auto view = pixels_of(vm, matrix_value(each), at("views"));
    if (!view) return Failed{};
    views.push_back(*view);
  }
  const auto points = points_of(vm, rows, at("points"));
  if (!points) return Failed{};
  const auto clamped = [](std::int64_t value) {
    return static_cast<int>(std::clamp<std::int64_t>(value, -1, 1'000'000));
  };
  const auto found = with_pictures(vm, 0, [&] {
    return calibrate_camera(views, *points, clamped(size[0].i), clamped(size[1].i), clamped(terms));
  });
  if (!found) return Failed{};
  if (!*found) return undetermined(vm, found->error());
  Obj* record = new_calibration(vm, **found);
  if (record == nullptr) return Failed{};
  return record;
}

std::vector<Eigen::Isometry3d> poses_of(const HostList<PosC>& list) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < list.size(); ++i) poses.push_back(list[i].T);
  return poses;
}

Answer<Obj*> calibrate_hand_eye(Vm& vm, HostList<PosC> tools, HostList<PosC> targets,
                                std::string_view method) {
  if (!opencv_for(vm, "calibrateHandEye")) return Failed{};
  const auto word = std::find(kHandEyeMethods.begin(), kHandEyeMethods.end(), method);
  if (word == kHandEyeMethods.end()) {
    return fail_picture(
        vm,
        fmt::format("there is no method \"{}\"; expected {}", method, choice_of(kHandEyeMethods)),
        at("method"));
  }
  const auto found = with_pictures(vm, 0, [&] {
    return hand_eye(poses_of(tools), poses_of(targets),
                    static_cast<HandEyeMethod>(word - kHandEyeMethods.begin()));
  });
  if (!found) return Failed{};
  if (!*found) return undetermined(vm, found->error());
  RecordObj* record = new_record(vm, vm.program().library_record("HandEye"));
  if (record == nullptr) return Failed{};
  record->fields()[0].o = new_posc(vm, {(*found)->T_tool_camera, true});
  record->fields()[1].d = (*found)->error;
  record->fields()[2].d = (*found)->tilt;
  if (record->fields()[0].o != nullptr) return record;
  release(vm, record);
  return Failed{};
}

Answer<Image> undistort(Vm& vm, const CameraRef& c, const Image& image) {
  const Intrinsics& lens = Host::of(vm).cell().cameras().at(c.id).lens.intrinsics();
  if (image.width() != lens.width || image.height() != lens.height) {
    return fail_picture(vm,
                        fmt::format("it has {} pixels, and this camera takes pictures of {} x {}",
                                    size_of(image), lens.width, lens.height),
                        at("img"));
  }
  const std::uint64_t pixels = std::uint64_t{1} * image.width() * image.height();
  return with_opencv(vm, "undistort", 60 * pixels, [&] {
    return undistorted(image, {lens.fx, lens.fy, lens.cx, lens.cy, lens.distortion});
  });
}

#define ARMLET_SHOWN_STATIONS                                                                    \
  "let mounted = xyz(20mm, 0mm, 60mm) * rotZ(30deg); let target = xyz(400mm, 0mm, 0mm); let "    \
  "tools = [xyz(z: 500mm), xyz(z: 600mm) * rotX(20deg), xyz(y: 50mm, z: 550mm) * rotY(25deg)]; " \
  "let seen = tools.map(fn(t) => inv(t * mounted) * target); "

constexpr NativeFunction kCalibrationFunctions[] = {
    def<calibrate>(
        "calibrateCamera(views: matrix[], points: length[][], size: int[], terms: int = 2) -> "
        "Calibration",
        "The matrix K and the distortion k1, k2, p1, p2, k3 of a camera from 3 to 30 views "
        "of a flat pattern: the pixels of its points in each, and the points, with z = 0, in its "
        "own frame. size: of the pictures. terms: 0, 1, 2, 4 or 5 terms of distortion are found. "
        "With the error in pixels, the deviations of fx, fy, cx, cy and the distortion, and the "
        "poses of the pattern in the frame of the camera. Needs OpenCV.",
        "let pattern = range(35).map(fn(i) => [20mm * (i % 7), 20mm * ((i - i % 7) / 7), 0mm]); "
        "camera eye { at: xyz(z: -500mm) }; let views = [rotX(20deg), rotY(20deg), rotX(-20deg) * "
        "rotY(20deg)].map(fn(p) => eye.project(pattern, from: inv(xyz(z: 500mm) * p))); "
        "print(calibrateCamera(views, pattern, [640, 480], terms: 0).error < 0.01)"),
    def<calibrate_hand_eye>(
        "calibrateHandEye(tools: posC[], targets: posC[], method: string = \"park\") -> HandEye",
        "The pose of a camera on the tool, from 3 to 100 stations: the poses of the tool in "
        "the world, and those of a target that does not move in the frame of the camera. The tool "
        "has to rotate about two axes between them. error and tilt: how far the target seems to "
        "move from station to station. method: \"tsai\", \"park\", \"horaud\" or \"daniilidis\". "
        "Needs OpenCV.",
        ARMLET_SHOWN_STATIONS "print(near(calibrateHandEye(tools, seen).pose, mounted, tol: 1um))",
        {.check = check_word<"method", kHandEyeMethods>}),
    def<undistort>("undistort(c: camera, img: image) -> image",
                   "What the camera would have seen without its distortion; black where the "
                   "picture shows nothing of that. Needs OpenCV.",
                   "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, "
                   "900mm)); size: [64, 48]; distortion: [-0.2, 0.0, 0.0, 0.0, 0.0] }; "
                   "print(undistort(eye, eye.capture()))",
                   {.check = gives_same_kind<"img">}),
};

}  // namespace

std::span<const NativeFunction> calibration_functions() { return kCalibrationFunctions; }

}  // namespace armlet::bind
