#include "camera/raster/shade.hpp"

#include <algorithm>
#include <cmath>

namespace armlet::raster {

using Eigen::Vector3d;

// A linear function along a run of pixels: its start is computed in double precision, the pixels of
// the run from there in single precision.
struct Shader::Steps {
  float start, slope;
  Steps(const Linear& f, const PixelRun& run)
      : start(static_cast<float>(f.at(run.u, run.v))), slope(static_cast<float>(f.a)) {}
  [[nodiscard]] F4 at(F4 k) const { return start + slope * k; }
};

// Shares of the light of a run.
struct Shader::Lights {
  const ShadowMap& shadows;
  Steps x, y, h;
  float x0, y0, h0, slope_x, slope_y;

  Lights(const ShadowMap& map, const PixelRun& run, const std::array<float, 2>& slope)
      : shadows(map),
        x(map.x(), run),
        y(map.y(), run),
        h(map.h(), run),
        x0(static_cast<float>(map.origin().x())),
        y0(static_cast<float>(map.origin().y())),
        h0(static_cast<float>(map.origin().z())),
        slope_x(slope[0] * map.square()),
        slope_y(slope[1] * map.square()) {}

  [[nodiscard]] F4 at(F4 k, F4 depth) const {
    // Columns and rows of the map are at integers.
    const F4 column = x.at(k) * depth + x0, row = y.at(k) * depth + y0;
    const F4 height = h.at(k) * depth + h0;
    F4 share{};
    for (int i = 0; i < 4; ++i)
      share[i] = shadows.light_at(column[i], row[i], height[i], slope_x, slope_y);
    return share;
  }
};

GroundView::GroundView(const Ground& ground, const View& view) {
  const Vector3d eye = view.T_world_eye.translation();
  const double height = eye.z() - ground.z;
  if (!ground.drawn || height <= 0.0) return;
  is_seen = true;
  const Eigen::Matrix3d& R = view.T_eye_world.linear();
  nearness = view.plane(R * Vector3d::UnitZ(), -height);
  x = view.along_ray(R * Vector3d::UnitX());
  y = view.along_ray(R * Vector3d::UnitY());
  origin = eye.head<2>();
}

Shader::Shader(const Scene& scene, const View& view, const SceneTriangles& triangles,
               const ShadowMap& shadows, const GroundView& ground, const Lighting& lighting)
    : view_(view),
      triangles_(triangles),
      shadows_(shadows),
      ground_view_(ground),
      ground_(scene.ground),
      background_(scene.background),
      background_bytes_{byte_of(background_.r), byte_of(background_.g), byte_of(background_.b)},
      tables_(srgb_tables()),
      ground_sky_(lighting.sky(1.0F)),
      ground_key_(lighting.key * std::max(0.0F, static_cast<float>(lighting.towards.z()))) {
  const LightFrame light(lighting.towards);
  const double up = std::max(light.towards.z(), 0.05);
  ground_slope_ = {static_cast<float>(-light.x.z() / up), static_cast<float>(-light.y.z() / up)};
}

void Shader::shade(std::int32_t number, const PixelRun& run, std::uint8_t* out) const {
  if (number >= 0) {
    const TriangleLook& look = triangles_.looks[static_cast<std::size_t>(number)];
    if (look.picture >= 0) {
      shade_picture(look, run, out);
    } else {
      shade_triangle(look, run, out);
    }
  } else if (number == kGroundNumber) {
    shade_ground(run, out);
  } else {
    for (int i = 0; i < 3 * run.count; ++i)
      out[i] = background_bytes_[static_cast<std::size_t>(i % 3)];
  }
}

void Shader::write(F4 r, F4 g, F4 b, int count, std::uint8_t* out) const {
  constexpr auto kSteps = static_cast<float>(SrgbTables::kEncodeSteps);
  const auto index = [](F4 linear) {
    return __builtin_convertvector(within(linear * kSteps, 0.0F, kSteps) + 0.5F, I4);
  };
  const I4 ir = index(r), ig = index(g), ib = index(b);
  for (int i = 0; i < std::min(count, 4); ++i) {
    out[3 * i] = tables_.encode[static_cast<std::size_t>(ir[i])];
    out[3 * i + 1] = tables_.encode[static_cast<std::size_t>(ig[i])];
    out[3 * i + 2] = tables_.encode[static_cast<std::size_t>(ib[i])];
  }
}

void Shader::shade_triangle(const TriangleLook& look, const PixelRun& run,
                            std::uint8_t* out) const {
  const bool meets_shadows = look.meets_light && !shadows_.is_empty();
  if (!meets_shadows && !look.is_smooth) {
    const float light = static_cast<float>(look.sky.c + look.key.c);
    std::array<std::uint8_t, 3> bytes{encoded_byte(tables_, look.color.r * light),
                                      encoded_byte(tables_, look.color.g * light),
                                      encoded_byte(tables_, look.color.b * light)};
    for (int i = 0; i < run.count; ++i, out += 3) std::copy_n(bytes.data(), 3, out);
    return;
  }
  const Steps w(look.nearness, run), key(look.key, run), sky(look.sky, run);
  const Lights lights(shadows_, run, look.slope);
  for (int i = 0; i < run.count; i += 4, out += 12) {
    const F4 k = __builtin_convertvector(kCount + i, F4);
    const F4 depth = 1.0F / w.at(k);
    F4 directed = F4{} + static_cast<float>(look.key.c),
       light = F4{} + static_cast<float>(look.sky.c);
    if (look.is_smooth) {
      directed = within(key.at(k) * depth, 0.0F, 1e3F);
      light = within(sky.at(k) * depth, 0.0F, 1e3F);
    }
    if (meets_shadows) directed *= lights.at(k, depth);
    light += directed;
    write(look.color.r * light, look.color.g * light, look.color.b * light, run.count - i, out);
  }
}

// Pixel by pixel: interpolation and texture access take longer than the rest.
void Shader::shade_picture(const TriangleLook& look, const PixelRun& run, std::uint8_t* out) const {
  const PicturePlace& place = triangles_.places[static_cast<std::size_t>(look.picture)];
  const auto width = static_cast<double>(place.texture->width());
  const auto height = static_cast<double>(place.texture->height());
  for (int i = 0; i < run.count; ++i, out += 3) {
    const PixelRun one{run.u + i, run.v, 1};
    const double depth = 1.0 / look.nearness.at(one.u, one.v);
    const double s = place.u.at(one.u, one.v) * depth, t = place.v.at(one.u, one.v) * depth;
    // d(s, t) / d(u, v) in pixels of the picture; the longer column is the footprint.
    const Linear& w = look.nearness;
    const double su = (place.u.a - s * w.a) * width, sv = (place.u.b - s * w.b) * width;
    const double tu = (place.v.a - t * w.a) * height, tv = (place.v.b - t * w.b) * height;
    const double square = std::max(su * su + tu * tu, sv * sv + tv * tv) * depth * depth;
    const auto footprint = static_cast<float>(std::sqrt(std::min(square, 1e12)));
    const std::array<float, 3> rgb =
        place.texture->value(static_cast<float>(std::clamp(s, -1.0, 2.0)),
                             static_cast<float>(std::clamp(t, -1.0, 2.0)), footprint);
    auto key = static_cast<float>(look.key.c), sky = static_cast<float>(look.sky.c);
    if (look.is_smooth) {
      key = static_cast<float>(std::clamp(look.key.at(one.u, one.v) * depth, 0.0, 1e3));
      sky = static_cast<float>(std::clamp(look.sky.at(one.u, one.v) * depth, 0.0, 1e3));
    }
    if (look.meets_light && !shadows_.is_empty())
      key *= Lights(shadows_, one, look.slope).at(F4{}, F4{} + static_cast<float>(depth))[0];
    const float light = sky + key;
    out[0] = encoded_byte(tables_, look.color.r * light * decoded_value(tables_, rgb[0]));
    out[1] = encoded_byte(tables_, look.color.g * light * decoded_value(tables_, rgb[1]));
    out[2] = encoded_byte(tables_, look.color.b * light * decoded_value(tables_, rgb[2]));
  }
}

// Share of pixels of given widths that lines parallel to the axes cover. Lines that lie closer
// than a few pixels fade away.
F4 Shader::lines_at(F4 x, F4 y, F4 width_x, F4 width_y, float spacing, float half) const {
  constexpr float kRound = 12582912.0F;  // 1.5 * 2^23: adding it leaves no digits behind the point
  const auto covered = [&](F4 at, F4 width) {
    const F4 cell = at * (1.0F / spacing);
    const F4 off = (cell - ((cell + kRound) - kRound)) * spacing;
    const F4 distance = larger(off, -off);
    const F4 share = (half + 0.5F * width - distance) / width;
    const F4 most = smaller(F4{} + 1.0F, (2.0F * half) / width);
    const F4 fade = within(2.0F - width * (6.0F / spacing), 0.0F, 1.0F);
    return smaller(larger(share, F4{}), most) * fade;
  };
  return larger(covered(x, width_x), covered(y, width_y));
}

void Shader::shade_ground(const PixelRun& run, std::uint8_t* out) const {
  const GroundView& g = ground_view_;
  const Steps w(g.nearness, run), x(g.x, run), y(g.y, run);
  const Lights lights(shadows_, run, ground_slope_);
  const auto x0 = static_cast<float>(g.origin.x()), y0 = static_cast<float>(g.origin.y());
  const auto far = static_cast<float>(1.0 / view_.camera.far);
  const auto xu = static_cast<float>(g.x.a), xv = static_cast<float>(g.x.b);
  const auto yu = static_cast<float>(g.y.a), yv = static_cast<float>(g.y.b);
  const auto wu = static_cast<float>(g.nearness.a), wv = static_cast<float>(g.nearness.b);
  const auto magnitude = [](F4 f) { return larger(f, -f); };
  for (int i = 0; i < run.count; i += 4, out += 12) {
    const F4 k = __builtin_convertvector(kCount + i, F4);
    const F4 nearness = larger(w.at(k), F4{} + far);
    const F4 depth = 1.0F / nearness;
    F4 line{};
    if (ground_.grid) {
      const F4 dx = x.at(k) * depth, dy = y.at(k) * depth;
      const F4 width_x = (magnitude(xu - dx * wu) + magnitude(xv - dx * wv)) * depth + 1e-9F;
      const F4 width_y = (magnitude(yu - dy * wu) + magnitude(yv - dy * wv)) * depth + 1e-9F;
      line = larger(lines_at(dx + x0, dy + y0, width_x, width_y, 1.0F, 0.003F),
                    0.45F * lines_at(dx + x0, dy + y0, width_x, width_y, 0.1F, 0.001F));
    }
    F4 light = F4{} + ground_key_;
    if (!shadows_.is_empty()) light *= lights.at(k, depth);
    light += ground_sky_;
    // The ground fades out between half of `far` and `far`.
    const F4 fade = within(2.0F - far * depth * 2.0F, 0.0F, 1.0F);
    const auto mixed = [&](float plain, float drawn, float behind) {
      return (plain + line * (drawn - plain)) * light * fade + behind * (1.0F - fade);
    };
    write(mixed(ground_.color.r, ground_.line.r, background_.r),
          mixed(ground_.color.g, ground_.line.g, background_.g),
          mixed(ground_.color.b, ground_.line.b, background_.b), run.count - i, out);
  }
}

}  // namespace armlet::raster
