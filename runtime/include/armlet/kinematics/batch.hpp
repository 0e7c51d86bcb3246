#pragma once

#include <span>

#include "armlet/chain/instruction_set.hpp"
#include "armlet/model/robot.hpp"

namespace armlet {

// Tool poses of any number of configurations, several at once. A batch of one is as fast as
// forward().
//
// q        structure of arrays: joint i of configuration k is q[i * count + k], rad or m; `count`
//          is the size of q over n and may be 0.
// poses    12 count numbers: entry e is poses[e * count + k]; 0-2, 3-5 and 6-8 are the axes x, y, z
//          of the tool in the world and 9-11 its origin.
// set      the result of a configuration has the same bits for every set, alone and in any batch.
//          It is within 2e-16 (n + 2) of forward(); for the origin, times the length of the path
//          from the world's origin along all frames to the tool.
// throws   ArgumentError on a wrong size, on a joint value that is not finite, and on a set that
//          this processor lacks.
// source   as forward().
void forward_batch(const Robot& robot, std::span<const double> q, std::span<double> poses,
                   InstructionSet set = best_instruction_set());

// World Jacobians of the tool point, as accurate as those of jacobian(). The arguments q and set,
// the exceptions and the sources are those of forward_batch and jacobian().
//
// jacobians  6 n count numbers: row r of column i is jacobians[(6 * i + r) * count + k]; m or 1 for
//            v, 1/m or 1 for w, per joint value.
void jacobian_batch(const Robot& robot, std::span<const double> q, std::span<double> jacobians,
                    InstructionSet set = best_instruction_set());

}  // namespace armlet
