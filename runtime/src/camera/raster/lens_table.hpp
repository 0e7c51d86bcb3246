#pragma once
// Pictures of a camera with distortion from those of one without.

#include <vector>

#include "armlet/camera/renderer.hpp"

namespace armlet::raster {

// Resizes the requested pictures; those that have the size are kept.
void fit(Pictures& pictures, int width, int height, const PictureOptions& options);

// Maps every pixel of a camera with distortion to a pixel of a camera without it, whose picture is
// as large as needed.
class LensTable {
 public:
  // Computed again only if the intrinsics changed.
  //
  // throws  ArgumentError if the picture without distortion has a side above Image::kMostSide.
  void prepare(const Pinhole& camera);

  [[nodiscard]] const Intrinsics& wide() const { return wide_; }
  void resample(const Pictures& wide, const PictureOptions& options, Pictures& out) const;

 private:
  struct Place {
    float x, y;  // x < 0: the pixel has no ray
  };
  void color_row(const Image& wide, int y, std::uint8_t* out) const;

  Intrinsics camera_{.width = 0};
  Intrinsics wide_;
  std::vector<Place> places_;
};

}  // namespace armlet::raster
