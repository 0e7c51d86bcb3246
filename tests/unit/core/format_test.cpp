#include "armlet/core/format.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("numbers lose trailing zeros and never show a negative zero") {
  CHECK(format_number(2.0) == "2");
  CHECK(format_number(0.5) == "0.5");
  CHECK(format_number(-0.0001) == "0");
  CHECK(format_number(-0.0) == "0");
  CHECK(format_number(1234.5678, 2) == "1234.57");
  CHECK(format_number(100.0, 0) == "100");
}

TEST_CASE("lengths are shown in millimetres and angles in degrees") {
  CHECK(format_mm(0.0372) == "37.2 mm");
  CHECK(format_mm(0.9) == "900 mm");
  CHECK(format_deg(-2.6599) == "-152.4 deg");
}
