// Balls, found by their positions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// Each ball lies in a cube of a grid whose cubes are once to twice as wide as the ball; there is a
// grid for each power of two. So the balls near a position are found without testing the others,
// however different their sizes. A cube with many balls is divided into eight, and so on.
//
// A ball may have a core, a smaller concentric ball. A query with a core can leave out the balls
// whose cores certainly overlap its own; among thousands of balls at one position it then tests
// few.
//
// source  C. Ericson, Real-Time Collision Detection, 2005, 7.2 (hierarchical grids), 7.3 (octrees).
class BallGrid {
 public:
  // kWhole: balls in space; kColumns: balls count as columns along z, whatever their heights.
  enum class Space { kWhole, kColumns };
  explicit BallGrid(Space space) : space_(space) {}

  static constexpr double kNoCore = -std::numeric_limits<double>::infinity();

  // Adds a ball; an existing one is moved.
  //
  // middle, radius  finite, m; radius >= 0.
  // core            its radius, m, or kNoCore.
  void put(std::uint32_t id, const Eigen::Vector3d& middle, double radius, double core = kNoCore);
  // Removes a ball; no effect if there is none.
  void take(std::uint32_t id);
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  // All balls that touch a given ball, in ascending order of their numbers; because of rounding a
  // few may only nearly touch it. Balls whose cores overlap `core` are left out; heights count for
  // cores, with kColumns too.
  [[nodiscard]] std::vector<std::uint32_t> touching(const Eigen::Vector3d& middle, double radius,
                                                    double core = kNoCore) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const Cell& cell) const;
  };
  struct Ball {
    Eigen::Vector3d middle;
    double radius = 0.0;
    double core = kNoCore;
    std::uint32_t id = 0;
  };
  using Query = Ball;
  // A cube, or a part of one. The balls are in its children, if it has any.
  //
  // centre, width  of the part; centres of balls on its lower sides belong to it.
  // low, high      bounds of all centres that were put into it since it was empty.
  // core           the smallest core radius among them.
  struct Part {
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    double width = 0.0;
    int depth = 0;
    std::size_t count = 0;
    Eigen::Vector3d low = Eigen::Vector3d::Zero(), high = Eigen::Vector3d::Zero();
    double core = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> ids{};
    std::vector<Part> children{};

    Part& child_with(const Eigen::Vector3d& middle);
    void widen_for(const Ball& ball);
  };
  // balls  all of the level, for queries with a large radius.
  struct Level {
    std::unordered_map<Cell, Part, CellHash> cells;
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
  [[nodiscard]] const Ball& ball_of(std::uint32_t id) const;
  [[nodiscard]] double square_between(const Eigen::Vector3d& apart) const;
  [[nodiscard]] bool touches(const Ball& ball, const Query& query) const;
  [[nodiscard]] bool may_touch(const Part& part, double width, const Query& query) const;
  void put_in(Part& part, const Ball& ball) const;
  void divide(Part& part) const;
  void find_in(const Level& level, double width, const Query& query,
               std::vector<std::uint32_t>& found) const;
  void find_in(const Part& part, double width, const Query& query,
               std::vector<std::uint32_t>& found) const;

  Space space_;
  std::unordered_map<std::uint32_t, Place> places_;
  std::map<int, Level> levels_;
};

}  // namespace armlet
