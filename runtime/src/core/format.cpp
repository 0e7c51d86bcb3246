#include "armlet/core/format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace armlet {

std::string format_number(double value, int digits) {
  if (std::isnan(value)) return "nan";  // never with a sign
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string format_mm(double length) { return format_number(length * 1000.0, 1) + " mm"; }

std::string format_deg(double angle) {
  return format_number(angle * (180.0 / std::numbers::pi), 1) + " deg";
}

}  // namespace armlet
