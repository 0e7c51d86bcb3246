#pragma once
// Which point of one picture is which of another one.

#include <vector>

#include "armlet/vision/plane_points.hpp"

namespace armlet {

// For each wanted point the one that is taken for it.
//
// index     row of the points, or -1: none is near enough. No point is taken twice.
// distance  pixels; for those without one, to the nearest point there is, infinity without any.
struct Matches {
  std::vector<int> index;
  std::vector<double> distance;

  [[nodiscard]] std::vector<int> lost() const;  // rows of the wanted points, in order
};

inline constexpr int kMostMatched = 500;  // points of each list

// As many pairs as possible no farther apart than `within`, and of those choices the one with the
// smallest sum of distances. Pairs of the same sums are taken in the order of the rows.
//
// points, wanted  n x 2 and k x 2, pixels.
// throws  ArgumentError for more than kMostMatched points, numbers that are not finite, and a
//         distance that is not above 0.
// source  H. W. Kuhn, The Hungarian method for the assignment problem, Naval Research Logistics
//         Quarterly 2, 1955; with shortest augmenting paths, R. Jonker, A. Volgenant, Computing 38,
//         1987.
Matches match_points(const PlanePoints& points, const PlanePoints& wanted, double within);

// Keeps the labels of points from picture to picture. A point that is not found stays where it was
// predicted for at most `patience` pictures; then it is lost.
class PointTracker {
 public:
  // start     k x 2, pixels.
  // gate      how far a point may be from its prediction, pixels.
  // throws    as match_points; and for a negative patience.
  PointTracker(PlanePoints start, double gate, int patience = 5);

  // Takes the points of the next picture, in any order, to the labels.
  //
  // predicted  k x 2: where the points are expected; empty: expected().
  // returns    k x 2 in the order of the start.
  // throws     as match_points, and for a prediction of another number of points.
  const PlanePoints& update(const PlanePoints& points, const PlanePoints& predicted = {});

  [[nodiscard]] const PlanePoints& points() const { return points_; }
  // Where they should be in the next picture: where they were, plus what they moved by before.
  [[nodiscard]] PlanePoints expected() const { return points_ + moved_; }
  // Labels that have not been found for more pictures than `patience`, in order.
  [[nodiscard]] std::vector<int> lost() const;
  // In how many pictures, one after the other, a label has not been found.
  [[nodiscard]] const std::vector<int>& missed() const { return missed_; }

 private:
  PlanePoints points_;
  PlanePoints moved_;  // by the last step
  std::vector<int> missed_;
  double gate_;
  int patience_;
};

}  // namespace armlet
