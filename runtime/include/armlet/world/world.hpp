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

// The last frame of a carrier, in which its hand is.
inline constexpr int kFlange = -1;

// A body carried by a frame of a robot. The pose in that frame is stored once, so that carrying
// never drifts.
//
// on       name of the carried body that it rests on and travels with; empty: the hand itself holds
//          it, or it is mounted on the frame.
// frame    what joint `frame` of the carrier moves, 0: its base; or kFlange.
// mounted  it travels with what is mounted there, not with what the hand holds.
struct Attachment {
  int carrier = 0;
  Eigen::Isometry3d T_carrier_obj = Eigen::Isometry3d::Identity();
  std::string on{};
  int frame = kFlange;
  bool mounted = false;
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

// What a body or a frame is on: a body or a frame, `on`; a frame of a carrier; or the world.
enum class FrameBase { kWorld, kObject, kFrame, kCarrier };
struct Mount {
  FrameBase base = FrameBase::kWorld;
  std::string on{};
  int carrier = -1;
  int frame = kFlange;
};

// A frame with a name, which moves with what it is on.
//
// T_on_frame       its pose in the frame that it is on.
// turned           its orientation means something (posC of programs).
// carrier, frame   as in Mount.
// T_world_carrier  where that frame of the carrier is now.
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

// Where a body that moves straight down comes to rest on another one: the height of its frame in
// the world, m; nothing if it passes.
using RestingHeight = std::optional<double> (*)(const Object& falling, const Object& below);

// Bodies by name, in the order in which they were inserted, and frames, whose names are their own.
class World {
 public:
  // floor_z  height of a floor that is everywhere, m; nothing: there is none.
  explicit World(std::optional<double> floor_z = std::nullopt);

  [[nodiscard]] std::optional<double> floor_z() const { return floor_z_; }

  // How it is found where bodies rest that lean or have no simple shape. Null, as at first: they
  // count as the boxes around them.
  void set_resting(RestingHeight resting) { resting_ = resting; }

  // Throws ArgumentError for a name that exists already and for what check_object refuses. The
  // rotation is made orthonormal to rounding. A body put onto a carried one travels with it.
  const Object& insert(Object object);

  // Takes a body away and returns what fell, from the lowest: all that rested on it, directly or
  // not, falls straight down to the first surface; fixed bodies and what a hand holds stay.
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

  // Puts a body somewhere; one that is carried or fastened is let go first, unless it is fixed:
  // that stays on what it is on, from there. Returns what fell, as `remove` does.
  std::vector<Fall> set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj);

  // The body keeps its present pose relative to the carrier from now on; what rests on it, directly
  // or not, travels with it.
  void attach(std::string_view name, int carrier, const Eigen::Isometry3d& T_world_carrier);
  // Lets it go, and with it what travels on it: all stay in place.
  void detach(std::string_view name);
  [[nodiscard]] const std::optional<Attachment>& attachment(std::string_view name) const;
  [[nodiscard]] const std::optional<Attachment>& attachment_of(std::size_t index) const {
    return bodies_[index]->attachment;
  }
  // Indices of all bodies that are carried, ascending.
  [[nodiscard]] std::vector<std::size_t> carried() const;

  // Indices, ascending, of all bodies that come within a ball; some that only nearly do may be
  // among them.
  [[nodiscard]] std::vector<std::size_t> near(const Eigen::Vector3d& middle, double radius) const;

  // Name of the body that a carrier's hand holds; empty if none.
  [[nodiscard]] std::string_view carried_by(int carrier) const;

  // Moves what the carrier carries: T_world_obj = T_world_frame T_frame_obj.
  //
  // T_world_frames  its frames from the base on, the last one that of the hand; that one alone is
  //                 enough where nothing is mounted on the others.
  void move_carried(int carrier, std::span<const Eigen::Isometry3d> T_world_frames);
  void move_carried(int carrier, const Eigen::Isometry3d& T_world_carrier) {
    move_carried(carrier, std::span(&T_world_carrier, 1));
  }

  // --- fastening (fastening.cpp) ----------------------------------------------------------------
  // Fastens a body to another one or to a frame of a carrier: it goes where that goes, until a hand
  // takes it or it is put elsewhere. Of a body that is removed it is let go, and falls.
  // throws  ArgumentError if the other one is the body itself or fastened on it.
  void fasten(std::string_view name, std::string_view on);
  void mount(std::string_view name, int carrier, int frame, const Eigen::Isometry3d& T_world_frame);
  // Whether anything was ever mounted on a carrier, bodies or frames.
  [[nodiscard]] bool has_mounted(int carrier) const;
  // Name of the body that it is fastened on; empty: none.
  [[nodiscard]] const std::string& fastened_on(std::size_t index) const {
    return bodies_[index]->fastened_on;
  }
  // Names of all bodies that are fastened on others of the same thing as this one, in the order of
  // insertion.
  [[nodiscard]] std::vector<std::string> fastened_with(std::string_view name) const;
  // A body and all that is fastened on it, directly or not.
  [[nodiscard]] std::vector<const Object*> thing(std::string_view name) const;
  // Whether they belong to one thing: one of them is fastened on the other, directly or not, or
  // both on a third.
  [[nodiscard]] bool are_fastened(std::string_view a, std::string_view b) const;

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
  // What carries it, a body or a frame of a carrier, or nothing: the world; through other frames.
  [[nodiscard]] Mount mount_of_frame(std::string_view name) const;
  // Puts a frame somewhere in the world; from now on it moves from there with what it is on.
  // throws  ArgumentError if that was removed, too.
  void set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame);

 private:
  [[nodiscard]] std::optional<Eigen::Isometry3d> T_world_base(const NamedFrame& frame) const;
  // fastened, riding  numbers of the bodies that are fastened on it, and of those that travel on it
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
  // What is done to a body goes through these, which keep the lists and grids right.
  void has_moved(const Body& body);
  void carry(Body& body, std::optional<Attachment> attachment);
  void fasten_to(Body& body, Body& lower);
  bool unfasten(Body& body);  // false: it was not fastened
  // Bodies that may touch one, and those that may be above or below it; ascending.
  [[nodiscard]] std::vector<std::uint32_t> touching(const Object& object) const;
  [[nodiscard]] std::vector<std::uint32_t> in_column(const Object& object) const;
  // --- falling (falling.cpp)
  // A body, with what is fastened on it, and how far it falls.
  struct Landing {
    std::size_t body;
    Drop drop;
  };
  // What is above a body of a list: who of the list, how far, and on which part of it.
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
  // Whether `upper` would fall or travel with `lower`.
  [[nodiscard]] bool is_carried_on(const Body& upper, const Body& lower) const;
  [[nodiscard]] const Body& lower_in(const std::set<std::uint32_t>& stack, const Body& upper) const;
  void ride(Body& body);
  std::vector<Fall> settle(const std::vector<std::string>& names);
  // What is fastened on a body goes with it: one body, or all.
  void bring(const Body& lower, Body& upper);
  void bring_fastened(const Body& lower);
  // The bodies that are fastened on one, directly or not, and itself.
  [[nodiscard]] std::vector<const Body*> compound(const Body& root) const;
  [[nodiscard]] std::string_view root_of(std::string_view name) const;
  void let_loose(const Body& removed, std::vector<std::string>& above);

  std::optional<double> floor_z_;
  RestingHeight resting_ = nullptr;
  template <class Value>
  using ByName = std::unordered_map<std::string, Value, NameHash, std::equal_to<>>;
  // Bodies have numbers that rise in the order of insertion and stay when others are removed.
  std::vector<Owned<Body>> bodies_;
  std::vector<std::uint32_t> ids_;  // of the same
  std::uint32_t next_id_ = 0;
  ByName<std::uint32_t> by_name_;
  std::set<std::uint32_t> carried_;
  BallGrid near_{BallGrid::Space::kWhole};
  BallGrid columns_{BallGrid::Space::kColumns};
  int fastened_ = 0;  // how many bodies are fastened on others
  std::vector<NamedFrame> frames_;
  ByName<std::size_t> frame_index_;
  std::vector<int> mounted_;  // carriers on which something was mounted
};

}  // namespace armlet
