// The same pixels with every compiler, optimisation and processor.
#include <doctest/doctest.h>

#include <array>

#include "armlet/camera/renderer.hpp"
#include "armlet/core/hash.hpp"
#include "sample_scenes.hpp"

using namespace armlet;
using namespace armlet::test;

namespace {

void add(const Pictures& pictures, Fnv1a& hash) {
  for (const std::uint8_t byte : pictures.color.bytes()) hash.add_byte(byte);
  for (const float depth : pictures.depth.depths()) hash.add(static_cast<double>(depth));
  for (const std::int32_t body : pictures.bodies) hash.add(body);
}

}  // namespace

// Recorded numbers. A change of them is a change of pictures: look at some before and after.
TEST_CASE("pictures of six scenes have the recorded bits") {
  constexpr std::array<std::uint64_t, 6> kRecorded{13643958098791902806U, 3280747796093200210U,
                                                   14135894286217406218U, 1368603846872634004U,
                                                   7089063553976360619U,  8788477211372732970U};
  const std::vector<Scene> scenes = sample_scenes();
  REQUIRE(scenes.size() == kRecorded.size());
  Renderer renderer;
  Pictures pictures;
  Random random(43);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Fnv1a hash;
    for (int n = 0; n < 10; ++n) {
      Intrinsics camera = intrinsics_from_fov(128, 96, 0.9);
      if (n == 9) camera.distortion = {-0.25, 0.08, 0.001, 0.002, 0.0};
      renderer.render(scenes[i], Pinhole(camera), random_eye(random),
                      {.samples = n % 3 == 2 ? 1 : 4, .depth = true, .bodies = true}, pictures);
      add(pictures, hash);
    }
    CAPTURE(i);
    CHECK(hash.value() == kRecorded[i]);
  }
}
