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

// tick_ns           how often conditions are to be evaluated while one is armed.
// sample_period_ns  how often moving robots are reported to the backend.
// contact_picking   hands close on objects of the task where a move ends, and open where a later
//                   move puts them on a surface.
struct CellOptions {
  std::int64_t tick_ns = 1'000'000;
  std::int64_t sample_period_ns = 10'000'000;
  bool contact_picking = false;
};

// Functions that take a robot throw ArgumentError for an index that does not exist, functions that
// take an object's name for one that does not.
class Cell {
 public:
  explicit Cell(World world = World(), CellOptions options = {});

  // --- time -----------------------------------------------------------------------------------
  [[nodiscard]] std::int64_t now_ns() const { return clock_.now_ns(); }
  [[nodiscard]] const CellOptions& options() const { return options_; }
  void set_pacer(Pacer pacer) { clock_.set_pacer(std::move(pacer)); }
  void set_contact_picking(bool on) { options_.contact_picking = on; }

  // The earliest end of a motion, which may be now; nothing while all robots stand still.
  [[nodiscard]] std::optional<std::int64_t> next_event() const;

  // The next instant after now at which conditions are evaluated: a multiple of the tick.
  [[nodiscard]] std::int64_t next_tick() const;

  // Lets time pass until t_ns: robots move, held objects with them, motions end. An instant may be
  // given again to end motions that take no time. Cutting a stretch into pieces changes nothing.
  void advance_to(std::int64_t t_ns);

  // What happened since the last call, in order.
  std::vector<CellEvent> take_events();

  // --- robots ---------------------------------------------------------------------------------
  // A robot at its home position; returns its index.
  // throws  ArgumentError for a null model or a name in use.
  int add_robot(std::shared_ptr<const Robot> model, std::string name = {});
  // Mounts a hand with fingers on the flange of an arm, whose tool point goes to between the
  // fingers; returns the index of the hand, behind which its fingers follow. What it holds, the arm
  // holds: fingers that press on an object and carry its weight by friction take it where their
  // motion ends, and let it go where a motion of theirs begins or of the arm ends at which they no
  // longer would (fingers.hpp).
  // throws  ArgumentError for an arm that is none, moves, holds something or has such a hand.
  int add_hand(int arm, FingeredHand hand);
  // The hand with fingers that an arm carries; -1: none.
  [[nodiscard]] int hand_on(int arm) const;
  [[nodiscard]] int robot_count() const { return static_cast<int>(robots_.size()); }
  [[nodiscard]] const CellRobot& robot(int index) const;
  [[nodiscard]] std::optional<int> find_robot(std::string_view name) const;
  // Exchanges what a robot is, for example its tool point; what it holds stays where it is.
  // throws  ArgumentError while it moves, but for a motion under forces, whose next piece is
  //         that of the new model; or if the number of joints differs.
  void set_model(int robot, std::shared_ptr<const Robot> model);
  // Puts a robot into a position without moving it. Throws ArgumentError while it moves.
  void set_joints(int robot, const Eigen::VectorXd& q);

  // Of a hand with fingers the tool point is that of the arm, whatever its joints do.
  [[nodiscard]] Eigen::Isometry3d T_world_base(int robot) const;
  // What joint `frame` moves, 0: the base; or kFlange. throws  ArgumentError for another one.
  [[nodiscard]] Eigen::Isometry3d T_world_link(int robot, int frame) const;
  [[nodiscard]] Eigen::Isometry3d T_world_flange(int robot) const;
  [[nodiscard]] Eigen::Isometry3d T_world_tool(int robot) const;

  // Force and moment about the tool point that the objects exert which the robot presses its hand,
  // what that carries, or its links into, in world axes; what the hand holds does not count. An
  // object pushes back with its stiffness times the depth, along the normal at the point of first
  // touch, and with friction against the sliding. The same for slices of time of any size. Of a
  // hand with fingers or a finger: what its fingers press with, without friction.
  [[nodiscard]] Vector6d contact_wrench(int robot) const;
  // The parts of which it is made, but for those of a hand with fingers (finger_contacts).
  [[nodiscard]] std::vector<Press> presses(int robot) const;
  // What they exert on the joints: the sum of J' w over the bodies that are pressed, each with the
  // joints that move it, N m or N. Motors have to give as much less.
  [[nodiscard]] Eigen::VectorXd contact_forces(int robot) const;
  // The same of what the hand holds and what rests on it: its weight, and its inertia as it is
  // moved. Zero if it holds nothing.
  [[nodiscard]] Vector6d held_wrench(int robot) const;

  // --- motion ---------------------------------------------------------------------------------
  // Starts a verified trajectory now; returns the number of the motion.
  // throws  ArgumentError if the robot is moving or the trajectory does not start where it stands
  //         (within 1e-6 rad or m).
  int start(int robot, Trajectory trajectory);

  // Starts a motion that goes on from the position and the speed of the robot, without a step, and
  // ends at rest; returns its number. If the robot slows down after a velocity command, that motion
  // ends now.
  //
  // held_ns  for a velocity command: until when it holds.
  // throws   ArgumentError if the trajectory does not start with the position (within 1e-6 rad or
  //          m) and speed (1e-6 per s) of the robot, or unless can_drive.
  int drive(int robot, Trajectory trajectory, std::optional<std::int64_t> held_ns = {});

  // Moves a robot under forces, piece by piece: the motion that simulation found for the time until
  // the next call, and what the motors give in it. The first call starts a motion of a robot that
  // stands, every other one goes on with it, at the end of the piece before or earlier; settle()
  // brings the robot to rest. Returns the number of the motion, which is the same for all pieces.
  // throws  ArgumentError if the robot moves otherwise, or the piece does not start where it is.
  int push(int robot, Trajectory piece, const Eigen::VectorXd& forces);

  // Ends a motion under forces: brings the robot to rest as its limits allow, inside of the limits
  // of its joints.
  void settle(int robot);
  // Whether the robot stands, or slows down after a velocity command.
  [[nodiscard]] bool can_drive(int robot) const;
  [[nodiscard]] bool is_moving(int robot) const { return this->robot(robot).motion.has_value(); }

  // Brings a robot to rest on its path as its limits allow: see motion.hpp.
  void stop(int robot);
  // The same from outside of the motion, and it is reported as such.
  void halt(int robot);
  [[nodiscard]] const MotionReport& report(int motion) const;
  // Up to which instant it is known how a motion goes on, at most its end: time has to pass up to
  // there before more is known. A hand that is pressed harder than it can stand stops the motion,
  // under control, at the nanosecond at which that begins.
  [[nodiscard]] std::int64_t known_until(int motion) const;

  // --- objects --------------------------------------------------------------------------------
  [[nodiscard]] const World& world() const { return world_; }
  void insert(Object object);
  // An object on something, in whose frame its pose is given: it goes where that goes until a hand
  // takes it or it is put elsewhere; on a frame of the world it is only placed there.
  // throws  ArgumentError for what it would be on and is not there.
  void insert(Object object, const Mount& on);
  // What rested on the object falls straight down to the first surface; returns what fell, from the
  // lowest.
  // throws  ArgumentError if a hand holds the object.
  std::vector<Fall> remove(std::string_view name);
  std::vector<Fall> set_pose(std::string_view name, const Eigen::Isometry3d& T_world_obj);

  // Frames with names, as World has them.
  void insert_frame(NamedFrame frame);
  void set_frame(std::string_view name, const Eigen::Isometry3d& T_world_frame) {
    world_.set_frame(name, T_world_frame);
  }

  // The robot whose hand is closed on an object; nothing if none is.
  [[nodiscard]] std::optional<int> holder_of(std::string_view name) const;
  // Makes an object part of the task: it is counted, and contact picking considers it. Naming it
  // twice counts once.
  void add_to_task(std::string_view name);
  [[nodiscard]] const std::vector<std::string>& task_objects() const { return task_objects_; }
  // Closes the hand of a robot on an object, whatever its distance: see gripper.hpp for the rules.
  // An object that another hand holds as well follows the hand that closed last.
  void take(int robot, std::string_view name);

  // What nobody else holds falls straight down to the first surface.
  // throws  ArgumentError if the hand is empty.
  Drop let_go(int robot);

  // --- shapes that are only shown, cameras ----------------------------------------------------
  // Shows a shape from now on, or changes the one of that name. On a frame of the world it goes
  // where that is now.
  // throws  ArgumentError for what Drawings::put refuses, and what it would be on and is not there.
  void draw(Drawing drawing);
  bool undraw(std::string_view name);  // false: there is none
  [[nodiscard]] const Drawings& drawings() const { return drawings_; }
  [[nodiscard]] Trails& trails() { return trails_; }
  // Where its frame is now, and one that something is mounted on; ArgumentError: it is not there.
  [[nodiscard]] Eigen::Isometry3d T_world_drawing(std::string_view name) const;
  [[nodiscard]] Eigen::Isometry3d T_world_mount(const Mount& on) const;
  [[nodiscard]] Cameras& cameras() { return cameras_; }
  [[nodiscard]] const Cameras& cameras() const { return cameras_; }
  // Cameras::add, and tells the backend.
  int add_camera(Camera camera);
  // The picture that a camera takes from there, or `given` instead of it, counted and told to the
  // backend. A camera with a rate has one picture at an instant: who asks again gets that one.
  // throws  ArgumentError for a given picture of another size, or that is not RGB.
  Image capture(int camera, const Eigen::Isometry3d& T_world_camera,
                std::optional<Image> given = {});

  // --- signals and the outside ----------------------------------------------------------------
  [[nodiscard]] Signals& signals() { return signals_; }
  [[nodiscard]] const Signals& signals() const { return signals_; }

  // backend  not owned; null: nobody listens. To be set before the run begins.
  void set_backend(Backend* backend) { backend_ = backend; }
  // How many events the backend was told; the next one has this number.
  [[nodiscard]] std::uint64_t events_told() const { return told_; }

  // Tells the backend. What is said before the first motion is kept until the run begins, so that
  // robots may be added after it.
  void note(NoteKind kind, std::string_view text);
  // Begins the run for the backend; a motion, passing of time or a picture does so by itself.
  void begin();
  // Tells the backend that a figure has begun or has changed. What changes before the run begins is
  // kept as notes are, the last state of each figure.
  void figure_changed(const Figure& figure);
  // Hands the backend a figure as the program left it.
  void figure(const Figure& figure);
  // Ends the run for the backend. Nothing may happen afterwards.
  void end();

 private:
  struct PendingNote {
    std::int64_t t_ns;
    NoteKind kind;
    std::string text;
  };
  CellRobot& state(int index);
  // What is touched now is known from here on: to be called before anything but time changes.
  void settle_contacts();
  int execute(int index, Trajectory trajectory, std::optional<std::int64_t> held_ns);
  void begin_rest(int index, bool stopped);
  // A robot, or a part of a hand on an arm.
  int join(std::shared_ptr<const Robot> model, std::string name, int on, int hand);
  // Fingers stand as their hand moves them, and the hand as they do.
  void follow_hands();
  // Takes or lets go what the fingers on an arm hold as they stand.
  void review_grip(int arm);
  // Before a motion of a finger, or of a whole hand, that would end holding nothing.
  void loosen_grip(int index, const Trajectory& motion);
  // Everything where it is at an instant, also ahead of now.
  void bring_to(std::int64_t t_ns);
  // What happens by itself (foresight.cpp). The next instant that is not known, or at which
  // something is due; nothing: there is none.
  std::optional<std::int64_t> look_ahead();
  void foresee(int index);
  [[nodiscard]] bool is_watched(int index) const;
  // Of the hand and of the links.
  [[nodiscard]] std::array<HandOverload, 2> pressed_at(int index, std::int64_t t_ns);
  template <class IsSo>
  std::optional<std::int64_t> first_instant(std::int64_t from, std::int64_t to, IsSo&& is_so);
  void forget_ahead();
  // What is due now.
  void let_happen();
  void slip(int index, double carried, bool moving);
  // What a robot holds, and what is mounted on it, goes with it.
  void carry_along(int index);
  // Brings `loaded` of all robots up to date after a change of what hands carry.
  void weigh_loads();
  // motion  that the robot executes or has just ended; -1: it stands without one.
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
  std::vector<Eigen::Isometry3d> T_world_links_;  // of the last sample, if they are wanted
  mutable Contacts contacts_;                     // finds first touches when they are asked for
  Contacts contacts_ahead_;                       // the same for instants ahead of now
  std::vector<Foresight> ahead_;                  // of each robot; empty: nothing is known
  std::vector<PressLimit> press_limits_;          // of each robot, for its last motion
  Backend* backend_ = nullptr;
  std::uint64_t told_ = 0;  // events that the backend was told
  bool begun_ = false;
};

}  // namespace armlet
