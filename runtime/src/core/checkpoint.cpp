#include "armlet/core/checkpoint.hpp"

#include <utility>

namespace armlet {
namespace {

// Of a thread, like its stack: results do not depend on it.
thread_local Supervisor* present = nullptr;

}  // namespace

Supervised::Supervised(Supervisor* supervisor) : before_(std::exchange(present, supervisor)) {}
Supervised::~Supervised() { present = before_; }

void checkpoint(std::uint64_t operations) {
  if (present != nullptr && !present->go_on(operations)) throw Stopped{};
}

}  // namespace armlet
