#include "armlet/collision/own_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "collision/table_axes.hpp"

namespace armlet {
namespace {

// Joint values within the limits; a joint without limits rotates within a revolution or slides by
// the length of the arm.
void random_position(const Robot& robot, Random& random, Eigen::VectorXd& q) {
  for (int i = 0; i < robot.n(); ++i) {
    const double most = robot.is_revolute(i) ? std::numbers::pi : robot.length();
    double low = robot.lower()[i], high = robot.upper()[i];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      low = std::isfinite(low) ? low : std::isfinite(high) ? high - 2.0 * most : -most;
      high = std::isfinite(high) ? high : low + 2.0 * most;
    }
    q[i] = random.uniform(low, high);
  }
}

// Pairs of bodies of two links that are exempt or checked together.
struct PairCandidate {
  LinkPair links;
  std::vector<std::pair<int, int>> bodies;
  int free = 0;  // configurations in which none of them overlaps
};

class OwnPairSearch {
 public:
  OwnPairSearch(const Robot& robot, const std::vector<ArmSolid>& bodies)
      : robot_(robot), bodies_(bodies), frames_(static_cast<std::size_t>(robot.rows())) {
    of_link_.resize(static_cast<std::size_t>(robot.rows()) + 1);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      of_link_[static_cast<std::size_t>(bodies[i].frame)].push_back(static_cast<int>(i));
      placed_.push_back(bodies[i].solid);
      reach_.push_back(bodies[i].solid.reach());
    }
  }

  void run() {
    for (int a = 1; a <= robot_.rows(); ++a) {
      for (int b = 0; b < a; ++b) sort_in({a, b});
    }
    try_positions();
    for (const PairCandidate& each : candidates_) {
      if (is_exempt(each)) {
        add_exempt(each.links, ExemptReason::kOverlap,
                   1.0 - static_cast<double>(each.free) / OwnPairs::kPositions);
      } else {
        compared_.insert(compared_.end(), each.bodies.begin(), each.bodies.end());
      }
    }
    std::ranges::sort(compared_);
    for (ExemptPair& each : exempt_) each.whole = !is_compared(each.links);
    std::ranges::stable_sort(exempt_, [](const ExemptPair& a, const ExemptPair& b) {
      return std::pair(a.links, a.reason) < std::pair(b.links, b.reason);
    });
  }

  std::vector<std::pair<int, int>> take_compared() { return std::move(compared_); }
  std::vector<ExemptPair> take_exempt() { return std::move(exempt_); }

 private:
  [[nodiscard]] const std::vector<int>& of_link(int link) const {
    return of_link_[static_cast<std::size_t>(link)];
  }
  [[nodiscard]] const ArmSolid& body(int i) const { return bodies_[static_cast<std::size_t>(i)]; }

  static bool has(const std::vector<LinkPair>& pairs, LinkPair links) {
    return std::ranges::find(pairs, links) != pairs.end();
  }

  void sort_in(LinkPair links) {
    const std::vector<int>&first = of_link(links.first), &second = of_link(links.second);
    if (first.empty() || second.empty()) return;
    PairCandidate given{.links = links, .bodies = {}};
    for (const int a : first) {
      for (const int b : second) {
        const bool are_given = body(a).given && body(b).given;
        if (has(robot_.spec().watch, links)) {
          compared_.emplace_back(a, b);
        } else if (const auto reason = reason_of(links, are_given)) {
          add_exempt(links, *reason, 0.0);
        } else if (are_given) {
          given.bodies.emplace_back(a, b);
        } else {
          candidates_.push_back({.links = links, .bodies = {{a, b}}});
        }
      }
    }
    if (!given.bodies.empty()) candidates_.push_back(std::move(given));
  }

  // The reason that exempts two links in all configurations.
  [[nodiscard]] std::optional<ExemptReason> reason_of(LinkPair links, bool are_given) const {
    if (has(robot_.spec().allow, links)) return ExemptReason::kAllowed;
    const auto [a, b] = links;
    if (are_given) {
      for (int link = b + 1; link < a; ++link) {
        if (!of_link(link).empty()) return std::nullopt;
      }
      return ExemptReason::kAdjacent;
    }
    if (b >= first_on_axis(robot_.uncoupled(), a) - 1) return ExemptReason::kAdjacent;
    if (may_be_side_by_side(robot_.uncoupled(), b, a)) return ExemptReason::kSideBySide;
    return std::nullopt;
  }

  void add_exempt(LinkPair links, ExemptReason reason, double share) {
    const auto known = std::ranges::find_if(exempt_, [&](const ExemptPair& each) {
      return each.links == links && each.reason == reason;
    });
    if (known == exempt_.end()) {
      exempt_.push_back({.links = links, .reason = reason, .share = share});
    } else {
      known->share = std::max(known->share, share);
    }
  }

  static bool is_exempt(const PairCandidate& candidate) {
    return candidate.free <= (1.0 - OwnPairs::kNearlyAll) * OwnPairs::kPositions;
  }

  // A pair is decided as soon as it was free too often; most pairs are decided soon.
  void try_positions() {
    std::vector<std::size_t> open(candidates_.size());
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
    Random random(0x61726d6c6574);
    Eigen::VectorXd q(robot_.n());
    for (int k = 0; k < OwnPairs::kPositions && !open.empty(); ++k) {
      random_position(robot_, random, q);
      place(q);
      std::erase_if(open, [&](std::size_t i) {
        PairCandidate& each = candidates_[i];
        if (!overlaps(each)) ++each.free;
        return !is_exempt(each);
      });
    }
  }

  void place(const Eigen::VectorXd& q) {
    (void)link_frames(robot_, q, frames_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const int k = bodies_[i].frame;
      placed_[i].T = (k == 0 ? robot_.T_world_base() : frames_[static_cast<std::size_t>(k - 1)]) *
                     bodies_[i].solid.T;
    }
  }

  [[nodiscard]] bool overlaps(const PairCandidate& candidate) const {
    return std::ranges::any_of(candidate.bodies, [&](const std::pair<int, int>& pair) {
      const auto a = static_cast<std::size_t>(pair.first),
                 b = static_cast<std::size_t>(pair.second);
      const double most = reach_[a] + reach_[b];
      if ((placed_[a].T.translation() - placed_[b].T.translation()).squaredNorm() > most * most)
        return false;
      return !is_farther(placed_[a], placed_[b], 0.0);
    });
  }

  [[nodiscard]] bool is_compared(LinkPair links) const {
    return std::ranges::any_of(compared_, [&](const std::pair<int, int>& pair) {
      return LinkPair(body(pair.first).frame, body(pair.second).frame) == links;
    });
  }

  const Robot& robot_;
  const std::vector<ArmSolid>& bodies_;
  std::vector<Eigen::Isometry3d> frames_;
  std::vector<Solid> placed_;
  std::vector<double> reach_;
  std::vector<std::vector<int>> of_link_;  // bodies of each link
  std::vector<PairCandidate> candidates_;
  std::vector<std::pair<int, int>> compared_;
  std::vector<ExemptPair> exempt_;
};

}  // namespace

OwnPairs::OwnPairs(const Robot& robot) {
  OwnPairSearch search(robot, robot.derived<ArmSolids>().slim());
  search.run();
  pairs_ = search.take_compared();
  exempt_ = search.take_exempt();
}

std::string link_text(const Robot& robot, int link) {
  const std::vector<std::string>& names = robot.body(link).names;
  const std::string number = link == 0 ? "the base" : fmt::format("link {}", link);
  return names.empty() ? number : fmt::format("{} (`{}`)", number, names.front());
}

int link_of_name(const Robot& robot, std::string_view name) {
  for (int link = 0; link <= robot.rows(); ++link) {
    const std::vector<std::string>& names = robot.body(link).names;
    if (std::ranges::find(names, name) != names.end()) return link;
  }
  for (int link = 0; link <= robot.rows(); ++link) {
    if (name == (link == 0 ? std::string("base") : fmt::format("link {}", link))) return link;
  }
  return -1;
}

}  // namespace armlet
