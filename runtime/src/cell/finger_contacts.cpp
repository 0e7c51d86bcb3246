#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/cell/fingers.hpp"
#include "armlet/collision/contact.hpp"
#include "armlet/core/error.hpp"
#include "armlet/kinematics/forward.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kTouching = 1e-5;  // m, from where on bodies touch

const CellRobot& hand_at(const Cell& cell, int hand) {
  const CellRobot& robot = cell.robot(hand);
  if (robot.fingers.empty()) throw ArgumentError("\"" + robot.name + "\" is no hand with fingers.");
  return robot;
}

// The links of a finger, or the palm, in the world.
std::vector<Solid> links_of(const Robot& model, const VectorXd& q, const Isometry3d& T_world_on) {
  const std::vector<Isometry3d> frames = link_frames(model, q);
  std::vector<Solid> links;
  for (const ArmSolid& each : model.derived<ArmSolids>().solids()) {
    Solid solid = each.solid;
    solid.T = T_world_on *
              (each.frame == 0 ? model.T_world_base()
                               : frames[static_cast<std::size_t>(each.frame - 1)]) *
              each.solid.T;
    links.push_back(std::move(solid));
  }
  return links;
}

Solid solid_at(const Object& object) {
  Solid solid = solid_of(object.shape);
  solid.T = object.T_world_obj;
  return solid;
}

bool may_meet(const Solid& a, const Solid& b, double within) {
  return (a.T.translation() - b.T.translation()).norm() <= a.reach() + b.reach() + within;
}

// Those that a ball around all links comes to.
std::vector<std::size_t> objects_near(const World& world, const std::vector<Solid>& links) {
  std::vector<std::size_t> near;
  if (links.empty()) return near;
  const Vector3d middle = links.front().T.translation();
  double reach = kTouching;
  for (const Solid& each : links)
    reach = std::max(reach, (each.T.translation() - middle).norm() + each.reach() + kTouching);
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    const double most = reach + solid_of(object.shape).reach();
    if ((object.T_world_obj.translation() - middle).squaredNorm() <= most * most) near.push_back(i);
  }
  return near;
}

void look(const Cell& cell, int finger, const std::vector<Solid>& links,
          std::vector<FingerContact>& found) {
  const std::vector<std::size_t> near = objects_near(cell.world(), links);
  for (const Solid& link : links) {
    for (const std::size_t i : near) {
      const Object& object = cell.world().object(i);
      const Solid body = solid_at(object);
      if (!may_meet(link, body, kTouching) || is_farther(link, body, kTouching)) continue;
      const Gap gap = gap_between(link, body);
      found.push_back({.finger = finger,
                       .object = object.name,
                       .p = pressure_point(link, body, gap.away),
                       .inward = -gap.away,
                       .force = object.stiffness * std::max(0.0, -gap.distance),
                       .friction = object.friction});
    }
  }
}

double force_of(const Cell& cell, const std::vector<Solid>& links) {
  std::vector<FingerContact> contacts;
  look(cell, 0, links, contacts);
  double sum = 0.0;
  for (const FingerContact& each : contacts) sum += each.force;
  return sum;
}

// The smallest gap to anything.
double gap_to_world(const Cell& cell, const std::vector<Solid>& links) {
  double least = std::numeric_limits<double>::infinity();
  for (const Solid& link : links) {
    for (std::size_t i = 0; i < cell.world().size(); ++i) {
      const Solid body = solid_at(cell.world().object(i));
      if (least < std::numeric_limits<double>::infinity() && !may_meet(link, body, least)) continue;
      least = std::min(least, gap_between(link, body).distance);
    }
  }
  return least;
}

}  // namespace

std::vector<FingerContact> finger_contacts(const Cell& cell, int hand, const VectorXd& q) {
  const CellRobot& palm = hand_at(cell, hand);
  const Isometry3d T_world_on = cell.T_world_flange(palm.on);
  std::vector<FingerContact> contacts;
  look(cell, -1, links_of(*palm.model, q, T_world_on), contacts);
  for (int i = 0; i < static_cast<int>(palm.fingers.size()); ++i) {
    const Robot& finger = *cell.robot(palm.fingers[static_cast<std::size_t>(i)]).model;
    look(cell, i, links_of(finger, finger_joints(i, q), T_world_on), contacts);
  }
  return contacts;
}

std::vector<FingerContact> finger_contacts(const Cell& cell, int hand) {
  return finger_contacts(cell, hand, hand_at(cell, hand).q);
}

double finger_force(const Cell& cell, int finger) {
  const CellRobot& robot = cell.robot(finger);
  if (robot.hand < 0) throw ArgumentError("\"" + robot.name + "\" is no finger.");
  return force_of(cell, links_of(*robot.model, robot.q, cell.T_world_flange(robot.on)));
}

Vector6d finger_wrench(const Cell& cell, int robot, std::string_view without) {
  const CellRobot& part = cell.robot(robot);
  const int hand = part.hand < 0 ? robot : part.hand;
  const Vector3d p_tool = cell.T_world_tool(robot).translation();
  Vector6d sum = Vector6d::Zero();
  for (const FingerContact& each : finger_contacts(cell, hand)) {
    if (each.object == without) continue;
    if (part.hand >= 0 &&
        (each.finger < 0 ||
         hand_at(cell, hand).fingers[static_cast<std::size_t>(each.finger)] != robot))
      continue;
    const Vector3d force = -each.force * each.inward;
    sum.head<3>() += force;
    sum.tail<3>() += (each.p - p_tool).cross(force);
  }
  return sum;
}

Closing close_finger(const Cell& cell, int finger, double force) {
  const CellRobot& robot = cell.robot(finger);
  const CellRobot& palm = hand_at(cell, robot.hand);
  const auto index =
      static_cast<int>(std::ranges::find(palm.fingers, finger) - palm.fingers.begin());
  const Isometry3d T_world_on = cell.T_world_flange(robot.on);
  VectorXd q = palm.q;
  const auto links_at = [&](double bend) {
    q[index + 1] = bend;
    return links_of(*robot.model, finger_joints(index, q), T_world_on);
  };
  const double end = palm.model->upper()[index + 1];
  // No point of the finger is farther from its first axis than both links and the tip are long, and
  // the last link turns a third more.
  const int bend = bend_joint(index);
  const double last = robot.model->joint(bend + 1).dh.a;
  const double tip = 0.02;  // m, at least the thickness
  const double lever = robot.model->joint(bend).dh.a + last + tip + (last + tip) / 3.0;
  constexpr double kTouches = 1e-7;  // m
  double at = robot.q[bend];
  double gap = gap_to_world(cell, links_at(at));
  while (gap > kTouches && at < end) {
    at = std::min(end, at + gap / lever);
    gap = gap_to_world(cell, links_at(at));
  }
  const double touch = at;
  if (gap > kTouches) return {.bend = end, .touch = end};
  if (force_of(cell, links_at(touch)) >= force) return {.bend = touch, .touch = touch};
  // Pressing deeper: steps that double, and then halves.
  double below = touch, step = 1e-5, above = touch;
  do {
    below = above;
    above = std::min(end, above + step);
    step *= 2.0;
  } while (above < end && force_of(cell, links_at(above)) < force);
  if (force_of(cell, links_at(above)) < force) return {.bend = end, .touch = touch};
  for (int i = 0; i < 60 && above - below > 1e-15; ++i) {
    const double middle = 0.5 * (below + above);
    (force_of(cell, links_at(middle)) < force ? below : above) = middle;
  }
  return {.bend = above, .touch = touch};
}

}  // namespace armlet
