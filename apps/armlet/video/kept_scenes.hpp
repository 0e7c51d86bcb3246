#pragma once
// The scenes of a cell at the instants of a run, for the pictures of a video.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "armlet/camera/scene.hpp"

namespace armlet::cli {

// Scenes of one cell, which differ in their bodies and in the height of the ground. A body that
// stays as it is takes four bytes in each scene, and a scene that is as the one before nothing.
class KeptScenes {
 public:
  void add(const Scene& scene);

  [[nodiscard]] std::size_t size() const { return scenes_.size(); }
  // Whether a scene is the same as the one before it, if there is one.
  [[nodiscard]] bool is_as_before(std::size_t i) const {
    return i > 0 && scenes_[i] == scenes_[i - 1];
  }
  [[nodiscard]] Scene at(std::size_t i) const;

 private:
  struct Kept {
    std::vector<std::uint32_t> bodies;  // numbers
    double ground_z = 0.0;
    bool operator==(const Kept&) const = default;
  };
  std::uint32_t number_of(const SceneBody& body);

  std::vector<SceneBody> bodies_;
  std::map<std::string, std::uint32_t, std::less<>> last_;  // body with a name that was kept last
  std::vector<Kept> kept_;
  std::vector<std::uint32_t> scenes_;  // which of the kept ones each is
  Scene around_;                       // light, ground and background, without bodies
};

}  // namespace armlet::cli
