#pragma once

#include <cstddef>

// Arguments of the kernels for batches; plain data only, because sources for larger instruction
// sets include it.
namespace armlet {

// LinkTwist, as a number.
inline constexpr unsigned char kRightTwist = 1, kAnyTwist = 2;

// A plan as plain pointers, for kernels.
struct BatchArm {
  std::size_t n;
  bool base_is_none, tool_on_axis;
  const double *theta, *q_to_theta, *d, *q_to_d, *a, *sin_alpha, *cos_alpha, *base, *tool;
  const bool *has_d, *has_a;
  const unsigned char* twist;

  [[gnu::always_inline]] bool slides(std::size_t i) const { return q_to_theta[i] == 0.0; }
  // Whether the angle of a joint is its value.
  [[gnu::always_inline]] bool plain(std::size_t i) const {
    return theta[i] == 0.0 && q_to_theta[i] == 1.0;
  }
  [[gnu::always_inline]] bool right_angle(std::size_t i) const { return twist[i] == kRightTwist; }
  [[gnu::always_inline]] bool any_angle(std::size_t i) const { return twist[i] == kAnyTwist; }
};

// A kernel for many configurations: entry e of configuration k is element [e * count + k] of `q`
// and of the output. `count` is at least the number of lanes.
using BatchKernel = void(const BatchArm& arm, const double* q, std::size_t count, double* out);

// Storage for the sines of the `lanes` configurations from number k on: the sine of joint i is at
// sines[i * stride + lane].
struct BlockSines {
  std::size_t k, lanes, stride;
  double *sines, *cosines;
};

// Recomputes the sines and cosines of angles that are too large for the kernels, and no others.
//
// throws  ArgumentError if a joint value is not finite.
void careful_batch_sines(const BatchArm& arm, const double* q, std::size_t count,
                         const BlockSines& block);

inline constexpr std::size_t kBatchJoints = 12;

}  // namespace armlet
