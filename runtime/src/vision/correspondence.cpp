#include "armlet/vision/correspondence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/check_finite.hpp"

namespace armlet {
namespace {

using Eigen::Index;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void check_points(const PlanePoints& points, const char* which) {
  if (points.rows() > kMostMatched) {
    throw ArgumentError(fmt::format("At most {} points are matched, not {} {}.", kMostMatched,
                                    points.rows(), which));
  }
  check_finite(which, points);
}

double distance_of(const PlanePoints& a, Index i, const PlanePoints& b, Index j) {
  const double dx = a(i, 0) - b(j, 0), dy = a(i, 1) - b(j, 1);
  return std::sqrt(dx * dx + dy * dy);
}

// Assigns every row to a different column such that the sum of the costs is smallest; there are at
// least as many columns as rows. Row and column 0 are auxiliary.
class Assignment {
 public:
  Assignment(const Eigen::MatrixXd& cost)
      : cost_(cost),
        rows_(cost.rows()),
        columns_(cost.cols()),
        of_row_(static_cast<std::size_t>(rows_ + 1), 0.0),
        of_column_(static_cast<std::size_t>(columns_ + 1), 0.0),
        row_at_(static_cast<std::size_t>(columns_ + 1), 0),
        from_(static_cast<std::size_t>(columns_ + 1), 0) {}

  // The column of each row.
  std::vector<Index> columns_of_rows() {
    for (Index row = 1; row <= rows_; ++row) add(row);
    std::vector<Index> out(static_cast<std::size_t>(rows_));
    for (Index j = 1; j <= columns_; ++j) {
      const Index row = row_at_[at(j)];
      if (row > 0) out[at(row - 1)] = j - 1;
    }
    return out;
  }

 private:
  static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

  // Finds the path of least cost to a free column over those that are assigned, and shifts all
  // assignments along it.
  void add(Index row) {
    std::vector<double> least(at(columns_ + 1), kInfinity);
    std::vector<bool> done(at(columns_ + 1), false);
    row_at_[0] = row;
    Index column = 0;
    while (row_at_[at(column)] != 0) {
      checkpoint(4 * at(columns_));
      done[at(column)] = true;
      const Index here = row_at_[at(column)];
      double step = kInfinity;
      Index next = 0;
      for (Index j = 1; j <= columns_; ++j) {
        if (done[at(j)]) continue;
        const double reduced = cost_(here - 1, j - 1) - of_row_[at(here)] - of_column_[at(j)];
        if (reduced < least[at(j)]) {
          least[at(j)] = reduced;
          from_[at(j)] = column;
        }
        if (least[at(j)] < step) {
          step = least[at(j)];
          next = j;
        }
      }
      for (Index j = 0; j <= columns_; ++j) {
        if (done[at(j)]) {
          of_row_[at(row_at_[at(j)])] += step;
          of_column_[at(j)] -= step;
        } else {
          least[at(j)] -= step;
        }
      }
      column = next;
    }
    for (; column != 0; column = from_[at(column)])
      row_at_[at(column)] = row_at_[at(from_[at(column)])];
  }

  const Eigen::MatrixXd& cost_;
  Index rows_, columns_;
  std::vector<double> of_row_, of_column_;
  std::vector<Index> row_at_;  // the row assigned to a column; 0: free
  std::vector<Index> from_;    // the column before it on the path
};

}  // namespace

std::vector<int> Matches::lost() const {
  std::vector<int> out;
  for (std::size_t i = 0; i < index.size(); ++i)
    if (index[i] < 0) out.push_back(static_cast<int>(i));
  return out;
}

Matches match_points(const PlanePoints& points, const PlanePoints& wanted, double within) {
  check_points(points, "seen");
  check_points(wanted, "wanted");
  check_positive("within", within);
  const Index n = points.rows(), k = wanted.rows();
  Matches out;
  out.index.assign(static_cast<std::size_t>(k), -1);
  out.distance.assign(static_cast<std::size_t>(k), kInfinity);
  if (k == 0) return out;
  // One more column for each goal point, for "no pair": its cost is higher than that of all pairs
  // together.
  const double none = within * static_cast<double>(k + 1);
  Eigen::MatrixXd cost = Eigen::MatrixXd::Constant(k, n + k, none);
  for (Index i = 0; i < k; ++i) {
    for (Index j = 0; j < n; ++j) {
      const double distance = distance_of(wanted, i, points, j);
      out.distance[static_cast<std::size_t>(i)] =
          std::min(out.distance[static_cast<std::size_t>(i)], distance);
      cost(i, j) = distance <= within ? distance : 4.0 * none;
    }
  }
  const std::vector<Index> chosen = Assignment(cost).columns_of_rows();
  for (Index i = 0; i < k; ++i) {
    const Index j = chosen[static_cast<std::size_t>(i)];
    if (j >= n) continue;
    out.index[static_cast<std::size_t>(i)] = static_cast<int>(j);
    out.distance[static_cast<std::size_t>(i)] = distance_of(wanted, i, points, j);
  }
  return out;
}

PointTracker::PointTracker(PlanePoints start, double gate, int patience)
    : points_(std::move(start)),
      moved_(PlanePoints::Zero(points_.rows(), 2)),
      missed_(static_cast<std::size_t>(points_.rows()), 0),
      gate_(gate),
      patience_(patience) {
  check_points(points_, "first");
  check_positive("gate", gate);
  if (patience < 0) {
    throw ArgumentError(
        fmt::format("A point is waited for in 0 pictures or more, not in {}.", patience));
  }
}

const PlanePoints& PointTracker::update(const PlanePoints& points, const PlanePoints& predicted) {
  const bool is_given = predicted.rows() > 0;
  if (is_given && predicted.rows() != points_.rows()) {
    throw ArgumentError(fmt::format("{} points are tracked and {} are predicted.", points_.rows(),
                                    predicted.rows()));
  }
  const PlanePoints aims = is_given ? predicted : expected();
  const Matches matches = match_points(points, aims, gate_);
  for (Index i = 0; i < points_.rows(); ++i) {
    const auto label = static_cast<std::size_t>(i);
    const int found = matches.index[label];
    const Eigen::RowVector2d next =
        found < 0 ? Eigen::RowVector2d(aims.row(i)) : Eigen::RowVector2d(points.row(found));
    moved_.row(i) = next - points_.row(i);
    points_.row(i) = next;
    missed_[label] = found < 0 ? missed_[label] + 1 : 0;
  }
  return points_;
}

std::vector<int> PointTracker::lost() const {
  std::vector<int> out;
  for (std::size_t i = 0; i < missed_.size(); ++i)
    if (missed_[i] > patience_) out.push_back(static_cast<int>(i));
  return out;
}

}  // namespace armlet
