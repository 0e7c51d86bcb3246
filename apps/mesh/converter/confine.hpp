#pragma once
// What a process that reads files of others is kept from.

#include <cstddef>
#include <string>

namespace armlet::mesh {

// From now on this process computes and talks over the files 0 and 1, and nothing else: it can open
// no file, start no program, make no connection and no thread, and ends when it exceeds `memory`
// bytes of address space or `cpu` seconds. Libraries that load others have to have done so.
//
// returns  why it could not be confined; empty: it is.
[[nodiscard]] std::string confine(std::size_t memory, int cpu);

}  // namespace armlet::mesh
