#include "cell/carried_load.hpp"

namespace armlet {

Payload carried_load(const World& world, int carrier) {
  Payload load;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const auto& attachment = world.attachment_of(i);
    if (!attachment || attachment->carrier != carrier) continue;
    const Object& object = world.object(i);
    const Eigen::Matrix3d R = attachment->T_carrier_obj.linear();
    load = together(load, {.mass = object.mass,
                           .com = attachment->T_carrier_obj.translation(),
                           .inertia = R * inertia(object) * R.transpose()});
  }
  return load;
}

}  // namespace armlet
