// Sizes of picture files, without decoding them (image/files.hpp does that).
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "armlet/image/image.hpp"

namespace armlet {

// "image/png" or "image/jpeg" by the first bytes; empty for other kinds.
std::string_view image_kind(std::string_view bytes);

// Largest side of a picture that can be shown.
inline constexpr std::size_t kMostPixels = Image::kMostSide;

struct PictureSize {
  std::size_t width = 0;
  std::size_t height = 0;

  [[nodiscard]] bool is_usable() const {
    return width > 0 && height > 0 && width <= kMostPixels && height <= kMostPixels;
  }
};

// The size of a PNG, which is checked to its end, or of a JPEG, which is read up to its size;
// nothing if it is neither, or incomplete.
//
// source  W3C, Portable Network Graphics, 2003, chapters 5 and 11; ITU-T T.81 (JPEG), 1992, annex
//         B.
std::optional<PictureSize> picture_size(std::string_view bytes);

}  // namespace armlet
