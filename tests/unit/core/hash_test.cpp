#include "armlet/core/hash.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace armlet;

namespace {

std::uint64_t hash_of(std::string_view bytes) {
  Fnv1a hash;
  hash.add_bytes(bytes);
  return hash.value();
}

}  // namespace

// From the test vectors that its authors publish with the algorithm (fnv64a).
TEST_CASE("FNV-1a gives the published values") {
  CHECK(hash_of("") == 0xcbf29ce484222325);
  CHECK(hash_of("a") == 0xaf63dc4c8601ec8c);
  CHECK(hash_of("b") == 0xaf63df4c8601f1a5);
  CHECK(hash_of("fo") == 0x08985907b541d342);
  CHECK(hash_of("foobar") == 0x85944171f73967e8);
  CHECK(hash_of("chongo was here!\n") == 0x46810940eff5f915);
  CHECK(hash_of(std::string_view("\0", 1)) == 0xaf63bd4c8601b7df);
}

TEST_CASE("numbers are hashed as their bytes, the lowest first") {
  Fnv1a word;
  word.add(std::uint64_t{0x7261626f6f66});  // "foobar"
  CHECK(word.value() == hash_of(std::string_view("foobar\0\0", 8)));
  Fnv1a zero;
  zero.add(0.0);
  Fnv1a minus_zero;
  minus_zero.add(-0.0);
  CHECK(zero.value() != minus_zero.value());
  Fnv1a nan;
  nan.add(std::numeric_limits<double>::quiet_NaN());
  Fnv1a minus_nan;
  minus_nan.add(-std::numeric_limits<double>::quiet_NaN());
  CHECK(nan.value() == minus_nan.value());
}

TEST_CASE("texts one after the other are kept apart") {
  Fnv1a one;
  one.add(std::string_view("ab"));
  one.add(std::string_view("c"));
  Fnv1a other;
  other.add(std::string_view("a"));
  other.add(std::string_view("bc"));
  CHECK(one.value() != other.value());
}
