#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "armlet/backend/run_hash.hpp"

namespace armlet {

// The hash of all events up to a virtual time, which is that of an event.
struct RunMark {
  std::int64_t t_ns = 0;
  std::uint64_t hash = 0;
  bool operator==(const RunMark&) const = default;
};

// The hash of a run at many instants, from which the time is found at which two runs begin to
// differ: a mark for each 10 ms with an event, or for longer intervals when there would be more
// than kMost marks. The positions of marks depend on the events alone.
class RunMarks : public RunHash {
 public:
  static constexpr std::size_t kMost = 4096;

  void on(const Event& event) override;

  // The marks, including one at the last event.
  [[nodiscard]] std::vector<RunMark> marks() const;

 private:
  void thin();

  std::vector<RunMark> marks_;
  RunMark last_{};
  bool has_last_ = false;
  std::int64_t stretch_ns_ = 10'000'000;
};

// Where two runs begin to differ: they are equal up to `same_ns`, and differ at `differ_ns`, or one
// of them has ended there.
struct RunParting {
  std::int64_t same_ns = 0;
  std::int64_t differ_ns = 0;
};
// The first difference of two runs; nothing: they are equal.
[[nodiscard]] std::optional<RunParting> where_runs_part(std::span<const RunMark> one,
                                                        std::span<const RunMark> other);

}  // namespace armlet
