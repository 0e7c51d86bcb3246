#pragma once
// The columns of a table of joint values: as many as the widest robot at the beginning has joints.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "armlet/backend/backend.hpp"

namespace armlet {

class JointColumns {
 public:
  void begin(const RunInfo& run) {
    for (const RobotInfo& robot : run.robots) count_ = std::max(count_, robot.joints.size());
  }

  // A robot that joins later; one that has too many joints is an error, and left out.
  void add(const RobotInfo& robot) {
    if (robot.joints.size() <= count_ || !error_.empty()) return;
    error_ = fmt::format(
        "The table was begun for robots of {} joints; \"{}\" has {}. Declare it before the first "
        "motion.",
        count_, robot.name, robot.joints.size());
  }

  [[nodiscard]] bool hold(const JointSample& sample) const { return sample.q.size() <= count_; }
  [[nodiscard]] std::size_t count() const { return count_; }
  // Empty, or a sentence about the first robot that does not fit.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::size_t count_ = 0;
  std::string error_;
};

}  // namespace armlet
