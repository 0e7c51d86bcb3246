// Events of a run as values: one small struct for each kind.
//
// Every event has a time and a number. The numbers of a run count from 0 in the order of the
// events, without gaps, and do not depend on the listeners. Both decrease only at an Undone.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "armlet/backend/camera_info.hpp"
#include "armlet/backend/drawing_info.hpp"
#include "armlet/backend/robot_info.hpp"
#include "armlet/plot/figure.hpp"

namespace armlet {

// An object when it appears. `size`, m: x, y, z of a box; radius and height of round shapes.
//
// glb      bytes of a GLB, shared with the mesh made from them, for shape "mesh"; otherwise null.
// T_obj_glb  from the coordinates of that file, z up, to those of the object.
// texture  bytes of a PNG or JPEG, shared with the world; null: none.
struct ObjectInfo {
  std::string name;
  std::string shape;
  std::vector<double> size;
  double mass = 0.0;  // kg
  std::string color = "gray";
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
  std::shared_ptr<const std::string> glb;
  Eigen::Affine3d T_obj_glb = Eigen::Affine3d::Identity();
  std::shared_ptr<const std::string> texture;
};

struct RunInfo {
  std::vector<RobotInfo> robots;
  std::vector<ObjectInfo> objects;
  std::vector<CameraInfo> cameras{};
};

// The run begins, with these robots, objects and cameras.
struct BeginRun {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  RunInfo run;
};

// A robot that is added later; its index follows the existing ones.
struct RobotAdded {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  RobotInfo robot;
};

// A robot has another tool, tool point or base pose; its data from now on.
struct RobotChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  RobotInfo robot;
};

// State of one robot at one instant. The spans are valid only during the call.
//
// motion         number of the motion in the run; -1 while the robot is at rest.
// T_world_links  frames of the links, one for each joint, if a backend wants them; otherwise empty.
struct JointSample {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int robot = 0;
  int motion = -1;
  std::span<const double> q;    // rad or m
  std::span<const double> qd;   // 1/s
  std::span<const double> qdd;  // 1/s^2
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  std::span<const Eigen::Isometry3d> T_world_links;
};

struct ObjectAdded {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  ObjectInfo object;
};

// The name is valid only during the call, as in other events.
struct ObjectSample {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  std::string_view name;
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
};

// kAttached and kDetached have a robot; kRemoved and kFell (its support was removed) have none
// (-1).
enum class ObjectChange { kAttached, kDetached, kRemoved, kFell };
struct ObjectEvent {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  ObjectChange change = ObjectChange::kAttached;
  std::string_view name;
  int robot = -1;
};

// kOutput is printed by the program, kMessage is an error, kAdvice an improvement.
enum class NoteKind { kOutput, kMessage, kAdvice };
struct Note {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  NoteKind kind = NoteKind::kOutput;
  std::string_view text;
};

// A figure has begun or has changed; the event has the complete figure. Of figures that changed
// before the run begins only the last state is reported, at the beginning.
//
// index   of the figure in the run: they count from 0 in the order of their beginnings.
// figure  never null; it is valid only during the call.
struct FigureChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  const Figure* figure = nullptr;
};

// A figure at the end of the program, after all other events; index and figure as above.
struct FinalFigure {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  const Figure* figure = nullptr;
};

// Marks the events with the numbers from `from` on as undone, because an entry failed or the
// session went to another time. Events below it count, even if an earlier mark undid them. The next
// event continues with that number at the time `back_ns`, or at the time of the run that replaces
// this one (Session::change, take_up).
//
// number  one more than that of the last event before it; the next event has the same number.
struct Undone {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  std::uint64_t from = 0;
  std::int64_t back_ns = 0;
};

struct EndRun {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
};

// A shape that is only shown has appeared, has changed, or is removed (`removed`); the event has
// the complete shape. Shapes from before the run began are reported after its beginning.
struct DrawingChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  DrawingInfo drawing{};
  bool removed = false;
};

// A camera that is added after the run has begun. Its pictures are ImageFrames (camera_info.hpp).
struct CameraAdded {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  CameraInfo camera{};
};

// The events that a backend receives. BeginRun comes first, and again after an Undone from 0;
// EndRun last.
using Event = std::variant<BeginRun, RobotAdded, RobotChanged, JointSample, ObjectAdded,
                           ObjectSample, ObjectEvent, Note, FigureChanged, FinalFigure, Undone,
                           EndRun, DrawingChanged, CameraAdded, ImageFrame>;

// The alternatives of Event, in their order.
enum class EventKind : std::size_t {
  kBeginRun,
  kRobotAdded,
  kRobotChanged,
  kJointSample,
  kObjectAdded,
  kObjectSample,
  kObjectEvent,
  kNote,
  kFigureChanged,
  kFinalFigure,
  kUndone,
  kEndRun,
  kDrawingChanged,
  kCameraAdded,
  kImageFrame,
};
inline constexpr std::size_t kEventKinds = std::variant_size_v<Event>;

[[nodiscard]] inline EventKind kind_of(const Event& event) {
  return static_cast<EventKind>(event.index());
}
[[nodiscard]] inline std::int64_t time_of(const Event& event) {
  return std::visit([](const auto& each) { return each.t_ns; }, event);
}
[[nodiscard]] inline std::uint64_t number_of(const Event& event) {
  return std::visit([](const auto& each) { return each.number; }, event);
}

// A set of kinds of events.
class EventKinds {
 public:
  constexpr EventKinds() = default;

  // The kinds of these structs: EventKinds::of<Note, JointSample>().
  template <class... Events>
  [[nodiscard]] static constexpr EventKinds of() {
    EventKinds kinds;
    ((kinds.bits_ |= bit(index_of<Events>(static_cast<Event*>(nullptr)))), ...);
    return kinds;
  }
  [[nodiscard]] static constexpr EventKinds all() {
    EventKinds kinds;
    kinds.bits_ = bit(kEventKinds) - 1;
    return kinds;
  }

  [[nodiscard]] constexpr bool has(EventKind kind) const {
    return (bits_ & bit(static_cast<std::size_t>(kind))) != 0;
  }

  // The intersection.
  friend constexpr EventKinds operator&(EventKinds one, EventKinds other) {
    one.bits_ &= other.bits_;
    return one;
  }
  bool operator==(const EventKinds&) const = default;

 private:
  static constexpr std::uint32_t bit(std::size_t index) { return std::uint32_t{1} << index; }

  template <class Wanted, class... All>
  static constexpr std::size_t index_of(const std::variant<All...>*) {
    static_assert((std::is_same_v<Wanted, All> || ...), "not an alternative of Event");
    std::size_t index = 0;
    (void)((std::is_same_v<Wanted, All> || (++index, false)) || ...);
    return index;
  }

  std::uint32_t bits_ = 0;
};

// Combines functions for different events into one, for std::visit:
//
//   std::visit(Overload{[](const Note& note) { ... }, [](const auto&) {}}, event);
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

// In an Overload: the kinds of events that a backend ignores; kinds() returns them. An event that
// is neither handled nor ignored does not compile.
template <class Ignored>
struct IgnoreOne {
  constexpr void operator()(const Ignored&) const {}
};
template <class... Ignored>
struct Ignore : IgnoreOne<Ignored>... {
  using IgnoreOne<Ignored>::operator()...;
  [[nodiscard]] static constexpr EventKinds kinds() { return EventKinds::of<Ignored...>(); }
};

// "attached", "detached", "removed" or "fell"; "output", "message" or "advice".
std::string_view to_text(ObjectChange change);
std::string_view to_text(NoteKind kind);
// The name of its struct: "JointSample".
std::string_view to_text(EventKind kind);

}  // namespace armlet
