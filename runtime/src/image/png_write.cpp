#include <fmt/format.h>
#include <png.h>

#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/files.hpp"

namespace armlet {

std::string write_png(const Image& image) {
  check_8_bit("write_png", image);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width());
  header.height = static_cast<png_uint_32>(image.height());
  header.format = image.channels() == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  const int is_written =
      png_image_write_to_memory(&header, bytes.data(), &size, 0, image.bytes().data(), 0, nullptr);
  if (is_written == 0)
    throw ArgumentError(fmt::format("The picture of {} x {} pixels cannot be written as PNG: {}.",
                                    image.width(), image.height(), header.message));
  bytes.resize(size);
  return bytes;
}

}  // namespace armlet
