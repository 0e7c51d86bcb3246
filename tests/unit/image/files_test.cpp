#include "armlet/image/files.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <random>
#include <sstream>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/plain_png.hpp"
#include "random_image.hpp"
#include "refusal_of.hpp"

using namespace armlet;

namespace {

Image random_image(std::mt19937_64& generator, PixelKind kind) {
  const int width = 1 + static_cast<int>(generator() % 70);
  return random_image(generator, width, 1 + static_cast<int>(generator() % 50), kind);
}

// A smooth picture, which JPEG keeps well.
Image waves(int width, int height, PixelKind kind) {
  Image image(width, height, kind);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < image.channels(); ++c)
        image.row(y)[x * image.channels() + c] = static_cast<std::uint8_t>(
            std::lround(127 + 100 * std::sin(0.1 * x + c) * std::cos(0.07 * y)));
  return image;
}

std::string message_of(std::string_view bytes) {
  const Result<Image> read = read_image(bytes);
  if (read.ok()) return "a picture";
  CHECK(read.error().code == "picture");
  return read.error().message;
}

std::string from_hex(std::string_view text) {
  std::string bytes;
  int high = -1;
  for (const char letter : text) {
    if (letter == ' ') continue;
    const int digit = letter <= '9' ? letter - '0' : letter - 'a' + 10;
    if (high >= 0) bytes += static_cast<char>(high * 16 + digit);
    high = high < 0 ? digit : -1;
  }
  return bytes;
}

void put_big_endian(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(value >> (24 - 8 * i));
}

// Bit by bit, unlike the table of the library.
std::uint32_t crc(std::string_view bytes) {
  std::uint32_t c = ~0U;
  for (const char byte : bytes) {
    c ^= static_cast<std::uint8_t>(byte);
    for (int i = 0; i < 8; ++i) c = (c & 1) != 0 ? 0xedb88320U ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

// A PNG file whose sides say something else, with the checksum that belongs to them.
std::string with_sides(std::string png, std::uint32_t width, std::uint32_t height) {
  put_big_endian(png, 16, width);
  put_big_endian(png, 20, height);
  put_big_endian(png, 29, crc(std::string_view(png).substr(12, 17)));
  return png;
}

}  // namespace

TEST_CASE("pictures come back from PNG, PGM and PPM as they were") {
  std::mt19937_64 generator(1);
  for (int round = 0; round < 60; ++round) {
    for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
      const Image image = random_image(generator, kind);
      CHECK(read_image(write_png(image)).value() == image);
      CHECK(read_image(write_netpbm(image)).value() == image);
    }
  }
}

TEST_CASE("JPEG keeps smooth pictures within a few grey levels") {
  for (const PixelKind kind : {PixelKind::kGrey, PixelKind::kRgb}) {
    const Image image = waves(67, 45, kind);
    const std::string bytes = write_jpeg(image, 95);
    const Image back = read_image(bytes).value();
    REQUIRE(back.width() == 67);
    REQUIRE(back.height() == 45);
    int worst = 0;
    for (int y = 0; y < 45; ++y)
      for (int x = 0; x < 67; ++x)
        for (int c = 0; c < 3; ++c) {
          const int b = back.row(y)[back.channels() * x + (back.channels() == 3 ? c : 0)];
          const int a = image.row(y)[image.channels() * x + (image.channels() == 3 ? c : 0)];
          worst = std::max(worst, std::abs(a - b));
        }
    CHECK(worst <= 12);  // rounding of coefficients; chroma has half the pixels
    CHECK(write_jpeg(image, 20).size() < bytes.size());
  }
}

TEST_CASE("files of other programs: palettes, opacity, 16 bits, interlacing, CMYK, progressive") {
  std::ifstream file(std::string(ARMLET_REFERENCE_DIR) + "/vision/picture_files.csv");
  std::string line;
  std::getline(file, line);
  int count = 0;
  for (; std::getline(file, line); ++count) {
    std::istringstream fields(line);
    std::string name, width, height, hex, pixels;
    for (std::string* field : {&name, &width, &height, &hex, &pixels})
      std::getline(fields, *field, ',');
    CAPTURE(name);
    const Result<Image> read = read_image(from_hex(hex));
    REQUIRE_MESSAGE(read.ok(), name);
    CHECK(read->width() == std::stoi(width));
    CHECK(read->height() == std::stoi(height));
    const std::string wanted = from_hex(pixels);
    REQUIRE(wanted.size() == read->bytes().size());
    int worst = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      worst =
          std::max(worst, std::abs(int{read->bytes()[i]} - static_cast<std::uint8_t>(wanted[i])));
    // Decoders of JPEG round coefficients differently; PNG is exact.
    CHECK(worst <= (name.find("JPEG") == std::string::npos ? 0 : 3));
  }
  CHECK(count >= 9);
}

TEST_CASE("PGM and PPM: text, comments, 16 bits and other largest values") {
  const Image grey = read_image("P2 # a comment\n3 1 #more\n15\n0 7 15").value();
  CHECK(grey.bytes()[0] == 0);
  CHECK(grey.bytes()[1] == 119);
  CHECK(grey.bytes()[2] == 255);
  const Image wide = read_image(std::string_view("P5 2 1 65535\n\x80\x00\xff\xff", 17)).value();
  CHECK(wide.bytes()[0] == 128);
  CHECK(wide.bytes()[1] == 255);
  const Image colour = read_image("P3\n1 1\n255\n1 2 3\n").value();
  CHECK(colour.kind() == PixelKind::kRgb);
  CHECK(colour.bytes()[2] == 3);
  CHECK(message_of("P5 3 3 255\nabcd") ==
        "The PGM file says 3 x 3 pixels, which take at least 9 bytes; 4 follow its header.");
  CHECK(message_of("P2 2 1 15 3 16") ==
        "Value 2 of the PGM file, before byte 14, is 16; expected 0 to 15.");
  CHECK(message_of("P2 2 1 15 3 x..") ==
        "Value 2 of the PGM file, before byte 12, is no number; expected 0 to 15.");
  CHECK(message_of("P5 9000 3 255\n") ==
        "The PGM file says 9000 x 3 pixels; expected sides of 1 to 8192.");
  CHECK(message_of("P6 3 3 70000\n") ==
        "The largest value of the PPM file is 70000; expected 1 to 65535.");
  CHECK(message_of("P6 3") ==
        "The header of the PPM file ends at byte 4 without width, height and largest value.");
}

TEST_CASE("damage is described with its position and numbers") {
  std::mt19937_64 generator(5);
  const std::string png = write_png(random_image(generator, PixelKind::kRgb));
  CHECK(message_of("") == "The picture's file is empty.");
  CHECK(message_of("GIF89a") ==
        "The file begins with the bytes 47 49 46 38, which is no PNG (89 50 4e 47), JPEG (ff d8), "
        "PGM or PPM (P2, P3, P5, P6).");
  CHECK(message_of(png.substr(0, png.size() - 5)).starts_with("The PNG file ends at byte "));
  CHECK(message_of(png.substr(0, 60)).find(" of the PNG file says ") != std::string::npos);
  std::string flipped = png;
  flipped[flipped.size() - 20] ^= 1;
  CHECK(message_of(flipped).find("is damaged: its checksum is ") != std::string::npos);
  CHECK(message_of(with_sides(png, 100'000, 100'000)) ==
        "The PNG file says 100000 x 100000 pixels; expected sides of 1 to 8192.");
  CHECK(message_of(with_sides(png, 0, 5)) ==
        "The PNG file says 0 x 5 pixels; expected sides of 1 to 8192.");
  CHECK(
      message_of(with_sides(png, 8192, 8192))
          .starts_with("The PNG file says 8192 x 8192 pixels, which take at least 195083 bytes; "));
  const Result<Image> more = read_image(with_sides(png, 90, 90));
  REQUIRE(!more.ok());
  CHECK(more.error().message.starts_with("The pixels of the PNG file of "));

  const std::string jpeg = write_jpeg(waves(40, 30, PixelKind::kRgb));
  CHECK(message_of(jpeg.substr(0, jpeg.size() - 2)).ends_with("before its last marker ff d9."));
  CHECK(message_of(jpeg.substr(0, 3)) == "The JPEG file of 3 bytes has no frame (SOF).");
  const std::size_t frame = jpeg.find("\xff\xc0");
  REQUIRE(frame != std::string::npos);
  std::string other = jpeg;
  other[frame + 1] = '\xc9';
  CHECK(message_of(other).starts_with("The JPEG file is of the kind SOF9 "));
  other = jpeg;
  other[frame + 4] = 12;
  CHECK(message_of(other) == "The JPEG file has 12 bits a channel; expected 8.");
  other = jpeg;
  other[frame + 5] = '\x1f';
  other[frame + 7] = '\x1f';
  CHECK(message_of(other).find("pixels, which take at least ") != std::string::npos);
  // More codes than a Huffman table holds, which stb_image would write behind its table.
  const std::size_t tables = jpeg.find("\xff\xc4");
  REQUIRE(tables != std::string::npos);
  other = jpeg;
  other[tables + 5 + 8] = '\xff';
  other[tables + 5 + 9] = '\xff';
  CHECK(message_of(other).starts_with(
      fmt::format("The Huffman table at byte {} of the JPEG file says ", tables + 4)));
}

TEST_CASE("a scan of a JPEG file needs the tables that it uses before it") {
  const std::string jpeg = write_jpeg(waves(40, 30, PixelKind::kRgb));
  // Without the first table of a kind: stb_image would read memory that nothing was written to.
  const auto without = [&](const char* marker, std::size_t size) {
    std::string other = jpeg;
    const std::size_t at = other.find(marker);
    REQUIRE(at != std::string::npos);
    return other.erase(at, size);
  };
  const std::size_t codes = jpeg.find("\xff\xc4"), sizes = jpeg.find("\xff\xdb");
  const auto length = [&](std::size_t at) {
    return 2 + 256 * static_cast<unsigned char>(jpeg[at + 2]) +
           static_cast<unsigned char>(jpeg[at + 3]);
  };
  CHECK(message_of(without("\xff\xc4", length(codes)))
            .ends_with("needs the Huffman table 0, which no part before it has."));
  CHECK(message_of(without("\xff\xdb", length(sizes)))
            .ends_with("needs the quantisation table 0, which no part before it has."));
  std::string other = jpeg;
  other[jpeg.find("\xff\xda") + 5] = '\x09';
  CHECK(message_of(other).ends_with("is of the channel 9, which its frame does not have."));
  CHECK(message_of(without("\xff\xc0", 2 + 17)).ends_with("stands before its frame."));
}

TEST_CASE("any bytes give a picture or a sentence") {
  std::mt19937_64 generator(9);
  const std::string seeds[] = {
      write_png(waves(20, 17, PixelKind::kRgb)),  write_png(waves(21, 16, PixelKind::kGrey)),
      write_jpeg(waves(33, 17, PixelKind::kRgb)), write_jpeg(waves(19, 30, PixelKind::kGrey)),
      write_netpbm(waves(9, 8, PixelKind::kRgb)), "P2 3 2 9\n1 2 3 4 5 6\n"};
  int pictures = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = seeds[generator() % 6];
    for (std::uint64_t i = generator() % 8 + 1; i > 0; --i)
      bytes[generator() % bytes.size()] = static_cast<char>(generator());
    if (generator() % 4 == 0) bytes.resize(generator() % (bytes.size() + 1));
    const Result<Image> read = read_image(bytes);
    pictures += read.ok();
    if (!read.ok()) CHECK(read.error().message.back() == '.');
  }
  CHECK(pictures > 100);
  CHECK(pictures < 2900);
}

TEST_CASE("work on files can be stopped, several times in each pass over the pixels") {
  // Counts operations, each about a nanosecond, and stops when `left` of them are done.
  class Watch final : public Supervisor {
   public:
    explicit Watch(std::uint64_t left) : left_(left) {}
    bool go_on(std::uint64_t operations) override {
      longest_ = std::max(longest_, operations);
      done_ += operations;
      return done_ <= left_;
    }
    [[nodiscard]] std::uint64_t longest() const { return longest_; }
    [[nodiscard]] std::uint64_t done() const { return done_; }

   private:
    std::uint64_t left_, longest_ = 0, done_ = 0;
  };
  std::mt19937_64 generator(3);
  const Image image = random_image(generator, 1024, 1024, PixelKind::kRgb);
  const std::string png = write_png(image), jpeg = write_jpeg(image);
  const std::function<void()> works[] = {
      [&] { (void)write_png(image); }, [&] { (void)write_jpeg(image); },
      [&] { (void)plain_png(image); }, [&] { (void)read_image(png); },
      [&] { (void)read_image(jpeg); }};
  for (const auto& work : works) {
    Watch whole(UINT64_MAX);
    {
      const Supervised watch(&whole);
      work();
    }
    CHECK(whole.done() > 10'000'000);  // some operations for each value
    CHECK(whole.longest() < 30'000'000);
    for (const std::uint64_t share : {0, 1, 2}) {
      Watch some(whole.done() * share / 3);
      const Supervised watch(&some);
      CHECK_THROWS_AS(work(), Stopped);
    }
  }
}

TEST_CASE("pictures of depths and qualities out of range are refused in words") {
  const Image depth(3, 3, PixelKind::kDepth);
  CHECK(refusal_of([&] { (void)write_png(depth); }) ==
        "`write_png` takes a grey or coloured picture, not one of depths.");
  CHECK(refusal_of([&] { (void)write_jpeg(Image(3, 3, PixelKind::kGrey), 101); }) ==
        "`quality` of `write_jpeg` is 101; expected 1 to 100.");
  CHECK_THROWS_AS((void)write_netpbm(Image()), ArgumentError);
}
