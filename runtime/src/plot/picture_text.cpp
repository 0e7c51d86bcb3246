#include "picture_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "armlet/image/arithmetic.hpp"
#include "armlet/image/shown.hpp"
#include "dot_character.hpp"

namespace armlet {
namespace {

// ---- dots -------------------------------------------------------------------------------------

// 1 for each dot: their density corresponds to the brightness. The error of each dot is distributed
// to its neighbours (R. Floyd and L. Steinberg, 1976).
std::vector<std::uint8_t> dots_of(const Image& grey) {
  const int width = grey.width();
  std::vector<int> now(static_cast<std::size_t>(width) + 2, 0), next(now);  // 1/16 grey levels
  std::vector<std::uint8_t> dots;
  for (int y = 0; y < grey.height(); ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = static_cast<std::size_t>(x) + 1;
      const int level = 16 * grey.row(y)[x] + now[at];
      const bool is_set = level >= 16 * 128;
      dots.push_back(is_set ? 1 : 0);
      const int error = level - (is_set ? 16 * 255 : 0);
      now[at + 1] += error * 7 / 16;
      next[at - 1] += error * 3 / 16;
      next[at] += error * 5 / 16;
      next[at + 1] += error / 16;
    }
    now.swap(next);
    std::fill(next.begin(), next.end(), 0);
  }
  return dots;
}

std::vector<std::string> dotted_rows(const Image& image, int columns, int rows) {
  const std::vector<std::uint8_t> dots = dots_of(resized(to_grey(image), 2 * columns, 4 * rows));
  std::vector<std::string> out;
  for (int r = 0; r < rows; ++r) {
    std::string& row = out.emplace_back();
    for (int c = 0; c < columns; ++c) {
      unsigned bits = 0;
      for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 2; ++x) {
          const int at = (4 * r + y) * 2 * columns + 2 * c + x;
          if (dots[static_cast<std::size_t>(at)] != 0) bits |= kDotBits[y][x];
        }
      }
      append_dots(row, bits);
    }
  }
  return out;
}

// ---- colours ----------------------------------------------------------------------------------

using Rgb = std::array<int, 3>;

// The nearest of the 256 colours of xterm: a cube of 6 x 6 x 6, or 24 greys.
int color_number(const Rgb& rgb) {
  constexpr int kLevels[6] = {0, 95, 135, 175, 215, 255};
  const auto distance = [&rgb](const Rgb& other) {
    int sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (rgb[k] - other[k]) * (rgb[k] - other[k]);
    return sum;
  };
  int number = 16;
  Rgb cube{};
  for (std::size_t k = 0; k < 3; ++k) {
    int nearest = 0;
    for (int i = 1; i < 6; ++i)
      if (std::abs(kLevels[i] - rgb[k]) < std::abs(kLevels[nearest] - rgb[k])) nearest = i;
    cube[k] = kLevels[nearest];
    number += nearest * (k == 0 ? 36 : k == 1 ? 6 : 1);
  }
  const int step = std::clamp(((rgb[0] + rgb[1] + rgb[2]) / 3 - 3) / 10, 0, 23);
  const int level = 8 + 10 * step;
  return distance({level, level, level}) < distance(cube) ? 232 + step : number;
}

int color_at(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.row(y) + x * image.channels();
  return image.channels() == 3 ? color_number({pixel[0], pixel[1], pixel[2]})
                               : color_number({pixel[0], pixel[0], pixel[0]});
}

// The upper half of a character has the foreground colour, the lower one the background colour.
std::vector<std::string> colored_rows(const Image& image, int columns, int rows) {
  const Image pixels = resized(image, columns, 2 * rows);
  std::vector<std::string> out;
  for (int r = 0; r < rows; ++r) {
    std::string& row = out.emplace_back();
    int upper = -1, lower = -1;
    for (int c = 0; c < columns; ++c) {
      const int above = color_at(pixels, c, 2 * r), below = color_at(pixels, c, 2 * r + 1);
      if (above != upper || below != lower)
        row += fmt::format("\x1b[38;5;{};48;5;{}m", above, below);
      upper = above;
      lower = below;
      row += "\u2580";
    }
    row += "\x1b[0m";
  }
  return out;
}

}  // namespace

std::string picture_text(const Figure& figure, int columns, int rows, bool color) {
  const Image& image = *figure.picture;
  const double scale = std::min(static_cast<double>(columns) / image.width(),
                                2.0 * static_cast<double>(rows) / image.height());
  const auto characters = [scale](int pixels, double each, int most) {
    return std::clamp(static_cast<int>(std::lround(scale * pixels / each)), 1, most);
  };
  const int width = characters(image.width(), 1.0, columns);
  const int height = characters(image.height(), 2.0, rows);
  std::string edge;
  for (int c = 0; c < width; ++c) edge += "\u2500";
  std::string out = figure.title.empty() ? std::string() : figure.title + '\n';
  out += "\u250c" + edge + "\u2510\n";
  for (const std::string& row :
       color ? colored_rows(image, width, height) : dotted_rows(image, width, height))
    out += "\u2502" + row + "\u2502\n";
  out += "\u2514" + edge + "\u2518\n";
  return figure.note.empty() ? out : out + figure.note + '\n';
}

}  // namespace armlet
