#pragma once
// Pictures that cameras have drawn, kept for whoever takes the same run again.

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

// Coloured pictures by everything that decides on their pixels. Of more bytes than there may be,
// those go first that nobody has asked for the longest time. Equal pixels side by side are kept
// once, so that a picture takes a part of its size.
//
// To be used by one thread at a time.
class KeptPictures {
 public:
  using Key = std::array<std::uint64_t, 2>;

  explicit KeptPictures(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  // samples, blur  as those of a Camera.
  [[nodiscard]] static Key key_of(const Scene& scene, const Pinhole& lens,
                                  const Eigen::Isometry3d& T_world_eye, int samples, double blur);

  // An empty picture: it is not kept.
  [[nodiscard]] Image find(const Key& key);
  // image  grey or RGB; one that is too large alone is not kept.
  void put(const Key& key, const Image& image);

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t count() const { return kept_.size(); }

 private:
  struct Kept {
    int width = 0;
    int height = 0;
    PixelKind kind = PixelKind::kRgb;
    std::vector<std::uint8_t> runs;  // of a pixel: how often less one, and its channels
    std::list<Key>::iterator used;
  };
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::map<Key, Kept> kept_;
  std::list<Key> by_use_;  // the oldest first
};

}  // namespace armlet
