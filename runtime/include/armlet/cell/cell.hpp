// One or more robots, a world, a clock and a backend: the only mutable state of a run.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/backend/backend.hpp"
#include "armlet/cell/cameras.hpp"
#include "armlet/cell/cell_robot.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/cell/contacts.hpp"
#include "armlet/cell/motion.hpp"
#include "armlet/cell/reports.hpp"
#include "armlet/cell/signals.hpp"
#include "armlet/cell/trails.hpp"
#include "armlet/math/twist.hpp"
#include "armlet/model/hands.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/world/drawings.hpp"
#include "armlet/world/world.hpp"

namespace armlet {

// tick_ns           period of evaluating conditions while one is armed.
// sample_period_ns  period of reporting moving robots to the backend.
// contact_picking   grippers close on objects of the task where a move ends, and open where a later
//                   move puts them on a surface.
struct CellOptions {
  std::int64_t tick_ns = 1'000'000;
  std::int64_t sample_period_ns = 10'000'000;
  bool contact_picking = false;
};

// Functions that take a robot throw ArgumentError for an index that does not exist; functions that
// take the name of an object throw it if there is no such object.
class Cell {
 public:
  explicit Cell(World world = World(), CellOptions options = {});

  // --- time -----------------------------------------------------------------------------------
  [[nodiscard]] std::int64_t now_ns() const { return clock_.now_ns(); }
  [[nodiscard]] const CellOptions& options() const { return options_; }
  void set_pacer(Pacer pacer) { clock_.set_pacer(std::move(pacer)); }
  void set_contact_picking(bool on) { options_.contact_picking = on; }

  // The earliest end of a motion, which may be now; nothing while all robots are at rest.
  [[nodiscard]] std::optional<std::int64_t> next_event() const;

  // The next instant after now at which conditions are evaluated: a multiple of the tick.
  [[nodiscard]] std::int64_t next_tick() const;

  // Advances time to t_ns: robots move, held objects move with them, motions end. Calling it again
  // with the same instant ends motions of no duration. The result does not depend on how an
  // interval is divided into calls.
  void advance_to(std::int64_t t_ns);

  // The events since the last call, in order.
  std::vector<CellEvent> take_events();

  // --- robots ---------------------------------------------------------------------------------
  // A robot at its home position; returns its index.
  // throws  ArgumentError for a null model or a name in use.
  int add_robot(std::shared_ptr<const Robot> model, std::string name = {});
  // Mounts a hand with fingers on the flange of an arm and moves the arm's tool point to between
  // the fingers. Returns the index of the hand with fingers; its fingers have the indices that
  // follow. An object that it holds is held by the arm: fingers take an object when their motion
  // ends, they press on it, and friction carries its weight. They release it when one of their
  // motions begins, or a motion of the arm ends, and they would no longer carry it (fingers.hpp).
  // throws  ArgumentError if `arm` is not an arm, moves, holds something or has one already.
  int add_hand(int arm, FingeredHand hand);
  // The index of the hand with fingers that an arm carries; -1: none.
  [[nodiscard]] int hand_on(int arm) const;
  [[nodiscard]] int robot_count() const { return static_cast<int>(robots_.size()); }
  [[nodiscard]] const CellRobot& robot(int index) const;
  [[nodiscard]] std::optional<int> find_robot(std::string_view name) const;
  // Replaces the model of a robot, for example its tool point. A held object keeps its pose.
  // throws  ArgumentError while the robot moves, except in a motion under forces, whose next piece
  //         follows the new model; or if the number of joints differs.
  void set_model(int robot, std::shared_ptr<const Robot> model);
  // Sets the joint values of a robot without a motion. Throws ArgumentError while it moves.
  void set_joints(int robot, const Eigen::VectorXd& q);

  // The tool point of a hand with fingers is that of its arm, whatever its own joint values.
  [[nodiscard]] Eigen::Isometry3d T_world_base(int robot) const;
  // Pose of the link that joint `frame` moves, 0: base, kFlange: flange; else ArgumentError.
  [[nodiscard]] Eigen::Isometry3d T_world_link(int robot, int frame) const;
  [[nodiscard]] Eigen::Isometry3d T_world_flange(int robot) const;
  [[nodiscard]] Eigen::Isometry3d T_world_tool(int robot) const;

  // Force and moment about the tool point, in world axes, that objects exert on the gripper, what
  // it carries and the links, without those of the held object on its gripper. An object exerts its
  // stiffness times the depth, along the normal at the point of first contact, and friction against
  // the sliding. The result does not depend on how time is divided into slices. For a hand with
  // fingers or a finger: the contact forces of its fingers, without friction.
  [[nodiscard]] Vector6d contact_wrench(int robot) const;
  // The contacts that make up contact_wrench; those of a hand with fingers are in finger_contacts.
  [[nodiscard]] std::vector<Press> presses(int robot) const;
  // The joint forces that correspond to these contacts: the sum of J' w over the bodies in contact,
  // each with the joints that move it, N m or N. The motors have to give that much less.
  [[nodiscard]] Eigen::VectorXd contact_forces(int robot) const;
  // Force and moment of the held object and of what rests on it: weight, and inertia during a
  // motion. About the tool point, in world axes; zero if the robot holds nothing.
  [[nodiscard]] Vector6d held_wrench(int robot) const;

  // --- motion ---------------------------------------------------------------------------------
  // Starts a verified trajectory now; returns the number of the motion.
  // throws  ArgumentError if the robot is moving or the trajectory does not start at its present
  //         joint values (within 1e-6 rad or m).
  int start(int robot, Trajectory trajectory);

  // Starts a motion that continues from the present joint values and speeds without a jump, and
  // ends at rest; returns its number. If the robot decelerates after a velocity command, that
  // motion ends now.
  //
  // held_ns  for a velocity command: until when it holds.
  // throws   ArgumentError if the trajectory does not start with the joint values (within 1e-6 rad
  //          or m) and speeds (1e-6 per s) of the robot, or unless can_drive.
  int drive(int robot, Trajectory trajectory, std::optional<std::int64_t> held_ns = {});

  // Moves a robot under forces, piece by piece. A piece is the simulated motion until the next
  // call, with the forces of the motors. The first call starts a motion of a robot at rest; every
  // later call continues it, at the end of the last piece or earlier; settle() brings the robot to
  // rest. Returns the number of the motion, which is the same for all pieces.
  // throws  ArgumentError if the robot executes another motion, or the piece does not start at the
  //         present state.
  int push(int robot, Trajectory piece, const Eigen::VectorXd& forces);

  // Ends a motion under forces: brings the robot to rest within its limits of speed and
  // acceleration and within its joint limits.
  void settle(int robot);
  // Whether the robot is at rest, or decelerates after a velocity command.
  [[nodiscard]] bool can_drive(int robot) const;
  [[nodiscard]] bool is_moving(int robot) const { return this->robot(robot).motion.has_value(); }

  // Brings a robot to rest on its path within its limits: see motion.hpp.
  void stop(int robot);
  // Stops a robot like stop(), but the stop is reported as requested from outside of the motion.
  void halt(int robot);
  [[nodiscard]] const MotionReport& report(int motion) const;
  // The instant up to which the course of a motion is known, at most its end; time has to pass
  // before more is known. Overload of the gripper stops the motion, under control, at the
  // nanosecond at which it begins.
  [[nodiscard]] std::int64_t known_until(int motion) const;

  // --- objects --------------------------------------------------------------------------------
  [[nodiscard]] const World& world() const { return world_; }
  void insert(Object object);
  // Adds an object that is mounted on `on`, in whose frame its pose is given. It moves with that
  // until a gripper takes it or its pose is set; a frame of the world only gives it its first pose.
  // throws  ArgumentError if there is no such mount.
  void insert(Object object, const Mount& on);
  // Removes an object. Objects that rested on it fall down to the first surface; returns them, the
  // lowest first. throws  ArgumentError if a gripper holds the object.
  std::vector<Fall> remove(std::string_view name);
  std::vector<Fall> set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj);

  // Named frames, as World has them.
  void insert_frame(NamedFrame frame);
  void set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame) {
    world_.set_frame(name, T_world_frame);
  }

  // The robot whose gripper holds an object; nothing if none does.
  [[nodiscard]] std::optional<int> holder_of(std::string_view name) const;
  // Makes an object part of the task, once: it is counted, and contact picking considers it.
  void add_to_task(std::string_view name);
  [[nodiscard]] const std::vector<std::string>& task_objects() const { return task_objects_; }
  // Closes the gripper of a robot on an object, whatever its distance: see gripper.hpp for the
  // rules. An object that two grippers hold follows the one that closed last.
  void take(int robot, std::string_view name);

  // Opens the gripper. An object that no other robot holds falls down to the first surface.
  // throws  ArgumentError if the robot holds nothing.
  Drop let_go(int robot);

  // --- shapes that are only shown, cameras ----------------------------------------------------
  // Shows a shape from now on, or replaces the one of that name. A frame of the world that it is
  // mounted on gives it its present pose.
  // throws  ArgumentError for what Drawings::put refuses, and if there is no such mount.
  void draw(Drawing drawing);
  bool undraw(std::string_view name);  // returns false if there is none
  [[nodiscard]] const Drawings& drawings() const { return drawings_; }
  [[nodiscard]] Trails& trails() { return trails_; }
  // The present pose of a drawing, and of a mount; ArgumentError if it does not exist.
  [[nodiscard]] Eigen::Isometry3d T_world_drawing(std::string_view name) const;
  [[nodiscard]] Eigen::Isometry3d T_world_mount(const Mount& on) const;
  [[nodiscard]] Cameras& cameras() { return cameras_; }
  [[nodiscard]] const Cameras& cameras() const { return cameras_; }
  // Cameras::add, and a report to the backend.
  int add_camera(Camera camera);
  // The picture that a camera takes from this pose, or `given` instead of it; it is counted and
  // reported to the backend. A camera with a rate has one picture at an instant.
  // throws  ArgumentError for a given picture of another size, or that is not RGB.
  Image capture(int camera, const Eigen::Isometry3d& T_world_camera,
                std::optional<Image> given = {});

  // --- signals and the outside ----------------------------------------------------------------
  [[nodiscard]] Signals& signals() { return signals_; }
  [[nodiscard]] const Signals& signals() const { return signals_; }

  // backend  not owned; null: nothing is reported. To be set before the run begins.
  void set_backend(Backend* backend) { backend_ = backend; }
  // Number of events reported to the backend; the next event has this number.
  [[nodiscard]] std::uint64_t events_told() const { return told_; }

  // Reports a note to the backend. Notes from before the first motion are kept until the run
  // begins, so that robots may still be added after them.
  void note(NoteKind kind, std::string_view text);
  // Begins the run for the backend. The first motion, passing of time or picture also begins it.
  void begin();
  // Reports to the backend that a figure has begun or has changed. Changes before the run begins
  // are kept like notes; only the last state of each figure is.
  void figure_changed(const Figure& figure);
  // Reports a complete figure to the backend.
  void figure(const Figure& figure);
  // Ends the run for the backend. No other call may follow.
  void end();

 private:
  struct PendingNote {
    std::int64_t t_ns;
    NoteKind kind;
    std::string text;
  };
  CellRobot& state(int index);
  // Records the contacts of this instant; to be called before any change other than of time.
  void settle_contacts();
  int execute(int index, Trajectory trajectory, std::optional<std::int64_t> held_ns);
  void begin_rest(int index, bool stopped);
  // Adds a robot, or a part of a hand with fingers on an arm.
  int join(std::shared_ptr<const Robot> model, std::string name, int on, int hand);
  // Updates the poses of hands with fingers and of their fingers.
  void follow_hands();
  // Takes or releases the object between the fingers on an arm, as their present contacts demand.
  void review_grip(int arm);
  // Releases the object before a motion of fingers that would end without holding it.
  void loosen_grip(int index, const Trajectory& motion);
  // Moves everything to its pose at an instant, which may be later than now.
  void bring_to(std::int64_t t_ns);
  // Computes what happens without a command (foresight.cpp). Returns the next instant that is not
  // known or at which such an event is due; nothing: there is none.
  std::optional<std::int64_t> look_ahead();
  void foresee(int index);
  [[nodiscard]] bool is_watched(int index) const;
  // The overloads of the gripper and of the links.
  [[nodiscard]] std::array<HandOverload, 2> pressed_at(int index, std::int64_t t_ns);
  template <class IsSo>
  std::optional<std::int64_t> first_instant(std::int64_t from, std::int64_t to, IsSo&& is_so);
  void forget_ahead();
  // Executes the events that are due now.
  void let_happen();
  void slip(int index, double carried, bool moving);
  // Moves what a robot holds, and what is mounted on it, with the robot.
  void carry_along(int index);
  // Updates `loaded` of all robots after a change of what grippers carry.
  void weigh_loads();
  // motion  that the robot executes or has just ended; -1: it is at rest without one.
  void publish(int index, int motion = -1);
  void publish_object(std::string_view name);
  void publish_falls(const std::vector<Fall>& falls);
  void publish_drawing(const Drawing& drawing, bool removed);
  void publish_camera(const Camera& camera);
  void publish_frame(const ImageFrame& frame);
  void refuse_held(std::string_view name, std::string_view what) const;
  template <class Told>
  void tell(Told&& event);
  void publish_event(ObjectChange change, std::string_view name, int robot);
  void end_due_motions();
  void end_motion(int index);
  [[nodiscard]] bool listening() const { return backend_ != nullptr && begun_; }
  [[nodiscard]] std::int64_t next_multiple(std::int64_t period_ns) const;

  World world_;
  Drawings drawings_;
  Trails trails_;
  Cameras cameras_;
  CellOptions options_;
  Clock clock_;
  Signals signals_;
  std::vector<CellRobot> robots_;
  std::vector<std::int64_t> published_ns_;  // when each robot was last reported
  std::vector<MotionReport> reports_;
  std::vector<CellEvent> events_;
  std::vector<std::string> task_objects_;
  std::vector<PendingNote> pending_notes_;
  std::vector<Figure> pending_figures_;
  std::vector<Eigen::Isometry3d> T_world_links_;  // of the last sample, if they are used
  mutable Contacts contacts_;                     // finds first touches when they are asked for
  Contacts contacts_ahead_;                       // the same for instants ahead of now
  std::vector<Foresight> ahead_;                  // of each robot; empty: nothing is known
  std::vector<PressLimit> press_limits_;          // of each robot, for its last motion
  Backend* backend_ = nullptr;
  std::uint64_t told_ = 0;  // events reported to the backend
  bool begun_ = false;
};

}  // namespace armlet
