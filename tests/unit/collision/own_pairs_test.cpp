#include "armlet/collision/own_pairs.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d random_vector(Random& random, double most) {
  return {random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most)};
}

LinkSolid random_box(Random& random) {
  LinkSolid box{.size = random_vector(random, 0.1) + Vector3d::Constant(0.15)};
  box.T_link_solid.translation() = random_vector(random, 0.15);
  box.T_link_solid.linear() =
      Eigen::AngleAxisd(random.uniform(0.0, 3.0), random_vector(random, 1.0).normalized())
          .toRotationMatrix();
  return box;
}

// Of four to six joints, with two boxes on each link, a plate as base, and links without a body.
RobotSpec random_arm(Random& random, DhConvention convention) {
  RobotSpec spec{.convention = convention};
  const int n = 4 + static_cast<int>(random.uniform(0.0, 3.0));
  for (int i = 0; i < n; ++i) {
    Joint joint;
    joint.dh = {random.uniform(-1.0, 1.0), random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2),
                random.uniform(-2.0, 2.0)};
    joint.lower = random.uniform(-2.5, -0.2);
    joint.upper = random.uniform(0.2, 2.5);
    spec.joints.push_back(joint);
    Link link;
    const int boxes = static_cast<int>(random.uniform(0.0, 3.0));
    for (int k = 0; k < boxes; ++k) link.solids.push_back(random_box(random));
    // A point far below: links without one would get bodies from the table.
    LinkSolid nothing{.kind = LinkSolidKind::kSphere, .size = {1e-4, 0.0, 0.0}};
    nothing.use = LinkSolidUse::kPicture;
    link.solids.push_back(nothing);
    spec.links.push_back(std::move(link));
  }
  spec.base.solids = {random_box(random)};
  return spec;
}

// How often bodies of two links overlap in positions of another seed, placed and compared without
// the code under test.
double share_of_overlaps(const Robot& robot, LinkPair links, Random& random, int positions) {
  const auto placed = [&](int link, const VectorXd& q) {
    std::vector<Solid> solids;
    for (const LinkSolid& each : robot.body(link).solids) {
      if (each.use == LinkSolidUse::kPicture) continue;
      Solid solid = solid_of(Shape(Box{each.size}));
      solid.T = (link == 0 ? robot.T_world_base() : link_frame(robot, q, link)) * each.T_link_solid;
      solids.push_back(solid);
    }
    return solids;
  };
  int overlaps = 0;
  for (int k = 0; k < positions; ++k) {
    VectorXd q(robot.n());
    for (int i = 0; i < robot.n(); ++i) q[i] = random.uniform(robot.lower()[i], robot.upper()[i]);
    bool met = false;
    for (const Solid& a : placed(links.first, q)) {
      for (const Solid& b : placed(links.second, q)) met = met || gap_between(a, b).distance < 0.0;
    }
    if (met) ++overlaps;
  }
  return static_cast<double>(overlaps) / positions;
}

bool has_bodies(const Robot& robot, int link) {
  return std::ranges::any_of(robot.body(link).solids, [](const LinkSolid& each) {
    return each.use != LinkSolidUse::kPicture;
  });
}

std::set<LinkPair> compared_links(const Robot& robot) {
  std::set<LinkPair> found;
  const auto& bodies = robot.derived<ArmSolids>().slim();
  for (const auto& [a, b] : robot.derived<OwnPairs>().pairs())
    found.emplace(bodies[static_cast<std::size_t>(a)].frame,
                  bodies[static_cast<std::size_t>(b)].frame);
  return found;
}

}  // namespace

TEST_CASE("only neighbours and links that overlap nearly everywhere are exempt: random arms") {
  Random random(2), others(77);
  int exempt = 0, compared = 0, at_home = 0;
  for (int round = 0; round < 40; ++round) {
    const Robot robot(
        random_arm(random, round % 2 == 0 ? DhConvention::kStandard : DhConvention::kModified));
    CAPTURE(round);
    std::map<LinkPair, ExemptPair> listed;
    for (const ExemptPair& each : robot.derived<OwnPairs>().exempt()) {
      CHECK(listed.emplace(each.links, each).second);
      CHECK(each.whole);
    }
    const std::set<LinkPair> checked = compared_links(robot);
    for (int a = 1; a <= robot.n(); ++a) {
      for (int b = 0; b < a; ++b) {
        const LinkPair links{a, b};
        if (!has_bodies(robot, a) || !has_bodies(robot, b)) {
          CHECK_FALSE(checked.contains(links));
          continue;
        }
        bool is_adjacent = true;
        for (int k = b + 1; k < a; ++k) is_adjacent = is_adjacent && !has_bodies(robot, k);
        CAPTURE(a);
        CAPTURE(b);
        CHECK(checked.contains(links) != listed.contains(links));
        if (is_adjacent) {
          CHECK(listed.at(links).reason == ExemptReason::kAdjacent);
          continue;
        }
        const double share = share_of_overlaps(robot, links, others, 2000);
        if (std::abs(share - OwnPairs::kNearlyAll) < 0.02) continue;  // 4 sigma of 2000 positions
        CHECK(listed.contains(links) == (share > OwnPairs::kNearlyAll));
        if (listed.contains(links)) {
          ++exempt;
          CHECK(listed.at(links).reason == ExemptReason::kOverlap);
          CHECK(listed.at(links).share == doctest::Approx(share).epsilon(0.02));
        } else {
          ++compared;
          if (share > 0.3) ++at_home;
        }
      }
    }
  }
  MESSAGE("exempt " << exempt << ", compared " << compared << ", of these often in each other "
                    << at_home);
  CHECK(exempt > 0);
  CHECK(compared > 100);
  CHECK(at_home > 5);
}

TEST_CASE("a pair that is named is exempt, or compared, whatever else holds") {
  Random random(9);
  RobotSpec spec = random_arm(random, DhConvention::kModified);
  for (Link& link : spec.links) link.solids = {random_box(random)};
  const Robot plain{RobotSpec(spec)};
  REQUIRE(compared_links(plain).contains({3, 0}));
  REQUIRE_FALSE(compared_links(plain).contains({2, 1}));
  spec.allow = {{3, 0}};
  spec.watch = {{2, 1}};
  const Robot named(std::move(spec));
  CHECK_FALSE(compared_links(named).contains({3, 0}));
  CHECK(compared_links(named).contains({2, 1}));
  const auto& exempt = named.derived<OwnPairs>().exempt();
  CHECK(std::ranges::any_of(exempt, [](const ExemptPair& each) {
    return each.links == LinkPair(3, 0) && each.reason == ExemptReason::kAllowed;
  }));
  RobotSpec wrong = plain.spec();
  wrong.allow = {{1, 1}};
  CHECK_THROWS_AS(Robot(std::move(wrong)), ArgumentError);
}

TEST_CASE("pairs are worked out once for copies that differ in load, name and acceleration") {
  const auto robot = make_robot("ur5");
  const OwnPairs& own = robot->derived<OwnPairs>();
  CHECK(&robot->with_payload({.mass = 1.0}).derived<OwnPairs>() == &own);
  CHECK(&robot->with_name("other").derived<OwnPairs>() == &own);
  CHECK(&robot->with_acceleration(0.5).derived<OwnPairs>() == &own);
  const Robot narrow = robot->with_limits(0.5 * robot->lower(), 0.5 * robot->upper());
  CHECK(&narrow.derived<OwnPairs>() != &own);
  CHECK(OwnPairs(*robot).pairs() == own.pairs());
}

TEST_CASE("bodies from a table: neighbours never, and no arm of the catalogue starts in itself") {
  for (const std::string_view name : catalog_names()) {
    const std::shared_ptr<const Robot> robot = make_robot(name);
    CAPTURE(name);
    const auto& bodies = robot->derived<ArmSolids>().slim();
    for (const auto& [first, second] : robot->derived<OwnPairs>().pairs()) {
      const ArmSolid& a = bodies[static_cast<std::size_t>(first)];
      const ArmSolid& b = bodies[static_cast<std::size_t>(second)];
      CHECK(a.frame > b.frame + 1);
      Solid one = a.solid, other = b.solid;
      one.T = link_frame(*robot, robot->home(), a.frame) * a.solid.T;
      other.T = link_frame(*robot, robot->home(), b.frame) * b.solid.T;
      CAPTURE(a.frame);
      CAPTURE(b.frame);
      CHECK(gap_between(one, other).distance > -1e-4);
    }
  }
  CHECK_FALSE(make_robot("ur5")->derived<OwnPairs>().pairs().empty());
}

TEST_CASE("links are found by number and by the names of a description") {
  RobotSpec spec = make_robot("planar2")->spec();
  spec.links.resize(2);
  spec.base.names = {"world", "table"};
  spec.links[1].names = {"forearm", "camera"};
  const Robot robot(std::move(spec));
  CHECK(link_of_name(robot, "base") == 0);
  CHECK(link_of_name(robot, "table") == 0);
  CHECK(link_of_name(robot, "link 1") == 1);
  CHECK(link_of_name(robot, "camera") == 2);
  CHECK(link_of_name(robot, "link 3") == -1);
  CHECK(link_text(robot, 0) == "the base (`world`)");
  CHECK(link_text(robot, 1) == "link 1");
  CHECK(link_text(robot, 2) == "link 2 (`forearm`)");
}

}  // namespace armlet
