#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A backend that writes the samples of the robots as one array of NumPy's format .npy, version 1.0;
// `a = numpy.load("run.npy")` gives a row for each sample:
//
//   a["t"]                      s
//   a["robot"]                  its index: 0 is the first robot
//   a["p"], a["r"]              of the tool point in the world: m, and a unit quaternion w, x, y, z
//   a["q"], a["qd"], a["qdd"]   of n joints each: rad or m, per s, per s^2
//
// Numbers have 8 bytes, the least significant first, with the same bits as in the run. n is the
// largest number of joints at the beginning; a robot with fewer has NaN in the other columns; one
// with more that is added later is an error and left out. Objects, events and texts are not
// written.
//
// source  NumPy Reference, numpy.lib.format, "Format Version 1.0".
//
// out  not owned; lives at least as long as the backend. The number of rows is written to the
//      beginning when the run has ended: seekp has to be possible.
[[nodiscard]] std::unique_ptr<Backend> make_npy_backend(std::ostream& out);

}  // namespace armlet
