#pragma once
// A store of pictures that cameras have drawn, used when the same run is repeated.

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"
#include "armlet/image/image.hpp"

namespace armlet {

// Colour pictures, found by a key that contains everything that determines their pixels. When the
// store exceeds its size, the pictures that were used least recently are removed. Runs of equal
// pixels are stored once, which compresses a picture to a fraction of its size.
//
// Not thread-safe.
class KeptPictures {
 public:
  using Key = std::array<std::uint64_t, 2>;

  explicit KeptPictures(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  // samples, blur  as those of a Camera.
  [[nodiscard]] static Key key_of(const Scene& scene, const Pinhole& lens,
                                  const Eigen::Isometry3d& T_world_eye, int samples, double blur);

  // An empty picture if it is not in the store.
  [[nodiscard]] Image find(const Key& key);
  // image  grey or RGB; a picture larger than the whole store is not kept.
  void put(const Key& key, const Image& image);

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return kept_.size(); }

 private:
  struct Kept {
    int width = 0;
    int height = 0;
    PixelKind kind = PixelKind::kRgb;
    std::vector<std::uint8_t> runs;  // of a pixel: repetitions less one, and its channels
    std::list<Key>::iterator used;
  };
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::map<Key, Kept> kept_;
  std::list<Key> by_use_;  // the oldest first
};

}  // namespace armlet
