#pragma once
// A motion from the call that starts it to the Move that the call returns.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "moves/moves.hpp"

namespace armlet::bind {

// The words of a move with several targets. Left out, they follow from the call.
//
// labels   one text for each target: "moveL to (300, 0, 150) mm".
// call_of  the call that messages about the refused target of a report mark.
// timed    the call that messages about the time mark.
struct MoveWords {
  std::function<std::vector<std::string>(const MoveReport& report)> labels{};
  std::function<MoveCall(const MoveReport& report)> call_of{};
  std::optional<MoveCall> timed{};
};

// Makes the move and reports what it exceeds, or why it is refused. A robot that decelerates after
// a velocity command continues with its present speed. A move that is stopped before its end
// reports the path length of the moving point.
Started run_move(Vm& vm, MoveCall call, const MoveCommand& command, const MoveWords& words = {});

// A move that is not executed: it has ended at once.
std::unique_ptr<Waiting> no_move();

}  // namespace armlet::bind
