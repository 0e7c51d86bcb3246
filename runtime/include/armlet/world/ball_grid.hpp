// Balls, found by where they are.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Each ball lies in a cube of a grid whose cubes are as wide as the ball or less than twice as
// wide; a grid for each power of two. The balls near a place are found without looking at the
// others, however different their sizes.
//
// source  C. Ericson, Real-Time Collision Detection, 2005, 7.2 (hierarchical grids).
class BallGrid {
 public:
  // Heights count, or balls are columns along z.
  enum class Space { kWhole, kColumns };
  explicit BallGrid(Space space) : space_(space) {}

  // A ball that is there already is moved.
  //
  // middle, radius  finite, m; radius >= 0.
  void put(std::uint32_t id, const Eigen::Vector3d& middle, double radius);
  // Nothing happens if it is not there.
  void take(std::uint32_t id);
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  // All balls that a ball touches, by rising numbers; it may touch some of them but for rounding.
  [[nodiscard]] std::vector<std::uint32_t> touching(const Eigen::Vector3d& middle,
                                                    double radius) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Ball {
    Eigen::Vector3d middle;
    double radius = 0.0;
    std::uint32_t id = 0;
  };
  // balls  all of the level, for queries that reach far.
  struct Level {
    std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
    std::vector<Ball> balls;
  };
  // level  its cubes are 2^level wide.
  // index  of Level::balls.
  struct Place {
    int level = 0;
    Cell cell{};
    std::size_t index = 0;
  };

  [[nodiscard]] Cell cell_of(const Eigen::Vector3d& p, double width) const;
  [[nodiscard]] bool touches(const Ball& ball, const Eigen::Vector3d& middle, double radius) const;
  void find_in(const Level& level, double width, const Eigen::Vector3d& middle, double radius,
               std::vector<std::uint32_t>& found) const;

  Space space_;
  std::unordered_map<std::uint32_t, Place> places_;
  std::map<int, Level> levels_;
};

}  // namespace armlet
