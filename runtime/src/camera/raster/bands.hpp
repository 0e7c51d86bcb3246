#pragma once
// Pictures in bands of a few rows, whose samples fit into the cache. Bands are independent of each
// other.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "camera/raster/shade.hpp"

namespace armlet::raster {

inline constexpr int kBandRows = 16;  // of pixels

// The triangles that intersect each band, in drawing order.
class BandLists {
 public:
  void sort(const std::vector<DrawnTriangle>& triangles, const Window& window);
  [[nodiscard]] int bands() const { return bands_; }
  // Calls visit(triangle number) for each triangle of a band.
  template <class Visit>
  void for_each(int band, Visit&& visit) const {
    const auto at = static_cast<std::size_t>(band);
    for (std::uint32_t i = starts_[at]; i < starts_[at + 1]; ++i) visit(items_[i]);
  }

 private:
  struct Rows {
    int first, last;
  };
  [[nodiscard]] Rows bands_of(const DrawnTriangle& triangle) const;

  Window window_;
  int bands_ = 0;
  std::vector<std::uint32_t> starts_, items_, next_;
};

// The samples of a band: the nearest triangle at each.
class Band {
 public:
  // Clears the samples to the ground and the background and draws the triangles of the band.
  void draw(int band, const BandLists& lists, const std::vector<DrawnTriangle>& triangles,
            const Window& window, int samples, const GroundView& ground, double far);

  [[nodiscard]] int first_row() const { return first_row_; }  // of pixels, relative to the window
  [[nodiscard]] int pixel_rows() const { return pixel_rows_; }
  [[nodiscard]] const SampleGrid& grid() const { return grid_; }
  // A row of samples, counted from the first one of the band.
  [[nodiscard]] const std::int32_t* numbers(int row) const {
    return rows_.number.data() + static_cast<std::size_t>(row) * rows_.stride;
  }
  [[nodiscard]] const float* nearness(int row) const {
    return rows_.nearness.data() + static_cast<std::size_t>(row) * rows_.stride;
  }

 private:
  void clear(int begin, int end, const GroundView& ground, double far);

  SampleGrid grid_;
  SampleRows rows_;
  int first_row_ = 0;
  int pixel_rows_ = 0;
};

}  // namespace armlet::raster
