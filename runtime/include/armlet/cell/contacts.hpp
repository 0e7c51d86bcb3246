// What a hand presses against: first touches, and the forces that follow from the depth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "armlet/collision/arm_solids.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

struct CellRobot;

// What of a robot feels: what its hand carries, and the hand; the tool point, if it has no hand of
// a length of its own. On its last link.
//
// carried  name of the object; empty: part number `part` of the hand.
struct Feeler {
  std::string carried{};
  int part = 0;
  Solid solid{};
};

// First touches of a cell, as far as they last.
//
// A touch begins where two bodies have come 0.01 mm close, and lasts until they are farther apart
// at one of the instants that are whole milliseconds from the last begin or end of a motion. Its
// normal is the one at that first instant and stays fixed to the object. What is asked for at an
// instant is a function of the motions alone: neither the slices of time nor what was asked for
// before count.
class Contacts {
 public:
  // To be called before a motion begins or ends and before anything else changes than time.
  void settle(const std::vector<CellRobot>& robots, const World& world, std::int64_t now_ns);
  // An object was put elsewhere or a robot has another hand: what was touched there is forgotten.
  void forget_object(std::string_view name);
  void forget_robot(int robot);

  // Force and moment about the tool point that objects exert on the feelers of a robot, world axes.
  // With depth d, stiffness k of the object, sliding velocity v: k d along the normal, and
  // against v the friction mu k d, in proportion below 1 mm/s. mu is the smaller one of two
  // objects that touch.
  Vector6d wrench(const std::vector<CellRobot>& robots, const World& world, int robot,
                  std::int64_t now_ns);

 private:
  // normal_obj  in the frame of the object.
  // verified    number of the millisecond up to which the touch is known to last.
  struct Touch {
    int robot = 0;
    std::string carried{};
    int part = 0;
    std::string object{};
    Eigen::Vector3d normal_obj = Eigen::Vector3d::UnitZ();
    std::int64_t verified = 0;
  };
  // Where the tool point was when nothing that may be pressed was nearer to a feeler than `gap`, m;
  // `reach`, how far points of the feelers are from it, m.
  struct Clear {
    double gap = 0.0;
    double reach = 0.0;
    Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();

    [[nodiscard]] bool still_at(const Eigen::Isometry3d& T) const;
  };
  struct Scene;  // robots and world
  Touch& first_touch(const Scene& scene, int robot, const Feeler& feeler, std::size_t index,
                     std::int64_t now_ns);
  template <class Visit>
  Clear for_each_contact(const Scene& scene, int robot, std::int64_t now_ns, Visit&& visit);

  std::int64_t begin_ns_ = 0;
  std::vector<Touch> touches_;  // known at begin_ns_, and found since
  std::vector<Clear> clear_;    // of each robot, since nothing but time has changed
};

}  // namespace armlet
