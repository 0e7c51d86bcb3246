// Pictures and corners on one processor: our pictures, with light and one hard shadow, compared
// with Embree's primary rays through the same samples of the same scene, which find only the body
// at each sample; SUSAN with and without wide registers, compared with corners by OpenCV. Both find
// the same bodies, which is checked.
#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "armlet/camera/renderer.hpp"
#include "armlet/image/arithmetic.hpp"
#include "armlet/vision/harris.hpp"
#include "armlet/vision/susan.hpp"
#include "bench.hpp"
#include "embree_scene.hpp"

namespace armlet::bench {
namespace {

constexpr int kWidth = 640, kHeight = 480;

// A sphere of 2 * bands * (bands - 1) * 2 triangles.
std::shared_ptr<const Surface> ball(double radius, int bands) {
  SurfaceParts parts;
  const int sectors = 2 * bands;
  const auto at = [&](double down, double around) {
    return Eigen::Vector3d(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around),
                           std::cos(down));
  };
  for (int i = 0; i <= bands; ++i) {
    for (int k = 0; k <= sectors; ++k) {
      const Eigen::Vector3d n =
          at(std::numbers::pi * i / bands, 2.0 * std::numbers::pi * k / sectors);
      parts.positions.push_back(radius * n);
      parts.normals.push_back(n.cast<float>());
    }
  }
  const auto number = [&](int i, int k) {
    return static_cast<std::uint32_t>(i * (sectors + 1) + k);
  };
  for (int i = 0; i < bands; ++i) {
    for (int k = 0; k < sectors; ++k) {
      if (i > 0) parts.corners.push_back({number(i, k), number(i + 1, k), number(i, k + 1)});
      if (i + 1 < bands)
        parts.corners.push_back({number(i, k + 1), number(i + 1, k), number(i + 1, k + 1)});
    }
  }
  return std::make_shared<const Surface>(std::move(parts));
}

// Eight spheres above the ground, about 20,000 triangles together.
Scene balls() {
  Scene scene;
  const auto surface = ball(0.12, 25);
  for (int i = 0; i < 8; ++i) {
    SceneBody body{.name = "ball", .surface = surface};
    body.T_world_body.translation() << 0.2 + 0.16 * (i % 3), -0.3 + 0.09 * i, 0.1 + 0.03 * i;
    body.materials = {Material{{0.15F + 0.1F * static_cast<float>(i), 0.4F, 0.6F}}};
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

// A chessboard in perspective, for corner detectors.
cv::Mat board() {
  cv::Mat flat(kHeight, kWidth, CV_8U), picture;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      flat.at<std::uint8_t>(y, x) = (x / 40 + y / 40) % 2 == 0 ? 50 : 200;
  const cv::Matx33d warp(0.8, 0.15, 40.0, -0.1, 0.85, 60.0, 0.0001, 0.0003, 1.0);
  cv::warpPerspective(flat, picture, warp, picture.size(), cv::INTER_LINEAR, cv::BORDER_CONSTANT,
                      cv::Scalar(120));
  return picture;
}

Image image_of(const cv::Mat& grey) {
  Image image(grey.cols, grey.rows, PixelKind::kGrey);
  for (int y = 0; y < grey.rows; ++y)
    std::copy_n(grey.ptr<std::uint8_t>(y), grey.cols, image.row(y));
  return image;
}

// Compares our pixels of bodies with Embree's; they may differ at outlines.
void check_same(const Pictures& pictures, const EmbreeScene& peer, int samples) {
  const auto ours = std::ranges::count_if(pictures.bodies, [](int body) { return body >= 0; });
  const double theirs = static_cast<double>(peer.samples_on_bodies()) / samples;
  if (std::abs(static_cast<double>(ours) - theirs) <= 0.005 * theirs) return;
  std::fprintf(stderr, "Bodies cover %td pixels here and %.0f by rays.\n", ours, theirs);
  std::exit(1);
}

void print_milliseconds(const char* what, const char* peer, const Times& times,
                        const char* target = "") {
  std::printf("%-34s %8.2f ms   %-24s %8.2f ms %7.2fx  %s\n", what, times.ours * 1e-6, peer,
              times.theirs * 1e-6, times.theirs / times.ours, target);
}

void time_pictures() {
  const Scene scene = balls();
  const Pinhole camera(intrinsics_from_fov(kWidth, kHeight, 55.0 * std::numbers::pi / 180.0));
  const Eigen::Isometry3d T_world_eye = looking_at({0.4, 0.0, 0.15}, {1.3, -0.5, 0.8});
  Renderer renderer;
  EmbreeScene peer(scene, camera, T_world_eye);
  std::printf("%d triangles, %d x %d\n", peer.triangle_count(), kWidth, kHeight);
  for (const int samples : {4, 1}) {
    PictureOptions options{.samples = samples};
    Pictures pictures;
    options.bodies = true;
    renderer.render(scene, camera, T_world_eye, options, pictures);
    peer.trace(samples);
    check_same(pictures, peer, samples);
    options.bodies = false;
    const Times times = compare(
        Calls(4),
        [&](int) {
          renderer.render(scene, camera, T_world_eye, options, pictures);
          return static_cast<double>(pictures.color.row(0)[0]);
        },
        [&](int) {
          peer.trace(samples);
          return static_cast<double>(peer.samples_on_bodies());
        });
    print_milliseconds(samples == 4 ? "picture, 4 samples" : "picture, 1 sample", "rays of Embree",
                       times, samples == 4 ? "(target: 32 ms, 1x)" : "");
  }
}

void time_corners() {
  const cv::Mat grey = board();
  const Image image = image_of(grey);
  const auto susan = [&](InstructionSet set) {
    return [&image, set](int) {
      return static_cast<double>(susan_corners(image, {.set = set}).size());
    };
  };
  print_milliseconds(
      "SUSAN", "SUSAN, narrow registers",
      compare(Calls(10), susan(best_instruction_set()), susan(InstructionSet::kBaseline)),
      "(target: 2x)");
  const auto fast = [&](int) {
    std::vector<cv::KeyPoint> found;
    cv::FAST(grey, found, 20);
    return static_cast<double>(found.size());
  };
  print_milliseconds("SUSAN", "FAST of OpenCV",
                     compare(Calls(10), susan(best_instruction_set()), fast));
  const auto ours = [&](int) { return static_cast<double>(harris_corners(image).size()); };
  const auto theirs = [&](int) {
    std::vector<cv::Point2f> found;
    cv::goodFeaturesToTrack(grey, found, 0, 0.01, 10.0, cv::noArray(), 3, true, 0.04);
    return static_cast<double>(found.size());
  };
  print_milliseconds("Harris", "Harris of OpenCV", compare(Calls(10), ours, theirs));
}

}  // namespace
}  // namespace armlet::bench

int main() {
  cv::setNumThreads(1);
  armlet::bench::time_pictures();
  armlet::bench::time_corners();
}
