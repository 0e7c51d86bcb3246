#include "camera/raster/triangles.hpp"

#include <algorithm>
#include <cmath>

#include "camera/raster/clip.hpp"

namespace armlet::raster {
namespace {

using Eigen::Vector3d;

// Adds the triangles of one body to the list.
class BodyTriangles {
 public:
  BodyTriangles(const SceneBody& body, std::int32_t number, const View& view, const Window& window,
                const Lighting& lighting, const LightFrame& light, SceneTriangles& out)
      : body_(body),
        parts_(body.surface->parts()),
        number_(number),
        view_(view),
        lighting_(lighting),
        out_(out),
        T_eye_body_(view.T_eye_world * body.T_world_body),
        light_{view.T_eye_world.linear() * light.x, view.T_eye_world.linear() * light.y,
               view.T_eye_world.linear() * light.towards},
        up_(view.T_eye_world.linear() * Vector3d::UnitZ()) {
    low_x_ = to_fixed(window.left - 1.0);
    low_y_ = to_fixed(window.top - 1.0);
    high_x_ = to_fixed(window.left + window.width);
    high_y_ = to_fixed(window.top + window.height);
  }

  void add() {
    project_vertices();
    for (std::size_t i = 0; i < parts_.corners.size(); ++i) add_triangle(i);
  }

 private:
  void place(SeenVertex& vertex) const {
    const Intrinsics& camera = view_.camera;
    const Vector3d& p = vertex.p;
    vertex.is_plain = false;
    vertex.x = vertex.y = 0;
    vertex.nearness = 0.0F;
    if (p.z() < camera.near) return;
    const double nearness = 1.0 / p.z();
    const double u = camera.fx * p.x() * nearness + camera.cx;
    const double v = camera.fy * p.y() * nearness + camera.cy;
    vertex.nearness = static_cast<float>(nearness);
    vertex.x = to_fixed(u);
    vertex.y = to_fixed(v);
    vertex.is_plain = u >= kGuardLow && u <= kGuardHigh && v >= kGuardLow && v <= kGuardHigh;
  }

  void project_vertices() {
    const Eigen::Matrix3d R = T_eye_body_.linear();
    const Vector3d t = T_eye_body_.translation();
    const Vector3d light = R.transpose() * light_[2], up = R.transpose() * up_;
    const bool is_smooth = !parts_.normals.empty();
    out_.vertices.resize(parts_.positions.size());
    for (std::size_t i = 0; i < parts_.positions.size(); ++i) {
      const Vector3d& p = parts_.positions[i];
      SeenVertex& vertex = out_.vertices[i];
      for (int k = 0; k < 3; ++k)
        vertex.p[k] = R(k, 0) * p[0] + R(k, 1) * p[1] + (R(k, 2) * p[2] + t[k]);
      place(vertex);
      if (!is_smooth) continue;
      const Vector3d n = parts_.normals[i].cast<double>();
      vertex.key = static_cast<float>(dot(n, light));
      vertex.up = static_cast<float>(dot(n, up));
    }
  }

  // Whether the back of the triangle is visible: 1 yes, 0 no, -1 it is not drawn.
  [[nodiscard]] int inside_of(std::int64_t area) const {
    if (area == 0) return -1;
    if (area < 0) return 0;  // counterclockwise as seen
    return parts_.closed ? -1 : 1;
  }

  [[nodiscard]] bool is_beside(const FixedTriangle& t) const {
    const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
    const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
    return x1 < low_x_ || x0 > high_x_ || y1 < low_y_ || y0 > high_y_;
  }

  void add_triangle(std::size_t i) {
    const auto& corners = parts_.corners[i];
    const std::array<const SeenVertex*, 3> v{&out_.vertices[corners[0]], &out_.vertices[corners[1]],
                                             &out_.vertices[corners[2]]};
    look_ = -1;
    if (v[0]->is_plain && v[1]->is_plain && v[2]->is_plain) {
      draw(i, v, v);
      return;
    }
    if (std::max({v[0]->p.z(), v[1]->p.z(), v[2]->p.z()}) < view_.camera.near) return;
    const Polygon polygon = clipped({v[0]->p, v[1]->p, v[2]->p}, view_.camera);
    std::array<SeenVertex, Polygon::kMost> cut;
    for (int k = 0; k < polygon.size; ++k) {
      const auto at = static_cast<std::size_t>(k);
      cut[at].p = polygon.p[at];
      cut[at].p.z() = std::max(cut[at].p.z(), view_.camera.near);  // rounding may lead below it
      place(cut[at]);
    }
    for (int k = 2; k < polygon.size; ++k)
      draw(i, {&cut[0], &cut[static_cast<std::size_t>(k - 1)], &cut[static_cast<std::size_t>(k)]},
           v);
  }

  // Draws a part of triangle i with corners v.
  void draw(std::size_t i, const std::array<const SeenVertex*, 3>& part,
            const std::array<const SeenVertex*, 3>& v) {
    const FixedTriangle fixed{{part[0]->x, part[1]->x, part[2]->x},
                              {part[0]->y, part[1]->y, part[2]->y}};
    if (is_beside(fixed)) return;
    const int inside = inside_of(fixed.doubled_area());
    if (inside < 0) return;
    const auto [low, high] = std::minmax({part[0]->nearness, part[1]->nearness, part[2]->nearness});
    if (look_ < 0) add_look(i, v, inside == 1, high);
    const Linear& w = out_.looks.back().nearness;
    out_.drawn.push_back({fixed, low, high, w.a, w.b, w.c, look_});
  }

  void add_look(std::size_t i, const std::array<const SeenVertex*, 3>& v, bool is_inside,
                float nearest) {
    const Vector3d &p0 = v[0]->p, &p1 = v[1]->p, &p2 = v[2]->p;
    const Vector3d n = (p1 - p0).cross(p2 - p0);
    const double det = dot(n, p0), length = std::sqrt(dot(n, n));
    // A triangle that is seen along its plane has no depths of its own.
    const bool is_plane = std::abs(det) > 1e-12 * length * (1e-3 + std::sqrt(dot(p0, p0)));
    const Material& material = body_.materials[parts_.materials.empty() ? 0 : parts_.materials[i]];
    TriangleLook look{};
    look.nearness = is_plane ? view_.plane(n, det) : Linear{0.0, 0.0, nearest};
    look.color = material.color;
    look.body = number_;
    look.picture = -1;
    look.is_smooth = is_plane && !parts_.normals.empty();
    shade(look, v, length > 0.0 ? Vector3d(n / length) : Vector3d(0.0, 0.0, -1.0), is_inside, det);
    if (is_plane && material.texture && !parts_.on_image.empty()) {
      std::array<Eigen::Vector2f, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = parts_.on_image[parts_.corners[i][k]];
      look.picture = static_cast<std::int32_t>(out_.places.size());
      out_.places.push_back({interpolated(v, {at[0].x(), at[1].x(), at[2].x()}, det),
                             interpolated(v, {at[0].y(), at[1].y(), at[2].y()}, det),
                             material.texture.get()});
    }
    look_ = static_cast<std::int32_t>(out_.looks.size());
    out_.looks.push_back(look);
  }

  void shade(TriangleLook& look, const std::array<const SeenVertex*, 3>& v, Vector3d n,
             bool is_inside, double det) const {
    const float sign = is_inside ? -1.0F : 1.0F;
    if (is_inside) n = -n;
    const double key = dot(n, light_[2]);
    look.meets_light = key > 0.0;
    if (look.is_smooth) {
      std::array<float, 3> keys, skies;
      for (std::size_t k = 0; k < 3; ++k) {
        keys[k] = lighting_.key * std::max(sign * v[k]->key, 0.0F);
        skies[k] = lighting_.sky(sign * v[k]->up);
      }
      look.key = interpolated(v, keys, det);
      look.sky = interpolated(v, skies, det);
    } else {
      look.key.c = lighting_.key * std::max(static_cast<float>(key), 0.0F);
      look.sky.c = lighting_.sky(static_cast<float>(dot(n, up_)));
    }
    // steeper surfaces get hardly any light that a shadow could remove
    constexpr double kSteepest = 12.0;
    for (std::size_t k = 0; k < 2; ++k) {
      look.slope[k] = 0.0F;
      if (look.meets_light)
        look.slope[k] =
            static_cast<float>(std::clamp(-dot(n, light_[k]) / key, -kSteepest, kSteepest));
    }
  }

  // f / z for a value f with given numbers at the corners.
  [[nodiscard]] Linear interpolated(const std::array<const SeenVertex*, 3>& v,
                                    const std::array<float, 3>& f, double det) const {
    const Vector3d g = (f[0] * v[1]->p.cross(v[2]->p) + f[1] * v[2]->p.cross(v[0]->p) +
                        f[2] * v[0]->p.cross(v[1]->p)) /
                       det;
    return view_.along_ray(g);
  }

  const SceneBody& body_;
  const SurfaceParts& parts_;
  std::int32_t number_;
  const View& view_;
  const Lighting& lighting_;
  SceneTriangles& out_;
  Eigen::Isometry3d T_eye_body_;
  std::array<Vector3d, 3> light_;  // axes of the light in the camera's frame
  Vector3d up_;
  std::int32_t low_x_, low_y_, high_x_, high_y_;
  std::int32_t look_ = -1;  // of the present triangle, -1: none yet
};

}  // namespace

Lighting::Lighting(const Light& light)
    : towards(light.towards / light.towards.norm()),
      key(static_cast<float>(light.key)),
      sky_middle(static_cast<float>(0.5 * (light.sky_up + light.sky_down))),
      sky_half(static_cast<float>(0.5 * (light.sky_up - light.sky_down))) {}

LightFrame::LightFrame(const Vector3d& direction) : towards(direction / direction.norm()) {
  const Vector3d across = std::abs(towards.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
  x = across.cross(towards);
  x /= x.norm();
  y = towards.cross(x);
}

void SceneTriangles::clear() {
  drawn.clear();
  looks.clear();
  places.clear();
}

bool may_be_seen(const Vector3d& middle, double radius, const Intrinsics& camera,
                 const Window& window) {
  if (middle.z() + radius < camera.near || middle.z() - radius > camera.far) return false;
  const double left = (window.left - 1.0 - camera.cx) / camera.fx;
  const double right = (window.left + window.width - camera.cx) / camera.fx;
  const double top = (window.top - 1.0 - camera.cy) / camera.fy;
  const double bottom = (window.top + window.height - camera.cy) / camera.fy;
  const auto is_outside = [&](double across, double slope, double sign) {
    const double distance = sign * (across - slope * middle.z());
    return distance < -radius * std::sqrt(1.0 + slope * slope);
  };
  return !is_outside(middle.x(), left, 1.0) && !is_outside(middle.x(), right, -1.0) &&
         !is_outside(middle.y(), top, 1.0) && !is_outside(middle.y(), bottom, -1.0);
}

void SceneTriangles::add(const SceneBody& body, std::int32_t number, const View& view,
                         const Window& window, const Lighting& lighting, const LightFrame& light) {
  const Vector3d middle = view.T_eye_world * (body.T_world_body * body.surface->middle());
  if (!may_be_seen(middle, body.surface->radius() * (1.0 + 1e-9) + 1e-9, view.camera, window))
    return;
  BodyTriangles(body, number, view, window, lighting, light, *this).add();
}

}  // namespace armlet::raster
