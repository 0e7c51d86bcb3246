#include "armlet/cell/contacts.hpp"

#include <algorithm>
#include <limits>

#include "armlet/cell/cell.hpp"
#include "armlet/collision/contact.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "cell/arm_bodies.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kNear = 1e-5;             // m, from where on bodies touch
constexpr double kClear = 2e-5;            // m, less than this is not counted as room
constexpr std::int64_t kLook = 1'000'000;  // ns, how often it is looked whether they still do
constexpr double kSlips = 1e-3;            // m/s, from where on friction is that of sliding

// A hand without a length of its own closes around the tool point: what fits in is not pressed.
bool is_around(const Robot& arm, const Object& object, const Vector3d& approach) {
  return arm.derived<ArmSolids>().is_bare() && arm.tool().kind == ToolKind::kParallelGripper &&
         !object.fixed && grasp_width(object, approach) <= arm.tool().stroke;
}

bool is_at_flange(const Robot& arm, const Attachment& carried) {
  return carried.frame == kFlange || carried.frame == arm.n();
}

}  // namespace

// The cell at any instant since nothing but time has changed it.
struct Contacts::Scene {
  const std::vector<CellRobot>& robots;
  const World& world;

  [[nodiscard]] const CellRobot& arm(int robot) const {
    return robots[static_cast<std::size_t>(robot)];
  }

  void state(int robot, std::int64_t t_ns, Eigen::VectorXd& q, Eigen::VectorXd& qd) const {
    const CellRobot& arm = this->arm(robot);
    q = arm.q;
    qd = arm.qd;
    Eigen::VectorXd qdd = arm.qdd;
    if (arm.motion) arm.motion->sample(t_ns, q, qd, qdd);
  }

  [[nodiscard]] Isometry3d T_world_link(int robot, int frame, std::int64_t t_ns) const {
    Eigen::VectorXd q, qd;
    state(robot, t_ns, q, qd);
    const Robot& model = *arm(robot).model;
    const Isometry3d T_link = frame == 0
                                  ? model.T_world_base()
                                  : link_frame(model, q, frame == kFlange ? model.n() : frame);
    const int on = arm(robot).on;
    return on < 0 ? T_link : T_world_link(on, kFlange, t_ns) * T_link;
  }
  [[nodiscard]] Isometry3d T_world_flange(int robot, std::int64_t t_ns) const {
    return T_world_link(robot, kFlange, t_ns);
  }

  [[nodiscard]] Isometry3d T_world_obj(std::size_t index, std::int64_t t_ns) const {
    const auto& carried = world.attachment_of(index);
    if (!carried) return world.object(index).T_world_obj;
    return T_world_link(carried->carrier, carried->frame, t_ns) * carried->T_carrier_obj;
  }

  [[nodiscard]] std::vector<Feeler> feelers(int robot) const {
    std::vector<Feeler> all;
    const CellRobot& arm = this->arm(robot);
    if (arm.on >= 0) return all;  // fingers.hpp
    for (std::size_t i = 0; i < world.size(); ++i) {
      const auto& carried = world.attachment_of(i);
      if (!carried || carried->carrier != robot || !is_at_flange(*arm.model, *carried)) continue;
      Feeler feeler{.carried = world.object(i).name, .solid = solid_of(world.object(i).shape)};
      feeler.solid.T = carried->T_carrier_obj;
      all.push_back(std::move(feeler));
    }
    const ArmSolids& solids = arm.model->derived<ArmSolids>();
    const ToolKind kind = arm.model->tool().kind;
    if (solids.is_bare() || kind == ToolKind::kPoint || kind == ToolKind::kNone) {
      Feeler point;
      point.solid.T = arm.model->T_flange_tool();
      all.push_back(std::move(point));
      return all;
    }
    std::vector<ArmSolid> bodies = solids.solids();
    close_fingers(arm, world, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!is_hand(bodies[i].role)) continue;
      all.push_back({.part = static_cast<int>(i), .solid = bodies[i].solid});
    }
    return all;
  }

  // What the hand holds, and what travels with that, it does not press against.
  [[nodiscard]] bool is_own(int robot, std::size_t index) const {
    const auto& carried = world.attachment_of(index);
    const bool goes_along = carried && carried->carrier == robot &&
                            (!carried->mounted || is_at_flange(*arm(robot).model, *carried));
    return goes_along || world.object(index).name == arm(robot).held;
  }

  // Whether time alone brings the object elsewhere.
  [[nodiscard]] bool is_on_its_way(std::size_t index) const {
    const auto& carried = world.attachment_of(index);
    if (!carried) return false;
    const int on = arm(carried->carrier).on;
    return arm(carried->carrier).motion || (on >= 0 && arm(on).motion);
  }

  [[nodiscard]] bool may_press(int robot, std::size_t index, const Feeler& feeler,
                               const Vector3d& approach) const {
    return !feeler.carried.empty() || !is_around(*arm(robot).model, world.object(index), approach);
  }
};

// No point of a feeler has moved farther than the tool point has, and by turning about it.
bool Contacts::Clear::still_at(const Isometry3d& T) const {
  const double moved = (T.translation() - T_world_tool.translation()).norm();
  const double turned = (T.linear() - T_world_tool.linear()).norm();
  return moved + turned * reach < gap - kClear;
}

// Calls visit(feeler, placed feeler, index of the object, placed object) for all that are near now.
// Returns how much room there is if there are none, and the reach of the feelers.
template <class Visit>
Contacts::Clear Contacts::for_each_contact(const Scene& scene, int robot, std::int64_t now_ns,
                                           Visit&& visit) {
  Clear clear{.gap = std::numeric_limits<double>::infinity()};
  if (scene.world.size() == 0) return clear;
  const std::vector<Feeler> feelers = scene.feelers(robot);
  const Isometry3d T_world_flange = scene.T_world_flange(robot, now_ns);
  const Vector3d& p_flange_tool = scene.arm(robot).model->T_flange_tool().translation();
  const Vector3d approach =
      T_world_flange.linear() * scene.arm(robot).model->T_flange_tool().linear().col(2);
  std::vector<Solid> placed;
  for (const Feeler& each : feelers) {
    placed.push_back(each.solid);
    placed.back().T = T_world_flange * each.solid.T;
    clear.reach = std::max(
        clear.reach, (each.solid.T.translation() - p_flange_tool).norm() + each.solid.reach());
  }
  for (std::size_t i = 0; i < scene.world.size(); ++i) {
    if (scene.is_own(robot, i)) continue;
    const Vector3d& centre = scene.world.object(i).T_world_obj.translation();
    Solid solid = solid_of(scene.world.object(i).shape);
    const double reach = solid.reach();
    if (scene.is_on_its_way(i)) clear.gap = 0.0;
    for (std::size_t k = 0; k < feelers.size(); ++k) {
      const double most = reach + placed[k].reach() + kNear;
      const double middles = (placed[k].T.translation() - centre).norm();
      if (middles > most) {
        clear.gap = std::min(clear.gap, middles - most);
        continue;
      }
      solid.T = scene.T_world_obj(i, now_ns);
      const bool apart = is_farther(placed[k], solid, kNear);
      if (clear.gap > 0.0)
        clear.gap = std::min(clear.gap, apart ? gap_between(placed[k], solid).distance : 0.0);
      if (apart || !scene.may_press(robot, i, feelers[k], approach)) continue;
      visit(feelers[k], placed[k], i, solid);
    }
  }
  return clear;
}

void Contacts::settle(const std::vector<CellRobot>& robots, const World& world,
                      std::int64_t now_ns) {
  clear_.clear();
  if (now_ns == begin_ns_) return;
  const Scene scene{robots, world};
  std::vector<Touch> lasting;
  for (int robot = 0; robot < static_cast<int>(robots.size()); ++robot) {
    for_each_contact(scene, robot, now_ns,
                     [&](const Feeler& feeler, const Solid&, std::size_t index, const Solid&) {
                       lasting.push_back(first_touch(scene, robot, feeler, index, now_ns));
                       lasting.back().verified = 0;
                     });
  }
  touches_ = std::move(lasting);
  begin_ns_ = now_ns;
}

void Contacts::forget_object(std::string_view name) {
  std::erase_if(touches_,
                [&](const Touch& each) { return each.object == name || each.carried == name; });
}

void Contacts::forget_robot(int robot) {
  std::erase_if(touches_, [&](const Touch& each) { return each.robot == robot; });
}

Contacts::Touch& Contacts::first_touch(const Scene& scene, int robot, const Feeler& feeler,
                                       std::size_t index, std::int64_t now_ns) {
  const Object& object = scene.world.object(index);
  const auto place = [&](std::int64_t t_ns, Solid& a, Solid& b) {
    a = feeler.solid;
    a.T = scene.T_world_flange(robot, t_ns) * feeler.solid.T;
    b = solid_of(object.shape);
    b.T = scene.T_world_obj(index, t_ns);
  };
  const auto is_apart = [&](std::int64_t t_ns) {
    Solid a, b;
    place(t_ns, a, b);
    return is_farther(a, b, kNear);
  };
  auto known = std::ranges::find_if(touches_, [&](const Touch& each) {
    return each.robot == robot && each.part == feeler.part && each.carried == feeler.carried &&
           each.object == object.name;
  });
  const std::int64_t last = (now_ns - begin_ns_) / kLook;
  const std::int64_t from = known == touches_.end() ? 0 : known->verified;
  std::int64_t k = last;
  while (k >= from && !is_apart(begin_ns_ + k * kLook)) --k;
  std::int64_t t_ns = begin_ns_;
  if (k >= from) {
    // Apart at k, together from then on.
    std::int64_t apart = begin_ns_ + k * kLook;
    t_ns = std::min(now_ns, apart + kLook);
    while (t_ns - apart > 1) {
      const std::int64_t middle = apart + (t_ns - apart) / 2;
      (is_apart(middle) ? apart : t_ns) = middle;
    }
  } else if (known != touches_.end()) {
    known->verified = std::max(known->verified, last);
    return *known;
  }
  Solid a, b;
  place(t_ns, a, b);
  if (known == touches_.end()) {
    touches_.push_back(
        {.robot = robot, .carried = feeler.carried, .part = feeler.part, .object = object.name});
    known = touches_.end() - 1;
  }
  known->normal_obj = b.T.linear().transpose() * contact_normal(a, b);
  known->verified = std::max<std::int64_t>(last, k + 1);
  return *known;
}

Vector6d Contacts::wrench(const std::vector<CellRobot>& robots, const World& world, int robot,
                          std::int64_t now_ns) {
  const Scene scene{robots, world};
  Vector6d sum = Vector6d::Zero();
  const Isometry3d T_world_tool = forward(*scene.arm(robot).model, scene.arm(robot).q);
  clear_.resize(robots.size());
  Clear& clear = clear_[static_cast<std::size_t>(robot)];
  if (clear.still_at(T_world_tool)) return sum;
  // Of a point of what joint `frame` moves.
  const auto velocity_of = [&](int of, int frame, const Vector3d& p) -> Vector3d {
    Eigen::VectorXd q, qd;
    scene.state(of, now_ns, q, qd);
    const Robot& model = *scene.arm(of).model;
    if (frame != kFlange) qd.tail(model.n() - frame).setZero();
    Jacobian J(6, model.n());
    const Isometry3d T = forward_and_jacobian(model, q, J);
    const Vector6d twist = J * qd;
    return twist.head<3>() + twist.tail<3>().cross(p - T.translation());
  };
  const Vector3d p_tool = T_world_tool.translation();
  clear = for_each_contact(
      scene, robot, now_ns,
      [&](const Feeler& feeler, const Solid& a, std::size_t index, const Solid& b) {
        const Object& object = world.object(index);
        const Vector3d n =
            b.T.linear() * first_touch(scene, robot, feeler, index, now_ns).normal_obj;
        const double press = object.stiffness * depth_along(a, b, n);
        if (!(press > 0.0)) return;
        const Vector3d p = pressure_point(a, b, n);
        Vector3d v = velocity_of(robot, kFlange, p);
        if (const auto& carried = world.attachment_of(index))
          v -= velocity_of(carried->carrier, carried->frame, p);
        v -= v.dot(n) * n;
        double mu = object.friction;
        if (!feeler.carried.empty()) mu = std::min(mu, world.at(feeler.carried).friction);
        const Vector3d force = press * n - mu * press / std::max(v.norm(), kSlips) * v;
        sum.head<3>() += force;
        sum.tail<3>() += (p - p_tool).cross(force);
      });
  clear.T_world_tool = T_world_tool;
  return sum;
}

}  // namespace armlet
