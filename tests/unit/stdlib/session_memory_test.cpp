// What sessions that rest keep: bytes asked of the allocator, the same in every run.

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "armlet/model/catalog.hpp"
#include "library.hpp"
#include "vm/state/state.hpp"

namespace {

// Of all blocks that live; each has its size in front of it.
std::size_t bytes_alive = 0;

constexpr std::size_t kFront = 16;

}  // namespace

// Inlined, g++ 12 takes new and free for a pair that does not match.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  auto* block = static_cast<std::byte*>(std::malloc(size + kFront));
  if (block == nullptr) return nullptr;
  *reinterpret_cast<std::size_t*>(block) = size;
  bytes_alive += size;
  return block + kFront;
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory == nullptr) return;
  auto* block = static_cast<std::byte*>(memory) - kFront;
  bytes_alive -= *reinterpret_cast<std::size_t*>(block);
  std::free(block);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

using namespace armlet;

namespace {

constexpr std::size_t kSessions = 20;
constexpr std::size_t kMost = 57'000;          // bytes of a session, so that 60 kB are resident
constexpr std::size_t kMostOfAnEntry = 3'700;  // of one line that declares a number

void enter(Session& session, const std::string& text) {
  REQUIRE(session.submit(text, "line"));
  REQUIRE(session.run().status == Progress::kDone);
}

}  // namespace

TEST_CASE("a thousand sessions that rest keep less than 60 kB each") {
  SessionOptions options;
  options.robot = make_robot("scara");
  options.default_world = table_world();
  {
    Session first(library_engine(), options);  // what all share is made
    enter(first, "moveJ(home(), time: 1s)");
  }
  std::vector<std::unique_ptr<Session>> sessions;
  sessions.reserve(kSessions);
  const std::size_t before = bytes_alive;
  const auto each = [&] {
    std::size_t bytes = bytes_alive - before;
    for (const auto& session : sessions) bytes += session->vm()->state().heap.reserved();
    return bytes / kSessions;
  };
  for (std::size_t i = 0; i < kSessions; ++i) {
    sessions.push_back(std::make_unique<Session>(library_engine(), options));
    enter(*sessions.back(), "let width = 40mm");
  }
  const std::size_t after_one = each();
  CHECK(after_one < kMost / 4);
  for (const auto& session : sessions)
    for (int line = 0; line < 10; ++line)
      enter(*session, "let n" + std::to_string(line) + " = " + std::to_string(line) + " * width");
  const std::size_t after_ten = each();
  CHECK(after_ten < kMost);
  CHECK((after_ten - after_one) / 10 < kMostOfAnEntry);
  for (const auto& session : sessions)
    enter(*session, "moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  CHECK(each() < kMost);
  MESSAGE(after_one << ", " << after_ten << " and " << each() << " bytes");
}
