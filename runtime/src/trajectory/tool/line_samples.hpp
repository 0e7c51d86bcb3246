// Inverse kinematics at positions on a curve, as closely spaced as the joints need it.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/trajectory/cartesian_line.hpp"
#include "trajectory/tool/pose_curve.hpp"

namespace armlet {

// How the parameter x determines the position on the curve.
//
// kQuintic  x is time from 0 to 1; the fraction 10 x^3 - 15 x^4 + 6 x^5 of the length is travelled.
// kEven     x is the fraction of the length, for a time law to be found later.
// kGiven    x is the time of the curve, which begins and ends at rest.
enum class CurveLaw { kQuintic, kEven, kGiven };

class LineSamples {
 public:
  LineSamples(const Robot& robot, const Eigen::VectorXd& q0, PoseCurve curve, IkTask task,
              CurveLaw law = CurveLaw::kQuintic);

  // For redundant arms: number of strengths with which joints keep away from their limits.
  static constexpr int kWays = 4;
  [[nodiscard]] int ways() const;

  // Samples the curve with the first method from number `way` on that can follow it; false if none
  // can, then fault() has the reason.
  bool follow(int way = 0);
  [[nodiscard]] const LineFault& fault() const { return fault_; }

  // The joints as functions of x, through all samples: from rest to rest, or for kEven with the
  // slopes of the samples at the ends. Only after follow() succeeded.
  [[nodiscard]] Trajectory motion() const;

 private:
  struct Sample {
    double x;
    Eigen::VectorXd q;
  };

  [[nodiscard]] double covered(double x) const;
  [[nodiscard]] Eigen::Isometry3d pose_at(double x) const;
  // How joint values are chosen where the curve leaves freedom.
  //
  // approach  rate, per metre of the curve and relative to the distance to its limit, at which a
  //           joint may approach the limit.
  // away      whether joints keep away from limits, or move as little as possible.
  struct Slide {
    double approach = INFINITY;
    bool away = false;

    [[nodiscard]] double share_of(double distance) const {
      return std::isfinite(approach) ? std::min(1.0, approach * distance) : 1.0;
    }
  };

  [[nodiscard]] std::optional<Eigen::VectorXd> slide(const Eigen::Isometry3d& T_world_tool,
                                                     const Eigen::VectorXd& seed, Slide how) const;
  [[nodiscard]] std::optional<Eigen::VectorXd> slide_to_position(const Eigen::Vector3d& position,
                                                                 const Eigen::VectorXd& seed,
                                                                 Slide how) const;
  [[nodiscard]] std::optional<Eigen::VectorXd> slide_into(const Eigen::Isometry3d& T_world_tool,
                                                          const Eigen::VectorXd& seed,
                                                          Slide how) const;
  [[nodiscard]] bool has_choice() const;
  [[nodiscard]] std::optional<Eigen::VectorXd> slide_easily(const Eigen::Isometry3d& T_world_tool,
                                                            const Eigen::VectorXd& seed) const;
  [[nodiscard]] IkResult solve(double x, const Eigen::VectorXd& seed,
                               bool respect_limits = true) const;
  bool follow_once();
  [[nodiscard]] bool goes_on(double x, const Eigen::VectorXd& q) const;
  [[nodiscard]] bool is_straight(double x) const;
  bool extend_easily(double x);
  bool extend(double x, int halvings);
  bool refine();
  [[nodiscard]] bool swings_out(const Trajectory& motion, const Sample& before,
                                const Sample& behind) const;
  [[nodiscard]] bool strays(const Trajectory& motion, double x) const;
  bool fail(const Sample& last, double x, IkResult ik);

  const Robot& robot_;
  PoseCurve curve_;
  IkTask task_;
  CurveLaw law_;
  std::vector<Sample> samples_;
  double away_ = 0.0;  // how strongly joints of a redundant arm keep away from their limits
  LineFault fault_;
};

}  // namespace armlet
