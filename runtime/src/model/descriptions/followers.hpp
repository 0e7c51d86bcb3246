#pragma once

#include <memory>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "chain_drives.hpp"

namespace armlet {

// The links of a mechanism outside of an arm that are moved by mimic joints of the arm.
//
// follows    of each body, whether it is one of them.
// mechanism  RobotSpec::followers; null if they have neither mass nor friction.
struct Followers {
  std::vector<bool> follows;
  std::shared_ptr<const Mechanism> mechanism;
};

// chain   bodies of the rows of the arm.
// drives  of these rows.
Followers followers_of(const Mechanism& mechanism, const std::vector<int>& chain,
                       const ChainDrives& drives);

// A link with only its shape.
Link without_mass(const Link& link);

}  // namespace armlet
