// Things that are placed wrongly, are too many or cannot be: each case gives a clear message or the
// right result, in bounded time and memory.
#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "armlet/cell/collisions.hpp"
#include "armlet/collision/solid.hpp"
#include "armlet/core/error.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/mesh/glb.hpp"
#include "library.hpp"
#include "mesh_bodies.hpp"
#include "sanitized.hpp"
#include "temporary_folder.hpp"

using namespace armlet;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// What a program printed, what it was advised, and how it failed: "R0631: this cannot be ...".
struct Ended {
  std::string printed{};
  std::vector<std::string> advice{};
  std::string failure{};
  double seconds = 0.0;  // of the processor

  [[nodiscard]] int count(std::string_view code) const {
    return static_cast<int>(std::ranges::count_if(
        advice, [&](const std::string& each) { return each.starts_with(code); }));
  }
};

std::string text_of(const Diagnostic& d) {
  return d.code + ": " + d.message + " " + d.why + " " + (d.fix ? d.fix->text : "");
}

Ended run(const std::string& program, const std::filesystem::path& folder = {}) {
  Ended told;
  SessionOptions options = at_the_table();
  options.folder = folder;
  options.output = [&](std::string_view text) { told.printed += text; };
  options.advice = [&](const Diagnostic& d) { told.advice.push_back(text_of(d)); };
  const std::clock_t begin = std::clock();
  Session session(library_engine(), std::move(options));
  if (!session.compile(program, "p.rbt")) {
    told.failure = text_of(session.problems().front().diagnostic);
    return told;
  }
  const RunResult result = session.run();
  if (result.error) told.failure = text_of(*result.error);
  told.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return told;
}

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// A file of one body.
void write_part(const std::filesystem::path& file, GlbPart part) {
  GlbNode node;
  node.name = "body";
  node.parts.push_back(std::move(part));
  GlbScene scene;
  scene.materials.push_back({.name = "gray"});
  scene.nodes.push_back(std::move(node));
  std::ofstream(file, std::ios::binary) << write_glb(scene);
}

// A surface of bands from pole to pole, as a file.
void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh,
                bool inside_out = false, std::size_t left_out = 0) {
  GlbPart part;
  for (const Eigen::Vector3d& each : mesh.vertices()) {
    part.positions.push_back(each.cast<float>());
    part.normals.push_back(Eigen::Vector3f::UnitZ());
  }
  for (std::size_t i = left_out; i < mesh.triangles().size(); ++i) {
    const Corners& c = mesh.triangles()[i];
    part.corners.insert(part.corners.end(), {c[0], c[inside_out ? 2 : 1], c[inside_out ? 1 : 2]});
  }
  write_part(file, std::move(part));
}

const char* kCube = "object cube { shape: box(40mm, 40mm, 40mm); at: xyz(400mm, 0mm, 120mm) }\n";

}  // namespace

TEST_CASE(
    "objects inside of each other at the start are told, once for each place, with the depth") {
  const Ended told =
      run(std::string(kCube) +
          "object other { shape: box(40mm, 40mm, 40mm); at: xyz(410mm, 0mm, 120mm) }\n"
          "print(distance(cube, other), touching(cube, other))\n");
  CHECK(told.failure.empty());
  REQUIRE(told.count("W0723") == 1);
  CHECK(has(told.advice[0], "30"));
  CHECK(told.printed == "-30 mm true\n");
}

TEST_CASE("objects at exactly the same pose have a depth that frees them, of every two shapes") {
  const char* shapes[] = {"box(40mm, 40mm, 40mm)", "sphere(20mm)",
                          "cylinder(radius: 20mm, height: 40mm)",
                          "cone(radius: 20mm, height: 40mm)", "plane(40mm, 40mm)"};
  for (const char* a : shapes) {
    for (const char* b : shapes) {
      const Ended told = run(std::string("object a { shape: ") + a +
                             "; at: xyz(400mm, 0mm, 300mm) }\nobject b { shape: " + b +
                             "; at: xyz(400mm, 0mm, 300mm) }\n"
                             "let d = distance(a, b) / 1mm\n"
                             "assert(d <= 1e-9 && d >= -40.0001)\nprint(touching(a, b))\n");
      CAPTURE(a);
      CAPTURE(b);
      CHECK(told.failure.empty());
      CHECK(told.printed == "true\n");
    }
  }
}

TEST_CASE("sizes and positions that cannot be computed with are refused, and say the number") {
  struct Case {
    const char* what;
    const char* said;
  };
  const Case cases[] = {
      {"box(0mm, 40mm, 40mm).spawn(\"a\", at: p)", "must be more than 0 mm, but it is 0 mm"},
      {"box(40mm, -40mm, 40mm).spawn(\"a\", at: p)", "must be more than 0 mm, but it is -40 mm"},
      {"sphere(0mm).spawn(\"a\", at: p)", "must be more than 0 mm, but it is 0 mm"},
      {"sphere(-1mm).spawn(\"a\", at: p)", "must be more than 0 mm, but it is -1 mm"},
      {"cylinder(radius: 0mm, height: 1mm).spawn(\"a\", at: p)",
       "must be more than 0 mm, but it is 0 mm"},
      {"cone(radius: 1mm, height: 0mm).spawn(\"a\", at: p)",
       "must be more than 0 mm, but it is 0 mm"},
      {"plane(0mm, 1mm).spawn(\"a\", at: p)", "must be more than 0 mm, but it is 0 mm"},
      {"sphere(1e12 * 1m).spawn(\"a\", at: p)", "expected 10 km at most"},
      {"sphere(1e300 * 1m).spawn(\"a\", at: p)", "expected 10 km at most"},
      {"sphere(5e-324 * 1m).spawn(\"a\", at: p)", "expected 0.001 mm at least"},
      {"sphere(1e-310 * 1m).spawn(\"a\", at: p)", "expected 0.001 mm at least"},
      {"sphere(1mm).spawn(\"a\", at: xyz(1e12 * 1m, 0mm, 0mm))", "expected 10 km at most"},
      {"sphere(1mm).spawn(\"a\", at: xyz(0mm, 1e300 * 1m, 0mm))", "expected 10 km at most"},
      {"sphere(1mm).spawn(\"a\", at: xyz(0mm, 0mm, nan * 1m))", "not a finite number"},
      {"sphere(1mm).spawn(\"a\", at: xyz(0mm, 0mm, 1m / same(0.0)))", "not a finite number"},
      {"sphere(1mm).spawn(\"a\", at: rotZ(nan * 1rad))", "not a finite number"},
      {"sphere(nan * 1m).spawn(\"a\", at: p)", "nan"},
      {"sphere(1mm).spawn(\"a\", at: p, mass: nan * 1kg)", "nan"},
      {"sphere(1mm).spawn(\"a\", at: p, mass: same(-1.0) * 1kg)", "-1"},
      {"cube.setPose(xyz(nan * 1mm, 0mm, 0mm))", "not a finite number"},
      {"cube.setPose(xyz(-1e300 * 1m, 0mm, 0mm))", "expected 10 km at most"},
      {"sphere(1mm).spawn(\"cube\", at: p)", "cube"},
  };
  for (const Case& each : cases) {
    const Ended told = run(std::string(kCube) +
                           "fn same(x: double) -> double { return x }\nlet nan = same(0.0) / 0.0\n"
                           "let p = xyz(300mm, 0mm, 100mm)\n" +
                           each.what + "\n");
    CAPTURE(std::string(each.what));
    CAPTURE(told.failure);
    CHECK(has(told.failure, each.said));
  }
}

TEST_CASE("the embedding interface refuses poses that are none, and nothing changes") {
  World world;
  Object object{.name = "a", .shape = Box{}};
  const auto refused = [&](const Eigen::Isometry3d& T) {
    object.T_world_obj = T;
    CHECK_THROWS_AS(world.insert(object), ArgumentError);
    CHECK(world.size() == 0);
  };
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  for (const double bad : {kNan, kInfinite, -kInfinite, 1e300, 1e12}) {
    T.translation().y() = bad;
    refused(T);
  }
  T = Eigen::Isometry3d::Identity();
  T.linear()(0, 1) = kNan;
  refused(T);
  T.linear() = 2.0 * Eigen::Matrix3d::Identity();
  refused(T);
  T.linear() = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();  // a mirror
  refused(T);
  T = Eigen::Isometry3d::Identity();
  object.T_world_obj = T;
  for (double* number : {&object.mass, &object.friction, &object.stiffness}) {
    const double before = *number;
    for (const double bad : {kNan, kInfinite, -1.0}) {
      *number = bad;
      CHECK_THROWS_AS(world.insert(object), ArgumentError);
    }
    *number = before;
  }
  object.p_obj_grasp.x() = kNan;
  CHECK_THROWS_AS(world.insert(object), ArgumentError);
  object.p_obj_grasp.setZero();
  world.insert(object);
  T.translation().x() = kNan;
  CHECK_THROWS_AS(world.set_pose("a", T), ArgumentError);
  CHECK(world.at("a").T_world_obj.isApprox(Eigen::Isometry3d::Identity()));
  // A cell, its joints and its frames.
  Cell cell{World(world)};
  const int arm = cell.add_robot(make_robot("scara"));
  CHECK_THROWS_AS(cell.set_pose("a", T), ArgumentError);
  Eigen::VectorXd q = cell.robot(arm).q;
  q[0] = kNan;
  CHECK_THROWS_AS(cell.set_joints(arm, q), ArgumentError);
  CHECK_THROWS_AS(cell.insert_frame({.name = "f", .T_on_frame = T}), ArgumentError);
  CHECK(cell.contact_wrench(arm).allFinite());
}

TEST_CASE("a robot inside of an object is reported where it moves, and its force is finite") {
  const Ended told =
      run("robot arm = robots.puma560(tool: parallelGripper(stroke: 60mm, length: 120mm))\n"
          "object block1 { shape: box(2m, 2m, 2m); at: xyz(0mm, 0mm, 0mm) * rotZ(30deg); fixed: "
          "true }\n"
          "print(touching(arm, block1), distance(arm, block1) < 0mm)\n"
          "let f = arm.force()\n"
          "assert(f.x == f.x && f.y == f.y && f.z == f.z && f.mx == f.mx)\n"
          "try { with (collisions: \"error\") { arm.moveJ(posJ(10deg, -40deg, 90deg, 0deg, 30deg, "
          "0deg)) } }\n"
          "catch (e) { print(e.kind) }\n"
          "arm.moveJ(posJ(10deg, -40deg, 90deg, 0deg, 30deg, 0deg))\n"
          "for (tau in arm.torques()) assert(tau == tau)\n");
  CAPTURE(told.failure);
  CHECK(told.failure.empty());
  CHECK(told.printed == "true true\nCollision\n");
  CHECK(told.count("W0711") >= 1);
}

TEST_CASE("10,000 objects: placed, asked, moved among, dropped, in bounded time and memory") {
  const double before = peak_megabytes();
  const Ended told =
      run("robot arm = robots.puma560(tool: parallelGripper(stroke: 60mm, length: 120mm))\n"
          "for (i in range(10000)) {\n"
          "  let p = xyz(20mm * (i % 100) - 3000mm, 20mm * floor(double(i) / 100) - 3000mm, 5mm)\n"
          "  box(10mm, 10mm, 10mm).spawn(f\"b{i}\", at: p, mass: 10g)\n"
          "}\n"
          "object tray { shape: box(100mm, 100mm, 10mm); at: xyz(0mm, 3000mm, 100mm); mass: 1kg }\n"
          "object top { shape: box(10mm, 10mm, 10mm); at: xyz(0mm, 3000mm, 110mm); mass: 10g }\n"
          "remove(tray)\n"
          "assert(near(poseOf(top).z, 5mm, tol: 0.001mm))\n"
          "print(objects().length, nearestObject(xyz(-1000mm, -1000mm)).name)\n"
          "let near1 = nearestObject(xyz(-3000mm, -3000mm, 5mm))\n"
          "let near2 = nearestObject(xyz(-2980mm, -3000mm, 5mm))\n"
          "assert(near1.name == \"b0\" && near2.name == \"b1\")\n"
          "assert(near(distance(near1, near2), 10mm, tol: 0.0001mm))\n"
          "arm.moveJ(posJ(60deg, -45deg, 90deg, 0deg, 30deg, 0deg)) until arm.force().z > 10N\n"
          "arm.moveL(arm.here() * xyz(z: 20mm), speed: 100mm/s)\n"
          "print(arm.force().z)\n");
  CAPTURE(told.failure);
  CHECK(told.failure.empty());
  CHECK(told.printed == "10001 b9999\n0 N\n");
  MESSAGE("10,000 objects: ", told.seconds, " s, ", peak_megabytes() - before, " MB");
  if (kSanitized) return;
  CHECK(told.seconds < 30.0);
  CHECK(peak_megabytes() - before < 300.0);
}

TEST_CASE("a mesh of a million triangles is read, weighed and collides; one more is refused") {
  if (kSanitized) return;
  TemporaryFolder folder;
  const double before = peak_megabytes();
  // 2 n (2 n - 2) triangles: 998,000 and 1,002,000.
  write_mesh(folder.path() / "ball.glb", test::ball_mesh(0.05, 500));
  const Ended told =
      run("let shape = mesh(\"ball.glb\", density: 1000kg/m^3)\n"
          "object ball { shape: shape; at: xyz(400mm, 0mm, 200mm) }\n"
          "object cube { shape: box(40mm, 40mm, 40mm); at: xyz(400mm, 0mm, 300mm) }\n"
          "print(f\"{distance(ball, cube):.2f mm}\")\n"
          "moveJ(posJ(40deg, 20deg, 0mm, 0deg))\n",
          folder.path());
  CAPTURE(told.failure);
  CHECK(told.failure.empty());
  CHECK(told.printed == "30.00 mm\n");
  MESSAGE("a million triangles: ", told.seconds, " s, ", peak_megabytes() - before, " MB");
  CHECK(told.seconds < 30.0);
  CHECK(peak_megabytes() - before < 1500.0);
  GlbPart part;
  part.positions = {{0.F, 0.F, 0.F}, {1.F, 0.F, 0.F}, {0.F, 1.F, 0.F}};
  part.normals.assign(3, Eigen::Vector3f::UnitZ());
  for (std::size_t i = 0; i <= kMostTriangles; ++i)
    part.corners.insert(part.corners.end(), {0U, 1U, 2U});
  write_part(folder.path() / "many.glb", std::move(part));
  const Ended refused = run("let shape = mesh(\"many.glb\")\n", folder.path());
  CHECK(has(refused.failure, "R0656"));
  CHECK(has(refused.failure, "1000000"));
  CHECK(refused.seconds < 30.0);
}

TEST_CASE(
    "an open mesh has no mass and is refused as an object; one that is inside out is turned") {
  TemporaryFolder folder;
  const TriangleMesh box = test::box_mesh({0.1, 0.2, 0.3});
  write_mesh(folder.path() / "open.glb", box, false, 1);
  write_mesh(folder.path() / "turned.glb", box, true);
  const Ended open = run("let s = mesh(\"open.glb\", density: 1000kg/m^3)\n", folder.path());
  CHECK(has(open.failure, "R0656"));
  CHECK(has(open.failure, "3 edges belong to one triangle alone"));
  const Ended turned =
      run("object part { shape: mesh(\"turned.glb\", density: 1000kg/m^3); at: xyz(400mm, 0mm, "
          "500mm) }\n"
          "object ball { shape: sphere(10mm); at: xyz(400mm, 0mm, 500mm) }\n"
          "print(touching(part, ball))\n",
          folder.path());
  CHECK(turned.failure.empty());
  CHECK(turned.printed == "true\n");
  const TriangleMesh inside_out = [&] {
    std::vector<Corners> triangles = box.triangles();
    for (Corners& each : triangles) std::swap(each[1], each[2]);
    return TriangleMesh(box.vertices(), std::move(triangles));
  }();
  CHECK(inside_out.mass_properties()->volume == doctest::Approx(0.006).epsilon(1e-12));
  // The lower level says why, too.
  std::vector<Corners> fewer(box.triangles().begin() + 1, box.triangles().end());
  const TriangleMesh sheet(box.vertices(), std::move(fewer));
  CHECK_FALSE(sheet.mass_properties().has_value());
  CHECK_THROWS_WITH_AS((void)make_mesh(sheet), doctest::Contains("open"), ArgumentError);
}
