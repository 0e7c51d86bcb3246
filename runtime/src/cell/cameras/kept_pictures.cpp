#include "armlet/cell/kept_pictures.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace armlet {
namespace {

constexpr int kLongestRun = 256;
constexpr std::size_t kOverhead = 160;  // bytes of a picture in addition to its pixels

// Two hashes of the same words, so that two scenes practically never have the same key.
class KeyMaker {
 public:
  void add(std::uint64_t word) {
    for (std::size_t i = 0; i < key_.size(); ++i) {
      key_[i] = (std::rotl(key_[i], 29) ^ word) * kFactors[i];
      key_[i] ^= key_[i] >> 32U;
    }
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(float number) { add(std::uint64_t{std::bit_cast<std::uint32_t>(number)}); }
  void add(bool truth) { add(std::uint64_t{truth}); }
  void add(int number) { add(static_cast<std::uint64_t>(number)); }
  void add(const LinearRgb& color) {
    add(color.r);
    add(color.g);
    add(color.b);
  }
  void add(const Eigen::Isometry3d& T) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 4; ++j) add(T.matrix()(i, j));
    }
  }
  [[nodiscard]] KeptPictures::Key key() const { return key_; }

 private:
  static constexpr KeptPictures::Key kFactors{0x9E3779B97F4A7C15, 0xD6E8FEB86659FD93};
  KeptPictures::Key key_{0x243F6A8885A308D3, 0x13198A2E03707344};
};

std::vector<std::uint8_t> runs_of(const Image& image) {
  const auto channels = static_cast<std::size_t>(image.channels());
  const std::span<const std::uint8_t> bytes = image.bytes();
  std::vector<std::uint8_t> runs;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::uint8_t* pixel = bytes.data() + at;
    int count = 1;
    at += channels;
    while (count < kLongestRun && at < bytes.size() &&
           std::memcmp(pixel, bytes.data() + at, channels) == 0) {
      ++count;
      at += channels;
    }
    runs.push_back(static_cast<std::uint8_t>(count - 1));
    runs.insert(runs.end(), pixel, pixel + channels);
  }
  return runs;
}

}  // namespace

KeptPictures::Key KeptPictures::key_of(const Scene& scene, const Pinhole& lens,
                                       const Eigen::Isometry3d& T_world_eye, int samples,
                                       double blur) {
  KeyMaker made;
  const Intrinsics& in = lens.intrinsics();
  for (const int each : {in.width, in.height, samples}) made.add(each);
  for (const double each : {in.fx, in.fy, in.cx, in.cy, in.near, in.far, blur}) made.add(each);
  for (const double each : in.distortion) made.add(each);
  made.add(T_world_eye);
  for (const double each : scene.light.towards) made.add(each);
  for (const double each :
       {scene.light.key, scene.light.sky_up, scene.light.sky_down, scene.ground.z})
    made.add(each);
  for (const bool each : {scene.light.shadows, scene.ground.drawn, scene.ground.grid})
    made.add(each);
  for (const LinearRgb& each : {scene.ground.color, scene.ground.line, scene.background})
    made.add(each);
  for (const SceneBody& body : scene.bodies) {
    made.add(body.surface->fingerprint());
    made.add(body.T_world_body);
    made.add(body.casts_shadow);
    for (const Material& material : body.materials) {
      made.add(material.color);
      made.add(material.texture == nullptr ? 0 : material.texture->fingerprint());
    }
  }
  return made.key();
}

Image KeptPictures::find(const Key& key) {
  const auto found = kept_.find(key);
  if (found == kept_.end()) return {};
  const Kept& kept = found->second;
  by_use_.splice(by_use_.end(), by_use_, kept.used);
  Image image(kept.width, kept.height, kept.kind);
  const auto channels = static_cast<std::size_t>(image.channels());
  std::uint8_t* to = image.row(0);
  for (std::size_t at = 0; at < kept.runs.size(); at += 1 + channels) {
    const std::uint8_t* pixel = kept.runs.data() + at + 1;
    for (int i = 0; i <= kept.runs[at]; ++i, to += channels) std::copy_n(pixel, channels, to);
  }
  return image;
}

void KeptPictures::put(const Key& key, const Image& image) {
  if (kept_.contains(key)) return;
  Kept kept{image.width(), image.height(), image.kind(), runs_of(image), {}};
  kept.runs.shrink_to_fit();
  const std::size_t needed = kept.runs.size() + kOverhead;
  if (needed > most_bytes_) return;
  while (bytes_ + needed > most_bytes_) {
    const auto oldest = kept_.find(by_use_.front());
    bytes_ -= oldest->second.runs.size() + kOverhead;
    kept_.erase(oldest);
    by_use_.pop_front();
  }
  kept.used = by_use_.insert(by_use_.end(), key);
  bytes_ += needed;
  kept_.emplace(key, std::move(kept));
}

}  // namespace armlet
