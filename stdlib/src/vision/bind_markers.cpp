// Markers, and poses from known points, by OpenCV (language reference, section 15).

#include <fmt/format.h>

#include <algorithm>

#include "armlet/image/parameters.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/vision/markers.hpp"
#include "armlet/vision/solid_pose.hpp"
#include "rules/rules_settings.hpp"
#include "values/matrices.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "vision/features.hpp"
#include "vision/opencv_needed.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {
namespace {

Answer<int> dictionary_of(Vm& vm, std::string_view word) {
  const auto found = std::find(kMarkerDictionaries.begin(), kMarkerDictionaries.end(), word);
  if (found != kMarkerDictionaries.end())
    return static_cast<int>(found - kMarkerDictionaries.begin());
  return fail_picture(vm,
                      fmt::format("there is no dictionary \"{}\"; expected {}", word,
                                  choice_of(kMarkerDictionaries)),
                      at("dictionary"));
}

RecordObj* new_marker(Vm& vm, const FoundMarker& marker) {
  RecordObj* record = new_record(vm, vm.program().library_record("Marker"));
  if (record == nullptr) return nullptr;
  record->fields()[0].i = marker.id;
  MatrixObj* corners = new_matrix_unset(vm, 4, 2);
  record->fields()[1].o = corners;
  if (corners == nullptr) {
    release(vm, record);
    return nullptr;
  }
  for (int i = 0; i < 8; ++i) corners->data()[i] = marker.corners(i / 2, i % 2);
  return record;
}

Answer<Obj*> markers(Vm& vm, const Image& image, std::string_view dictionary) {
  const auto index = dictionary_of(vm, dictionary);
  if (!index || !grey_for_opencv(vm, image)) return Failed{};
  const std::uint64_t pixels = std::uint64_t{1} * image.width() * image.height();
  const auto found =
      with_opencv(vm, "markers", 100 * pixels, [&] { return find_markers(image, *index); });
  if (!found) return Failed{};
  ListMaker list(vm);
  for (const FoundMarker& marker : *found)
    if (!list.push(new_marker(vm, marker))) return Failed{};
  Obj* made = list.take();
  if (made == nullptr) return Failed{};
  return made;
}

Answer<Image> picture_of_marker(Vm& vm, std::int64_t id, std::string_view dictionary,
                                std::int64_t cell) {
  const auto index = dictionary_of(vm, dictionary);
  if (!index) return Failed{};
  return with_opencv(vm, "markerPicture", 1'000'000, [&] {
    check_picture_parameter("markerPicture", "id", static_cast<double>(id));
    check_picture_parameter("markerPicture", "cell", static_cast<double>(cell));
    return marker_picture(static_cast<int>(id), *index, static_cast<int>(cell));
  });
}

Answer<RecordObj*> pose_from_marker(Vm& vm, const CameraRef& c, const RecordObj& marker,
                                    double size) {
  const auto pixels = pixels_of(vm, matrix_value(marker.fields()[1]), at("marker"));
  if (!pixels) return Failed{};
  const auto points = with_pictures(vm, 0, [&] { return marker_points(size); });
  if (!points) return Failed{};
  return flat_pose(vm, c, *pixels, *points);
}

Answer<RecordObj*> pose_from_solid(Vm& vm, const CameraRef& c, const MatrixObj& matrix,
                                   std::span<const Slot> rows) {
  if (!opencv_for(vm, "poseFromSolid")) return Failed{};
  const auto pixels = pixels_of(vm, matrix, at("pixels"));
  const auto points = pixels ? points_of(vm, rows, at("points")) : Failed{};
  const auto seen = points ? seen_by(vm, c, *pixels) : Failed{};
  if (!seen) return Failed{};
  const auto found = with_pictures(vm, 0, [&] { return solid_pose(*points, *seen); });
  if (!found) return Failed{};
  if (!*found) return undetermined(vm, found->error());
  RecordObj* record = new_record(vm, vm.program().library_record("SolidPose"));
  if (record == nullptr) return Failed{};
  record->fields()[0].o = new_posc(vm, {(*found)->T_camera_obj, true});
  record->fields()[1].d =
      Host::of(vm).cell().cameras().at(c.id).lens.intrinsics().fx * (*found)->error;
  if (record->fields()[0].o != nullptr) return record;
  release(vm, record);
  return Failed{};
}

#define ARMLET_SHOWN_MARKER                                                                     \
  "camera eye { at: lookingAt(xyz(), from: xyz(z: 500mm)) }; let img = markerPicture(7, cell: " \
  "10); "

constexpr NativeFunction kMarkerFunctions[] = {
    def<markers>("markers(img: image, dictionary: string = \"4x4_50\") -> Marker[]",
                 "The square markers of a grey picture in the order of their numbers: each has its "
                 "id and its corners in pixels, a row for the upper left, upper right, lower right "
                 "and lower left one of the marker when it stands upright. dictionary: \"4x4_50\", "
                 "\"5x5_100\", \"6x6_250\", \"aruco\" or \"apriltag_36h11\". Needs OpenCV.",
                 ARMLET_SHOWN_MARKER "print(markers(img).map(fn(m) => m.id))",
                 {.check = check_word<"dictionary", kMarkerDictionaries>}),
    def<picture_of_marker>(
        "markerPicture(id: int, dictionary: string = \"4x4_50\", cell: int = 20) -> image",
        "The picture of a marker: its black square with cells of cell px, 1 to 200, and one cell "
        "of white around it. Of \"4x4_50\" it has 8 cells across, 6 of them in the square. Needs "
        "OpenCV.",
        "print(markerPicture(3))",
        {.check =
             [](CheckCall& call) {
               check_word<"dictionary", kMarkerDictionaries>(call);
               gives_kind<PixelKind::kGrey>(call);
             }}),
    def<pose_from_marker>(
        "poseFromMarker(c: camera, marker: Marker, size: length) -> PlanarPose",
        "The pose of a marker in the frame of the camera: x to its right, y upwards, z out of it. "
        "size: of a side of its black square. As poseFromPoints, it gives both poses of a plane.",
        "camera near { at: xyz(); size: [80, 80]; focal: 100 }; let img = markerPicture(7, cell: "
        "10); "
        "print(poseFromMarker(near, markers(img)[0], size: 60mm).error < 1.0)"),
    def<pose_from_solid>(
        "poseFromSolid(c: camera, pixels: matrix, points: length[][]) -> SolidPose",
        "The pose, in the frame of the camera, of an object from the pixels of four of its points "
        "or more, which are given in its own frame and need not lie in a plane; with the error in "
        "pixels. Needs OpenCV.",
        "camera eye { at: lookingAt(xyz(), from: xyz(100mm, 0mm, 500mm)) }; let corners = "
        "object(\"cube\").corners(); print(poseFromSolid(eye, eye.project(corners), "
        "corners).error < 0.1)"),
};

}  // namespace

std::span<const NativeFunction> marker_functions() { return kMarkerFunctions; }

}  // namespace armlet::bind
