// Corners, regions and results from points of pictures (language reference, section 15).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "armlet/image/parameters.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/vision/blobs.hpp"
#include "armlet/vision/corners.hpp"
#include "armlet/vision/correspondence.hpp"
#include "armlet/vision/homography.hpp"
#include "armlet/vision/planar_pose.hpp"
#include "armlet/world/looks.hpp"
#include "rules/rules_settings.hpp"
#include "values/eigen_results.hpp"
#include "values/matrices.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "values/world/objects.hpp"
#include "values/world/pictures.hpp"
#include "vision/features.hpp"
#include "vision/opencv_needed.hpp"

namespace armlet::bind {

Answer<void> searchable(Vm& vm, const Image& image) {
  constexpr std::int64_t kMost = Cameras::kMostPixels;
  const std::int64_t pixels = std::int64_t{image.width()} * image.height();
  if (pixels > kMost) {
    return fail_picture(
        vm,
        fmt::format("it has {} pixels, and corners are looked for in {} at most", pixels, kMost),
        CallPart::first(), "cut the part out that matters: img[x0:x1, y0:y1]");
  }
  if (image.kind() != PixelKind::kGrey)
    return fail_picture(vm, "corners are looked for in grey pictures", CallPart::first(),
                        "gray({arg}) is one");
  return {};
}

Answer<CornerMethod> corner_method(Vm& vm, std::string_view word, CallPart part) {
  if (word == kCornerMethods[0]) return CornerMethod::kSusan;
  if (word == kCornerMethods[1]) return CornerMethod::kHarris;
  if (word == kCornerMethods[2]) {
    if (!opencv_for(vm, "corners(method: \"fast\")")) return Failed{};
    return CornerMethod::kFast;
  }
  return fail_picture(
      vm, fmt::format("there is no method \"{}\"; expected {}", word, choice_of(kCornerMethods)),
      part);
}

Failed fail_lost(Vm& vm, FoundCorners found, const std::vector<double>& distance, CallPart part) {
  std::string rows;
  std::string distances;
  for (const int i : found.lost) {
    rows += fmt::format("{}{}", rows.empty() ? "" : ", ", i);
    const double far = distance[static_cast<std::size_t>(i)];
    distances += fmt::format("{}{}", distances.empty() ? "" : ", ",
                             std::isfinite(far) ? fmt::format("{:.1f} px", far) : "none");
  }
  Failure f;
  f.headline = {row("R0682"), {rows, fmt::format("{:g} px", found.within)}};
  f.mark = part;
  f.why = fmt::format("the nearest corners are this far from them: {}", distances);
  f.fix = "look from nearer to them, lower `threshold`, or widen the distance that is allowed";
  f.detail = std::make_shared<const FoundCorners>(std::move(found));
  return fail(vm, std::move(f));
}

Answer<PlanePoints> few_enough(Vm& vm, PlanePoints points) {
  if (points.rows() <= kMostMatched) return points;
  return fail_picture(vm,
                      fmt::format("{} corners were found, and at most {} are told apart",
                                  points.rows(), kMostMatched),
                      {}, "raise `threshold`, or cut out the part that matters");
}

Failed undetermined(Vm& vm, const Error& error) {
  Failure f;
  f.headline = {row("R0683"), {clause_of(error)}};
  return fail(vm, std::move(f));
}

Answer<PlanePoints> seen_by(Vm& vm, const CameraRef& c, const PlanePoints& pixels) {
  const Pinhole& lens = Host::of(vm).cell().cameras().at(c.id).lens;
  PlanePoints seen(pixels.rows(), 2);
  for (Eigen::Index i = 0; i < pixels.rows(); ++i) {
    const auto ray = lens.ray(pixels.row(i).transpose());
    if (!ray) return undetermined(vm, ray.error());
    seen.row(i) = ray->head<2>().transpose();
  }
  return seen;
}

Answer<RecordObj*> flat_pose(Vm& vm, const CameraRef& c, const PlanePoints& pixels,
                             const Points& points) try {
  if (!charge_work(vm, 20'000 * points.rows())) return Failed{};
  const auto seen = seen_by(vm, c, pixels);
  if (!seen) return Failed{};
  const auto found = planar_pose(points, *seen);
  if (!found) return undetermined(vm, found.error());
  RecordObj* record = new_record(vm, vm.program().library_record("PlanarPose"));
  if (record == nullptr) return Failed{};
  Slot* fields = record->fields();
  const double focal = Host::of(vm).cell().cameras().at(c.id).lens.intrinsics().fx;
  fields[0].o = new_posc(vm, {found->best.T_camera_obj, true});
  fields[1].d = focal * found->best.error;
  fields[2].o = fields[0].o == nullptr ? nullptr : new_posc(vm, {found->other.T_camera_obj, true});
  fields[3].d = focal * found->other.error;
  if (fields[2].o != nullptr) return record;
  release(vm, record);
  return Failed{};
} catch (const ArgumentError& error) {
  return undetermined(vm, {"", clause_of(error)});
}

namespace {

Answer<CornerOptions> corner_options(Vm& vm, std::string_view method, std::int64_t threshold,
                                     double quality, double distance, double sensitivity,
                                     std::int64_t max, bool refine) {
  const auto checked = with_pictures(vm, 0, [&] {
    check_picture_parameter("corners", "threshold", static_cast<double>(threshold));
    check_picture_parameter("corners", "quality", quality);
    check_picture_parameter("corners", "distance", distance);
    check_picture_parameter("corners", "sensitivity", sensitivity);
    check_picture_parameter("corners", "max", static_cast<double>(max));
    return true;
  });
  if (!checked) return Failed{};
  const auto found_by = corner_method(vm, method, at("method"));
  if (!found_by) return Failed{};
  return CornerOptions{.method = *found_by,
                       .threshold = static_cast<int>(threshold),
                       .quality = quality,
                       .distance = distance,
                       .sensitivity = sensitivity,
                       .max = static_cast<int>(max),
                       .refine = refine};
}

// R0687: no corner was found near any of the wanted points.
Failed fail_none(Vm& vm, const Image& image, const CornerOptions& options) {
  const auto levels = image.bytes();
  const auto [low, high] = std::minmax_element(levels.begin(), levels.end());
  const int darkest = *low, brightest = *high;
  Failure f;
  f.headline = Headline(row("R0687"));
  f.mark = CallPart::first();
  f.why = fmt::format("its grey levels go from {} to {}, a difference of {}", darkest, brightest,
                      brightest - darkest);
  f.fix = options.method == CornerMethod::kSusan && brightest - darkest <= options.threshold
              ? fmt::format("`threshold` is {}: choose less than the difference, or more light",
                            options.threshold)
              : "look at something that has corners, from where they are in the picture";
  return fail(vm, std::move(f));
}

// One corner for each wanted one, in their order.
Answer<PlanePoints> corners_near(Vm& vm, const Image& image, const CornerOptions& options,
                                 const PlanePoints& wanted, double within) {
  const auto found =
      with_pictures(vm, 0, [&] { return find_corners_around(image, wanted, within, options); });
  const auto points = found ? few_enough(vm, *found) : Failed{};
  if (!points) return Failed{};
  if (points->rows() == 0) return fail_none(vm, image, options);
  const auto matches = with_pictures(vm, 0, [&] { return match_points(*points, wanted, within); });
  if (!matches) return Failed{};
  PlanePoints out = wanted;
  for (Eigen::Index i = 0; i < wanted.rows(); ++i) {
    const int row = matches->index[static_cast<std::size_t>(i)];
    if (row >= 0) out.row(i) = points->row(row);
  }
  if (std::vector<int> lost = matches->lost(); !lost.empty())
    return fail_lost(vm, {std::move(out), std::move(lost), within}, matches->distance,
                     at("nearTo"));
  return out;
}

Answer<PlanePoints> corners(Vm& vm, const Image& image, std::string_view method,
                            std::int64_t threshold, double quality, double distance,
                            double sensitivity, std::int64_t max, std::optional<Slot> near_to,
                            double within, bool refine) {
  const auto options =
      corner_options(vm, method, threshold, quality, distance, sensitivity, max, refine);
  if (!options || !searchable(vm, image)) return Failed{};
  if (!near_to) return with_pictures(vm, 0, [&] { return find_corners(image, *options); });
  const auto wanted = pixels_of(vm, matrix_value(*near_to), at("nearTo"));
  const auto in_range = with_pictures(vm, 0, [&] {
    check_picture_parameter("corners", "within", within);
    return true;
  });
  if (!wanted || !in_range) return Failed{};
  return corners_near(vm, image, *options, *wanted, within);
}

// ---- regions

Obj* new_color(Vm& vm, const std::array<double, 3>& rgb) {
  RecordObj* record = new_record(vm, vm.program().library_record("Color"));
  for (std::size_t i = 0; record != nullptr && i < rgb.size(); ++i)
    record->fields()[i].i = static_cast<std::int64_t>(std::floor(rgb[i] + 0.5));
  return record;
}

RecordObj* new_blob(Vm& vm, const Blob& blob) {
  RecordObj* record = new_record(vm, vm.program().library_record("Blob"));
  if (record == nullptr) return nullptr;
  Slot* fields = record->fields();
  fields[0].d = blob.x;
  fields[1].d = blob.y;
  fields[2].i = blob.area;
  fields[3].d = blob.angle;
  fields[4].d = blob.width;
  fields[5].d = blob.height;
  fields[6].o = new_color(vm, blob.color);
  if (fields[6].o != nullptr) return record;
  release(vm, record);
  return nullptr;
}

Answer<Image> mask_of(Vm& vm, const Image& image, std::optional<std::string_view> color,
                      std::int64_t tolerance) {
  if (!color) return with_pictures(vm, 0, [&] { return to_grey(image); });
  const auto code = color_code(*color);
  if (!code) {
    const auto meant = similar_color(*color);
    return fail_picture(vm, fmt::format("there is no colour \"{}\"", *color), at("color"),
                        meant ? fmt::format("did you mean \"{}\"?", *meant) : "");
  }
  constexpr std::uint32_t kByte = 0xff;
  const std::array<std::uint8_t, 3> rgb{static_cast<std::uint8_t>(*code >> 16U & kByte),
                                        static_cast<std::uint8_t>(*code >> 8U & kByte),
                                        static_cast<std::uint8_t>(*code & kByte)};
  return with_pictures(vm, 0, [&] { return color_mask(image, rgb, static_cast<int>(tolerance)); });
}

Answer<Obj*> blobs(Vm& vm, const Image& image, std::int64_t min_area,
                   std::optional<std::string_view> color, std::int64_t tolerance) {
  const auto checked = with_pictures(vm, 20 * bytes_of(image), [&] {
    check_picture_parameter("blobs", "minArea", static_cast<double>(min_area));
    check_picture_parameter("blobs", "tolerance", static_cast<double>(tolerance));
    return true;
  });
  const auto mask = checked ? mask_of(vm, image, color, tolerance) : Failed{};
  if (!mask) return Failed{};
  const auto found = with_pictures(
      vm, 0, [&] { return find_blobs(*mask, image, {.min_area = static_cast<int>(min_area)}); });
  if (!found) return Failed{};
  ListMaker list(vm);
  for (const Blob& blob : *found) {
    if (!list.push(new_blob(vm, blob))) return Failed{};
  }
  Obj* made = list.take();
  if (made == nullptr) return Failed{};
  return made;
}

// ---- planes

// The rows of a matrix as points, with finite coordinates.
Answer<PlanePoints> points_in_plane(Vm& vm, const MatrixObj& matrix, CallPart part,
                                    std::string_view name) {
  if (matrix.cols != 2) {
    return failure(vm, "R0613",
                   fmt::format("points are the rows of an N x 2 matrix, x first; `{}` is {} x {}",
                               name, matrix.rows, matrix.cols),
                   part);
  }
  const PlanePoints points = Eigen::Map<const PlanePoints>(matrix.data(), matrix.rows, 2);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points.data()[i]))
      return not_finite(vm,
                        fmt::format("{} of point {} of `{}`", i % 2 == 0 ? "x" : "y", i / 2, name),
                        points.data()[i], part);
  }
  return points;
}

Answer<Eigen::Matrix3d> homography_of(Vm& vm, const MatrixObj& a, const MatrixObj& b) try {
  const auto from = points_in_plane(vm, a, at("a"), "a");
  const auto to = from ? points_in_plane(vm, b, at("b"), "b") : Failed{};
  if (!to || !charge_work(vm, 1000 * from->rows())) return Failed{};
  if (from->rows() != to->rows()) {
    return failure(vm, "R0613",
                   fmt::format("`a` has {} points and `b` {}; row i of the one belongs to row i of "
                               "the other",
                               from->rows(), to->rows()),
                   at("b"));
  }
  const auto H = homography(*from, *to);
  if (!H) return undetermined(vm, H.error());
  return *H;
} catch (const ArgumentError& error) {
  return undetermined(vm, {"", clause_of(error)});
}

Answer<RecordObj*> pose_from_points(Vm& vm, const CameraRef& c, const MatrixObj& matrix,
                                    std::span<const Slot> rows) {
  const auto pixels = pixels_of(vm, matrix, at("pixels"));
  const auto points = pixels ? points_of(vm, rows, at("points")) : Failed{};
  if (!points) return Failed{};
  if (pixels->rows() != points->rows()) {
    return failure(vm, "R0613",
                   fmt::format("`pixels` has {} rows and `points` {}; row i of the one belongs to "
                               "row i of the other",
                               pixels->rows(), points->rows()),
                   at("points"));
  }
  return flat_pose(vm, c, *pixels, *points);
}

#define ARMLET_SHOWN_SPOT                                                                         \
  "var m = zeros(60, 80); for (y in range(20, 40)) { for (x in range(30, 55)) { m[y, x] = 200 } " \
  "} "                                                                                            \
  "let img = image(m); "

constexpr NativeFunction kFeatureFunctions[] = {
    def<corners>(
        "corners(img: image, method: string = \"susan\", threshold: int = 20, quality: double = "
        "0.01, distance: double = 10.0, sensitivity: double = 0.04, max: int = 0, nearTo: matrix?, "
        "within: double = 20.0, refine: bool = true) -> matrix",
        "The corners of a grey picture, a row x, y in pixels for each, from the strongest to the "
        "weakest. method: \"susan\" takes pixels as alike that differ by much less than threshold, "
        "1 "
        "to 255 grey levels; \"fast\" takes those of nine or more connected pixels on a circle "
        "that differ by more, and needs OpenCV; \"harris\" leaves out what is weaker than quality, "
        "0 to 1, times the "
        "strongest one and nearer than distance px to a stronger one; sensitivity, 0 to 0.25, is "
        "its "
        "k. max: so many at most, 0: all. nearTo: for each row of this matrix the corner nearest "
        "to "
        "it, in the same order; FeatureLost if one is farther than within px. refine: to fractions "
        "of a pixel.",
        ARMLET_SHOWN_SPOT "print(corners(img, nearTo: [30, 20; 54, 39]))",
        {.check = check_word<"method", kCornerMethods>}),
    def<blobs>(
        "blobs(img: image, minArea: int = 20, color: string?, tolerance: int = 40) -> Blob[]",
        "The connected regions of pixels that are not black, or of a colour from which none of "
        "red, green and blue differs by more than tolerance, 0 to 255; smaller ones than "
        "minArea px are left out. Each has its centre x, y, its area, the angle of its long "
        "axis from x towards y, width and height of the rectangle with the same moments, all "
        "in pixels, and its mean color. They are in the order of their first pixels.",
        ARMLET_SHOWN_SPOT "print(blobs(img).length)"),
    def<homography_of>(
        "homography(a: matrix, b: matrix) -> matrix",
        "The projective map that takes the points a to the points b, each N x 2 with "
        "at least four rows in the same order.",
        "homography([0, 0; 1, 0; 1, 1; 0, 1], [0, 0; 2, 0; 2, 2; 0, 2])"),
    def<pose_from_points>(
        "poseFromPoints(c: camera, pixels: matrix, points: length[][]) -> PlanarPose",
        "The pose, in the frame of the camera, of a flat object from the pixels of four of its "
        "points "
        "or more, which are given in its own frame. A small or distant object looks nearly the "
        "same "
        "in two poses: both are given, with the error in pixels; eye.pose() * r.pose is the better "
        "one in the world.",
        "camera eye { at: lookingAt(xyz(), from: xyz(100mm, 0mm, 500mm)) }; let square = [[-50mm, "
        "-50mm, 0mm], [50mm, -50mm, 0mm], [50mm, 50mm, 0mm], [-50mm, 50mm, 0mm]]; "
        "print(poseFromPoints(eye, eye.project(square), square).error < 0.1)"),
};

}  // namespace

std::span<const NativeFunction> feature_functions() { return kFeatureFunctions; }

}  // namespace armlet::bind
