#include "armlet/backend/run_marks.hpp"

#include <algorithm>

namespace armlet {

void RunMarks::on(const Event& event) {
  if (kind_of(event) == EventKind::kUndone) return;
  const std::int64_t t_ns = time_of(event);
  if (has_last_ && t_ns / stretch_ns_ > last_.t_ns / stretch_ns_) {
    marks_.push_back(last_);
    if (marks_.size() == kMost) thin();
  }
  RunHash::on(event);
  last_ = {t_ns, value()};
  has_last_ = true;
}

// Keeps the last mark of every interval of twice the length.
void RunMarks::thin() {
  stretch_ns_ *= 2;
  std::vector<RunMark> kept;
  for (const RunMark& mark : marks_) {
    if (!kept.empty() && kept.back().t_ns / stretch_ns_ == mark.t_ns / stretch_ns_) {
      kept.back() = mark;
    } else {
      kept.push_back(mark);
    }
  }
  marks_ = std::move(kept);
}

std::vector<RunMark> RunMarks::marks() const {
  std::vector<RunMark> all = marks_;
  if (has_last_) all.push_back(last_);
  return all;
}

std::optional<RunParting> where_runs_part(std::span<const RunMark> one,
                                          std::span<const RunMark> other) {
  if (std::ranges::equal(one, other)) return std::nullopt;
  std::int64_t same_ns = 0;
  std::size_t j = 0;
  for (const RunMark& mark : one) {
    // Skips marks of the shorter run that the longer one has removed.
    while (j < other.size() && other[j].t_ns < mark.t_ns) ++j;
    if (j == other.size()) return RunParting{same_ns, mark.t_ns};
    if (other[j].t_ns > mark.t_ns) continue;
    if (other[j].hash != mark.hash) return RunParting{same_ns, mark.t_ns};
    same_ns = mark.t_ns;
  }
  return RunParting{same_ns, other.empty() ? same_ns : other.back().t_ns};
}

}  // namespace armlet
