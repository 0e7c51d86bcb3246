#pragma once

#include <span>

#include "armlet/interpreter/reference.hpp"

namespace armlet {

// The subjects of textbooks and the names of other toolboxes, with the pages of the library about
// them: keywords of the reference for help_about. Names that messages about unknown names propose,
// such as `ik` for `ikine`, are found as well and are not repeated here.
[[nodiscard]] std::span<const HelpTopic> help_topics();

}  // namespace armlet
