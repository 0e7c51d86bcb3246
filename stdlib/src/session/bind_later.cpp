// Functions of the language reference that nothing stands behind yet. Programs that use them are
// checked whole and then refused (E0199), so that they are right on the day the function arrives.

#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// `feature` is what the message says is missing; without it, the name.
constexpr NativeFunction later(std::string_view name, std::string_view signature,
                               std::string_view feature = {}) {
  return {.name = name, .signature = signature, .help = feature, .later = true};
}

constexpr NativeFunction later_motion(std::string_view name, std::string_view signature,
                                      std::string_view feature = {}) {
  NativeFunction function = later(name, signature, feature);
  function.pauses = true;
  return function;
}

constexpr NativeFunction kLaterFunctions[] = {
    // motion
    later_motion("speedC", "(r: robot, v: double[], frame: camera, during: time)",
                 "`speedC` in the frame of a camera"),
    // cameras and images
    later("robots.overheadCamera", "(name: string?) -> camera"),
    later("camera{}",
          "(name: string, on: robot, at: posC?, size: int[]?, fov: angle = 1rad) -> camera"),
    later("camera{}",
          "(name: string, on: object, at: posC?, size: int[]?, fov: angle = 1rad) -> camera"),
    later("camera{}", "(name: string, at: posC?, size: int[]?, fov: angle = 1rad) -> camera"),
    later("corners", "(o: object) -> length[][]", "`corners` of an object"),
    later("capture", "(c: camera) -> image"),
    later("project", "(c: camera, points: length[][], from: posC?) -> matrix"),
    later("depth", "(c: camera, s: matrix) -> length[]"),
    later("interactionMatrix", "(c: camera, s: matrix, depth: length[]) -> matrix"),
    later("image.width", "(img: image) -> int"),
    later("image.height", "(img: image) -> int"),
    later("gray", "(img: image) -> image"),
    later("blur", "(img: image, radius: double) -> image"),
    later("threshold", "(img: image, level: double) -> image"),
    later("edges", "(img: image, low: double, high: double) -> image"),
    later("corners",
          "(img: image, method: string = \"susan\", nearTo: matrix?, max: int = 1000) -> matrix",
          "`corners` of an image"),
    later("blobs", "(img: image, minArea: double = 1.0) -> Blob[]"),
    later("lines", "(img: image) -> matrix"),
    later("circles", "(img: image) -> matrix"),
    later("match", "(img: image, template: image) -> Match"),
    later("loadImage", "(path: string) -> image"),
    later("save", "(img: image, path: string)", "`save` of an image"),
    // pictures
    later("show", "(img: image)"),
    later("trail", "(r: robot)"),
};

}  // namespace

const HostType kCamera = {.name = "camera", .is_handle = true, .noun = "a camera"};
const HostType kImage = {.name = "image", .noun = "an image"};

std::span<const NativeFunction> later_functions() { return kLaterFunctions; }

}  // namespace armlet::bind
