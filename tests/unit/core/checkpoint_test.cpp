#include "armlet/core/checkpoint.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace armlet;

namespace {

// Lets so much work be done.
class Budget final : public Supervisor {
 public:
  explicit Budget(std::uint64_t left) : left_(left) {}
  bool go_on(std::uint64_t operations) override {
    if (operations > left_) return false;
    left_ -= operations;
    return true;
  }

 private:
  std::uint64_t left_;
};

// Passes checkpoints until it is stopped, at most `most`.
int passed(int most) {
  int count = 0;
  try {
    for (; count < most; ++count) checkpoint(10);
  } catch (const Stopped&) {
  }
  return count;
}

}  // namespace

TEST_CASE("work goes on as long as its supervisor lets it") {
  CHECK(passed(100) == 100);
  Budget budget(55);
  {
    const Supervised watch(&budget);
    CHECK(passed(100) == 5);
    {
      const Supervised nobody(nullptr);
      CHECK(passed(100) == 100);
    }
    CHECK(passed(100) == 0);
  }
  CHECK(passed(100) == 100);
}

TEST_CASE("a handler of failures does not catch that work is stopped") {
  Budget budget(0);
  const Supervised watch(&budget);
  bool seen_as_failure = false;
  bool stopped = false;
  try {
    try {
      checkpoint(1);
    } catch (const std::exception&) {
      seen_as_failure = true;
    }
  } catch (const Stopped&) {
    stopped = true;
  }
  CHECK(stopped);
  CHECK(!seen_as_failure);
}
