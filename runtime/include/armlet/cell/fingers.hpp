// Hands with fingers: what their fingers press on, how well that holds, and closing until contact.
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
// p       where, in the world; inward: unit vector into the object, both m.
// force   that it presses with: the stiffness of the object times the depth, N.
struct FingerContact {
  int finger = -1;
  std::string object;
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d inward = Eigen::Vector3d::UnitX();
  double force = 0.0;
  double friction = 0.0;
};

// Contacts of a hand as it stands now, finger by finger from the palm outwards, objects in their
// order. The depth is the least that would free the two, so it depends on where they are alone.
//
// throws  ArgumentError unless the robot is a hand with fingers.
std::vector<FingerContact> finger_contacts(const Cell& cell, int hand);
// The same with the palm's joints at q.
std::vector<FingerContact> finger_contacts(const Cell& cell, int hand, const Eigen::VectorXd& q);

// What one finger presses with, the sum over its links, N.
double finger_force(const Cell& cell, int finger);

// What objects exert on a hand with fingers, or on a finger, about its tool point, world axes.
//
// by  kArm: nothing of what the arm carries itself, with which it goes along.
enum class FeltBy { kHand, kArm };
Vector6d finger_wrench(const Cell& cell, int robot, FeltBy by = FeltBy::kHand);

// How well the contacts of a hand hold an object; moments about its centre of mass, divided by the
// distance of its surface there.
GraspQuality hand_quality(const Cell& cell, int hand, std::string_view object);

// The part of the weight of an object that contacts carry by pressing with no more than they do:
// 1 or more: they hold it. An object without a mass counts as one gram.
double carried_part(const Cell& cell, int arm, std::span<const FingerContact> contacts,
                    std::string_view object);

// The same of what the fingers on an arm hold, for its weight and its inertia as the arm moves now,
// and what lies on it; 1: all of it. Objects lighter than a gram count as at rest.
double carried_in_motion(const Cell& cell, int arm);

// The finger of a hand that presses hardest, from 0, -1 if none does, with what, N, and what on
// most.
struct HardestFinger {
  int finger = -1;
  double force = 0.0;
  std::string object{};
};
HardestFinger hardest_finger(const Cell& cell, int hand);

// Where a finger that closes first presses with `force`, or the end of its way.
//
// bend    of its first link, rad.
// touch   the bend at which it first touches something; the end of the way if nothing.
struct Closing {
  double bend = 0.0;
  double touch = 0.0;
};

// Nothing is left out: the finger goes on by no more than no point of it can travel the gap that is
// left, until that is below a tenth of a micrometre.
//
// force   N, > 0.
// source  conservative advancement: B. Mirtich, Impulse-based dynamic simulation of rigid body
//         systems, 1996, chapter 2.
Closing close_finger(const Cell& cell, int finger, double force);

// The same of all fingers of a hand, which bend equally fast: where one comes to within 0.01 mm of
// another, both stop. Fingers that touch at the begin and come apart may go on.
//
// throws  ArgumentError unless the robot is a hand with fingers.
// source  as close_finger.
std::vector<Closing> close_hand(const Cell& cell, int hand, double force);

}  // namespace armlet
