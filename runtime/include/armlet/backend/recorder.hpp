#pragma once

#include "armlet/backend/backend.hpp"

namespace armlet {

// Copies of events that a Recorder keeps.
struct RecordedJoints {
  std::int64_t t_ns = 0;
  int robot = 0;
  std::vector<double> q, qd, qdd;
  Eigen::Matrix4d T_world_tool = Eigen::Matrix4d::Identity();
  bool operator==(const RecordedJoints&) const = default;
};
struct RecordedObject {
  std::int64_t t_ns = 0;
  std::string name;
  Eigen::Matrix4d T_world_obj = Eigen::Matrix4d::Identity();
  bool operator==(const RecordedObject&) const = default;
};
struct RecordedEvent {
  std::int64_t t_ns = 0;
  ObjectChange change = ObjectChange::kAttached;
  std::string name;
  int robot = -1;
  bool operator==(const RecordedEvent&) const = default;
};
struct RecordedNote {
  std::int64_t t_ns = 0;
  NoteKind kind = NoteKind::kOutput;
  std::string text;
  bool operator==(const RecordedNote&) const = default;
};

struct RecordedFrame {
  std::int64_t t_ns = 0;
  std::string camera;
  std::uint64_t frame = 0;
  int width = 0;
  int height = 0;
  int channels = 0;
  std::uint64_t pixels = 0;  // hash of the pixels
  Eigen::Matrix4d T_world_camera = Eigen::Matrix4d::Identity();
  bool operator==(const RecordedFrame&) const = default;
};

// See Undone of event.hpp.
struct RecordedUndoing {
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
  std::uint64_t from = 0;
  std::int64_t back_ns = 0;
  bool operator==(const RecordedUndoing&) const = default;
};

// Keeps the events of a run in memory, except figures and drawings. Undone events stay, and
// undoings() identifies them. An object that appears is recorded as a sample of its pose.
class Recorder : public Backend {
 public:
  void on(const Event& event) override;
  [[nodiscard]] EventKinds ignores() const override;

  // The beginning of the run, with the robots and cameras that were added later, in their present
  // state.
  [[nodiscard]] const RunInfo& run() const { return run_; }
  [[nodiscard]] const std::vector<RecordedJoints>& joints() const { return joints_; }
  [[nodiscard]] const std::vector<RecordedObject>& objects() const { return objects_; }
  [[nodiscard]] const std::vector<RecordedEvent>& events() const { return events_; }
  [[nodiscard]] const std::vector<RecordedNote>& notes() const { return notes_; }
  // Pictures that cameras took, with the hash of their pixels.
  [[nodiscard]] const std::vector<RecordedFrame>& frames() const { return frames_; }
  [[nodiscard]] const std::vector<RecordedUndoing>& undoings() const { return undoings_; }
  [[nodiscard]] std::int64_t end_ns() const { return end_ns_; }

  // Whether samples, events, notes, pictures and marks are equal, bit by bit.
  [[nodiscard]] bool same_as(const Recorder& other) const;

 private:
  void keep(const BeginRun& begin);
  void keep(const RobotAdded& added);
  void keep(const RobotChanged& changed);
  void keep(const JointSample& sample);
  void keep(const ObjectAdded& added);
  void keep(const ObjectSample& sample);
  void keep(const ObjectEvent& event);
  void keep(const Note& note);
  void keep(const CameraAdded& added);
  void keep(const ImageFrame& frame);
  void keep(const Undone& undone);
  void keep(const EndRun& end);

  RunInfo run_;
  std::vector<RecordedJoints> joints_;
  std::vector<RecordedObject> objects_;
  std::vector<RecordedEvent> events_;
  std::vector<RecordedNote> notes_;
  std::vector<RecordedFrame> frames_;
  std::vector<RecordedUndoing> undoings_;
  std::int64_t end_ns_ = 0;
};

}  // namespace armlet
