#include "show.hpp"

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

// "1.25e+02" with the fewest digits that read back to the same value, 15 at most.
std::string shortest(double value) {
  for (int digits = 0; digits < 15; ++digits) {
    std::string text = printed("%.*e", digits, value);
    if (digits == 14 || std::strtod(text.c_str(), nullptr) == value) return text;
  }
  return {};
}

// The number without a needless point: "2", "0.1", "1e-07".
std::string bare(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  if (value == 0) return "0";
  const std::string scientific = shortest(std::fabs(value));
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

std::string styled(double value, const Style& style) {
  if (style.digits < 0 && style.letter == 0) return bare(value);
  if (!std::isfinite(value)) return bare(value);
  const int digits = style.digits < 0 ? 6 : style.digits;
  const char* format = style.letter == 'e' ? "%.*e" : style.letter == 'g' ? "%.*g" : "%.*f";
  std::string text = printed(format, digits, value);
  // Minus nothing is nothing.
  const bool is_zero =
      std::strtod(text.c_str(), nullptr) == 0.0 &&
      text.substr(0, text.find('e')).find_first_of("123456789") == std::string::npos;
  if (is_zero && text[0] == '-') text.erase(0, 1);
  return text;
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
  if (!style.unit.empty()) return styled(value / style.factor, style) + " " + style.unit;
  if (dim.is_none()) {
    return style.digits < 0 && style.letter == 0 ? show_number(value) : styled(value, style);
  }
  const DisplayUnit unit = unit_for(dim, value);
  const std::string number = styled(value / unit.factor, style);
  return unit.name.empty() ? number : number + " " + unit.name;
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
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    out += (i > 0 ? ", " : "") + show_inside(list.items[i], element, style);
  }
  return out + "]";
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
  for (std::size_t i = 0; i < matrix.numbers.size(); ++i) {
    if (i > 0) out += i % matrix.cols == 0 ? "; " : ", ";
    out += show_real(matrix.numbers[i].real(), dims::kNone, style);
  }
  return out + "]";
}

}  // namespace

std::string show_number(double value) {
  const std::string text = bare(value);
  const bool needs_point = text.find_first_of(".enai") == std::string::npos;
  return needs_point ? text + ".0" : text;
}

std::string show(const Value& value, const Type& type, const Style& style) {
  switch (type.kind) {
    case Kind::kBool:
      return value.truth() ? "true" : "false";
    case Kind::kInt:
      if (style.is_plain()) return std::to_string(value.integer());
      return show_real(static_cast<double>(value.integer()), dims::kNone, style);
    case Kind::kReal:
      return show_real(value.real(), type.dim, style);
    case Kind::kText:
      return value.text();
    case Kind::kEnum:
      return type.enumeration->name + "." + type.enumeration->values[value.integer()];
    case Kind::kList:
      return show_list(value.list(), *type.element, style);
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
