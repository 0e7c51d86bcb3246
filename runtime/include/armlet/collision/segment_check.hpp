// Whether an arm can move straight in joint space among bodies at rest; path searches ask this
// thousands of times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "armlet/collision/motion_check.hpp"

namespace armlet {

// A pair of a scene that overlaps by more than allowed, and the depth, m.
struct Overlap {
  std::size_t pair = 0;  // of MotionScene::pairs
  double depth = 0.0;
};

// The first arm of a scene moves; the others are at the ends of their motions. Bodies keep a
// clearance c from each other. A pair whose gap g at an end of the path is less than 1.25 c keeps
// max(g / 2, g - c / 4) instead, and if that is nearly zero it may touch.
class SegmentCheck {
 public:
  // scene      not owned, not changed. The motion of the first arm is ignored.
  // clearance  between the bodies of each pair, m, > 0.
  // ends       joint values at which the path may begin or end; those in collision are ignored.
  // throws     ArgumentError as check_motion, and unless every end has n elements.
  SegmentCheck(const MotionScene& scene, double clearance, std::span<const Eigen::VectorXd> ends);
  ~SegmentCheck();
  SegmentCheck(const SegmentCheck&) = delete;
  SegmentCheck& operator=(const SegmentCheck&) = delete;

  // The overlaps at joint values q, deepest first; empty if none is deeper than kSoft. A body that
  // lies on another one, and would be lifted from it, does not count.
  [[nodiscard]] std::vector<Overlap> overlaps(const Eigen::VectorXd& q);

  // The distance that each pair keeps along free segments, m: certain for the whole segment, with a
  // margin of 5 %. Negative: the pair may touch, or overlap by that much.
  [[nodiscard]] const std::vector<double>& kept() const { return kept_; }

  // Whether the arm keeps its clearance at q.
  [[nodiscard]] bool is_free(const Eigen::VectorXd& q);

  // Whether the arm keeps its clearance on the whole straight segment in joint space between two
  // configurations: certain, without sampling. It halves the segment until no point can travel as
  // far as the gap.
  //
  // source  as for check_motion.
  [[nodiscard]] bool is_free(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);

  // How often each pair has blocked a segment so far.
  [[nodiscard]] const std::vector<std::uint64_t>& blocked() const { return blocked_; }

 private:
  struct Stretch {
    double t0, t1;
    std::size_t begin, end;  // of open_: the pairs that are not excluded there
  };
  enum class Answer { kFree, kBlocked, kOpen };

  void place(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double t0, double t1);
  void keep_less_at(const Eigen::VectorXd& end, double clearance);
  [[nodiscard]] Answer look(std::size_t pair);

  const MotionScene& scene_;
  class Pose;
  std::unique_ptr<Pose> pose_;
  std::vector<double> kept_;
  std::vector<double> keep_;   // of each pair: the gap required at every checked configuration, m
  std::vector<double> grain_;  // allowed decrease of the gap between two of them, m
  std::vector<std::uint64_t> blocked_;
  std::vector<std::size_t> open_;
  std::vector<Stretch> stretches_;
};

}  // namespace armlet
