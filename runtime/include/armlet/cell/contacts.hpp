// Contacts of robots with objects: when they begin, and the forces that follow from the depth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "armlet/collision/arm_solids.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

struct CellRobot;

// A body of a robot on which contact forces are measured: what its gripper carries, the gripper (or
// the tool point if no gripper with a length is mounted), and the links.
//
// carried  name of the object; empty: body number `part` of the robot's ArmSolids, or kToolPoint.
// frame    the joint that moves it; 0: the base.
// solid    with its T in that frame.
// speed    bound on the speed of all its points as long as only time changes, m/s.
struct Feeler {
  static constexpr int kToolPoint = -1;
  std::string carried{};
  int part = kToolPoint;
  int frame = 0;
  bool of_hand = true;
  Solid solid{};
  double speed = 0.0;
};

// A contact in which a body of a robot presses on an object.
//
// carried, part, frame, of_hand  the body, as in Feeler.
//
// p         point of contact, in the world, m.
// force     that the object exerts there, normal force and friction, world axes, N.
// normal    magnitude of the normal force, N.
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

// Contacts of a cell, from their begin to their end.
//
// A contact begins when two bodies are within 0.01 mm. It ends when they are farther apart at one
// of the instants that are whole milliseconds after the last begin or end of a motion. Its normal
// is the one at the first instant and stays fixed to the object. The result for an instant is a
// function of the motions alone: neither the slices of time nor earlier calls influence it.
class Contacts {
 public:
  // To be called before a motion begins or ends and before any change other than of time.
  void settle(const std::vector<CellRobot>& robots, const World& world, std::int64_t now_ns);
  // An object was moved or a robot has another gripper: ends the contacts with it.
  void forget_object(std::string_view name);
  void forget_robot(int robot);
  // Must be called when the objects that grippers carry have changed since `settle`.
  void look_again() { seen_.clear(); }

  // The contacts of a robot, in the order of its bodies: carried ones first, then gripper and
  // links. With depth d, stiffness k of the object and sliding velocity v the force is k d along
  // the normal, and friction mu k d against v, reduced in proportion below 1 mm/s. mu is the
  // smaller coefficient of the two objects.
  //
  // t_ns  not before the instant of an earlier call, as long as only time has changed.
  std::vector<Press> presses(const std::vector<CellRobot>& robots, const World& world, int robot,
                             std::int64_t t_ns);

  // To be called after presses(): until when the robot certainly has no contact, as long as only
  // time changes; the instant of that call if it may have one.
  [[nodiscard]] std::int64_t clear_until(int robot) const;
  // The last begin or end of a motion, from which whole milliseconds are counted.
  [[nodiscard]] std::int64_t begin_ns() const { return begin_ns_; }

 private:
  // normal_obj  in the frame of the object.
  // verified    number of the millisecond up to which the contact is known to last.
  struct Touch {
    int robot = 0;
    std::string carried{};
    int part = 0;
    std::string object{};
    Eigen::Vector3d normal_obj = Eigen::Vector3d::UnitZ();
    std::int64_t verified = 0;
  };
  // Until when a body certainly has no contact.
  struct Free {
    std::int64_t from_ns = 0;
    std::int64_t until_ns = 0;
    [[nodiscard]] bool at(std::int64_t t_ns) const { return t_ns >= from_ns && t_ns < until_ns; }
  };
  // When a feeler is free, and from what this follows: its clearance at T_world_feeler, m.
  struct Room {
    Free free{};
    double room = -1.0;
    Eigen::Isometry3d T_world_feeler = Eigen::Isometry3d::Identity();
  };
  // The bodies of a robot on which forces are measured, and when each of them and all are free.
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
  std::vector<Seen> seen_;       // of each robot; valid while only time changes
  std::vector<double> reaches_;  // of the objects of the world, m
};

}  // namespace armlet
