#include "messages/text_places.hpp"

#include <doctest/doctest.h>

#include <string>

#include "armlet/core/random.hpp"

using namespace armlet;
using namespace armlet::lab;

TEST_CASE("positions in a text count UTF-16 units") {
  // e with an accent: two bytes, one unit; the face: four bytes, two units.
  const Source source("a.rbt", "ab\ncafé\n\xF0\x9F\x98\x80x");
  CHECK(place_of(source, 0) == TextPlace{1, 0});
  CHECK(place_of(source, 3) == TextPlace{2, 0});
  CHECK(place_of(source, 8) == TextPlace{2, 4});
  CHECK(place_of(source, 7) == TextPlace{2, 3});  // inside of the letter
  CHECK(place_of(source, 13) == TextPlace{3, 2});
  CHECK(place_of(source, 1000) == TextPlace{3, 3});
  CHECK(byte_of(source, {2, 4}) == 8);
  CHECK(byte_of(source, {2, 99}) == 8);
  CHECK(byte_of(source, {3, 1}) == 9);  // inside of the pair
  CHECK(byte_of(source, {3, 2}) == 13);
  CHECK(byte_of(source, {0, 5}) == 0);
  CHECK(byte_of(source, {99, 0}) == 14);
}

TEST_CASE("a position leads back to its byte, for every character of random texts") {
  Random random(11);
  const std::string letters[] = {"a", " ", "\n", "é", "€", "\xF0\x9F\x98\x80"};
  for (int trial = 0; trial < 50; ++trial) {
    std::string text;
    std::vector<std::uint32_t> starts;
    for (int i = 0; i < 60; ++i) {
      starts.push_back(static_cast<std::uint32_t>(text.size()));
      text += letters[random.below(std::size(letters))];
    }
    const Source source("a.rbt", text);
    for (const std::uint32_t byte : starts) CHECK(byte_of(source, place_of(source, byte)) == byte);
  }
}
