// The table from which Trajectory::sample reads: the starts of the pieces, and the polynomials of
// neighbouring joints next to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// The destinations of the state of all joints, n numbers each.
struct StateOut {
  double* q;
  double* qd;
  double* qdd;
};

class SampleTable {
 public:
  // joints  must be valid; the coefficients above the degree of a piece must be zero.
  SampleTable(std::span<const JointPath> joints, double duration);

  // The state at time t of these joints, as specified for Trajectory::sample.
  void sample(std::span<const JointPath> joints, double t, const StateOut& out) const;

 private:
  void index_shared(const JointPath& path);
  void copy_polynomials(std::span<const JointPath> joints);
  void index_each(std::span<const JointPath> joints);
  [[nodiscard]] std::size_t shared_piece(double t) const;
  template <int kDegree>
  void sample_moving(double t, std::size_t n, const StateOut& out) const;
  template <int kDegree>
  void sample_any(std::span<const JointPath> joints, double t, const StateOut& out) const;
  template <int kDegree>
  void sample_as(std::span<const JointPath> joints, double t, const StateOut& out) const;

  int degree_ = 2;           // the highest of all pieces, at least 2
  bool shared_ = true;       // all joints that move have the same starts of pieces
  double first_end_ = -1.0;  // the end of the first joint that stops, -1 if none moves
  // The ends of the joints' motions, -1 for joints that never move; by pairs of joints.
  std::vector<double> ends_;
  std::vector<double> goals_;  // their last positions

  // If all joints have the same starts: the polynomials of a piece are together, those of two
  // joints interleaved.
  std::vector<double> starts_;        // of the pieces, and an infinite one at the end
  std::vector<double> polynomials_;   // piece by piece, pair by pair, power by power
  double cells_per_second_ = 0.0;     // the time is divided into equal cells ...
  std::vector<std::uint32_t> cells_;  // ... with the piece at the beginning of each
  std::uint32_t most_in_cell_ = 0;    // largest number of pieces that begin in one cell

  // Otherwise: the starts of the second, third ... piece, infinite if there is none; by pairs.
  std::vector<double> later_starts_;
  std::size_t most_pieces_ = 0;
};

}  // namespace armlet
