// Pictures of cameras, and the true data behind them (language reference, section 15).

#include <fmt/format.h>

#include "armlet/camera/interaction_matrix.hpp"
#include "armlet/camera/surfaces.hpp"
#include "armlet/stdlib/host.hpp"
#include "values/eigen_results.hpp"
#include "values/matrices.hpp"
#include "values/world/cameras.hpp"
#include "values/world/objects.hpp"
#include "values/world/pictures.hpp"
#include "vision/capture.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {
namespace {

// f(cell, pose of the camera, given or present); R0684 if it refuses.
template <class F>
auto looking(Vm& vm, const CameraRef& c, const PosC* from, F f)
    -> Answer<decltype(f(std::declval<Cell&>(), Eigen::Isometry3d()))> try {
  Cell& cell = Host::of(vm).cell();
  const Eigen::Isometry3d T_world_camera =
      from == nullptr ? cell.cameras().T_world_camera(cell, c.id)
                      : cell.cameras().T_world_camera_for(cell, c.id, from->T);
  return f(cell, T_world_camera);
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error));
}

Answer<Image> capture_depth(Vm& vm, const CameraRef& c, const PosC* from) {
  return looking(vm, c, from, [&](Cell& cell, const Eigen::Isometry3d& T) {
    return cell.cameras().depth(cell, c.id, T);
  });
}

Answer<MatrixObj*> capture_ids(Vm& vm, const CameraRef& c, const PosC* from) {
  const auto ids = looking(vm, c, from, [&](Cell& cell, const Eigen::Isometry3d& T) {
    return cell.cameras().bodies(cell, c.id, T);
  });
  if (!ids) return Failed{};
  const Intrinsics& lens = Host::of(vm).cell().cameras().at(c.id).lens.intrinsics();
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(lens.height),
                                  static_cast<std::uint32_t>(lens.width));
  if (A == nullptr) return Failed{};
  std::copy(ids->begin(), ids->end(), A->data());
  return A;
}

std::vector<std::string> bodies(Vm& vm, const CameraRef& c) {
  Cell& cell = Host::of(vm).cell();
  std::vector<std::string> names;
  for (const SceneBody& body : cell.cameras().scene(cell, c.id).bodies) names.push_back(body.name);
  return names;
}

// ---- geometry

Answer<Eigen::MatrixXd> project(Vm& vm, const CameraRef& c, std::span<const Slot> rows,
                                const PosC* from) try {
  const auto points = points_of(vm, rows, at("points"));
  if (!points || !charge_work(vm, 64 * points->rows())) return Failed{};
  Cell& cell = Host::of(vm).cell();
  const Cameras& cameras = cell.cameras();
  const Eigen::Isometry3d T_world_camera = from == nullptr
                                               ? cameras.T_world_camera(cell, c.id)
                                               : cameras.T_world_camera_for(cell, c.id, from->T);
  const Eigen::Isometry3d T_camera_world = T_world_camera.inverse(Eigen::Isometry);
  Eigen::MatrixXd pixels(points->rows(), 2);
  for (Eigen::Index i = 0; i < points->rows(); ++i) {
    const auto pixel = cameras.at(c.id).lens.project(T_camera_world * points->row(i).transpose());
    if (!pixel) {
      return fail_blind(vm, fmt::format("point {}: {}", i, clause_of(pixel.error())), at("points"));
    }
    pixels.row(i) = pixel->transpose();
  }
  return pixels;
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error));
}

// The directions of the rays through pixels, in the camera's frame with z = 1.
Answer<std::vector<Eigen::Vector3d>> rays_of(Vm& vm, const CameraRef& c, const PlanePoints& pixels,
                                             CallPart part) {
  const Pinhole& lens = Host::of(vm).cell().cameras().at(c.id).lens;
  std::vector<Eigen::Vector3d> rays;
  for (Eigen::Index i = 0; i < pixels.rows(); ++i) {
    const Eigen::Vector2d pixel = pixels.row(i).transpose();
    if (!pixel.allFinite()) return not_finite(vm, fmt::format("pixel {}", i), pixel.sum(), part);
    const auto ray = lens.ray(pixel);
    if (!ray) {
      return fail_blind(vm, fmt::format("row {}: {}", i, clause_of(ray.error())), part);
    }
    rays.push_back(*ray);
  }
  return rays;
}

Answer<std::vector<double>> ray(Vm& vm, const CameraRef& c, std::span<const double> pixel) {
  if (pixel.size() != 2) {
    return failure(vm, "R0613", fmt::format("a pixel has 2 values, not {}", pixel.size()),
                   at("pixel"));
  }
  PlanePoints one(1, 2);
  one << pixel[0], pixel[1];
  const auto rays = rays_of(vm, c, one, at("pixel"));
  const auto now = pose_now(vm, c);
  if (!rays || !now) return Failed{};
  const Eigen::Vector3d d = (now->linear() * rays->front()).normalized();
  return std::vector<double>{d.x(), d.y(), d.z()};
}

// One depth for each of `count` points; a single depth applies to all.
Answer<Eigen::VectorXd> depths_of(Vm& vm, std::span<const double> depths, Eigen::Index count,
                                  CallPart part) {
  if (depths.size() != 1 && static_cast<Eigen::Index>(depths.size()) != count) {
    return failure(
        vm, "R0613",
        fmt::format("{} depths for {} points; expected one or as many", depths.size(), count),
        part);
  }
  Eigen::VectorXd out(count);
  for (Eigen::Index i = 0; i < count; ++i)
    out[i] = depths[depths.size() == 1 ? 0 : static_cast<std::size_t>(i)];
  for (const double z : out) {
    if (!std::isfinite(z)) return not_finite(vm, "a depth", z, part);
    if (!(z > 0.0))
      return fail_blind(vm, fmt::format("a depth of {} m; expected more than 0", z), part);
  }
  return out;
}

template <class Depth>
std::span<const double> as_list(const Depth& depth) {
  if constexpr (std::is_same_v<Depth, double>) {
    return {&depth, 1};
  } else {
    return depth;
  }
}

template <class Depth>
Answer<std::vector<std::vector<double>>> unproject(Vm& vm, const CameraRef& c,
                                                   const MatrixObj& matrix, Depth depth) {
  const auto pixels = pixels_of(vm, matrix, at("pixels"));
  if (!pixels || !charge_work(vm, 256 * pixels->rows())) return Failed{};
  const auto depths = depths_of(vm, as_list(depth), pixels->rows(), at("depth"));
  const auto rays = depths ? rays_of(vm, c, *pixels, at("pixels")) : Failed{};
  const auto now = rays ? pose_now(vm, c) : Failed{};
  if (!now) return Failed{};
  std::vector<std::vector<double>> points;
  for (Eigen::Index i = 0; i < pixels->rows(); ++i) {
    const Eigen::Vector3d p = *now * ((*depths)[i] * (*rays)[static_cast<std::size_t>(i)]);
    points.push_back({p.x(), p.y(), p.z()});
  }
  return points;
}

template <class Depth>
Answer<Eigen::MatrixXd> interaction(Vm& vm, const CameraRef& c, const MatrixObj& matrix,
                                    Depth depth) try {
  const auto pixels = pixels_of(vm, matrix, at("s"));
  if (!pixels || !charge_work(vm, 512 * pixels->rows())) return Failed{};
  const auto depths = depths_of(vm, as_list(depth), pixels->rows(), at("depth"));
  if (!depths) return Failed{};
  auto L = interaction_matrix(Host::of(vm).cell().cameras().at(c.id).lens, *pixels, *depths);
  if (!L) {
    return fail_blind(vm, clause_of(L.error()), at("s"));
  }
  return std::move(L).value();
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error));
}

// ---- true data

// The depth along the camera axis of the nearest body within a pixel around one: a corner belongs
// to the body in front. Nullopt if there is no body.
std::optional<double> nearest_depth(const Scene& scene, const Pinhole& lens,
                                    const Eigen::Isometry3d& T_world_camera,
                                    const Eigen::Vector2d& pixel) {
  std::optional<double> nearest;
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    const auto ray = lens.ray(pixel + Eigen::Vector2d(x, y));
    if (!ray) continue;
    const auto hit = first_hit(scene, T_world_camera.translation(), T_world_camera.linear() * *ray);
    // The direction of the ray has z = 1, so t is the depth.
    if (hit && (!nearest || hit->t < *nearest)) nearest = hit->t;
  }
  return nearest;
}

Answer<std::vector<double>> depth(Vm& vm, const CameraRef& c, const MatrixObj& matrix) try {
  const auto pixels = pixels_of(vm, matrix, at("s"));
  const auto rays = pixels ? rays_of(vm, c, *pixels, at("s")) : Failed{};  // only for its checks
  const auto now = rays ? pose_now(vm, c) : Failed{};
  if (!now) return Failed{};
  Cell& cell = Host::of(vm).cell();
  const Scene scene = cell.cameras().scene(cell, c.id);
  const Pinhole& lens = cell.cameras().at(c.id).lens;
  std::vector<double> depths;
  for (Eigen::Index i = 0; i < pixels->rows(); ++i) {
    const auto z = nearest_depth(scene, lens, *now, pixels->row(i).transpose());
    if (!z) return fail_blind(vm, fmt::format("row {}: nothing is seen at this pixel", i), at("s"));
    depths.push_back(*z);
  }
  return depths;
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error));
}

Answer<double> sees(Vm& vm, const CameraRef& c, const ObjectRef& o) {
  if (find_object(vm, o.name) == nullptr) return fail_unknown_object(vm, o.name, at("o"));
  return looking(vm, c, nullptr, [&](Cell& cell, const Eigen::Isometry3d&) {
    return cell.cameras().visible_share(cell, c.id, o.name);
  });
}

Answer<MatrixObj*> seen_corners_of(Vm& vm, const CameraRef& c, const ObjectRef& o) {
  if (find_object(vm, o.name) == nullptr) return fail_unknown_object(vm, o.name, at("o"));
  const auto corners = looking(vm, c, nullptr, [&](Cell& cell, const Eigen::Isometry3d&) {
    return cell.cameras().corners(cell, c.id, o.name);
  });
  if (!corners) return Failed{};
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(corners->size()), 2);
  if (A == nullptr) return Failed{};
  for (std::size_t i = 0; i < corners->size(); ++i) {
    A->data()[2 * i] = (*corners)[i].pixel.x();
    A->data()[2 * i + 1] = (*corners)[i].pixel.y();
  }
  return A;
}

// Half the size of a shape along its axes, m; a mesh is centred at the middle of its box.
Eigen::Vector3d half_size(const Shape& shape) {
  const Surface surface = surface_of(shape);
  return 0.5 * (surface.high() - surface.low());
}

Answer<std::vector<std::vector<double>>> corners_of(Vm& vm, const ObjectRef& o) {
  const Object* object = find_object(vm, o.name);
  if (object == nullptr) return fail_unknown_object(vm, o.name, at("o"));
  const Eigen::Vector3d half = half_size(object->shape);
  constexpr double kAround[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::vector<std::vector<double>> points;
  for (const double up : {1.0, -1.0}) {
    for (const auto& [x, y] : kAround) {
      const Eigen::Vector3d p =
          object->T_world_obj * Eigen::Vector3d(x * half.x(), y * half.y(), up * half.z());
      points.push_back({p.x(), p.y(), p.z()});
    }
  }
  return points;
}

#define ARMLET_SHOWN_EYE                                                                        \
  "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, 900mm)); size: [64, " \
  "48] }; "

constexpr std::string_view kCapture = "capture(c: camera, from: posC?) -> image";
constexpr std::string_view kCaptureHelp =
    "The RGB picture of the camera at this instant, which takes no time; of a camera with a rate, "
    "its next picture, for which it waits. from: as in pose(c).";
constexpr std::string_view kCaptureExample = ARMLET_SHOWN_EYE "print(eye.capture())";

void check_capture(CheckCall& call) {
  note_kind(call, PixelKind::kRgb);
  check_rate(call, at("c"));
}

constexpr NativeFunction kCaptureNext =
    def<capture_next>(kCapture, kCaptureHelp, kCaptureExample, {.pauses = true});

constexpr NativeFunction kSightFunctions[] = {
    def<capture>(kCapture, kCaptureHelp, kCaptureExample,
                 {.check = check_capture, .timed = &kCaptureNext}),
    def<capture_depth>(
        "captureDepth(c: camera, from: posC?) -> image",
        "A picture of depths: how far what is seen lies along the axis of the camera, "
        "0 m where nothing is seen.",
        ARMLET_SHOWN_EYE "print(eye.captureDepth())", {.check = gives_kind<PixelKind::kDepth>}),
    def<capture_ids>("captureIds(c: camera, from: posC?) -> matrix",
                     "For each pixel, row by row, the index in bodies(c) of what is seen there, -2 "
                     "for the ground, -1 for nothing.",
                     ARMLET_SHOWN_EYE "print(max(eye.captureIds()))"),
    def<bodies>("bodies(c: camera) -> string[]",
                "The names of what a camera may see, in the order of the indices of captureIds.",
                ARMLET_SHOWN_EYE "print(eye.bodies())"),
    def<project>(
        "project(c: camera, points: length[][], from: posC?) -> matrix",
        "The pixels, a row for each, at which points of the world are seen: x to the right, "
        "y down, integers at pixel centres. They may lie outside of the picture. from: as in "
        "pose(c).",
        ARMLET_SHOWN_EYE "print(eye.project([[400mm, 0mm, 0mm]]))"),
    def<ray>("ray(c: camera, pixel: double[]) -> double[]",
             "The direction in which a pixel is seen, as a unit vector of the world.",
             ARMLET_SHOWN_EYE "print(eye.ray([31.5, 23.5]))"),
    def<unproject<double>, unproject<std::span<const double>>>(
        "unproject(c: camera, pixels: matrix, depth: length | length[]) -> length[][]",
        "The points of the world that are seen at pixels, at this depth along the "
        "axis of the camera.",
        ARMLET_SHOWN_EYE "print(eye.unproject([31.5, 23.5;], depth: 500mm))"),
    def<interaction<double>, interaction<std::span<const double>>>(
        "interactionMatrix(c: camera, s: matrix, depth: length | length[]) -> matrix",
        "How resting points move in the picture: two rows, in pixels per second, for each point, "
        "times the velocity of the camera along its own axes, vx, vy, vz in m/s, wx, wy, wz in "
        "rad/s. depth: of the points along the axis of the camera.",
        ARMLET_SHOWN_EYE "print(eye.interactionMatrix([31.5, 23.5;], depth: 500mm))"),
    def<depth>("depth(c: camera, s: matrix) -> length[]",
               "The true depth of what is nearest within a pixel around pixels. A real camera does "
               "not know it.",
               ARMLET_SHOWN_EYE "print(eye.depth([31.5, 23.5;]))"),
    def<sees>("sees(c: camera, o: object) -> double",
              "The share of the pixels of an object that is not hidden by others and lies in the "
              "picture, from 0 to 1.",
              ARMLET_SHOWN_EYE "print(eye.sees(object(\"table\")))"),
    def<seen_corners_of>("corners(c: camera, o: object) -> matrix",
                         "The pixels of the corners of an object that are in the picture and not "
                         "hidden: of a box or a plane, and the apex of a cone.",
                         ARMLET_SHOWN_EYE "print(eye.corners(object(\"cube\")))"),
    def<corners_of>("corners(o: object) -> length[][]",
                    "The corners of a box in the world: those of its upper face first, "
                    "counterclockwise from (-x, -y) of its own frame, then those below; of other "
                    "shapes those of the box around them.",
                    "print(object(\"cube\").corners())"),
};

}  // namespace

std::span<const NativeFunction> sight_functions() { return kSightFunctions; }

}  // namespace armlet::bind
