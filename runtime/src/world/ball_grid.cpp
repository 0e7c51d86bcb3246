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
  const Ball ball{middle, radius, id};
  const auto known = places_.find(id);
  if (known != places_.end() && known->second.level == level && known->second.cell == cell) {
    levels_.at(level).balls[known->second.index] = ball;
    return;
  }
  take(id);
  Level& at = levels_[level];
  places_.insert_or_assign(id, Place{level, cell, at.balls.size()});
  at.cells[cell].push_back(id);
  at.balls.push_back(ball);
}

void BallGrid::take(std::uint32_t id) {
  const auto known = places_.find(id);
  if (known == places_.end()) return;
  const Place place = known->second;
  places_.erase(known);
  const auto level = levels_.find(place.level);
  const auto cell = level->second.cells.find(place.cell);
  std::erase(cell->second, id);
  if (cell->second.empty()) level->second.cells.erase(cell);
  // The last ball of the list takes its place.
  std::vector<Ball>& balls = level->second.balls;
  if (place.index + 1 < balls.size()) {
    balls[place.index] = balls.back();
    places_.at(balls.back().id).index = place.index;
  }
  balls.pop_back();
  if (balls.empty()) levels_.erase(level);
}

bool BallGrid::touches(const Ball& ball, const Vector3d& middle, double radius) const {
  Vector3d apart = ball.middle - middle;
  if (space_ == Space::kColumns) apart.z() = 0.0;
  const double most = (ball.radius + radius) * (1.0 + kMargin);
  return apart.squaredNorm() <= most * most;
}

// Where a query covers more cubes than there are balls, all balls of the level are looked at.
void BallGrid::find_in(const Level& level, double width, const Vector3d& middle, double radius,
                       std::vector<std::uint32_t>& found) const {
  const Vector3d around = Vector3d::Constant((radius + 0.5 * width) * (1.0 + kMargin));
  const Cell low = cell_of(middle - around, width), high = cell_of(middle + around, width);
  double cubes = 1.0;
  for (std::size_t k = 0; k < 3; ++k) cubes *= static_cast<double>(high[k] - low[k]) + 1.0;
  if (cubes > static_cast<double>(level.cells.size())) {
    for (const Ball& each : level.balls) {
      if (touches(each, middle, radius)) found.push_back(each.id);
    }
    return;
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto cell = level.cells.find({x, y, z});
        if (cell == level.cells.end()) continue;
        for (const std::uint32_t id : cell->second) {
          if (touches(level.balls[places_.at(id).index], middle, radius)) found.push_back(id);
        }
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
