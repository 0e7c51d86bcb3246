#pragma once

#include "lane_parts.hpp"

// Pairs of numbers, for kernels of one configuration.
namespace armlet {

using Lanes = det::Lanes;

inline Lanes both(double value) { return Lanes{value, value}; }

inline Lanes load_pair(const double* p) { return load_lanes<Lanes>(p); }
inline void store_pair(double* p, Lanes v) { store_lanes(p, v); }

}  // namespace armlet
