// Hands with fingers: their contacts, how firm a grasp is, and closing until contact.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/grasp/grasp_quality.hpp"

namespace armlet {

// A link of a hand that touches an object: nearer than 0.01 mm.
//
// finger  0 to 2; -1: the palm.
// p       point of contact, in the world; inward: unit vector into the object, both m.
// force   normal force: the stiffness of the object times the depth, N.
struct FingerContact {
  int finger = -1;
  std::string object;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d inward = Eigen::Vector3d::UnitX();
  double force = 0.0;
  double friction = 0.0;
};

// Present contacts of a hand: finger by finger, from the palm outwards, objects in their order. The
// depth is the least displacement that separates the two bodies, so it depends on their poses
// alone.
//
// throws  ArgumentError unless the robot is a hand with fingers.
std::vector<FingerContact> finger_contacts(const Cell& cell, int hand);
// The present contacts of a hand whose palm has the joint values q.
std::vector<FingerContact> finger_contacts(const Cell& cell, int hand, const Eigen::VectorXd& q);

// The normal force of one finger, summed over its links, N.
double finger_force(const Cell& cell, int finger);

// Which forces count in the wrench that objects exert on a hand with fingers, or on a finger, about
// its tool point in world axes.
//
// kArm  leaves out forces of objects that the arm itself carries, since these move with it.
enum class FeltBy { kHand, kArm };
Vector6d finger_wrench(const Cell& cell, int robot, FeltBy by = FeltBy::kHand);

// The quality with which the contacts of a hand hold an object. Moments are about its centre of
// mass, divided by the largest distance of its surface from there.
GraspQuality hand_quality(const Cell& cell, int hand, std::string_view object);

// The part of an object's weight that its contacts carry with normal forces up to the present ones;
// 1 or more: they hold it. An object without a mass counts as one gram.
double carried_part(const Cell& cell, int arm, std::span<const FingerContact> contacts,
                    std::string_view object);

// The part of the load that the contacts carry, for the object that the fingers on an arm hold and
// the objects on it. The load is the weight and the inertia forces of the present motion; 1: all of
// it. Objects lighter than a gram count as at rest.
double carried_in_motion(const Cell& cell, int arm);

// The finger of a hand with the largest force, from 0, or -1 if none is in contact; that force, N,
// and the object with the largest part in it.
struct HardestFinger {
  int finger = -1;
  double force = 0.0;
  std::string object{};
};
HardestFinger hardest_finger(const Cell& cell, int hand);

// The joint angle at which a closing finger presses with `force`, or the end of its range.
//
// bend    of its first link, rad.
// touch   the bend at first contact; the end of the range if there is none.
struct Closing {
  double bend = 0.0;
  double touch = 0.0;
};

// No contact is missed: in each step no point of the finger can travel farther than the remaining
// gap, until the gap is below a tenth of a micrometre.
//
// force   N, > 0.
// source  conservative advancement: B. Mirtich, Impulse-based dynamic simulation of rigid body
//         systems, 1996, chapter 2.
Closing close_finger(const Cell& cell, int finger, double force);

// Closes all fingers of a hand, which bend equally fast. Two fingers that come within 0.01 mm of
// each other both stop; fingers that touch at the start and separate continue.
//
// throws  ArgumentError unless the robot is a hand with fingers. source  as close_finger.
std::vector<Closing> close_hand(const Cell& cell, int hand, double force);

}  // namespace armlet
