// Cameras in the record of a run.

#include <numeric>

#include "armlet/core/error.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

RecordedCamera recorded(const Cell& cell, const Camera& camera) {
  RecordedCamera out{.name = camera.name,
                     .lens = camera.lens.intrinsics(),
                     .object = {},
                     .T_on_camera = camera.T_on_camera};
  Mount on = camera.on;
  if (on.base == FrameBase::kFrame) {
    const Mount carrier = cell.world().mount_of_frame(on.on);
    const Eigen::Isometry3d T_carrier_frame =
        cell.T_world_mount(carrier).inverse(Eigen::Isometry) * cell.T_world_mount(on);
    out.T_on_camera = T_carrier_frame * out.T_on_camera;
    on = carrier;
  }
  if (on.base == FrameBase::kObject) out.object = on.on;
  if (on.base == FrameBase::kCarrier) {
    out.robot = on.carrier;
    out.link = on.frame == kFlange ? cell.robot(on.carrier).model->rows() : on.frame;
  }
  return out;
}

}  // namespace

void Recording::look_at_cameras() {
  const Host* host = session_ == nullptr ? nullptr : session_->host();
  if (host == nullptr) return;
  const Cell& cell = host->cell();
  const Cameras& cameras = cell.cameras();
  RecordedCameras& known = record_.cameras;
  known.taken = std::accumulate(cameras.taken().begin(), cameras.taken().end(), std::uint64_t{0});
  while (static_cast<int>(known.list.size()) < cameras.count()) {
    const int next = static_cast<int>(known.list.size());
    try {
      known.list.push_back(recorded(cell, cameras.at(next)));
    } catch (const ArgumentError&) {  // its carrier was removed
      known.list.push_back({.name = cameras.at(next).name, .lens = {}, .object = {}});
    }
    ++record_.described;
  }
}

}  // namespace armlet::lab
