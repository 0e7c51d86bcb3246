#pragma once
// The summary of a run at its end.

#include <string>

#include "armlet/stdlib/session.hpp"

namespace armlet::cli {

// trace  the trace file; empty: none.
void show_summary(const Session& session, const std::string& trace, Progress status);

}  // namespace armlet::cli
