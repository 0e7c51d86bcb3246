#include "armlet/camera/renderer.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "ray_caster.hpp"
#include "refusal_of.hpp"
#include "sample_scenes.hpp"

using namespace armlet;
using namespace armlet::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Pinhole kLarge(intrinsics_from_fov(640, 480, 0.9));
const Pinhole kSmall(intrinsics_from_fov(96, 72, 0.9));

// What a ray through a pixel meets; nothing if rays beside it meet something else.
std::optional<Met> met_at(const Scene& scene, const Pinhole& camera, const Eigen::Isometry3d& T,
                          double u, double v, double beside) {
  const auto through = [&](double du, double dv) {
    return cast(scene, T.translation(), T.linear() * camera.ray({u + du, v + dv}).value(),
                camera.intrinsics().near);
  };
  const Met met = through(0.0, 0.0);
  for (const double d : {-beside, beside}) {
    if (!(through(d, 0.0) == met) || !(through(0.0, d) == met)) return std::nullopt;
  }
  return met;
}

// Light of a point: 1, or 0 in the shadow; nothing next to the border of a shadow.
std::optional<double> light_at(const Scene& scene, const Vector3d& p, const Vector3d& n,
                               double beside) {
  const Vector3d l = scene.light.towards.normalized();
  if (n.dot(l) <= 0.05) return std::nullopt;
  const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  const auto is_lit = [&](double x, double y) {
    return cast(scene, p + x * u + y * v + 1e-6 * n, l, 1e-9, true).body == -1;
  };
  const bool lit = is_lit(0.0, 0.0);
  for (int k = 0; k < 16; ++k) {
    const double angle = k * 0.3926990816987241;
    if (is_lit(beside * std::cos(angle), beside * std::sin(angle)) != lit) return std::nullopt;
    if (is_lit(0.5 * beside * std::cos(angle), 0.5 * beside * std::sin(angle)) != lit)
      return std::nullopt;
  }
  return lit ? 1.0 : 0.0;
}

double encoded(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
}

}  // namespace

TEST_CASE("pixels show the body that a ray meets there, at its depth") {
  Random random(9);
  Renderer renderer;
  int compared = 0;
  for (const Scene& scene : {boxes(), shapes(), balls(6), hall()}) {
    for (int n = 0; n < 2; ++n) {
      const Eigen::Isometry3d T = random_eye(random);
      Pictures pictures;
      renderer.render(scene, kSmall, T, {.color = false, .depth = true, .bodies = true}, pictures);
      for (int y = 1; y < 72; y += 3) {
        for (int x = 1; x < 96; x += 3) {
          const std::optional<Met> met = met_at(scene, kSmall, T, x, y, 0.02);
          if (!met) continue;
          ++compared;
          const bool beyond = met->t > kSmall.intrinsics().far;  // rays have z = 1
          const int body = beyond ? kNoBody : met->body;
          REQUIRE(pictures.bodies[static_cast<std::size_t>(96 * y + x)] == body);
          const float depth = pictures.depth.depth_row(y)[x];
          // Corners are rounded to 1/512 pixel, which does not move the planes: only floats round.
          REQUIRE(depth == doctest::Approx(body == kNoBody ? 0.0 : met->t).epsilon(1e-6));
        }
      }
    }
  }
  CHECK(compared > 4000);
}

TEST_CASE("flat faces have the colour of their light, shadows included") {
  Random random(10);
  Renderer renderer;
  int lit = 0, dark = 0;
  Scene scene = boxes();
  scene.ground.grid = false;
  const Vector3d l = scene.light.towards.normalized();
  for (int n = 0; n < 6; ++n) {
    const Eigen::Isometry3d T = random_eye(random);
    Pictures pictures;
    renderer.render(scene, kLarge, T, {.samples = n % 2 == 0 ? 1 : 4}, pictures);
    for (int y = 10; y < 480; y += 20) {
      for (int x = 10; x < 640; x += 20) {
        const std::optional<Met> met = met_at(scene, kLarge, T, x, y, 0.6);
        if (!met || met->body == -1 || met->t > 5.0) continue;
        const Vector3d p = T * (met->t * kLarge.ray({x, y}).value());
        const double facing = met->n.dot(l);
        // A square of the map of shadows is 1 to 2 mm long here; two of them count as the border.
        const std::optional<double> share =
            facing <= 0.0 ? std::optional(0.0) : light_at(scene, p, met->n, 0.006);
        if (!share) continue;
        (*share > 0.0 ? lit : dark) += 1;
        const LinearRgb color =
            met->body == kGroundBody
                ? scene.ground.color
                : scene.bodies[static_cast<std::size_t>(met->body)].materials[0].color;
        const double sky = 0.5 * (scene.light.sky_up + scene.light.sky_down) +
                           0.5 * (scene.light.sky_up - scene.light.sky_down) * met->n.z();
        const double light = sky + scene.light.key * std::max(0.0, facing) * *share;
        const std::uint8_t* rgb = pictures.color.row(y) + 3 * x;
        REQUIRE(std::abs(rgb[0] - encoded(color.r * light)) <= 4.0);
        REQUIRE(std::abs(rgb[1] - encoded(color.g * light)) <= 4.0);
        REQUIRE(std::abs(rgb[2] - encoded(color.b * light)) <= 4.0);
      }
    }
  }
  CHECK(lit > 500);
  CHECK(dark > 100);
}

TEST_CASE("with four samples a sheet covers its area, about its centre") {
  Random random(11);
  Renderer renderer;
  const Pinhole camera(intrinsics_from_fov(160, 120, 0.9));
  double squares = 0.0;
  for (int n = 0; n < 20; ++n) {
    Scene scene;
    scene.light = Light::flat();
    scene.ground.drawn = false;
    scene.background = {1.0F, 1.0F, 1.0F};
    scene.bodies.push_back(
        body_of("sheet", Plane{{0.2, 0.2}}, at(0.4, 0.0, 0.1, random.uniform(0.0, 3.0)), {}));
    const Vector3d from{0.4 + random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.6};
    const Eigen::Isometry3d T = looking_at({0.4, 0.0, 0.1}, from);
    Pictures pictures;
    renderer.render(scene, camera, T, {}, pictures);
    double area = 0.0;
    Vector2d moment(0.0, 0.0);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 160; ++x) {
        const double share = 1.0 - pictures.color.row(y)[3 * x] / 255.0;
        area += share;
        moment += share * Vector2d(x, y);
      }
    }
    std::vector<Vector2d> corners;
    for (const Vector3d& p : scene.bodies[0].surface->parts().features)
      corners.push_back(camera.project(T.inverse() * (scene.bodies[0].T_world_body * p)).value());
    double doubled = 0.0;
    Vector2d centre(0.0, 0.0);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector2d &a = corners[k], &b = corners[(k + 1) % 4];
      const double cross = a.x() * b.y() - a.y() * b.x();
      doubled += cross;
      centre += cross * (a + b) / 3.0;
    }
    CHECK(area == doctest::Approx(std::abs(0.5 * doubled)).epsilon(0.01));
    squares += (moment / area - centre / doubled).squaredNorm();
  }
  // An edge along a row of samples, half a pixel apart, is off by up to a quarter; others by less.
  CHECK(std::sqrt(squares / 20.0) < 0.05);
}

TEST_CASE("pixels of a camera with distortion show what lies at their rays") {
  Random random(12);
  Renderer renderer;
  Intrinsics i = intrinsics_from_fov(96, 72, 1.0);
  i.distortion = {-0.3, 0.1, 0.002, -0.001, 0.0};
  const Pinhole camera(i);
  int compared = 0;
  for (int n = 0; n < 3; ++n) {
    const Scene scene = boxes();
    const Eigen::Isometry3d T = random_eye(random);
    Pictures pictures;
    renderer.render(scene, camera, T, {.depth = true, .bodies = true}, pictures);
    CHECK(pictures.color.width() == 96);
    for (int y = 0; y < 72; y += 3) {
      for (int x = 0; x < 96; x += 3) {
        const std::optional<Met> met = met_at(scene, camera, T, x, y, 0.8);
        if (!met || met->t > 19.0) continue;
        ++compared;
        REQUIRE(pictures.bodies[static_cast<std::size_t>(96 * y + x)] == met->body);
      }
    }
  }
  CHECK(compared > 1000);
  i.distortion = {-0.45, 0.0, 0.0, 0.0, 0.0};
  Pictures pictures;  // its corners see nothing
  i.fx = i.fy = 60.0;
  renderer.render(boxes(), Pinhole(i), random_eye(random), {.bodies = true}, pictures);
  CHECK(pictures.bodies[0] == kNoBody);
  CHECK(pictures.color.row(0)[0] == 0);
}

TEST_CASE("a body that hides half of another one leaves half of it visible") {
  Renderer renderer;
  Scene scene;
  const Eigen::Isometry3d T = looking_at({0.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
  scene.ground.drawn = false;
  scene.bodies.push_back(body_of("behind", Plane{{0.2, 0.2}}, at(0.0, 0.0, 0.0), {}));
  CHECK(renderer.visible_share(scene, kSmall, T, 0) == 1.0);
  scene.bodies.push_back(body_of("before", Plane{{0.4, 0.4}}, at(0.2, 0.0, 0.001), {}));
  CHECK(renderer.visible_share(scene, kSmall, T, 0) == doctest::Approx(0.5).epsilon(0.06));
  scene.bodies[1].T_world_body = at(0.0, 0.0, 0.001);
  CHECK(renderer.visible_share(scene, kSmall, T, 0) == 0.0);
  // The camera moves until the border of the picture cuts the sheet in halves.
  scene.bodies.pop_back();
  const double half_width = kSmall.ray({95.5, 0.0})->x();
  CHECK(renderer.visible_share(scene, kSmall,
                               looking_at({half_width, 0.0, 0.0}, {half_width, 0.0, 1.0}),
                               0) == doctest::Approx(0.5).epsilon(0.06));
  CHECK(refusal_of([&] { (void)renderer.visible_share(scene, kSmall, T, 3); }) ==
        "The scene has 1 bodies, counted from 0; there is none with the number 3.");
}

TEST_CASE("a closed body is not seen from inside, an open one is") {
  Renderer renderer;
  Pictures pictures;
  Scene scene;
  scene.ground.drawn = false;
  scene.bodies.push_back(body_of("around", Sphere{0.5}, at(0.0, 0.0, 0.0), {}));
  scene.bodies.push_back(body_of("beyond", Box{{0.2, 0.2, 0.2}}, at(1.0, 0.0, 0.0), {}));
  const Eigen::Isometry3d T = looking_at({1.0, 0.0, 0.0}, {0.1, 0.0, 0.0});
  renderer.render(scene, kSmall, T, {.bodies = true}, pictures);
  CHECK(pictures.bodies[96 * 36 + 48] == 1);
  CHECK(pictures.bodies[0] == kNoBody);
  SurfaceParts open = scene.bodies[0].surface->parts();
  open.closed = false;
  scene.bodies[0].surface = std::make_shared<const Surface>(open);
  renderer.render(scene, kSmall, T, {.bodies = true}, pictures);
  CHECK(std::all_of(pictures.bodies.begin(), pictures.bodies.end(), [](int b) { return b == 0; }));
}

TEST_CASE("facets without area, behind the camera and of kilometres are drawn or left out") {
  Renderer renderer;
  Pictures pictures;
  Random random(13);
  SurfaceParts parts;
  parts.closed = false;
  parts.positions = {{0, 0, 0},       {1, 0, 0},        {2, 0, 0},
                     {1e4, 1e4, 5.0}, {-1e4, 1e4, 5.0}, {0, -1e4, 5.0}};
  parts.corners = {{0, 0, 0}, {0, 1, 2}, {0, 1, 1}, {3, 4, 5}, {5, 4, 3}};
  for (int k = 0; k < 300; ++k) {
    const double size = k % 3 == 0 ? 1e4 : k % 3 == 1 ? 1.0 : 1e-9;
    const auto first = static_cast<std::uint32_t>(parts.positions.size());
    for (int i = 0; i < 3; ++i)
      parts.positions.push_back(Vector3d(random.uniform(-size, size), random.uniform(-size, size),
                                         random.uniform(-size, size)));
    parts.corners.push_back({first, first + 1, first + 2});
  }
  Scene scene;
  scene.bodies.push_back({.name = "wild", .surface = std::make_shared<const Surface>(parts)});
  for (int n = 0; n < 20; ++n) {
    renderer.render(scene, kSmall, random_eye(random),
                    {.samples = n % 2 == 0 ? 1 : 4, .depth = true, .bodies = true}, pictures);
    for (const float depth : pictures.depth.depths()) {
      REQUIRE(depth >= 0.0F);
      REQUIRE(depth <= 20.1F);
    }
  }
}

TEST_CASE("pictures do not depend on what was drawn before") {
  Random random(14);
  Renderer renderer;
  for (const Scene& scene : sample_scenes()) {
    const Eigen::Isometry3d T = random_eye(random);
    Pictures used, fresh;
    renderer.render(scene, kSmall, T, {.depth = true, .bodies = true}, used);
    Renderer().render(scene, kSmall, T, {.depth = true, .bodies = true}, fresh);
    CHECK(used.color == fresh.color);
    CHECK(used.depth == fresh.depth);
    CHECK(used.bodies == fresh.bodies);
  }
}

TEST_CASE("scenes and options that are wrong are refused with their numbers") {
  Renderer renderer;
  Pictures pictures;
  Scene scene = boxes();
  const Eigen::Isometry3d T = looking_at({0, 0, 0}, {1, 0, 1});
  CHECK(refusal_of([&] { renderer.render(scene, kSmall, T, {.samples = 3}, pictures); }) ==
        "A pixel has 1 or 4 samples, not 3.");
  Eigen::Isometry3d wrong = T;
  wrong.translation().x() = NAN;
  CHECK_THROWS_AS(renderer.render(scene, kSmall, wrong, {}, pictures), ArgumentError);
  scene.bodies[1].T_world_body.linear() *= 2.0;
  CHECK_THROWS_AS(renderer.render(scene, kSmall, T, {}, pictures), ArgumentError);
  scene = boxes();
  scene.bodies[2].materials.resize(1);
  CHECK(refusal_of([&] { renderer.render(scene, kSmall, T, {}, pictures); }) ==
        "The body `blue` has 1 materials; its surface needs 2.");
  scene = boxes();
  scene.light.towards = Vector3d::Zero();
  CHECK_THROWS_AS(renderer.render(scene, kSmall, T, {}, pictures), ArgumentError);
  scene = boxes();
  scene.bodies[0].surface = nullptr;
  CHECK_THROWS_AS(renderer.render(scene, kSmall, T, {}, pictures), ArgumentError);
}
