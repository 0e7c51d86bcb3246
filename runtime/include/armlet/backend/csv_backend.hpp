#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// Writes a run as one table, numbers with 9 significant digits.
//
//   t,what,name,x,y,z,qw,qx,qy,qz,q1,..,qn,qd1,..,qdn,qdd1,..,qddn,text
//
// t is in seconds with all nanoseconds, `what` is robot, object, attached, detached, removed,
// output, message, advice or end. A robot's pose is that of its tool point, in the world. n is the
// largest number of joints at the beginning; a robot that joins later with more is an error and
// left out. Cells that do not apply are empty.
class CsvBackend : public Backend {
 public:
  // out  not owned; lives at least as long as this.
  explicit CsvBackend(std::ostream& out);
  ~CsvBackend() override;

  void begin(const RunInfo& run) override;
  void robot_added(std::int64_t t_ns, const RobotInfo& robot) override;
  void joint_sample(const JointSample& sample) override;
  void object_added(std::int64_t t_ns, const ObjectInfo& object) override;
  void object_sample(const ObjectSample& sample) override;
  void object_event(const ObjectEvent& event) override;
  void note(const Note& note) override;
  void end(std::int64_t t_ns) override;
  [[nodiscard]] std::string error() const override;

 private:
  class Table;
  std::unique_ptr<Table> table_;
};

}  // namespace armlet
