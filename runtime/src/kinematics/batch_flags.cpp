#include "batch_flags.hpp"

namespace armlet {

BatchFlags::BatchFlags(const WalkPlan& plan) {
  for (std::size_t i = 0; i <= static_cast<std::size_t>(plan.n); ++i) {
    right[i] = plan.twist[i] == Twist::kRightAngle;
    any[i] = plan.twist[i] == Twist::kAny;
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(plan.n); ++i) {
    slides[i] = plan.slide[i] != 0.0;
    plain[i] = plan.theta[i] == 0.0 && plan.turn[i] == 1.0;
  }
}

BatchArm batch_arm(const WalkPlan& plan, const BatchFlags& flags) {
  return {.n = static_cast<std::size_t>(plan.n),
          .base_is_none = plan.base_is_none,
          .tool_on_axis = plan.tool_on_axis,
          .theta = plan.theta.data(),
          .turn = plan.turn.data(),
          .d = plan.d.data(),
          .slide = plan.slide.data(),
          .a = plan.a.data(),
          .sin_alpha = plan.sin_alpha.data(),
          .cos_alpha = plan.cos_alpha.data(),
          .base = plan.base.data(),
          .tool = plan.tool.data(),
          .has_d = plan.has_d.data(),
          .has_a = plan.has_a.data(),
          .slides = flags.slides.data(),
          .plain = flags.plain.data(),
          .right_angle = flags.right.data(),
          .any_angle = flags.any.data()};
}

}  // namespace armlet
