#pragma once
// The scene of a camera in Embree, whose primary rays are compared with our pictures.

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"

namespace armlet::bench {

// Traces rays in one thread, in packets of 16 neighbours, with the flag for coherent rays.
class EmbreeScene {
 public:
  EmbreeScene(const Scene& scene, const Pinhole& camera, const Eigen::Isometry3d& T_world_eye)
      : width_(camera.intrinsics().width),
        height_(camera.intrinsics().height),
        focal_(static_cast<float>(camera.intrinsics().fx)),
        middle_(static_cast<float>(camera.intrinsics().cx),
                static_cast<float>(camera.intrinsics().cy)),
        from_(T_world_eye.translation().cast<float>()),
        axes_(T_world_eye.linear().cast<float>()) {
    for (const SceneBody& body : scene.bodies) {
      std::vector<Eigen::Vector3f> points;
      for (const Eigen::Vector3d& p : body.surface->parts().positions)
        points.push_back((body.T_world_body * p).cast<float>());
      add(points, body.surface->parts().corners);
    }
    const auto z = static_cast<float>(scene.ground.z);
    const float r = 20.0F;
    ground_ = add({{-r, -r, z}, {r, -r, z}, {r, r, z}, {-r, r, z}}, {{0, 1, 2}, {0, 2, 3}});
    rtcCommitScene(scene_);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  // Finds the body at each of 1 or 4 samples per pixel.
  void trace(int samples) {
    on_bodies_ = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    std::fill(std::begin(valid), std::end(valid), -1);
    // A packet is a square of 4 x 4 samples: 2 x 2 pixels with four each, or 4 x 4 pixels.
    const int pixels = samples == 4 ? 2 : 4;
    const float step = samples == 4 ? 0.5F : 1.0F, first = samples == 4 ? -0.25F : 0.0F;
    for (int y = 0; y < height_; y += pixels) {
      for (int x = 0; x < width_; x += pixels) {
        RTCRayHit16 packet;
        for (unsigned k = 0; k < 16; ++k)
          set_ray(packet, k, static_cast<float>(x) + first + step * static_cast<float>(k % 4),
                  static_cast<float>(y) + first + step * static_cast<float>(k / 4));
        rtcIntersect16(valid, scene_, &context, &packet);
        for (const unsigned id : packet.hit.geomID)
          on_bodies_ += id != RTC_INVALID_GEOMETRY_ID && id != ground_ ? 1 : 0;
      }
    }
  }

  // The number of samples on bodies in the last trace.
  [[nodiscard]] long samples_on_bodies() const { return on_bodies_; }
  [[nodiscard]] int triangle_count() const { return triangles_; }

 private:
  unsigned add(const std::vector<Eigen::Vector3f>& points,
               const std::vector<std::array<std::uint32_t, 3>>& corners) {
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* const to = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                             sizeof(Eigen::Vector3f), points.size());
    std::copy(points.begin(), points.end(), static_cast<Eigen::Vector3f*>(to));
    void* const index =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), corners.size());
    std::copy(corners.begin(), corners.end(), static_cast<std::array<std::uint32_t, 3>*>(index));
    rtcCommitGeometry(geometry);
    const unsigned id = rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    triangles_ += static_cast<int>(corners.size());
    return id;
  }

  void set_ray(RTCRayHit16& packet, unsigned k, float u, float v) const {
    const Eigen::Vector3f towards =
        axes_ * Eigen::Vector3f((u - middle_.x()) / focal_, (v - middle_.y()) / focal_, 1.0F);
    packet.ray.org_x[k] = from_.x();
    packet.ray.org_y[k] = from_.y();
    packet.ray.org_z[k] = from_.z();
    packet.ray.dir_x[k] = towards.x();
    packet.ray.dir_y[k] = towards.y();
    packet.ray.dir_z[k] = towards.z();
    packet.ray.tnear[k] = 0.01F;
    packet.ray.tfar[k] = 20.0F;
    packet.ray.time[k] = 0.0F;
    packet.ray.mask[k] = ~0U;
    packet.ray.flags[k] = 0;
    packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }

  RTCDevice device_ = rtcNewDevice("threads=1");
  RTCScene scene_ = rtcNewScene(device_);
  int width_, height_;
  float focal_;
  Eigen::Vector2f middle_;
  Eigen::Vector3f from_;
  Eigen::Matrix3f axes_;
  unsigned ground_ = 0;
  int triangles_ = 0;
  long on_bodies_ = 0;
};

}  // namespace armlet::bench
