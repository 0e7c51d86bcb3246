#pragma once

#include "armlet/model/link_shapes.hpp"

namespace armlet {

// The palm, or a finger: a rod for each of its links, with the dimensions of hands.cpp.
std::vector<LinkShape> hand_shapes(const Robot& robot);

}  // namespace armlet
