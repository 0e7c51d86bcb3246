#include "armlet/camera/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "camera/raster/bands.hpp"
#include "camera/raster/lens_table.hpp"

namespace armlet {

using namespace raster;  // NOLINT: this file is where the parts are put together

class Renderer::Frame {
 public:
  void render(const Scene& scene, const Pinhole& camera, const Eigen::Isometry3d& T_world_eye,
              const PictureOptions& options, Pictures& out) {
    if (!camera.intrinsics().is_distorted()) {
      render_plain(scene, View(camera.intrinsics(), T_world_eye), options, out);
      return;
    }
    lens_.prepare(camera);
    render_plain(scene, View(lens_.wide(), T_world_eye), options, wide_);
    lens_.resample(wide_, options, out);
  }

  double visible_share(const Scene& scene, const Intrinsics& intrinsics,
                       const Eigen::Isometry3d& T_world_eye, int body) {
    const View view(intrinsics, T_world_eye);
    const int width = intrinsics.width, height = intrinsics.height;
    const std::int64_t whole =
        count(scene, view, {-width, -height, 3 * width, 3 * height}, body, true);
    if (whole == 0) return 0.0;
    const std::int64_t seen = count(scene, view, {0, 0, width, height}, body, false);
    return static_cast<double>(seen) / static_cast<double>(whole);
  }

 private:
  void set_up(const Scene& scene, const View& view, const Window& window, int only) {
    const Lighting lighting(scene.light);
    const LightFrame light(lighting.towards);
    triangles_.clear();
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const auto number = static_cast<std::int32_t>(i);
      constexpr std::uint64_t kTriangle = 300;  // operations
      checkpoint(kTriangle * scene.bodies[i].surface->parts().corners.size());
      if (only < 0 || only == number)
        triangles_.add(scene.bodies[i], number, view, window, lighting, light);
    }
    lists_.sort(triangles_.drawn, window);
  }

  void render_plain(const Scene& scene, const View& view, const PictureOptions& options,
                    Pictures& out) {
    const Intrinsics& camera = view.camera;
    const Window window{0, 0, camera.width, camera.height};
    set_up(scene, view, window, -1);
    const GroundView ground(scene.ground, view);
    fit(out, window.width, window.height, options);
    const bool has_centres = options.depth || options.bodies;
    const int samples = options.samples;
    if (options.color) {
      const Lighting lighting(scene.light);
      shadows_.clear();
      if (scene.light.shadows && scene.light.key > 0.0)
        shadows_.draw(scene, view, LightFrame(lighting.towards));
      const Shader shader(scene, view, triangles_, shadows_, ground, lighting);
      for (int band = 0; band < lists_.bands(); ++band) {
        band_.draw(band, lists_, triangles_.drawn, window, samples, ground, camera.far);
        count_band(window, samples);
        color_band(shader, out.color);
        if (samples == 1 && has_centres) centre_band(ground, options, out);
      }
      if (samples == 1) return;
    }
    if (!has_centres) return;
    for (int band = 0; band < lists_.bands(); ++band) {
      band_.draw(band, lists_, triangles_.drawn, window, 1, ground, camera.far);
      count_band(window, 1);
      centre_band(ground, options, out);
    }
  }

  // Reports the work of a band at a checkpoint.
  void count_band(const Window& window, int samples) const {
    constexpr std::uint64_t kSample = 20;  // operations
    checkpoint(kSample * static_cast<std::uint64_t>(window.width * band_.pixel_rows() * samples));
  }

  void color_band(const Shader& shader, Image& color) const {
    const bool is_fine = band_.grid().step != kOne;
    for (int row = 0; row < band_.pixel_rows(); ++row) {
      const int y = band_.first_row() + row;
      if (is_fine) {
        fine_row(shader, band_.numbers(2 * row), band_.numbers(2 * row + 1), y, color);
      } else {
        plain_row(shader, band_.numbers(row), y, color);
      }
    }
  }

  static void plain_row(const Shader& shader, const std::int32_t* number, int y, Image& color) {
    std::uint8_t* out = color.row(y);
    for (int x = 0; x < color.width();) {
      int end = x + 1;
      while (end < color.width() && number[end] == number[x]) ++end;
      shader.shade(number[x], {static_cast<double>(x), static_cast<double>(y), end - x},
                   out + 3 * x);
      x = end;
    }
  }

  // Pixels with four equal samples are computed once, in their centres.
  static void fine_row(const Shader& shader, const std::int32_t* above, const std::int32_t* below,
                       int y, Image& color) {
    std::uint8_t* out = color.row(y);
    const auto shows_only = [&](int x, std::int32_t number) {
      return above[2 * x] == number && above[2 * x + 1] == number && below[2 * x] == number &&
             below[2 * x + 1] == number;
    };
    for (int x = 0; x < color.width();) {
      const std::int32_t number = above[2 * x];
      if (!shows_only(x, number) || shader.is_pictured(number)) {
        mixed_pixel(shader, above + 2 * x, below + 2 * x, x, y, out + 3 * x);
        ++x;
        continue;
      }
      int end = x + 1;
      while (end < color.width() && shows_only(end, number)) ++end;
      shader.shade(number, {static_cast<double>(x), static_cast<double>(y), end - x}, out + 3 * x);
      x = end;
    }
  }

  // The mean of bytes, not of light: a pixel half covered by each of two colours gets the byte in
  // the middle, so edge detectors find the edge without an offset.
  static void mixed_pixel(const Shader& shader, const std::int32_t* above,
                          const std::int32_t* below, int x, int y, std::uint8_t* out) {
    std::array<int, 3> sum{2, 2, 2};
    for (int i = 0; i < 4; ++i) {
      const std::int32_t number = (i < 2 ? above : below)[i % 2];
      std::array<std::uint8_t, 3> rgb;
      shader.shade(number, {x - 0.25 + 0.5 * (i % 2), y - 0.25 + 0.5 * (i / 2), 1}, rgb.data());
      for (std::size_t c = 0; c < 3; ++c) sum[c] += rgb[c];
    }
    for (std::size_t c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(sum[c] / 4);
  }

  void centre_band(const GroundView& ground, const PictureOptions& options, Pictures& out) const {
    const int width = band_.grid().columns;
    for (int row = 0; row < band_.pixel_rows(); ++row) {
      const int y = band_.first_row() + row;
      const std::int32_t* number = band_.numbers(row);
      const float* nearness = band_.nearness(row);
      float* depth = options.depth ? out.depth.depth_row(y) : nullptr;
      std::int32_t* body = options.bodies ? out.bodies.data() + static_cast<std::size_t>(y) *
                                                                    static_cast<std::size_t>(width)
                                          : nullptr;
      for (int x = 0; x < width; ++x) {
        if (depth != nullptr) depth[x] = depth_of(number[x], nearness[x], x, y, ground);
        if (body != nullptr)
          body[x] = number[x] >= 0 ? triangles_.looks[static_cast<std::size_t>(number[x])].body
                                   : number[x];
      }
    }
  }

  static float depth_of(std::int32_t number, float nearness, int x, int y,
                        const GroundView& ground) {
    if (number == kBackground) return 0.0F;
    if (number == kGroundNumber) return static_cast<float>(1.0 / ground.nearness.at(x, y));
    return 1.0F / nearness;
  }

  // Number of pixels of a window in whose centres a body is visible: alone, or among the others.
  std::int64_t count(const Scene& scene, const View& view, const Window& window, int body,
                     bool alone) {
    set_up(scene, view, window, alone ? body : -1);
    const GroundView ground = alone ? GroundView() : GroundView(scene.ground, view);
    std::int64_t pixels = 0;
    for (int band = 0; band < lists_.bands(); ++band) {
      band_.draw(band, lists_, triangles_.drawn, window, 1, ground, view.camera.far);
      count_band(window, 1);
      for (int row = 0; row < band_.pixel_rows(); ++row) {
        const std::int32_t* number = band_.numbers(row);
        for (int x = 0; x < window.width; ++x) {
          if (number[x] >= 0 && triangles_.looks[static_cast<std::size_t>(number[x])].body == body)
            ++pixels;
        }
      }
    }
    return pixels;
  }

  SceneTriangles triangles_;
  BandLists lists_;
  Band band_;
  ShadowMap shadows_;
  LensTable lens_;
  Pictures wide_;
};

static_assert(kBackground == kNoBody && kGroundNumber == kGroundBody);

Renderer::Renderer() : frame_(std::make_unique<Frame>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::render(const Scene& scene, const Pinhole& camera,
                      const Eigen::Isometry3d& T_world_eye, const PictureOptions& options,
                      Pictures& pictures) {
  check_scene(scene);
  check_pose("camera", T_world_eye);
  if (options.samples != 1 && options.samples != 4) {
    throw ArgumentError(fmt::format("A pixel has 1 or 4 samples, not {}.", options.samples));
  }
  frame_->render(scene, camera, T_world_eye, options, pictures);
}

double Renderer::visible_share(const Scene& scene, const Pinhole& camera,
                               const Eigen::Isometry3d& T_world_eye, int body) {
  check_scene(scene);
  check_pose("camera", T_world_eye);
  check_body(scene, body);
  return frame_->visible_share(scene, camera.intrinsics(), T_world_eye, body);
}

}  // namespace armlet
