#include "armlet/core/checkpoint.hpp"

namespace armlet {

constinit thread_local Supervisor* detail::present_supervisor = nullptr;

void checkpoint(std::uint64_t operations) {
  Supervisor* present = detail::present_supervisor;
  if (present != nullptr && !present->go_on(operations)) throw Stopped{};
}

}  // namespace armlet
