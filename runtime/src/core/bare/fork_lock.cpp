// There are no forks in a page.
#include "armlet/core/fork_lock.hpp"

namespace armlet {
namespace {
constinit std::mutex mutex;
}

std::unique_lock<std::mutex> lock_over_forks() { return std::unique_lock(mutex); }

}  // namespace armlet
