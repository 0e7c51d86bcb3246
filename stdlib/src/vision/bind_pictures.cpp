// Pictures as values: their elements, parts and arithmetic (language reference, section 15).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/image/arithmetic.hpp"
#include "armlet/image/blur.hpp"
#include "armlet/image/noise.hpp"
#include "armlet/image/parameters.hpp"
#include "values/matrices.hpp"
#include "values/world/pictures.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {
namespace {

constexpr int kBrightest = 255;

std::int64_t width(const Image& image) { return image.width(); }
std::int64_t height(const Image& image) { return image.height(); }
std::int64_t channels(const Image& image) { return image.channels(); }

// ---- elements

bool is_inside(const Image& image, std::int64_t x, std::int64_t y) {
  return x >= 0 && x < image.width() && y >= 0 && y < image.height();
}

Answer<RecordObj*> color_at(Vm& vm, const Image& image, std::int64_t x, std::int64_t y) {
  if (!is_inside(image, x, y)) return fail_outside(vm, image, x, y);
  if (image.kind() == PixelKind::kDepth) {
    return fail_picture(vm, "it holds depths and has no colours", at("img"),
                        "matrix({arg})[y, x] is the depth in metres");
  }
  RecordObj* record = new_record(vm, vm.program().library_record("Color"));
  if (record == nullptr) return Failed{};
  const std::uint8_t* pixel = image.row(static_cast<int>(y)) + x * image.channels();
  for (int i = 0; i < 3; ++i) record->fields()[i].i = pixel[image.channels() == 3 ? i : 0];
  return record;
}

Answer<std::int64_t> grey_at(Vm& vm, const Image& image, std::int64_t x, std::int64_t y) {
  if (!is_inside(image, x, y)) return fail_outside(vm, image, x, y);
  if (image.kind() == PixelKind::kGrey) return image.row(static_cast<int>(y))[x];
  return fail_picture(vm, fmt::format("it was grey at first and is {} now", kind_of(image.kind())),
                      at("img"), "gray({arg})[x, y] is a number from 0 to 255");
}

Answer<double> depth_at(Vm& vm, const Image& image, std::int64_t x, std::int64_t y) {
  if (!is_inside(image, x, y)) return fail_outside(vm, image, x, y);
  if (image.kind() == PixelKind::kDepth) return image.depth_row(static_cast<int>(y))[x];
  return fail_picture(
      vm, fmt::format("it held depths at first and is {} now", kind_of(image.kind())), at("img"));
}

// ---- storing

// The picture itself if it has no other owner, otherwise a copy of it.
PictureValue* own_picture(Vm& vm, Slot& slot) {
  auto& value = *static_cast<PictureValue*>(static_cast<HostObj*>(slot.o)->payload());
  if (slot.o->refs == 1 && value.kept.use_count() == 1) {
    retain(slot.o);
    return &value;
  }
  if (!charge_work(vm, bytes_of(value.kept->image) / 8)) return nullptr;
  slot.o = new_picture(vm, value.kept->image);
  return slot.o == nullptr ? nullptr
                           : static_cast<PictureValue*>(static_cast<HostObj*>(slot.o)->payload());
}

// Calls store(image) if the indices are inside of the picture and it has this kind.
template <class F>
Answer<Obj*> store_at(Vm& vm, Slot picture, PixelKind kind, std::int64_t x, std::int64_t y,
                      F store) {
  const Image& image = host_value<PictureValue>(picture).kept->image;
  if (!is_inside(image, x, y)) return fail_outside(vm, image, x, y);
  if (image.kind() != kind) {
    constexpr std::string_view kStores[] = {"a number from 0 to 255", "a colour, rgb(r, g, b)",
                                            "a length"};
    constexpr std::string_view kFixes[] = {
        "store the grey level alone, or make an RGB picture: image(m, m, m) of m = matrix(img)",
        "store rgb(r, g, b), or make a grey picture: gray(img)", ""};
    const auto is = static_cast<std::size_t>(image.kind());
    Failure f;
    f.headline = {row("R0681"),
                  {fmt::format("a pixel of a picture of {}, {}, takes {}", size_of(image),
                               kind_of(image.kind()), kStores[is])}};
    f.mark = at("value");
    f.fix = kFixes[is];
    return fail(vm, std::move(f));
  }
  PictureValue* own = own_picture(vm, picture);
  if (own == nullptr) return Failed{};
  store(own->kept->image);
  return picture.o;
}

Answer<Obj*> store_grey(Vm& vm, Slot picture, std::int64_t x, std::int64_t y, std::int64_t value) {
  if (value < 0 || value > kBrightest)
    return fail_picture(vm, fmt::format("{} is no grey level; expected 0 to 255", value),
                        at("value"));
  return store_at(vm, picture, PixelKind::kGrey, x, y, [&](Image& image) {
    image.row(static_cast<int>(y))[x] = static_cast<std::uint8_t>(value);
  });
}

Answer<Obj*> store_color(Vm& vm, Slot picture, std::int64_t x, std::int64_t y,
                         const RecordObj& color) {
  std::array<std::uint8_t, 3> rgb{};
  for (int i = 0; i < 3; ++i) {
    const std::int64_t value = color.fields()[i].i;
    if (value < 0 || value > kBrightest) {
      return fail_picture(vm,
                          fmt::format("`{}` of a colour is {}; expected 0 to 255", "rgb"[i], value),
                          at("value"));
    }
    rgb[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(value);
  }
  return store_at(vm, picture, PixelKind::kRgb, x, y, [&](Image& image) {
    std::copy(rgb.begin(), rgb.end(), image.row(static_cast<int>(y)) + 3 * x);
  });
}

Answer<Obj*> store_depth(Vm& vm, Slot picture, std::int64_t x, std::int64_t y, double value) {
  if (!(value >= 0.0 && value <= 1e6))
    return fail_picture(vm,
                        fmt::format("{} is no depth; expected 0 m to 1000 km",
                                    std::isnan(value) ? "nan" : fmt::format("{} m", value)),
                        at("value"));
  return store_at(vm, picture, PixelKind::kDepth, x, y, [&](Image& image) {
    image.depth_row(static_cast<int>(y))[x] = static_cast<float>(value);
  });
}

// ---- parts and arithmetic

using End = std::optional<std::int64_t>;

Answer<Image> part_of(Vm& vm, const Image& image, End left, End right, End top, End bottom) {
  const std::int64_t x0 = left.value_or(0), x1 = right.value_or(image.width());
  const std::int64_t y0 = top.value_or(0), y1 = bottom.value_or(image.height());
  if (x0 < 0 || y0 < 0 || x1 > image.width() || y1 > image.height() || x0 >= x1 || y0 >= y1) {
    return failure(
        vm, "R0606",
        fmt::format("[{}:{}, {}:{}] is no part of a picture of {}", x0, x1, y0, y1, size_of(image)),
        {}, "the end of a range is left out of it, and x comes before y");
  }
  const PixelBox box{static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1),
                     static_cast<int>(y1)};
  return with_pictures(vm, (x1 - x0) * (y1 - y0), [&] { return cropped(image, box); });
}

std::uint64_t values_of(const Image& image) {
  return std::uint64_t{1} * image.width() * image.height() * image.channels();
}

// R0681 unless two pictures have the same size and kind.
Answer<void> check_alike(Vm& vm, const Image& a, const Image& b) {
  if (a.width() == b.width() && a.height() == b.height() && a.kind() == b.kind()) return {};
  return fail_picture(vm,
                      fmt::format("the two are {}, {}, and {}, {}; expected one size and kind",
                                  size_of(a), kind_of(a.kind()), size_of(b), kind_of(b.kind())),
                      at("b"));
}
Answer<Image> difference(Vm& vm, const Image& a, const Image& b) {
  if (!check_alike(vm, a, b)) return Failed{};
  return with_pictures(vm, values_of(a), [&] { return absolute_difference(a, b); });
}
Answer<Image> sum(Vm& vm, const Image& a, const Image& b) {
  if (!check_alike(vm, a, b)) return Failed{};
  return with_pictures(vm, values_of(a), [&] { return saturating_sum(a, b); });
}
Answer<Image> times(Vm& vm, const Image& image, double factor) {
  if (!(factor >= 0.0 && factor <= 1e6))
    return fail_picture(vm, fmt::format("{} is no factor; expected 0 to 1000000",
                                        std::isnan(factor) ? std::abs(factor) : factor));
  return with_pictures(vm, 4 * values_of(image), [&] { return scaled(image, factor); });
}
Answer<Image> of_times(Vm& vm, double factor, const Image& image) {
  return times(vm, image, factor);
}

Answer<Image> gray(Vm& vm, const Image& image) {
  return with_pictures(vm, 4 * values_of(image), [&] { return to_grey(image); });
}
Answer<Image> over_level(Vm& vm, const Image& image, std::int64_t level) {
  return with_pictures(vm, values_of(image), [&] {
    check_picture_parameter("threshold", "level", static_cast<double>(level));
    return threshold(image, static_cast<int>(level));
  });
}
Answer<Image> blur(Vm& vm, const Image& image, double sigma) {
  return with_pictures(vm, 0, [&] { return gaussian_blurred(image, sigma); });
}
Answer<Image> box_blur(Vm& vm, const Image& image, std::int64_t radius) {
  return with_pictures(vm, 0, [&] {
    check_picture_parameter("boxBlur", "radius", static_cast<double>(radius));
    return box_blurred(image, static_cast<int>(radius));
  });
}
Answer<Image> noise(Vm& vm, const Image& image, double sigma, std::int64_t seed) {
  return with_pictures(vm, bytes_of(image) / 8, [&] {
    check_picture_parameter("noise", "seed", static_cast<double>(seed));
    Random random(static_cast<std::uint64_t>(seed));
    Image noisy = image;
    add_noise(noisy, sigma, random);
    return noisy;
  });
}

// ---- matrices

Answer<MatrixObj*> to_matrix(Vm& vm, const Image& image, std::optional<std::int64_t> channel) {
  const std::int64_t chosen = channel.value_or(0);
  if (image.channels() == 3 && !channel) {
    return fail_picture(vm, "it is RGB, and a matrix has one number for each pixel", at("img"),
                        "take matrix(gray({arg})), or matrix({arg}, 0) for red, 1 green, 2 blue");
  }
  if (chosen < 0 || chosen >= image.channels()) {
    return fail_picture(vm, fmt::format("there is no channel {} of {}", chosen, image.channels()),
                        at("channel"));
  }
  MatrixObj* A = new_matrix_unset(vm, static_cast<std::uint32_t>(image.height()),
                                  static_cast<std::uint32_t>(image.width()));
  if (A == nullptr) return Failed{};
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      double* to = A->data() + y * A->cols;
      for (int x = 0; x < image.width(); ++x) {
        to[x] = image.kind() == PixelKind::kDepth
                    ? image.depth_row(static_cast<int>(y))[x]
                    : image.row(static_cast<int>(y))[x * image.channels() + chosen];
      }
    }
  };
  if (in_blocks(vm, A->rows, static_cast<unsigned>(image.width()), fill)) return A;
  release(vm, A);
  return Failed{};
}

Answer<void> check_size(Vm& vm, const MatrixObj& A) {
  const std::int64_t pixels = std::int64_t{A.rows} * A.cols;
  if (A.rows >= 1 && A.cols >= 1 && A.rows <= Image::kMostSide && A.cols <= Image::kMostSide &&
      pixels <= kMostPixels)
    return {};
  return fail_picture(vm,
                      fmt::format("it would have {} x {} pixels; sides go from 1 to {}, and there "
                                  "are at most {} pixels",
                                  A.cols, A.rows, Image::kMostSide, kMostPixels),
                      CallPart::first());
}

// The elements of a matrix as one channel of a picture, rounded to grey levels.
Answer<void> fill_channel(Vm& vm, const MatrixObj& A, CallPart part, int channel, Image& image) {
  std::size_t bad = count_of(A);
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      std::uint8_t* to = image.row(static_cast<int>(y)) + channel;
      for (std::size_t x = 0; x < A.cols; ++x, to += image.channels()) {
        const double level = std::floor(A.data()[y * A.cols + x] + 0.5);
        if (!(level >= 0.0 && level <= kBrightest)) {
          bad = y * A.cols + x;
          return false;
        }
        *to = static_cast<std::uint8_t>(level);
      }
    }
    return true;
  };
  if (in_blocks(vm, A.rows, 4 * A.cols, fill)) return {};
  if (bad == count_of(A)) return Failed{};
  const double level = A.data()[bad];
  return fail_picture(
      vm,
      fmt::format("element [{}, {}] is {}; grey levels go from 0 to 255", bad / A.cols,
                  bad % A.cols, std::isnan(level) ? std::abs(level) : level),
      part);
}

Answer<Image> from_matrix(Vm& vm, const MatrixObj& A) {
  if (!check_size(vm, A)) return Failed{};
  Image image(static_cast<int>(A.cols), static_cast<int>(A.rows), PixelKind::kGrey);
  if (!fill_channel(vm, A, at("m"), 0, image)) return Failed{};
  return image;
}

Answer<Image> from_channels(Vm& vm, const MatrixObj& red, const MatrixObj& green,
                            const MatrixObj& blue) {
  static constexpr CallPart kNames[] = {at("red"), at("green"), at("blue")};
  const MatrixObj* const parts[] = {&red, &green, &blue};
  if (!check_size(vm, red)) return Failed{};
  Image image(static_cast<int>(red.cols), static_cast<int>(red.rows), PixelKind::kRgb);
  for (int i = 0; i < 3; ++i) {
    if (parts[i]->rows != red.rows || parts[i]->cols != red.cols) {
      return sizes_differ(
          vm, size_text(red.rows, red.cols) + " and " + size_text(parts[i]->rows, parts[i]->cols),
          kNames[i]);
    }
    if (!fill_channel(vm, *parts[i], kNames[i], i, image)) return Failed{};
  }
  return image;
}

Answer<RecordObj*> rgb(Vm& vm, std::int64_t r, std::int64_t g, std::int64_t b) {
  static constexpr CallPart kNames[] = {at("r"), at("g"), at("b")};
  const std::int64_t parts[] = {r, g, b};
  for (int i = 0; i < 3; ++i) {
    if (parts[i] >= 0 && parts[i] <= kBrightest) continue;
    return fail_picture(
        vm, fmt::format("`{}` of a colour is {}; expected 0 to 255", "rgb"[i], parts[i]),
        kNames[i]);
  }
  RecordObj* record = new_record(vm, vm.program().library_record("Color"));
  if (record == nullptr) return Failed{};
  for (int i = 0; i < 3; ++i) record->fields()[i].i = parts[i];
  return record;
}

constexpr NativeFunction kPictureFunctions[] = {
    def<rgb>("rgb(r: int, g: int, b: int) -> Color",
             "A colour from its red, green and blue, 0 to 255 each.", "rgb(255, 128, 0)"),
    def<width>("image.width(img: image) -> int", "How many pixels a row has.",
               "image([0, 255; 255, 0]).width"),
    def<height>("image.height(img: image) -> int", "How many rows there are.",
                "image([0, 255; 255, 0]).height"),
    def<channels>("image.channels(img: image) -> int",
                  "1 of a grey picture or one of depths, 3 of an RGB one.",
                  "image([0, 255; 255, 0]).channels"),
    def<color_at>(
        "image[](img: image, x: int, y: int) -> Color",
        "The pixel in column x, from the left, and row y, from the top, both from 0. Of a "
        "picture that the text shows to be grey it is a whole number from 0 to 255, of "
        "one of depths a length, otherwise a Color { r, g, b }, whose parts are equal in "
        "a grey picture.",
        "image([0, 1;], [0, 2;], [0, 3;])[1, 0].g"),
    def<grey_at>("image.grey[](img: image, x: int, y: int) -> int",
                 "The grey level of a pixel, 0 to 255.", "image([0, 255; 255, 0])[1, 0]"),
    def<depth_at>("image.depths[](img: image, x: int, y: int) -> length",
                  "The depth at a pixel of a picture of depths.",
                  "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, 900mm)); "
                  "size: [64, 48] }; print(eye.captureDepth()[32, 24])"),
    def<store_grey, store_color, store_depth>(
        "image[]=(img: image, x: int, y: int, value: int | Color | length) -> image",
        "Stores a value in a pixel: a grey level, 0 to 255, in a grey picture, a colour in an RGB "
        "picture, a length in a picture of depths.",
        "var img = image([0, 255; 255, 0]); img[0, 1] = 128; var seen = image([0, 1;], [0, 2;], "
        "[0, 3;]); seen[0, 0] = rgb(255, 0, 0)"),
    def<part_of>("image[:](img: image, left: int?, right: int?, top: int?, bottom: int?) -> image",
                 "Cuts out columns left to right and rows top to bottom, both without their ends: "
                 "img[10:20, :] has ten columns.",
                 "image([0, 255; 255, 0])[0:1, :]", {.check = gives_same_kind<"img">}),
    def<difference>("operator-(a: image, b: image) -> image",
                    "The absolute difference, pixel by pixel.",
                    "image([9, 5; 7, 1]) - image([5, 9; 1, 7])", {.check = gives_same_kind<"a">}),
    def<sum>("operator+(a: image, b: image) -> image",
             "The sum, pixel by pixel; brighter than 255 is 255.",
             "image([9, 5; 7, 1]) + image([5, 9; 1, 7])", {.check = gives_same_kind<"a">}),
    def<times>("operator*(img: image, k: double) -> image",
               "Every pixel times a factor from 0 to 1000000, to the nearest grey level; brighter "
               "than 255 is 255.",
               "image([9, 5; 7, 1]) * 0.5", {.check = gives_same_kind<"img">}),
    def<of_times>("operator*(k: double, img: image) -> image", "Every pixel times a factor.",
                  "0.5 * image([9, 5; 7, 1])", {.check = gives_same_kind<"img">}),
    def<gray>("gray(img: image) -> image",
              "The picture in shades of grey: 0.299 r + 0.587 g + 0.114 b, to the nearest level.",
              "gray(image([0, 1;], [0, 2;], [0, 3;]))", {.check = gives_kind<PixelKind::kGrey>}),
    def<over_level>("threshold(img: image, level: int = 128) -> image",
                    "A grey picture in black and white: 255 where it is brighter than level, 0 to "
                    "255, otherwise 0.",
                    "threshold(image([90, 200; 7, 1]), level: 100)",
                    {.check = gives_kind<PixelKind::kGrey>}),
    def<blur>("blur(img: image, sigma: double = 1.0) -> image",
              "Smooths by a Gaussian bell with the standard deviation sigma, 0 to 30 px.",
              "blur(image([0, 0, 255; 0, 0, 255]), sigma: 0.7)", {.check = gives_same_kind<"img">}),
    def<box_blur>(
        "boxBlur(img: image, radius: int = 1) -> image",
        "Each pixel becomes the mean of the square with 2 radius + 1 pixels on each side; "
        "radius: 0 to 100.",
        "boxBlur(image([0, 0, 255; 0, 0, 255]), radius: 2)", {.check = gives_same_kind<"img">}),
    def<noise>("noise(img: image, sigma: double = 5.0, seed: int = 1) -> image",
               "The picture with Gaussian noise of the standard deviation sigma, 0 to 255 grey "
               "levels. The same seed, from 0 on, gives the same noise.",
               "noise(image([90, 90; 90, 90]), sigma: 2.0)", {.check = gives_same_kind<"img">}),
    def<to_matrix>("matrix(img: image, channel: int?) -> matrix",
                   "A matrix with a number for each pixel, row by row: the grey levels, or the "
                   "depths in metres. Of an RGB picture, channel 0, 1 or 2: red, green or blue.",
                   "matrix(image([0, 255; 255, 0]))"),
    def<from_matrix>("image(m: matrix) -> image",
                     "A grey picture from a matrix of grey levels, 0 to 255, row by row.",
                     "image([0, 255; 255, 0])", {.check = gives_kind<PixelKind::kGrey>}),
    def<from_channels>("image(red: matrix, green: matrix, blue: matrix) -> image",
                       "An RGB picture from three matrices of the same size.",
                       "image([0, 1;], [0, 2;], [0, 3;])"),
};

}  // namespace

std::span<const NativeFunction> picture_value_functions() { return kPictureFunctions; }

}  // namespace armlet::bind
