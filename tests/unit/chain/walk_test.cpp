// Walking along a chain, outward and inward.
#include <doctest/doctest.h>

#include <vector>

#include "armlet/model/dh.hpp"
#include "chain/quick_sines.hpp"
#include "chain/walk_in.hpp"
#include "chain/walk_out.hpp"
#include "random_arm.hpp"

using namespace armlet;

namespace {

// A point and a direction, fixed in the tool.
struct PointAndDirection {
  Parts<double> point, direction;

  void rotate_z(Lanes sine, Lanes cosine) {
    point.rotate_z(sine[0], cosine[0]);
    direction.rotate_z(sine[0], cosine[0]);
  }
  void rotate_right_z(Lanes sine, Lanes cosine) {
    point.rotate_right_z(sine[0], cosine[0]);
    direction.rotate_right_z(sine[0], cosine[0]);
  }
  void rotate_x(double sine, double cosine) {
    point.rotate_x(sine, cosine);
    direction.rotate_x(sine, cosine);
  }
  void start(const WalkPlan& plan, Lanes sine, Lanes cosine) {
    const auto by_tool = [&plan](const Parts<double>& v, double w) {
      const auto row = [&](std::size_t r) {
        const double* T = plan.tool.data() + 4 * r;
        return T[0] * v.x + T[1] * v.y + T[2] * v.z + T[3] * w;
      };
      return Parts<double>{row(0), row(1), row(2)};
    };
    point = by_tool(point, 1.0);
    direction = by_tool(direction, 0.0);
    rotate_z(sine, cosine);
  }
  void shift_z(double d) { point.z += d; }
  void shift_x(double a) { point.x += a; }
  void place(const double* base) {
    point.rotate_base(base);
    direction.rotate_base(base);
    point = point + Parts<double>{base[9], base[10], base[11]};
  }
};

Eigen::Vector3d to_eigen(const Parts<double>& v) { return {v.x, v.y, v.z}; }
Eigen::Vector3d to_eigen(const WalkAxis& v) { return {v.xy[0], v.xy[1], v.z}; }

// Frames before each joint's own motion counts, and at the end the tool.
std::vector<Eigen::Isometry3d> product_of_rows(const Robot& robot, const Eigen::VectorXd& q) {
  const Chain& chain = robot.chain();
  const auto x_step = [&chain](std::size_t i) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    const double s = chain.sin_alpha[i], c = chain.cos_alpha[i];
    X.linear() << 1, 0, 0, 0, c, -s, 0, s, c;
    X.translation().x() = chain.a[i];
    return X;
  };
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d T = robot.T_world_base();
  for (std::size_t i = 0; i < static_cast<std::size_t>(chain.n); ++i) {
    const double value = q[static_cast<Eigen::Index>(i)];
    T = T * x_step(i) *
        dh_pose(DhConvention::kStandard, {.theta = chain.theta[i] + chain.q_to_theta[i] * value,
                                          .d = chain.d[i] + chain.q_to_d[i] * value});
    frames.push_back(T);
  }
  frames.push_back(T * x_step(static_cast<std::size_t>(chain.n)) * robot.T_flange_tool());
  return frames;
}

template <int N>
using SinesFromTool = QuickJointSines<N, true>;

template <template <int> class SinesOf>
double worst_walk_in(const Robot& robot, const Eigen::VectorXd& q, Random& random) {
  const Eigen::Isometry3d T = product_of_rows(robot, q).back();
  const Eigen::Vector3d p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const Eigen::Vector3d v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  PointAndDirection carried = {{p.x(), p.y(), p.z()}, {v.x(), v.y(), v.z()}};
  const WalkPlan& plan = robot.walk_plan();
  walk_in(plan, plan.n, q.data(), SinesOf<kAnyCount>(plan, q.data()), carried);
  return std::max((to_eigen(carried.point) - T * p).norm(),
                  (to_eigen(carried.direction) - T.linear() * v).norm());
}

}  // namespace

// Twelve steps of a few roundings each, of lengths up to five metres; quick sines have an error of
// two units more.
TEST_CASE("what is carried from the tool to the base is multiplied by all rows") {
  Random random(5);
  double exact = 0.0, quick = 0.0;
  for (int k = 0; k < 1200; ++k) {
    const int n = 1 + k % kMaxJoints;
    const Robot robot = random_arm(random, n);
    const Eigen::VectorXd q = random_values(random, n);
    exact = std::max(exact, worst_walk_in<JointSines>(robot, q, random));
    quick = std::max(quick, worst_walk_in<SinesFromTool>(robot, q, random));
  }
  CHECK(exact < 1e-13);
  CHECK(quick < 1e-13);
}

TEST_CASE(
    "walking outward passes the frame of each joint, up to half a revolution about its x axis") {
  Random random(6);
  double worst = 0.0;
  for (int k = 0; k < 1200; ++k) {
    const int n = 1 + k % kMaxJoints;
    const Robot robot = random_arm(random, n);
    const Eigen::VectorXd q = random_values(random, n);
    const std::vector<Eigen::Isometry3d> frames = product_of_rows(robot, q);
    const WalkPlan& plan = robot.walk_plan();
    const auto compare = [&](const Eigen::Isometry3d& T, const WalkFrame& f, double flip) {
      worst = std::max({worst, (T.linear().col(0) - to_eigen(f.x)).norm(),
                        (T.linear().col(1) - flip * to_eigen(f.y)).norm(),
                        (T.linear().col(2) - flip * to_eigen(f.z)).norm(),
                        (T.translation() - to_eigen(f.p)).norm()});
    };
    std::size_t passed = 0;
    WalkFrame frame = walk_out<kAnyCount>(
        plan, q.data(),
        [&](std::size_t i, const WalkFrame& f) {
          CHECK(i == passed++);
          compare(frames[i], f, plan.flip[i]);
        },
        [](std::size_t, const WalkFrame&) {});
    CHECK(passed == static_cast<std::size_t>(n));
    frame.step_tool(plan);
    compare(frames.back(), frame, 1.0);
  }
  CHECK(worst < 1e-13);
}
