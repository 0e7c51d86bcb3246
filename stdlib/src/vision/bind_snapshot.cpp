// Pictures of the whole cell in files (language reference, section 15).

#include <fmt/format.h>

#include "armlet/cell/overview.hpp"
#include "armlet/stdlib/host.hpp"
#include "rules/rules_settings.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "values/world/pictures.hpp"
#include "vision/picture_files.hpp"

namespace armlet::bind {
namespace {

constexpr std::int64_t kLeastSide = 16, kMostSide = 2048;  // pixels of a picture of the cell

// Adds the extension: "cell" is the file cell.png.
std::string with_ending(std::string_view file) {
  std::string path(file);
  if (path.find('.', path.find_last_of('/') + 1) == std::string::npos) path += ".png";
  return path;
}

void check_snapshot_file(CheckCall& call) {
  const auto file = call.given(at("file")) ? call.constant(at("file")) : std::nullopt;
  if (file && file->kind == Constant::Kind::kText && with_ending(file->text) == file->text)
    check_endings(call, at("file"), kSnapshotEndings);
}

Answer<void> save(Vm& vm, std::string_view file, const Viewpoint& from, const Scene& scene) {
  const auto image = with_pictures(vm, 0, [&] { return picture_from(from, scene); });
  if (!image) return Failed{};
  return save_picture(vm, *image, with_ending(file), at("file"));
}

Answer<void> snapshot(Vm& vm, std::string_view file, std::int64_t width, std::int64_t height) {
  Cell& cell = Host::of(vm).cell();
  const Scene scene = cell.cameras().scene(cell);
  for (const auto& [side, part] :
       {std::pair(width, at("width")), std::pair(height, at("height"))}) {
    if (side < kLeastSide || side > kMostSide) {
      return fail_picture(vm,
                          fmt::format("its {} would be {} pixels; expected {} to {}",
                                      part.parameter(), side, kLeastSide, kMostSide),
                          part);
    }
  }
  const auto from = with_pictures(vm, 0, [&] {
    Overview view(static_cast<int>(width), static_cast<int>(height));
    view.add(cell, scene);
    return view.viewpoint();
  });
  if (!from) return Failed{};
  return save(vm, file, *from, scene);
}

Answer<void> snapshot_from(Vm& vm, std::string_view file, const CameraRef& c) {
  const auto pose = pose_now(vm, c);
  if (!pose) return Failed{};
  Cell& cell = Host::of(vm).cell();
  return save(vm, file, {cell.cameras().at(c.id).lens, *pose}, cell.cameras().scene(cell, c.id));
}

constexpr NativeFunction kSnapshotFunctions[] = {
    def<snapshot>("snapshot(file: string, width: int = 960, height: int = 720)",
                  "Saves a picture of the cell as it is now, from the front, the right and above, "
                  "with all robots and what is around them: .png (also without an ending) or .jpg.",
                  "snapshot(\"cell\")", {.check = check_snapshot_file}),
    def<snapshot_from>("snapshot(file: string, from: camera)",
                       "The same as a camera sees it, with its size, light and ground, without "
                       "noise and blur. It does not count as a picture that the camera has taken.",
                       "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(900mm, -900mm, "
                       "900mm)) }; snapshot(\"cell.jpg\", from: eye)",
                       {.check = check_snapshot_file}),
};

}  // namespace

std::span<const NativeFunction> snapshot_functions() { return kSnapshotFunctions; }

}  // namespace armlet::bind
