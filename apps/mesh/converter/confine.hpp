#pragma once
// The restrictions of the process that reads files of unknown origin.

#include <cstddef>
#include <string>

namespace armlet::mesh {

// From now on this process can only compute and communicate over the files 0 and 1: it can open no
// file, start no program, no connection and no thread, and ends when it exceeds `memory` bytes of
// address space or `cpu` seconds. Libraries that load others must have done so before.
//
// returns  the reason if it could not be restricted; empty: it is.
[[nodiscard]] std::string confine(std::size_t memory, int cpu);

}  // namespace armlet::mesh
