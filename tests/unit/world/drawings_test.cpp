#include "armlet/world/drawings.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

#include "armlet/math/pose.hpp"
#include "refusal_of.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

Drawing arrow(std::string name) {
  return {.name = std::move(name), .kind = DrawingKind::kArrow, .size = {0.2, 0.01, 0.0}};
}

}  // namespace

TEST_CASE("a drawing of a name is replaced, and found until it is taken away") {
  Drawings drawings;
  drawings.put(arrow("b"));
  drawings.put(arrow("a"));
  Drawing other = arrow("b");
  other.kind = DrawingKind::kLine;
  other.color = "red";
  drawings.put(other);
  CHECK(drawings.size() == 2);
  CHECK(drawings.names() == std::vector<std::string>{"a", "b"});
  CHECK(drawings.find("b")->kind == DrawingKind::kLine);
  CHECK(drawings.remove("b"));
  CHECK_FALSE(drawings.remove("b"));
  CHECK(drawings.find("b") == nullptr);
}

TEST_CASE("those on an object are known, whatever they were on before") {
  Drawings drawings;
  Drawing on_cube = arrow("a");
  on_cube.on = {.base = FrameBase::kObject, .on = "cube"};
  drawings.put(on_cube);
  drawings.put(arrow("b"));
  CHECK(drawings.on_object("cube") == std::vector<std::string>{"a"});
  CHECK(drawings.on_object("ball").empty());
  drawings.put(arrow("a"));
  CHECK(drawings.on_object("cube").empty());
  drawings.put(on_cube);
  CHECK(drawings.remove("a"));
  CHECK(drawings.on_object("cube").empty());
}

TEST_CASE("the frame between two points begins at one, and the other is on its z axis") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2.0, 2.0);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d from(number(random), number(random), number(random));
    Vector3d to(number(random), number(random), number(random));
    if (i % 10 == 0) to = from - Vector3d::UnitZ() * std::abs(number(random));  // straight down
    const Eigen::Isometry3d T = frame_between(from, to);
    CHECK((T * Vector3d(0.0, 0.0, (to - from).norm()) - to).norm() < 1e-12);
    CHECK((T.linear().transpose() * T.linear()).isIdentity(1e-12));
    CHECK(T.linear().determinant() == doctest::Approx(1.0));
  }
  CHECK(frame_between(Vector3d::Ones(), Vector3d::Ones()).linear().isIdentity(0.0));
}

TEST_CASE("what cannot be drawn is refused, with its name and the number") {
  const auto refused = [](const Drawing& drawing) {
    return refusal_of([&] { check_drawing(drawing); });
  };
  CHECK_NOTHROW(check_drawing(arrow("a")));
  Drawing wrong = arrow("a");
  wrong.size[0] = 0.0;
  CHECK(refused(wrong) == "The arrow \"a\" has no length: it ends where it begins.");
  for (const double size : {-1.0, 1e9, std::numeric_limits<double>::quiet_NaN(),
                            std::numeric_limits<double>::infinity()}) {
    wrong.size = {0.1, size, 0.0};
    CHECK(refused(wrong).find("A size of the arrow \"a\"") == 0);
  }
  wrong = arrow("a");
  wrong.T_on_drawing.translation().x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused(wrong).find("\"a\"") != std::string::npos);
  CHECK(refused(arrow("")) == "A drawing needs a name.");
  Drawing text{.name = "t", .kind = DrawingKind::kText, .size = {0.1, 0.0, 0.0}};
  CHECK(refused(text) == "The text \"t\" says nothing.");
  text.text = std::string(2000, 'x');
  CHECK(refused(text).find("2000 bytes") != std::string::npos);
}

TEST_CASE("there is an end to how many there may be") {
  Drawings drawings;
  for (std::size_t i = 0; i < Drawings::kMost; ++i) drawings.put(arrow("a" + std::to_string(i)));
  drawings.put(arrow("a0"));  // one that is there
  CHECK_THROWS_AS(drawings.put(arrow("one more")), ArgumentError);
  CHECK(drawings.size() == Drawings::kMost);
}
