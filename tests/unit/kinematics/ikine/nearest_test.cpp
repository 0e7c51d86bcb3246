// Of the joint values that reach a goal the nearest ones are taken (ruling 53),
// against a dense search over the joint that the goal leaves free. The search
// has its own code: it fixes that joint and finds the others by division of
// what two joints share, or by Newton's method.
#include <doctest/doctest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "armlet/core/random.hpp"
#include "armlet/kinematics/closed_form.hpp"
#include "armlet/kinematics/ik.hpp"
#include "armlet/kinematics/jacobian.hpp"
#include "armlet/math/angles.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/catalog.hpp"
#include "random_arm.hpp"
#include "sanitized.hpp"

using namespace armlet;
using Eigen::Isometry3d;
using Eigen::VectorXd;

namespace {

constexpr int kScale = kSanitized ? 20 : 1;

// A joint at its copy inside the limits that is nearest to the seed; how far
// that is.
double nearest_copy(const Robot& robot, int i, double value, double seed) {
  double best = INFINITY;
  const int turns = robot.is_revolute(i) ? 3 : 0;
  for (int k = -turns; k <= turns; ++k) {
    const double copy = value + 2.0 * kPi * k;
    if (copy >= robot.lower()[i] - 1e-12 && copy <= robot.upper()[i] + 1e-12)
      best = std::min(best, std::abs(copy - seed));
  }
  return best;
}

double change_of(const Robot& robot, const VectorXd& q, const VectorXd& seed) {
  double change = 0.0;
  for (int i = 0; i < robot.n(); ++i)
    change = std::max(change, nearest_copy(robot, i, q[i], seed[i]));
  return change;
}

// The least value of a function of one variable: on a grid, then around its
// best point.
template <class Function>
double least_of(double from, double to, int steps, const Function& f) {
  const double h = (to - from) / steps;
  double best = INFINITY, at = from;
  for (int k = 0; k <= steps; ++k) {
    const double value = f(from + k * h);
    if (value < best) {
      best = value;
      at = from + k * h;
    }
  }
  double low = std::max(from, at - h), high = std::min(to, at + h);
  for (int k = 0; k < 60; ++k) {
    const double a = low + 0.382 * (high - low), b = high - 0.382 * (high - low);
    const double fa = f(a), fb = f(b);
    best = std::min({best, fa, fb});
    (fa <= fb ? high : low) = fa <= fb ? b : a;
  }
  return best;
}

// Joints a and b rotate about one line at q, the same way (sign 1) or against
// each other.
struct Pair {
  int a, b;
  double sign;
};

double least_of_pair(const Robot& robot, const Pair& pair, const VectorXd& q,
                     const VectorXd& seed) {
  double others = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    if (i != pair.a && i != pair.b)
      others = std::max(others, nearest_copy(robot, i, q[i], seed[i]));
  }
  return least_of(robot.lower()[pair.a], robot.upper()[pair.a], 400, [&](double t) {
    const double b = q[pair.b] + pair.sign * (q[pair.a] - t);
    return std::max(
        {others, std::abs(t - seed[pair.a]), nearest_copy(robot, pair.b, b, seed[pair.b])});
  });
}

// The other joints by Newton's method while one is turned on step by step from
// q.
class Followed {
 public:
  Followed(const Robot& robot, const VectorXd& q, int joint, const VectorXd& seed)
      : robot_(robot), goal_(forward(robot, q)), joint_(joint), seed_(seed), q_(q) {}

  double least() {
    constexpr int kSteps = 72;
    const double h = 2.0 * kPi / kSteps;
    double best = change_of(robot_, q_, seed_);
    VectorXd at = q_;
    for (const double way : {h, -h}) {
      VectorXd q = q_;
      for (int k = 0; k < kSteps / 2 && step(q, q[joint_] + way); ++k) {
        const double change = change_of(robot_, q, seed_);
        if (change >= best) continue;
        best = change;
        at = q;
      }
    }
    double width = h;
    for (int k = 0; k < 60; ++k) {  // downhill in ever smaller steps
      bool better = false;
      for (const double way : {width, -width}) {
        VectorXd q = at;
        if (!step(q, q[joint_] + way)) continue;
        const double change = change_of(robot_, q, seed_);
        if (change >= best) continue;
        best = change;
        at = q;
        better = true;
      }
      if (!better) width *= 0.6;
    }
    return best;
  }

 private:
  bool step(VectorXd& q, double value) const {
    q[joint_] = value;
    for (int k = 0; k < 8; ++k) {
      Jacobian J;
      const Isometry3d T = forward_and_jacobian(robot_, q, J);
      Vector6d e;
      e << goal_.translation() - T.translation(),
          rotation_log(goal_.linear() * T.linear().transpose());
      if (e.norm() < 1e-10) return true;
      J.col(joint_).setZero();
      Eigen::MatrixXd H = J.transpose() * J;
      H.diagonal().array() += 1e-13;
      H(joint_, joint_) = 1.0;
      const VectorXd more = H.ldlt().solve(J.transpose() * e);
      if (!(more.cwiseAbs().maxCoeff() < 0.5)) return false;
      q += more;
    }
    return false;
  }

  const Robot& robot_;
  Isometry3d goal_;
  int joint_;
  const VectorXd& seed_;
  VectorXd q_;
};

VectorXd perturbed(const Robot& robot, const VectorXd& q, Random& random) {
  VectorXd seed = q;
  switch (random.below(3)) {
    case 0:
      seed[static_cast<int>(random.below(static_cast<std::uint64_t>(robot.n())))] +=
          random.below(2) == 0 ? kPi / 18 : -kPi / 18;
      break;
    case 1:
      for (double& value : seed) value += random.uniform(-0.3, 0.3);
      break;
    default:
      seed = random_joints(robot, random);
  }
  return clamp_to_limits(robot, seed);
}

// Within the limits, every other time with a joint or two at theirs.
VectorXd on_limits(const Robot& robot, Random& random) {
  VectorXd q = random_joints(robot, random);
  for (int k = static_cast<int>(random.below(3)); k > 0; --k) {
    const int i = static_cast<int>(random.below(static_cast<std::uint64_t>(robot.n())));
    q[i] = random.below(2) == 0 ? robot.lower()[i] : robot.upper()[i];
  }
  return q;
}

struct Score {
  int farther = 0;
  int missed = 0;
  double worst = 0.0;
};

void judge(const Robot& robot, const VectorXd& q, const VectorXd& seed, double least,
           IkMethod method, Score& score) {
  const Isometry3d goal = forward(robot, q);
  const IkResult ik = solve_ik(robot, goal, {.seed = seed, .method = method});
  const bool good = ik.ok() && within_limits(robot, ik.q, 0.0) &&
                    (forward(robot, ik.q).translation() - goal.translation()).norm() < 1.001e-6 &&
                    angle_between(forward(robot, ik.q), goal) < 1.001e-6;
  score.missed += good ? 0 : 1;
  if (!good) return;
  const double more = (ik.q - seed).cwiseAbs().maxCoeff() - least;
  score.farther += more > 1e-6 ? 1 : 0;
  score.worst = std::max(score.worst, more);
}

Robot with_limits(RobotSpec spec, Random& random) {
  for (Joint& joint : spec.joints) {
    if (!joint.is_revolute()) {
      joint.lower = -0.5;
      joint.upper = 0.5;
      continue;
    }
    joint.lower = -random.uniform(1.0, 5.0);
    joint.upper = random.uniform(3.2, 5.0);
  }
  return Robot(spec);
}

Robot arm_of(std::initializer_list<DhRow> rows, Random& random, std::size_t slide = 99) {
  RobotSpec spec;
  for (const DhRow& row : rows) {
    Joint joint;
    if (spec.joints.size() == slide) joint.kind = JointKind::kPrismatic;
    joint.dh = row;
    spec.joints.push_back(joint);
  }
  return with_limits(std::move(spec), random);
}

// The change of the nearest solution that the closed form finds, which knows of other curves and
// branches than the one through q; infinite if it makes use of the tolerance.
double closed_form_change(const Robot& robot, const VectorXd& q, const VectorXd& seed) {
  const Isometry3d goal = forward(robot, q);
  const IkResult ik = solve_ik(robot, goal, {.seed = seed});
  if (!ik.ok()) return INFINITY;
  const Isometry3d T = forward(robot, ik.q);
  const bool exact =
      (T.translation() - goal.translation()).norm() < 1e-9 && angle_between(T, goal) < 1e-8;
  return exact ? (ik.q - seed).cwiseAbs().maxCoeff() : INFINITY;
}

void check_pairs(const Robot& robot, Pair pair, int joint, double value, int count,
                 Random& random) {
  Score score;
  for (int k = 0; k < count / kScale; ++k) {
    VectorXd q = on_limits(robot, random);
    q[joint] = value;
    VectorXd moved = q;
    moved[pair.a] += 0.3;
    moved[pair.b] -= 0.3 * pair.sign;
    REQUIRE((forward(robot, moved).matrix() - forward(robot, q).matrix()).norm() < 1e-9);
    const VectorXd seed = perturbed(robot, q, random);
    judge(robot, q, seed, least_of_pair(robot, pair, q, seed), IkMethod::kAuto, score);
  }
  CHECK(score.missed == 0);
  CHECK(score.farther == 0);
  CHECK(score.worst < 1e-6);
}

void check_followed(const Robot& robot, int joint, std::optional<int> zero, IkMethod method,
                    int count) {
  Random random(static_cast<std::uint64_t>(joint + 20));
  Score score;
  for (int k = 0; k < (count + kScale - 1) / kScale; ++k) {
    VectorXd q = on_limits(robot, random);
    if (zero) q[*zero] = 0.0;
    const VectorXd seed = perturbed(robot, q, random);
    double least = Followed(robot, q, joint, seed).least();
    if (method == IkMethod::kNumeric) least = std::min(least, closed_form_change(robot, q, seed));
    judge(robot, q, seed, least, method, score);
  }
  CHECK(score.missed == 0);
  CHECK(score.farther == 0);
  CHECK(score.worst < 1e-6);
}

}  // namespace

TEST_CASE("two joints about one line share their angle so that neither turns far") {
  Random random(53);
  for (const char* name : {"puma560", "irb120", "stanford", "pa10_6"}) {
    CAPTURE(name);
    check_pairs(*make_robot(name), {3, 5, 1.0}, 4, 0.0, 2'800, random);
  }
  constexpr double kRight = kPi / 2;
  for (int k = 0; k < 5; ++k) {
    // Equal links folded onto the first of the parallel axes.
    CHECK_NOTHROW(check_pairs(arm_of({{0, 0, .3, 0}, {0, 0, .3, 0}, {0, 0, .1, 0}}, random),
                              {0, 2, 1.0}, 1, kPi, 500, random));
    check_pairs(arm_of({{0, .2, .3, 0}, {0, 0, .3, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}}, random, 2),
                {0, 3, 1.0}, 1, kPi, 500, random);
    check_pairs(arm_of({{0, .2, 0, kRight},
                        {0, 0, .4, 0},
                        {0, 0, .4, 0},
                        {0, .1, 0, kRight},
                        {0, .1, 0, -kRight},
                        {0, .1, 0, 0}},
                       random),
                {1, 3, 1.0}, 2, kPi, 500, random);
  }
}

TEST_CASE(
    "a joint that the goal leaves free takes the value from which no "
    "joint turns far") {
  check_followed(*make_robot("ur5"), 5, 4, IkMethod::kAuto, 700);
  check_followed(*make_robot("ur10"), 5, 4, IkMethod::kAuto, 300);
  for (const char* name : {"pa10", "iiwa14", "arm7"}) {
    CAPTURE(name);
    check_followed(*make_robot(name), 2, {}, IkMethod::kAuto, 300);
  }
  check_followed(*make_robot("panda"), 6, {}, IkMethod::kAuto, 400);
}

TEST_CASE("arms solved by iteration choose their free joints too") {
  check_followed(*make_robot("puma560"), 3, 4, IkMethod::kNumeric, 200);
  check_followed(*make_robot("ur5"), 5, 4, IkMethod::kNumeric, 300);
  check_followed(*make_robot("pa10"), 2, {}, IkMethod::kNumeric, 200);
  for (const char* name : {"iiwa14", "arm7"}) {
    CAPTURE(name);
    check_followed(*make_robot(name), 2, {}, IkMethod::kNumeric, 60);
  }
  check_followed(*make_robot("panda"), 6, {}, IkMethod::kNumeric, 60);
}

TEST_CASE("where the wrist lies on the first axis, that joint is free") {
  const Robot robot = *make_robot("pa10_6");
  Random random(54);
  Score score;
  for (int k = 0; k < 100 / kScale; ++k) {
    VectorXd q = on_limits(robot, random);
    q[0] = 0.0;
    const auto aside = [&](double q2) {
      q[1] = q2;
      return link_frame(robot, q, 4).translation().x();
    };
    double low = -1.0, high = 1.0;
    if (aside(low) * aside(high) > 0.0) continue;
    for (int round = 0; round < 80; ++round) {
      const double middle = 0.5 * (low + high);
      (aside(low) * aside(middle) <= 0.0 ? high : low) = middle;
    }
    aside(low);
    q[0] = random.uniform(robot.lower()[0], robot.upper()[0]);
    if (!within_limits(robot, q)) continue;
    const VectorXd seed = perturbed(robot, q, random);
    judge(robot, q, seed, Followed(robot, q, 0, seed).least(), IkMethod::kAuto, score);
  }
  CHECK(score.missed == 0);
  CHECK(score.farther == 0);
}

TEST_CASE("a goal one joint and 10 deg away is reached with a change of 10 deg") {
  // The partner of the free joint stands at its limit.
  const Robot robot = *make_robot("puma560");
  VectorXd seed = VectorXd::Zero(6);
  seed << 0.2, -0.7, 1.0, robot.upper()[3], 0.0, 0.3;
  VectorXd q = seed;
  q[3] -= kPi / 18;
  const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = seed});
  REQUIRE(ik.ok());
  CHECK((ik.q - seed).cwiseAbs().maxCoeff() <= kPi / 18 + 1e-6);
}

// Found among other seeds: feasible only where two joints stand at their limits, a branch that
// exists for a twentieth of a turn of the arm, and a change beyond half a revolution.
TEST_CASE("narrow intervals of the free joint are found") {
  const auto more = [](const char* name, int joint, IkMethod method, std::vector<double> at,
                       std::vector<double> from) {
    const Robot robot = *make_robot(name);
    const VectorXd q = VectorXd::Map(at.data(), robot.n());
    const VectorXd seed = VectorXd::Map(from.data(), robot.n());
    const double least = Followed(robot, q, joint, seed).least();
    const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = seed, .method = method});
    REQUIRE(ik.ok());
    return (ik.q - seed).cwiseAbs().maxCoeff() - least;
  };
  CHECK(more("iiwa14", 2, IkMethod::kAuto,
             {1.9582263870882821, -1.9460089232749855, 2.9670597283903604, -1.9074804995667263,
              0.6183012145923561, 2.0943951023931953, -1.597064456329039},
             {2.2543269976557481, 1.2170633670100766, 1.9318537193852992, -1.2880275026132879,
              1.4290135686662362, 1.9816725253582317, 0.92143563459606881}) < 1e-6);
  CHECK(more("panda", 6, IkMethod::kAuto,
             {1.9204148485504446, -0.68400973988925773, -2.6098847722583249, -0.0698,
              -0.018224207307417917, 2.4111643014265822, -1.4496287682590918},
             {2.0484235220566274, -0.43807061127159536, -2.4770081986112698, -0.0698,
              -0.11084841868855452, 2.2315141424748126, -1.6863865184757132}) < 1e-6);
  CHECK(more("ur5", 5, IkMethod::kNumeric,
             {-6.2831853071795862, 6.2831853071795862, -0.37065572313992767, -2.7535415912167438,
              0.0, 2.5260442902676647},
             {0.12854782219917826, 5.4806764553118263, -2.6733954532785487, 2.7794666352263953,
              0.36004574372518849, -1.8773400119867558}) < 1e-6);
}

// Found among other seeds: the curve of solutions is a loop of 0.05 rad, with the elbow stretched
// all but exactly; a curve that one start in fifty leads to; and one next to it, across the
// singularity of the stretched elbow.
TEST_CASE("every curve of solutions is found") {
  const auto change = [](const char* name, IkMethod method, std::vector<double> at,
                         std::vector<double> from) {
    const Robot robot = *make_robot(name);
    const VectorXd q = VectorXd::Map(at.data(), robot.n());
    const VectorXd seed = VectorXd::Map(from.data(), robot.n());
    const IkResult ik = solve_ik(robot, forward(robot, q), {.seed = seed, .method = method});
    REQUIRE(ik.ok());
    return (ik.q - seed).cwiseAbs().maxCoeff();
  };
  CHECK(change("ur5", IkMethod::kAuto,
               {6.2831853071795862, 3.8797185735425419, -6.2831853071795862, -1.5596327035900588,
                0.0, 1.541632406577917},
               {6.2831853071795862, 4.0542514987419747, -6.2831853071795862, -1.5596327035900588,
                0.0, 1.541632406577917}) < 0.1722156);
  const std::vector<double> panda = {-2.1579294272902554, 1.0390037555650342,  -2.0418572617523965,
                                     -1.8892086374610544, 0.82837733322015028, 3.7525,
                                     -1.1556947653720862};
  const std::vector<double> from_panda = {
      -0.012149515506323372, 1.5694019952070652, -1.1789025840873089, -2.7027276816649843,
      0.95274820240900793,   1.2564965827424406, 2.8117387334863655};
  CHECK(change("panda", IkMethod::kNumeric, panda, from_panda) ==
        doctest::Approx(change("panda", IkMethod::kAuto, panda, from_panda)).epsilon(4e-7));
  const std::vector<double> pa10 = {0.16589456497650268,  0.51274368526277292, 0.61160221279962368,
                                    -0.32111914262192487, 0.11768350150844054, -0.5568526511821652,
                                    -4.8070950578784437};
  const std::vector<double> from_pa10 = {
      -1.004574098735036,   -0.7769555202643933, -2.2338998951331535, -1.2518509679725198,
      -0.73892044541774826, -1.862574759041226,  -4.5924968524757368};
  CHECK(change("pa10", IkMethod::kNumeric, pa10, from_pa10) ==
        doctest::Approx(change("pa10", IkMethod::kAuto, pa10, from_pa10)).epsilon(4e-7));
}

TEST_CASE("a joint on its limit that was turned and turned back is not beyond it") {
  const Robot robot = *make_robot("puma560");
  VectorXd q(6), seed(6);
  q << robot.upper()[0], 1.5933786453329803, 0.64724057344995423, -2.7624455915188948, 0.0,
      3.4374467604670551;
  seed << -1.2801873951084257, 0.069790458803469013, -0.27626725178605671, 1.7465062580793829,
      0.55398911362123759, -0.43961435937310878;
  const IkResult ik =
      solve_ik(robot, forward(robot, q), {.seed = seed, .method = IkMethod::kNumeric});
  REQUIRE(ik.ok());
  CHECK(within_limits(robot, ik.q, 0.0));
  const Robot pa10 = *make_robot("pa10");
  VectorXd q_7(7), seed_7(7);
  q_7 << 1.093568433889041, -0.57779336405408088, -2.0487588627265194, 0.059211104151368765,
      -3.0190133222849456, -2.8797932657906435, -6.2831853071795862;
  seed_7 << 1.1473940958048807, -0.50204266731062575, -2.0315301354462862, 0.1739269171450587,
      -2.8962423804442912, -2.8482401906146535, -6.2831853071795862;
  const IkResult turned =
      solve_ik(pa10, forward(pa10, q_7), {.seed = seed_7, .method = IkMethod::kNumeric});
  REQUIRE(turned.ok());
  CHECK(within_limits(pa10, turned.q, 0.0));
}

TEST_CASE("every branch is listed once") {
  Random random(55);
  int same = 0;
  for (int k = 0; k < 3'000 / kScale; ++k) {
    RobotSpec spec;
    for (int i = 0; i < 1 + k % 3; ++i) {
      Joint joint;
      joint.dh = {0, 0.3 * static_cast<double>(random.below(2)),
                  0.3 * static_cast<double>(random.below(2)),
                  kPi / 2 * (static_cast<double>(random.below(4)) - 1.0)};
      spec.joints.push_back(joint);
    }
    const Robot robot(spec);
    if (!closed_form(robot).exists()) continue;
    VectorXd q = random_joints(robot, random);
    for (double& value : q)
      value = random.below(2) == 0 ? value : kPi / 2 * static_cast<double>(random.below(3));
    q = clamp_to_limits(robot, q);
    for (const bool respect : {true, false}) {
      const auto all = solve_ik_all(robot, forward(robot, q),
                                    {.seed = random_joints(robot, random),
                                     .task = IkTask::kPosition,
                                     .respect_limits = respect});
      for (std::size_t a = 0; a < all.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          double most = 0.0;
          for (int i = 0; i < robot.n(); ++i)
            most = std::max(most, std::abs(angle_difference(all[a][i], all[b][i])));
          same += most < 1e-6 ? 1 : 0;
        }
      }
    }
  }
  CHECK(same == 0);
}
