#pragma once

#include <iosfwd>
#include <memory>

#include "armlet/backend/backend.hpp"

namespace armlet {

// Writes a run as one JSON object per line; numbers read back to the same bits.
//
//   {"what":"begin","robots":[{"name":"arm","joints":["rad","m"]}]}
//   {"t":0.000000000,"what":"added","name":"cube","shape":"box","size":[...],"mass":0.2,
//    "color":"red","p":[x,y,z],"r":[w,x,y,z]}
//   {"t":0.010000000,"what":"robot","name":"arm","q":[...],"qd":[...],"qdd":[...],"p":..,"r":..}
//   {"t":..,"what":"object","name":"cube","p":..,"r":..}
//   {"t":..,"what":"attached","name":"cube","robot":"arm"}          (also detached, removed)
//   {"t":..,"what":"output","text":"..."}                           (also message, advice)
//   {"t":..,"what":"figure","title":"...","x":"s","y":"rad","z":"","right":"","series":
//    [{"kind":"line","label":"...","axis":"left","x":[...],"y":[...],"z":[]}]}    (units of SI;
//    null: no number; with logarithmic axes "log":"y", with names below bars "names":["a","b"], in
//    panels "panels":[{"title":"...","x":..., "series":[...]}])
//   {"t":..,"what":"robotAdded","name":"late","joints":["rad"]}
//   {"t":..,"what":"end"}
//
// A robot's p and r are those of its tool point in the world; r is a unit quaternion.
class JsonlBackend : public Backend {
 public:
  // out  not owned; lives at least as long as this.
  explicit JsonlBackend(std::ostream& out);
  ~JsonlBackend() override;

  void begin(const RunInfo& run) override;
  void robot_added(std::int64_t t_ns, const RobotInfo& robot) override;
  void joint_sample(const JointSample& sample) override;
  void object_added(std::int64_t t_ns, const ObjectInfo& object) override;
  void object_sample(const ObjectSample& sample) override;
  void object_event(const ObjectEvent& event) override;
  void note(const Note& note) override;
  void figure(std::int64_t t_ns, const Figure& figure) override;
  void end(std::int64_t t_ns) override;
  [[nodiscard]] std::string error() const override;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace armlet
