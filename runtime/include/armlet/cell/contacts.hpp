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

// A body of a robot that feels what it is pressed into: what its hand carries, the hand or the tool
// point, if it has no hand of a length of its own, and its links.
//
// carried  name of the object; empty: body number `part` of the robot's ArmSolids, or kToolPoint.
// frame    what joint `frame` moves, 0: the base.
// solid    with its T in that frame.
// speed    no point of it is faster as long as nothing but time changes, m/s.
struct Feeler {
  static constexpr int kToolPoint = -1;
  std::string carried{};
  int part = kToolPoint;
  int frame = 0;
  bool of_hand = true;
  Solid solid{};
  double speed = 0.0;
};

// A body of a robot that is pressed into an object.
//
// carried, part, frame, of_hand  which one, as in Feeler.
//
// p         the point of pressure, in the world, m.
// force     that the object exerts there, normal force and friction, world axes, N.
// normal    the normal force alone, N.
// friction  coefficient between the two.
struct Press {
  std::string carried{};
  int part = Feeler::kToolPoint;
  int frame = 0;
  bool of_hand = true;
  std::string object{};
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  double normal = 0.0;
  double friction = 0.0;
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
  // What hands carry has changed since `settle`.
  void look_again() { seen_.clear(); }

  // What a robot presses into, in the order of its bodies, carried ones first, hand and links after
  // them. With depth d, stiffness k of the object, sliding velocity v: k d along the normal, and
  // against v the friction mu k d, in proportion below 1 mm/s. mu is the smaller one of two
  // objects that touch.
  //
  // t_ns  not before what was asked for since nothing but time has changed.
  std::vector<Press> presses(const std::vector<CellRobot>& robots, const World& world, int robot,
                             std::int64_t t_ns);

  // Behind presses(): until when it is certain that the robot presses on nothing, as long as
  // nothing but time changes; the instant that was asked for if it may.
  [[nodiscard]] std::int64_t clear_until(int robot) const;
  // The last begin or end of a motion: instants are counted in whole milliseconds from there.
  [[nodiscard]] std::int64_t begin_ns() const { return begin_ns_; }

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
  // When it is certain that something presses on nothing.
  struct Free {
    std::int64_t from_ns = 0;
    std::int64_t until_ns = 0;
    [[nodiscard]] bool at(std::int64_t t_ns) const { return t_ns >= from_ns && t_ns < until_ns; }
  };
  // When a feeler is free, and what follows from: the room that it had at T_world_feeler, m.
  struct Room {
    Free free{};
    double room = -1.0;
    Eigen::Isometry3d T_world_feeler = Eigen::Isometry3d::Identity();
  };
  // What of a robot feels, and when each part of it, and all, is free.
  struct Seen {
    bool is_known = false;
    std::vector<Feeler> feelers{};
    std::vector<Room> rooms{};
    Free all{};
  };
  struct Scene;  // robots and world
  Touch& first_touch(const Scene& scene, int robot, const Feeler& feeler, std::size_t index,
                     std::int64_t now_ns);
  Seen& seen(const Scene& scene, int robot);
  template <class Visit>
  void for_each_contact(const Scene& scene, int robot, std::int64_t now_ns, Visit&& visit);
  template <class Visit>
  double look_around(const Scene& scene, int robot, const Feeler& feeler, const Solid& body,
                     const Eigen::Vector3d& approach, std::int64_t now_ns, Visit&& visit);

  std::int64_t begin_ns_ = 0;
  std::vector<Touch> touches_;   // known at begin_ns_, and found since
  std::vector<Seen> seen_;       // of each robot, since nothing but time has changed
  std::vector<double> reaches_;  // of the objects of the world, m
};

}  // namespace armlet
