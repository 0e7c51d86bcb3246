// The one file in which stb_image_write is compiled; only its JPEG encoder is used.
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
//
#include <fmt/format.h>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/files.hpp"

namespace armlet {
namespace {

// Operations, for a byte of the pixels and for one of the file.
constexpr std::uint64_t kOfPixels = 8, kOfFile = 64;

// Is called for some 64 bytes of the file; the encoder holds no memory when a checkpoint stops it.
void append(void* bytes, void* data, int size) {
  checkpoint(kOfFile * static_cast<std::uint64_t>(size));
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data),
                                           static_cast<std::size_t>(size));
}

}  // namespace

std::string write_jpeg(const Image& image, int quality) {
  check_8_bit("write_jpeg", image);
  if (quality < 1 || quality > 100)
    throw ArgumentError(
        fmt::format("`quality` of `write_jpeg` is {}; expected 1 to 100.", quality));
  checkpoint(kOfPixels * image.bytes().size());
  std::string bytes;
  stbi_write_jpg_to_func(append, &bytes, image.width(), image.height(), image.channels(),
                         image.bytes().data(), quality);
  return bytes;
}

}  // namespace armlet
