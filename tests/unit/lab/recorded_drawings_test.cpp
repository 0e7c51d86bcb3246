#include "runs/recorded_drawings.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace armlet;
using namespace armlet::lab;

namespace {

DrawingChanged arrow(std::string name, double length, std::string color = "red") {
  DrawingChanged changed;
  changed.drawing = {.name = std::move(name),
                     .kind = "arrow",
                     .size = {length, 0.01, 0.0},
                     .color = std::move(color)};
  return changed;
}

// Column `k` of row `i`.
double at(const RecordedDrawings& recorded, std::size_t i, std::size_t k) {
  return recorded.rows()[0].rows(i, 1)[k];
}

}  // namespace

TEST_CASE("a shape has rows while only its pose and sizes change, and is another one otherwise") {
  RecordedDrawings recorded;
  recorded.take(arrow("a", 0.1), 0.0, {});
  recorded.take(arrow("a", 0.2), 1.0, {});
  CHECK(recorded.list().size() == 1);
  recorded.take(arrow("a", 0.3, "blue"), 2.0, {});
  REQUIRE(recorded.list().size() == 2);
  CHECK(recorded.list()[1].info.color == "blue");
  // 0.1, 0.2, gone, 0.3 of the other one.
  REQUIRE(recorded.rows()[0].count() == 4);
  CHECK(at(recorded, 2, 1) == 0.0);
  CHECK(at(recorded, 2, 9) == 0.0);
  CHECK(at(recorded, 3, 1) == 1.0);
  CHECK(at(recorded, 3, 9) == 0.3);
  // Back again: no third one.
  recorded.take(arrow("a", 0.4), 3.0, {});
  CHECK(recorded.list().size() == 2);
  DrawingChanged gone = arrow("a", 0.4);
  gone.removed = true;
  recorded.take(gone, 4.0, {});
  CHECK(at(recorded, recorded.rows()[0].count() - 1, 9) == 0.0);
  recorded.take(gone, 5.0, {});  // a second time nothing ends
  CHECK(at(recorded, recorded.rows()[0].count() - 1, 0) == 4.0);
}

TEST_CASE("of very many rows some are left out, but never the last one of a shape") {
  RecordedDrawings recorded;
  constexpr int kShapes = 1000;
  constexpr int kTimes = 1500;
  for (int k = 0; k < kTimes; ++k) {
    for (int i = 0; i < kShapes; ++i)
      recorded.take(arrow("a" + std::to_string(i), 1.0 + k), k / 30.0, {});
  }
  CHECK(recorded.list().size() == kShapes);
  CHECK(recorded.rows()[0].count() < 900'000);
  recorded.flush();
  std::map<int, double> last;
  const Rows& rows = recorded.rows()[0];
  for (std::size_t i = 0; i < rows.count(); ++i)
    last[static_cast<int>(at(recorded, i, 1))] = at(recorded, i, 9);
  CHECK(last.size() == kShapes);
  for (const auto& [shape, length] : last) CHECK(length == kTimes);
}
