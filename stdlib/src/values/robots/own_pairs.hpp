// Pairs of links of an arm that programs include in collision checks, or exclude.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "armlet/interpreter/native.hpp"
#include "armlet/model/robot.hpp"

namespace armlet::bind {

// Rows of two names, as allow: and watch: take them: allow: [["link 1", "link 3"]].
using NamePairs = std::optional<std::span<const Slot>>;

// The robot with pairs that are never (allow) or always (watch) checked for collisions.
//
// throws  ArgumentError for a row that does not have two names, for an unknown link, for a link
//         paired with itself, and for a pair in both lists.
Robot with_own_pairs(Robot robot, NamePairs allow, NamePairs watch);

// The pairs of links that are not checked against each other, one line for each reason.
std::string exempt_text(const Robot& robot);

// The rows `allow:` and `watch:` of a robot block; empty if there are none.
std::string own_pairs_rows(const Robot& robot);

}  // namespace armlet::bind
