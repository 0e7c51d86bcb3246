// Planned paths around obstacles in the record of a run.

#include <algorithm>

#include "armlet/cell/clock.hpp"
#include "armlet/kinematics/forward.hpp"
#include "record.hpp"

namespace armlet::lab {
namespace {

constexpr int kPathPoints = 61;
constexpr int kArms = 5;

// Joint values at `count` equal intervals of the motion, from `first` to `last` of its duration.
std::vector<Eigen::VectorXd> positions(const Trajectory& motion, int count, double first,
                                       double last) {
  std::vector<Eigen::VectorXd> all;
  Eigen::VectorXd q(motion.n()), qd(motion.n()), qdd(motion.n());
  for (int i = 0; i < count; ++i) {
    const double share = first + (last - first) * i / (count - 1);
    motion.sample(share * motion.duration(), q, qd, qdd);
    all.push_back(q);
  }
  return all;
}

}  // namespace

void Recording::take_ways() {
  const Host* host = session_ == nullptr ? nullptr : session_->host();
  if (host == nullptr) return;
  for (std::size_t i = record_.ways.size(); i < host->ways().size(); ++i) {
    const PlannedWay& way = host->ways()[i];
    RecordedWay told{
        .robot = way.robot,
        .t = to_seconds(way.t_ns),
        .duration = way.motion.duration(),
        .path = {},
        .arms = positions(way.motion, kArms, 1.0 / (kArms + 1), 1.0 - 1.0 / (kArms + 1))};
    for (const Eigen::VectorXd& q : positions(way.motion, kPathPoints, 0.0, 1.0))
      told.path.push_back(forward(*way.model, q).translation());
    record_.ways.push_back(std::move(told));
  }
}

}  // namespace armlet::lab
