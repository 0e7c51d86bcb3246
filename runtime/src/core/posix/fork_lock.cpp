#include "armlet/core/fork_lock.hpp"

#include <pthread.h>

namespace armlet {
namespace {

constinit std::mutex mutex;

// source  POSIX.1-2017, pthread_atfork.
[[maybe_unused]] const int at_fork =
    pthread_atfork([] { mutex.lock(); }, [] { mutex.unlock(); }, [] { mutex.unlock(); });

}  // namespace

std::unique_lock<std::mutex> lock_over_forks() { return std::unique_lock(mutex); }

}  // namespace armlet
