#include "armlet/core/ample_stack.hpp"

#include <doctest/doctest.h>
#include <pthread.h>

#include <stdexcept>
#include <string>

using namespace armlet;

namespace {

// As many frames of at least 1 KB as are asked for.
int deep(int frames) {
  volatile char room[1024];
  room[0] = static_cast<char>(frames);
  return frames == 0 ? 0 : deep(frames - 1) + 1 + (room[0] - static_cast<char>(frames));
}

// Runs in a thread whose stack has 256 KB.
void in_small_thread(void (*body)()) {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  REQUIRE(pthread_attr_setstacksize(&attributes, std::size_t{256} * 1024) == 0);
  pthread_t thread{};
  const auto start = [](void* argument) -> void* {
    reinterpret_cast<void (*)()>(argument)();
    return nullptr;
  };
  REQUIRE(pthread_create(&thread, &attributes, start, reinterpret_cast<void*>(body)) == 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

}  // namespace

TEST_CASE("work that needs megabytes of stack runs in a thread that has a quarter of one") {
  in_small_thread([] {
    CHECK(stack_left() < kAmpleStack);
    int reached = 0;
    on_ample_stack([&] {
      CHECK(stack_left() >= kAmpleStack);
      reached = deep(3000);
    });
    CHECK(reached == 3000);
    CHECK(stack_left() < kAmpleStack);
  });
}

TEST_CASE("what work throws on a stack of its own arrives, and the next work runs") {
  in_small_thread([] {
    std::string caught;
    try {
      on_ample_stack([] { throw std::runtime_error("far away"); });
    } catch (const std::runtime_error& error) {
      caught = error.what();
    }
    CHECK(caught == "far away");
    int inner = 0;
    on_ample_stack([&] { on_ample_stack([&] { inner = deep(1000); }); });
    CHECK(inner == 1000);
  });
}

TEST_CASE("where the stack is ample nothing is changed") {
  if (stack_left() < kAmpleStack) return;
  const void* outside = __builtin_frame_address(0);
  const void* inside = nullptr;
  on_ample_stack([&] { inside = __builtin_frame_address(0); });
  const auto distance = static_cast<const char*>(outside) - static_cast<const char*>(inside);
  CHECK(distance >= 0);  // the work may be inlined
  CHECK(distance < 4096);
}
