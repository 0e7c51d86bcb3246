// What a run tells the outside, as values: one small struct for each kind of event.
//
// Every event has a time and a number. The numbers of a run count from 0 in the order in which the
// events are told, without gaps, and do not depend on who listens. Both go back only at an Undone.
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

// An object when it appears. `size`, m: x, y, z of a box; radius and height of what is round.
//
// glb      bytes of a GLB, shared with the mesh that they gave, for shape "mesh"; otherwise null.
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

// The run begins, with what is there.
struct BeginRun {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  RunInfo run;
};

// A robot that joins later; its index follows those before it.
struct RobotAdded {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  RobotInfo robot;
};

// A robot has another tool or tool point, or stands elsewhere: what it is from now on.
struct RobotChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  RobotInfo robot;
};

// State of one robot at one instant. The spans live only during the call.
//
// motion         number of the motion in the run; -1 while the robot stands.
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

// The name lives only during the call; so do those of other events.
struct ObjectSample {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  std::string_view name;
  Eigen::Isometry3d T_world_obj = Eigen::Isometry3d::Identity();
};

// kAttached and kDetached say which robot; kRemoved and kFell (what it rested on went away) have
// none (-1).
enum class ObjectChange { kAttached, kDetached, kRemoved, kFell };
struct ObjectEvent {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  ObjectChange change = ObjectChange::kAttached;
  std::string_view name;
  int robot = -1;
};

// kOutput is what the program prints, kMessage what went wrong, kAdvice what could be better.
enum class NoteKind { kOutput, kMessage, kAdvice };
struct Note {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  NoteKind kind = NoteKind::kOutput;
  std::string_view text;
};

// A figure has begun or has changed: the whole of it as it is now. Of a figure that changed before
// the run began only the last state is told, when it begins.
//
// index   of the figure in the run: they count from 0 as they are begun.
// figure  never null; it lives only during the call.
struct FigureChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  const Figure* figure = nullptr;
};

// A figure as the program left it, after everything else; index and figure as above.
struct FinalFigure {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  int index = 0;
  const Figure* figure = nullptr;
};

// Of what was told, the events with the numbers from `from` on are undone, because an entry failed
// or the session went elsewhere; those below it count, also where an earlier mark said otherwise.
// What is told next goes on with that number at the time `back_ns`, or where another run has come
// to that takes its place (Session::change, take_up).
//
// number  one more than that of the last event before it; it is given once more.
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

// A shape that is only shown has appeared, has changed, or is gone (`removed`): the whole of it as
// it is now. Those that were there before the run began come behind its beginning.
struct DrawingChanged {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  DrawingInfo drawing{};
  bool removed = false;
};

// A camera that joins after the run has begun. What it takes are ImageFrames (camera_info.hpp).
struct CameraAdded {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  CameraInfo camera{};
};

// What a backend is told. BeginRun comes first, and again behind an Undone from 0; EndRun last.
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

  // Those in both.
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

// Functions for different events as one, for std::visit:
//
//   std::visit(Overload{[](const Note& note) { ... }, [](const auto&) {}}, event);
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

// What a backend does with events that it ignores, in an Overload; kinds() is what it declares. An
// event that is neither handled nor ignored does not compile.
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
