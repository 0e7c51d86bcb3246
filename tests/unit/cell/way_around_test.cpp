#include "armlet/cell/way_around.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "armlet/cell/gripper.hpp"
#include "armlet/core/checkpoint.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Points = std::vector<VectorXd>;

constexpr double kRoom = 0.012;     // m, between obstacles and the known path
constexpr double kOwnRoom = 0.006;  // m, between its own links along that path

Trajectory straight(const VectorXd& q0, const VectorXd& q1) {
  std::vector<JointPath> joints;
  for (Eigen::Index i = 0; i < q0.size(); ++i) {
    joints.push_back(
        {.segments = {{.start = 0.0, .duration = 1.0, .degree = 1, .c = {q0[i], q1[i] - q0[i]}}},
         .q_end = q1[i]});
  }
  return {std::move(joints), 1.0};
}

// A cell with one robot, and a joint path that is known to be free.
class Puzzle {
 public:
  Puzzle(const std::string& name, std::uint64_t seed) : random_(seed), robot_(make_robot(name)) {
    do {
      way_.clear();
      const int corners = 1 + static_cast<int>(random_.below(4));
      for (int k = 0; k < corners + 2; ++k) way_.push_back(random_joints());
    } while (!is_free({}, way_, kOwnRoom));
  }

  // Boxes, balls and cylinders near the straight path, which is blocked in the end.
  bool scatter(std::size_t count) {
    count += objects_.size();
    for (int k = 0; k < 400 && objects_.size() < count; ++k) {
      Object object = random_body();
      object.T_world_obj.translation() = near_straight_way();
      add(std::move(object));
    }
    return is_blocked();
  }

  // A wall of tiles across the straight path, without those that the known path needs: a gap.
  void wall() {
    const VectorXd q = 0.5 * (way_.front() + way_.back());
    const Vector3d p = forward(*robot_, q).translation();
    Vector3d across =
        forward(*robot_, way_.back()).translation() - forward(*robot_, way_.front()).translation();
    across.z() = 0.0;
    tiles(p, Eigen::AngleAxisd(std::atan2(across.y(), across.x()), Vector3d::UnitZ())
                 .toRotationMatrix());
  }

  // Boards one over the other, of tiles, and a back between them.
  void shelf() {
    const Vector3d p = forward(*robot_, way_.back()).translation();
    const double angle = std::atan2(p.y(), p.x());
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    const Eigen::Matrix3d lying = R * Eigen::AngleAxisd(1.5707963267948966, Vector3d::UnitY());
    tiles(p + Vector3d(0.0, 0.0, 0.15), lying);
    tiles(p - Vector3d(0.0, 0.0, 0.15), lying);
    tiles(p + R * Vector3d(0.3, 0.0, 0.0), R);
  }

  [[nodiscard]] Cell cell() const {
    Cell all;
    all.add_robot(robot_, "arm");
    all.set_joints(0, way_.front());
    for (const Object& each : objects_) all.insert(each);
    return all;
  }
  [[nodiscard]] const VectorXd& goal() const { return way_.back(); }
  [[nodiscard]] const Robot& robot() const { return *robot_; }

 private:
  VectorXd random_joints() {
    VectorXd q(robot_->n());
    for (int i = 0; i < robot_->n(); ++i) {
      q[i] = random_.uniform(std::max(robot_->lower()[i], -2.8), std::min(robot_->upper()[i], 2.8));
    }
    return q;
  }

  Object random_body() {
    Object object;
    const auto size = [&] { return random_.uniform(0.03, 0.25); };
    switch (random_.below(3)) {
      case 0:
        object.shape = Box{{size(), size(), size()}};
        break;
      case 1:
        object.shape = Sphere{0.5 * size()};
        break;
      default:
        object.shape = Cylinder{0.5 * size(), size()};
    }
    const Vector3d axis(random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0), 0.5);
    object.T_world_obj.linear() =
        Eigen::AngleAxisd(random_.uniform(0.0, 3.0), axis.normalized()).toRotationMatrix();
    return object;
  }

  // A point of a link somewhere on the straight path, and beside it.
  Vector3d near_straight_way() {
    const VectorXd q = way_.front() + random_.uniform(0.15, 0.85) * (way_.back() - way_.front());
    const int frame = 1 + static_cast<int>(random_.below(static_cast<std::uint64_t>(robot_->n())));
    const Vector3d beside(random_.uniform(-0.1, 0.1), random_.uniform(-0.1, 0.1),
                          random_.uniform(-0.1, 0.1));
    return link_frame(*robot_, q, frame).translation() + beside;
  }

  // 6 x 6 tiles of 120 mm around a point, in the y-z plane of a frame.
  void tiles(const Vector3d& p, const Eigen::Matrix3d& R) {
    constexpr double kTile = 0.12;
    for (int i = -3; i < 3; ++i) {
      for (int k = -3; k < 3; ++k) {
        Object tile;
        tile.shape = Box{{0.02, kTile, kTile}};
        tile.T_world_obj.linear() = R;
        tile.T_world_obj.translation() =
            p + R * Vector3d(0.0, kTile * (i + 0.5), kTile * (k + 0.5));
        add(std::move(tile));
      }
    }
  }

  // Unless the known path meets it.
  void add(Object object) {
    object.name = "o" + std::to_string(objects_.size() + 1);
    object.fixed = true;
    if (is_free({object}, way_, kRoom)) objects_.push_back(std::move(object));
  }

  [[nodiscard]] bool is_blocked() const {
    return !is_free(objects_, {way_.front(), way_.back()}, 1e-4);
  }

  [[nodiscard]] bool is_free(const std::vector<Object>& objects, const Points& points,
                             double clearance) const {
    Cell cell;
    cell.add_robot(robot_, "arm");
    for (const Object& each : objects) cell.insert(each);
    const Trajectory ends = straight(points.front(), points.back());
    MotionScene scene = compared_bodies(cell, 0, ends).scene;
    if (!objects.empty())
      std::erase_if(scene.pairs, [](const CheckedPair& pair) { return pair.b.arm == 0; });
    SegmentCheck check(scene, clearance, {});
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      if (!check.is_free(points[k], points[k + 1])) return false;
    }
    return true;
  }

  Random random_;
  std::shared_ptr<const Robot> robot_;
  Points way_;
  std::vector<Object> objects_;
};

bool same_bits(const Trajectory& a, const Trajectory& b) {
  if (a.n() != b.n()) return false;
  for (int i = 0; i < a.n(); ++i) {
    const auto &first = a.joint(i).segments, &second = b.joint(i).segments;
    if (first.size() != second.size()) return false;
    for (std::size_t k = 0; k < first.size(); ++k) {
      if (std::bit_cast<std::uint64_t>(first[k].start) !=
          std::bit_cast<std::uint64_t>(second[k].start))
        return false;
      for (std::size_t c = 0; c < first[k].c.size(); ++c) {
        if (std::bit_cast<std::uint64_t>(first[k].c[c]) !=
            std::bit_cast<std::uint64_t>(second[k].c[c]))
          return false;
      }
    }
  }
  return true;
}

// The clearance that a pair of a scene has to keep, from the gaps at both ends: what the reference
// says, written down again.
double promised(double clearance, double gap_at_ends) {
  return std::min(clearance, std::max(0.5 * gap_at_ends, gap_at_ends - 0.25 * clearance));
}

// The gaps of all pairs of a scene at a position, placed without the code under test.
std::vector<double> gaps_at(const MotionScene& scene, const VectorXd& q) {
  const std::vector<Eigen::Isometry3d> frames = link_frames(*scene.arms[0].robot, q);
  const auto body = [&](const BodyRef& ref) {
    if (ref.arm == BodyRef::kFixed) return scene.fixed[static_cast<std::size_t>(ref.index)];
    const ArmSolid& own = scene.arms[0].solids[static_cast<std::size_t>(ref.index)];
    Solid solid = own.solid;
    solid.T = (own.frame == 0 ? scene.arms[0].robot->T_world_base()
                              : frames[static_cast<std::size_t>(own.frame - 1)]) *
              own.solid.T;
    return solid;
  };
  std::vector<double> all;
  for (const CheckedPair& pair : scene.pairs)
    all.push_back(gap_between(body(pair.a), body(pair.b)).distance);
  return all;
}

// By how much the motion misses what is promised at the worst of many instants, m; below zero: it
// keeps more.
double missing_clearance(const Cell& cell, const Trajectory& motion, double clearance) {
  constexpr int kSamples = 800;
  const MotionScene scene = compared_bodies(cell, 0, motion).scene;
  const std::vector<double> first = gaps_at(scene, motion.start());
  const std::vector<double> last = gaps_at(scene, motion.end());
  double worst = -clearance;
  for (int k = 0; k <= kSamples; ++k) {
    VectorXd q(motion.n());
    for (int i = 0; i < motion.n(); ++i) q[i] = motion.value(i, motion.duration() * k / kSamples);
    const std::vector<double> now = gaps_at(scene, q);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double at_ends = std::min(first[i], last[i]);
      if (at_ends > 2e-4) worst = std::max(worst, promised(clearance, at_ends) - now[i]);
    }
  }
  return worst;
}

void check_motion_keeps_limits(const Robot& robot, const Trajectory& motion) {
  for (int i = 0; i < robot.n(); ++i) {
    CHECK(motion.peak(i, 1) <= robot.joint(i).max_speed * (1.0 + 1e-6));
    CHECK(motion.peak(i, 2) <= robot.joint(i).max_accel * (1.0 + 1e-6));
    CHECK(motion.peak(i, 3) <= robot.joint(i).max_jerk * (1.0 + 1e-6));
    CHECK(motion.range(i).lower >= robot.lower()[i] - 1e-9);
    CHECK(motion.range(i).upper <= robot.upper()[i] + 1e-9);
  }
}

}  // namespace

// 200 scenes: a path is sampled first, then obstacles are put where it is not.
TEST_CASE(
    "paths around obstacles are found in random scenes that have one, certified, with the same "
    "bits" *
    doctest::skip(!can_search_ways())) {
  const std::vector<std::string> arms = {"puma560", "scara", "ur5",  "planar3",
                                         "kr6",     "scara", "panda"};
  int tried = 0, scenes = 0, solved = 0, most = 0;
  double whole = 0.0;
  for (std::uint64_t seed = 1; scenes < 200; ++seed) {
    const std::string& name = arms[seed % arms.size()];
    Puzzle puzzle(name, 77'000 + seed);
    if (seed % 4 == 0) puzzle.wall();
    if (seed % 4 == 1) puzzle.shelf();
    if (++tried; !puzzle.scatter(6 + seed % 13)) continue;
    ++scenes;
    const Cell cell = puzzle.cell();
    const WayAround around = find_way_around(cell, {.robot = 0, .goals = {puzzle.goal()}});
    INFO(name, " ", seed, ": ", around.way.iterations, " iterations");
    most = std::max(most, around.way.iterations);
    REQUIRE(around.ok());
    ++solved;
    const Trajectory& motion = *around.motion.trajectory;
    CHECK(motion.start() == cell.robot(0).q);
    CHECK(motion.end() == puzzle.goal());
    CHECK(find_collisions(cell, 0, motion).empty());
    CHECK(missing_clearance(cell, motion, 0.005) <= 0.0);
    check_motion_keeps_limits(puzzle.robot(), motion);
    whole += motion.duration();
    if (seed % 4 != 0) continue;
    // Again in a process that has searched others meanwhile.
    const WayAround again = find_way_around(cell, {.robot = 0, .goals = {puzzle.goal()}});
    REQUIRE(again.ok());
    CHECK(same_bits(motion, *again.motion.trajectory));
  }
  MESSAGE(solved << " of " << scenes << " scenes (" << tried << " tried), at most " << most
                 << " iterations, " << whole << " s of motions");
}

// Where there is much room a wide clearance is kept as well; where there is none that wide, no path
// is found, or one that keeps it.
TEST_CASE("a clearance of any width is kept everywhere, corners included" *
          doctest::skip(!can_search_ways())) {
  int solved = 0, around_corners = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    Puzzle puzzle(seed % 2 == 0 ? "ur5" : "puma560", 99'000 + seed);
    if (!puzzle.scatter(1 + seed % 9)) continue;
    const Cell cell = puzzle.cell();
    const double clearance = std::array{0.001, 0.005, 0.012, 0.03}[seed % 4];
    const WayAround around =
        find_way_around(cell, {.robot = 0,
                               .goals = {puzzle.goal()},
                               .search = {.clearance = clearance, .iterations = 2'000}});
    if (!around.ok()) continue;
    ++solved;
    if (around.way.points.size() > 2) ++around_corners;
    INFO(seed, ": ", clearance, " m");
    CHECK(missing_clearance(cell, *around.motion.trajectory, clearance) <= 0.0);
  }
  CHECK(solved > 50);
  CHECK(around_corners > 40);
}

namespace {

Object body_at(const std::string& name, const Shape& shape, const Vector3d& p) {
  Object object;
  object.name = name;
  object.shape = shape;
  object.fixed = true;
  object.T_world_obj.translation() = p;
  return object;
}

// A SCARA with its arm to the right, and to the left.
struct Scara {
  std::shared_ptr<const Robot> robot = make_robot("scara");
  Cell cell;
  VectorXd right = robot->home(), left = robot->home();
  Scara() {
    cell.add_robot(robot, "arm");
    right[0] = -1.0;
    left[0] = 1.0;
    right[1] = left[1] = 0.6;
    cell.set_joints(0, right);
  }
};

}  // namespace

TEST_CASE("a wall from the base outwards leaves no path, and is named with what hits it" *
          doctest::skip(!can_search_ways())) {
  Scara scara;
  scara.cell.insert(body_at("wall", Box{{2.0, 0.02, 2.0}}, {1.15, 0.0, 0.3}));
  const WayAround around = find_way_around(
      scara.cell, {.robot = 0, .goals = {scara.left}, .search = {.iterations = 300}});
  CHECK(around.way.status == WayStatus::kNotFound);
  CHECK(around.way.iterations == 300);
  CHECK_FALSE(around.ok());
  REQUIRE_FALSE(around.blocking.empty());
  double share = 0.0;
  for (const BlockingBodies& each : around.blocking) {
    CHECK(each.other.object == "wall");
    share += each.share;
  }
  CHECK(share == doctest::Approx(1.0));
}

TEST_CASE("a start or a goal that collides is reported with the bodies and how deep they are") {
  Scara scara;
  const Vector3d p = link_frame(*scara.robot, scara.left, 1).translation();
  scara.cell.insert(body_at("post", Box{{0.1, 0.1, 0.4}}, p));
  WayAround around = find_way_around(scara.cell, {.robot = 0, .goals = {scara.left}});
  CHECK(around.way.status == WayStatus::kGoalCollides);
  REQUIRE_FALSE(around.blocking.empty());
  CHECK(around.blocking[0].other.object == "post");
  CHECK(around.blocking[0].depth > 0.01);
  scara.cell.set_joints(0, scara.left);
  around = find_way_around(scara.cell, {.robot = 0, .goals = {scara.right}});
  CHECK(around.way.status == WayStatus::kStartCollides);
  REQUIRE_FALSE(around.blocking.empty());
  CHECK(around.blocking[0].other.object == "post");
}

TEST_CASE("another goal is taken where the first one collides") {
  Scara scara;
  VectorXd other = scara.left;
  other[0] = -0.2;
  const Vector3d p = link_frame(*scara.robot, scara.left, 1).translation();
  scara.cell.insert(body_at("post", Box{{0.1, 0.1, 0.4}}, p));
  const WayAround around = find_way_around(scara.cell, {.robot = 0, .goals = {scara.left, other}});
  REQUIRE(around.ok());
  CHECK(around.way.goal == 1);
  CHECK(around.motion.trajectory->end() == other);
}

TEST_CASE("a time is kept, and one that is too short is refused with what would do" *
          doctest::skip(!can_search_ways())) {
  Scara scara;
  scara.cell.insert(body_at("post", Box{{0.06, 0.06, 2.0}}, {0.52, 0.0, 0.3}));
  const WayAround fast = find_way_around(scara.cell, {.robot = 0, .goals = {scara.left}});
  REQUIRE(fast.ok());
  CHECK(fast.way.points.size() > 2);
  const double least = fast.motion.trajectory->duration();
  const WayAround slow =
      find_way_around(scara.cell, {.robot = 0, .goals = {scara.left}, .time = 2.0 * least});
  REQUIRE(slow.ok());
  CHECK(slow.motion.trajectory->duration() == doctest::Approx(2.0 * least));
  const WayAround none =
      find_way_around(scara.cell, {.robot = 0, .goals = {scara.left}, .time = 0.5 * least});
  CHECK_FALSE(none.ok());
  REQUIRE(none.motion.too_fast);
  CHECK(none.motion.too_fast->least_time > 0.5 * least);
}

// The tool point itself would pass over the posts; what it carries would not.
TEST_CASE("what the tool carries is part of the arm" * doctest::skip(!can_search_ways())) {
  Cell cell;
  const auto robot =
      std::make_shared<const Robot>(make_robot("scara")->with_tool(parallel_gripper(0.060, 0.150)));
  const int arm = cell.add_robot(robot, "arm");
  VectorXd right = robot->home(), left = robot->home();
  right[0] = -1.0;
  left[0] = 1.0;
  right[2] = left[2] = 0.1;
  cell.set_joints(arm, right);
  const Vector3d p = cell.T_world_tool(arm).translation();
  Object bar = body_at("bar", Box{{0.04, 0.04, 0.08}}, p - Vector3d(0.0, 0.0, 0.02));
  bar.fixed = false;
  cell.insert(bar);
  // Its top is 30 mm below the tool point, and 30 mm above the lower end of the bar.
  cell.insert(body_at("fence", Box{{2.0, 0.02, 0.1}}, {p.x() + 0.5, 0.0, p.z() - 0.08}));
  const WayAround empty = find_way_around(cell, {.robot = arm, .goals = {left}});
  REQUIRE(empty.ok());
  CHECK(empty.way.points.size() == 2);
  REQUIRE(grasp(cell, arm, "bar").ok());
  const WayAround carried = find_way_around(cell, {.robot = arm, .goals = {left}});
  REQUIRE(carried.ok());
  CHECK(carried.way.points.size() > 2);
  CHECK(find_collisions(cell, arm, *carried.motion.trajectory).empty());
}

// The second arm has left when it stands: for the search there is room, during the motion there is
// not.
TEST_CASE("a robot that is met while it moves is reported, and no motion is returned") {
  const auto model = make_robot("planar2");
  const auto q = [](double angle) { return VectorXd(Eigen::Vector2d(angle, 0.0)); };
  Cell cell;
  const int left = cell.add_robot(model, "left");
  const Eigen::Isometry3d T_base =
      Eigen::Translation3d(1.6 * model->reach(), 0.0, 0.0) * model->T_world_base();
  const auto other = std::make_shared<const Robot>(model->with_base(T_base));
  const int right = cell.add_robot(other, "right");
  cell.set_joints(left, q(1.5));
  cell.set_joints(right, q(3.1));
  cell.start(right, straight(q(3.1), q(1.1)).stretched(100.0));
  const WayAround around = find_way_around(cell, {.robot = left, .goals = {q(-1.5)}});
  CHECK(around.way.points.size() == 2);
  CHECK_FALSE(around.ok());
  REQUIRE(around.met.size() == 1);
  CHECK(around.met[0].other.robot == right);
}

namespace {

class Limit : public Supervisor {
 public:
  explicit Limit(std::uint64_t operations) : left_(operations) {}
  bool go_on(std::uint64_t operations) override {
    if (operations >= left_) return false;
    left_ -= operations;
    return true;
  }

 private:
  std::uint64_t left_;
};

}  // namespace

TEST_CASE("a search is stopped from outside, wherever it is" * doctest::skip(!can_search_ways())) {
  Scara scara;
  scara.cell.insert(body_at("wall", Box{{2.0, 0.02, 2.0}}, {1.15, 0.0, 0.3}));
  for (const std::uint64_t operations : {1'000U, 100'000U, 1'000'000U, 5'000'000U}) {
    Limit limit(operations);
    const Supervised supervised(&limit);
    CHECK_THROWS_AS(find_way_around(scara.cell, {.robot = 0, .goals = {scara.left}}), Stopped);
  }
}

}  // namespace armlet
