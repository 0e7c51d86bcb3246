#include "armlet/core/platform.hpp"

#include <dlfcn.h>
#include <sys/mman.h>

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

namespace armlet {

ReservedMemory::ReservedMemory(std::size_t bytes)
    : begin_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)),
      bytes_(bytes) {
  if (begin_ == MAP_FAILED) throw std::bad_alloc();
}
ReservedMemory::~ReservedMemory() { munmap(begin_, bytes_); }

void ReservedMemory::give_back(std::size_t first) {
  madvise(static_cast<std::byte*>(begin_) + first, bytes_ - first, MADV_DONTNEED);
}

bool reserves_for_free() { return true; }

std::int64_t steady_time_ns() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(since).count();
}

void yield_thread() { std::this_thread::yield(); }

// ---- Alarm ------------------------------------------------------------------------------------

struct Alarm::State {
  State(std::int64_t after_ns, std::function<void()> call)
      : deadline(std::chrono::steady_clock::now() + std::chrono::nanoseconds(after_ns)),
        thread([this, call = std::move(call)] {
          std::unique_lock lock(mutex);
          if (!ended.wait_until(lock, deadline, [this] { return end; })) call();
        }) {}

  std::chrono::steady_clock::time_point deadline;
  std::mutex mutex;
  std::condition_variable ended;
  bool end = false;
  std::thread thread;
};

Alarm::Alarm(std::int64_t after_ns, std::function<void()> call)
    : state_(std::make_unique<State>(after_ns, std::move(call))) {}

Alarm::~Alarm() {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->end = true;
  }
  state_->ended.notify_all();
  state_->thread.join();
}

// ---- LoadedLibrary ----------------------------------------------------------------------------

LoadedLibrary::LoadedLibrary(const std::string& name)
    : handle_(dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL)) {}
void* LoadedLibrary::find(const char* symbol) const {
  return handle_ != nullptr ? dlsym(handle_, symbol) : nullptr;
}

std::string program_folder() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path().string();
}

}  // namespace armlet
