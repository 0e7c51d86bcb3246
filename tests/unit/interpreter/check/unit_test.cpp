#include "armlet/interpreter/unit.hpp"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "armlet/core/random.hpp"

namespace armlet {
namespace {

constexpr double kPi = std::numbers::pi;

double si(std::string_view text) {
  const std::optional<Quantity> quantity = parse_quantity(text);
  REQUIRE_MESSAGE(quantity, std::string(text) << " is no quantity");
  return quantity->si;
}

}  // namespace

TEST_CASE("a quantity in a decimal unit is the double nearest to its decimal value") {
  CHECK(si("250mm") == 0.25);
  CHECK(si("0.1mm") == 0.0001);
  CHECK(si("2.3mm") == 0.0023);
  CHECK(si("1_000.5mm/s") == 1.0005);
  CHECK(si("7g") == 0.007);
  CHECK(si("1e3us") == 0.001);
  CHECK(si("1e+3us") == 0.001);
  CHECK(si(".5kN") == 500.0);
  CHECK(si("2.m") == 2.0);
  CHECK(si("9.81m/s^2") == 9.81);
  CHECK(si("0.02kg*m^2") == 0.02);
}

TEST_CASE("every whole number of micrometres reads as its decimal value does") {
  for (int n = 1; n < 20000; n += 7) {
    CHECK(si(std::to_string(n) + "um") == std::stod(std::to_string(n) + "e-6"));
  }
}

TEST_CASE("angles multiply by pi before they divide") {
  CHECK(si("45deg") == 45 * kPi / 180);
  CHECK(si("180deg") == kPi);
  CHECK(si("90\u00B0") == kPi / 2);
  CHECK(si("1rev") == 2 * kPi);
  CHECK(si("60rpm") == 2 * kPi * 60 / 60);
  CHECK(si("180deg/s") == kPi);
  CHECK(si("5mrad") == 0.005);
}

TEST_CASE("units that are no power of ten divide once") {
  CHECK(si("90mm/min") == 90.0 / 60000.0);
  CHECK(si("10inch") == 0.254);
  CHECK(si("2h") == 7200.0);
  CHECK(si("1.5min") == 90.0);
}

TEST_CASE("a quantity has the dimension of its unit") {
  CHECK(parse_quantity("100mm/s")->dim == dims::kSpeed);
  CHECK(parse_quantity("9.81m/s^2")->dim == dims::kAccel);
  CHECK(parse_quantity("10rpm")->dim == dims::kAngularSpeed);
  CHECK(parse_quantity("3J")->dim == dims::kTorque);
  CHECK(parse_quantity("3px")->dim == dims::kNone);
  CHECK(parse_quantity("2s^-1")->dim == *dimension_named("frequency"));
  CHECK(parse_quantity("90deg")->number == 90.0);
  CHECK(parse_quantity("90deg")->unit == "deg");
}

TEST_CASE("what is no quantity gives nothing") {
  for (const char* text :
       {"", "5", "mm", "5cmm", "5 mm", "5mm/", "5mm//s", "5mm^", "5mm^99", "5mm^2.5", "1e999m",
        "-5mm", "1.2.3mm", "5mm/speed", "_mm", "1e99999999m"}) {
    CAPTURE(text);
    CHECK_FALSE(parse_quantity(text));
  }
}

TEST_CASE("numbers have underscores, suffixes and hexadecimal digits") {
  CHECK(*parse_number("1_000") == 1000.0);
  CHECK(*parse_number("0x1F") == 31.0);
  CHECK(*parse_number(".5") == 0.5);
  CHECK(*parse_number("2.") == 2.0);
  CHECK(*parse_number("1e-3") == 1e-3);
  CHECK(*parse_number("0.5f") == 0.5);
  CHECK(*parse_number("3D") == 3.0);
  CHECK(*parse_number("42L") == 42.0);
  for (const char* text : {"", "x", "1x", "0x", "0xG", "inf", "nan", "1e999", "--1", "."}) {
    CAPTURE(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("every unit reads back as one of itself") {
  for (const Unit& unit : all_units()) {
    CAPTURE(unit.name);
    const std::optional<Quantity> one = parse_quantity("1" + std::string(unit.name));
    REQUIRE(one);
    CHECK(one->dim == unit.dim);
    CHECK(one->si == doctest::Approx(unit.factor).epsilon(1e-15));
    CHECK(unit_named(unit.name)->factor == unit.factor);
    CHECK(parse_unit(unit.name)->factor == doctest::Approx(unit.factor).epsilon(1e-15));
  }
  CHECK(unit_named("furlong") == nullptr);
}

TEST_CASE("combined units multiply their factors") {
  CHECK(parse_unit("mm/s")->factor == 1e-3);
  CHECK(parse_unit("kg*mm^2")->factor == 1e-6);
  CHECK(parse_unit("N/mm")->factor == 1e3);
  CHECK(parse_unit("Nm*s/rad")->dim ==
        *divide(*multiply(dims::kTorque, dims::kTime), dims::kAngle));
  CHECK_FALSE(parse_unit(""));
  CHECK_FALSE(parse_unit("mm s"));
}

TEST_CASE("dimensions form a group under multiplication") {
  Random random(1);
  const auto part = [&random] { return static_cast<std::int8_t>(random.below(41) - 20); };
  for (int i = 0; i < 500; ++i) {
    const Dim a{part(), part(), part(), part()};
    const Dim b{part(), part(), part(), part()};
    CHECK(*multiply(a, b) == *multiply(b, a));
    CHECK(*divide(*multiply(a, b), b) == a);
    CHECK(*power(a, 4) == *multiply(a, a));
    CHECK(*power(*power(a, 4), 1) == a);
  }
}

TEST_CASE("the root of an area is a length, the root of a half is nothing") {
  CHECK(*power(*dimension_named("area"), 1) == dims::kLength);
  CHECK_FALSE(power(*power(dims::kLength, 1), 1));
}

TEST_CASE("an exponent that grows too large is refused") {
  CHECK_FALSE(multiply(Dim{127, 0, 0, 0}, dims::kLength));
  CHECK_FALSE(power(dims::kLength, 200));
  CHECK_FALSE(power(dims::kLength, 1'000'000'000));
  CHECK(power(dims::kNone, 1'000'000'000) == dims::kNone);
}

TEST_CASE("dimensions have the names that programs use") {
  CHECK(dimension_name(dims::kLength) == "length");
  CHECK(dimension_name(dims::kTorque) == "torque");
  CHECK(dimension_name(*dimension_named("energy")) == "torque");
  CHECK(dimension_name(dims::kNone) == "number");
  CHECK(dimension_name(*divide(dims::kLength, *multiply(dims::kMass, dims::kMass))) ==
        "length/mass^2");
  CHECK(dimension_name(*power(dims::kLength, 1)) == "length^0.5");
  CHECK(dimension_name(*divide(dims::kNone, dims::kLength)) == "1/length");
  CHECK(dimension_phrase(dims::kAngle) == "an angle");
  CHECK(dimension_phrase(dims::kAccel) == "an acceleration");
  CHECK(dimension_phrase(dims::kNone) == "a plain number");
  CHECK(dimension_phrase(*divide(dims::kForce, dims::kLength)) == "a value in N/m");
  for (const std::string_view name : dimension_names()) CHECK(dimension_named(name));
  CHECK_FALSE(dimension_named("colour"));
}

TEST_CASE("values are shown in degrees, and in mm or g below one metre or kilogram") {
  CHECK(display_unit(dims::kAngle, 4.0).name == "deg");
  CHECK(display_unit(dims::kLength, 0.999).name == "mm");
  CHECK(display_unit(dims::kLength, -0.999).name == "mm");
  CHECK(display_unit(dims::kLength, 1.0).name == "m");
  CHECK(display_unit(dims::kMass, 0.2).name == "g");
  CHECK(display_unit(dims::kMass, 2.0).name == "kg");
  CHECK(display_unit(dims::kTime, 0.001).name == "s");
  CHECK(display_unit(dims::kSpeed, 0.1).name == "m/s");
  CHECK(display_unit(dims::kTorque, 3.0).name == "Nm");
  CHECK(display_unit(dims::kNone, 3.0).name.empty());
}

TEST_CASE("a shown unit reads back as the dimension it came from") {
  Random random(2);
  const auto part = [&random] { return static_cast<std::int8_t>(2 * random.below(7) - 6); };
  for (int i = 0; i < 500; ++i) {
    const Dim dim{part(), part(), part(), part()};
    const DisplayUnit shown = display_unit(dim, 5.0);
    if (shown.name.empty() || shown.name.starts_with("1/")) continue;
    CAPTURE(shown.name);
    const std::optional<CombinedUnit> unit = parse_unit(shown.name);
    REQUIRE(unit);
    CHECK(unit->dim == dim);
    CHECK(unit->factor == doctest::Approx(shown.factor).epsilon(1e-15));
  }
}

}  // namespace armlet
