// A queue of events in front of a listener that may be slower than the run.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "armlet/backend/backend.hpp"
#include "armlet/backend/owned_event.hpp"

namespace armlet {

// Counts of the items that a queue has dropped to bound its size.
struct Thinned {
  std::uint64_t joint_samples = 0;
  std::uint64_t object_samples = 0;
  // states of a figure that a later state replaced before they were taken
  std::uint64_t figures = 0;
  std::uint64_t frames = 0;
  bool operator==(const Thinned&) const = default;
};

// Keeps copies of events until the listener takes them, in the same thread or in another one. The
// sender never waits for the listener. Events keep their order.
//
// When there are more than `capacity` events and at least an eighth of them may be dropped, every
// second of these is dropped, for each robot, object and camera separately, beginning with the
// oldest. This is repeated while the condition holds. So the same events, taken at the same
// moments, lead to the same drops.
//
//   joint samples   may be dropped, unless they are the first or the last of their motion so far or
//                   belong to none.
//   object samples  may be dropped if there is a later one of that object and no other event about
//                   that object between the two.
//   pictures        may be dropped if there is a later one of that camera.
//   FigureChanged   contains the complete figure: it always replaces an earlier one that was not
//                   taken yet, because a figure can be large.
//
// All other events are kept, beyond the capacity if necessary. Events that the listener ignores are
// not queued.
class BoundedQueue : public Backend {
 public:
  // listener  not owned; lives at least as long as this. Its ignores() and wants_link_poses() are
  //           called in the constructor.
  // throws    ArgumentError for a capacity of 0.
  BoundedQueue(Backend& listener, std::size_t capacity);

  // ---- for the sender
  void on(const Event& event) override;
  [[nodiscard]] EventKinds ignores() const override { return ignored_; }
  [[nodiscard]] bool wants_link_poses() const override { return wants_link_poses_; }
  // The error of the listener; to be called when nothing is delivered any more.
  [[nodiscard]] std::string error() const override { return listener_.error(); }
  // Ends the queue: no event follows. EndRun does the same.
  void close();

  // ---- for the listener
  // The oldest event; null if there is none.
  [[nodiscard]] std::unique_ptr<const OwnedEvent> take();
  // Delivers the events present at the start of the call to the listener; returns their number.
  std::size_t deliver();
  // Waits until there is an event, or the queue has ended; returns whether there is an event.
  [[nodiscard]] bool wait();

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Thinned thinned() const;

 private:
  // serial  number of the event in the order of arrival.
  // source  of samples and pictures: index of the robot, object or camera.
  struct Entry {
    std::unique_ptr<const OwnedEvent> event;
    std::uint64_t serial = 0;
    std::size_t source = 0;
    bool may_go = false;
  };
  // The last sample of a robot or an object, or the last picture of a camera.
  struct LastSample {
    std::size_t source = 0;
    std::uint64_t serial = 0;
    int motion = -1;
    bool is_first = true;    // of its motion
    bool is_latest = false;  // no other event about that object since
  };

  void track(const JointSample& sample, Entry& entry);
  void track(const ObjectSample& sample, Entry& entry);
  void track(const ImageFrame& frame, Entry& entry);
  void track(const FigureChanged& changed, const Entry& entry);
  void forget_object(std::string_view name);
  [[nodiscard]] std::deque<Entry>::iterator find(std::uint64_t serial);
  void allow_to_go(std::uint64_t serial);
  void make_room();
  void thin();

  Backend& listener_;
  const std::size_t capacity_;
  const EventKinds ignored_;
  const bool wants_link_poses_;

  mutable std::mutex mutex_;  // guards all that follows
  std::condition_variable arrived_;
  std::deque<Entry> entries_;
  std::size_t may_go_ = 0;  // number of events that may be dropped
  std::uint64_t pushed_ = 0;
  std::size_t sources_ = 0;
  std::map<int, LastSample> robots_;
  std::map<std::string, LastSample, std::less<>> objects_;
  std::map<std::string, LastSample, std::less<>> cameras_;
  std::map<int, std::uint64_t> figures_;  // serial of the last state of each
  Thinned thinned_;
  bool closed_ = false;
};

}  // namespace armlet
