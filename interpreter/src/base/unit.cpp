#include "armlet/interpreter/unit.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

namespace armlet {
namespace {

// The factor of a unit as numerator / denominator * 10^exponent * pi^pi_power, which is multiplied
// only once, at the end. With it 250mm is exactly 0.25: the decimal point of the digits is shifted,
// and the result is rounded once.
struct ExactFactor {
  double numerator = 1.0;
  double denominator = 1.0;
  int exponent = 0;
  int pi_power = 0;
};

struct UnitRow {
  Unit unit;
  ExactFactor exact;
};

constexpr double kPi = std::numbers::pi;
constexpr Dim kFrequency{0, 0, -2, 0};
constexpr Dim kPower{4, 2, -6, 0};
constexpr Dim kPressure{-2, 2, -4, 0};

constexpr UnitRow kRows[] = {
    {{"deg", dims::kAngle, kPi / 180}, {1, 180, 0, 1}},
    {{"\u00B0", dims::kAngle, kPi / 180}, {1, 180, 0, 1}},
    {{"rad", dims::kAngle, 1}, {}},
    {{"mrad", dims::kAngle, 1e-3}, {1, 1, -3, 0}},
    {{"rev", dims::kAngle, 2 * kPi}, {2, 1, 0, 1}},
    {{"um", dims::kLength, 1e-6}, {1, 1, -6, 0}},
    {{"\u00B5m", dims::kLength, 1e-6}, {1, 1, -6, 0}},
    {{"\u03BCm", dims::kLength, 1e-6}, {1, 1, -6, 0}},
    {{"mm", dims::kLength, 1e-3}, {1, 1, -3, 0}},
    {{"cm", dims::kLength, 1e-2}, {1, 1, -2, 0}},
    {{"dm", dims::kLength, 1e-1}, {1, 1, -1, 0}},
    {{"m", dims::kLength, 1}, {}},
    {{"km", dims::kLength, 1e3}, {1, 1, 3, 0}},
    {{"inch", dims::kLength, 0.0254}, {254, 1, -4, 0}},
    {{"us", dims::kTime, 1e-6}, {1, 1, -6, 0}},
    {{"\u00B5s", dims::kTime, 1e-6}, {1, 1, -6, 0}},
    {{"\u03BCs", dims::kTime, 1e-6}, {1, 1, -6, 0}},
    {{"ms", dims::kTime, 1e-3}, {1, 1, -3, 0}},
    {{"s", dims::kTime, 1}, {}},
    {{"min", dims::kTime, 60}, {60, 1, 0, 0}},
    {{"h", dims::kTime, 3600}, {3600, 1, 0, 0}},
    {{"g", dims::kMass, 1e-3}, {1, 1, -3, 0}},
    {{"kg", dims::kMass, 1}, {}},
    {{"mN", dims::kForce, 1e-3}, {1, 1, -3, 0}},
    {{"N", dims::kForce, 1}, {}},
    {{"kN", dims::kForce, 1e3}, {1, 1, 3, 0}},
    {{"Nm", dims::kTorque, 1}, {}},
    {{"rpm", dims::kAngularSpeed, 2 * kPi / 60}, {2, 60, 0, 1}},
    {{"Hz", kFrequency, 1}, {}},
    {{"kHz", kFrequency, 1e3}, {1, 1, 3, 0}},
    {{"J", dims::kTorque, 1}, {}},
    {{"W", kPower, 1}, {}},
    {{"Pa", kPressure, 1}, {}},
    {{"kPa", kPressure, 1e3}, {1, 1, 3, 0}},
    {{"MPa", kPressure, 1e6}, {1, 1, 6, 0}},
    {{"bar", kPressure, 1e5}, {1, 1, 5, 0}},
    {{"px", dims::kNone, 1}, {}},
};

constexpr auto kUnits = [] {
  std::array<Unit, std::size(kRows)> units{};
  for (std::size_t i = 0; i < units.size(); ++i) units[i] = kRows[i].unit;
  return units;
}();

struct NamedDim {
  std::string_view name;
  Dim dim;
  std::string_view phrase;
  std::string_view si_unit;  // the SI unit that display_unit shows
};

// The first name of a dimension is the one in messages: torque before energy.
constexpr NamedDim kDims[] = {
    {"angle", dims::kAngle, "an angle", "rad"},
    {"length", dims::kLength, "a length", "m"},
    {"time", dims::kTime, "a time", "s"},
    {"mass", dims::kMass, "a mass", "kg"},
    {"area", {4, 0, 0, 0}, "an area", "m^2"},
    {"volume", {6, 0, 0, 0}, "a volume", "m^3"},
    {"speed", dims::kSpeed, "a speed", "m/s"},
    {"angularSpeed", dims::kAngularSpeed, "an angular speed", "rad/s"},
    {"accel", dims::kAccel, "an acceleration", "m/s^2"},
    {"angularAccel", dims::kAngularAccel, "an angular acceleration", "rad/s^2"},
    {"force", dims::kForce, "a force", "N"},
    {"torque", dims::kTorque, "a torque", "Nm"},
    {"inertia", {4, 2, 0, 0}, "an inertia", "kg*m^2"},
    {"energy", dims::kTorque, "an energy", "Nm"},
    {"power", kPower, "a power", "W"},
    {"pressure", kPressure, "a pressure", "Pa"},
    {"frequency", kFrequency, "a frequency", "Hz"},
    {"density", {-6, 2, 0, 0}, "a density", "kg/m^3"},
};

// Dimensions without a name whose unit has a usual form.
struct UsualUnit {
  Dim dim;
  std::string_view unit;
};

constexpr UsualUnit kUsualUnits[] = {
    {{0, 2, -4, 0}, "N/m"},       {{4, 2, -4, -2}, "Nm/rad"}, {{0, 2, -2, 0}, "N*s/m"},
    {{4, 2, -2, -2}, "Nm*s/rad"}, {{2, 2, -2, 0}, "N*s"},     {{4, 2, -2, 0}, "Nm*s"},
    {{2, 2, -4, -2}, "N/rad"},    {{-4, 2, -4, 0}, "N/m^3"},
};

constexpr auto kDimNames = [] {
  std::array<std::string_view, std::size(kDims)> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kDims[i].name;
  return names;
}();

const NamedDim* find_dim(Dim dim) {
  for (const NamedDim& row : kDims) {
    if (row.dim == dim) return &row;
  }
  return nullptr;
}

template <class Combine>
std::optional<Dim> combine(Dim a, Dim b, Combine f) {
  Dim out;
  const auto set = [&](std::int8_t Dim::*part) {
    const int value = f(a.*part, b.*part);
    out.*part = static_cast<std::int8_t>(value);
    return value >= -128 && value <= 127;
  };
  if (set(&Dim::length) && set(&Dim::mass) && set(&Dim::time) && set(&Dim::angle)) return out;
  return std::nullopt;
}

// A product such as "length/mass^2" or "m/kg^2": the powers of `dim` with the given names of the
// four base dimensions.
std::string product_text(Dim dim, const std::array<std::string_view, 4>& names) {
  const int halves[] = {dim.length, dim.mass, dim.time, dim.angle};
  std::string over;
  std::string under;
  for (const std::size_t i : {1U, 0U, 2U, 3U}) {
    if (halves[i] == 0) continue;
    std::string& out = halves[i] > 0 ? over : under;
    if (halves[i] < 0) {
      out += '/';
    } else if (!out.empty()) {
      out += '*';
    }
    out += names[i];
    const int size = std::abs(halves[i]);
    if (size == 2) continue;
    out += '^' + std::to_string(size / 2);
    if (size % 2 != 0) out += ".5";
  }
  return (over.empty() ? "1" : over) + under;
}

const UnitRow* find_unit(std::string_view name) {
  for (const UnitRow& row : kRows) {
    if (row.unit.name == name) return &row;
  }
  return nullptr;
}

struct ParsedUnit {
  Dim dim;
  ExactFactor exact;
};

// Multiplies `out` by the unit to the power halves/2.
bool apply_unit(ParsedUnit& out, const UnitRow& row, int halves) {
  constexpr int kMostHalves = 18;  // of units whose factors are multiplied
  const std::optional<Dim> part = power(row.unit.dim, halves);
  const std::optional<Dim> dim = part ? multiply(out.dim, *part) : std::nullopt;
  if (!dim) return false;
  out.dim = *dim;
  if (row.unit.factor == 1.0) return true;
  if (halves % 2 != 0 || std::abs(halves) > kMostHalves) return false;
  const int times = halves / 2;
  out.exact.exponent += times * row.exact.exponent;
  out.exact.pi_power += times * row.exact.pi_power;
  for (int i = 0; i < std::abs(times); ++i) {
    out.exact.numerator *= times > 0 ? row.exact.numerator : row.exact.denominator;
    out.exact.denominator *= times > 0 ? row.exact.denominator : row.exact.numerator;
  }
  return true;
}

// Parses an exponent such as "2" or "-0.5", in halves.
std::optional<int> parse_exponent(std::string_view text) {
  const bool has_half = text.ends_with(".5");
  const bool is_negative = text.starts_with('-');
  if (has_half) text.remove_suffix(2);
  int whole = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), whole);
  if (error != std::errc{} || stop != text.data() + text.size() || std::abs(whole) > 99)
    return std::nullopt;
  return 2 * whole + (!has_half ? 0 : is_negative ? -1 : 1);
}

// Splits "kg*m^2/s" at * and /; each sign belongs to the part after it.
std::optional<ParsedUnit> parse_parts(std::string_view text) {
  ParsedUnit out;
  int sign = 1;
  if (text.starts_with("1/")) {
    sign = -1;
    text.remove_prefix(2);
  }
  while (true) {
    const std::size_t end = std::min(text.find_first_of("*/"), text.size());
    std::string_view part = text.substr(0, end);
    std::optional<int> halves = 2;
    if (const std::size_t hat = part.find('^'); hat != std::string_view::npos) {
      halves = parse_exponent(part.substr(hat + 1));
      part = part.substr(0, hat);
    }
    const UnitRow* row = find_unit(part);
    if (row == nullptr || !halves || !apply_unit(out, *row, sign * *halves)) return std::nullopt;
    if (end == text.size()) return out;
    sign = text[end] == '/' ? -1 : 1;
    text.remove_prefix(end + 1);
  }
}

double power_of_ten(int exponent) {
  double out = 1.0;
  for (int i = 0; i < exponent; ++i) out *= 10.0;  // exact up to 10^22
  return out;
}

// number * factor, with a single division at the end.
double scale(double number, const ExactFactor& factor) {
  double over = number * factor.numerator;
  double under = factor.denominator;
  for (int i = 0; i < std::abs(factor.pi_power); ++i) (factor.pi_power > 0 ? over : under) *= kPi;
  (factor.exponent > 0 ? over : under) *= power_of_ten(std::abs(factor.exponent));
  return over / under;
}

// Parses a decimal number without underscores: digits, point, exponent.
std::optional<double> decimal(std::string_view text) {
  if (text.empty() || !(text[0] == '.' || (text[0] >= '0' && text[0] <= '9'))) return std::nullopt;
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

// Parses a decimal number whose point is moved by `shift` digits before the number is rounded.
std::optional<double> shifted_decimal(std::string text, int shift) {
  int exponent = 0;
  if (const std::size_t e = text.find_first_of("eE"); e != std::string::npos) {
    const char* first = text.data() + e + (text[e + 1] == '+' ? 2 : 1);
    if (std::from_chars(first, text.data() + text.size(), exponent).ec != std::errc{}) {
      return std::nullopt;
    }
    text.resize(e);
  }
  if (std::abs(exponent) > 100'000) return std::nullopt;
  return decimal(text + 'e' + std::to_string(exponent + shift));
}

std::string without_underscores(std::string_view text) {
  std::string out(text);
  std::erase(out, '_');
  return out;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The count of characters of the number at the start of `text`.
std::size_t number_length(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && (is_digit(text[end]) || text[end] == '.' || text[end] == '_')) ++end;
  if (end == 0 || end == text.size() || (text[end] != 'e' && text[end] != 'E')) return end;
  std::size_t digits = end + 1;
  if (digits < text.size() && (text[digits] == '+' || text[digits] == '-')) ++digits;
  std::size_t after = digits;
  while (after < text.size() && is_digit(text[after])) ++after;
  return after > digits ? after : end;
}

std::optional<double> hexadecimal(std::string_view digits) {
  std::uint64_t value = 0;
  const auto [stop, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc{} || stop != digits.data() + digits.size()) return std::nullopt;
  return static_cast<double>(value);
}

}  // namespace

std::optional<Dim> multiply(Dim a, Dim b) {
  return combine(a, b, [](int x, int y) { return x + y; });
}

std::optional<Dim> divide(Dim a, Dim b) {
  return combine(a, b, [](int x, int y) { return x - y; });
}

std::optional<Dim> power(Dim a, int halves) {
  if (std::abs(halves) > 254) return a.is_none() ? std::optional<Dim>(a) : std::nullopt;
  const int parts[] = {a.length, a.mass, a.time, a.angle};
  for (const int part : parts) {
    if (part * halves % 2 != 0) return std::nullopt;
  }
  return combine(a, a, [halves](int x, int) { return x * halves / 2; });
}

std::optional<Dim> dimension_named(std::string_view name) {
  for (const NamedDim& row : kDims) {
    if (row.name == name) return row.dim;
  }
  return std::nullopt;
}

std::span<const std::string_view> dimension_names() { return kDimNames; }

std::string dimension_name(Dim dim) {
  if (dim.is_none()) return "number";
  if (const NamedDim* row = find_dim(dim)) return std::string(row->name);
  return product_text(dim, {"length", "mass", "time", "angle"});
}

std::string dimension_phrase(Dim dim) {
  if (dim.is_none()) return "a plain number";
  if (const NamedDim* row = find_dim(dim)) return std::string(row->phrase);
  return "a value in " + display_unit(dim, 1.0).name;
}

const Unit* unit_named(std::string_view name) {
  for (const Unit& unit : kUnits) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

std::span<const Unit> all_units() { return kUnits; }

std::optional<CombinedUnit> parse_unit(std::string_view text) {
  const std::optional<ParsedUnit> unit = parse_parts(text);
  if (!unit) return std::nullopt;
  return CombinedUnit{unit->dim, scale(1.0, unit->exact)};
}

std::optional<Quantity> parse_quantity(std::string_view text) {
  const std::size_t length = number_length(text);
  const std::string digits = without_underscores(text.substr(0, length));
  const std::string_view unit_text = text.substr(length);
  const std::optional<double> si = si_of(digits, unit_text);
  if (!si) return std::nullopt;
  return Quantity{*si, parse_parts(unit_text)->dim, *decimal(digits), unit_text};
}

std::optional<double> si_of(std::string_view number, std::string_view unit) {
  const std::optional<double> value = decimal(number);
  const std::optional<ParsedUnit> parts = parse_parts(unit);
  if (!value || !parts) return std::nullopt;
  const ExactFactor& factor = parts->exact;
  const bool only_decimal =
      factor.numerator == 1.0 && factor.denominator == 1.0 && factor.pi_power == 0;
  const std::optional<double> si =
      only_decimal ? shifted_decimal(std::string(number), factor.exponent) : scale(*value, factor);
  return si && std::isfinite(*si) ? si : std::nullopt;
}

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) return hexadecimal(text.substr(2));
  const std::size_t length = number_length(text);
  const std::string_view rest = text.substr(length);
  const bool suffix =
      rest.size() == 1 && std::string_view("fFdDlL").find(rest[0]) != std::string_view::npos;
  if (!rest.empty() && !suffix) return std::nullopt;
  return decimal(without_underscores(text.substr(0, length)));
}

DisplayUnit display_unit(Dim dim, double si_value) {
  const double size = std::abs(si_value);
  if (dim == dims::kAngle) return {"deg", kPi / 180};
  if (dim == dims::kLength && size < 1.0) return {"mm", 1e-3};
  if (dim == dims::kMass && size < 1.0) return {"g", 1e-3};
  if (dim.is_none()) return {"", 1.0};
  if (const NamedDim* row = find_dim(dim)) return {std::string(row->si_unit), 1.0};
  for (const UsualUnit& row : kUsualUnits) {
    if (row.dim == dim) return {std::string(row.unit), 1.0};
  }
  return {product_text(dim, {"m", "kg", "s", "rad"}), 1.0};
}

std::string si_unit(Dim dim) {
  constexpr double kLarge = 1e6;  // above it, metres and kilograms instead of millimetres and grams
  return dim == dims::kAngle ? "rad" : display_unit(dim, kLarge).name;
}

}  // namespace armlet
