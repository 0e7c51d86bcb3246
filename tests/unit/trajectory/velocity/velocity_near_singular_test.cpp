// Laws of velocity commands where joints are at a large part of their speeds while the tool is
// slow.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/decompose.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/velocity.hpp"
#include "survey.hpp"
#include "velocity_cases.hpp"

using namespace armlet;
using namespace armlet::velocity_cases;

namespace {

// A position from which joint speeds that hardly move the tool are near: from a random one, random
// steps that lessen the least singular value of the directions in which the arm can move.
Eigen::VectorXd near_singular(const Robot& robot, double value, Dice& dice) {
  const auto value_at = [&](const Eigen::VectorXd& q) {
    const Eigen::MatrixXd J = jacobian(robot, q);
    const Eigen::VectorXd s = singular_values(J).s;
    return s[std::min<Eigen::Index>(robot.n(), 6) - 1];
  };
  Eigen::VectorXd q = good_position(robot, dice);
  double least = value_at(q), step = 0.3;
  for (int k = 0; k < 400 && least > value; ++k) {
    const Eigen::VectorXd next = q + dice.within(Eigen::VectorXd::Constant(robot.n(), step));
    const Eigen::ArrayXd margin = 0.05 * (robot.upper() - robot.lower()).array().min(6.0);
    const bool inside = (next.array() > robot.lower().array() + margin).all() &&
                        (next.array() < robot.upper().array() - margin).all();
    if (!inside) continue;
    if (const double at = value_at(next); at < least) {
      least = at;
      q = next;
    } else {
      step = std::max(0.9 * step, 0.02);
    }
  }
  return q;
}

enum class Kind { kMoving, kTurning, kBoth };

// A velocity for which a joint needs the part `use` of its speed.
Vector6d velocity_for(const Robot& robot, const Eigen::VectorXd& q, Kind kind, double use,
                      Dice& dice) {
  Vector6d twist = holdable(robot, 1.0, dice);
  if (robot.n() >= 6 && kind == Kind::kMoving) twist.tail<3>().setZero();
  if (robot.n() >= 6 && kind == Kind::kTurning) twist.head<3>().setZero();
  const Eigen::MatrixXd J = jacobian(robot, q);
  const Eigen::VectorXd qd = J.completeOrthogonalDecomposition().solve(twist);
  const double load = (qd.array().abs() / robot.max_speed().array()).maxCoeff();
  return std::min(use / load, 0.5) * twist;
}

// By which part the tool exceeds the fastest velocity between two times: moving where moving is
// asked for, rotating where rotating is.
double excess(const Robot& robot, const Trajectory& motion, double begin, double end,
              const ToolSpeeds& fastest) {
  double most = 0.0;
  constexpr int kSamples = 25;
  for (int k = 0; k <= kSamples; ++k) {
    const State s = state_at(motion, begin + (end - begin) * k / kSamples);
    const Vector6d moving = jacobian(robot, s.q) * s.qd;
    if (fastest.v > 1e-3) most = std::max(most, moving.head<3>().norm() / fastest.v - 1.0);
    if (fastest.w > 5e-3 && fastest.w > 0.2 * fastest.v)
      most = std::max(most, moving.tail<3>().norm() / fastest.w - 1.0);
  }
  return most;
}

// Whether the tool has exactly its velocity and keeps it.
bool taken_up(const Robot& robot, const VelocityStart& state, const Vector6d& twist) {
  const Eigen::MatrixXd J = jacobian(robot, state.q);
  const Vector6d gain = J * state.qdd + jacobian_dot_qd(robot, state.q, state.qd);
  return (J * state.qd - twist).norm() < 1e-7 && gain.norm() < 1e-5;
}

// How much faster the tool became than the fastest velocity being taken up: while one was, and
// while the joints stopped after it.
struct Sent {
  int planned = 0;
  double excess = 0.0;
  double stopping = 0.0;
};

// A command that was not calm, to be looked at by itself.
void tell(const VelocityStart& start, const Vector6d& twist, double taking_up, double stopping) {
  std::ostringstream text;
  text.precision(17);
  const auto row = [&](const char* name, const Eigen::VectorXd& x) {
    text << "\n" << name << " " << x.transpose();
  };
  row("q", start.q);
  row("qd", start.qd);
  row("qdd", start.qdd);
  row("twist", twist);
  text << "\nduring " << start.during;
  if (start.fastest) text << " fastest " << start.fastest->v << " " << start.fastest->w;
  MESSAGE("above by " << 100.0 * taking_up << " %, stopping " << 100.0 * stopping << " %"
                      << text.str());
}

// Random velocities one after another. The largest ones still being taken up are counted here, not
// asked for.
void send(const Robot& robot, const Eigen::VectorXd& q, Kind kind, Dice& dice, Sent& sent) {
  VelocityStart start = standing(q, 0.0);
  const double use = std::exp(dice.from(std::log(0.05), std::log(0.9)));
  ToolSpeeds fastest;
  for (int c = 0; c < 12; ++c) {
    Vector6d twist = velocity_for(robot, start.q, kind, use, dice);
    twist *= dice.from(0.0, 1.0) < 0.1 ? 0.0 : dice.from(0.1, 1.0);
    start.during = some_period(dice);
    const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
    if (!plan.motion) continue;
    ++sent.planned;
    fastest = {.v = std::max(fastest.v, twist.head<3>().norm()),
               .w = std::max(fastest.w, twist.tail<3>().norm())};
    check_motion(robot, start, *plan.motion);
    const VelocityStart begin = start;
    const double taking_up = excess(robot, *plan.motion, 0.0, start.during, fastest);
    const double stops = start.during;
    go_on(*plan.motion, start);
    start.fastest = plan.take_up.fastest;
    if (taken_up(robot, start, twist))
      fastest = {.v = twist.head<3>().norm(), .w = twist.tail<3>().norm()};
    const double stopping = excess(robot, *plan.motion, stops, plan.motion->duration(), fastest);
    if (std::max(taking_up, stopping) > 0.01) tell(begin, twist, taking_up, stopping);
    sent.excess = std::max(sent.excess, taking_up);
    sent.stopping = std::max(sent.stopping, stopping);
  }
}

}  // namespace

TEST_CASE("near singular positions no tool is faster than the fastest velocity being taken up") {
  Dice dice{std::mt19937_64(survey_seed(55))};
  int planned = 0;
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    if (holdable(robot, 1.0, dice).isZero()) continue;
    Sent sent;
    for (int n = 0; n < 3 * survey_count(1); ++n) {
      const Kind kind =
          std::array{Kind::kMoving, Kind::kTurning, Kind::kBoth}[static_cast<std::size_t>(n % 3)];
      const double value = std::exp(dice.from(std::log(0.003), std::log(0.1)));
      send(robot, near_singular(robot, value, dice), kind, dice, sent);
      send(robot, good_position(robot, dice), kind, dice, sent);
    }
    CHECK(sent.planned > 30);
    planned += sent.planned;
    CHECK(sent.excess <= 0.01);
    CHECK(sent.stopping <= 0.01);
  }
  MESSAGE(planned << " commands");
}

TEST_CASE("near singular positions a velocity sent again and again is one sent once") {
  Dice dice{std::mt19937_64(survey_seed(56))};
  for (const std::string_view name : catalog_names()) {
    CAPTURE(std::string(name));
    const Robot robot = *make_robot(name);
    if (holdable(robot, 1.0, dice).isZero()) continue;
    int compared = 0;
    for (const Kind kind : {Kind::kMoving, Kind::kTurning, Kind::kBoth}) {
      const VelocityStart start = standing(near_singular(robot, 0.03, dice), 0.0);
      const double use = dice.from(0.1, 0.6);
      const Resent result = resend(dice, start, 5, [&](const VelocityStart& from) {
        const Vector6d twist = velocity_for(robot, from.q, kind, use, dice);
        return [&robot, twist](const VelocityStart& at) {
          return plan_tool_velocity(robot, at, twist);
        };
      });
      compared += result.compared;
      CHECK(result.apart < 1e-9);
    }
    CHECK(compared > 3);
  }
}

// Found among other seeds: the tool slows down first, and the law that follows begins with the
// accelerations then.
TEST_CASE("a command that slows the tool down first can be sent again like any other") {
  const Robot robot = *make_robot("planar3");
  using Joints3 = Eigen::Vector<double, 3>;
  VelocityStart start{
      .q = Joints3{0.57993064763467272, -0.031651879388724984, -1.394974673871807},
      .qd = Joints3{-0.039197871254063453, 0.090912266267357378, -0.051178006325420439},
      .qdd = Joints3{1.0946107273840702, -2.5387486290274048, 1.4291591083311108},
      .fastest = ToolSpeeds{0.011210894515916729, 0.017509026003248575}};
  const Vector6d twist{-0.0043663945235272155, 0.014495467953817218, 0.0, 0.0, 0.0,
                       -0.0072742989017902078};
  constexpr int kTimes = 12;
  VelocityStart once = start, often = start;
  often.during = 0.003;
  once.during = kTimes * often.during;
  const VelocityPlan whole = plan_tool_velocity(robot, once, twist);
  REQUIRE(whole.motion);
  go_on(*whole.motion, once);
  for (int k = 0; k < kTimes; ++k) {
    const VelocityPlan part = plan_tool_velocity(robot, often, twist);
    REQUIRE(part.motion);
    go_on(*part.motion, often);
    often.same = part.take_up;
  }
  CHECK((once.q - often.q).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((once.qd - often.qd).cwiseAbs().maxCoeff() < 1e-9);
}

namespace {

// By which part the tool of an arm exceeds the fastest velocity that is taken up.
double excess_of_command(const char* name, const VelocityStart& start, const Vector6d& twist) {
  const Robot robot = *make_robot(name);
  const VelocityPlan plan = plan_tool_velocity(robot, start, twist);
  REQUIRE(plan.motion);
  const double taking_up = excess(robot, *plan.motion, 0.0, start.during, *start.fastest);
  const double stopping =
      excess(robot, *plan.motion, start.during, plan.motion->duration(), plan.take_up.fastest);
  return std::max(taking_up, stopping);
}

}  // namespace

// Found among other seeds: the joints gain speed for another velocity when the command comes, and
// the law that keeps the tool on the spot while it rotates asks a little more of them than they
// have; a joint has to go on through the position in which the elbow is stretched.
TEST_CASE("the calmest law is taken where the strictest one asks too much of the joints") {
  using Joints6 = Eigen::Vector<double, 6>;
  using Joints7 = Eigen::Vector<double, 7>;
  VelocityStart turning{
      .q = Joints7{-0.677296, -0.087807, 1.304371, -0.530426, -1.211377, -0.549727, -0.144389},
      .qd = Joints7{0.09212, -0.0751985, 0.173976, 0.0901885, 0.247959, -0.262761, -0.231305},
      .qdd = Joints7{2.297226, -1.084429, 1.670913, 1.338565, 1.452596, -4.212324, -3.705974},
      .during = 0.3,
      .fastest = ToolSpeeds{0.0, 0.518228}};
  CHECK(excess_of_command("pa10", turning, {0.0, 0.0, 0.0, 0.0769681, 0.0621357, -0.1657117}) <
        0.01);
  VelocityStart stretching{
      .q = Joints6{-1.136627, -0.641329, 0.0448865, 0.29983, -1.28818, -0.106856},
      .qd = Joints6{0.0259944, 0.0869406, -0.2055481, 0.1163999, 0.0248592, 0.0079122},
      .qdd = Joints6{0.410662, 1.752305, -4.035593, 2.248247, 0.392715, 0.125084},
      .during = 0.122,
      .fastest = ToolSpeeds{0.0262054, 0.0}};
  CHECK(excess_of_command("ur5", stretching,
                          {0.00018975, -0.00084621, -0.00044251, 0.0, 0.0, 0.0}) < 0.01);
}

// Found among other seeds: each joint comes to rest by itself, and the tool is calm, where it is
// not with all of them together; and an acceleration is reversed with nearly all of the jerk.
TEST_CASE("a stop that no usual law makes calm is made with all that the joints have") {
  using Joints6 = Eigen::Vector<double, 6>;
  VelocityStart alone{
      .q = Joints6{-0.03289247501559892, -0.2871692309910976, -0.24268437863815032,
                   0.15385641772572164, -0.004395830311996958, 0.24319187218654892},
      .qd = Joints6{3.9974393573033246e-17, 3.1508315498043576e-16, -4.567541492078131e-16,
                    -0.0017865560581910023, -2.8853872927295677e-06, 0.0017874598794103136},
      .qdd = Joints6{7.699336848848938e-12, 1.1162772895827715e-11, -1.4075042487334478e-11,
                     -0.7144914838913887, -0.001064234837589462, 0.7137633311903453},
      .during = 0.154,
      .fastest = ToolSpeeds{0, 0.0040179396083129398}};
  CHECK(excess_of_command("puma560", alone,
                          {0.0, 0.0, 0.0, -0.00406225453877477, -0.015100183385950136,
                           -0.014026279027556092}) < 0.01);
  VelocityStart quickly{
      .q = Joints6{-0.6726810279038038, -1.4799449109637774, 1.200685780783548,
                   -0.28395549293596684, -0.6718370283279207, 1.1829474244062772},
      .qd = Joints6{-0.10114464574601578, -0.1594091642182787, -0.29159420950793896,
                    -0.2483653974971105, 0.40570442840402765, 0.35294809790595577},
      .qdd = Joints6{-3.4239086198109114, 2.2993184696400695, -14.377957448250116,
                     -7.582021008384569, 10.621843877525999, 10.835241363443467},
      .during = 0.17899999999999999,
      .fastest = ToolSpeeds{0.37961013538859434, 0}};
  CHECK(excess_of_command("kr6", quickly,
                          {-0.028959994417325264, 0.0325171208627051, -0.34971410810950215, 0.0,
                           0.0, 0.0}) < 0.01);
}
