#include "check/explain/pauses.hpp"

#include <string>

namespace armlet::lang {

bool is_sample(const hir::Function& function) { return function.name.starts_with(kSampleName); }

void report_pause(Checker& checker, const hir::Function& condition, Span span) {
  const std::string takes_time = what_takes_time(checker.registry);
  Diagnostic diagnostic = make_diagnostic("E0505", span, {takes_time});
  if (is_sample(condition)) diagnostic.message = "what `record` samples cannot " + takes_time;
  checker.report(std::move(diagnostic));
}

}  // namespace armlet::lang
