#include "armlet/model/joint.hpp"

#include "armlet/core/format.hpp"

namespace armlet {

std::string format_joint_value(JointKind kind, double value) {
  return kind == JointKind::kRevolute ? format_deg(value) : format_mm(value);
}

std::string_view joint_word(JointKind kind) {
  return kind == JointKind::kRevolute ? "turn" : "slide";
}

}  // namespace armlet
