#include "armlet/collision/motion_check.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "collision/motion_cells.hpp"
#include "collision/scene_pose.hpp"

namespace armlet {
namespace {

constexpr double kResolution = 5e-5;  // m
// travel of points between checks, relative to the clearance
constexpr double kGrainOfClearance = 0.05;
constexpr std::uint64_t kPlaceCost = 1'000;  // operations for a pose of the arms
constexpr std::uint64_t kBallsCost = 20;     // the same of a pair whose balls are apart
constexpr std::uint64_t kGapCost = 2'000;    // the same of a distance or a depth
constexpr int kManyLooks = 20'000;           // after that many the resolution becomes coarser
constexpr double kComeApart = 1e-3;          // m, distance from which separating bodies are checked
constexpr int kSamples = 64;                 // of a motion, for depths and for separating bodies
constexpr double kExactDepth = 2e-6;         // m
constexpr int kDepthLooks = 4'000;           // number of poses for refining a depth
constexpr int kMeshLooks = 200;              // the same for bodies whose depths take long
constexpr double kNever = std::numeric_limits<double>::infinity();

class Check {
 public:
  // certifies  whether heights are verified, and depths between samples.
  // keep       clearance of each pair, m; empty: the bodies may touch.
  Check(const MotionScene& scene, bool certifies, std::span<const double> keep = {})
      : scene_(scene),
        keep_(keep),
        certifies_(certifies),
        pose_(scene),
        cells_(scene),
        q_(static_cast<std::size_t>(cells_.joints())),
        travel_(q_.size()),
        from_(scene.pairs.size(), 0.0),
        done_(scene.pairs.size(), false) {}

  std::vector<Nearing> nearings() {
    look_at_all();
    std::vector<Nearing> all;
    for (const Meeting& each : result_.meetings) all.push_back({.pair = each.pair, .t = each.t});
    std::ranges::stable_sort(all, {}, &Nearing::t);
    return all;
  }

  MotionCheck run() {
    find_leaving();
    look_at_all();
    result_.resolution = resolution_;
    for (std::size_t i = 0; i < before_.size(); ++i) {
      bring_forward(result_.meetings[i], before_[i]);
      measure(result_.meetings[i]);
      if (certifies_) certify_height(result_.meetings[i]);
    }
    std::ranges::stable_sort(result_.meetings, {}, &Meeting::t);
    return std::move(result_);
  }

 private:
  void look_at_all() {
    for (std::size_t i = 0; i < scene_.pairs.size(); ++i) open_.push_back(i);
    if (scene_.duration > 0.0) look_at_cells(0, cells_.count(), 0, open_.size());
  }

  // Pairs [begin, end) of open_ are those that are not excluded for the cells.
  void look_at_cells(int first, int last, std::size_t begin, std::size_t end) {
    if (last - first == 1) {
      const auto curves = cells_.curves(first);
      std::vector<JointCurve> own(curves.begin(), curves.end());
      look_at(cells_.start(first), cells_.start(last), own, begin, end);
      return;
    }
    for (std::size_t j = 0; j < q_.size(); ++j) {
      JointCurve::Range all{kNever, -kNever};
      for (int cell = first; cell < last; ++cell) {
        const JointCurve::Range range = cells_.curves(cell)[j].range();
        all = {std::min(all.lower, range.lower), std::max(all.upper, range.upper)};
      }
      q_[j] = 0.5 * (all.lower + all.upper);
      travel_[j] = std::max(all.upper - q_[j], q_[j] - all.lower);
    }
    place(end - begin);
    const std::size_t kept = open_.size();
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t pair = open_[i];
      if (!done_[pair] && !is_free(pair, pose_.travel(scene_.pairs[pair]))) open_.push_back(pair);
    }
    const std::size_t kept_end = open_.size();
    if (kept != kept_end) {
      const int middle = (first + last) / 2;
      look_at_cells(first, middle, kept, kept_end);
      look_at_cells(middle, last, kept, kept_end);
    }
    open_.resize(kept);
  }

  // Checks an interval of time in which all joints follow one polynomial each.
  void look_at(double t0, double t1, std::vector<JointCurve>& curves, std::size_t begin,
               std::size_t end) {
    const double middle = 0.5 * (t0 + t1);
    std::vector<JointCurve> second(curves.size());
    for (std::size_t j = 0; j < curves.size(); ++j) {
      const JointCurve::Range range = curves[j].range();
      q_[j] = curves[j].halve(second[j]);
      travel_[j] = std::max({range.upper - q_[j], q_[j] - range.lower, 0.0});
    }
    place(end - begin);
    const std::size_t kept = open_.size();
    for (std::size_t i = begin; i < end; ++i) look_at_pair(open_[i], t0, t1);
    const std::size_t kept_end = open_.size();
    if (kept != kept_end) {
      look_at(t0, middle, curves, kept, kept_end);
      look_at(middle, t1, second, kept, kept_end);
    }
    open_.resize(kept);
  }

  void look_at_pair(std::size_t index, double t0, double t1) {
    const CheckedPair& pair = scene_.pairs[index];
    if (done_[index] || t1 <= from_[index]) return;
    const double travel = pose_.travel(pair);
    if (is_free(index, travel)) return;
    if (travel >= (keep_.empty() ? resolution_ : kGrainOfClearance * keep_[index])) {
      open_.push_back(index);
      return;
    }
    if (keep_.empty() && (t0 < from_[index] || gap_of(pair).distance >= -kSoft)) return;
    done_[index] = true;
    result_.meetings.push_back({.pair = index, .t = 0.5 * (t0 + t1)});
    before_.push_back(t0);
  }

  void place(std::size_t pairs) {
    pose_.place(q_, travel_);
    checkpoint(kPlaceCost + kBallsCost * pairs);
    if (++result_.looks % kManyLooks == 0) resolution_ *= 2.0;
  }

  // Whether the pair keeps its clearance, or only touches, if no point travels farther.
  bool is_free(std::size_t index, double travel) {
    const CheckedPair& pair = scene_.pairs[index];
    const double keep = keep_.empty() ? -kSoft : keep_[index];
    const Solid &a = pose_.body(pair.a), &b = pose_.body(pair.b);
    const double middles = (a.T.translation() - b.T.translation()).norm();
    const double wanted = travel + keep;
    if (middles - pose_.reach(pair.a) - pose_.reach(pair.b) > std::max(wanted, travel)) return true;
    if (middles < wanted) return false;
    return wanted >= 0.0 ? is_farther(a, b, wanted) : gap_between(a, b).distance > wanted;
  }

  Gap gap_of(const CheckedPair& pair) {
    checkpoint(kGapCost);
    return gap_between(pose_.body(pair.a), pose_.body(pair.b));
  }

  void place_at(double t) {
    std::size_t j = 0;
    for (const ArmInMotion& arm : scene_.arms) {
      for (int i = 0; i < arm.robot->n(); ++i) q_[j++] = arm.motion->value(i, arm.from + t);
    }
    std::fill(travel_.begin(), travel_.end(), 0.0);
    pose_.place(q_, travel_);
  }

  // Finds pairs that may touch at the start; for most pairs their bounding balls exclude it.
  void find_leaving() {
    const double first = scene_.duration * 1 / kSamples;
    std::vector<std::size_t> near;
    place_at(first);
    for (std::size_t i = 0; i < scene_.pairs.size(); ++i) {
      const CheckedPair& pair = scene_.pairs[i];
      if (!pair.leaving) continue;
      const double middles =
          (pose_.body(pair.a).T.translation() - pose_.body(pair.b).T.translation()).norm();
      if (middles - pose_.reach(pair.a) - pose_.reach(pair.b) > 2.0 * kComeApart) {
        from_[i] = first;
      } else {
        near.push_back(i);
      }
    }
    for (const std::size_t i : near) from_[i] = leaves_at(i);
  }

  double leaves_at(std::size_t index) {
    const CheckedPair& pair = scene_.pairs[index];
    place_at(0.0);
    const double at_start = gap_of(pair).distance;
    if (at_start < -kPressed) return 0.0;
    const double deepest = std::min(at_start, 0.0) - kComeApart;
    for (int k = 1; k <= kSamples; ++k) {
      const double t = scene_.duration * k / kSamples;
      place_at(t);
      const double distance = gap_of(pair).distance;
      if (distance > kComeApart || distance < deepest) return t;
    }
    return kNever;
  }

  // Finds the instant at which an overlap begins, which is not before t0.
  void bring_forward(Meeting& meeting, double t0) {
    constexpr int kHalvings = 40;
    const auto overlaps = [&](double t) {
      place_at(t);
      return gap_of(scene_.pairs[meeting.pair]).distance < -kSoft;
    };
    double t = t0;
    for (int k = 0; k < kHalvings && !overlaps(t); ++k) t = 0.5 * (t + meeting.t);
    if (t < meeting.t) meeting.t = t;
  }

  // Number of samples such that the first body moves at most a few millimetres between two.
  int samples_from(double t0, const CheckedPair& pair) {
    constexpr double kStep = 0.005;  // m
    constexpr int kMostSamples = 1000;
    double way = 0.0;
    Eigen::Isometry3d T;
    for (int k = 0; k <= kSamples; ++k) {
      place_at(t0 + (scene_.duration - t0) * k / kSamples);
      const Eigen::Isometry3d& now = pose_.body(pair.a).T;
      if (k > 0) {
        way += (now.translation() - T.translation()).norm() +
               (now.linear() - T.linear()).norm() * pose_.reach(pair.a);
      }
      T = now;
    }
    return static_cast<int>(std::clamp(way / kStep, double{kSamples}, double{kMostSamples}));
  }

  // Measures the depth from the collision on, and the height that would avoid it.
  void measure(Meeting& meeting) {
    const CheckedPair& pair = scene_.pairs[meeting.pair];
    const int samples = samples_from(meeting.t, pair);
    for (int k = 0; k <= samples; ++k) {
      const double t = meeting.t + (scene_.duration - meeting.t) * k / samples;
      place_at(t);
      const Gap gap = gap_of(pair);
      if (gap.distance >= -kSoft) continue;
      meeting.at_end = k == samples;
      if (meeting.higher >= 0.0) raise(meeting, pair);
      if (-gap.distance > meeting.depth) take_depth(meeting, gap, t);
    }
    if (!(meeting.depth > 0.0)) return;
    if (certifies_) search_deepest(meeting, pair);
    place_at(meeting.t_deepest);
    meeting.at_least = !has_whole_depth(pair);
  }

  bool has_whole_depth(const CheckedPair& pair) {
    return is_whole_depth(pose_.body(pair.a), pose_.body(pair.b), gap_of(pair));
  }

  // A half of an interval of the motion.
  //
  // most  bound on the depth in it, m.
  struct Stretch {
    double t0, t1, most;
    std::vector<JointCurve> first, second;
  };

  // Checks the middle of an interval, and keeps the interval in `open` if it may contain a larger
  // depth: a depth changes by no more than points travel.
  void look_for_depth(double t0, double t1, std::vector<JointCurve> curves, Meeting& meeting,
                      std::vector<Stretch>& open) {
    if (t1 <= meeting.t) return;
    const CheckedPair& pair = scene_.pairs[meeting.pair];
    Stretch stretch{t0, t1, 0.0, std::move(curves), {}};
    stretch.second.resize(stretch.first.size());
    for (std::size_t j = 0; j < stretch.first.size(); ++j) {
      const JointCurve::Range range = stretch.first[j].range();
      q_[j] = stretch.first[j].halve(stretch.second[j]);
      travel_[j] = std::max({range.upper - q_[j], q_[j] - range.lower, 0.0});
    }
    pose_.place(q_, travel_);
    const double travel = pose_.travel(pair), t = 0.5 * (t0 + t1);
    const Solid &a = pose_.body(pair.a), &b = pose_.body(pair.b);
    const double middles = (a.T.translation() - b.T.translation()).norm();
    if (middles - pose_.reach(pair.a) - pose_.reach(pair.b) > travel - meeting.depth) return;
    const Gap gap = gap_of(pair);
    if (t >= meeting.t && -gap.distance > meeting.depth) take_depth(meeting, gap, t);
    stretch.most = travel - gap.distance;
    if (stretch.most > meeting.depth + kExactDepth) push(open, std::move(stretch));
  }

  static void take_depth(Meeting& meeting, const Gap& gap, double t) {
    meeting.depth = -gap.distance;
    meeting.t_deepest = t;
    meeting.p_world = 0.5 * (gap.p_a + gap.p_b);
  }

  // Order of a heap with the interval of the largest possible depth in front.
  static bool is_less(const Stretch& a, const Stretch& b) {
    return a.most != b.most ? a.most < b.most : a.t0 > b.t0;
  }
  static void push(std::vector<Stretch>& open, Stretch stretch) {
    open.push_back(std::move(stretch));
    std::push_heap(open.begin(), open.end(), is_less);
  }

  // Refines the deepest sample to the maximum. If bodies stay equally deep for long, the search
  // ends with an upper bound.
  void search_deepest(Meeting& meeting, const CheckedPair& pair) {
    place_at(meeting.t_deepest);
    const bool is_whole = has_whole_depth(pair);
    std::vector<Stretch> open;
    for (int cell = 0; cell < cells_.count(); ++cell) {
      const auto curves = cells_.curves(cell);
      look_for_depth(cells_.start(cell), cells_.start(cell + 1), {curves.begin(), curves.end()},
                     meeting, open);
    }
    for (int looks = 0; !open.empty(); looks += 2) {
      std::pop_heap(open.begin(), open.end(), is_less);
      Stretch stretch = std::move(open.back());
      open.pop_back();
      if (stretch.most <= meeting.depth + kExactDepth) return;
      if (looks >= (is_whole ? kDepthLooks : kMeshLooks)) {
        if (is_whole && stretch.most > meeting.depth + kSoft) meeting.depth = stretch.most;
        return;
      }
      const double middle = 0.5 * (stretch.t0 + stretch.t1);
      look_for_depth(stretch.t0, middle, std::move(stretch.first), meeting, open);
      look_for_depth(middle, stretch.t1, std::move(stretch.second), meeting, open);
    }
  }

  // Raises the height that clears the second body until it does so here as well.
  void raise(Meeting& meeting, const CheckedPair& pair) {
    constexpr double kHighest = 1.0;  // m
    constexpr double kExact = 1e-4;   // m
    const Solid b = pose_.body(pair.b);
    const auto clears = [&](double height) {
      Solid raised = pose_.body(pair.a);
      raised.T.translation().z() += height;
      return is_farther(raised, b, 0.0);
    };
    if (clears(meeting.higher)) return;
    double low = meeting.higher, high = std::max(2.0 * low, 1e-3);
    while (high < kHighest && !clears(high)) {
      low = high;
      high *= 2.0;
    }
    if (high >= kHighest) {
      meeting.higher = -1.0;
      return;
    }
    while (high - low > kExact) {
      const double middle = 0.5 * (low + high);
      (clears(middle) ? high : low) = middle;
    }
    meeting.higher = high;
  }

  // The height was found at samples. Passing higher by some amount is the same as passing the other
  // body lowered by it: remaining collisions there increase the height.
  void certify_height(Meeting& meeting) const {
    constexpr int kRounds = 20;
    constexpr double kLeast = 1e-4;  // m
    const CheckedPair& pair = scene_.pairs[meeting.pair];
    if (meeting.higher <= 0.0 || pair.b.arm != BodyRef::kFixed) return;
    MotionScene lower{.arms = scene_.arms,
                      .fixed = {scene_.fixed[static_cast<std::size_t>(pair.b.index)]},
                      .pairs = {{.a = pair.a, .b = {BodyRef::kFixed, 0}, .leaving = pair.leaving}},
                      .duration = scene_.duration};
    const double z = lower.fixed[0].T.translation().z();
    for (int round = 0; round < kRounds && meeting.higher >= 0.0; ++round) {
      lower.fixed[0].T.translation().z() = z - meeting.higher;
      const MotionCheck check = Check(lower, false).run();
      if (check.meetings.empty()) return;
      const double more = check.meetings[0].higher;
      meeting.higher = more < 0.0 ? -1.0 : meeting.higher + std::max(more, kLeast);
    }
    meeting.higher = -1.0;  // no certain height
  }

  const MotionScene& scene_;
  std::span<const double> keep_;
  bool certifies_;
  ScenePose pose_;
  MotionCells cells_;
  std::vector<double> q_, travel_;
  std::vector<double> from_;  // the instant from which each pair is checked
  std::vector<bool> done_;
  std::vector<double> before_;  // instants just before the collisions
  std::vector<std::size_t> open_;
  double resolution_ = kResolution;
  MotionCheck result_;
};

}  // namespace

MotionCheck check_motion(const MotionScene& scene) { return Check(scene, true).run(); }

std::vector<Nearing> check_clearances(const MotionScene& scene, std::span<const double> keep) {
  check_size("keep", std::ssize(keep), std::ssize(scene.pairs));
  if (keep.empty()) return {};
  return Check(scene, false, keep).nearings();
}

}  // namespace armlet
