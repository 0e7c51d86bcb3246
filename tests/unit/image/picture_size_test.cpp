#include "armlet/image/picture_size.hpp"

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "armlet/core/random.hpp"
#include "armlet/image/files.hpp"

using namespace armlet;

TEST_CASE("the size of a file is that of the picture that is read from it") {
  Random random(3);
  for (int round = 0; round < 40; ++round) {
    const auto side = [&] { return static_cast<int>(1 + random.below(70)); };
    const Image picture(side(), side(), random.below(2) == 0 ? PixelKind::kGrey : PixelKind::kRgb);
    for (const auto& [kind, bytes] : {std::pair("image/png", write_png(picture)),
                                      std::pair("image/jpeg", write_jpeg(picture))}) {
      CHECK(image_kind(bytes) == kind);
      const auto size = picture_size(bytes);
      REQUIRE(size.has_value());
      CHECK(size->is_usable());
      const Result<Image> read = read_image(bytes);
      REQUIRE(read.ok());
      CHECK(size->width == static_cast<std::size_t>(read->width()));
      CHECK(size->height == static_cast<std::size_t>(read->height()));
    }
  }
}

TEST_CASE("a PNG that is cut off anywhere has no size, and what is no picture has none") {
  const std::string bytes = write_png(Image(9, 5, PixelKind::kRgb));
  for (std::size_t n = 0; n < bytes.size(); ++n) CHECK_FALSE(picture_size(bytes.substr(0, n)));
  CHECK(image_kind("GIF89a").empty());
  CHECK_FALSE(picture_size("GIF89a"));
  CHECK_FALSE(picture_size(write_netpbm(Image(9, 5, PixelKind::kRgb))));
}
