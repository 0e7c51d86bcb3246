// The one file in which stb_image is compiled: PNG and JPEG from memory, no files, no other
// formats. Its vector code is left out so that one version is tested everywhere. Coefficients that
// no encoder writes overflow in its transforms: the file is compiled with -fwrapv, which defines
// that. Memory is cleared, because pixels that a corrupt file leaves out would otherwise be
// undefined. Where stb_image takes memory, which it does between its passes over the pixels, is a
// checkpoint; the blocks are kept in a list so that they are freed where work is stopped.
#include <cstdlib>
#include <set>
//
#include "armlet/core/checkpoint.hpp"

namespace {

// The blocks of memory of one picture that is decoded.
class Blocks {
 public:
  Blocks() : before_(present_) { present_ = this; }
  ~Blocks() {
    for (void* const block : taken_) std::free(block);
    present_ = before_;
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;

  static void* take(std::size_t size) {
    armlet::checkpoint(size);
    return present_->add(std::calloc(1, size));
  }
  static void* change(void* block, std::size_t size) {
    if (block == nullptr) return take(size);
    void* const other = std::realloc(block, size);
    if (other == nullptr) return nullptr;
    present_->taken_.erase(block);
    return present_->add(other);
  }
  static void drop(void* block) {
    present_->taken_.erase(block);
    std::free(block);
  }

 private:
  void* add(void* block) {
    if (block != nullptr) taken_.insert(block);
    return block;
  }

  static thread_local Blocks* present_;
  Blocks* before_;
  std::set<void*> taken_;
};

thread_local Blocks* Blocks::present_ = nullptr;

}  // namespace

#define STBI_MALLOC(size) Blocks::take(size)
#define STBI_REALLOC(block, size) Blocks::change(block, size)
#define STBI_FREE(block) Blocks::drop(block)
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_SIMD
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 8192
#include <stb/stb_image.h>
//
#include <fmt/format.h>

#include <memory>

#include "image/read_formats.hpp"

namespace armlet {
namespace {

static_assert(STBI_MAX_DIMENSIONS == Image::kMostSide);

std::uint8_t over_white(int value, int alpha) {
  return static_cast<std::uint8_t>((value * alpha + 255 * (255 - alpha) + 127) / 255);
}

// Copies pixels; the second or fourth channel is the opacity.
void copy_pixels(const std::uint8_t* from, int channels, Image& image) {
  const bool has_alpha = channels % 2 == 0;
  const int colours = image.channels();
  for (int y = 0; y < image.height(); ++y) {
    checkpoint(4 * static_cast<std::uint64_t>(image.width() * channels));
    std::uint8_t* to = image.row(y);
    for (int x = 0; x < image.width(); ++x, from += channels, to += colours) {
      for (int c = 0; c < colours; ++c)
        to[c] = has_alpha ? over_white(from[c], from[channels - 1]) : from[c];
    }
  }
}

}  // namespace

Result<Image> decode_png_or_jpeg(std::string_view format, std::string_view bytes) {
  int width = 0;
  int height = 0;
  int channels = 0;
  struct Release {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
  };
  const Blocks blocks;  // outlives the pixels
  const std::unique_ptr<stbi_uc, Release> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &channels, 0));
  if (pixels == nullptr) {
    const char* reason = stbi_failure_reason();
    return Error{kPictureCode, fmt::format("The pixels of the {} file of {} bytes cannot be "
                                           "decoded: {}.",
                                           format, bytes.size(), reason ? reason : "no reason")};
  }
  Image image(width, height, channels < 3 ? PixelKind::kGrey : PixelKind::kRgb);
  copy_pixels(pixels.get(), channels, image);
  return image;
}

}  // namespace armlet
