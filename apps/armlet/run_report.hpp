#pragma once
// What is said of a run while it goes and at its end.

#include <string>

#include "armlet/stdlib/session.hpp"

namespace armlet::cli {

void show_move(const MoveReport& move);
// trace  where one was left; empty: nowhere.
void show_summary(const Session& session, const std::string& trace, Progress status);

}  // namespace armlet::cli
