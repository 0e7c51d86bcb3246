// What meets what in a cell: now, and during a motion before it is made.
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
// robot   whose part it is, or who carries it; -1: nobody.
// object  its name; empty: it is a part of the robot.
// frame   of a part of a robot: what joint `frame` moves, 0: the base.
struct CellBody {
  int robot = -1;
  std::string object{};
  int frame = 0;
  LinkShapeRole role = LinkShapeRole::kLink;
};

// "link 3 of `arm`", "the gripper of `arm`", "\"cube\"".
std::string body_text(const Cell& cell, const CellBody& body);

// Whether the body feels what it presses into (Cell::contact_wrench): of a hand, or carried by one.
bool feels(const Cell& cell, const CellBody& body);

// Two bodies that would meet during a motion; times from its begin, the rest as in Meeting.
//
// at_start, at_end  they overlap there already.
struct CellCollision {
  CellBody body;   // of the robot that moves, or what it carries
  CellBody other;  // an object, another robot's, or of the same robot
  double t = 0.0;
  double depth = 0.0;
  bool at_least = false;
  double t_deepest = 0.0;
  Eigen::Vector3d p_world = Eigen::Vector3d::Zero();
  double higher = 0.0;
  bool at_start = false;
  bool at_end = false;
};

// A motion of another robot, which begins at the same instant. Not owned.
struct MotionBeside {
  int robot = -1;
  const Trajectory* motion = nullptr;
};

// What the robot, with all that it carries, would meet on this motion from now on: objects, itself,
// other robots, which go on as they move now. The first to meet of each pair of a robot or carried
// object and another robot or object, in order of time.
//
// Not counted: the fingers or the cup of a hand, or the stick at the end of an arm without one, and
// an object that this hand can take where the motion begins or ends; what it carries, in its hand,
// in that of who holds it as well; what it carries and the hand, and what they touch at the begin,
// until they have come apart; the base
// and the column on it, which stay where they are, and what stands around them. A gripper that
// holds something is as far open as that is wide. Arms whose bases stand in one
// another cannot both be there: they are taken for alternatives. A motion that takes no time is not
// looked at. Of fingers, and of a hand with fingers: fixed objects, what other robots carry, and
// robots, all where they are now, as the arm is; the palm; and the other fingers, as they move now.
//
// beside  of fingers: motions of others of the same hand that begin at the same instant. Two of
//         them are compared by the one with the lower number.
// throws  ArgumentError as check_motion.
std::vector<CellCollision> find_collisions(const Cell& cell, int robot, const Trajectory& motion,
                                           std::span<const MotionBeside> beside = {});

// What find_collisions would compare, and what each pair of the scene is.
//
// scene  its arms point to the robots of the cell and to the motion; the first one is the robot.
struct ComparedBodies {
  MotionScene scene{};
  std::vector<std::pair<CellBody, CellBody>> pairs{};
};
ComparedBodies compared_bodies(const Cell& cell, int robot, const Trajectory& motion);

// Whether a robot counts with what it carries: in its hand, mounted on its links, and on that.
enum class Carried { kCounts, kLeftOut };

// Two things and how far they are apart.
//
// distance          m, below zero if they overlap, by so much.
// p_body, p_other   in the world: their nearest points, or those that lie deepest in the other one.
// at_least          they may overlap by more (is_whole_depth); told by `clearances`.
struct Clearance {
  CellBody body;   // of the first: a part of the robot, or what it carries
  CellBody other;  // of the second
  double distance = std::numeric_limits<double>::infinity();
  bool at_least = false;
  Eigen::Vector3d p_body = Eigen::Vector3d::Zero();
  Eigen::Vector3d p_other = Eigen::Vector3d::Zero();
};

// The smallest gap between two things of the cell as they are now, and the bodies that it is
// between. `robot` without an object is the robot with its hand, fingers included, of which what
// belongs to the other thing or lies on it does not count; frame and role do not count.
Clearance nearest_between(const Cell& cell, const CellBody& a, const CellBody& b,
                          Carried carried = Carried::kCounts);
inline double distance_between(const Cell& cell, const CellBody& a, const CellBody& b,
                               Carried carried = Carried::kCounts) {
  return nearest_between(cell, a, b, carried).distance;
}

// Another object that one lies in, deeper than bodies which rest on each other.
//
// at_least  the depth may be more, as of meshes that are not convex (is_whole_depth).
struct ObjectOverlap {
  std::string other;
  double depth = 0.0;  // m
  bool at_least = false;
};

// The one that it lies in deepest; nothing if there is none. Two fixed objects may be parts of one
// thing, and what a hand carries is where the hand brings it.
std::optional<ObjectOverlap> deepest_overlap(const World& world, const Object& object);

}  // namespace armlet
