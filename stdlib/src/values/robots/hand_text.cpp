#include "values/robots/hand_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armlet/core/format.hpp"
#include "armlet/model/hands.hpp"

namespace armlet::bind {
namespace {

struct HandLine {
  std::string joint, from, to, drives;
};

// The joints that an actuator drives: "finger1_bend, finger1_curl 0.3333 times as far".
std::string driven_by(const Mechanism& hand, int actuator) {
  std::string text;
  for (int joint = 0; joint < hand.joint_count(); ++joint) {
    const double share = hand.spec().coupling(joint, actuator);
    if (share == 0.0) continue;
    const int body = hand.moving()[static_cast<std::size_t>(joint)];
    text += fmt::format("{}{}", text.empty() ? "" : ", ",
                        hand.bodies()[static_cast<std::size_t>(body)].joint_name);
    if (share != 1.0) text += fmt::format(" {} times as far", format_number(share, 4));
  }
  return text;
}

}  // namespace

std::string hand_table(const Robot& palm, std::string_view name) {
  const Mechanism hand = make_barrett_hand();
  std::vector<HandLine> lines = {{"joint", "from", "to", "drives"}};
  for (int i = 0; i < palm.n(); ++i) {
    const Joint& joint = palm.joint(i);
    lines.push_back(
        {fmt::format("{} {}", i + 1, hand.actuators()[static_cast<std::size_t>(i)].name),
         format_joint_value(joint.kind, joint.lower), format_joint_value(joint.kind, joint.upper),
         driven_by(hand, i)});
  }
  const auto width = [&](std::string HandLine::*column) {
    std::size_t most = 0;
    for (const HandLine& line : lines) most = std::max(most, (line.*column).size());
    return most;
  };
  const std::size_t joint = width(&HandLine::joint), from = width(&HandLine::from),
                    to = width(&HandLine::to);
  std::string text = fmt::format("robot {}\nhand with {} fingers: {} joints drive {}", name,
                                 hand.tips().size(), palm.n(), hand.joint_count());
  for (const HandLine& line : lines) {
    text += fmt::format("\n{:<{}}  {:>{}}  {:>{}}  {}", line.joint, joint, line.from, from, line.to,
                        to, line.drives);
  }
  return text;
}

}  // namespace armlet::bind
