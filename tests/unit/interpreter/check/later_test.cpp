#include "armlet/interpreter/later.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE(
    "what is not there yet is called by its name as programs write it, or by what is said of it") {
  CHECK(later_feature({.name = "camera{}", .signature = "()"}) == "`camera`");
  CHECK(later_feature({.name = "image[]", .signature = "()"}) == "`image`");
  CHECK(later_feature({.name = "corners", .signature = "()", .help = "`corners` of an object"}) ==
        "`corners` of an object");
}
