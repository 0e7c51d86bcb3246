#include <fmt/format.h>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/files.hpp"
#include "image/read_formats.hpp"

namespace armlet {
namespace {

bool is_space(char letter) { return letter == ' ' || (letter >= '\t' && letter <= '\r'); }

// Reads numbers in text, separated by spaces and comments.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  // The next number, or -1 if there is none below a million.
  int number() {
    skip_space();
    const std::size_t first = at_;
    int value = 0;
    while (at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9' && value < 1'000'000)
      value = 10 * value + (bytes_[at_++] - '0');
    return at_ == first || value >= 1'000'000 ? -1 : value;
  }
  void skip(std::size_t count) { at_ += count; }
  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::size_t left() const { return at_ < bytes_.size() ? bytes_.size() - at_ : 0; }

 private:
  void skip_space() {
    while (at_ < bytes_.size()) {
      if (bytes_[at_] == '#') {
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
      } else if (is_space(bytes_[at_])) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view bytes_;
  std::size_t at_ = 2;
};

struct Header {
  const char* format;
  bool is_text;
  int channels;
  int width;
  int height;
  int most;  // the value of white
};

std::uint8_t scaled(int value, int most) {
  return static_cast<std::uint8_t>((255 * value + most / 2) / most);
}

Error error(std::string message) { return {kPictureCode, std::move(message)}; }

Error too_short(const Header& header, std::size_t needed, std::size_t left) {
  return error(fmt::format(
      "The {} file says {} x {} pixels, which take at least {} bytes; {} follow its header.",
      header.format, header.width, header.height, needed, left));
}

// The value of a channel in a binary file, of one byte or two.
int binary_value(std::string_view bytes, std::size_t at, std::size_t size, std::size_t index) {
  return static_cast<int>(big_endian(bytes, at + index * size, static_cast<int>(size)));
}

Result<Image> read_values(const Header& header, Reader& reader, std::string_view bytes) {
  const std::size_t count = static_cast<std::size_t>(header.width) *
                            static_cast<std::size_t>(header.height * header.channels);
  const std::size_t size = header.most < 256 ? 1 : 2;
  const std::size_t needed = header.is_text ? 2 * count - 1 : count * size;
  if (reader.left() < needed) return too_short(header, needed, reader.left());
  Image image(header.width, header.height,
              header.channels == 3 ? PixelKind::kRgb : PixelKind::kGrey);
  const std::size_t first = reader.at();
  std::uint8_t* out = image.row(0);
  constexpr std::size_t kBlock = 4096;  // values between two checkpoints
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kBlock == 0) checkpoint(4 * kBlock);
    const int value = header.is_text ? reader.number() : binary_value(bytes, first, size, i);
    if (value < 0 || value > header.most) {
      return error(fmt::format("Value {} of the {} file, before byte {}, is {}; expected 0 to {}.",
                               i + 1, header.format,
                               header.is_text ? reader.at() : first + (i + 1) * size,
                               value < 0 ? "no number" : fmt::format("{}", value), header.most));
    }
    out[i] = scaled(value, header.most);
  }
  return image;
}

}  // namespace

Result<Image> read_netpbm(std::string_view bytes) {
  const char kind = bytes[1];
  const bool is_colour = kind == '3' || kind == '6';
  Reader reader(bytes);
  Header header{.format = is_colour ? "PPM" : "PGM",
                .is_text = kind < '4',
                .channels = is_colour ? 3 : 1,
                .width = reader.number(),
                .height = reader.number(),
                .most = reader.number()};
  if (header.width < 0 || header.height < 0 || header.most < 0) {
    return error(fmt::format(
        "The header of the {} file ends at byte {} without width, height and largest value.",
        header.format, reader.at()));
  }
  if (std::string fault = fault_of_size(header.format, static_cast<std::uint64_t>(header.width),
                                        static_cast<std::uint64_t>(header.height));
      !fault.empty())
    return error(std::move(fault));
  if (header.most < 1 || header.most > 65535) {
    return error(fmt::format("The largest value of the {} file is {}; expected 1 to 65535.",
                             header.format, header.most));
  }
  reader.skip(1);  // one space ends the header
  return read_values(header, reader, bytes);
}

std::string write_netpbm(const Image& image) {
  check_8_bit("write_netpbm", image);
  checkpoint(image.bytes().size());
  std::string bytes = fmt::format("P{}\n{} {}\n255\n", image.channels() == 3 ? 6 : 5, image.width(),
                                  image.height());
  bytes.append(reinterpret_cast<const char*>(image.bytes().data()), image.bytes().size());
  return bytes;
}

}  // namespace armlet
