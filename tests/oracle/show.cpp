#include "show.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace armlet::oracle {

namespace {

std::string printed(const char* format, int digits, double value) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, digits, value);
  return buffer;
}

// "1.25e+02" with the fewest digits that read back to the same value, at most so many.
std::string shortest(double value, int most) {
  for (int digits = 0; digits < most; ++digits) {
    std::string text = printed("%.*e", digits, value);
    if (digits == most - 1 || std::strtod(text.c_str(), nullptr) == value) return text;
  }
  return {};
}

// The number without a needless point: "2", "0.1", "1e-07".
std::string bare(double value, int most = 15) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  if (value == 0) return "0";
  const std::string scientific = shortest(std::fabs(value), most);
  const std::size_t e = scientific.find('e');
  const int exponent = std::atoi(scientific.c_str() + e + 1);
  std::string digits = scientific.substr(0, 1);
  if (e > 2) digits += scientific.substr(2, e - 2);
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  std::string out = value < 0 ? "-" : "";
  if (exponent < -4 || exponent >= 15) {
    out += digits.substr(0, 1);
    if (digits.size() > 1) out += "." + digits.substr(1);
    return out + scientific.substr(e);
  }
  if (exponent < 0) return out + "0." + std::string(-exponent - 1, '0') + digits;
  const std::size_t whole = exponent + 1;
  if (digits.size() <= whole) return out + digits + std::string(whole - digits.size(), '0');
  return out + digits.substr(0, whole) + "." + digits.substr(whole);
}

// Quantities and elements of matrices have ten digits at most.
constexpr int kMeasured = 10;

std::string styled(double value, const Style& style) {
  std::string text;
  if (!style.has_digits() || !std::isfinite(value)) {
    text = bare(value, kMeasured);
  } else {
    const int digits = style.digits < 0 ? 6 : style.digits;
    const char* format = style.letter == 'e' ? "%.*e" : style.letter == 'g' ? "%.*g" : "%.*f";
    text = printed(format, digits, value);
    // Minus nothing is nothing.
    const bool is_zero =
        std::strtod(text.c_str(), nullptr) == 0.0 &&
        text.substr(0, text.find('e')).find_first_of("123456789") == std::string::npos;
    if (is_zero && text[0] == '-') text.erase(0, 1);
  }
  return text;
}

int length_of(const std::string& text) {
  int count = 0;
  for (const char c : text) count += (c & 0xC0) != 0x80 ? 1 : 0;
  return count;
}

// Blanks around a text, or zeros behind the sign of a number, up to the width.
std::string filled(std::string text, const Style& style, bool is_number) {
  if (is_number && style.sign && text[0] != '-' && text != "nan") text.insert(0, "+");
  const int missing = style.width - length_of(text);
  if (missing <= 0) return text;
  const std::size_t first = text[0] == '-' || text[0] == '+' ? 1 : 0;
  if (is_number && style.zeros && text[first] >= '0' && text[first] <= '9')
    return text.insert(first, std::string(missing, '0'));
  const char align = style.align != 0 ? style.align : is_number ? '>' : '<';
  if (align == '<') return text + std::string(missing, ' ');
  if (align == '>') return std::string(missing, ' ') + text;
  return std::string(missing / 2, ' ') + text + std::string(missing - missing / 2, ' ');
}

std::string with_point(const std::string& text) {
  const bool needs_point = text.find_first_of(".enai") == std::string::npos;
  return needs_point ? text + ".0" : text;
}

// The unit chosen by size: degrees, mm below 1 m, g below 1 kg, otherwise SI.
DisplayUnit unit_for(Dim dim, double value) {
  if (dim == dims::kAngle) return {"deg", std::numbers::pi / 180.0};
  if (dim == dims::kLength)
    return std::fabs(value) < 1.0 ? DisplayUnit{"mm", 1e-3} : DisplayUnit{"m", 1.0};
  if (dim == dims::kMass)
    return std::fabs(value) < 1.0 ? DisplayUnit{"g", 1e-3} : DisplayUnit{"kg", 1.0};
  if (dim == dims::kTime) return {"s", 1.0};
  return {display_unit(dim, value).name, 1.0};  // a name from the table of dimensions
}

std::string show_real(double value, Dim dim, const Style& style) {
  std::string text;
  if (!style.unit.empty()) {
    text = styled(value / style.factor, style) + " " + style.unit;
  } else if (dim.is_none()) {
    text = style.has_digits() ? styled(value, style) : show_number(value);
  } else {
    const DisplayUnit unit = unit_for(dim, value);
    text = styled(value / unit.factor, style);
    if (!unit.name.empty()) text += " " + unit.name;
  }
  return filled(text, style, true);
}

// What is nothing beside the largest of the numbers is 0.
double without_noise(double value, double largest, const Style& style) {
  const bool is_noise = std::fabs(value) <= 1e-12 * largest;
  return is_noise && !style.has_digits() ? 0.0 : value;
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : std::string(1, c);
  }
  return out + "\"";
}

std::string show_inside(const Value& value, const Type& type, const Style& style) {
  return type.is(Kind::kText) ? quoted(value.text()) : show(value, type, style);
}

std::string show_list(const List& list, const Type& element, const Style& style) {
  std::string out = "[";
  const bool quantities = element.is(Kind::kReal) && !element.dim.is_none();
  double largest = 0.0;
  for (const Value& item : list.items) {
    if (quantities && std::isfinite(item.real()))
      largest = std::max(largest, std::fabs(item.real()));
  }
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    if (i > 0) out += ", ";
    out += quantities
               ? show_real(without_noise(list.items[i].real(), largest, style), element.dim, style)
               : show_inside(list.items[i], element, style);
  }
  return out + "]";
}

std::string show_map(const Map& map, const Type& type, const Style& style) {
  std::string out;
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    out += (i > 0 ? ", " : "") + show_inside(map.keys[i], *type.key, {}) + ": " +
           show_inside(map.values[i], *type.element, style);
  }
  return "[" + (out.empty() ? ":" : out) + "]";
}

std::string show_record(const Record& record, const RecordInfo& info, const Style& style) {
  std::string out = info.name + "(";
  for (std::size_t i = 0; i < info.fields.size(); ++i) {
    out += (i > 0 ? ", " : "") + info.fields[i].name + ": " +
           show_inside(record.fields[i], *info.fields[i].type, style);
  }
  return out + ")";
}

std::string show_matrix(const Matrix& matrix, const Style& style) {
  std::string out = "[";
  double largest = 0.0;
  for (const Value& number : matrix.numbers) {
    if (std::isfinite(number.real())) largest = std::max(largest, std::fabs(number.real()));
  }
  for (std::size_t i = 0; i < matrix.numbers.size(); ++i) {
    if (i > 0) out += i % matrix.cols == 0 ? "; " : ", ";
    const double number = without_noise(matrix.numbers[i].real(), largest, style);
    if (style.has_digits() || !style.unit.empty()) {
      out += show_real(number, dims::kNone, style);
    } else {
      out += filled(with_point(bare(number, kMeasured)), style, true);
    }
  }
  return out + "]";
}

}  // namespace

std::string show_number(double value) { return with_point(bare(value)); }

std::string show(const Value& value, const Type& type, const Style& style) {
  switch (type.kind) {
    case Kind::kBool:
      return filled(value.truth() ? "true" : "false", style, false);
    case Kind::kInt:
      if (style.has_digits() || !style.unit.empty())
        return show_real(static_cast<double>(value.integer()), dims::kNone, style);
      return filled(std::to_string(value.integer()), style, true);
    case Kind::kReal:
      return show_real(value.real(), type.dim, style);
    case Kind::kText:
      return filled(value.text(), style, false);
    case Kind::kEnum:
      return filled(type.enumeration->name + "." + type.enumeration->values[value.integer()], style,
                    false);
    case Kind::kList:
      return show_list(value.list(), *type.element, style);
    case Kind::kMap:
      return show_map(value.map(), type, style);
    case Kind::kRecord:
      return show_record(value.record(), *type.record, style);
    case Kind::kMatrix:
      return show_matrix(value.matrix(), style);
    case Kind::kFunction:
      return type_name(&type);
    default:
      throw std::logic_error("the oracle cannot show a " + type_name(&type));
  }
}

}  // namespace armlet::oracle
