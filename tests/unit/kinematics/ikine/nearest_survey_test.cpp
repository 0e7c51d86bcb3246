// Goals at singular positions and next to them, for every kind of arm: the nearest joint values are
// taken (language reference, section 13.6). ARMLET_SURVEY=20000 ARMLET_SEED=1 runs it over so many
// goals of each arm.
#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/model/catalog.hpp"
#include "general_arm.hpp"
#include "nearest_search.hpp"
#include "sanitized.hpp"
#include "survey.hpp"

using namespace armlet;
using namespace armlet::nearest;

namespace {

constexpr int kUsual = kSanitized ? 2 : 20;

// Where joint `singular` is zero the arm is singular, and joint `free` can be chosen; without a
// free joint two solutions meet there. Without a singular joint the free one can be chosen
// anywhere.
struct Case {
  std::string name;
  IkMethod method;
  std::optional<int> free;
  std::optional<int> singular = {};
};

// Nothing, or up to 0.1 rad, all sizes alike.
double off_singular(Random& random) {
  if (random.below(3) == 0) return 0.0;
  return (random.below(2) == 0 ? 1.0 : -1.0) * std::pow(10.0, -random.uniform(1.0, 9.0));
}

// The least change: that to the joint values from which the goal was made, to those that rotating
// the free joint leads to where the goal leaves it free, and to what the closed form finds.
double least_change(const Robot& robot, const VectorXd& q, const VectorXd& seed,
                    std::optional<int> free, IkMethod method) {
  double least = change_of(robot, q, seed);
  if (free) least = std::min(least, Followed(robot, q, *free, seed).least());
  if (method == IkMethod::kNumeric) least = std::min(least, closed_form_change(robot, q, seed));
  return least;
}

void check_case(const Case& c) {
  CAPTURE(c.name);
  const Robot robot = *make_robot(c.name);
  Random random(survey_seed(70) + static_cast<std::uint64_t>(c.free.value_or(9)));
  Score score;
  const int count = survey_count(kUsual);
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    VectorXd q = on_limits(robot, random);
    double off = 0.0;
    if (c.singular) {
      off = off_singular(random);
      q[*c.singular] = off;
      if (!within_limits(robot, q, 0.0)) q[*c.singular] = -off;
    }
    const VectorXd seed = perturbed(robot, q, random);
    const int before = score.farther + score.missed;
    const std::optional<int> free = off == 0.0 ? c.free : std::nullopt;
    judge(robot, q, seed, least_change(robot, q, seed, free, c.method), c.method, score);
    if (score.farther + score.missed > before) {
      std::ostringstream text;
      text.precision(17);
      text << q.transpose() << "\nseed\n" << seed.transpose();
      MESSAGE("at " << off << " from singular, worst " << score.worst << ", q\n" << text.str());
    }
  }
  CHECK(score.missed == 0);
  CHECK(score.farther == 0);
  const std::string name = c.name + (c.method == IkMethod::kNumeric ? " by iteration" : "");
  MESSAGE(name << ": " << count << " goals, " << score.farther << " farther, " << score.missed
               << " missed, at most " << score.worst << " farther");
}

}  // namespace

TEST_CASE("survey of nearest solutions: closed forms of six joints and fewer") {
  for (const char* name : {"puma560", "irb120", "stanford", "pa10_6"})
    check_case({name, IkMethod::kAuto, 3, 4});
  check_case({"ur5", IkMethod::kAuto, 5, 4});
  check_case({"ur10", IkMethod::kAuto, 5, 4});
  check_case({"planar3", IkMethod::kAuto, {}, 1});
  check_case({"scara", IkMethod::kAuto, {}, 1});
}

TEST_CASE("survey of nearest solutions: closed forms of seven joints") {
  for (const char* name : {"pa10", "iiwa14", "arm7"}) check_case({name, IkMethod::kAuto, 2});
  check_case({"panda", IkMethod::kAuto, 6});
}

TEST_CASE("survey of nearest solutions: arms solved by iteration") {
  check_case({"puma560", IkMethod::kNumeric, 3, 4});
  check_case({"ur5", IkMethod::kNumeric, 5, 4});
  check_case({"planar3", IkMethod::kNumeric, {}, 1});
  check_case({"scara", IkMethod::kNumeric, {}, 1});
}

TEST_CASE("survey of nearest solutions: seven joints by iteration") {
  check_case({"pa10", IkMethod::kNumeric, 2});
  check_case({"iiwa14", IkMethod::kNumeric, 2});
  check_case({"arm7", IkMethod::kNumeric, 2});
  check_case({"panda", IkMethod::kNumeric, 6});
}

namespace {

// An arm without any structure, joint values at or next to singular ones if it has six joints, and
// a seed.
struct RandomCase {
  Robot robot;
  VectorXd q;
  VectorXd seed;
};

RandomCase random_case(Random& random, std::uint64_t joints) {
  Robot robot = general_arm(random, false, joints);
  VectorXd q = random_joints(robot, random);
  if (joints == 6) {
    const auto singular = singular_value(robot, q, 4);
    if (singular) q[4] = *singular + off_singular(random);
    q = clamp_to_limits(robot, q);
  }
  VectorXd seed = perturbed(robot, q, random);
  return {std::move(robot), std::move(q), std::move(seed)};
}

}  // namespace

TEST_CASE("survey of nearest solutions: random arms of six and seven joints") {
  Random random(survey_seed(71));
  Score six, seven;
  const int count = survey_count(kUsual);
  for (int k = 0; k < count; ++k) {
    CAPTURE(k);
    const bool is_seven = k % 2 == 0;
    const auto [robot, q, seed] = random_case(random, is_seven ? 7 : 6);
    Score& score = is_seven ? seven : six;
    const int before = score.farther + score.missed;
    const std::optional<int> free = is_seven ? std::optional(3) : std::nullopt;
    const double least = least_change(robot, q, seed, free, IkMethod::kAuto);
    judge(robot, q, seed, least, IkMethod::kAuto, score);
    if (score.farther + score.missed > before)
      MESSAGE(robot.n() << " joints, case " << k << ", worst " << score.worst);
  }
  CHECK(six.missed + seven.missed == 0);
  CHECK(six.farther + seven.farther == 0);
  MESSAGE("six joints: " << six.farther << " farther, " << six.missed << " missed; seven: "
                         << seven.farther << " farther, " << seven.missed << " missed");
}

// Found by the survey: two solutions that coincide and a third one 0.02 rad from them, and three
// within 0.006 rad, on one curve next to singular joint values.
TEST_CASE("three solutions between two points of a curve are all found") {
  Random random(1);
  for (int k = 0; k <= 737; ++k) {
    CAPTURE(k);
    const auto [robot, q, seed] = random_case(random, k % 2 == 0 ? 7 : 6);
    if (k != 541 && k != 737) continue;
    const Isometry3d goal = forward(robot, q);
    const auto all = solve_ik_all(robot, goal, {.seed = seed, .respect_limits = false}, 20);
    int near = 0;
    for (const VectorXd& other : all) {
      double apart = 0.0;
      for (int i = 0; i < robot.n(); ++i)
        apart = std::max(apart, std::abs(angle_difference(other[i], q[i])));
      near += apart < 0.03 ? 1 : 0;
    }
    CHECK(near == (k == 541 ? 3 : 2));
    Score score;
    judge(robot, q, seed, change_of(robot, q, seed), IkMethod::kAuto, score);
    CHECK(score.farther + score.missed == 0);
  }
}

// Found by the survey: wrists within 3e-9 rad of singular, of which rounding took a joint for
// another value; a joint that was left a revolution too far; and one put back onto its limit beside
// the values that meet the goal exactly.
TEST_CASE("next to singular values rounding does not decide which joint values are nearest") {
  struct Found {
    const char* name;
    std::vector<double> q, seed;
  };
  constexpr double kTurn = 2.0 * kPi;
  const Found cases[] = {
      {"ur5",
       {4.2798169596536457, -5.1851226421085936, -kTurn, -1.5712472063153626, 0.0, kTurn},
       {4.9540648064786321, -4.6269995982456589, 5.9845058933494588, 3.5719459877560205,
        3.028590879327993, -4.1927979553445613}},
      {"ur5",
       {-3.9130040666375323, kTurn, 3.1453155966565962, -2.3905900495892878,
        -1.1752505955503831e-09, -5.2586864450089212},
       {-3.6648037805967002, kTurn, 3.0347180021848139, -2.6755818484297205, -0.25979981945061048,
        -5.1254289906614146}},
      {"ur5",
       {1.2783579489270496, 1.1097382577162378, -3.4411817068170225, 1.3115884098324564,
        2.3616512571311296e-09, -kTurn},
       {1.2783579489270496, 1.1097382577162378, -3.4411817068170225, 1.4861213350318894,
        2.3616512571311296e-09, -kTurn}},
      {"ur5",
       {5.8926596238469262, 4.7888361993918274, -0.018094596124337059, -2.6065661337282,
        2.5657379308175729e-09, -0.76700397597049008},
       {5.4472118000374312, -4.4831410971327008, 5.3398826100403216, -5.0856960154634478,
        -0.31202390389689327, -1.0500626524386023}},
      {"scara",
       {-2.6179938779914944, -5.0127023647774087e-07, 0.04582595641475487, 5.1352014375463568},
       {-2.6179938779914944, -0.17453342646966943, 0.04582595641475487, 5.1352014375463568}},
  };
  for (const Found& found : cases) {
    const Robot robot = *make_robot(found.name);
    const VectorXd q = VectorXd::Map(found.q.data(), robot.n());
    const VectorXd seed = VectorXd::Map(found.seed.data(), robot.n());
    CAPTURE(q.transpose());
    Score score;
    judge(robot, q, seed, change_of(robot, q, seed), IkMethod::kAuto, score);
    CHECK(score.missed == 0);
    CHECK(score.farther == 0);
  }
}
