#include "armlet/core/ample_stack.hpp"

#include <pthread.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <utility>

#if defined(__SANITIZE_ADDRESS__)
#define ARMLET_TELLS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define ARMLET_TELLS_SANITIZER 1
#endif
#endif
#ifdef ARMLET_TELLS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace armlet {
namespace {

struct Bounds {
  std::uintptr_t low = 0;
  std::uintptr_t high = 0;  // 0: not known
};

// Bounds of the first thread's stack, which the system lets grow down to its limit: the end of the
// highest object that the system puts there, the name of the program. pthread_getattr_np would read
// /proc/self/maps for it.
Bounds bounds_of_first_thread() {
  constexpr std::uintptr_t kPage = 4096;
  constexpr std::uintptr_t kMost = std::uintptr_t{8} * 1024 * 1024;  // of a stack without limit
  const std::uintptr_t name = getauxval(AT_EXECFN);
  rlimit limit{};
  if (name == 0 || getrlimit(RLIMIT_STACK, &limit) != 0) return {};
  const std::uintptr_t high = (name / kPage + 1) * kPage;
  return {high - std::min<std::uintptr_t>(limit.rlim_cur, kMost), high};
}

Bounds bounds_of_thread() {
  if (gettid() == getpid()) return bounds_of_first_thread();
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return {};
  void* begin = nullptr;
  std::size_t size = 0;
  const bool known = pthread_attr_getstack(&attributes, &begin, &size) == 0;
  pthread_attr_destroy(&attributes);
  const auto low = reinterpret_cast<std::uintptr_t>(begin);
  return known ? Bounds{low, low + size} : Bounds{};
}

Bounds& present_bounds() {
  thread_local Bounds bounds = bounds_of_thread();
  return bounds;
}

class Stack {
 public:
  Stack()
      : begin_(mmap(nullptr, kGuard + kOwnStack, PROT_NONE,
                    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0)) {
    if (begin_ == MAP_FAILED) throw std::bad_alloc();
    if (mprotect(bottom(), kOwnStack, PROT_READ | PROT_WRITE) != 0) {
      munmap(begin_, kGuard + kOwnStack);
      throw std::bad_alloc();
    }
  }
  ~Stack() { munmap(begin_, kGuard + kOwnStack); }
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;

  [[nodiscard]] void* bottom() const { return static_cast<std::byte*>(begin_) + kGuard; }
  [[nodiscard]] Bounds bounds() const {
    const auto low = reinterpret_cast<std::uintptr_t>(bottom());
    return {low, low + kOwnStack};
  }

 private:
  // never used: an access would crash
  static constexpr std::size_t kGuard = std::size_t{64} * 1024;
  void* begin_;
};

// The arguments of a call on another stack, and its result.
struct Errand {
  const std::function<void()>& work;
  std::exception_ptr thrown;
  ucontext_t here;
  ucontext_t there;
#ifdef ARMLET_TELLS_SANITIZER
  const void* here_bottom = nullptr;
  std::size_t here_size = 0;
#endif
};

// makecontext passes ints only.
extern "C" void armlet_run_errand(unsigned high, unsigned low) {
  auto& errand = *reinterpret_cast<Errand*>((std::uintptr_t{high} << 32U) | std::uintptr_t{low});
#ifdef ARMLET_TELLS_SANITIZER
  __sanitizer_finish_switch_fiber(nullptr, &errand.here_bottom, &errand.here_size);
#endif
  try {
    errand.work();
  } catch (...) {  // rethrown on the other stack
    errand.thrown = std::current_exception();
  }
#ifdef ARMLET_TELLS_SANITIZER
  __sanitizer_start_switch_fiber(nullptr, errand.here_bottom, errand.here_size);
#endif
}

void run_on(const Stack& stack, Errand& errand) {
  getcontext(&errand.there);
  errand.there.uc_stack.ss_sp = stack.bottom();
  errand.there.uc_stack.ss_size = kOwnStack;
  errand.there.uc_link = &errand.here;
  const auto address = reinterpret_cast<std::uintptr_t>(&errand);
  makecontext(&errand.there, reinterpret_cast<void (*)()>(armlet_run_errand), 2,
              static_cast<unsigned>(address >> 32U), static_cast<unsigned>(address));
#ifdef ARMLET_TELLS_SANITIZER
  void* fake = nullptr;
  __sanitizer_start_switch_fiber(&fake, stack.bottom(), kOwnStack);
#endif
  swapcontext(&errand.here, &errand.there);
#ifdef ARMLET_TELLS_SANITIZER
  __sanitizer_finish_switch_fiber(fake, nullptr, nullptr);
#endif
}

}  // namespace

std::size_t stack_left() {
  const Bounds& bounds = present_bounds();
  const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  return here > bounds.low && here < bounds.high ? here - bounds.low : 0;
}

void on_own_stack(const std::function<void()>& work) {
  const Stack stack;
  Errand errand{.work = work, .thrown = nullptr, .here = {}, .there = {}};
  const Bounds before = std::exchange(present_bounds(), stack.bounds());
  run_on(stack, errand);
  present_bounds() = before;
  if (errand.thrown != nullptr) std::rethrow_exception(errand.thrown);
}

}  // namespace armlet
