// Rows of a `lab` block with pictures: picture files, computed pictures, and views of cameras
// (language reference, section 16).

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "armlet/stdlib/host.hpp"
#include "armlet/world/looks.hpp"
#include "laboratory/lab_rules.hpp"
#include "laboratory/row_results.hpp"
#include "values/values.hpp"
#include "values/world/cameras.hpp"

namespace armlet::bind {
namespace {

using Text = std::string_view;
using OptionalWord = std::optional<std::string_view>;

// A row with a picture from a file.
Answer<LabRow> picture(Vm& vm, Text file, OptionalWord label, Text name) {
  constexpr std::size_t kMostBytes = 16 << 20;
  LabRow made = row_of(vm, LabRowKind::kImage, name, label);
  Result<std::string> bytes = Host::of(vm).load_file(std::string(file), kMostBytes);
  if (!bytes.ok()) return refuse_row(vm, made.kind, bytes.error().message, at("file"));
  if (const std::string fault = picture_fault(*bytes); !fault.empty())
    return refuse_row(vm, made.kind, fmt::format("\"{}\": {}", file, fault), at("file"));
  made.picture = std::make_shared<const std::string>(std::move(bytes).value());
  return made;
}

LabRow computed(Vm& vm, FunctionValue, OptionalWord label, Text name) {
  LabRow made = row_of(vm, LabRowKind::kImage, name, label);
  made.is_read = true;
  return made;
}

Answer<LabRow> view_row(Vm& vm, const CameraRef& of, std::optional<Slot> wanted, OptionalWord label,
                        Text name) {
  constexpr std::uint32_t kSides = 2;
  constexpr std::uint32_t kMostWanted = 200;
  LabRow made = row_of(vm, LabRowKind::kView, name, label);
  made.camera = Host::of(vm).cell().cameras().at(of.id).name;
  if (!wanted) return made;
  const MatrixObj& pixels = matrix_value(*wanted);
  if (pixels.cols != kSides || pixels.rows == 0) {
    return refuse_row(vm, made.kind,
                      fmt::format("pixels are the rows of an N x 2 matrix, x first; `wanted` is "
                                  "{} x {}",
                                  pixels.rows, pixels.cols),
                      at("wanted"));
  }
  if (pixels.rows > kMostWanted) {
    return refuse_row(
        vm, made.kind,
        fmt::format("`wanted` has {} pixels; expected at most {}", pixels.rows, kMostWanted),
        at("wanted"));
  }
  for (std::uint32_t i = 0; i < pixels.rows; ++i) {
    made.wanted.push_back({pixels.data()[kSides * i], pixels.data()[kSides * i + 1]});
    for (const double x : made.wanted.back()) {
      if (!std::isfinite(x))
        return refuse_row(vm, made.kind, fmt::format("row {} of `wanted` is not finite", i),
                          at("wanted"));
    }
  }
  return made;
}

Answer<LabRow> view(Vm& vm, const CameraRef& of, OptionalWord overlay, std::optional<Slot> wanted,
                    OptionalWord label, Text name) {
  Answer<LabRow> made = view_row(vm, of, wanted, label, name);
  if (!made || !overlay) return made;
  const std::optional<LabOverlay> known = overlay_named(*overlay);
  if (!known) return refuse_row(vm, made->kind, unknown_overlay(*overlay), at("overlay"));
  if (*known == LabOverlay::kWanted && !wanted)
    return refuse_row(vm, made->kind, kWantedMissing, at("overlay"));
  made->overlay = *known;
  return made;
}

template <bool kTakesPicture>
Answer<LabRow> view_of_features(Vm& vm, const CameraRef& of, FunctionValue,
                                std::optional<Slot> wanted, OptionalWord label, Text name) {
  Answer<LabRow> made = view_row(vm, of, wanted, label, name);
  if (!made) return made;
  made->is_read = true;
  made->takes_picture = kTakesPicture;
  return made;
}

constexpr std::string_view kViewHelp =
    "The picture of a camera at the instant that is looked at, drawn when somebody looks. overlay: "
    "what is marked in it: \"corners\" that are found there, \"truth\", the corners of objects "
    "that are in view, \"wanted\", or the pixels that a function gives, N x 2, x first, which may "
    "take the picture; the ways of these are drawn, too. wanted: where they are to be.";

constexpr NativeFunction kLabPictureFunctions[] = {
    def<picture>("lab.image.NAME(file: string, label: string?, name: string) -> labRow",
                 "A picture, PNG or JPEG, in the folder of the program; or what a function gives.",
                 "text intro(\"A file `cell.png` is shown by: image photo(\\\"cell.png\\\")\")"),
    def<computed>("lab.image.NAME(value: fn() -> image, label: string?, name: string) -> labRow",
                  "What the function gives at the instant that is looked at.",
                  "image photo(fn() => image([0, 128; 255, 64]))"),
    def<view, view_of_features<false>, view_of_features<true>>(
        "lab.view.NAME(of: camera, overlay: string? | fn() -> matrix | fn(image) -> matrix, "
        "wanted: matrix?, label: string?, name: string) -> labRow",
        kViewHelp,
        "view eyeView(of: eye, overlay: \"corners\"); view found(of: eye, overlay: fn(img) => "
        "corners(gray(img)))",
        {.check = check_view}),
};

}  // namespace

std::span<const NativeFunction> lab_picture_functions() { return kLabPictureFunctions; }

}  // namespace armlet::bind
