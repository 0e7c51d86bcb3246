#pragma once
// The host of a robot program: one cell on a virtual clock, and what the library knows about it.

#include <Eigen/Geometry>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/model/urdf.hpp"
#include "armlet/plot/figure.hpp"
#include "armlet/stdlib/host_frames.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "armlet/stdlib/mesh_converter.hpp"
#include "armlet/trajectory/planner.hpp"
#include "armlet/trajectory/velocity.hpp"

namespace armlet {

class Journal;

// A finished motion, for listeners that show progress.
struct FinishedMove {
  std::string robot;
  std::string function;   // as called: "moveJ"
  double start = 0.0;     // s
  double duration = 0.0;  // s
  bool stopped = false;   // by a guard
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
};

// A button of a laboratory was pressed, and the task that it started has ended.
struct PressReport {
  std::string button;
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
  std::optional<Diagnostic> failure{};  // why it failed, or that it was cancelled
};

// One move of a motion that consists of several moves.
struct MotionPart {
  std::string what;     // "moveL to (300, 0, 150) mm"
  double end = 0.0;     // s, its end from the start of the motion
  double missed = 0.0;  // m, the distance by which it passes its target
};

// Facts about a motion that the trajectory itself does not contain.
//
// deviation, turn  largest deviation of the tool from its path, m and rad.
struct MotionNotes {
  std::vector<MotionPart> parts{};
  double deviation = 0.0;
  double turn = 0.0;
};

// The motion of a robot that was started last, as it was planned.
struct LastMotion {
  std::string function;  // as called: "moveJ"
  Trajectory motion;
  MotionNotes notes{};
};

// The tool velocity that the program requested for a motion, and how the motion reaches it.
struct LastVelocity {
  int motion = -1;
  Vector6d twist = Vector6d::Zero();
  ToolTakeUp take_up{};
};

// A velocity command. Its robot comes to rest at its end unless another command follows at once.
struct LastRest {
  int motion = -1;
  Trajectory path;
  std::string function;  // as called: "speedJ"
  CallPlace place{};
};

// A goal of the tool that a robot could not reach, and the nearest pose that it can reach.
//
// q_nearest  joint values of that pose; empty: none was found.
struct UnreachedGoal {
  std::int64_t t_ns = 0;
  int robot = -1;
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  Eigen::VectorXd q_nearest{};
  Eigen::Isometry3d T_world_nearest = Eigen::Isometry3d::Identity();
  double distance = 0.0;  // m
  double angle = 0.0;     // rad
};

// A path around obstacles, as it was planned.
struct PlannedWay {
  std::int64_t t_ns = 0;
  int robot = 0;
  std::shared_ptr<const Robot> model;  // with the tool point of the motion
  Trajectory motion{};
};

// A planner of the host, as PlannerSet::add takes it.
struct NamedPlanner {
  std::string name;
  Planner plan;
  Through through = Through::kStops;
};

struct HostOptions {
  std::shared_ptr<const Robot> robot;  // for programs that declare none; null: no robot
  std::vector<NamedPlanner> planners;  // in addition to the built-in ones
  std::function<void(const FinishedMove&)> on_move;
  // Called before the clock advances to t, and at each multiple of 10 ms before that; may sleep.
  // False: the program must stop. Null: the clock advances at once.
  std::function<bool(std::int64_t t_ns)> pace;
  // The folder below which the program may write files; empty: none.
  std::filesystem::path folder{};
  MeshConverter convert_mesh{};          // null: of mesh formats, only GLB can be read
  PackageFolders packages{};             // folders in which descriptions of robots may name meshes
  std::function<bool()> is_cancelled{};  // returns whether the program must stop; null: never
  HostFrames frames{};                   // camera pictures that the host supplies
  // Fills an empty world when a program names an object and no world was given. Null: there is no
  // default world, and insertObj makes a stand-in. `skip`: names that the program declares.
  std::function<void(class Host&, const std::vector<std::string>& skip)> default_world;
  // The journal of the session that runs the program; null: inputs from outside are not recorded.
  Journal* journal = nullptr;
};

// A kind of file that a function of the language writes: "a table", with one of these extensions.
struct FileKind {
  std::string_view what;
  std::span<const std::string_view> endings;
};

class Host : public Timeline {
 public:
  explicit Host(HostOptions options);

  // The host of a running program.
  //
  // throws  ArgumentError if the Vm was made without one.
  static Host& of(Vm& vm) {
    if (vm.host() == nullptr) [[unlikely]]
      refuse_no_host();
    return *static_cast<Host*>(vm.host());
  }

  [[nodiscard]] Cell& cell() { return cell_; }
  [[nodiscard]] const Cell& cell() const { return cell_; }
  [[nodiscard]] const PlannerSet& planners() const { return planners_; }
  [[nodiscard]] PlannerSet& planners() { return planners_; }

  // ---- robots
  [[nodiscard]] Result<int> add_robot(std::shared_ptr<const Robot> robot);
  // The host's own robot; it is put into the cell when it is first needed.
  [[nodiscard]] Result<int> default_robot();
  [[nodiscard]] std::shared_ptr<const Robot> default_robot_model() const { return options_.robot; }
  // The only robot of the cell (or the host's own, if the cell has none); otherwise null.
  [[nodiscard]] const Robot* only_robot() const;

  // ---- the world
  void set_world_name(std::string name) { world_name_ = std::move(name); }
  [[nodiscard]] const std::string& world_name() const { return world_name_; }
  [[nodiscard]] bool has_world() const { return !world_name_.empty(); }
  // Starts to fill the world: until it is full, files are read from this folder, if it has a name,
  // and each mesh is read once.
  void begin_world(std::filesystem::path folder) {
    world_folder_ = std::move(folder);
    fills_world_ = true;
  }
  void end_world() {
    world_folder_.clear();
    fills_world_ = false;
    world_meshes_.clear();
  }
  // Called when the program names an object: adds the default world if no world was given.
  void want_world(const std::vector<std::string>& declared);
  // While a default world is filled: whether this object is left out because the program declares
  // one of that name.
  [[nodiscard]] bool is_skipped(std::string_view name) const;

  // take_events: events of the cell since the last call. first_contact_pick: true only for the
  // first pick by contact, the one that is reported.
  [[nodiscard]] std::vector<CellEvent> take_events();
  [[nodiscard]] bool first_contact_pick();
  [[nodiscard]] bool first_fall();  // the same for objects that lost their support
  // Whether this call reports these two bodies for the first time; whether it reported them before.
  [[nodiscard]] bool first_collision(const void* call, std::string pair);
  [[nodiscard]] bool knows_collision(const void* call, const std::string& pair) const;

  // Writes a file of the program. `name` is relative to the folder that the host allowed, stays
  // below it, has an extension of its kind and follows no link. If the file cannot be written
  // completely, the old one stays. Fails with the reason. A silent run writes nothing
  // (host/journal.hpp).
  [[nodiscard]] Result<std::filesystem::path> save_file(const FileKind& kind,
                                                        const std::string& name,
                                                        std::string_view content) const;

  // The bytes of a mesh as GLB, from the file that has_mesh finds; at most 128 MB.
  // unit  length of one unit of the file, m; 0: as its format says.
  [[nodiscard]] Result<std::string> load_mesh(const std::string& file, const std::string& mesh,
                                              double unit = 0.0) const;
  // The bytes as GLB of a mesh file of the program, from the file that load_file finds. unit
  // length of one unit of the file, m; 0: as its format says.
  [[nodiscard]] Result<std::string> load_shape(const std::string& name, double unit) const;
  // The text of a file of the program; the same rule for `name`. Fails with the reason.
  // most  bytes; a larger file is refused.
  [[nodiscard]] Result<std::string> load_file(const std::string& name,
                                              std::size_t most = 16 << 20) const;
  // Whether this mesh exists in a file that the program names; `file` empty: in the program itself.
  [[nodiscard]] bool has_mesh(const std::string& file, const std::string& mesh) const;
  // A picture from HostFrames::take; nullopt: the pictures of this camera are rendered.
  [[nodiscard]] std::optional<Result<std::string>> host_frame(const FrameRequest& asked) const;

  // The figures of the program, in the order in which it began them.
  [[nodiscard]] std::vector<Figure>& figures() { return figures_; }
  [[nodiscard]] const std::vector<Figure>& figures() const { return figures_; }
  Figure& begin_figure(Figure figure);  // it becomes the last figure and gets the next index
  void figure_changed();                // reports to listeners that the last figure has changed

  // The contents of the `lab` block of the program; null: no such block has been executed.
  void set_lab(LabRows lab) { lab_ = std::move(lab); }
  [[nodiscard]] const LabRows* lab() const { return lab_ ? &*lab_ : nullptr; }

  void remember_motion(int robot, LastMotion motion);
  // Null if the robot has not moved.
  [[nodiscard]] const LastMotion* last_motion(int robot) const;

  void remember_velocity(int robot, LastVelocity velocity);
  // Null unless the robot is still moving after a velocity command.
  [[nodiscard]] const LastVelocity* last_velocity(int robot) const;

  void remember_rest(int robot, LastRest rest);
  [[nodiscard]] std::optional<LastRest> take_rest(int robot);  // of the last command; given once

  // The last goal that was out of reach, for displays of the run; null: all goals were reached.
  void note_unreached(UnreachedGoal goal) { unreached_ = std::move(goal); }
  [[nodiscard]] const UnreachedGoal* unreached() const {
    return unreached_ ? &*unreached_ : nullptr;
  }

  // The paths around obstacles that were planned, for displays of the run; the first kMostWays.
  static constexpr std::size_t kMostWays = 500;
  void note_way(PlannedWay way);
  [[nodiscard]] const std::vector<PlannedWay>& ways() const { return ways_; }

  void report_move(const FinishedMove& report);
  [[nodiscard]] int move_count() const { return moves_; }

  // ---- Timeline
  [[nodiscard]] std::int64_t now_ns() const override;
  [[nodiscard]] std::int64_t tick_ns() const override;
  bool advance_to(std::int64_t t_ns) override;

 private:
  [[noreturn]] static void refuse_no_host();
  // Writes no content if the run writes no files; the name is checked in any case.
  [[nodiscard]] Result<std::filesystem::path> write(const FileKind& kind, const std::string& name,
                                                    std::string_view content) const;
  [[nodiscard]] Result<std::string> read(const std::string& name, std::size_t most) const;
  [[nodiscard]] Result<std::string> read_mesh(const std::string& name, double unit) const;
  [[nodiscard]] const std::filesystem::path& folder_of_files() const {
    return world_folder_.empty() ? options_.folder : world_folder_;
  }
  [[nodiscard]] std::string mesh_path(const std::string& file, const std::string& mesh) const;
  [[nodiscard]] bool finds_mesh(const std::string& file, const std::string& mesh) const;
  bool pace_to(std::int64_t t_ns);

  HostOptions options_;
  Cell cell_;
  PlannerSet planners_;
  std::vector<std::optional<LastMotion>> last_motions_;
  std::vector<std::optional<LastVelocity>> last_velocities_;
  std::vector<std::optional<LastRest>> last_rests_;
  std::optional<UnreachedGoal> unreached_;
  std::vector<PlannedWay> ways_;
  int default_robot_ = -1;
  std::string world_name_;
  std::filesystem::path world_folder_;
  bool fills_world_ = false;
  mutable std::map<std::string, std::string> world_meshes_;  // meshes read so far
  std::vector<Figure> figures_;
  std::optional<LabRows> lab_;
  std::vector<std::string> skipped_;
  bool filling_ = false;
  bool contact_pick_reported_ = false;
  bool fall_reported_ = false;
  std::set<std::pair<const void*, std::string>> collisions_reported_;
  int moves_ = 0;
};

}  // namespace armlet
