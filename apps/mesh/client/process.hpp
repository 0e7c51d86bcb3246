#pragma once
// The converter as a process: starts it, answers it, and ends it when it exceeds its limits.

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
// find       returns a file that the mesh names.
// progress   null, or called about once a second with the stage of the conversion.
// is_cancelled  null, or called many times a second.
struct ConverterRun {
  std::string program;
  std::vector<std::string> arguments;
  std::string_view input;
  std::function<Sibling(const std::string& name)> find;
  std::function<void(const std::string& stage, int seconds)> progress;
  std::function<bool()> is_cancelled;
  ConvertLimits limits;
};

// The GLB, or the reason as a sentence without a full stop: the converter's message, the limit that
// it exceeded, that it was cancelled, or that it ended by a signal. The process has ended in all
// cases.
[[nodiscard]] Result<std::string> run_converter(const ConverterRun& run);

}  // namespace armlet::mesh
