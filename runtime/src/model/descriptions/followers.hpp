#pragma once

#include <memory>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "chain_drives.hpp"

namespace armlet {

// The links of a mechanism that joints carry which copy joints of an arm without belonging to it.
//
// follows    of each body, whether it is one.
// mechanism  RobotSpec::followers; null if they have neither mass nor friction.
struct Followers {
  std::vector<bool> follows;
  std::shared_ptr<const Mechanism> mechanism;
};

// chain   bodies of the rows of the arm.
// drives  what moves them.
Followers followers_of(const Mechanism& mechanism, const std::vector<int>& chain,
                       const ChainDrives& drives);

// A link with its shape alone.
Link without_mass(const Link& link);

}  // namespace armlet
