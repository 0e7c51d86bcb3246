#pragma once

#include <memory>
#include <vector>

#include "armlet/model/mechanism.hpp"

namespace armlet {

// The links of a mechanism that joints carry which copy joints of an arm without belonging to it.
//
// follows    of each body, whether it is one.
// mechanism  RobotSpec::followers; null if they have neither mass nor friction.
struct Followers {
  std::vector<bool> follows;
  std::shared_ptr<const Mechanism> mechanism;
};

// chain   bodies that the joints of the arm move.
// motors  the actuator of each.
Followers followers_of(const Mechanism& mechanism, const std::vector<int>& chain,
                       const std::vector<Eigen::Index>& motors);

// A link with its shape alone.
Link without_mass(const Link& link);

}  // namespace armlet
