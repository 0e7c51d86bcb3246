#pragma once
// The record of a run: all data that pages show of it, in lists that only grow.

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
#include "armlet/plot/figure.hpp"
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

// From a time on, a robot has another tool or another base pose.
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

// A path around obstacles, as it was planned at `t`; it takes `duration`, s.
//
// path  of the tool point, in the world, at equal time intervals.
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
// An interval in which a task executed one statement, or a signal had one value.
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
// `what` is "added" or the word of an event.
struct RecordedChange {
  double t = 0.0;
  std::string what;
  int object = 0;
  int robot = -1;
};
// element  the button whose function printed it; empty: the program printed it.
struct RecordedText {
  double t = 0.0;
  NoteKind kind = NoteKind::kOutput;
  std::string text;
  std::optional<TextSpan> span;
  std::string element;
};
// plot  the values of a figure in the plane, so that pages can draw it themselves; nullopt: it is in
//       space, a picture, has bars, or has too many values.
struct RecordedFigure {
  int index = 0;
  std::string title;
  std::string svg;
  std::optional<Figure> plot{};
};
// Whether the figure, or each of its panels, has lines and points in the plane and nothing else.
[[nodiscard]] bool is_plot(const Figure& figure);
// The number of values of its series.
[[nodiscard]] std::size_t values_of(const Figure& figure);

// The elements of the page of a laboratory.
//
// ranges     of the axes of each row, m or rad; only for sliders of the tool pose.
// has_block  false: these are the default elements of a program without a `lab` block.
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

// An input of a user to a run.
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
  std::string world;  // its name; empty: the program has used none
  std::optional<int> parent;
  std::optional<double> parts_at;
  std::int64_t text_version = 0;
  std::vector<RunInput> inputs;
  std::string hash;
  std::optional<TextMessage> error;
  std::vector<TextMessage> advice;  // with times; only the first of very many
  RecordedDrawings drawings;        // shapes without effect
  RecordedCameras cameras;
  std::uint64_t changes = 1;    // counts changes of the fields above
  std::uint64_t described = 0;  // counts changes of robots and objects
  std::uint64_t figure_changes = 0;
};

struct RunRecord : RunHead {
  std::vector<RecordedRobot> robots;
  std::vector<ObjectInfo> objects;
  std::vector<ObjectFiles> object_files;
  std::vector<std::optional<TextSpan>> object_places;  // where the program makes them
  std::vector<Rows> robot_rows;
  std::vector<Rows> force_rows;    // t and the motor forces, of robots with masses
  std::vector<Rows> contact_rows;  // t and Cell::contact_wrench, from the first contact on
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
  std::vector<RunMark> marks;  // when it has ended

  [[nodiscard]] std::size_t bytes() const;
  // The line of the program at a time; 0: it has not begun.
  [[nodiscard]] int line_at(double t) const;
  [[nodiscard]] std::optional<int> find_robot(std::string_view name) const;
  // The model of the robot at a time.
  [[nodiscard]] std::shared_ptr<const Robot> model_at(int robot, double t) const;
  // Joint values of a robot at a time: those of the last row until then.
  [[nodiscard]] std::vector<double> joints_at(int robot, double t) const;
};

// Receives the events of a session and fills a record. The record and the files must outlive it.
class Recording : public Backend {
 public:
  Recording(RunRecord& record, ShownFiles& files) : record_(record), files_(files) {}

  // Sets the session before its run.
  void listen_to(Session& session) { session_ = &session; }
  void on(const Event& event) override;
  // Called from on_move, `advice` and on_press of the session.
  void on_move(const FinishedMove& report);
  void on_advice(const Diagnostic& advice);
  void on_press(const PressReport& report);
  // Called from `pace` of the session before the clock advances: records what holds until then.
  void on_wait();
  // The statement of the task that runs, or has run last.
  [[nodiscard]] std::optional<TextSpan> here() const;
  // Called while the program computes without end: records its line.
  void on_slice();
  // Called at the end of the run: records loads that have changed since the clock advanced last.
  void on_end();
  // Reads data that events do not contain: models of the robots, the name of the world.
  void look_at_models();
  // Reads the cameras, and the number of pictures that they took.
  void look_at_cameras();
  // Replaces the pictures of elements by names of files.
  void keep_pictures(LabElements& lab);
  // Reads where the program declares the objects that existed at the start of the run. Only while
  // the session is paused.
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
  [[nodiscard]] std::optional<int> find_object(std::string_view name) const;

  struct Motion {
    int number = -1;
    RecordedMove move;
    std::vector<double> last_row;
  };
  // The last row of motor forces of a robot.
  //
  // loaded  the arm with its payload at that time, if it was at rest; otherwise null.
  struct Forces {
    std::shared_ptr<const Robot> loaded;
    std::vector<double> last_row;
  };
  // The last time at which contact forces of a robot were read, and whether there were any.
  struct Touch {
    double t = 0.0;
    bool is_touching = false;
  };

  // An interval that has not ended.
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
  // The order of intervals in which those of tasks and signals with the same name and statement are
  // neighbours.
  static std::vector<std::size_t> order_of(const std::vector<Going>& all);
  void end_stretch(const Going& going, double t);

  RunRecord& record_;
  ShownFiles& files_;
  std::vector<Going> going_;
  std::vector<std::size_t> going_order_;  // order_of(going_)
  Session* session_ = nullptr;
  std::vector<Motion> motions_;  // of each robot
  std::vector<Forces> forces_;   // of each robot
  std::vector<Touch> touches_;   // of each robot
  std::size_t looked_at_ = 0;    // number of objects whose declarations were read
};

}  // namespace armlet::lab
