#include "armlet/backend/bounded_queue.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "armlet/core/error.hpp"

namespace armlet {

BoundedQueue::BoundedQueue(Backend& listener, std::size_t capacity)
    : listener_(listener),
      capacity_(capacity),
      ignored_(listener.ignores()),
      wants_link_poses_(listener.wants_link_poses()) {
  if (capacity == 0)
    throw ArgumentError("The capacity of a queue of events is 0; expected at least 1.");
}

void BoundedQueue::on(const Event& event) {
  const bool is_last = kind_of(event) == EventKind::kEndRun;
  if (!ignored_.has(kind_of(event))) {
    Entry entry{.event = std::make_unique<const OwnedEvent>(event)};
    const std::lock_guard lock(mutex_);
    entry.serial = pushed_++;
    std::visit(Overload{[&](const JointSample& each) { track(each, entry); },
                        [&](const ObjectSample& each) { track(each, entry); },
                        [&](const ObjectAdded& each) { forget_object(each.object.name); },
                        [&](const ObjectEvent& each) { forget_object(each.name); },
                        [&](const ImageFrame& each) { track(each, entry); },
                        [&](const FigureChanged& each) { track(each, entry); },
                        Ignore<BeginRun, RobotAdded, RobotChanged, Note, FinalFigure, Undone,
                               EndRun, DrawingChanged, CameraAdded>{}},
               event);
    entries_.push_back(std::move(entry));
    make_room();
  }
  if (is_last) close();
  arrived_.notify_one();
}

void BoundedQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  arrived_.notify_all();
}

void BoundedQueue::track(const JointSample& sample, Entry& entry) {
  const auto [found, is_new] = robots_.try_emplace(sample.robot);
  LastSample& last = found->second;
  if (is_new) last.source = sources_++;
  const bool goes_on = !is_new && sample.motion >= 0 && sample.motion == last.motion;
  if (goes_on && !last.is_first) allow_to_go(last.serial);
  entry.source = last.source;
  last.serial = entry.serial;
  last.motion = sample.motion;
  last.is_first = !goes_on;
}

void BoundedQueue::track(const ObjectSample& sample, Entry& entry) {
  auto found = objects_.find(sample.name);
  if (found == objects_.end()) {
    found = objects_.try_emplace(std::string(sample.name)).first;
    found->second.source = sources_++;
  }
  LastSample& last = found->second;
  if (last.is_latest) allow_to_go(last.serial);
  entry.source = last.source;
  last.serial = entry.serial;
  last.is_latest = true;
}

void BoundedQueue::track(const ImageFrame& frame, Entry& entry) {
  const auto [found, is_new] = cameras_.try_emplace(std::string(frame.camera));
  LastSample& last = found->second;
  if (is_new) {
    last.source = sources_++;
  } else {
    allow_to_go(last.serial);
  }
  entry.source = last.source;
  last.serial = entry.serial;
}

void BoundedQueue::forget_object(std::string_view name) {
  if (const auto found = objects_.find(name); found != objects_.end())
    found->second.is_latest = false;
}

void BoundedQueue::track(const FigureChanged& changed, const Entry& entry) {
  const auto [found, is_new] = figures_.try_emplace(changed.index, entry.serial);
  if (is_new) return;
  if (const auto before = find(found->second); before != entries_.end()) {
    entries_.erase(before);
    ++thinned_.figures;
  }
  found->second = entry.serial;
}

std::deque<BoundedQueue::Entry>::iterator BoundedQueue::find(std::uint64_t serial) {
  const auto found = std::ranges::lower_bound(entries_, serial, {}, &Entry::serial);
  return found != entries_.end() && found->serial == serial ? found : entries_.end();
}

void BoundedQueue::allow_to_go(std::uint64_t serial) {
  const auto found = find(serial);
  if (found == entries_.end() || found->may_go) return;
  found->may_go = true;
  ++may_go_;
}

void BoundedQueue::make_room() {
  // A pass scans the whole queue, so it must remove enough: then the time per event stays bounded,
  // however many events have to stay.
  constexpr std::size_t kPart = 8;
  while (entries_.size() > capacity_ && may_go_ > 0 && may_go_ >= entries_.size() / kPart) thin();
}

void BoundedQueue::thin() {
  std::vector<bool> stays(sources_, false);  // whether the next event of each source stays
  const auto goes = [&](const Entry& entry) {
    if (!entry.may_go) return false;
    const bool stayed = stays[entry.source];
    stays[entry.source] = !stayed;
    if (stayed) return false;
    --may_go_;
    const EventKind kind = kind_of(entry.event->event());
    ++(kind == EventKind::kJointSample  ? thinned_.joint_samples
       : kind == EventKind::kImageFrame ? thinned_.frames
                                        : thinned_.object_samples);
    return true;
  };
  // In order, which std::erase_if does not guarantee.
  auto kept = entries_.begin();
  for (auto each = entries_.begin(); each != entries_.end(); ++each) {
    if (goes(*each)) continue;
    if (kept != each) *kept = std::move(*each);
    ++kept;
  }
  entries_.erase(kept, entries_.end());
}

std::unique_ptr<const OwnedEvent> BoundedQueue::take() {
  const std::lock_guard lock(mutex_);
  if (entries_.empty()) return nullptr;
  Entry oldest = std::move(entries_.front());
  entries_.pop_front();
  if (oldest.may_go) --may_go_;
  return std::move(oldest.event);
}

std::size_t BoundedQueue::deliver() {
  const std::size_t count = size();
  // Thinning may have reduced the number.
  for (std::size_t i = 0; i < count; ++i) {
    const auto event = take();
    if (event == nullptr) return i;
    listener_.on(event->event());
  }
  return count;
}

bool BoundedQueue::wait() {
  std::unique_lock lock(mutex_);
  arrived_.wait(lock, [this] { return closed_ || !entries_.empty(); });
  return !entries_.empty();
}

std::size_t BoundedQueue::size() const {
  const std::lock_guard lock(mutex_);
  return entries_.size();
}

Thinned BoundedQueue::thinned() const {
  const std::lock_guard lock(mutex_);
  return thinned_;
}

}  // namespace armlet
