#pragma once
// The columns of a table of joint values: as many as the largest number of joints of a robot at the
// beginning.

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "armlet/backend/backend.hpp"

namespace armlet {

class JointColumns {
 public:
  void begin(const RunInfo& run) {
    for (const RobotInfo& robot : run.robots) {
      for (std::size_t i = 0; i < robot.joints.size(); ++i) {
        const JointUnit unit = robot.joints[i].unit;
        if (i == units_.size()) units_.emplace_back(unit);
        if (units_[i] != unit) units_[i].reset();
      }
    }
  }

  // Adds a robot during the run; one with too many joints is an error, and left out.
  void add(const RobotInfo& robot) {
    if (robot.joints.size() <= count() || !error_.empty()) return;
    error_ = fmt::format(
        "The table was begun for robots of {} joints; \"{}\" has {}. Declare it before the first "
        "motion.",
        count(), robot.name, robot.joints.size());
  }

  [[nodiscard]] bool hold(const JointSample& sample) const { return sample.q.size() <= count(); }
  [[nodiscard]] std::size_t count() const { return units_.size(); }
  // Unit of the values in column `i`; nothing if the robots at the beginning differ.
  [[nodiscard]] std::optional<JointUnit> unit(std::size_t i) const { return units_[i]; }
  // Empty, or a sentence about the first robot that does not fit.
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::vector<std::optional<JointUnit>> units_;
  std::string error_;
};

}  // namespace armlet
