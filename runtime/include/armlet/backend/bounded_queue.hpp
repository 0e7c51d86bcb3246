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

// What a queue left out, so that it does not grow.
struct Thinned {
  std::uint64_t joint_samples = 0;
  std::uint64_t object_samples = 0;
  std::uint64_t figures = 0;  // states of a figure whose next state came before they were taken
  std::uint64_t frames = 0;
  bool operator==(const Thinned&) const = default;
};

// Keeps copies of events until the listener takes them, in the same thread or in another one. The
// sender never waits for the listener. Events keep their order.
//
// When there are more than `capacity` events and at least an eighth of them are ones that may
// go, every second of these goes, for each robot, object and camera, beginning with the oldest; and
// again until there are not. So the same events, taken at the same moments, leave the same ones.
//
//   joint samples   may go, unless they are the first or the last of their motion so far or belong
//                   to none.
//   object samples  may go if a later one of that object is there, and nothing else was told of
//                   that object between the two.
//   pictures        may go if a later one of that camera is there.
//   FigureChanged   is a whole state: it takes the place of the one before that was not taken yet,
//                   full or not, because a figure can be large.
//
// All else stays, beyond the capacity if it has to. What the listener ignores is not kept.
class BoundedQueue : public Backend {
 public:
  // listener  not owned; lives at least as long as this. What it ignores and whether it wants the
  //           poses of links is asked here.
  // throws    ArgumentError for a capacity of 0.
  BoundedQueue(Backend& listener, std::size_t capacity);

  // ---- for the sender
  void on(const Event& event) override;
  [[nodiscard]] EventKinds ignores() const override { return ignored_; }
  [[nodiscard]] bool wants_link_poses() const override { return wants_link_poses_; }
  // That of the listener; to be asked when nothing is delivered any more.
  [[nodiscard]] std::string error() const override { return listener_.error(); }
  // Nothing more comes; so it is after EndRun.
  void close();

  // ---- for the listener
  // The oldest event; null if there is none.
  [[nodiscard]] std::unique_ptr<const OwnedEvent> take();
  // Hands the listener what there is when the call begins; returns how many events that were.
  std::size_t deliver();
  // Waits until there is an event or nothing more comes; whether there is one.
  [[nodiscard]] bool wait();

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] Thinned thinned() const;

 private:
  // serial  counts what was pushed.
  // source  of samples and pictures: counts robots, objects and cameras.
  struct Entry {
    std::unique_ptr<const OwnedEvent> event;
    std::uint64_t serial = 0;
    std::size_t source = 0;
    bool may_go = false;
  };
  // The sample of a robot or an object, or the picture of a camera, that was pushed last.
  struct LastSample {
    std::size_t source = 0;
    std::uint64_t serial = 0;
    int motion = -1;
    bool is_first = true;    // of its motion
    bool is_latest = false;  // nothing else was told of that object since
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
  std::size_t may_go_ = 0;  // how many of them
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
