#pragma once

#include "armlet/backend/backend.hpp"

namespace armlet {

// Several backends as one; each hears everything, in the order given.
class FanOut : public Backend {
 public:
  // backends  not owned; they live at least as long as this.
  // throws    ArgumentError if one of them is null.
  explicit FanOut(std::vector<Backend*> backends);

  void begin(const RunInfo& run) override;
  void robot_added(std::int64_t t_ns, const RobotInfo& robot) override;
  void joint_sample(const JointSample& sample) override;
  void object_added(std::int64_t t_ns, const ObjectInfo& object) override;
  void object_sample(const ObjectSample& sample) override;
  void object_event(const ObjectEvent& event) override;
  void note(const Note& note) override;
  void figure(std::int64_t t_ns, const Figure& figure) override;
  void end(std::int64_t t_ns) override;

  // The error of the first backend that has one.
  [[nodiscard]] std::string error() const override;

 private:
  std::vector<Backend*> backends_;
};

}  // namespace armlet
