#include "armlet/cell/signals.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE("signals keep their last value and the order of their first") {
  Signals signals;
  CHECK_FALSE(signals.get("lamp").has_value());
  signals.set("lamp", true);
  signals.set("level", 2.5);
  signals.set("lamp", false);
  CHECK(signals.get("lamp") == SignalValue(false));
  CHECK(signals.get("level") == SignalValue(2.5));
  REQUIRE(signals.all().size() == 2);
  CHECK(signals.all()[0].first == "lamp");
}
