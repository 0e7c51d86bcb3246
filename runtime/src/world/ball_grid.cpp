#include "armlet/world/ball_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace armlet {
namespace {

using Eigen::Vector3d;

constexpr int kFinest = -20;      // cubes of a micrometre
constexpr double kMargin = 1e-9;  // of a distance, for rounding
constexpr std::size_t kFew = 16;  // balls of a part that is not divided
constexpr int kDeepest = 12;      // largest number of divisions of a cube

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

BallGrid::Part& BallGrid::Part::child_with(const Vector3d& middle) {
  std::size_t index = 0;
  for (int k = 0; k < 3; ++k) index = 2 * index + (middle[k] >= centre[k] ? 1 : 0);
  return children[index];
}

void BallGrid::Part::widen_for(const Ball& ball) {
  low = count == 0 ? ball.middle : Vector3d(low.cwiseMin(ball.middle));
  high = count == 0 ? ball.middle : Vector3d(high.cwiseMax(ball.middle));
  core = count == 0 ? ball.core : std::min(core, ball.core);
  ++count;
}

const BallGrid::Ball& BallGrid::ball_of(std::uint32_t id) const {
  const Place& place = places_.at(id);
  return levels_.at(place.level).balls[place.index];
}

// Columns have no centre along z: all their balls are put into the upper half.
void BallGrid::divide(Part& part) const {
  part.children.resize(8);
  for (std::size_t index = 0; index < 8; ++index) {
    Part& child = part.children[index];
    child.width = 0.5 * part.width;
    child.depth = part.depth + 1;
    child.centre = part.centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const double side = ((index >> (2 - k)) & 1) != 0 ? 0.25 : -0.25;
      child.centre[static_cast<Eigen::Index>(k)] += side * part.width;
    }
    if (space_ == Space::kColumns) child.centre.z() = part.centre.z();
  }
  for (const std::uint32_t id : part.ids) {
    const Ball& each = ball_of(id);
    put_in(part.child_with(each.middle), each);
  }
  part.ids = {};
}

void BallGrid::put_in(Part& root, const Ball& ball) const {
  Part* part = &root;
  part->widen_for(ball);
  while (!part->children.empty()) {
    part = &part->child_with(ball.middle);
    part->widen_for(ball);
  }
  part->ids.push_back(ball.id);
  if (part->ids.size() > kFew && part->depth < kDeepest) divide(*part);
}

void BallGrid::put(std::uint32_t id, const Vector3d& middle, double radius, double core) {
  const int level = level_of(radius);
  const double width = std::ldexp(1.0, level);
  const Cell cell = cell_of(middle, width);
  const Ball ball{middle, radius, core, id};
  const auto known = places_.find(id);
  if (known != places_.end() && known->second.level == level && known->second.cell == cell) {
    Level& same = levels_.at(level);
    Part& root = same.cells.at(cell);
    if (root.children.empty()) {
      same.balls[known->second.index] = ball;
      --root.count;
      root.widen_for(ball);
      return;
    }
  }
  take(id);
  Level& at = levels_[level];
  places_.insert_or_assign(id, Place{level, cell, at.balls.size()});
  at.balls.push_back(ball);
  Part& root = at.cells[cell];
  if (root.width == 0.0) {
    root.width = width;
    for (std::size_t k = 0; k < 3; ++k) {
      root.centre[static_cast<Eigen::Index>(k)] = (static_cast<double>(cell[k]) + 0.5) * width;
    }
    if (space_ == Space::kColumns) root.centre.z() = -std::numeric_limits<double>::infinity();
  }
  put_in(root, ball);
}

void BallGrid::take(std::uint32_t id) {
  const auto known = places_.find(id);
  if (known == places_.end()) return;
  const Place place = known->second;
  places_.erase(known);
  const auto level = levels_.find(place.level);
  std::vector<Ball>& balls = level->second.balls;
  const auto cell = level->second.cells.find(place.cell);
  Part* part = &cell->second;
  --part->count;
  while (part->count > 0 && !part->children.empty()) {
    part = &part->child_with(balls[place.index].middle);
    --part->count;
  }
  if (part->count == 0) part->children = {};
  std::erase(part->ids, id);
  if (cell->second.count == 0) level->second.cells.erase(cell);
  // The last ball of the list fills the gap.
  if (place.index + 1 < balls.size()) {
    balls[place.index] = balls.back();
    places_.at(balls.back().id).index = place.index;
  }
  balls.pop_back();
  if (balls.empty()) levels_.erase(level);
}

double BallGrid::square_between(const Vector3d& apart) const {
  return space_ == Space::kColumns ? apart.head<2>().squaredNorm() : apart.squaredNorm();
}

bool BallGrid::touches(const Ball& ball, const Query& query) const {
  const Vector3d apart = ball.middle - query.middle;
  const double most = (ball.radius + query.radius) * (1.0 + kMargin);
  const double cores = ball.core + query.core;
  if (cores > 0.0 && apart.squaredNorm() < cores * cores * (1.0 - kMargin)) return false;
  return square_between(apart) <= most * most;
}

// Whether a ball of the part may touch that of the query, and its core may not.
bool BallGrid::may_touch(const Part& part, double width, const Query& query) const {
  const Vector3d below = part.low - query.middle, above = query.middle - part.high;
  const double most = (0.5 * width + query.radius) * (1.0 + kMargin);
  if (square_between(below.cwiseMax(above).cwiseMax(0.0)) > most * most) return false;
  const double cores = part.core + query.core;
  if (!(cores > 0.0)) return true;
  const Vector3d farthest = (-below).cwiseMax(-above).cwiseMax(below).cwiseMax(above);
  return farthest.squaredNorm() >= cores * cores * (1.0 - kMargin);
}

void BallGrid::find_in(const Part& part, double width, const Query& query,
                       std::vector<std::uint32_t>& found) const {
  if (part.count == 0 || !may_touch(part, width, query)) return;
  for (const std::uint32_t id : part.ids) {
    if (touches(ball_of(id), query)) found.push_back(id);
  }
  for (const Part& child : part.children) find_in(child, width, query, found);
}

// A query that covers more cubes than exist tests all balls of the level, or all cubes, since most
// balls can be excluded by their cube.
void BallGrid::find_in(const Level& level, double width, const Query& query,
                       std::vector<std::uint32_t>& found) const {
  const Vector3d around = Vector3d::Constant((query.radius + 0.5 * width) * (1.0 + kMargin));
  const Cell low = cell_of(query.middle - around, width);
  const Cell high = cell_of(query.middle + around, width);
  double cubes = 1.0;
  for (std::size_t k = 0; k < 3; ++k) cubes *= static_cast<double>(high[k] - low[k]) + 1.0;
  if (cubes > static_cast<double>(level.cells.size())) {
    if (query.core > 0.0) {
      for (const auto& [cell, part] : level.cells) find_in(part, width, query, found);
      return;
    }
    for (const Ball& each : level.balls) {
      if (touches(each, query)) found.push_back(each.id);
    }
    return;
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto cell = level.cells.find({x, y, z});
        if (cell != level.cells.end()) find_in(cell->second, width, query, found);
      }
    }
  }
}

std::vector<std::uint32_t> BallGrid::touching(const Vector3d& middle, double radius,
                                              double core) const {
  const Query query{middle, radius, core};
  std::vector<std::uint32_t> found;
  for (const auto& [exponent, level] : levels_)
    find_in(level, std::ldexp(1.0, exponent), query, found);
  std::ranges::sort(found);
  return found;
}

}  // namespace armlet
