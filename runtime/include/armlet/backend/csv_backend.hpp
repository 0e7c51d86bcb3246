#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// A backend that writes a run as one table, numbers with 9 significant digits.
//
//   t [s],what,name,x [m],y [m],z [m],qw,qx,qy,qz,q1 [rad],..,qd1 [rad/s],..,qdd1 [rad/s^2],..,text
//
// t is in seconds with all nanoseconds; `what` is robot, object, attached, detached, removed,
// frame, output, message, advice or end. A robot's pose is that of its tool point, in the world. A
// frame is a picture that a camera took, with the pose of the camera and the name of its file as
// text. n is the largest number of joints at the beginning; a robot with more joints that is added
// later is an error and left out. A column of joint values has a unit if all robots at the
// beginning have the same unit there. Cells that do not apply are empty.
//
// out  not owned; lives at least as long as the backend.
[[nodiscard]] std::unique_ptr<Backend> make_csv_backend(std::ostream& out);

}  // namespace armlet
