// What a run tells the outside. Backends only listen: nothing they do changes the run.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/plot/figure.hpp"

namespace armlet {

// Unit of a joint's position; speeds and accelerations are per second and per second squared.
enum class JointUnit { kRadian, kMetre };

// A robot of the run. Its index in RunInfo names it in what follows.
struct RobotInfo {
  std::string name;
  std::vector<JointUnit> joints;
};

// An object when it appears. `size` is x, y, z of a box, radius and height of a cylinder, radius of
// a sphere, m.
struct ObjectInfo {
  std::string name;
  std::string shape;
  std::vector<double> size;
  double mass = 0.0;  // kg
  std::string color = "gray";
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
};

struct RunInfo {
  std::vector<RobotInfo> robots;
  std::vector<ObjectInfo> objects;
};

// State of one robot at one instant. The spans live only during the call.
struct JointSample {
  std::int64_t t_ns = 0;
  int robot = 0;
  std::span<const double> q;    // rad or m
  std::span<const double> qd;   // 1/s
  std::span<const double> qdd;  // 1/s^2
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
};

struct ObjectSample {
  std::int64_t t_ns = 0;
  std::string_view name;
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
};

// kAttached and kDetached say which robot; kRemoved and kFell (what it rested on went away) have
// none
// (-1).
enum class ObjectChange { kAttached, kDetached, kRemoved, kFell };
struct ObjectEvent {
  std::int64_t t_ns = 0;
  ObjectChange change = ObjectChange::kAttached;
  std::string_view name;
  int robot = -1;
};

// kOutput is what the program prints, kMessage what went wrong, kAdvice what could be better.
enum class NoteKind { kOutput, kMessage, kAdvice };
struct Note {
  std::int64_t t_ns = 0;
  NoteKind kind = NoteKind::kOutput;
  std::string_view text;
};

// Listens to a run. Calls come in the order of time: begin first, end last, each once. A backend
// overrides what it is interested in; none of them may throw because the outside fails.
class Backend {
 public:
  virtual ~Backend() = default;

  virtual void begin(const RunInfo&) {}

  // A robot that joins later; its index follows those before it.
  virtual void robot_added(std::int64_t /*t_ns*/, const RobotInfo&) {}
  virtual void joint_sample(const JointSample&) {}
  virtual void object_added(std::int64_t /*t_ns*/, const ObjectInfo&) {}
  virtual void object_sample(const ObjectSample&) {}
  virtual void object_event(const ObjectEvent&) {}
  virtual void note(const Note&) {}
  // A picture as the program left it, after everything else.
  virtual void figure(std::int64_t /*t_ns*/, const Figure&) {}
  virtual void end(std::int64_t /*t_ns*/) {}

  // Empty while everything was written; otherwise a sentence about the first thing that failed.
  [[nodiscard]] virtual std::string error() const { return {}; }
};

// "attached", "detached" or "removed"; "output", "message" or "advice".
std::string_view to_text(ObjectChange change);
std::string_view to_text(NoteKind kind);

}  // namespace armlet
