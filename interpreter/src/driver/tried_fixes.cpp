#include "driver/tried_fixes.hpp"

#include "driver/explained_habits.hpp"

namespace armlet::lang {

void drop_useless_fixes(std::vector<Diagnostic>& diagnostics, Trials& trials) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (!diagnostic.fix || diagnostic.fix->edits.empty()) continue;
    if (trials.exhausted()) {
      diagnostic.fix->confidence = Confidence::kMaybe;
      continue;
    }
    const std::optional<Trial> trial = trials.with(diagnostic.fix->edits);
    if (trial && fails_as_shown(*trial, diagnostic, trials)) diagnostic.fix.reset();
  }
}

}  // namespace armlet::lang
