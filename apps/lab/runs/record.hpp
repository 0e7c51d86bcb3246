#pragma once
// What is known of a run: everything that pages show of it, in lists that only grow.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "armlet/backend/event.hpp"
#include "armlet/backend/run_marks.hpp"
#include "armlet/cell/signals.hpp"
#include "armlet/model/link_shapes.hpp"
#include "armlet/model/robot.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"
#include "armlet/stdlib/session.hpp"
#include "messages/request.hpp"
#include "messages/text_message.hpp"
#include "messages/text_places.hpp"
#include "recorded_cameras.hpp"
#include "recorded_drawings.hpp"
#include "rows.hpp"
#include "shown_files.hpp"

namespace armlet::lab {

// Names of the files that pages draw (shown_files.hpp); empty: none.
struct ObjectFiles {
  std::string glb;
  std::string texture;
};

// A robot has another tool, or stands elsewhere, from a time on.
struct RobotChange {
  double t = 0.0;
  RobotInfo robot;
  std::shared_ptr<const Robot> model;
};
struct RecordedRobot {
  RobotInfo info;
  std::shared_ptr<const Robot> model;
  std::vector<RobotChange> changes;
  std::vector<std::string> pictures;  // names of the files of info.pictures
};

// A way around what stood in the way, as it was planned at `t`; it takes `duration`, s.
//
// path  of the tool point, in the world, at even times.
// arms  joint values at some times in between.
struct RecordedWay {
  int robot = 0;
  double t = 0.0;
  double duration = 0.0;
  std::vector<Eigen::Vector3d> path;
  std::vector<Eigen::VectorXd> arms;
};

// A motion that has ended; `text` is the function as called.
struct RecordedMove {
  int robot = 0;
  int motion = -1;
  std::optional<TextSpan> span;
  double t0 = 0.0;
  double t1 = 0.0;
  std::string text;
  bool stopped = false;
  Eigen::Vector3d p_end = Eigen::Vector3d::Zero();  // of the tool point, in the world
};
// What a task did, or a signal was, for a time that has ended.
//
// name   of the task, empty for the program itself, or of the signal.
// span   the statement of the task.
// value  of the signal.
struct RecordedStretch {
  enum class Kind : std::uint8_t { kTask, kSignal };
  Kind kind = Kind::kTask;
  std::string name;
  double t0 = 0.0;
  double t1 = 0.0;
  std::optional<TextSpan> span;
  std::optional<SignalValue> value;
};
struct RecordedLine {
  double t = 0.0;
  int line = 0;
};
// `what` is "added" or that of an event.
struct RecordedChange {
  double t = 0.0;
  std::string what;
  int object = 0;
  int robot = -1;
};
// element  the button whose function says so; empty: the program does.
struct RecordedText {
  double t = 0.0;
  NoteKind kind = NoteKind::kOutput;
  std::string text;
  std::optional<TextSpan> span;
  std::string element;
};
struct RecordedFigure {
  int index = 0;
  std::string title;
  std::string svg;
};

// What is on the page of a laboratory.
//
// ranges     of the axes of each row, m or rad; none but for sliders of a hand.
// has_block  otherwise these are the elements of a program that says nothing of a page.
struct LabElements {
  LabRows rows;
  std::vector<std::vector<std::array<double, 2>>> ranges;
  std::vector<std::vector<std::string>> units;  // SI, of the columns of plots that have been read
  std::vector<std::optional<TextSpan>> places;  // of the rows in the text
  std::vector<std::string> pictures;            // names of the files of rows; empty: none
  bool has_block = false;
  bool is_new = true;
};

enum class RunState : std::uint8_t { kRunning, kDone, kFailed, kStopped };

// What somebody did to a run.
struct RunInput {
  double t = 0.0;
  InputWhat what;
};

// A run as a whole.
struct RunHead {
  int number = 0;
  RunState state = RunState::kRunning;
  double t_end = 0.0;
  std::string label;
  std::string world;  // its name; empty: the program has asked for none
  std::optional<int> parent;
  std::optional<double> parts_at;
  std::int64_t text_version = 0;
  std::vector<RunInput> inputs;
  std::string hash;
  std::optional<TextMessage> error;
  std::vector<TextMessage> advice;  // that it gave, with times; only the first of very many
  RecordedDrawings drawings;        // shapes that are only shown
  RecordedCameras cameras;
  std::uint64_t changes = 1;    // counts what has happened to the fields above
  std::uint64_t described = 0;  // to the robots and objects
  std::uint64_t figure_changes = 0;
};

struct RunRecord : RunHead {
  std::vector<RecordedRobot> robots;
  std::vector<ObjectInfo> objects;
  std::vector<ObjectFiles> object_files;
  std::vector<std::optional<TextSpan>> object_places;  // where the program makes them
  std::vector<Rows> robot_rows;
  std::vector<Rows> force_rows;    // t and what the motors give, of robots with masses
  std::vector<Rows> contact_rows;  // t and Cell::contact_wrench, from where something is touched
  std::vector<Rows> object_rows;
  std::vector<RecordedMove> moves;
  std::vector<RecordedWay> ways;
  std::vector<RecordedStretch> stretches;
  std::vector<RecordedLine> lines;
  std::vector<RecordedChange> events;
  std::vector<RecordedText> texts;
  std::vector<RecordedFigure> figures;
  std::optional<LabElements> lab;
  std::vector<Rows> element_rows;  // of plots, in the order of the elements
  std::size_t file_bytes = 0;      // of files that no other run had

  SessionLog log;              // when it has ended
  std::vector<RunMark> marks;  // the same

  [[nodiscard]] std::size_t bytes() const;
  // Where the program was at a time; 0: it has not begun.
  [[nodiscard]] int line_at(double t) const;
  [[nodiscard]] std::optional<int> find_robot(std::string_view name) const;
  // What the robot is at a time.
  [[nodiscard]] std::shared_ptr<const Robot> model_at(int robot, double t) const;
  // Joint values of a robot at a time: those of the last row until then.
  [[nodiscard]] std::vector<double> joints_at(int robot, double t) const;
};

// Listens to a session and fills a record. The record and the files outlive it.
class Recording : public Backend {
 public:
  Recording(RunRecord& record, ShownFiles& files) : record_(record), files_(files) {}

  // The session that it listens to, before its run.
  void listen_to(Session& session) { session_ = &session; }
  void on(const Event& event) override;
  // From on_move, `advice` and on_press of the session.
  void on_move(const MoveReport& report);
  void on_advice(const Diagnostic& advice);
  void on_press(const PressReport& report);
  // From `pace` of the session: time is about to pass, so that what the program has come to lasts.
  void on_wait();
  // What the run has come to when it ends: loads that have changed since time passed.
  void on_end();
  // Reads off what the cell knows beside its events: models of the robots, the name of the world.
  void look_at_models();
  // Cameras, and how many pictures they took.
  void look_at_cameras();
  // The same of the pictures of a page.
  void keep_pictures(LabElements& lab);
  // The same of objects: where the program declares those that were there when the run began. While
  // the session has paused.
  void look_at_objects();

 private:
  void take(const BeginRun& begin);
  void take(const RobotAdded& added);
  void take(const RobotChanged& changed);
  void take(const JointSample& sample);
  void take(const ObjectAdded& added);
  void take(const ObjectSample& sample);
  void take(const ObjectEvent& event);
  void take(const Note& note);
  void take(const DrawingChanged& changed);
  void add_robot(const RobotInfo& robot);
  void add_object(const ObjectInfo& object, double t);
  void note_line(double t);
  void end_motion(int robot);
  std::string keep_file(FileBytes& bytes);
  void take_ways();
  void take_stretches(double t);
  void take_contacts(int robot, double t);
  void take_forces(const JointSample& sample);
  void take_forces_at_rest(double t);
  void add_forces(int robot, std::span<const double> row, bool is_break);
  [[nodiscard]] std::optional<TextSpan> here() const;
  [[nodiscard]] std::optional<int> find_object(std::string_view name) const;

  struct Motion {
    int number = -1;
    RecordedMove move;
    std::vector<double> last_row;
  };
  // What the motors of a robot have given last.
  //
  // loaded  the arm with its load then, if it stood; otherwise null.
  struct Forces {
    std::shared_ptr<const Robot> loaded;
    std::vector<double> last_row;
  };
  // When what a robot touches was looked at last, and whether it was anything.
  struct Touch {
    double t = 0.0;
    bool is_touching = false;
  };

  // A stretch that goes on.
  struct Going {
    RecordedStretch::Kind kind = RecordedStretch::Kind::kTask;
    std::string name;
    Span at{};
    std::optional<SignalValue> value;
    double t0 = 0.0;
    [[nodiscard]] auto place() const { return std::tie(kind, name, at.source, at.begin, at.end); }
    [[nodiscard]] bool is_same(const Going& other) const {
      return place() == other.place() && value == other.value;
    }
  };
  // Positions of stretches, those of tasks and signals of the same name and place beside each
  // other.
  static std::vector<std::size_t> order_of(const std::vector<Going>& all);
  void end_stretch(const Going& going, double t);

  RunRecord& record_;
  ShownFiles& files_;
  std::vector<Going> going_;
  std::vector<std::size_t> going_order_;  // order_of(going_)
  Session* session_ = nullptr;
  std::vector<Motion> motions_;  // of each robot
  std::vector<Forces> forces_;   // the same
  std::vector<Touch> touches_;   // the same
  std::size_t looked_at_ = 0;    // objects
};

}  // namespace armlet::lab
