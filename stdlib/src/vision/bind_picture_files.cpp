// Pictures in files (language reference, section 15).

#include <fmt/format.h>

#include "armlet/image/files.hpp"
#include "armlet/image/picture_size.hpp"
#include "armlet/stdlib/host.hpp"
#include "rules/rules_settings.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "values/world/pictures.hpp"
#include "vision/picture_files.hpp"

namespace armlet::bind {
namespace {

constexpr FileKind kImageFile{"a picture", kImageEndings};

Failed bad_picture(Vm& vm, std::string_view file, std::string why, CallPart part) {
  Failure f;
  f.headline = {row("R0680"), {std::string(file), std::move(why)}};
  f.mark = part;
  return fail(vm, std::move(f));
}

Answer<Image> load_image(Vm& vm, std::string_view file) try {
  constexpr std::size_t kMostBytes = 64 << 20;
  constexpr std::uint64_t kCost = 16;  // operations per byte
  const Result<std::string> bytes = Host::of(vm).load_file(std::string(file), kMostBytes);
  if (!bytes.ok()) return bad_picture(vm, file, bytes.error().message, at("file"));
  const std::optional<PictureSize> size = picture_size(*bytes);  // known for PNG and JPEG
  const std::uint64_t pixels = size ? std::uint64_t{size->width} * size->height : 0;
  if (pixels > std::uint64_t{kMostPixels}) {
    return bad_picture(vm, file,
                       fmt::format("it has {} x {} pixels; at most {} are possible", size->width,
                                   size->height, kMostPixels),
                       at("file"));
  }
  if (!charge_work(vm, kCost * (bytes->size() + pixels))) return Failed{};
  Result<Image> image = read_image(*bytes);
  if (!image.ok()) {
    return bad_picture(vm, file, clause_of(image.error()), at("file"));
  }
  if (std::int64_t{image->width()} * image->height() > kMostPixels) {
    return bad_picture(
        vm, file,
        fmt::format("it has {} pixels; at most {} are possible", size_of(*image), kMostPixels),
        at("file"));
  }
  return std::move(image).value();
} catch (const ArgumentError& error) {
  return bad_picture(vm, file, clause_of(error), at("file"));
}

Answer<void> save_image(Vm& vm, const Image& image, std::string_view file) {
  return save_picture(vm, image, file, at("file"));
}

constexpr NativeFunction kPictureFileFunctions[] = {
    def<load_image>(
        "loadImage(file: string) -> image",
        "Reads a PNG, JPEG, PGM or PPM file; its first bytes decide which it is. A file "
        "of one channel gives a grey picture, others an RGB one. At most 64 MB, sides "
        "up to 8192 and 16777216 pixels.",
        "let img = loadImage(\"part.png\")"),
    def<save_image>("save(img: image, file: string)",
                    "Writes a picture into a file: .png and .jpg, or .pgm of a grey and .ppm of an "
                    "RGB picture.",
                    "image([0, 255; 255, 0]).save(\"corner.png\")",
                    {.check = check_ending<"file", kImageEndings>}),
};

}  // namespace

Answer<void> save_picture(Vm& vm, const Image& image, std::string_view file, CallPart part) {
  const std::string path(file);
  if (image.kind() == PixelKind::kDepth)
    return bad_picture(vm, file, "it holds depths, which such files do not take",
                       CallPart::first());
  const bool is_grey = image.kind() == PixelKind::kGrey;
  if (path.ends_with(is_grey ? ".ppm" : ".pgm")) {
    return bad_picture(vm, file,
                       is_grey ? "it is grey, and .ppm files are RGB: take .pgm or .png"
                               : "it is RGB, and .pgm files are grey: take .ppm or .png",
                       part);
  }
  const auto bytes = with_pictures(vm, 0, [&] {
    if (path.ends_with(".png")) return write_png(image);
    return path.ends_with(".jpg") || path.ends_with(".jpeg") ? write_jpeg(image)
                                                             : write_netpbm(image);
  });
  if (!bytes) return Failed{};
  const auto saved = Host::of(vm).save_file(kImageFile, path, *bytes);
  if (!saved.ok()) return bad_picture(vm, file, saved.error().message, part);
  return {};
}

std::span<const NativeFunction> picture_file_functions() { return kPictureFileFunctions; }

}  // namespace armlet::bind
