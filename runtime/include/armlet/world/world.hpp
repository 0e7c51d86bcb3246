#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/world/object.hpp"

namespace armlet {

// A body closer than this to a surface below it rests on it.
inline constexpr double kRestTolerance = 0.002;  // m

// A body carried by a frame of a robot. The pose in that frame is stored once, so that carrying
// never drifts.
//
// on  name of the carried body that it rests on and travels with; empty: the hand itself holds it.
struct Attachment {
  int carrier = 0;
  Eigen::Isometry3d T_carrier_obj = Eigen::Isometry3d::Identity();
  std::string on{};
};

// What a falling body found.
//
// distance  how far it fell, m; up to kRestTolerance below zero if it had sunk into the surface.
// support   name of what it rests on, "floor", or empty if there is nothing below: it stays.
struct Drop {
  double distance = 0.0;
  std::string support;
};

// A body that fell because what it rested on went away.
struct Fall {
  std::string name;
  Drop drop;
};

// A frame with a name, which moves with what it is on: a body or a frame, or nothing, the world.
//
// T_on_frame  its pose in the frame that it is on.
// turned      its orientation means something (posC of programs).
enum class FrameBase { kWorld, kObject, kFrame };
struct NamedFrame {
  std::string name;
  FrameBase base = FrameBase::kWorld;
  std::string on{};
  Eigen::Isometry3d T_on_frame = Eigen::Isometry3d::Identity();
  bool turned = true;
};

// Bodies by name, in the order in which they were inserted, and frames, whose names are their own.
class World {
 public:
  // floor_z  height of a floor that is everywhere, m; nothing: there is none.
  explicit World(std::optional<double> floor_z = std::nullopt);

  [[nodiscard]] std::optional<double> floor_z() const { return floor_z_; }

  // Throws ArgumentError for a name that exists already and for what check_object refuses. The
  // rotation is made orthonormal to rounding. A body put onto a carried one travels with it.
  const Object& insert(Object object);

  // Takes a body away and returns what fell, from the lowest: all that rested on it, directly or
  // not, falls straight down to the first surface; fixed bodies and what a hand holds stay.
  //
  // throws  ArgumentError for an unknown name; so do all functions below that take a name.
  std::vector<Fall> remove(std::string_view name);

  [[nodiscard]] std::size_t size() const { return bodies_.size(); }
  [[nodiscard]] const Object& object(std::size_t index) const { return bodies_[index].object; }
  [[nodiscard]] std::vector<std::string> names() const;

  // Null if there is none. Pointers hold until the next insert or remove.
  [[nodiscard]] const Object* find(std::string_view name) const;
  [[nodiscard]] const Object& at(std::string_view name) const;

  // The existing name most like a mistyped one, for "did you mean"; nothing if none is similar.
  [[nodiscard]] std::optional<std::string> similar_name(std::string_view name) const;

  // Puts a body somewhere; one that is carried is let go first. Returns what fell, as `remove`
  // does.
  std::vector<Fall> set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj);

  // The body keeps its present pose relative to the carrier from now on; what rests on it, directly
  // or not, travels with it.
  void attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier);
  // Lets it go, and with it what travels on it: all stay in place.
  void detach(std::string_view name);
  [[nodiscard]] const std::optional<Attachment>& attachment(std::string_view name) const;
  [[nodiscard]] const std::optional<Attachment>& attachment_of(std::size_t index) const {
    return bodies_[index].attachment;
  }

  // Name of the body that a carrier's hand holds; empty if none.
  [[nodiscard]] std::string_view carried_by(int carrier) const;

  // Moves what the carrier carries: T_world_obj = T_world_carrier T_carrier_obj.
  void move_carried(int carrier, const Eigen::Isometry3d& T_world_carrier);

  // Lets a body fall straight down to the first surface below it, keeping its orientation, and what
  // rests on it after it. A body that falls onto a carried one travels with it.
  Drop drop(std::string_view name);

  // What rests on a body or travels on it, directly or not, in the order of insertion; neither
  // fixed bodies nor what a hand holds.
  [[nodiscard]] std::vector<std::string> stacked_on(std::string_view name) const;

  // What the body rests on within kRestTolerance ("floor" or a name); empty if it hangs in the air.
  [[nodiscard]] std::string resting_on(std::string_view name) const;

  // --- frames ---------------------------------------------------------------------------------
  // A frame is on what is there already, so they are a tree.
  // throws  ArgumentError for a name that is missing or in use, a pose that is none, and what it
  //         would be on and is not there.
  void insert_frame(NamedFrame frame);
  // Null if there is none.
  [[nodiscard]] const NamedFrame* find_frame(std::string_view name) const;
  [[nodiscard]] std::vector<std::string> frame_names() const;
  // Where it is in the world; nothing if the body that carries it, directly or not, was removed.
  // throws  ArgumentError for an unknown name, as the next.
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_world_frame(std::string_view name) const;
  // Puts a frame somewhere in the world; from now on it moves from there with what it is on.
  // throws  ArgumentError if that was removed, too.
  void set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame);

 private:
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_world_base(const NamedFrame& frame) const;
  struct Body {
    Object object;
    std::optional<Attachment> attachment;
  };
  [[nodiscard]] std::size_t index_of(std::string_view name) const;
  [[nodiscard]] Drop fall(const Body& falling) const;
  // Whether `upper` would fall or travel with `lower`.
  [[nodiscard]] bool is_carried_on(const Body& upper, const Body& lower) const;
  void ride(Body& body);
  std::vector<Fall> settle(const std::vector<std::string>& names);

  std::optional<double> floor_z_;
  std::vector<Body> bodies_;
  std::vector<NamedFrame> frames_;
};

}  // namespace armlet
