// Whether an arm can go straight from joints to joints among bodies that stand still: what planners
// ask thousands of times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "armlet/collision/motion_check.hpp"

namespace armlet {

// A pair of a scene that overlaps by more than may be, and how deep, m.
struct Overlap {
  std::size_t pair = 0;  // of MotionScene::pairs
  double depth = 0.0;
};

// The first arm of a scene moves; the others stand where their motions end. Bodies keep a clearance
// from each other. Of a pair that has a gap g of less than 1.25 times the clearance c at an end,
// they keep max(g / 2, g - c / 4) instead, and where that is next to nothing they may touch.
class SegmentCheck {
 public:
  // scene      not owned; it stays as it is. The motion of the first arm does not count.
  // clearance  wanted between the bodies of each pair, m, > 0.
  // ends       joints at which the way may begin or end; those that collide do not count.
  // throws     ArgumentError as check_motion, and unless every end has n elements.
  SegmentCheck(const MotionScene& scene, double clearance, std::span<const Eigen::VectorXd> ends);
  ~SegmentCheck();
  SegmentCheck(const SegmentCheck&) = delete;
  SegmentCheck& operator=(const SegmentCheck&) = delete;

  // The overlaps at a position, deepest first; empty if none is deeper than kSoft. What lies on
  // something else, and is lifted from it, does not count there.
  [[nodiscard]] std::vector<Overlap> overlaps(const Eigen::VectorXd& q);

  // What each pair keeps along free segments, m: certain for the whole segment, with 5 % to spare
  // there. Negative: the pair may touch, or overlap by so much.
  [[nodiscard]] const std::vector<double>& kept() const { return kept_; }

  // Whether the arm keeps its clearance at q.
  [[nodiscard]] bool is_free(const Eigen::VectorXd& q);

  // The same for the whole straight segment of the joints between two positions: certain, no
  // samples. It halves the segment until no point can travel as far as the gap is wide.
  //
  // source  as for check_motion.
  [[nodiscard]] bool is_free(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1);

  // How often each pair has been in the way so far.
  [[nodiscard]] const std::vector<std::uint64_t>& blocked() const { return blocked_; }

 private:
  struct Stretch {
    double t0, t1;
    std::size_t begin, end;  // of open_: the pairs that nobody has excluded there
  };
  enum class Answer { kFree, kBlocked, kOpen };

  void place(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double t0, double t1);
  void keep_less_at(const Eigen::VectorXd& end, double clearance);
  [[nodiscard]] Answer look(std::size_t pair);

  const MotionScene& scene_;
  class Pose;
  std::unique_ptr<Pose> pose_;
  std::vector<double> kept_;
  std::vector<double> keep_;   // of each pair: the gap at every position that is looked at, m
  std::vector<double> grain_;  // and by how much less it may be between two of them, m
  std::vector<std::uint64_t> blocked_;
  std::vector<std::size_t> open_;
  std::vector<Stretch> stretches_;
};

}  // namespace armlet
