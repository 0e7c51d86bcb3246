#pragma once

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

// Where an arm of a mechanism ends.
//
// note  why it ends there although other joints hang on it, a clause; empty: there is no question.
struct ArmTip {
  int body = -1;
  Eigen::Isometry3d T_body_tip = Eigen::Isometry3d::Identity();
  std::string note{};
};

// The link or tip of that name. Without a name the end of the only chain of joints; where several
// divide, of the one with the most joints, if no other has as many, none of its joints copies
// another and all joints beside it do.
//
// returns  an error that lists the ends with their joints if this does not decide.
Result<ArmTip> find_arm_tip(const Mechanism& mechanism, std::string_view name);

}  // namespace armlet
