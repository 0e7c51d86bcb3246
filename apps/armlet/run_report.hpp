#pragma once
// What is said of a run at its end.

#include <string>

#include "armlet/stdlib/session.hpp"

namespace armlet::cli {

// trace  where one was left; empty: nowhere.
void show_summary(const Session& session, const std::string& trace, Progress status);

}  // namespace armlet::cli
