#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "svg_parts.hpp"

namespace armlet::svg {
namespace {

struct Cell {
  int count = 0;
  double near = 0.0;
  int color = 0;
};

// Rows of equal cells as one path of rectangles.
class Runs {
 public:
  Runs(const Field& field, int columns) : field_(field), columns_(columns) {}

  template <class Belongs>
  std::string path(const std::vector<Cell>& grid, Belongs belongs) const {
    std::string d;
    for (std::size_t begin = 0; begin < grid.size(); begin += static_cast<std::size_t>(columns_)) {
      for (int column = 0; column < columns_;) {
        int end = column;
        while (end < columns_ && belongs(grid[begin + static_cast<std::size_t>(end)])) ++end;
        if (end > column) {
          const double y =
              field_.top + kCell * static_cast<double>(begin / static_cast<std::size_t>(columns_));
          d += fmt::format("M{} {}h{}v{}h-{}z", coordinate(field_.left + kCell * column),
                           coordinate(y), coordinate(kCell * (end - column)), coordinate(kCell),
                           coordinate(kCell * (end - column)));
        }
        column = std::max(end, column + 1);
      }
    }
    return d;
  }

 private:
  const Field& field_;
  int columns_;
};

}  // namespace

std::string cells(const Field& field, const std::vector<CloudPoint>& points, int series,
                  int classes) {
  const int columns = static_cast<int>(std::ceil(field.width() / kCell));
  const int rows = static_cast<int>(std::ceil(field.height() / kCell));
  std::vector<Cell> grid(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  int most = 1;
  for (const CloudPoint& point : points) {
    const int column = static_cast<int>(std::floor((point.at.x - field.left) / kCell));
    const int row = static_cast<int>(std::floor((point.at.y - field.top) / kCell));
    Cell& cell = grid[static_cast<std::size_t>(std::clamp(row, 0, rows - 1)) *
                          static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(std::clamp(column, 0, columns - 1))];
    if (cell.count++ == 0 || point.near > cell.near) {
      cell.near = point.near;
      cell.color = point.color;
    }
    most = std::max(most, cell.count);
  }
  const Runs runs(field, columns);
  std::string out;
  const auto add = [&](const std::string& css, const std::string& d) {
    if (!d.empty()) out += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", css, d);
  };
  for (int color = 0; color < classes; ++color) {
    add(fmt::format("h{}", color),
        runs.path(grid, [&](const Cell& c) { return c.count > 0 && c.color == color; }));
  }
  if (classes > 0) return out;
  const int few = std::max(1, most / 8), some = std::max(2, most / 3);
  const std::string fill = fmt::format("f{}", series);
  add(fill + " few", runs.path(grid, [&](const Cell& c) { return c.count > 0 && c.count <= few; }));
  add(fill + " some",
      runs.path(grid, [&](const Cell& c) { return c.count > few && c.count <= some; }));
  add(fill, runs.path(grid, [&](const Cell& c) { return c.count > few && c.count > some; }));
  return out;
}

}  // namespace armlet::svg
