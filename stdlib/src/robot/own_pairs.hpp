// Pairs of links of an arm that are compared with each other, or not, in programs.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "armlet/interpreter/native.hpp"
#include "armlet/model/robot.hpp"

namespace armlet::bind {

// Rows of two names, as allow: and watch: take them: allow: [["link 1", "link 3"]].
using NamePairs = std::optional<std::span<const Slot>>;

// The robot with pairs that are never (allow) or always (watch) compared.
//
// throws  ArgumentError for a row that has not two names, for a name that no link has, for one link
//         twice, and for a pair that both name.
Robot with_own_pairs(Robot robot, NamePairs allow, NamePairs watch);

// Which pairs of its links are not compared with each other, and why, one line for each reason.
std::string exempt_text(const Robot& robot);

// The rows `allow:` and `watch:` of a robot block; empty if there are none.
std::string own_pairs_rows(const Robot& robot);

}  // namespace armlet::bind
