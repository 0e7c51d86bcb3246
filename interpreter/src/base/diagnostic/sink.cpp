#include <algorithm>
#include <utility>

#include "armlet/interpreter/diagnostic.hpp"

namespace armlet {

bool DiagnosticSink::report(Diagnostic diagnostic) {
  const bool is_full = static_cast<int>(all_.size()) >= limit_;
  const bool is_error = diagnostic.severity == Severity::kError;
  if (is_error && statement_failed_) return false;
  if (is_error) statement_failed_ = true;
  if (is_error ? full() : is_full) return false;
  // A function without parameter types is checked once for each use; its mistakes are reported
  // once.
  const bool known = std::ranges::any_of(all_, [&](const Diagnostic& other) {
    return other.code == diagnostic.code && other.mark.span == diagnostic.mark.span;
  });
  if (known) return false;

  if (is_full) {
    // If there are too many messages, an error replaces advice.
    const auto advice = std::ranges::find(all_, Severity::kAdvice, &Diagnostic::severity);
    if (!is_error || advice == all_.end()) return false;
    all_.erase(advice);
  }
  if (is_error) ++errors_;
  all_.push_back(std::move(diagnostic));
  return true;
}

std::vector<Diagnostic> DiagnosticSink::take_sorted() {
  std::ranges::stable_sort(all_, [](const Diagnostic& a, const Diagnostic& b) {
    const Span& x = a.mark.span;
    const Span& y = b.mark.span;
    return x.source != y.source ? x.source < y.source : x.begin < y.begin;
  });
  errors_ = 0;
  statement_failed_ = false;
  return std::exchange(all_, {});
}

}  // namespace armlet
