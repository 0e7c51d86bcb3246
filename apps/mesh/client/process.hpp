#pragma once
// The converter as a process: started, answered, and ended when it exceeds its limits.

#include <functional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "client/siblings.hpp"
#include "exchange.hpp"

namespace armlet::mesh {

// One conversion by the program `program`.
//
// arguments  of the program, without its limits.
// input      bytes of the mesh.
// find       gives a file that the mesh names.
// progress   null, or called with what the converter does, about once a second from the first on.
// is_cancelled  null, or asked many times a second.
struct ConverterRun {
  std::string program;
  std::vector<std::string> arguments;
  std::string_view input;
  std::function<Sibling(const std::string& name)> find;
  std::function<void(const std::string& stage, int seconds)> progress;
  std::function<bool()> is_cancelled;
  ConvertLimits limits;
};

// The GLB, or the reason as a sentence without an end: what the converter says, which limit it
// exceeded, that it was cancelled, or that it ended by a signal. The process has ended in each
// case.
[[nodiscard]] Result<std::string> run_converter(const ConverterRun& run);

}  // namespace armlet::mesh
