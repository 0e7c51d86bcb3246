// Balls, found by where they are.
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

// Each ball lies in a cube of a grid whose cubes are as wide as the ball or less than twice as
// wide; a grid for each power of two. The balls near a place are found without looking at the
// others, however different their sizes. A cube with many balls is divided into eight, and so on.
//
// A ball may have a core, a smaller ball with the same middle. A query can leave out the balls
// whose cores surely overlap a core of its own; of thousands in one place it then looks at few.
//
// source  C. Ericson, Real-Time Collision Detection, 2005, 7.2 (hierarchical grids), 7.3 (octrees).
class BallGrid {
 public:
  // Heights count, or balls are columns along z.
  enum class Space { kWhole, kColumns };
  explicit BallGrid(Space space) : space_(space) {}

  static constexpr double kNoCore = -std::numeric_limits<double>::infinity();

  // A ball that is there already is moved.
  //
  // middle, radius  finite, m; radius >= 0.
  // core            its radius, m, or kNoCore.
  void put(std::uint32_t id, const Eigen::Vector3d& middle, double radius, double core = kNoCore);
  // Nothing happens if it is not there.
  void take(std::uint32_t id);
  [[nodiscard]] std::size_t size() const { return places_.size(); }

  // All balls that a ball touches, by rising numbers; it may touch some of them but for rounding.
  // Those whose cores overlap `core` are left out; heights count there, in columns too.
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
  // centre, width  of the part; middles lie on its low sides too.
  // low, high      around all middles that were put into it since it was empty.
  // core           the least of them.
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
  // balls  all of the level, for queries that reach far.
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
