#include "mesh/shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "mesh/rays.hpp"
#include "mesh/shell_crossings.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;

// The properties of a shell.
//
// volume   m^3, negative if its triangles face inwards; 0 for a sheet whose two sides are one
//          surface.
// samples  some of its triangles.
// around   shells that contain it.
struct Shell {
  double volume = 0.0;
  std::vector<std::uint32_t> samples{};
  std::vector<std::uint32_t> around{};
};

class ShellCheck {
 public:
  ShellCheck(std::span<const Vector3d> vertices, std::vector<Corners>& triangles,
             const TriangleTree& tree, const Shells& shells)
      : vertices_(vertices), triangles_(triangles), tree_(tree), of_(shells.of) {
    shells_.resize(shells.count);
    const TriangleTree::Node& all = tree.nodes.front();
    middle_ = 0.5 * (all.low + all.high);
    rounding_ = 2e-6 * std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
    weigh();
    choose_samples();
  }

  std::string run() {
    for (std::uint32_t i = 0; i < shells_.size(); ++i) {
      if (shells_[i].volume != 0.0) find_around(i);
    }
    std::string why = turn();
    if (!why.empty() || crosses_) return why.empty() ? crossing_text(crossing_at_) : why;
    std::vector<std::uint32_t> bodies(of_.begin(), of_.end());
    for (std::uint32_t& each : bodies) {
      if (shells_[each].volume == 0.0) each = kNoShell;
    }
    const auto at = find_crossing(vertices_, triangles_, tree_, bodies, rounding_);
    return at ? crossing_text(*at) : std::string();
  }

 private:
  [[nodiscard]] const Vector3d& corner(std::size_t triangle, std::size_t k) const {
    return vertices_[triangles_[triangle][k]];
  }

  static std::string crossing_text(const Vector3d& p) {
    return fmt::format(
        "closed parts of it overlap at ({:.4g}, {:.4g}, {:.4g}) m: the volume that they share "
        "counts more than once",
        p.x(), p.y(), p.z());
  }

  void weigh() {
    std::vector<Vector3d> low(shells_.size(), Vector3d::Constant(1e9)), high(shells_.size());
    for (Vector3d& each : high) each = Vector3d::Constant(-1e9);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      const Vector3d a = corner(i, 0) - middle_, b = corner(i, 1) - middle_,
                     c = corner(i, 2) - middle_;
      shells_[of_[i]].volume += a.dot(b.cross(c)) / 6.0;
      low[of_[i]] = low[of_[i]].cwiseMin(a).cwiseMin(b).cwiseMin(c);
      high[of_[i]] = high[of_[i]].cwiseMax(a).cwiseMax(b).cwiseMax(c);
    }
    for (std::size_t i = 0; i < shells_.size(); ++i) {
      const double size = (high[i] - low[i]).norm();
      if (std::abs(shells_[i].volume) <= 1e-9 * size * size * size) shells_[i].volume = 0.0;
    }
  }

  // Triangles at equal distances in the list; the largest part of a shell is likely among them.
  void choose_samples() {
    constexpr std::size_t kMost = 20'000, kMostOfOne = 24;
    const std::size_t wanted = std::clamp<std::size_t>(kMost / shells_.size(), 1, kMostOfOne);
    std::vector<std::size_t> sizes(shells_.size(), 0), seen(shells_.size(), 0);
    for (const std::uint32_t each : of_) ++sizes[each];
    for (std::uint32_t i = 0; i < of_.size(); ++i) {
      const std::uint32_t shell = of_[i];
      const std::size_t step = std::max<std::size_t>(1, sizes[shell] / wanted);
      if (seen[shell]++ % step == 0) shells_[shell].samples.push_back(i);
    }
  }

  // A point just inside of a shell, next to the centre of one of its triangles.
  [[nodiscard]] std::optional<Vector3d> inner_point(std::uint32_t triangle) const {
    const Vector3d &a = corner(triangle, 0), u = corner(triangle, 1) - a,
                   v = corner(triangle, 2) - a;
    const Vector3d n = u.cross(v);
    if (!(n.norm() > 1e-5 * std::max(u.squaredNorm(), v.squaredNorm()))) return {};
    const double outward = shells_[of_[triangle]].volume > 0.0 ? 1.0 : -1.0;
    return Vector3d(a + (u + v) / 3.0 - outward * rounding_ * n.normalized());
  }

  // The other shells that contain a point.
  [[nodiscard]] std::vector<std::uint32_t> around(const Vector3d& p, std::uint32_t own) const {
    std::map<std::uint32_t, int> windings;
    for (const Vector3d& direction : rays::kDirections) {
      windings.clear();
      const bool doubt = rays::cast(vertices_, triangles_, tree_, p, direction,
                                    [&](std::uint32_t i, int way) { windings[of_[i]] += way; });
      if (!doubt) break;
    }
    std::vector<std::uint32_t> found;
    for (const auto& [shell, winding] : windings) {
      if (winding != 0 && shell != own && shells_[shell].volume != 0.0) found.push_back(shell);
    }
    return found;
  }

  // If two points of a shell give different results, it intersects another one.
  void find_around(std::uint32_t shell) {
    bool is_first = true;
    for (const std::uint32_t sample : shells_[shell].samples) {
      const auto p = inner_point(sample);
      if (!p) continue;
      std::vector<std::uint32_t> found = around(*p, shell);
      if (is_first) {
        shells_[shell].around = std::move(found);
        is_first = false;
        continue;
      }
      if (found == shells_[shell].around) continue;
      if (!crosses_) crossing_at_ = *p;
      crosses_ = true;
      std::erase_if(shells_[shell].around, [&](std::uint32_t each) {
        return std::ranges::find(found, each) == found.end();
      });
    }
  }

  // Begins with the largest shell, so that the shells around a shell are processed before it.
  std::string turn() {
    std::vector<std::uint32_t> order(shells_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) {
      return std::abs(shells_[a].volume) > std::abs(shells_[b].volume);
    });
    std::vector<bool> turned(shells_.size(), false);
    std::size_t doubled = 0;
    double volume = 0.0;
    for (const std::uint32_t i : order) {
      int covered = 0;
      for (const std::uint32_t each : shells_[i].around)
        covered += shells_[each].volume > 0.0 ? 1 : -1;
      if (shells_[i].volume < 0.0 && covered <= 0) {
        turned[i] = true;
        shells_[i].volume = -shells_[i].volume;
      }
      if (!(shells_[i].volume > 0.0) || covered <= 0) continue;
      ++doubled;
      volume += shells_[i].volume;
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      if (turned[of_[i]]) std::swap(triangles_[i][1], triangles_[i][2]);
    }
    if (doubled == 0) return {};
    return fmt::format(
        "{} inside of {} and {} more than once, {:.4g} m^3: the surface of a cavity "
        "would look inwards",
        doubled == 1 ? "a closed part of it lies"
                     : fmt::format("{} closed parts of it lie", doubled),
        doubled == 1 ? "another one" : "others", doubled == 1 ? "counts" : "count", volume);
  }

  std::span<const Vector3d> vertices_;
  std::vector<Corners>& triangles_;
  const TriangleTree& tree_;
  std::span<const std::uint32_t> of_;
  std::vector<Shell> shells_;
  Vector3d middle_ = Vector3d::Zero();
  double rounding_ = 0.0;
  bool crosses_ = false;
  Vector3d crossing_at_ = Vector3d::Zero();
};

}  // namespace

std::string set_shells_right(std::span<const Vector3d> vertices, std::vector<Corners>& triangles,
                             const TriangleTree& tree, const Shells& shells) {
  constexpr std::size_t kMostShells = 5'000;
  if (shells.count > kMostShells) {
    return fmt::format(
        "it has {} closed parts, and of more than {} it is not found out whether some are inside "
        "out or overlap",
        shells.count, kMostShells);
  }
  return ShellCheck(vertices, triangles, tree, shells).run();
}

}  // namespace armlet
