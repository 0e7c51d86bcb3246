// Collisions in a cell: at this instant, and during a motion before it is executed.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/collision/motion_check.hpp"

namespace armlet {

// A body of the cell.
//
// robot   to which the body belongs, or that carries it; -1: none.
// object  name of the object; empty: the body is a part of the robot.
// frame   of a part of a robot: the joint that moves it; 0: the base.
struct CellBody {
  int robot = -1;
  std::string object{};
  int frame = 0;
  LinkShapeRole role = LinkShapeRole::kLink;
};

// "link 3 of `arm`", "the gripper of `arm`", "\"cube\"".
std::string body_text(const Cell& cell, const CellBody& body);

// Whether contact forces on the body are measured (Cell::contact_wrench): it is a part of a
// gripper, or carried by one.
bool feels(const Cell& cell, const CellBody& body);

// Two bodies that would collide during a motion; times are relative to its start, the rest as in
// Meeting.
//
// at_start, at_end  the bodies already overlap there.
struct CellCollision {
  CellBody body;   // of the moving robot, or what it carries
  CellBody other;  // an object, or a part of another or the same robot
  double t = 0.0;
  double depth = 0.0;
  bool at_least = false;
  double t_deepest = 0.0;
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  double higher = 0.0;
  bool at_start = false;
  bool at_end = false;
};

// A motion of another robot that begins at the same instant. Not owned.
struct MotionBeside {
  int robot = -1;
  const Trajectory* motion = nullptr;
};

// The collisions of the robot, with all that it carries, during this motion if it started now: with
// objects, with itself, and with other robots, whose present motions continue. Only the first
// collision of each pair (a robot or a carried object, and another robot or object) is returned, in
// order of time.
//
// These contacts do not count:
// - of the gripper's fingers or suction cup, or of the rod at the end of an arm without a gripper,
//   with an object that this gripper can take where the motion begins or ends;
// - of the carried object with the gripper, and with any other gripper that holds it;
// - of the carried object and the gripper with what they touch at the start, until they have
//   separated;
// - of the base and the column on it, which do not move, with what is around them.
//
// A gripper that holds something is open as far as the object is wide. Arms whose bases overlap
// cannot exist together: they are taken for alternatives and not compared. A motion of no duration
// is not checked. A finger or a hand with fingers is compared with fixed objects, with what other
// robots carry, with robots (all in their present poses, as is its own arm), with the palm, and
// with the other fingers along their present motions.
//
// beside  for fingers: motions of other fingers of the same gripper that begin at the same instant.
//         Each pair of them is compared in the call for the one with the lower number.
// throws  ArgumentError as check_motion.
std::vector<CellCollision> find_collisions(const Cell& cell, int robot, const Trajectory& motion,
                                           std::span<const MotionBeside> beside = {});

// The bodies that find_collisions compares, and the meaning of each pair of the scene.
//
// scene  its arms point to the robots of the cell and to the motion; the first one is the robot.
struct ComparedBodies {
  MotionScene scene{};
  std::vector<std::pair<CellBody, CellBody>> pairs{};
};
ComparedBodies compared_bodies(const Cell& cell, int robot, const Trajectory& motion);

// Whether a robot includes what it carries: in its gripper, mounted on its links, and on top of
// that.
enum class Carried { kCounts, kLeftOut };

// The distance between two things.
//
// distance          m; if they overlap, minus the depth.
// p_body, p_other   in the world: their nearest points, or those that lie deepest in the other
//                   body.
// at_least          the depth may be larger (is_whole_depth); set by `clearances`.
struct Clearance {
  CellBody body;   // of the first thing: a part of the robot, or what it carries
  CellBody other;  // of the second thing
  double distance = std::numeric_limits<double>::infinity();
  bool at_least = false;
  Eigen::Vector3d p_body = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_other = Eigen::Vector3d::Zero();
};

// The smallest distance between two things of the cell at this instant, and the bodies between
// which it is found. A CellBody with `robot` and no object stands for the robot with its gripper,
// without parts that belong to the other thing or lie on it; `frame` and `role` are ignored.
Clearance nearest_between(const Cell& cell, const CellBody& a, const CellBody& b,
                          Carried carried = Carried::kCounts);
inline double distance_between(const Cell& cell, const CellBody& a, const CellBody& b,
                               Carried carried = Carried::kCounts) {
  return nearest_between(cell, a, b, carried).distance;
}

// Another object that an object overlaps, deeper than bodies which rest on each other.
//
// at_least  the depth may be larger, as of meshes that are not convex (is_whole_depth).
struct ObjectOverlap {
  std::string other;
  double depth = 0.0;  // m
  bool at_least = false;
};

// The overlap of largest depth; nothing if there is none. Pairs of fixed objects are left out,
// since they may be parts of one thing, and so are objects that a gripper carries.
std::optional<ObjectOverlap> deepest_overlap(const World& world, const Object& object);

}  // namespace armlet
