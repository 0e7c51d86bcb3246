#pragma once

#include <string>
#include <string_view>

#include "armlet/core/error.hpp"
#include "armlet/model/mechanism.hpp"

namespace armlet {

// The end of an arm in a mechanism.
//
// note  why it is the end although there are other joints, a clause; empty: the end is unique.
struct ArmTip {
  int body = -1;
  Eigen::Isometry3d T_body_tip = Eigen::Isometry3d::Identity();
  std::string note{};
};

// The link or tip of that name. Without a name, the end of the only chain of joints; or of the
// longest of several chains, if no other is as long, it has no mimic joints and all joints outside
// of it are mimic joints.
//
// returns  an error that lists the ends with their joints if this does not determine it.
Result<ArmTip> find_arm_tip(const Mechanism& mechanism, std::string_view name);

}  // namespace armlet
