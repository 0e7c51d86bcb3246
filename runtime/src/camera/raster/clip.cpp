#include "camera/raster/clip.hpp"

#include "camera/raster/coverage.hpp"

namespace armlet::raster {
namespace {

using Eigen::Vector3d;

// Always computed from the kept corner to the other one, so that both triangles of an edge get the
// same point.
Vector3d crossing(const Vector3d& kept, double at_kept, const Vector3d& lost, double at_lost) {
  const double share = at_kept / (at_kept - at_lost);
  return {kept[0] + share * (lost[0] - kept[0]), kept[1] + share * (lost[1] - kept[1]),
          kept[2] + share * (lost[2] - kept[2])};
}

}  // namespace

Polygon cut(const Polygon& whole, const HalfSpace& side) {
  Polygon part;
  for (int i = 0; i < whole.size; ++i) {
    const Vector3d& here = whole.p[static_cast<std::size_t>(i)];
    const Vector3d& next = whole.p[static_cast<std::size_t>((i + 1) % whole.size)];
    const double at_here = side.at(here), at_next = side.at(next);
    const auto add = [&](const Vector3d& p) {
      if (part.size < Polygon::kMost) part.p[static_cast<std::size_t>(part.size++)] = p;
    };
    if (at_here >= 0.0) add(here);
    if (at_here >= 0.0 && at_next < 0.0) add(crossing(here, at_here, next, at_next));
    if (at_here < 0.0 && at_next >= 0.0) add(crossing(next, at_next, here, at_here));
  }
  return part;
}

Polygon clipped(const std::array<Vector3d, 3>& triangle, const Intrinsics& camera) {
  Polygon polygon;
  for (const Vector3d& p : triangle) polygon.p[static_cast<std::size_t>(polygon.size++)] = p;
  const std::array<HalfSpace, 5> sides{HalfSpace{{0.0, 0.0, 1.0}, -camera.near},
                                       HalfSpace{{camera.fx, 0.0, camera.cx - kGuardLow}},
                                       HalfSpace{{-camera.fx, 0.0, kGuardHigh - camera.cx}},
                                       HalfSpace{{0.0, camera.fy, camera.cy - kGuardLow}},
                                       HalfSpace{{0.0, -camera.fy, kGuardHigh - camera.cy}}};
  for (const HalfSpace& side : sides) {
    polygon = cut(polygon, side);
    if (polygon.size < 3) return {};
  }
  return polygon;
}

}  // namespace armlet::raster
