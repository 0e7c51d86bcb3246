// Limits of the functions of matrices; what they compute is shown by tests/scripts/matrices.

#include <doctest/doctest.h>

#include <string>

#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

std::string code_of(const std::string& text, std::uint64_t heap_bytes) {
  SessionOptions options;
  options.limits.heap_bytes = heap_bytes;
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(text, "test.rbt"));
  const RunResult result = session.run();
  return result.error ? result.error->code : "";
}

constexpr std::uint64_t kMega = 1 << 20;

}  // namespace

TEST_CASE("matrices and what is made of them count against the heap limit") {
  CHECK(code_of("let A = zeros(300, 300)", kMega).empty());
  CHECK(code_of("let A = zeros(400, 400)", kMega) == "R0628");
  CHECK(code_of("let A = zeros(300, 300)\nlet B = A * A", kMega) == "R0628");
  CHECK(code_of("let A = zeros(300, 300)\nlet B = A.T", kMega) == "R0628");
  CHECK(code_of("let A = zeros(300, 300)\nfor (row in A) { }", kMega) == "R0628");
  CHECK(code_of("let A = zeros(300, 300)\nlet B = A[:, 0:200]", kMega) == "R0628");
}

TEST_CASE("what a decomposition needs for itself counts as well") {
  CHECK(code_of("let s = svd(ones(100, 100))", 2 * kMega).empty());
  CHECK(code_of("let s = svd(ones(200, 200))", 2 * kMega) == "R0628");
  CHECK(code_of("let x = ones(300, 300) \\ ones(300)", 2 * kMega) == "R0628");
}

TEST_CASE("parts of records that cannot all be made leave nothing behind") {
  // The failure is caught many times, so that a leak would fill the heap.
  CHECK(code_of("let A = ones(100, 100)\nvar failed = 0\nlet ballast = zeros(56, 1000)\n"
                "for (i in range(100)) { try { let q = lu(A) } catch (e) { failed += 1 } }\n"
                "assert(failed == 100)\nlet B = ones(100, 100)",
                kMega)
            .empty());
}
