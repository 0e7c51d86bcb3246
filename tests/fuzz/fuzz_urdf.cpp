// Robot descriptions: any text gives a mechanism that can be written and read again, or a reason.

#include "armlet/model/urdf.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

constexpr double kMostTurn = 1e-9;  // angles of about a right angle count as right

void demand_reason(const Error& error) {
  fuzz::demand(!error.message.empty(), "what is refused has a reason");
}

// The URDF of a mechanism; empty if URDF cannot say what it is.
std::string written(const Mechanism& mechanism) {
  try {
    return write_urdf(mechanism);
  } catch (const ArgumentError&) {
    return {};
  }
}

void demand_same(const Mechanism& a, const Mechanism& b) {
  fuzz::demand(a.joint_count() == b.joint_count() && a.actuator_count() == b.actuator_count(),
               "a mechanism keeps its joints");
  for (std::size_t j = 0; j < a.moving().size(); ++j) {
    const Body& one = a.bodies()[static_cast<std::size_t>(a.moving()[j])];
    const Body& other = b.bodies()[static_cast<std::size_t>(b.moving()[j])];
    fuzz::demand(one.joint_name == other.joint_name && one.joint == other.joint,
                 "joints keep their names and kinds");
    const auto& T = one.T_parent_joint;
    fuzz::demand(T.translation() == other.T_parent_joint.translation(),
                 "lengths read back to the same bits");
    fuzz::demand((T.linear() - other.T_parent_joint.linear()).norm() < kMostTurn,
                 "rotations read back to the last digits");
    fuzz::demand(one.link.mass == other.link.mass && one.link.inertia == other.link.inertia,
                 "masses read back to the same bits");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  const auto scene = read_urdf_scene(text);
  if (!scene.ok()) demand_reason(scene.error());
  const auto mechanism = read_urdf(text);
  if (!mechanism.ok()) {
    demand_reason(mechanism.error());
    return 0;
  }
  const std::string once = written(*mechanism);
  if (once.empty()) return 0;
  const auto again = read_urdf(once);
  fuzz::demand(again.ok(), "what was written can be read");
  demand_same(*mechanism, *again);
  return 0;
}
