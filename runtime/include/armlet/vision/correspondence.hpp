#pragma once
// Correspondence of points between pictures.

#include <vector>

#include "armlet/vision/plane_points.hpp"

namespace armlet {

// For each goal point the point that is assigned to it.
//
// index     row of the assigned point, or -1: none is near enough. No point is assigned twice.
// distance  pixels; for goal points without one, to the nearest point, or infinity if there are no
//           points.
struct Matches {
  std::vector<int> index;
  std::vector<double> distance;

  [[nodiscard]] std::vector<int> lost() const;  // rows of the goal points without one, in order
};

inline constexpr int kMostMatched = 500;  // points of each list

// The assignment with the largest number of pairs no farther apart than `within`; of those, the one
// with the smallest sum of distances. Of equal sums the first in the order of the rows is chosen.
//
// points, wanted  n x 2 and k x 2, pixels.
// throws  ArgumentError for more than kMostMatched points, numbers that are not finite, and a
//         distance that is not above 0.
// source  H. W. Kuhn, The Hungarian method for the assignment problem, Naval Research Logistics
//         Quarterly 2, 1955; with shortest augmenting paths, R. Jonker, A. Volgenant, Computing 38,
//         1987.
Matches match_points(const PlanePoints& points, const PlanePoints& wanted, double within);

// Keeps the labels of points from picture to picture. A point that is not found keeps its predicted
// position for at most `patience` pictures; then it is lost.
class PointTracker {
 public:
  // start     k x 2, pixels.
  // gate      largest distance of a point from its prediction, pixels.
  // throws    as match_points; and for a negative patience.
  PointTracker(PlanePoints start, double gate, int patience = 5);

  // Assigns the points of the next picture, in any order, to the labels.
  //
  // predicted  k x 2: the predicted points; empty: expected().
  // returns    k x 2 in the order of the start.
  // throws     as match_points, and for a prediction of another number of points.
  const PlanePoints& update(const PlanePoints& points, const PlanePoints& predicted = {});

  [[nodiscard]] const PlanePoints& points() const { return points_; }
  // The predicted points of the next picture: the present ones plus their last displacement.
  [[nodiscard]] PlanePoints expected() const { return points_ + moved_; }
  // Labels that have been missed in more than `patience` pictures, in order.
  [[nodiscard]] std::vector<int> lost() const;
  // Number of consecutive pictures in which each label has been missed.
  [[nodiscard]] const std::vector<int>& missed() const { return missed_; }

 private:
  PlanePoints points_;
  PlanePoints moved_;  // displacement in the last step
  std::vector<int> missed_;
  double gate_;
  int patience_;
};

}  // namespace armlet
