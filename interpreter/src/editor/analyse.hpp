#pragma once
// Makes the data of an analysis from a text.

#include <memory>
#include <string>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/engine.hpp"

namespace armlet::lang {

struct Facts;
class Registry;

// Analyses a text. All mistakes in it are returned as diagnostics.
//
// before  the analysis of a similar text, whose results are reused; null: none.
[[nodiscard]] std::unique_ptr<const Analysis::Facts> analyse_text(
    std::shared_ptr<const Registry> registry, std::string text, std::string name,
    const CompileOptions& options, const Facts* before);

}  // namespace armlet::lang
