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

constexpr double kTouching = 1e-5;  // m, distance at which bodies touch

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

// The objects that a ball around all links touches.
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

double gap_between_links(const std::vector<Solid>& links, const std::vector<Solid>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Solid& link : links) {
    for (const Solid& other : others) {
      if (least < std::numeric_limits<double>::infinity() && !may_meet(link, other, least))
        continue;
      least = std::min(least, gap_between(link, other).distance);
    }
  }
  return least;
}

// Bound on the motion of a finger, m for each rad of the bend: no point is farther from the axis of
// its first bend than both links and the tip are long, and the last link rotates by a third more.
double lever_of(const Robot& finger, int bend) {
  const double last = finger.joint(bend + 1).dh.a;
  const double tip = 0.02;  // m, at least the thickness
  return finger.joint(bend).dh.a + last + tip + (last + tip) / 3.0;
}

// The closing fingers of a hand with fingers.
class ClosingHand {
 public:
  ClosingHand(const Cell& cell, int hand, std::vector<Closing>& closings)
      : cell_(cell), palm_(hand_at(cell, hand)), closings_(closings), q_(palm_.q) {}

  void close() {
    constexpr double kALittle = 1e-3;  // rad
    const std::vector<double> before = gaps();
    VectorXd on = q_;
    for (int i = 0; i < count(); ++i) {
      if (is_moving(i)) on[i + 1] += kALittle;
    }
    std::swap(q_, on);
    const std::vector<double> after = gaps();
    std::swap(q_, on);
    comes_apart_.resize(before.size());
    for (std::size_t k = 0; k < before.size(); ++k)
      comes_apart_[k] = before[k] <= kTouching && after[k] >= before[k];
    while (go_on()) {
    }
  }

 private:
  [[nodiscard]] int count() const { return static_cast<int>(closings_.size()); }
  [[nodiscard]] Closing& closing(int i) { return closings_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] bool is_moving(int i) { return q_[i + 1] < closing(i).bend; }
  [[nodiscard]] const Robot& finger(int i) const {
    return *cell_.robot(palm_.fingers[static_cast<std::size_t>(i)]).model;
  }

  // The gap of each pair of fingers, in order.
  [[nodiscard]] std::vector<double> gaps() const {
    std::vector<std::vector<Solid>> links;
    for (int i = 0; i < count(); ++i)
      links.push_back(links_of(finger(i), finger_joints(i, q_), Isometry3d::Identity()));
    std::vector<double> all;
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (std::size_t k = i + 1; k < links.size(); ++k)
        all.push_back(gap_between_links(links[i], links[k]));
    }
    return all;
  }

  void stop(int i) {
    if (!is_moving(i)) return;
    closing(i).bend = q_[i + 1];
    closing(i).touch = std::min(closing(i).touch, q_[i + 1]);
  }

  // Moves the fingers by a step in which none can reach another one or pass its own end; false:
  // none moves.
  bool go_on() {
    const std::vector<double> gaps = this->gaps();
    for (std::size_t k = 0, i = 0; i < closings_.size(); ++i) {
      for (std::size_t j = i + 1; j < closings_.size(); ++j, ++k) {
        if (gaps[k] > kTouching || comes_apart_[k]) continue;
        stop(static_cast<int>(i));
        stop(static_cast<int>(j));
      }
    }
    double step = std::numeric_limits<double>::infinity();
    for (int i = 0; i < count(); ++i) {
      if (is_moving(i)) step = std::min(step, closing(i).bend - q_[i + 1]);
    }
    if (step == std::numeric_limits<double>::infinity()) return false;
    for (std::size_t k = 0, i = 0; i < closings_.size(); ++i) {
      for (std::size_t j = i + 1; j < closings_.size(); ++j, ++k) {
        double rate = 0.0;
        for (const int each : {static_cast<int>(i), static_cast<int>(j)}) {
          if (is_moving(each)) rate += lever_of(finger(each), bend_joint(each));
        }
        if (rate > 0.0 && gaps[k] > kTouching) step = std::min(step, gaps[k] / rate);
      }
    }
    for (int i = 0; i < count(); ++i) {
      if (is_moving(i)) q_[i + 1] = std::min(closing(i).bend, q_[i + 1] + step);
    }
    return true;
  }

  const Cell& cell_;
  const CellRobot& palm_;
  std::vector<Closing>& closings_;
  VectorXd q_;
  std::vector<bool> comes_apart_;  // of each pair: they touch at the start, and separate soon
};

// The smallest gap between some links and the objects.
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
  // Forces of the palm on what is mounted on it are left out.
  std::erase_if(contacts, [&](const FingerContact& each) {
    const auto& carried = cell.world().attachment(each.object);
    return carried && carried->carrier == palm.on && carried->mounted;
  });
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

Vector6d finger_wrench(const Cell& cell, int robot, FeltBy by) {
  const CellRobot& part = cell.robot(robot);
  const int hand = part.hand < 0 ? robot : part.hand;
  const Vector3d p_tool = cell.T_world_tool(robot).translation();
  const std::string& held = cell.robot(part.on).held;
  const auto goes_along = [&](const std::string& object) {
    const auto& carried = cell.world().attachment(object);
    return object == held || (carried && carried->carrier == part.on);
  };
  Vector6d sum = Vector6d::Zero();
  for (const FingerContact& each : finger_contacts(cell, hand)) {
    if (by == FeltBy::kArm && goes_along(each.object)) continue;
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
  const int bend = bend_joint(index);
  const double lever = lever_of(*robot.model, bend);
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
  // Beyond the first contact: steps that double, then bisection.
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

std::vector<Closing> close_hand(const Cell& cell, int hand, double force) {
  std::vector<Closing> closings;
  for (const int finger : hand_at(cell, hand).fingers)
    closings.push_back(close_finger(cell, finger, force));
  ClosingHand(cell, hand, closings).close();
  return closings;
}

}  // namespace armlet
