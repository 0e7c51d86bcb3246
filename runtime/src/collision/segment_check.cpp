#include "armlet/collision/segment_check.hpp"

#include <algorithm>
#include <cmath>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "collision/scene_pose.hpp"

namespace armlet {
namespace {

// Fractions of a clearance: the margin of segments, so that a motion along them can be certified
// again, and the additional distance at configurations, compared with the interval between two of
// them.
constexpr double kSpare = 0.05;
constexpr double kGrain = 0.1;
constexpr double kRoomy = 1.25;  // clearances; larger gaps at an end reduce nothing
// m, pairs that may touch: with their grain still less than kSoft
constexpr double kTouching = -0.8e-4;
constexpr double kTouchingGrain = 2e-5;  // m
// m, largest distance at which a body that was lying on another one still does
constexpr double kLeft = 1e-3;
constexpr std::uint64_t kLookCost = 600;  // operations of a configuration, and of each pair there
constexpr std::uint64_t kPairCost = 40;

}  // namespace

class SegmentCheck::Pose {
 public:
  explicit Pose(const MotionScene& scene) : pose(scene) {
    for (const ArmInMotion& arm : scene.arms) {
      for (int i = 0; i < arm.robot->n(); ++i)
        q.push_back(arm.motion->value(i, arm.from + scene.duration));
    }
    travel.assign(q.size(), 0.0);
  }

  ScenePose pose;
  std::vector<double> q, travel;
};

SegmentCheck::SegmentCheck(const MotionScene& scene, double clearance,
                           std::span<const Eigen::VectorXd> ends)
    : scene_(scene),
      pose_(std::make_unique<Pose>(scene)),
      kept_(scene.pairs.size(), clearance),
      keep_(scene.pairs.size()),
      grain_(scene.pairs.size()),
      blocked_(scene.pairs.size(), 0) {
  for (const Eigen::VectorXd& end : ends) {
    check_size("ends", end.size(), scene.arms.at(0).robot->n());
    keep_less_at(end, clearance);
  }
  for (std::size_t i = 0; i < keep_.size(); ++i) {
    const bool touches = kept_[i] < 0.0;
    grain_[i] = touches ? kTouchingGrain : kGrain * kept_[i];
    keep_[i] = touches ? kept_[i] : (1.0 + kSpare) * kept_[i] + grain_[i];
  }
}

SegmentCheck::~SegmentCheck() = default;

void SegmentCheck::place(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, double t0,
                         double t1) {
  const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
  for (Eigen::Index i = 0; i < q0.size(); ++i) {
    const double way = q1[i] - q0[i];
    pose_->q[static_cast<std::size_t>(i)] = q0[i] + middle * way;
    pose_->travel[static_cast<std::size_t>(i)] = std::abs(half * way);
  }
  pose_->pose.place(pose_->q, pose_->travel);
}

void SegmentCheck::keep_less_at(const Eigen::VectorXd& end, double clearance) {
  place(end, end, 0.0, 0.0);
  for (std::size_t i = 0; i < scene_.pairs.size(); ++i) {
    const CheckedPair& pair = scene_.pairs[i];
    const Solid &a = pose_->pose.body(pair.a), &b = pose_->pose.body(pair.b);
    if (is_farther(a, b, kRoomy * clearance)) continue;
    const double gap = gap_between(a, b).distance;
    if (pair.leaving && gap < kLeft && gap > -kPressed) {
      kept_[i] = std::min({kept_[i], kTouching, gap - kTouchingGrain});
    } else if (gap >= -kSoft) {
      const double less = std::max(0.5 * gap, gap - (kRoomy - 1.0) * clearance);
      kept_[i] = std::min(kept_[i], less > -kTouching ? less : kTouching);
    }
  }
}

std::vector<Overlap> SegmentCheck::overlaps(const Eigen::VectorXd& q) {
  place(q, q, 0.0, 0.0);
  std::vector<Overlap> all;
  for (std::size_t i = 0; i < scene_.pairs.size(); ++i) {
    const CheckedPair& pair = scene_.pairs[i];
    const Solid &a = pose_->pose.body(pair.a), &b = pose_->pose.body(pair.b);
    if (is_farther(a, b, 0.0)) continue;
    const double gap = gap_between(a, b).distance;
    if (gap < std::min(-kSoft, keep_[i])) all.push_back({.pair = i, .depth = -gap});
  }
  std::ranges::stable_sort(all,
                           [](const Overlap& a, const Overlap& b) { return a.depth > b.depth; });
  return all;
}

SegmentCheck::Answer SegmentCheck::look(std::size_t index) {
  const CheckedPair& pair = scene_.pairs[index];
  const double travel = pose_->pose.travel(pair);
  const double keep = keep_[index], grain = grain_[index];
  const Solid &a = pose_->pose.body(pair.a), &b = pose_->pose.body(pair.b);
  // With a larger gap the bodies cannot come nearer than keep - grain while the points travel.
  const double certain = std::max(keep, keep - grain + travel);
  const double middles = (a.T.translation() - b.T.translation()).norm();
  if (middles - pose_->pose.reach(pair.a) - pose_->pose.reach(pair.b) > certain)
    return Answer::kFree;
  if (keep >= 0.0) {
    if (is_farther(a, b, certain)) return Answer::kFree;
    if (travel <= grain || !is_farther(a, b, keep)) return Answer::kBlocked;
    return Answer::kOpen;
  }
  if (certain >= 0.0 && is_farther(a, b, certain)) return Answer::kFree;
  const double gap = gap_between(a, b).distance;
  if (gap < keep) return Answer::kBlocked;
  return gap >= certain ? Answer::kFree : Answer::kOpen;
}

bool SegmentCheck::is_free(const Eigen::VectorXd& q) { return is_free(q, q); }

// Tests widely spaced configurations first, which finds obstacles early.
bool SegmentCheck::is_free(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1) {
  open_.clear();
  for (std::size_t i = 0; i < scene_.pairs.size(); ++i) open_.push_back(i);
  stretches_.assign({{0.0, 1.0, 0, open_.size()}});
  for (std::size_t next = 0; next < stretches_.size(); ++next) {
    const Stretch at = stretches_[next];
    place(q0, q1, at.t0, at.t1);
    checkpoint(kLookCost + kPairCost * (at.end - at.begin));
    const std::size_t begin = open_.size();
    for (std::size_t i = at.begin; i < at.end; ++i) {
      const std::size_t pair = open_[i];
      const Answer answer = look(pair);
      if (answer == Answer::kBlocked) {
        ++blocked_[pair];
        return false;
      }
      if (answer == Answer::kOpen) open_.push_back(pair);
    }
    if (begin == open_.size()) continue;
    const double middle = 0.5 * (at.t0 + at.t1);
    stretches_.push_back({at.t0, middle, begin, open_.size()});
    stretches_.push_back({middle, at.t1, begin, open_.size()});
  }
  return true;
}

}  // namespace armlet
