// Readers of picture files: any bytes give a picture, which is the same after it was written and
// read again, or a reason.
//
// The checksums of a PNG file are made right first, so that what stands in its chunks is read.

#include <zlib.h>

#include "armlet/image/files.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

std::string with_right_sums(std::string bytes) {
  if (!bytes.starts_with("\x89PNG")) return bytes;
  for (std::size_t at = 8; bytes.size() >= 12 && at <= bytes.size() - 12;) {
    const std::size_t length = number_at(bytes, at);
    if (length > bytes.size() - at - 12) break;
    const auto* const chunk = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    const uLong sum = crc32(0, chunk, static_cast<uInt>(length + 4));
    for (unsigned i = 0; i < 4; ++i)
      bytes[at + 8 + length + i] = static_cast<char>(sum >> (24U - 8U * i) & 0xFFU);
    at += length + 12;
  }
  return bytes;
}

void demand_same(const Image& picture, const std::string& file) {
  const Result<Image> again = read_image(file);
  fuzz::demand(again.ok() && *again == picture, "a picture reads back as it was written");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<Image> picture = read_image(with_right_sums(fuzz::text_of(data, size)));
  if (!picture.ok()) {
    fuzz::demand(!picture.error().message.empty(), "what is refused has a reason");
    return 0;
  }
  demand_same(*picture, write_png(*picture));
  demand_same(*picture, write_netpbm(*picture));
  const Result<Image> rough = read_image(write_jpeg(*picture));
  fuzz::demand(
      rough.ok() && rough->width() == picture->width() && rough->height() == picture->height(),
      "a JPEG file that was written has the size of the picture");
  return 0;
}
