#include "armlet/cell/contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "armlet/cell/cell.hpp"
#include "armlet/collision/contact.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/model/joint_coupling.hpp"
#include "cell/arm_bodies.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kNear = 1e-5;     // m, distance at which bodies touch
constexpr double kClear = 2e-5;    // m, a smaller distance counts as zero
constexpr double kWorthIt = 0.2;   // of the distance: when less is left it is measured again
constexpr double kFarOff = 0.25;   // m, larger distances are only estimated
constexpr double kFarthest = 1e5;  // m, larger than all positions
constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kLook = 1'000'000;  // ns, period at which contacts are checked
constexpr double kSlips = 1e-3;            // m/s, speed above which friction is sliding friction

// A gripper without a length of its own closes around the tool point: an object that fits into it
// is not pressed.
bool is_around(const Robot& arm, const Object& object, const Vector3d& across) {
  return arm.derived<ArmSolids>().is_bare() && arm.tool().kind == ToolKind::kParallelGripper &&
         !object.fixed && grasp_width(object, across) <= arm.tool().stroke;
}

// Derivatives of a polynomial piece are bounded by their Bernstein coefficients.
double bound_of(const Segment& piece, int order) {
  std::array<double, Segment::kMaxDegree + 1> b{};
  const int m = std::max(piece.degree - order, 0);
  double scale = 1.0, binomial = 1.0;  // duration^k, m over k
  for (int k = 0; k <= m; ++k) {
    const auto at = static_cast<std::size_t>(k + order);
    if (k + order <= piece.degree)
      b[static_cast<std::size_t>(k)] =
          (order == 1 ? k + 1.0 : 1.0) * piece.c[at] * scale / binomial;
    scale *= piece.duration;
    binomial = binomial * (m - k) / (k + 1);
  }
  for (int round = 1; round <= m; ++round) {
    for (int k = m; k >= round; --k)
      b[static_cast<std::size_t>(k)] += b[static_cast<std::size_t>(k - 1)];
  }
  double most = 0.0;
  for (int k = 0; k <= m; ++k) most = std::max(most, std::abs(b[static_cast<std::size_t>(k)]));
  return most;
}

// The largest |q|, or |dq/dt|, of a joint: exact for a few pieces, a bound for many short ones.
double largest(const Trajectory& motion, int joint, int order) {
  constexpr std::size_t kFew = 6;
  const JointPath& path = motion.joint(joint);
  if (path.segments.size() <= kFew) {
    if (order == 1) return motion.peak(joint, 1);
    const Trajectory::Range range = motion.range(joint);
    return std::max(std::abs(range.lower), std::abs(range.upper));
  }
  double most = order == 0 ? std::abs(path.q_end) : 0.0;
  for (const Segment& each : path.segments) most = std::max(most, bound_of(each, order));
  return most;
}

// Upper bounds on the speed of points that a motion moves: the speed of joint i, and the distance
// of the origin of frame `frame` from its axis.
class MotionSpeeds {
 public:
  explicit MotionSpeeds(const CellRobot& arm) : arm_(*arm.model) {
    if (!arm.motion) return;
    const Trajectory& motion = arm.motion->trajectory();
    for (int i = 0; i < arm_.rows(); ++i) {
      const DhRow& row = arm_.row(i).dh;
      const auto [joint, ratio] = motion_of_row(arm_, i);
      double d = std::abs(row.d);
      if (!arm_.row(i).is_revolute()) {
        d += std::abs(ratio) * largest(motion, joint, 0) + std::abs(arm_.row(i).drive.offset);
      }
      peaks_.push_back(std::abs(ratio) * largest(motion, joint, 1));
      lengths_.push_back(std::sqrt(row.a * row.a + d * d));
    }
  }

  // For points up to `off` from the origin of the frame.
  [[nodiscard]] double speed(int frame, double off) const {
    if (peaks_.empty()) return 0.0;
    const bool standard = arm_.spec().convention == DhConvention::kStandard;
    double sum = 0.0, behind = off;
    for (int i = frame - 1; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      if (!arm_.row(i).is_revolute()) {
        sum += peaks_[k];
      } else {
        // The constants of a standard row come after its joint; d is along the axis.
        sum += peaks_[k] * (behind + (standard ? std::abs(arm_.row(i).dh.a) : 0.0));
      }
      behind += lengths_[k];
    }
    return sum;
  }

 private:
  const Robot& arm_;
  std::vector<double> peaks_, lengths_;
};

std::vector<Isometry3d> frames_at(const Robot& model, const Eigen::VectorXd& q) {
  std::vector<Isometry3d> frames(static_cast<std::size_t>(model.rows()) + 1);
  frames[0] = model.T_world_base();
  (void)link_frames(model, q, std::span(frames).subspan(1));
  return frames;
}

bool is_at_flange(const Robot& arm, const Attachment& carried) {
  return carried.frame == kFlange || carried.frame == arm.rows();
}

}  // namespace

// The state of the cell at an instant after which only time has changed it.
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
                                  : link_frame(model, q, frame == kFlange ? model.rows() : frame);
    const int on = arm(robot).on;
    return on < 0 ? T_link : T_world_link(on, kFlange, t_ns) * T_link;
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
    const int n = arm.model->rows();
    for (const std::size_t i : world.carried()) {
      const auto& carried = world.attachment_of(i);
      if (carried->carrier != robot || carried->frame == 0) continue;
      const bool at_flange = is_at_flange(*arm.model, *carried);
      Feeler feeler{.carried = world.object(i).name,
                    .frame = at_flange ? n : carried->frame,
                    .of_hand = at_flange,
                    .solid = solid_of(world.object(i).shape)};
      feeler.solid.T = carried->T_carrier_obj;
      all.push_back(std::move(feeler));
    }
    const ArmSolids& solids = arm.model->derived<ArmSolids>();
    const ToolKind kind = arm.model->tool().kind;
    const bool is_point = solids.is_bare() || kind == ToolKind::kPoint || kind == ToolKind::kNone;
    if (is_point) {
      Feeler point{.frame = n};
      point.solid.T = arm.model->T_flange_tool();
      all.push_back(std::move(point));
    }
    std::vector<ArmSolid> bodies = solids.solids();
    close_fingers(arm, world, bodies);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const ArmSolid& body = bodies[i];
      const bool of_hand = is_hand(body.role);
      // On the rod of an arm without a gripper and the thin rod to a tool point, forces are
      // measured at the tool point.
      const bool is_stick = solids.is_bare() && body.frame > solids.neighbour_of_last();
      if (body.still || is_stick || (of_hand && is_point)) continue;
      all.push_back({.part = static_cast<int>(i),
                     .frame = body.frame,
                     .of_hand = of_hand,
                     .solid = body.solid});
    }
    const MotionSpeeds speeds(arm);
    for (Feeler& each : all)
      each.speed = speeds.speed(each.frame, each.solid.T.translation().norm() + each.solid.reach());
    return all;
  }

  // The held object, and what moves with it, exert no contact force on the gripper; on links,
  // nothing that moves with the robot does.
  [[nodiscard]] bool is_own(int robot, const Feeler& feeler, std::size_t index) const {
    const auto& carried = world.attachment_of(index);
    const bool goes_along =
        carried && carried->carrier == robot &&
        (!carried->mounted || !feeler.of_hand || is_at_flange(*arm(robot).model, *carried));
    return goes_along || world.object(index).name == arm(robot).held;
  }

  // Whether the object moves without a further command.
  [[nodiscard]] bool is_on_its_way(std::size_t index) const {
    const auto& carried = world.attachment_of(index);
    if (!carried) return false;
    const int on = arm(carried->carrier).on;
    return arm(carried->carrier).motion || (on >= 0 && arm(on).motion);
  }

  // The objects that reach into a ball, and all that are carried.
  [[nodiscard]] std::vector<std::size_t> around(const Vector3d& middle, double radius) const {
    std::vector<std::size_t> near = world.near(middle, radius);
    const std::vector<std::size_t> carried = world.carried();
    if (carried.empty()) return near;
    std::vector<std::size_t> all;
    std::set_union(near.begin(), near.end(), carried.begin(), carried.end(),
                   std::back_inserter(all));
    return all;
  }

  [[nodiscard]] bool may_press(int robot, std::size_t index, const Feeler& feeler,
                               const Vector3d& across) const {
    return !feeler.carried.empty() || !feeler.of_hand ||
           !is_around(*arm(robot).model, world.object(index), across);
  }
};

Contacts::Seen& Contacts::seen(const Scene& scene, int robot) {
  seen_.resize(scene.robots.size());
  Seen& known = seen_[static_cast<std::size_t>(robot)];
  if (known.is_known) return known;
  known = {.is_known = true, .feelers = scene.feelers(robot)};
  known.rooms.resize(known.feelers.size());
  return known;
}

std::int64_t Contacts::clear_until(int robot) const {
  const auto index = static_cast<std::size_t>(robot);
  return index < seen_.size() ? seen_[index].all.until_ns : 0;
}

// Calls visit(feeler, placed feeler, index of the object, placed object) for all pairs that are
// near now, and computes until when there are none.
template <class Visit>
void Contacts::for_each_contact(const Scene& scene, int robot, std::int64_t now_ns, Visit&& visit) {
  Seen& known = seen(scene, robot);
  if (known.all.at(now_ns)) return;
  known.all = {.from_ns = now_ns, .until_ns = kForever};
  Eigen::VectorXd q, qd;
  scene.state(robot, now_ns, q, qd);
  const Robot& model = *scene.arm(robot).model;
  const std::vector<Isometry3d> frames = frames_at(model, q);
  const Vector3d across = frames.back().linear() * model.T_flange_tool().linear().col(0);
  for (std::size_t k = 0; k < known.feelers.size(); ++k) {
    const Feeler& feeler = known.feelers[k];
    Room& known_room = known.rooms[k];
    Free& free = known_room.free;
    if (!free.at(now_ns)) {
      Solid body = feeler.solid;
      body.T = frames[static_cast<std::size_t>(feeler.frame)] * feeler.solid.T;
      // The distance that was measured last, minus the motion since then; if that is too small, a
      // new measurement.
      const double moved =
          (body.T.translation() - known_room.T_world_feeler.translation()).norm() +
          (body.T.linear() - known_room.T_world_feeler.linear()).norm() * body.reach();
      double room = known_room.room - moved;
      if (now_ns < free.from_ns || room < kWorthIt * known_room.room) {
        room = look_around(scene, robot, feeler, body, across, now_ns, visit) - kClear;
        known_room.room = room;
        known_room.T_world_feeler = body.T;
      }
      constexpr double kLongest = 1e6;  // s
      const double seconds = feeler.speed > 0.0 ? room / feeler.speed : kLongest;
      free = {.from_ns = now_ns, .until_ns = now_ns};
      if (room > 0.0) free.until_ns += static_cast<std::int64_t>(1e9 * std::min(seconds, kLongest));
    }
    known.all.until_ns = std::min(known.all.until_ns, free.until_ns);
  }
}

// Visits the contacts of one feeler. Returns the clearance around it, m: its smallest gap, or a
// lower bound.
template <class Visit>
double Contacts::look_around(const Scene& scene, int robot, const Feeler& feeler, const Solid& body,
                             const Vector3d& across, std::int64_t now_ns, Visit&& visit) {
  double room = std::numeric_limits<double>::infinity();
  const double reach = body.reach() + kNear;
  for (std::size_t i = reaches_.size(); i < scene.world.size(); ++i)
    reaches_.push_back(solid_of(scene.world.object(i).shape).reach());
  const auto room_of_balls = [&](std::size_t i) {
    const Vector3d middle = scene.world.attachment_of(i)
                                ? Vector3d(scene.T_world_obj(i, now_ns).translation())
                                : scene.world.object(i).T_world_obj.translation();
    return (body.T.translation() - middle).norm() - reach - reaches_[i];
  };
  for (const std::size_t i : scene.around(body.T.translation(), reach + kFarOff)) {
    if (scene.is_own(robot, feeler, i)) continue;
    if (scene.is_on_its_way(i)) room = 0.0;
    const double balls = room_of_balls(i);
    if (balls > 0.0 && balls >= std::min(room, kFarOff)) {
      room = std::min(room, balls);
      continue;
    }
    Solid solid = solid_of(scene.world.object(i).shape);
    solid.T = scene.T_world_obj(i, now_ns);
    const bool apart = is_farther(body, solid, kNear);
    if (room > 0.0) room = std::min(room, apart ? gap_between(body, solid).distance : 0.0);
    if (apart || !scene.may_press(robot, i, feeler, across)) continue;
    visit(feeler, body, i, solid);
  }
  // More distant objects are checked only if no nearer one was found.
  for (double sure = kFarOff; room > sure && sure < kFarthest;) {
    sure *= 2.0;
    for (const std::size_t i : scene.around(body.T.translation(), reach + sure)) {
      if (scene.is_own(robot, feeler, i)) continue;
      const double balls = room_of_balls(i);
      if (balls >= kFarOff) room = std::min(room, balls);
    }
  }
  return room;
}

void Contacts::settle(const std::vector<CellRobot>& robots, const World& world,
                      std::int64_t now_ns) {
  if (now_ns != begin_ns_) {
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
  seen_.clear();
}

void Contacts::forget_object(std::string_view name) {
  reaches_.clear();
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
    a.T = scene.T_world_link(robot, feeler.frame, t_ns) * feeler.solid.T;
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
    // Apart at k, in contact from then on.
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

std::vector<Press> Contacts::presses(const std::vector<CellRobot>& robots, const World& world,
                                     int robot, std::int64_t t_ns) {
  std::vector<Press> all;
  if (world.size() == 0) return all;
  const Scene scene{robots, world};
  // Velocity of a point of the link that joint `frame` moves.
  const auto velocity_of = [&](int of, int frame, const Vector3d& p) -> Vector3d {
    Eigen::VectorXd q, qd;
    scene.state(of, t_ns, q, qd);
    const Robot& model = *scene.arm(of).model;
    qd = row_rates(model, qd);
    if (frame != kFlange) qd.tail(model.rows() - frame).setZero();
    Jacobian J(6, model.rows());
    const Isometry3d T = forward_and_jacobian(model.uncoupled(), row_values(model, q), J);
    const Vector6d twist = J * qd;
    return twist.head<3>() + twist.tail<3>().cross(p - T.translation());
  };
  for_each_contact(
      scene, robot, t_ns,
      [&](const Feeler& feeler, const Solid& a, std::size_t index, const Solid& b) {
        const Object& object = world.object(index);
        const Vector3d n = b.T.linear() * first_touch(scene, robot, feeler, index, t_ns).normal_obj;
        const double normal = object.stiffness * depth_along(a, b, n);
        if (!(normal > 0.0)) return;
        const Vector3d p = pressure_point(a, b, n);
        Vector3d v = velocity_of(robot, feeler.frame, p);
        if (const auto& carried = world.attachment_of(index))
          v -= velocity_of(carried->carrier, carried->frame, p);
        v -= v.dot(n) * n;
        double mu = object.friction;
        if (!feeler.carried.empty()) mu = std::min(mu, world.at(feeler.carried).friction);
        all.push_back({.carried = feeler.carried,
                       .part = feeler.part,
                       .frame = feeler.frame,
                       .of_hand = feeler.of_hand,
                       .object = object.name,
                       .p = p,
                       .force = normal * n - mu * normal / std::max(v.norm(), kSlips) * v,
                       .normal = normal,
                       .friction = mu});
      });
  return all;
}

}  // namespace armlet
