// Files of pictures that are looked at no further than their sizes. Reading them is
// image/files.hpp.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "armlet/image/image.hpp"

namespace armlet {

// "image/png" or "image/jpeg" by the first bytes; empty for other kinds.
std::string_view image_kind(std::string_view bytes);

// Of a picture that can be shown, in each direction.
inline constexpr std::size_t kMostPixels = Image::kMostSide;

struct PictureSize {
  std::size_t width = 0;
  std::size_t height = 0;

  [[nodiscard]] bool is_usable() const {
    return width > 0 && height > 0 && width <= kMostPixels && height <= kMostPixels;
  }
};

// Of a PNG, which is looked at to its end, or a JPEG, up to where it says how large it is; nothing
// if it is neither, or not whole.
//
// source  W3C, Portable Network Graphics, 2003, chapters 5 and 11; ITU-T T.81 (JPEG), 1992, annex
//         B.
std::optional<PictureSize> picture_size(std::string_view bytes);

}  // namespace armlet
