// Thresholds, morphology, outlines and optical flow by OpenCV (language reference, section 15).

#include "armlet/image/parameters.hpp"
#include "armlet/vision/optical_flow.hpp"
#include "armlet/vision/shapes.hpp"
#include "values/eigen_results.hpp"
#include "values/matrices.hpp"
#include "values/world/cameras.hpp"
#include "vision/opencv_needed.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {
namespace {

Answer<Image> adaptive_levels(Vm& vm, const Image& image, std::int64_t radius, double offset,
                              bool gaussian) {
  if (!grey_for_opencv(vm, image)) return Failed{};
  return with_opencv(vm, "adaptiveThreshold", 0, [&] {
    check_picture_parameter("adaptiveThreshold", "radius", static_cast<double>(radius));
    return adaptive_threshold(image, static_cast<int>(radius), offset, gaussian);
  });
}

constexpr std::string_view kMorphologyNames[] = {"erode", "dilate", "opening", "closing"};

template <Morphology kOperation>
Answer<Image> morphology(Vm& vm, const Image& image, std::int64_t radius, bool disc) {
  return with_opencv(vm, kMorphologyNames[static_cast<int>(kOperation)], 0, [&] {
    check_picture_parameter(kMorphologyNames[static_cast<int>(kOperation)], "radius",
                            static_cast<double>(radius));
    return changed_by(kOperation, image, static_cast<int>(radius), disc);
  });
}

Answer<Obj*> contours(Vm& vm, const Image& image, bool holes, double min_area) {
  if (!grey_for_opencv(vm, image)) return Failed{};
  const std::uint64_t pixels = std::uint64_t{1} * image.width() * image.height();
  const auto found = with_opencv(vm, "contours", 30 * pixels,
                                 [&] { return find_contours(image, holes, min_area); });
  if (!found) return Failed{};
  ListMaker list(vm);
  for (const PlanePoints& contour : *found) {
    MatrixObj* points = new_matrix_unset(vm, static_cast<std::uint32_t>(contour.rows()), 2);
    if (points != nullptr) std::copy_n(contour.data(), contour.size(), points->data());
    if (!list.push(points)) return Failed{};
  }
  Obj* made = list.take();
  if (made == nullptr) return Failed{};
  return made;
}

Answer<PlanePoints> polygon(Vm& vm, const MatrixObj& matrix, double tolerance) {
  const auto contour = pixels_of(vm, matrix, at("contour"));
  if (!contour) return Failed{};
  return with_opencv(vm, "polygon", 0, [&] { return polygon_of(*contour, tolerance); });
}

Answer<RecordObj*> flow(Vm& vm, const Image& from, const Image& to, const MatrixObj& matrix,
                        std::int64_t window, std::int64_t levels, double within) {
  if (!grey_for_opencv(vm, from, at("from")) || !grey_for_opencv(vm, to, at("to"))) return Failed{};
  const auto points = pixels_of(vm, matrix, at("points"));
  if (!points) return Failed{};
  const std::uint64_t pixels = std::uint64_t{1} * from.width() * from.height();
  const auto found = with_opencv(vm, "flow", 40 * pixels, [&] {
    check_picture_parameter("flow", "window", static_cast<double>(window));
    check_picture_parameter("flow", "levels", static_cast<double>(levels));
    return follow_points(from, to, *points,
                         {static_cast<int>(window), static_cast<int>(levels), within});
  });
  if (!found) return Failed{};
  RecordObj* record = new_record(vm, vm.program().library_record("Flow"));
  if (record == nullptr) return Failed{};
  Slot* fields = record->fields();
  MatrixObj* there = new_matrix_unset(vm, static_cast<std::uint32_t>(found->points.rows()), 2);
  fields[0].o = there;
  if (there != nullptr) {
    std::copy_n(found->points.data(), found->points.size(), there->data());
    ListObj* lost = new_list(vm, static_cast<std::uint32_t>(found->lost.size()), false);
    for (std::size_t i = 0; lost != nullptr && i < found->lost.size(); ++i)
      lost->data[i].i = found->lost[i];
    fields[1].o = lost;
  }
  if (fields[1].o != nullptr) return record;
  release(vm, record);
  return Failed{};
}

#define ARMLET_SHOWN_PATCH                                                                        \
  "var m = zeros(60, 80); for (y in range(20, 40)) { for (x in range(30, 55)) { m[y, x] = 200 } " \
  "} "                                                                                            \
  "let img = image(m); "

constexpr NativeFunction kShapeFunctions[] = {
    def<adaptive_levels>(
        "adaptiveThreshold(img: image, radius: int = 10, offset: double = 5.0, gaussian: "
        "bool = false) -> image",
        "A grey picture in black and white, for uneven light: 255 where a pixel is "
        "brighter than the mean of the square with 2 radius + 1 pixels around it less "
        "offset. radius: 1 to 100 px; offset: -255 to 255 grey levels; gaussian: the mean "
        "is weighted by a Gaussian bell. Needs OpenCV.",
        ARMLET_SHOWN_PATCH "print(adaptiveThreshold(img)[40, 30])",
        {.check = gives_kind<PixelKind::kGrey>}),
    def<morphology<Morphology::kErode>>(
        "erode(img: image, radius: int = 1, disc: bool = false) -> image",
        "Every pixel becomes the darkest one of the square with 2 radius + 1 pixels around it, or "
        "of a disc; radius: 1 to 50 px. Bright regions get smaller. Needs OpenCV.",
        ARMLET_SHOWN_PATCH "print(erode(img)[30, 20])", {.check = gives_same_kind<"img">}),
    def<morphology<Morphology::kDilate>>(
        "dilate(img: image, radius: int = 1, disc: bool = false) -> image",
        "The same with the brightest pixel. Bright regions get larger. Needs OpenCV.",
        ARMLET_SHOWN_PATCH "print(dilate(img)[29, 19])", {.check = gives_same_kind<"img">}),
    def<morphology<Morphology::kOpen>>(
        "opening(img: image, radius: int = 1, disc: bool = false) -> image",
        "erode and then dilate: bright spots and bridges that are narrower than 2 radius + 1 "
        "pixels are gone. Needs OpenCV.",
        ARMLET_SHOWN_PATCH "print(opening(img) == img)", {.check = gives_same_kind<"img">}),
    def<morphology<Morphology::kClose>>(
        "closing(img: image, radius: int = 1, disc: bool = false) -> image",
        "dilate and then erode: dark spots and gaps that are narrower than 2 radius + 1 pixels are "
        "gone. Needs OpenCV.",
        ARMLET_SHOWN_PATCH "print(closing(img) == img)", {.check = gives_same_kind<"img">}),
    def<contours>("contours(img: image, holes: bool = false, minArea: double = 0.0) -> matrix[]",
                  "The outlines of the regions of a grey picture that are not black, from the top: "
                  "of each the pixels on its border, a row x, y for each. holes: those of holes, "
                  "too. minArea: outlines around less are left out; at most 10000 are given. Needs "
                  "OpenCV.",
                  ARMLET_SHOWN_PATCH "print(contours(img).length)"),
    def<polygon>("polygon(contour: matrix, tolerance: double = 2.0) -> matrix",
                 "The corners of a polygon that is nowhere farther than tolerance px, 0 to 8192, "
                 "from a closed outline. Needs OpenCV.",
                 ARMLET_SHOWN_PATCH "print(polygon(contours(img)[0]).rows)"),
    def<flow>("flow(from: image, to: image, points: matrix, window: int = 21, levels: int = 3, "
              "within: double = 0.5) -> Flow",
              "Follows points, rows x, y in pixels, from one grey picture to the next by the "
              "brightness around them: points has them in the second one, and lost the rows of "
              "those that are not found again within px of their start when they are followed "
              "back; these stay where they were. window: side of the square around a point, odd, 5 "
              "to 51 px; levels: how often the pictures are halved, 0 to 8. Needs OpenCV.",
              ARMLET_SHOWN_PATCH "print(flow(img, img, [30, 20;]).lost)"),
};

}  // namespace

std::span<const NativeFunction> shape_functions() { return kShapeFunctions; }

}  // namespace armlet::bind
