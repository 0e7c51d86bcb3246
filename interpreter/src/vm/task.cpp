#include "vm/task.hpp"

#include <sys/mman.h>

#include <new>

#include "vm/interpret.hpp"

namespace armlet::lang {

namespace {

// The largest frame, and behind it the arguments of a call by the host, which are as many at most.
constexpr std::size_t kLargestFrame = std::size_t{2} * 65536;

// What lies at the bottom of every task and below every call by the host.
constexpr Callee kHost{kReturnToHost, nullptr, nullptr, 0, 0, 0, 0};

}  // namespace

AddressSpace::AddressSpace(std::size_t bytes) : begin_(nullptr), bytes_(bytes) {
  begin_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                -1, 0);
  if (begin_ == MAP_FAILED) throw std::bad_alloc();
}

AddressSpace::~AddressSpace() { munmap(begin_, bytes_); }

// Besides the calls there are the bottom, the host's frame, and the program itself.
Task::Task(std::uint32_t call_depth, std::size_t slots)
    : slot_space((slots + kLargestFrame) * sizeof(Slot)),
      frame_space((std::size_t{call_depth} + 3) * sizeof(Frame)),
      slots_end(static_cast<Slot*>(slot_space.begin()) + slots),
      frames(static_cast<Frame*>(frame_space.begin())),
      frames_end(frames + call_depth + 3),
      top(frames) {
  *top = {kReturnToHost, static_cast<Slot*>(slot_space.begin()), &kHost, nullptr};
}

}  // namespace armlet::lang
