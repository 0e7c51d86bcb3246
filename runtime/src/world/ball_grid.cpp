#include "armlet/world/ball_grid.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace armlet {
namespace {

using Eigen::Vector3d;

constexpr int kFinest = -20;      // cubes of a micrometre
constexpr double kMargin = 1e-9;  // of a distance, for rounding

int level_of(double radius) {
  int exponent = 0;
  (void)std::frexp(2.0 * radius, &exponent);  // 2 radius < 2^exponent
  return radius > 0.0 ? std::max(exponent, kFinest) : kFinest;
}

}  // namespace

std::size_t BallGrid::CellHash::operator()(const Cell& cell) const {
  std::uint64_t value = 0x9e3779b97f4a7c15;
  for (const std::int64_t each : cell) {
    value = (value ^ static_cast<std::uint64_t>(each)) * 0xbf58476d1ce4e5b9;
    value ^= value >> 31;
  }
  return static_cast<std::size_t>(value);
}

BallGrid::Cell BallGrid::cell_of(const Vector3d& p, double width) const {
  Cell cell{};
  for (int k = 0; k < (space_ == Space::kWhole ? 3 : 2); ++k)
    cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(p[k] / width));
  return cell;
}

void BallGrid::put(std::uint32_t id, const Vector3d& middle, double radius) {
  const int level = level_of(radius);
  const Cell cell = cell_of(middle, std::ldexp(1.0, level));
  const auto known = balls_.find(id);
  if (known != balls_.end() && known->second.level == level && known->second.cell == cell) {
    known->second.middle = middle;
    known->second.radius = radius;
    return;
  }
  take(id);
  balls_.insert_or_assign(id, Ball{middle, radius, level, cell});
  Level& at = levels_[level];
  at.cells[cell].push_back(id);
  ++at.count;
}

void BallGrid::take(std::uint32_t id) {
  const auto ball = balls_.find(id);
  if (ball == balls_.end()) return;
  const auto level = levels_.find(ball->second.level);
  const auto cell = level->second.cells.find(ball->second.cell);
  std::erase(cell->second, id);
  if (cell->second.empty()) level->second.cells.erase(cell);
  if (--level->second.count == 0) levels_.erase(level);
  balls_.erase(ball);
}

bool BallGrid::touches(std::uint32_t id, const Vector3d& middle, double radius) const {
  const Ball& ball = balls_.at(id);
  Vector3d apart = ball.middle - middle;
  if (space_ == Space::kColumns) apart.z() = 0.0;
  return apart.norm() <= (ball.radius + radius) * (1.0 + kMargin);
}

// Where a query covers more cubes than there are balls, all balls of the level are looked at.
void BallGrid::find_in(const Level& level, double width, const Vector3d& middle, double radius,
                       std::vector<std::uint32_t>& found) const {
  const auto look = [&](const std::vector<std::uint32_t>& ids) {
    for (const std::uint32_t id : ids) {
      if (touches(id, middle, radius)) found.push_back(id);
    }
  };
  const Vector3d around = Vector3d::Constant((radius + 0.5 * width) * (1.0 + kMargin));
  const Cell low = cell_of(middle - around, width), high = cell_of(middle + around, width);
  double cubes = 1.0;
  for (std::size_t k = 0; k < 3; ++k) cubes *= static_cast<double>(high[k] - low[k]) + 1.0;
  if (cubes > static_cast<double>(level.cells.size())) {
    for (const auto& [cell, ids] : level.cells) look(ids);
    return;
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto cell = level.cells.find({x, y, z});
        if (cell != level.cells.end()) look(cell->second);
      }
    }
  }
}

std::vector<std::uint32_t> BallGrid::touching(const Vector3d& middle, double radius) const {
  std::vector<std::uint32_t> found;
  for (const auto& [exponent, level] : levels_)
    find_in(level, std::ldexp(1.0, exponent), middle, radius, found);
  std::ranges::sort(found);
  return found;
}

}  // namespace armlet
