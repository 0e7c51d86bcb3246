#pragma once
// Physical dimensions and units (language reference, section 6).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace armlet {

// A dimension: exponents of length, mass, time and angle, counted in halves, so that sqrt(area) is
// a length.
struct Dim {
  std::int8_t length = 0;
  std::int8_t mass = 0;
  std::int8_t time = 0;
  std::int8_t angle = 0;

  bool operator==(const Dim&) const = default;
  [[nodiscard]] bool is_none() const { return *this == Dim{}; }
  // The dimension without its angle part.
  [[nodiscard]] Dim without_angle() const { return {length, mass, time, 0}; }
  // Whether it is a power of an angle, or none.
  [[nodiscard]] bool is_only_angle() const { return length == 0 && mass == 0 && time == 0; }
};

// The dimension of a product or a quotient; empty if an exponent exceeds the range of int8.
[[nodiscard]] std::optional<Dim> multiply(Dim a, Dim b);
[[nodiscard]] std::optional<Dim> divide(Dim a, Dim b);
// a^(halves/2); empty if an exponent would not be a multiple of one half.
[[nodiscard]] std::optional<Dim> power(Dim a, int halves);

namespace dims {
inline constexpr Dim kNone{0, 0, 0, 0};
inline constexpr Dim kLength{2, 0, 0, 0};
inline constexpr Dim kMass{0, 2, 0, 0};
inline constexpr Dim kTime{0, 0, 2, 0};
inline constexpr Dim kAngle{0, 0, 0, 2};
inline constexpr Dim kSpeed{2, 0, -2, 0};
inline constexpr Dim kAccel{2, 0, -4, 0};
inline constexpr Dim kAngularSpeed{0, 0, -2, 2};
inline constexpr Dim kAngularAccel{0, 0, -4, 2};
inline constexpr Dim kForce{2, 2, -4, 0};
inline constexpr Dim kTorque{4, 2, -4, 0};
}  // namespace dims

// The dimension with a name of section 6: "length", "angle" ... `energy` and `torque` are one
// dimension.
[[nodiscard]] std::optional<Dim> dimension_named(std::string_view name);
[[nodiscard]] std::span<const std::string_view> dimension_names();
// The name of a dimension: "length", a product such as "length/mass^2" if it has no name, "number"
// for none.
[[nodiscard]] std::string dimension_name(Dim dim);
// The name with its article: "a length", "an angle", "a plain number".
[[nodiscard]] std::string dimension_phrase(Dim dim);

// A unit after a number: value in SI = number * factor.
struct Unit {
  std::string_view name;
  Dim dim;
  double factor;
};

// One simple unit such as "mm"; null if there is none.
[[nodiscard]] const Unit* unit_named(std::string_view name);
[[nodiscard]] std::span<const Unit> all_units();

// A combined unit: "mm/s", "kg*m^2", "m/s^2", also as si_unit writes it: "1/s^2", "m^0.5". Empty if
// any part is unknown.
struct CombinedUnit {
  Dim dim;
  double factor = 1.0;
};
[[nodiscard]] std::optional<CombinedUnit> parse_unit(std::string_view text);

// A number with a unit, without a blank between ("90deg", "1_000.5mm/s"), rounded once to SI.
struct Quantity {
  double si = 0.0;
  Dim dim;
  double number = 0.0;    // as written
  std::string_view unit;  // as written
};
[[nodiscard]] std::optional<Quantity> parse_quantity(std::string_view text);
// The SI value of a number without a sign in a unit ("90", "deg"), rounded once.
[[nodiscard]] std::optional<double> si_of(std::string_view number, std::string_view unit);

// Parses a number of the language: underscores, trailing f F d D l L. Empty if the text is not a
// number.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

// The unit by which `print` shows a value of dimension `dim` (section 6, "Printing"):
// deg; mm below 1 m, else m; g below 1 kg, else kg; s; the SI unit text otherwise.
struct DisplayUnit {
  std::string name;
  double factor = 1.0;
};
[[nodiscard]] DisplayUnit display_unit(Dim dim, double si);
// The name of the unit in SI, "rad" for angles; empty for plain numbers.
[[nodiscard]] std::string si_unit(Dim dim);

}  // namespace armlet
