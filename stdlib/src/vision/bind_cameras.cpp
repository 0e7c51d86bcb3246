// Creation of cameras in a cell, and their poses (language reference, section 15).

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules_settings.hpp"
#include "values/eigen_results.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "values/world/objects.hpp"
#include "vision/capture.hpp"

namespace armlet::bind {

namespace {
constexpr int kPixelSides = 2;
constexpr double kUsualView = 1.0;  // rad, horizontal angle of view
constexpr const char* kNoRate = "leave `rate` out to take a picture whenever it is asked for";

using Number = std::optional<double>;
using Doubles = std::optional<std::span<const double>>;
using Wholes = std::optional<std::span<const Slot>>;

Failed fail_camera(Vm& vm, const std::string& clause, std::string fix = {}) {
  Failure f;
  f.headline = {row("R0685"), {clause}};
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

// The fields of a block besides the pose of the camera.
struct Rows {
  Wholes size{};
  Number fov{};
  Number focal{};
  Doubles centre{};
  Doubles distortion{};
  double near = 0.01;
  double far = 20.0;
  std::int64_t samples = 4;
  double noise = 0.0;
  double blur = 0.0;
  std::int64_t seed = 1;
  std::string_view light = kLightWords[0];
  bool ground = true;
  Number rate{};
};

// A side of a picture as an int; values out of range stay so, and the runtime refuses them.
int side_of(Slot slot) { return static_cast<int>(std::clamp<std::int64_t>(slot.i, -1, 1'000'000)); }

Answer<Intrinsics> intrinsics_of(Vm& vm, const Rows& rows) {
  int width = Intrinsics{}.width, height = Intrinsics{}.height;
  if (rows.size) {
    if (rows.size->size() != kPixelSides) {
      return fail_camera(vm, fmt::format("its `size` has {} numbers; expected the width and the "
                                         "height in pixels",
                                         rows.size->size()));
    }
    width = side_of((*rows.size)[0]);
    height = side_of((*rows.size)[1]);
  }
  if (rows.fov && rows.focal) {
    return fail_camera(vm, "it has both `fov`, the angle of view across the width, and `focal`",
                       "leave one of them out");
  }
  Intrinsics made = rows.focal ? intrinsics_from_focal(width, height, *rows.focal)
                               : intrinsics_from_fov(width, height, rows.fov.value_or(kUsualView));
  made.near = rows.near;
  made.far = rows.far;
  if (rows.centre) {
    if (rows.centre->size() != kPixelSides)
      return fail_camera(
          vm, fmt::format("its `centre` has {} numbers; expected a pixel", rows.centre->size()));
    made.cx = (*rows.centre)[0];
    made.cy = (*rows.centre)[1];
  }
  if (rows.distortion) {
    if (rows.distortion->size() > made.distortion.size()) {
      return fail_camera(vm,
                         fmt::format("its `distortion` has {} numbers; expected k1, k2, p1, p2, "
                                     "k3 or the first of them",
                                     rows.distortion->size()));
    }
    std::copy(rows.distortion->begin(), rows.distortion->end(), made.distortion.begin());
  }
  return made;
}

Answer<CameraRef> make_camera(Vm& vm, std::string_view name, const PosC* pose,
                              const Answer<Mount>& on, const Rows& rows) try {
  if (!on) return Failed{};
  const auto lens = intrinsics_of(vm, rows);
  if (!lens) return Failed{};
  if (std::ranges::find(kLightWords, rows.light) == kLightWords.end())
    return fail_camera(
        vm, fmt::format("its `light` is \"{}\"; expected \"key\" or \"flat\"", rows.light));
  if (rows.seed < 0)
    return fail_camera(vm, fmt::format("its `seed` is {}; expected 0 or more", rows.seed));
  if (rows.rate == 0.0) return fail_camera(vm, "its `rate` is 0 pictures a second", kNoRate);
  Camera camera{.name = std::string(name),
                .on = *on,
                .lens = Pinhole(*lens),
                .samples = static_cast<int>(std::clamp<std::int64_t>(rows.samples, -1, 100)),
                .noise = rows.noise,
                .blur = rows.blur,
                .seed = static_cast<std::uint64_t>(rows.seed),
                .key_light = rows.light == kLightWords[0],
                .ground = rows.ground,
                .rate = rows.rate.value_or(0.0)};
  if (pose != nullptr) camera.T_on_camera = pose->T;
  return CameraRef{Host::of(vm).cell().add_camera(std::move(camera))};
} catch (const ArgumentError& error) {
  return fail_camera(vm, clause_of(error));
}

void check_camera(CheckCall& call) {
  check_words(call, at("light"), kLightWords, "light");
  note_rate(call, at("rate"));
}

Answer<CameraRef> camera_block(Vm& vm, std::string_view name, const PosC* pose, Wholes size,
                               Number fov, Number focal, Doubles centre, Doubles distortion,
                               double near, double far, std::int64_t samples, double noise,
                               double blur, std::int64_t seed, std::string_view light, bool ground,
                               Number rate) {
  return make_camera(vm, name, pose, Mount{},
                     {size, fov, focal, centre, distortion, near, far, samples, noise, blur, seed,
                      light, ground, rate});
}
Answer<CameraRef> camera_on_robot(Vm& vm, std::string_view name, const RobotRef& on,
                                  std::optional<std::int64_t> link, const PosC* pose, Wholes size,
                                  Number fov, Number focal, Doubles centre, Doubles distortion,
                                  double near, double far, std::int64_t samples, double noise,
                                  double blur, std::int64_t seed, std::string_view light,
                                  bool ground, Number rate) {
  return make_camera(vm, name, pose, mount_on_robot(vm, on, link, at("link")),
                     {size, fov, focal, centre, distortion, near, far, samples, noise, blur, seed,
                      light, ground, rate});
}

template <class On>
Answer<CameraRef> camera_on(Vm& vm, std::string_view name, const On& on, const PosC* pose,
                            Wholes size, Number fov, Number focal, Doubles centre,
                            Doubles distortion, double near, double far, std::int64_t samples,
                            double noise, double blur, std::int64_t seed, std::string_view light,
                            bool ground, Number rate) {
  return make_camera(vm, name, pose, mount_on(vm, on, at("on")),
                     {size, fov, focal, centre, distortion, near, far, samples, noise, blur, seed,
                      light, ground, rate});
}

// ---- poses

Answer<PosC> camera_pose(Vm& vm, const CameraRef& camera, const PosC* from) try {
  if (from == nullptr) {
    const auto now = pose_now(vm, camera);
    if (!now) return Failed{};
    return PosC{*now, true};
  }
  Cell& cell = Host::of(vm).cell();
  return PosC{cell.cameras().T_world_camera_for(cell, camera.id, from->T), true};
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error), at("from"));
}

const Intrinsics& lens_of(Vm& vm, const CameraRef& camera) {
  return Host::of(vm).cell().cameras().at(camera.id).lens.intrinsics();
}
std::string camera_name(Vm& vm, const CameraRef& camera) {
  return Host::of(vm).cell().cameras().at(camera.id).name;
}
std::int64_t camera_width(Vm& vm, const CameraRef& camera) { return lens_of(vm, camera).width; }
std::int64_t camera_height(Vm& vm, const CameraRef& camera) { return lens_of(vm, camera).height; }
Eigen::Matrix3d camera_matrix(Vm& vm, const CameraRef& camera) {
  return Host::of(vm).cell().cameras().at(camera.id).lens.K();
}

Answer<PosC> looking_from(Vm& vm, const PosC& p, const PosC& from) try {
  return PosC{looking_at(p.T.translation(), from.T.translation()), true};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0685"), error, at("from"));
}

#define ARMLET_CAMERA_ROWS                                                                     \
  "at: posC?, size: int[]?, fov: angle?, focal: double?, centre: double[]?, distortion: "      \
  "double[]?, near: length = 10mm, far: length = 20m, samples: int = 4, noise: double = 0.0, " \
  "blur: double = 0.0, seed: int = 1, light: string = \"key\", ground: bool = true, rate: "    \
  "double?) -> camera"

constexpr std::string_view kCameraHelp =
    "A camera in the world, or on the flange or a link of a robot, on an object or a frame. at: "
    "its "
    "frame there, z forward, x to the right, y down. size: width and height, 640 x 480 px. Either "
    "fov, the angle of view across the width, or focal, the focal length in px. centre: the pixel "
    "of the optical axis. distortion: k1, k2, p1, p2, k3. What is nearer than near or farther than "
    "far is not seen. samples: 1 or 4 in each pixel. noise: standard deviation in grey levels, 0 "
    "to "
    "255, drawn from seed. blur: that of a Gaussian bell, 0 to 30 px. light: \"key\" has shades "
    "and "
    "shadows, \"flat\" none. rate: pictures a second, for each of which capture waits.";

constexpr NativeFunction kCameraFunctions[] = {
    def<camera_block>("camera{}(name: string, " ARMLET_CAMERA_ROWS, kCameraHelp,
                      "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, "
                      "800mm)); size: [320, 240]; fov: 60deg }",
                      {.check = check_camera, .acts = true}),
    def<camera_on_robot>("camera{}(name: string, on: robot, link: int?, " ARMLET_CAMERA_ROWS,
                         kCameraHelp,
                         "robot arm = robots.ur5(); camera eye { on: arm; at: xyz(z: 60mm); size: "
                         "[640, 480]; fov: 55deg }",
                         {.check = check_camera, .acts = true}),
    def<camera_on<ObjectRef>, camera_on<FrameRef>>(
        "camera{}(name: string, on: object | frame, " ARMLET_CAMERA_ROWS, kCameraHelp,
        "camera eye { on: object(\"cube\"); at: xyz(z: 100mm); focal: 600 }",
        {.check = check_camera, .acts = true}),
    def<looking_from>(
        "lookingAt(p: posC, from: posC) -> posC",
        "The frame of a camera at from whose axis runs through p: z forward, x to the "
        "right, y down, the world's z upwards in its picture. Only the positions of p "
        "and from count.",
        "lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(0mm, 0mm, 800mm))"),
    def<camera_pose>("pose(c: camera, from: posC?) -> posC",
                     "Where the camera is now. from: where it would be if the tool point of the "
                     "robot that carries it were there; of a camera on no robot it is from itself.",
                     "robot arm = robots.ur5(); camera eye { on: arm }; print(eye.pose())"),
    def<camera_name>("camera.name(c: camera) -> string", "The name of a camera.",
                     "camera eye { at: xyz(z: 1m) }; print(eye.name)"),
    def<camera_width>("camera.width(c: camera) -> int", "The width of its pictures in pixels.",
                      "camera eye { at: xyz(z: 1m) }; print(eye.width)"),
    def<camera_height>("camera.height(c: camera) -> int", "The height of its pictures in pixels.",
                       "camera eye { at: xyz(z: 1m) }; print(eye.height)"),
    def<camera_matrix>("camera.K(c: camera) -> matrix",
                       "The matrix of the camera, [fx, 0, cx; 0, fy, cy; 0, 0, 1], in pixels.",
                       "camera eye { at: xyz(z: 1m) }; print(eye.K)"),
};

}  // namespace

std::span<const NativeFunction> camera_functions() { return kCameraFunctions; }

}  // namespace armlet::bind
