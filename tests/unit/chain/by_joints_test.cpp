#include "chain/by_joints.hpp"

#include <doctest/doctest.h>

using namespace armlet;

namespace {

using Counts = void(int n, int& compiled_for, int& counted, std::size_t& capacity);

template <int N>
void counts(int n, int& compiled_for, int& counted, std::size_t& capacity) {
  compiled_for = N;
  counted = joint_count<N>(n);
  capacity = kJointCapacity<N>;
}

constinit const KernelTable<Counts> kCounts =
    kernel_table<Counts>([]<int N>() { return &counts<N>; });

}  // namespace

TEST_CASE("every number of joints has the instance compiled for it, larger ones that for any") {
  for (int n = 1; n <= kMaxJoints; ++n) {
    CAPTURE(n);
    int compiled_for = -1, counted = -1;
    std::size_t capacity = 0;
    kernel_for(kCounts, n)(n, compiled_for, counted, capacity);
    CHECK(compiled_for == (n <= kLargestKernel ? n : kAnyCount));
    CHECK(counted == n);
    CHECK(capacity == static_cast<std::size_t>(n <= kLargestKernel ? n : kMaxJoints));
  }
}
