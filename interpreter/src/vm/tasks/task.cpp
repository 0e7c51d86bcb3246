#include "vm/tasks/task.hpp"

#include <algorithm>

#include "vm/heap/heap.hpp"
#include "vm/instructions/interpret.hpp"

namespace armlet::lang {

namespace {

// The largest frame, and behind it the arguments of a call by the host, which are as many at most.
constexpr std::size_t kLargestFrame = std::size_t{2} * 65536;

constexpr std::size_t kFirstSlots = kFirstBytes / 2 / sizeof(Slot);
constexpr std::size_t kFirstFrames = kFirstBytes / 2 / sizeof(Frame);

// Where an area ends when it holds `needed` items: it doubles, up to its limit.
template <class T>
T* grown_end(T* begin, T* end, const T* limit, const T* needed) {
  std::ptrdiff_t size = end - begin;
  while (size < needed - begin) size *= 2;
  return begin + std::min(size, limit - begin);
}

// What lies at the bottom of every task and below every call by the host.
constexpr Callee kHost{.code = kReturnToHost};

}  // namespace

// Besides the calls there are the bottom, the host's frame, and the program itself.
Task::Task(std::uint32_t call_depth, std::size_t slots)
    : slot_space((slots + kLargestFrame) * sizeof(Slot)),
      frame_space((std::size_t{call_depth} + 3) * sizeof(Frame)),
      slots_end(static_cast<Slot*>(slot_space.begin()) + std::min(slots, kFirstSlots)),
      frames(static_cast<Frame*>(frame_space.begin())),
      frames_end(frames + std::min<std::size_t>(call_depth + 3, kFirstFrames)),
      top(frames),
      slots_limit(static_cast<Slot*>(slot_space.begin()) + slots),
      frames_limit(frames + call_depth + 3) {
  *top = {kReturnToHost, static_cast<Slot*>(slot_space.begin()), &kHost, nullptr};
}

bool Task::grow(Heap& heap, const Frame* frame, Slot* window, std::size_t registers) {
  auto* slots = static_cast<Slot*>(slot_space.begin());
  Slot* slots_to =
      window < slots_end ? slots_end : grown_end(slots, slots_end, slots_limit, window + registers);
  Frame* frames_to =
      frame < frames_end ? frames_end : grown_end(frames, frames_end, frames_limit, frame + 1);
  const auto more = static_cast<std::uint64_t>(slots_to - slots_end) * sizeof(Slot) +
                    static_cast<std::uint64_t>(frames_to - frames_end) * sizeof(Frame);
  if (!heap.charge(more)) return false;
  charged += more;
  slots_end = slots_to;
  frames_end = frames_to;
  return true;
}

void Task::shrink(Heap& heap) {
  if (charged == 0) return;
  heap.discharge(charged);
  charged = 0;
  for (ReservedMemory* space : {&slot_space, &frame_space}) space->give_back(kFirstBytes);
  slots_end = std::min(slots_limit, static_cast<Slot*>(slot_space.begin()) + kFirstSlots);
  frames_end = std::min(frames_limit, frames + kFirstFrames);
}

}  // namespace armlet::lang
