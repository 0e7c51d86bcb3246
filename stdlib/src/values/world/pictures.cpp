#include "values/world/pictures.hpp"

#include <fmt/format.h>

namespace armlet::bind {
namespace {

const Image& image_in(const void* value) {
  return static_cast<const PictureValue*>(value)->kept->image;
}

void destroy(void* value) { static_cast<PictureValue*>(value)->~PictureValue(); }

bool equal(const void* a, const void* b) { return image_in(a) == image_in(b); }

void text(const void* value, std::string& out) {
  const Image& image = image_in(value);
  out += fmt::format("image {}, {}", size_of(image), kind_of(image.kind()));
}

// A host may keep its copy longer than the program, whose memory is counted.
void copy(const void* from, void* to) {
  auto kept = std::make_shared<KeptPicture>();
  kept->image = image_in(from);
  new (to) PictureValue{std::move(kept)};
}

}  // namespace

const HostType kImage = {.name = "image",
                         .size = sizeof(PictureValue),
                         .destroy = destroy,
                         .equal = equal,
                         .text = text,
                         .help = "A picture: grey, RGB, or of depths.",
                         .noun = "an image",
                         .copy = copy};

std::uint64_t bytes_of(const Image& image) {
  return image.bytes().size_bytes() + image.depths().size_bytes();
}

Obj* new_picture(Vm& vm, Image image) {
  auto kept = std::make_shared<KeptPicture>();
  kept->counted.emplace(vm, bytes_of(image));
  if (!kept->counted->granted()) return nullptr;
  kept->image = std::move(image);
  return new_host_value(vm, kImage, PictureValue{std::move(kept)});
}

std::string size_of(const Image& image) {
  return fmt::format("{} x {}", image.width(), image.height());
}

std::string_view kind_of(PixelKind kind) {
  return kind == PixelKind::kGrey ? "grey" : kind == PixelKind::kRgb ? "RGB" : "depths";
}

Failed fail_picture(Vm& vm, std::string_view clause, CallPart part, std::string fix) {
  Failure f;
  f.headline = {row("R0681"), {std::string(clause)}};
  f.mark = part;
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

Failed fail_outside(Vm& vm, const Image& image, std::int64_t x, std::int64_t y) {
  const bool x_fits = x >= 0 && x < image.width();
  const bool swapped_fits = y >= 0 && y < image.width() && x >= 0 && x < image.height();
  return failure(vm, "R0606",
                 fmt::format("pixel [{}, {}] is outside of a picture of {}", x, y, size_of(image)),
                 x_fits ? at("y") : at("x"),
                 fmt::format("x goes from 0 to {} and y, downwards, from 0 to {}",
                             image.width() - 1, image.height() - 1),
                 swapped_fits ? "x comes first, then y" : "");
}

}  // namespace armlet::bind
