// Moves of limited jerk with the force limits of motors instead of acceleration limits.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "armlet/trajectory/motion_forces.hpp"
#include "armlet/trajectory/time_optimal.hpp"
#include "trajectory/planners/planning.hpp"
#include "trajectory/timing/smooth_run.hpp"

namespace armlet {
namespace {

constexpr int kCells = 64;          // pieces of the speed along a path
constexpr int kIntervals = 100;     // intervals for the motion without jerk limits
constexpr double kRounding = 1e-9;  // relative

// The motion, slowed down until the motors suffice; empty if no factor is sufficient.
std::optional<Trajectory> slowed(const Robot& motors, Trajectory motion) {
  const double slower = motion_forces(motors, motion).slower;
  if (!std::isfinite(slower)) return {};
  if (slower <= 1.0) return motion;
  return motion.stretched(slower);
}

// The limits of each joint on speed and jerk, with that of its motor if the motor is known.
class MotorRuns {
 public:
  explicit MotorRuns(const MoveRequest& request)
      : request_(request), motors_(*request.motors), limits_(limits_beside_motors(request)) {}

  std::optional<Trajectory> shortest() {
    const Trajectory by_acceleration = phased_move(request_, request_.limits).trajectory();
    const Trajectory free = without_accelerations();
    std::optional<Trajectory> best = slowed(motors_, free);
    // No motion is faster than one that only the limits on speed and jerk restrict.
    if (best && best->duration() <= free.duration() * (1.0 + kRounding)) return best;
    take_shorter(best, slowed(motors_, by_acceleration));
    take_shorter(best, along(free, evenly(free)));
    take_shorter(best, straight());
    return best;
  }

 private:
  static void take_shorter(std::optional<Trajectory>& best, std::optional<Trajectory> other) {
    if (other && (!best || other->duration() < best->duration())) best = std::move(other);
  }

  // A joint that accelerates from rest to its highest speed V and back exceeds sqrt(V J) nowhere.
  [[nodiscard]] Trajectory without_accelerations() const {
    std::vector<AxisLimits> limits = limits_;
    for (AxisLimits& l : limits) {
      if (!std::isfinite(l.acceleration)) l.acceleration = std::sqrt(l.speed * l.jerk);
    }
    return phased_move(request_, limits).trajectory();
  }

  // The path of a motion, with its positions in the order of time.
  static SpeedAlongPath evenly(const Trajectory& motion) {
    SpeedAlongPath speed;
    for (int k = 0; k <= kIntervals; ++k) {
      speed.s.push_back(motion.duration() * k / kIntervals);
      speed.squared.push_back(1.0);
    }
    return speed;
  }

  [[nodiscard]] std::optional<Trajectory> along(const Trajectory& path,
                                                const SpeedAlongPath& fastest) const {
    const Course course{path, limits_, {}, {}, &motors_};
    TimedRun run = smooth_run(course, fastest, kCells);
    if (run.s.empty()) return {};
    return slowed(motors_, std::move(run.motion));
  }

  // All joints move in proportion.
  [[nodiscard]] std::optional<Trajectory> straight() const {
    const std::vector<Eigen::VectorXd> points = {request_.q0, request_.q1};
    const Trajectory path = path_through(points);
    const auto fastest = fastest_along(Course{path, limits_, {}, {}, &motors_}, kIntervals);
    if (!fastest) return {};
    return along(path, *fastest);
  }

  const MoveRequest& request_;
  const Robot& motors_;
  std::vector<AxisLimits> limits_;
};

}  // namespace

std::optional<Trajectory> limited_jerk_with_motors(const MoveRequest& request) {
  return MotorRuns(request).shortest();
}

}  // namespace armlet
