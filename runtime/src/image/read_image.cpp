#include <fmt/format.h>

#include <limits>

#include "armlet/image/files.hpp"
#include "image/read_formats.hpp"

namespace armlet {
namespace {

std::string first_bytes(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes.substr(0, 4))
    text += fmt::format("{}{:02x}", text.empty() ? "" : " ", static_cast<std::uint8_t>(byte));
  return text;
}

}  // namespace

Result<Image> read_image(std::string_view bytes) {
  constexpr std::size_t kMostBytes = 1U << 30;
  static_assert(kMostBytes < std::numeric_limits<int>::max());
  if (bytes.size() > kMostBytes) {
    return Error{kPictureCode, fmt::format("The picture's file has {} bytes; expected at most {}.",
                                           bytes.size(), kMostBytes)};
  }
  if (bytes.starts_with(kPngSignature)) {
    if (std::string fault = fault_of_png(bytes); !fault.empty()) return Error{kPictureCode, fault};
    return decode_png_or_jpeg("PNG", bytes);
  }
  if (bytes.starts_with("\xff\xd8")) {
    if (std::string fault = fault_of_jpeg(bytes); !fault.empty()) return Error{kPictureCode, fault};
    return decode_png_or_jpeg("JPEG", bytes);
  }
  for (const char* kind : {"P2", "P3", "P5", "P6"})
    if (bytes.starts_with(kind)) return read_netpbm(bytes);
  return Error{kPictureCode,
               bytes.empty() ? std::string("The picture's file is empty.")
                             : fmt::format("The file begins with the bytes {}, which is no PNG "
                                           "(89 50 4e 47), JPEG (ff d8), PGM or PPM (P2, P3, P5, "
                                           "P6).",
                                           first_bytes(bytes))};
}

}  // namespace armlet
