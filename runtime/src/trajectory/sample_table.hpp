// What Trajectory::sample looks at: when pieces begin, and the polynomials of all joints side by
// side.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "armlet/trajectory/trajectory.hpp"

namespace armlet {

// Where the state of all joints goes, n numbers each.
struct StateOut {
  double* q;
  double* qd;
  double* qdd;
};

class SampleTable {
 public:
  // joints  already checked; coefficients above the degree of a piece are zero.
  SampleTable(std::span<const JointPath> joints, double duration);

  // The state at time t of the same joints, as Trajectory::sample promises it.
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

  int degree_ = 2;            // the highest of all pieces, at least 2
  bool shared_ = true;        // all joints that move have the same starts
  double first_end_ = -1.0;   // when the first joint stops that moves, -1 if none does
  std::vector<double> ends_;  // when a joint stops moving, -1 if it never moves; by pairs of joints
  std::vector<double> goals_;  // their last positions

  // Shared starts: the polynomials of a piece stand together, those of two joints interleaved.
  std::vector<double> starts_;        // of the pieces, and one that is never
  std::vector<double> polynomials_;   // piece by piece, pair by pair, power by power
  double cells_per_second_ = 0.0;     // the time is divided into equal cells ...
  std::vector<std::uint32_t> cells_;  // ... the piece that holds at the begin of each
  std::uint32_t most_in_cell_ = 0;    // how many pieces begin in one cell at most

  // Otherwise: starts of the second, third ... piece, infinite where there is none; by pairs.
  std::vector<double> later_starts_;
  std::size_t most_pieces_ = 0;
};

}  // namespace armlet
