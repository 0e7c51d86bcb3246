#include "armlet/world/world.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"

using namespace armlet;

namespace {

Object at(std::string name, Shape shape, double x, double y, double z) {
  Object object{.name = std::move(name), .shape = shape};
  object.T_world_obj = make_translation({x, y, z});
  return object;
}

const Shape kCube = Box{{0.04, 0.04, 0.04}};

World table_world() {
  World world(0.0);
  Object table = at("table", Box{{1.0, 1.0, 0.22}}, 0.0, 0.0, 0.11);
  table.fixed = true;
  world.insert(table);
  return world;
}

}  // namespace

TEST_CASE("objects keep the order of insertion and their names are unique") {
  World world;
  world.insert(at("b", kCube, 0.0, 0.0, 0.0));
  world.insert(at("a", kCube, 0.0, 0.0, 0.0));
  CHECK(world.names() == std::vector<std::string>{"b", "a"});
  CHECK_THROWS_AS((void)world.insert(at("a", kCube, 1.0, 0.0, 0.0)), ArgumentError);
  world.remove("b");
  CHECK(world.names() == std::vector<std::string>{"a"});
  CHECK(world.find("b") == nullptr);
  CHECK_THROWS_AS(world.remove("b"), ArgumentError);
}

TEST_CASE("a mistyped name is answered with the most similar one") {
  World world;
  world.insert(at("cube", kCube, 0.0, 0.0, 0.0));
  world.insert(at("cylinder", kCube, 0.0, 0.0, 0.0));
  CHECK(world.similar_name("cubo") == "cube");
  CHECK(world.similar_name("cilynder") == "cylinder");
  CHECK_FALSE(world.similar_name("table").has_value());
  CHECK_THROWS_WITH_AS((void)world.at("cub"), "There is no object \"cub\"; did you mean \"cube\"?",
                       ArgumentError);
}

TEST_CASE("a pose that is not one is refused and rounding is cleaned") {
  World world;
  world.insert(at("cube", kCube, 0.0, 0.0, 0.0));
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() *= 1.0 + 1e-8;
  world.set_pose("cube", T);
  const Eigen::Matrix3d R = world.at("cube").T_world_obj.linear();
  CHECK((R.transpose() * R).isIdentity(1e-15));
  T.linear() = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  CHECK_THROWS_AS(world.set_pose("cube", T), ArgumentError);
}

TEST_CASE("a carried body has the same pose in the gripper after a million steps, bit by bit") {
  World world;
  world.insert(at("cube", kCube, 0.3, 0.1, 0.2));
  const Eigen::Isometry3d T_start = pose_from_rpy({0.3, 0.1, 0.25}, {3.0, 0.2, 0.4});
  world.attach("cube", 0, T_start);
  const Eigen::Isometry3d T_carrier_obj = world.attachment("cube")->T_carrier_obj;
  Eigen::Isometry3d T_world_gripper;
  for (int k = 0; k < 1000000; ++k) {
    T_world_gripper = T_start;
    T_world_gripper.translation().x() += 1e-7 * k;
    world.move_carried(0, T_world_gripper);
  }
  CHECK(world.attachment("cube")->T_carrier_obj.matrix() == T_carrier_obj.matrix());
  CHECK(world.at("cube").T_world_obj.matrix() == (T_world_gripper * T_carrier_obj).matrix());
  CHECK(world.at("cube").T_world_obj.translation().x() ==
        doctest::Approx(0.3999999).epsilon(1e-12));
}

TEST_CASE("only the carrier that holds a body moves it, and letting go leaves it in place") {
  World world;
  world.insert(at("cube", kCube, 0.0, 0.0, 0.5));
  world.attach("cube", 1, Eigen::Isometry3d::Identity());
  CHECK(world.carried_by(1) == "cube");
  CHECK(world.carried_by(0).empty());
  world.move_carried(0, make_translation({1.0, 0.0, 0.0}));
  CHECK(world.at("cube").T_world_obj.translation().x() == 0.0);
  world.move_carried(1, make_translation({0.2, 0.0, 0.0}));
  world.detach("cube");
  world.move_carried(1, make_translation({0.4, 0.0, 0.0}));
  CHECK(world.at("cube").T_world_obj.translation().x() == 0.2);
  CHECK(world.carried_by(1).empty());
}

TEST_CASE("upright bodies fall onto faces by the exact height") {
  for (const Shape& shape :
       {Shape(Box{{0.04, 0.04, 0.06}}), Shape(Cylinder{0.02, 0.06}), Shape(Sphere{0.03})}) {
    World world = table_world();
    world.insert(at("thing", shape, 0.3, 0.2, 0.8));
    const Drop drop = world.drop("thing");
    CHECK(drop.support == "table");
    CHECK(drop.distance == doctest::Approx(0.55).epsilon(1e-14));
    CHECK(world.at("thing").T_world_obj.translation().z() == doctest::Approx(0.25).epsilon(1e-14));
    CHECK(world.resting_on("thing") == "table");
  }
}

TEST_CASE("beside the table things fall to the floor, and stay in the air without one") {
  World world = table_world();
  world.insert(at("cube", kCube, 0.6, 0.0, 0.5));
  CHECK(world.drop("cube").support == "floor");
  CHECK(world.at("cube").T_world_obj.translation().z() == doctest::Approx(0.02).epsilon(1e-14));
  World empty;
  empty.insert(at("cube", kCube, 0.0, 0.0, 0.5));
  CHECK(empty.drop("cube").support.empty());
  CHECK(empty.at("cube").T_world_obj.translation().z() == 0.5);
}

TEST_CASE("bodies stack, and the highest surface below holds") {
  World world = table_world();
  world.insert(at("one", kCube, 0.1, 0.1, 0.24));
  world.insert(at("two", kCube, 0.13, 0.1, 0.6));
  CHECK(world.drop("two").support == "one");
  CHECK(world.at("two").T_world_obj.translation().z() == doctest::Approx(0.28).epsilon(1e-14));
  // Released below a body, a third one falls on the table and not up.
  world.insert(at("three", kCube, 0.25, 0.1, 0.5));
  world.insert(at("roof", kCube, 0.25, 0.1, 0.9));
  CHECK(world.drop("three").support == "table");
}

TEST_CASE("sides that touch do not hold") {
  World world = table_world();
  world.insert(at("one", kCube, 0.0, 0.0, 0.24));
  world.insert(at("two", kCube, 0.04, 0.0, 0.5));
  CHECK(world.drop("two").support == "table");
  world.insert(at("three", Cylinder{0.02, 0.04}, 0.0, 0.04, 0.5));
  CHECK(world.drop("three").support == "table");
  world.insert(at("ball", Sphere{0.02}, 0.0, -0.04, 0.5));
  CHECK(world.drop("ball").support == "table");
}

TEST_CASE("rotated rectangles and discs overlap only where they really do") {
  World world = table_world();
  Object turned = at("turned", kCube, 0.0, 0.0, 0.24);
  turned.T_world_obj.linear() = Eigen::AngleAxisd(M_PI / 4, Eigen::Vector3d::UnitZ()).matrix();
  world.insert(turned);
  // The corner of the rotated square reaches 28.28 mm along x, so squares overlap up to 48.28 mm.
  world.insert(at("touches", kCube, 0.0482, 0.0, 0.5));
  CHECK(world.drop("touches").support == "turned");
  world.remove("touches");
  world.insert(at("misses", kCube, 0.0484, 0.0, 0.5));
  CHECK(world.drop("misses").support == "table");
  // Along the diagonal its side is 20 mm away: a disc of 20 mm passes beyond 40 mm.
  const double d = 0.0401 / std::sqrt(2.0);
  world.insert(at("disc", Cylinder{0.02, 0.04}, -d, -d, 0.5));
  CHECK(world.drop("disc").support == "table");
}

TEST_CASE("spheres meet edges and spheres by Pythagoras") {
  World world = table_world();
  world.insert(at("box", kCube, 0.0, 0.0, 0.24));
  world.insert(at("ball", Sphere{0.05}, 0.05, 0.0, 0.9));
  CHECK(world.drop("ball").support == "box");
  // 30 mm beside the edge with radius 50 mm: the centre is 40 mm above the top.
  CHECK(world.at("ball").T_world_obj.translation().z() == doctest::Approx(0.30).epsilon(1e-13));
  world.insert(at("small", Sphere{0.01}, 0.05 + 0.036, 0.0, 0.9));
  CHECK(world.drop("small").support == "ball");
  CHECK(world.at("small").T_world_obj.translation().z() == doctest::Approx(0.348).epsilon(1e-13));
}

TEST_CASE("lying bodies fall onto their sides") {
  World world = table_world();
  Object rod = at("rod", Cylinder{0.01, 0.1}, 0.0, 0.0, 0.5);
  rod.T_world_obj.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitY()).matrix();
  world.insert(rod);
  world.drop("rod");
  CHECK(world.at("rod").T_world_obj.translation().z() == doctest::Approx(0.23).epsilon(1e-13));
  Object brick = at("brick", Box{{0.02, 0.04, 0.08}}, 0.2, 0.2, 0.5);
  brick.T_world_obj.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()).matrix();
  world.insert(brick);
  world.drop("brick");
  CHECK(world.at("brick").T_world_obj.translation().z() == doctest::Approx(0.24).epsilon(1e-13));
  // Leaning by 45 degrees, its bounding box counts.
  brick.T_world_obj = pose_from_rpy({-0.2, 0.2, 0.5}, {M_PI / 4, 0.0, 0.0});
  brick.name = "leaning";
  world.insert(brick);
  world.drop("leaning");
  CHECK(world.at("leaning").T_world_obj.translation().z() ==
        doctest::Approx(0.22 + 0.06 / std::sqrt(2.0)).epsilon(1e-13));
}

TEST_CASE("cones and planes fall and carry; a cone counts as the cylinder around it") {
  World world = table_world();
  world.insert(at("cone", Cone{0.03, 0.08}, 0.3, 0.2, 0.8));
  CHECK(world.drop("cone").support == "table");
  CHECK(world.at("cone").T_world_obj.translation().z() == doctest::Approx(0.26).epsilon(1e-14));
  world.insert(at("lid", kCube, 0.32, 0.2, 0.8));
  CHECK(world.drop("lid").support == "cone");
  CHECK(world.at("lid").T_world_obj.translation().z() == doctest::Approx(0.32).epsilon(1e-14));
  world.insert(at("sheet", Plane{{0.2, 0.1}}, -0.3, 0.2, 0.8));
  CHECK(world.drop("sheet").support == "table");
  CHECK(world.at("sheet").T_world_obj.translation().z() == doctest::Approx(0.22).epsilon(1e-14));
  world.insert(at("on it", kCube, -0.3, 0.2, 0.5));
  CHECK(world.drop("on it").support == "sheet");
  CHECK(world.at("on it").T_world_obj.translation().z() == doctest::Approx(0.24).epsilon(1e-14));
  // Upright it is as high as it is long, and as thin as a line.
  Object upright = at("upright", Plane{{0.2, 0.1}}, 0.0, -0.2, 0.8);
  upright.T_world_obj.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()).matrix();
  world.insert(upright);
  CHECK(world.drop("upright").support == "table");
  CHECK(world.at("upright").T_world_obj.translation().z() == doctest::Approx(0.27).epsilon(1e-14));
}

TEST_CASE("resting means within two millimetres of a surface") {
  World world = table_world();
  world.insert(at("cube", kCube, 0.0, 0.0, 0.2419));
  CHECK(world.resting_on("cube") == "table");
  world.set_pose("cube", make_translation({0.0, 0.0, 0.2381}));
  CHECK(world.resting_on("cube") == "table");
  world.set_pose("cube", make_translation({0.0, 0.0, 0.2421}));
  CHECK(world.resting_on("cube").empty());
}

TEST_CASE("what falls onto a carried body travels with it") {
  World world = table_world();
  world.insert(at("held", kCube, 0.0, 0.0, 0.4));
  world.insert(at("cube", kCube, 0.0, 0.0, 0.5));
  world.attach("held", 0, Eigen::Isometry3d::Identity());
  CHECK_FALSE(world.attachment("cube").has_value());
  CHECK(world.drop("cube").support == "held");
  CHECK(world.attachment("cube")->on == "held");
  CHECK(world.carried_by(0) == "held");
  world.move_carried(0, make_pose(rot_z(1.0), {0.1, 0.2, 0.3}));
  const Eigen::Isometry3d T = world.at("held").T_world_obj.inverse() * world.at("cube").T_world_obj;
  CHECK((T.matrix() - make_translation({0.0, 0.0, 0.04}).matrix()).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("a stack travels with its lowest body and is let go with it") {
  Random random(61);
  for (int k = 0; k < 200; ++k) {
    World world = table_world();
    const int height = 1 + static_cast<int>(random.below(5));
    std::vector<std::string> names;
    double z = 0.22;
    for (int i = 0; i < height; ++i) {
      const double h = random.uniform(0.02, 0.06);
      names.push_back("b" + std::to_string(i));
      world.insert(at(names.back(), Box{{0.1, 0.1, h}}, random.uniform(-0.02, 0.02),
                      random.uniform(-0.02, 0.02), z + 0.5 * h));
      z += h;
    }
    // A gripper takes one of them: those above travel, those below stay.
    const auto taken = random.below(static_cast<std::uint64_t>(height));
    std::vector<Eigen::Isometry3d> before;
    for (const std::string& name : names) before.push_back(world.at(name).T_world_obj);
    const Eigen::Isometry3d T_0 = pose_from_rpy({0.1, 0.2, 0.9}, {0.3, 0.2, 0.1});
    world.attach(names[taken], 3, T_0);
    const Eigen::Isometry3d T_1 =
        pose_from_rpy({0.4, -0.2, 0.95}, {0.3, 0.2, random.uniform(-3, 3)});
    world.move_carried(3, T_1);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Eigen::Isometry3d moved = i < taken ? before[i] : T_1 * T_0.inverse() * before[i];
      CHECK((world.at(names[i]).T_world_obj.matrix() - moved.matrix()).cwiseAbs().maxCoeff() <
            1e-14);
      CHECK(world.attachment(names[i]).has_value() == (i >= taken));
    }
    // Put back upright over the same position, it is let go and rests as it did.
    world.move_carried(3, T_0);
    world.drop(names[taken]);
    for (std::size_t i = 0; i < names.size(); ++i) {
      CHECK_FALSE(world.attachment(names[i]).has_value());
      CHECK(std::abs(world.at(names[i]).T_world_obj.translation().z() -
                     before[i].translation().z()) < 1e-12);
    }
  }
}

TEST_CASE(
    "what rested on a body that is moved or removed falls, all of it, onto the next surface") {
  for (const bool removed : {false, true}) {
    World world = table_world();
    world.insert(at("low", kCube, 0.0, 0.0, 0.24));
    world.insert(at("middle", kCube, 0.0, 0.0, 0.28));
    world.insert(at("high", kCube, 0.01, 0.0, 0.32));
    world.insert(at("aside", kCube, 0.3, 0.0, 0.24));
    const auto falls =
        removed ? world.remove("low") : world.set_pose("low", make_translation({0.5, 0.3, 0.24}));
    REQUIRE(falls.size() == 2);
    CHECK(falls[0].name == "middle");
    CHECK(falls[0].drop.support == "table");
    CHECK(falls[0].drop.distance == doctest::Approx(0.04).epsilon(1e-12));
    CHECK(falls[1].name == "high");
    CHECK(falls[1].drop.support == "middle");
    CHECK(world.at("high").T_world_obj.translation().z() == doctest::Approx(0.28).epsilon(1e-12));
    CHECK(world.at("aside").T_world_obj.translation().z() == 0.24);
  }
}

TEST_CASE("a beam on two bodies stays on the one that is left; fixed and hanging bodies stay too") {
  World world = table_world();
  world.insert(at("left", kCube, -0.1, 0.0, 0.24));
  world.insert(at("right", kCube, 0.1, 0.0, 0.24));
  world.insert(at("beam", Box{{0.3, 0.04, 0.02}}, 0.0, 0.0, 0.27));
  Object shelf = at("shelf", kCube, 0.1, 0.0, 0.30);
  shelf.fixed = true;
  world.insert(shelf);
  world.insert(at("hanging", kCube, 0.1, 0.0, 0.50));
  CHECK(world.remove("right").empty());
  CHECK(world.at("beam").T_world_obj.translation().z() == 0.27);
  CHECK(world.remove("left").size() == 1);
  CHECK(world.at("shelf").T_world_obj.translation().z() == 0.30);
  CHECK(world.at("hanging").T_world_obj.translation().z() == 0.50);
}

TEST_CASE("a body put onto a carried one travels with it, taken from it it does not") {
  World world = table_world();
  world.insert(at("tray", Box{{0.2, 0.2, 0.02}}, 0.0, 0.0, 0.5));
  world.attach("tray", 0, Eigen::Isometry3d::Identity());
  world.insert(at("a", kCube, 0.05, 0.0, 0.53));
  world.insert(at("b", kCube, 0.4, 0.0, 0.24));
  world.set_pose("b", make_translation({-0.05, 0.0, 0.53}));
  world.move_carried(0, make_translation({0.0, 0.0, 0.1}));
  CHECK(world.at("a").T_world_obj.translation().z() == doctest::Approx(0.63));
  CHECK(world.at("b").T_world_obj.translation().z() == doctest::Approx(0.63));
  // Another gripper takes one of them, which no longer follows the tray.
  world.attach("a", 1, Eigen::Isometry3d::Identity());
  world.move_carried(0, make_translation({0.0, 0.0, 0.2}));
  CHECK(world.at("a").T_world_obj.translation().z() == doctest::Approx(0.63));
  CHECK(world.at("b").T_world_obj.translation().z() == doctest::Approx(0.73));
}
