#include "vm/state/task.hpp"

#include <algorithm>

#include "vm/heap/heap.hpp"
#include "vm/state/interpret.hpp"

namespace armlet::lang {

namespace {

// Slots of the largest frame, and of the arguments of a call by the host behind it, which are as
// many at most.
constexpr std::size_t kLargestFrame = std::size_t{2} * 65536;

constexpr std::size_t kFirstSlots = kFirstBytes / 2 / sizeof(Slot);
constexpr std::size_t kFirstFrames = kFirstBytes / 2 / sizeof(Frame);

// The new end of an area that needs room for `needed` items: the size is doubled, up to the limit.
template <class T>
T* grown_end(T* begin, T* end, const T* limit, const T* needed) {
  std::ptrdiff_t size = end - begin;
  while (size < needed - begin) size *= 2;
  return begin + std::min(size, limit - begin);
}

// The function of host frames: the bottom frame of each task, and the frame below each call by the
// host.
constexpr Callee kHost{.code = kReturnToHost};

}  // namespace

// Two frames more than the calls: the host's frame at the bottom, and that of the program.
TaskStack::TaskStack(std::uint32_t call_depth, std::size_t slots)
    : slot_space_((slots + kLargestFrame) * sizeof(Slot)),
      frame_space_((std::size_t{call_depth} + 3) * sizeof(Frame)) {
  auto* first = static_cast<Slot*>(slot_space_.begin());
  slots_end = first + std::min(slots, kFirstSlots);
  slots_limit = first + slots;
  top = frames = static_cast<Frame*>(frame_space_.begin());
  frames_end = frames + std::min<std::size_t>(call_depth + 3, kFirstFrames);
  frames_limit = frames + call_depth + 3;
  *top = {kReturnToHost, first, &kHost, nullptr};
}

bool TaskStack::grow(Heap& heap, const Frame* frame, Slot* window, std::size_t registers) {
  auto* slots = static_cast<Slot*>(slot_space_.begin());
  Slot* slots_to =
      window < slots_end ? slots_end : grown_end(slots, slots_end, slots_limit, window + registers);
  Frame* frames_to =
      frame < frames_end ? frames_end : grown_end(frames, frames_end, frames_limit, frame + 1);
  const auto more = static_cast<std::uint64_t>(slots_to - slots_end) * sizeof(Slot) +
                    static_cast<std::uint64_t>(frames_to - frames_end) * sizeof(Frame);
  if (!heap.charge(more)) return false;
  charged_ += more;
  slots_end = slots_to;
  frames_end = frames_to;
  return true;
}

void TaskStack::shrink(Heap& heap) {
  if (charged_ == 0) return;
  heap.discharge(charged_);
  charged_ = 0;
  for (ReservedMemory* space : {&slot_space_, &frame_space_}) space->give_back(kFirstBytes);
  slots_end = std::min(slots_limit, static_cast<Slot*>(slot_space_.begin()) + kFirstSlots);
  frames_end = std::min(frames_limit, frames + kFirstFrames);
}

void TaskStack::rest() {
  if (top == frames) slot_space_.give_back(0);
}

}  // namespace armlet::lang
