#pragma once
// From a text to what an analysis keeps.

#include <memory>
#include <string>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/engine.hpp"

namespace armlet::lang {

struct Facts;
class Registry;

// before  of a text that is much alike; null: none.
// Everything that is wrong with the text comes back as diagnostics.
[[nodiscard]] std::unique_ptr<const Analysis::Facts> analyse_text(
    std::shared_ptr<const Registry> registry, std::string text, std::string name,
    const CompileOptions& options, const Facts* before);

}  // namespace armlet::lang
