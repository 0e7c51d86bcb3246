#pragma once

#include "dynamics/plan_dynamics.hpp"

// The first ten parameters of a link (identification.hpp): those of its mass, in its own frame.
namespace armlet {

inline constexpr int kMassParameters = 10;

// The parameters of a body with these moments: m, m c and the inertia about the origin, row by row.
Eigen::Matrix<double, kMassParameters, 1> mass_parameters(const Moments& body);

// A body with 1 for parameter k, and 0 for the others.
Moments unit_body(int k);

}  // namespace armlet
