#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "armlet/core/owned.hpp"
#include "armlet/world/ball_grid.hpp"
#include "armlet/world/object.hpp"

namespace armlet {

// A body closer than this to a surface below it rests on it.
inline constexpr double kRestTolerance = 0.002;  // m

// The last frame of a carrier, to which its gripper is fixed.
inline constexpr int kFlange = -1;

// A body carried by a frame of a robot. The pose in that frame is stored once, so the body does not
// drift while it is carried.
//
// on       name of the carried body that it rests on and moves with; empty: the gripper itself
//          holds it, or it is mounted on the frame.
// frame    the joint of the carrier that moves it, 0: its base; or kFlange.
// mounted  it moves with a mounted body, not with the held one.
struct Attachment {
  int carrier = 0;
  Eigen::Isometry3d T_carrier_obj = Eigen::Isometry3d::Identity();
  std::string on{};
  int frame = kFlange;
  bool mounted = false;
};

// The result of a fall.
//
// distance  of the fall, m; down to -kRestTolerance if the body had sunk into the surface.
// support   name of what it rests on, "floor", or empty if there is nothing below: it does not
//           fall.
struct Drop {
  double distance = 0.0;
  std::string support;
};

// A body that fell because its support was removed.
struct Fall {
  std::string name;
  Drop drop;
};

// What a body or a frame is mounted on: a body or a frame, `on`; a frame of a carrier; or the
// world.
enum class FrameBase { kWorld, kObject, kFrame, kCarrier };
struct Mount {
  FrameBase base = FrameBase::kWorld;
  std::string on{};
  int carrier = -1;
  int frame = kFlange;
};

// A named frame, which moves with what it is mounted on.
//
// T_on_frame       its pose in the frame that it is mounted on.
// turned           whether its orientation was given (posC of programs).
// carrier, frame   as in Mount.
// T_world_carrier  present pose of that frame of the carrier.
struct NamedFrame {
  std::string name;
  FrameBase base = FrameBase::kWorld;
  std::string on{};
  Eigen::Isometry3d T_on_frame = Eigen::Isometry3d::Identity();
  bool turned = true;
  int carrier = -1;
  int frame = kFlange;
  Eigen::Isometry3d T_world_carrier = Eigen::Isometry3d::Identity();
};

// The height at which a body that moves straight down comes to rest on another one: z of its frame
// in the world, m; nothing if it passes.
using RestingHeight = std::optional<double> (*)(const Object& falling, const Object& below);

// Bodies by name, in the order in which they were inserted, and frames with names of their own.
class World {
 public:
  // floor_z  height of an unbounded floor, m; nothing: there is none.
  explicit World(std::optional<double> floor_z = std::nullopt);

  [[nodiscard]] std::optional<double> floor_z() const { return floor_z_; }

  // Sets the function that finds the height at which tilted bodies or bodies without a simple shape
  // rest. Null, the default: they count as their bounding boxes.
  void set_resting(RestingHeight resting) { resting_ = resting; }

  // Throws ArgumentError for a name that exists already and for what check_object refuses. The
  // rotation is made orthonormal to rounding. A body put onto a carried one moves with it.
  const Object& insert(Object object);

  // Removes a body and returns what fell, from the lowest. All that rested on it, directly or not,
  // falls straight down to the first surface, except fixed bodies and held ones.
  //
  // throws  ArgumentError for an unknown name; so do all functions below that take a name.
  std::vector<Fall> remove(std::string_view name);

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] const Object& object(std::size_t index) const { return bodies_[index]->object; }
  [[nodiscard]] std::vector<std::string> names() const;

  // Null if there is none. Pointers hold until the next insert or remove.
  [[nodiscard]] const Object* find(std::string_view name) const;
  [[nodiscard]] const Object& at(std::string_view name) const;

  // The existing name most like a mistyped one, for "did you mean"; nothing if none is similar.
  [[nodiscard]] std::optional<std::string> similar_name(std::string_view name) const;

  // Sets the pose of a body. A carried or fastened body is released first; a fixed one stays
  // fastened, with the new relative pose. Returns what fell, like `remove`.
  std::vector<Fall> set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj);

  // From now on the body keeps its present pose relative to the carrier, and what rests on it,
  // directly or not, moves with it.
  void attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier);
  // Releases a body, and with it what moves with it: the poses do not change.
  void detach(std::string_view name);
  [[nodiscard]] const std::optional<Attachment>& attachment(std::string_view name) const;
  [[nodiscard]] const std::optional<Attachment>& attachment_of(std::size_t index) const {
    return bodies_[index]->attachment;
  }
  // Indices of all bodies that are carried, ascending.
  [[nodiscard]] std::vector<std::size_t> carried() const;

  // Indices, ascending, of all bodies that reach into a ball; a few others near it may be among
  // them.
  [[nodiscard]] std::vector<std::size_t> near(const Eigen::Vector3d& middle, double radius) const;

  // Name of the body in a carrier's gripper; empty if there is none.
  [[nodiscard]] std::string_view carried_by(int carrier) const;

  // Moves what the carrier carries: T_world_obj = T_world_frame T_frame_obj.
  //
  // T_world_frames  its frames from the base on, the last one that of the gripper; that one alone
  //                 is enough if nothing is mounted on the others.
  void move_carried(int carrier, std::span<const Eigen::Isometry3d> T_world_frames);
  void move_carried(int carrier, const Eigen::Isometry3d& T_world_carrier) {
    move_carried(carrier, std::span(&T_world_carrier, 1));
  }

  // --- fastening (fastening.cpp) ----------------------------------------------------------------
  // Fastens a body to another one or to a frame of a carrier: it moves with that until a gripper
  // takes it or its pose is set. When the other body is removed, this one is released and falls.
  // throws  ArgumentError if the other one is the body itself or fastened on it.
  void fasten(std::string_view name, std::string_view on);
  void mount(std::string_view name, int carrier, int frame, const Eigen::Isometry3d& T_world_frame);
  // Whether anything was ever mounted on a carrier, bodies or frames.
  [[nodiscard]] bool has_mounted(int carrier) const;
  // Name of the body that it is fastened on; empty: none.
  [[nodiscard]] const std::string& fastened_on(std::size_t index) const {
    return bodies_[index]->fastened_on;
  }
  // Names of all fastened bodies of the thing to which this body belongs, in the order of
  // insertion.
  [[nodiscard]] std::vector<std::string> fastened_with(std::string_view name) const;
  // A body and all bodies fastened on it, directly or not: a thing.
  [[nodiscard]] std::vector<const Object*> thing(std::string_view name) const;
  // Whether two bodies belong to one thing: one is fastened on the other, directly or not, or both
  // on a third.
  [[nodiscard]] bool are_fastened(std::string_view a, std::string_view b) const;

  // Lets a body fall straight down to the first surface below it, without rotation, and then what
  // rests on it. A body that falls onto a carried one moves with it.
  Drop drop(std::string_view name);

  // The bodies that rest on a body or move with it, directly or not, in the order of insertion,
  // without fixed and held ones.
  [[nodiscard]] std::vector<std::string> stacked_on(std::string_view name) const;

  // What the body rests on within kRestTolerance ("floor" or a name); empty if nothing supports it.
  [[nodiscard]] std::string resting_on(std::string_view name) const;

  // --- frames ---------------------------------------------------------------------------------
  // Adds a frame on something that exists already, so that frames form a tree.
  // throws  ArgumentError for a name that is missing or in use, a matrix that is not a pose, and a
  //         mount that does not exist.
  void insert_frame(NamedFrame frame);
  // Null if there is none.
  [[nodiscard]] const NamedFrame* find_frame(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> frame_names() const;
  // The pose of a frame in the world; nothing if the body that it is mounted on, directly or not,
  // was removed.
  // throws  ArgumentError for an unknown name, as mount_of_frame.
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_world_frame(std::string_view name) const;
  // What a frame is finally mounted on, through other frames: a body, a frame of a carrier, or
  // nothing, the world.
  [[nodiscard]] Mount mount_of_frame(std::string_view name) const;
  // Sets the pose of a frame in the world; from now on it moves from there with what it is mounted
  // on.
  // throws  ArgumentError if that was removed, too.
  void set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame);

 private:
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_world_base(const NamedFrame& frame) const;
  // fastened, riding  numbers of the bodies fastened on it, and of those that move with it
  //                   (Attachment::on), ascending.
  struct Body {
    Object object;
    std::uint32_t id = 0;
    std::optional<Attachment> attachment{};
    std::string fastened_on{};
    Eigen::Isometry3d T_on_obj = Eigen::Isometry3d::Identity();
    std::vector<std::uint32_t> fastened{};
    std::vector<std::uint32_t> riding{};
  };
  struct NameHash : std::hash<std::string_view> {
    using is_transparent = void;
  };
  [[nodiscard]] std::size_t index_of(std::string_view name) const;
  [[nodiscard]] std::size_t index_of_id(std::uint32_t id) const;
  [[nodiscard]] Body* find_body(std::string_view name);
  [[nodiscard]] Body& body(std::string_view name) { return *bodies_[index_of(name)]; }
  [[nodiscard]] const Body& body(std::string_view name) const { return *bodies_[index_of(name)]; }
  [[nodiscard]] Body& body(std::uint32_t id) { return *bodies_[index_of_id(id)]; }
  [[nodiscard]] const Body& body(std::uint32_t id) const { return *bodies_[index_of_id(id)]; }
  // All changes of a body go through these functions, which keep the lists and grids consistent.
  void has_moved(const Body& body);
  void carry(Body& body, std::optional<Attachment> attachment);
  void fasten_to(Body& body, Body& lower);
  bool unfasten(Body& body);  // false: it was not fastened
  // Numbers of bodies that may touch an object, and of those that may be above or below it;
  // ascending.
  [[nodiscard]] std::vector<std::uint32_t> touching(const Object& object) const;
  [[nodiscard]] std::vector<std::uint32_t> in_column(const Object& object) const;
  // --- falling (falling.cpp)
  // A body, with what is fastened on it, and the distance of its fall.
  struct Landing {
    std::size_t body;
    Drop drop;
  };
  // A body above one of a list: which of the list, at what distance, and above which part of it.
  struct Above {
    std::size_t who;
    double gap;
    const Body* on;
  };
  using Parts = std::vector<const Body*>;
  [[nodiscard]] std::vector<std::vector<Above>> find_above(const std::vector<Parts>& parts) const;
  [[nodiscard]] std::optional<double> rests_at(const Object& falling, const Object& below) const;
  [[nodiscard]] std::optional<double> gap_above(const Object& part, const Object& below) const;
  [[nodiscard]] std::optional<Drop> fall(const Body& falling,
                                         const std::set<std::uint32_t>& falls = {}) const;
  [[nodiscard]] std::vector<Landing> land(const std::vector<std::size_t>& roots) const;
  void put_down(Body& body, const Drop& drop);
  // Whether `upper` would fall or move with `lower`.
  [[nodiscard]] bool is_carried_on(const Body& upper, const Body& lower) const;
  [[nodiscard]] const Body& lower_in(const std::set<std::uint32_t>& stack, const Body& upper) const;
  void ride(Body& body);
  std::vector<Fall> settle(const std::vector<std::string>& names);
  // Moves what is fastened on a body with it: one body, or all.
  void bring(const Body& lower, Body& upper);
  void bring_fastened(const Body& lower);
  // A body and the bodies that are fastened on it, directly or not.
  [[nodiscard]] std::vector<const Body*> compound(const Body& root) const;
  [[nodiscard]] std::string_view root_of(std::string_view name) const;
  void let_loose(const Body& removed, std::vector<std::string>& above);

  std::optional<double> floor_z_;
  RestingHeight resting_ = nullptr;
  template <class Value>
  using ByName = std::unordered_map<std::string, Value, NameHash, std::equal_to<>>;
  // Bodies have numbers that grow in the order of insertion and do not change when others are
  // removed.
  std::vector<Owned<Body>> bodies_;
  std::vector<std::uint32_t> ids_;  // of the same
  std::uint32_t next_id_ = 0;
  ByName<std::uint32_t> by_name_;
  std::set<std::uint32_t> carried_;
  BallGrid near_{BallGrid::Space::kWhole};
  BallGrid columns_{BallGrid::Space::kColumns};
  int fastened_ = 0;  // number of bodies that are fastened on others
  std::vector<NamedFrame> frames_;
  ByName<std::size_t> frame_index_;
  std::vector<int> mounted_;  // carriers on which something was mounted
};

}  // namespace armlet
