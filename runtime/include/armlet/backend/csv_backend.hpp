#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A backend that writes a run as one table, numbers with 9 significant digits.
//
//   t,what,name,x,y,z,qw,qx,qy,qz,q1,..,qn,qd1,..,qdn,qdd1,..,qddn,text
//
// t is in seconds with all nanoseconds, `what` is robot, object, attached, detached, removed,
// output, message, advice or end. A robot's pose is that of its tool point, in the world. n is the
// largest number of joints at the beginning; a robot that joins later with more is an error and
// left out. Cells that do not apply are empty.
//
// out  not owned; lives at least as long as the backend.
[[nodiscard]] std::unique_ptr<Backend> make_csv_backend(std::ostream& out);

}  // namespace armlet
