#include "armlet/model/joint.hpp"

#include <numbers>

#include "armlet/core/format.hpp"

namespace armlet {

std::string format_joint_value(JointKind kind, double value) {
  return kind == JointKind::kRevolute ? format_deg(value) : format_mm(value);
}

std::string format_joint_value(JointKind kind, double value, double beside) {
  const bool turns = kind == JointKind::kRevolute;
  const double unit = turns ? std::numbers::pi / 180.0 : 1e-3;
  std::string text = format_joint_value(kind, value);
  const std::string other = format_joint_value(kind, beside);
  constexpr int kMostDecimals = 12;
  for (int decimals = 2; text == other && value != beside && decimals <= kMostDecimals; ++decimals)
    text = format_number(value / unit, decimals) + (turns ? " deg" : " mm");
  return text;
}

std::string_view joint_word(JointKind kind) {
  return kind == JointKind::kRevolute ? "turn" : "slide";
}

}  // namespace armlet
