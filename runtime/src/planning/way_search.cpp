#include "armlet/planning/way_search.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/math/check_finite.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "planning/sampling_door.hpp"

namespace armlet {
namespace {

using Eigen::VectorXd;
using Points = std::vector<VectorXd>;

constexpr std::uint64_t kSeed = 20'001;
constexpr double kLongest = 0.2;  // of the diagonal of the box, largest length of an edge of a tree
constexpr double kFreeRange = std::numbers::pi;  // range of joints without limits beyond the ends
constexpr std::uint64_t kStepCost = 2'000;       // operations of a step without its checks

SearchBySampling sampling_search() {
  static const auto found = []() -> SearchBySampling {
    for (const std::string& folder : {program_folder() + "/../lib/", program_folder() + '/', {}}) {
      const LoadedLibrary library(folder + kSamplingLibrary);
      if (void* const symbol = library.find(kSearchBySampling))
        return reinterpret_cast<SearchBySampling>(symbol);
    }
    return nullptr;
  }();
  return found;
}

// Joint values as lengths: a revolute joint is multiplied by the length of the arm beyond it, so
// that distances approximate the motion of the arm.
class Lengths {
 public:
  Lengths(const Robot& robot, const VectorXd& start, const Points& goals)
      : scale_(VectorXd::Zero(robot.n())), lower_(robot.n()), upper_(robot.n()) {
    const auto frames = link_frames(robot, start);
    double reach = 0.0;
    for (int i = robot.rows() - 1; i >= 0; --i) {
      const Eigen::Vector3d from = i > 0 ? frames[static_cast<std::size_t>(i - 1)].translation()
                                         : Eigen::Vector3d(robot.T_world_base().translation());
      reach += (frames[static_cast<std::size_t>(i)].translation() - from).norm();
      // The rows of one joint are combined.
      const auto [joint, ratio] = motion_of_row(robot, i);
      scale_[joint] +=
          std::abs(ratio) * (robot.row(i).is_revolute() ? std::max(reach, kLeastReach) : 1.0);
    }
    for (int i = 0; i < robot.n(); ++i) {
      double low = start[i], high = start[i];
      for (const VectorXd& goal : goals) {
        low = std::min(low, goal[i]);
        high = std::max(high, goal[i]);
      }
      const Joint& joint = robot.joint(i);
      const bool has_limits = !joint.is_continuous();
      lower_[i] =
          has_limits && std::isfinite(joint.lower) ? std::min(low, joint.lower) : low - kFreeRange;
      upper_[i] = has_limits && std::isfinite(joint.upper) ? std::max(high, joint.upper)
                                                           : high + kFreeRange;
    }
  }

  [[nodiscard]] int n() const { return static_cast<int>(scale_.size()); }
  [[nodiscard]] VectorXd lower() const { return of(lower_); }
  [[nodiscard]] VectorXd upper() const { return of(upper_); }
  [[nodiscard]] VectorXd of(const VectorXd& q) const { return q.cwiseProduct(scale_); }
  [[nodiscard]] VectorXd joints(const double* x) const {
    return Eigen::Map<const VectorXd>(x, scale_.size()).cwiseQuotient(scale_);
  }
  // The distance of two configurations.
  [[nodiscard]] double distance(const VectorXd& a, const VectorXd& b) const {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      const double way = (b[i] - a[i]) * scale_[i];
      sum += way * way;
    }
    return std::sqrt(sum);
  }

 private:
  static constexpr double kLeastReach = 0.05;  // m, of the last joints
  VectorXd scale_, lower_, upper_;
};

// The callbacks of the search; an exception of a checkpoint is kept until the search has ended.
class Asked {
 public:
  Asked(SegmentCheck& check, const Lengths& lengths, int iterations)
      : check_(check), lengths_(lengths), left_(iterations) {}

  bool run(SearchBySampling search, const VectorXd& start, const Points& goals) {
    const VectorXd lower = lengths_.lower(), upper = lengths_.upper(), x = lengths_.of(start);
    std::vector<double> all;
    for (const VectorXd& goal : goals) {
      const VectorXd each = lengths_.of(goal);
      all.insert(all.end(), each.data(), each.data() + each.size());
    }
    const SamplingSearch asked{
        .n = lengths_.n(),
        .lower = lower.data(),
        .upper = upper.data(),
        .start = x.data(),
        .goal_count = static_cast<int>(goals.size()),
        .goals = all.data(),
        .longest = kLongest * (upper - lower).norm(),
        .context = this,
        .sample = [](void* self, double* to) { static_cast<Asked*>(self)->sample(to); },
        .is_free = [](void* self,
                      const double* at) { return static_cast<Asked*>(self)->is_free(at, at); },
        .is_free_between =
            [](void* self, const double* from, const double* to) {
              return static_cast<Asked*>(self)->is_free(from, to);
            },
        .go_on = [](void* self) { return static_cast<Asked*>(self)->go_on(); },
        .found = [](void* self, const double* at) { static_cast<Asked*>(self)->found(at); }};
    const bool solved = search(&asked);
    if (stopped_ != nullptr) std::rethrow_exception(stopped_);
    return solved;
  }

  [[nodiscard]] int spent() const { return spent_; }
  [[nodiscard]] const Points& points() const { return points_; }

 private:
  void sample(double* to) {
    const VectorXd lower = lengths_.lower(), upper = lengths_.upper();
    for (int i = 0; i < lengths_.n(); ++i)
      to[i] = lower[i] + random_.uniform() * (upper[i] - lower[i]);
  }
  bool is_free(const double* from, const double* to) {
    if (stopped_ != nullptr) return false;
    try {
      return check_.is_free(lengths_.joints(from), lengths_.joints(to));
    } catch (...) {
      stopped_ = std::current_exception();
      return false;
    }
  }
  bool go_on() {
    if (stopped_ != nullptr || left_ == 0) return false;
    --left_;
    ++spent_;
    try {
      checkpoint(kStepCost + 4 * static_cast<std::uint64_t>(spent_));
    } catch (...) {
      stopped_ = std::current_exception();
      return false;
    }
    return true;
  }
  void found(const double* at) { points_.push_back(lengths_.joints(at)); }

  SegmentCheck& check_;
  const Lengths& lengths_;
  Random random_{kSeed};
  int left_;
  int spent_ = 0;
  Points points_;
  std::exception_ptr stopped_;
};

// Replaces the part between two random points of the path by a straight segment if that is free;
// then removes corners that are not needed.
class Shortener {
 public:
  Shortener(SegmentCheck& check, const Lengths& lengths, Points points)
      : check_(check), lengths_(lengths), points_(std::move(points)) {}

  Points shorten(int shortcuts) {
    leave_out_corners();
    for (int k = 0; k < shortcuts && points_.size() > 2; ++k) {
      cut_once();
      if (k % kOften == kOften - 1) leave_out_corners();
    }
    leave_out_corners();
    return std::move(points_);
  }

 private:
  static constexpr int kOften = 20;

  struct At {
    std::size_t piece;  // from points_[piece] to the next
    VectorXd q;
  };

  [[nodiscard]] At at(double length) const {
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
      const double piece = lengths_.distance(points_[k], points_[k + 1]);
      if (length <= piece && piece > 0.0)
        return {k, points_[k] + length / piece * (points_[k + 1] - points_[k])};
      length -= piece;
    }
    return {points_.size() - 2, points_.back()};
  }

  void cut_once() {
    double whole = 0.0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k)
      whole += lengths_.distance(points_[k], points_[k + 1]);
    const double first = whole * random_.uniform(), second = whole * random_.uniform();
    const At a = at(std::min(first, second)), b = at(std::max(first, second));
    if (a.piece == b.piece || !check_.is_free(a.q, b.q)) return;
    Points shorter(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(a.piece) + 1);
    shorter.push_back(a.q);
    shorter.push_back(b.q);
    shorter.insert(shorter.end(), points_.begin() + static_cast<std::ptrdiff_t>(b.piece) + 1,
                   points_.end());
    points_ = std::move(shorter);
    drop_repeated();
  }

  void leave_out_corners() {
    for (std::size_t k = 1; k + 1 < points_.size();) {
      if (check_.is_free(points_[k - 1], points_[k + 1])) {
        points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
    drop_repeated();
  }

  void drop_repeated() {
    constexpr double kSame = 1e-6;  // m
    for (std::size_t k = 1; k + 1 < points_.size();) {
      const bool repeats = lengths_.distance(points_[k - 1], points_[k]) < kSame &&
                           check_.is_free(points_[k - 1], points_[k + 1]);
      if (repeats) {
        points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
  }

  SegmentCheck& check_;
  const Lengths& lengths_;
  Points points_;
  Random random_{kSeed + 1};
};

void check_arguments(const MotionScene& scene, const VectorXd& start, const Points& goals,
                     const WayOptions& options) {
  if (scene.arms.empty()) throw ArgumentError("A way needs an arm.");
  if (goals.empty()) throw ArgumentError("A way needs a goal.");
  const int n = scene.arms[0].robot->n();
  check_size("start", start.size(), n);
  check_finite("start", start);
  for (const VectorXd& goal : goals) {
    check_size("goals", goal.size(), n);
    check_finite("goals", goal);
  }
  if (!(options.clearance > 0.0) || options.iterations < 1 || options.shortcuts < 0)
    throw ArgumentError("The clearance and the iterations of a search are above zero.");
}

std::vector<InTheWay> most_often(const std::vector<std::uint64_t>& blocked) {
  std::vector<InTheWay> all;
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    if (blocked[i] > 0) all.push_back({.pair = i, .times = blocked[i]});
  }
  std::ranges::stable_sort(all,
                           [](const InTheWay& a, const InTheWay& b) { return a.times > b.times; });
  return all;
}

}  // namespace

bool can_search_ways() { return sampling_search() != nullptr; }

Way search_way(const MotionScene& scene, const VectorXd& start, const Points& goals,
               const WayOptions& options) {
  check_arguments(scene, start, goals, options);
  Points ends = goals;
  ends.push_back(start);
  SegmentCheck check(scene, options.clearance, ends);
  Way way{.overlaps = check.overlaps(start), .kept = check.kept()};
  if (!way.overlaps.empty()) {
    way.status = WayStatus::kStartCollides;
    return way;
  }
  Points free;
  std::vector<int> index;  // of `goals`
  for (std::size_t k = 0; k < goals.size(); ++k) {
    std::vector<Overlap> overlaps = check.overlaps(goals[k]);
    if (overlaps.empty()) {
      free.push_back(goals[k]);
      index.push_back(static_cast<int>(k));
    } else if (k == 0) {
      way.overlaps = std::move(overlaps);
    }
  }
  if (free.empty()) {
    way.status = WayStatus::kGoalCollides;
    return way;
  }
  way.overlaps.clear();
  for (std::size_t k = 0; k < free.size(); ++k) {
    if (!check.is_free(start, free[k])) continue;
    way.status = WayStatus::kFound;
    way.points = {start, free[k]};
    way.goal = index[k];
    return way;
  }
  const SearchBySampling search = sampling_search();
  if (search == nullptr) {
    way.status = WayStatus::kCannotSearch;
    way.in_the_way = most_often(check.blocked());
    return way;
  }
  const Lengths lengths(*scene.arms[0].robot, start, free);
  Asked asked(check, lengths, options.iterations);
  const bool found = asked.run(search, start, free);
  way.iterations = asked.spent();
  way.in_the_way = most_often(check.blocked());
  if (!found) return way;
  way.status = WayStatus::kFound;
  // Scaling back and forth changes the ends by rounding; the exact ones are restored.
  Points points = asked.points();
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < free.size(); ++k) {
    if ((free[k] - points.back()).norm() < (free[nearest] - points.back()).norm()) nearest = k;
  }
  points.front() = start;
  points.back() = free[nearest];
  way.goal = index[nearest];
  way.points = Shortener(check, lengths, std::move(points)).shorten(options.shortcuts);
  return way;
}

}  // namespace armlet
