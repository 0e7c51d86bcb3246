#include "armlet/cell/clearance.hpp"

#include <algorithm>
#include <optional>

#include "armlet/kinematics/forward.hpp"
#include "armlet/trajectory/trajectory.hpp"

namespace armlet {
namespace {

constexpr double kInTouch = 1e-5;  // m

// The bodies of a scene in their poses at its beginning.
class PlacedBodies {
 public:
  explicit PlacedBodies(const MotionScene& scene) : scene_(scene) {
    for (const ArmInMotion& arm : scene.arms) {
      const int n = arm.robot->n();
      Eigen::VectorXd q(n), qd(n), qdd(n);
      arm.motion->sample(arm.from, q, qd, qdd);
      frames_.push_back(link_frames(*arm.robot, q));
    }
  }

  [[nodiscard]] Solid operator[](const BodyRef& ref) const {
    const auto index = static_cast<std::size_t>(ref.index);
    if (ref.arm == BodyRef::kFixed) return scene_.fixed[index];
    const auto arm = static_cast<std::size_t>(ref.arm);
    const ArmSolid& body = scene_.arms[arm].solids[index];
    Solid solid = body.solid;
    solid.T = (body.frame == 0 ? scene_.arms[arm].robot->T_world_base()
                               : frames_[arm][static_cast<std::size_t>(body.frame - 1)]) *
              body.solid.T;
    return solid;
  }

 private:
  const MotionScene& scene_;
  std::vector<std::vector<Eigen::Isometry3d>> frames_;
};

bool names_same(const CellBody& a, const CellBody& b) {
  return a.object == b.object && (!a.object.empty() || a.robot == b.robot);
}

// The earlier result for the same two things, or a new one.
Clearance& among(std::vector<Clearance>& found, const Clearance& now) {
  const auto same = std::ranges::find_if(found, [&](const Clearance& known) {
    return names_same(known.body, now.body) && names_same(known.other, now.other);
  });
  return same == found.end() ? found.emplace_back(now) : *same;
}

// Its own links are always near one another, and are compared with half their thickness.
bool is_own(const CellBody& other, int robot) {
  return other.robot == robot && other.object.empty();
}

}  // namespace

std::vector<Clearance> clearances(const Cell& cell, int robot, double reach, std::size_t most) {
  const Trajectory stands = Trajectory::at_rest(cell.robot(robot).q, 0.0);
  const ComparedBodies compared = compared_bodies(cell, robot, stands);
  const PlacedBodies bodies(compared.scene);
  std::vector<Clearance> touching;
  std::optional<Clearance> nearest;
  for (std::size_t i = 0; i < compared.pairs.size(); ++i) {
    const Solid a = bodies[compared.scene.pairs[i].a], b = bodies[compared.scene.pairs[i].b];
    const double limit =
        touching.empty() ? std::max(nearest ? nearest->distance : reach, 0.0) : 0.0;
    if (is_farther(a, b, std::max(limit, kInTouch))) continue;
    const Gap gap = gap_between(a, b);
    const Clearance now{.body = compared.pairs[i].first,
                        .other = compared.pairs[i].second,
                        .distance = gap.distance,
                        .p_body = gap.p_a,
                        .p_other = gap.p_b};
    if (gap.distance <= kInTouch) {
      Clearance& known = among(touching, now);
      if (now.distance <= known.distance) {
        known = now;
        known.at_least = gap.distance < -kInTouch && !is_whole_depth(a, b, gap);
      }
    } else if (!is_own(now.other, robot) && gap.distance < reach &&
               (!nearest || gap.distance < nearest->distance)) {
      nearest = now;
    }
  }
  if (touching.empty() && nearest) return {*nearest};
  std::ranges::stable_sort(touching, {}, &Clearance::distance);
  if (touching.size() > most) touching.resize(most);
  return touching;
}

}  // namespace armlet
