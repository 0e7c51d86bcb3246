// Surfaces of triangles: whether they are closed, what they weigh, what they hold.

#include "armlet/mesh/triangle_mesh.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

std::string refusal(std::vector<Vector3d> vertices, std::vector<Corners> triangles) {
  try {
    (void)TriangleMesh(std::move(vertices), std::move(triangles));
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return {};
}

TriangleMesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TriangleMesh without_last(const TriangleMesh& mesh) {
  auto triangles = mesh.triangles();
  triangles.pop_back();
  return {mesh.vertices(), triangles};
}

}  // namespace

TEST_CASE("a box weighs what a box weighs, wherever it is") {
  const Vector3d size(0.1, 0.2, 0.3), middle(3.0, -2.0, 1.0);
  const TriangleMesh mesh = test::box_mesh(size, middle);
  REQUIRE(mesh.mass_properties());
  CHECK(mesh.is_convex());
  CHECK(mesh.mass_properties()->volume == doctest::Approx(0.006).epsilon(1e-12));
  CHECK((mesh.mass_properties()->center_of_mass - middle).norm() < 1e-13);
  // m / 12 (y^2 + z^2) and so on, m = 0.006.
  const Vector3d inertia = 0.006 / 12.0 * Vector3d(0.13, 0.10, 0.05);
  CHECK((mesh.mass_properties()->inertia - Eigen::Matrix3d(inertia.asDiagonal())).norm() < 1e-16);
}

TEST_CASE("the tetrahedron of the three axes, by hand") {
  // Volume 1/6, centre (1/4, 1/4, 1/4). Integrals over it: x^2: 1/60, x y: 1/120; about the centre
  // y^2 + z^2: 1/30 - 1/48 = 1/80, x y: 1/120 - 1/96 = -1/480.
  const TriangleMesh mesh = tetrahedron();
  REQUIRE(mesh.mass_properties());
  CHECK(mesh.mass_properties()->volume == doctest::Approx(1.0 / 6.0).epsilon(1e-14));
  CHECK((mesh.mass_properties()->center_of_mass - Vector3d::Constant(0.25)).norm() < 1e-15);
  const Eigen::Matrix3d& inertia = mesh.mass_properties()->inertia;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k)
      CHECK(inertia(i, k) == doctest::Approx(i == k ? 1.0 / 80.0 : 1.0 / 480.0).epsilon(1e-13));
  }
}

TEST_CASE("balls of more and more faces come to weigh what a sphere weighs") {
  const double r = 0.05, volume = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  double before = 1.0;
  for (const int bands : {8, 16, 32, 64}) {
    const auto mass = test::ball_mesh(r, bands).mass_properties();
    REQUIRE(mass);
    const double error = 1.0 - mass->volume / volume;
    CHECK(error > 0.0);           // it lies inside
    CHECK(error < 0.3 * before);  // the error falls with the square
    CHECK(mass->inertia(2, 2) < 0.4 * volume * r * r);
    before = error;
  }
  CHECK(before < 2e-3);
}

TEST_CASE("an angle iron weighs as much as its two boxes") {
  // 0.1 x 0.02 x 0.05 and, beside it, 0.02 x 0.08 x 0.05.
  const auto mass = test::angle_iron().mass_properties();
  REQUIRE(mass);
  const double one = 0.1 * 0.02 * 0.05, two = 0.02 * 0.08 * 0.05;
  CHECK(mass->volume == doctest::Approx(one + two).epsilon(1e-12));
  const Vector3d centre =
      (one * Vector3d(0.05, 0.01, 0.025) + two * Vector3d(0.01, 0.06, 0.025)) / (one + two);
  CHECK((mass->center_of_mass - centre).norm() < 1e-15);
}

TEST_CASE("a moved or scaled mesh is what its vertices would make") {
  const TriangleMesh iron = test::angle_iron(),
                     shifted = iron.moved(Eigen::Isometry3d(Eigen::Translation3d(0.3, -0.2, 0.1)));
  std::vector<Vector3d> vertices = iron.vertices();
  for (Vector3d& each : vertices) each += Vector3d(0.3, -0.2, 0.1);
  const TriangleMesh made(vertices, iron.triangles());
  CHECK(shifted.low() == made.low());
  CHECK(shifted.high() == made.high());
  CHECK(shifted.reach() == made.reach());
  CHECK(
      (shifted.mass_properties()->center_of_mass - made.mass_properties()->center_of_mass).norm() <
      1e-15);
  for (std::size_t i = 0; i < made.tree().nodes.size(); ++i) {
    CHECK(shifted.tree().nodes[i].low == made.tree().nodes[i].low);
    CHECK(shifted.tree().nodes[i].high == made.tree().nodes[i].high);
  }
  const Eigen::Isometry3d T(Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()));
  CHECK(
      (iron.moved(T).mass_properties()->center_of_mass - T * iron.mass_properties()->center_of_mass)
          .norm() < 1e-15);
  const TriangleMesh mirrored = iron.scaled({-2.0, 1.0, 1.0});
  CHECK(mirrored.is_closed());
  CHECK(mirrored.mass_properties()->volume ==
        doctest::Approx(2.0 * iron.mass_properties()->volume).epsilon(1e-12));
  CHECK(mirrored.low().x() == -0.2);
}

TEST_CASE("what is convex but for the rounding of a file is convex, what has a dent is not") {
  const auto rounded = [](const TriangleMesh& mesh, const Vector3d& p) {
    std::vector<Vector3d> vertices;
    for (const Vector3d& each : mesh.vertices())
      vertices.emplace_back((each + p).cast<float>().cast<double>());
    return TriangleMesh(vertices, mesh.triangles());
  };
  CHECK(rounded(test::box_mesh({0.08, 0.07, 0.09}), {3.1, -2.3, 1.7}).is_convex());
  CHECK(rounded(test::ball_mesh(0.05, 200), {0.0, 0.0, 0.0}).is_convex());
  CHECK_FALSE(rounded(test::angle_iron(), {0.0, 0.0, 0.0}).is_convex());
  // The middle of a face 0.02 mm lower than its corners.
  const TriangleMesh box = test::box_mesh({0.1, 0.1, 0.1});
  std::vector<Vector3d> vertices = box.vertices();
  vertices.emplace_back(0.0, 0.0, 0.04998);
  std::vector<Corners> triangles = box.triangles();
  const auto number = [&](const Vector3d& p) {
    return static_cast<std::uint32_t>(std::ranges::find(vertices, p) - vertices.begin());
  };
  std::erase_if(triangles, [&](const Corners& c) {
    return std::ranges::all_of(c, [&](std::uint32_t k) { return vertices[k].z() > 0.0; });
  });
  REQUIRE(triangles.size() == 10);
  const std::uint32_t ring[] = {number({-0.05, -0.05, 0.05}), number({0.05, -0.05, 0.05}),
                                number({0.05, 0.05, 0.05}), number({-0.05, 0.05, 0.05})};
  for (std::size_t k = 0; k < 4; ++k) triangles.push_back({ring[k], ring[(k + 1) % 4], 8});
  const TriangleMesh dented(vertices, triangles);
  CHECK(dented.is_closed());
  CHECK_FALSE(dented.is_convex());
}

TEST_CASE("a surface with the inside outside is reversed") {
  TriangleMesh mesh = tetrahedron();
  auto triangles = mesh.triangles();
  for (Corners& each : triangles) std::swap(each[0], each[1]);
  const TriangleMesh turned(mesh.vertices(), triangles);
  REQUIRE(turned.mass_properties());
  CHECK(turned.mass_properties()->volume == mesh.mass_properties()->volume);
  CHECK(turned.is_convex());
}

TEST_CASE("what is no surface of a body is reported, with the edges") {
  const TriangleMesh open = without_last(test::box_mesh({1, 1, 1}));
  CHECK(open.open_because() == "its surface is open: 3 edges belong to one triangle alone");
  CHECK_FALSE(open.mass_properties());
  CHECK_FALSE(open.is_convex());
  auto triangles = test::box_mesh({1, 1, 1}).triangles();
  std::swap(triangles[5][0], triangles[5][1]);
  const TriangleMesh twisted(test::box_mesh({1, 1, 1}).vertices(), triangles);
  CHECK(twisted.open_because().find("3 edges are gone twice the same way") != std::string::npos);
  // Two sides of one triangle.
  const TriangleMesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  CHECK(flat.open_because() == "its surface holds nothing");
}

TEST_CASE("corners at one position are one, triangles without a face are left out") {
  // A box as files have it: every triangle with corners of its own.
  const TriangleMesh box = test::box_mesh({1, 2, 3});
  std::vector<Vector3d> vertices{{9, 9, 9}};  // used by none
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < box.triangles().size(); ++i) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t k = 0; k < 3; ++k) vertices.push_back(box.corner(i, k));
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first, first + 1});
  }
  const TriangleMesh mesh(vertices, triangles);
  CHECK(mesh.vertices().size() == 8);
  CHECK(mesh.triangles().size() == 12);
  CHECK(mesh.is_closed());
  CHECK(mesh.high() == Vector3d(0.5, 1.0, 1.5));
}

TEST_CASE("what cannot be computed with is refused") {
  const std::vector<Vector3d> three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK(refusal(three, {}) == "it has no triangles");
  CHECK(refusal(three, {{0, 1, 3}}) == "triangle 0 has the corner 3; there are 3 vertices");
  CHECK(refusal(three, {{0, 0, 1}}) == "none of its triangles has three different corners");
  auto broken = three;
  broken[1].y() = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(broken, {{0, 1, 2}}) == "vertex 1 has a coordinate that is no number");
  broken[1].y() = 1e5;
  CHECK(refusal(broken, {{0, 1, 2}}).find("10 km") != std::string::npos);
  CHECK(refusal(three, std::vector<Corners>(kMostTriangles + 1, Corners{0, 1, 2}))
            .find("1000001 triangles") != std::string::npos);
}

TEST_CASE("the farthest vertex is that of a search through all") {
  Random random(3);
  const TriangleMesh ball = test::ball_mesh(0.3, 20), iron = test::angle_iron();
  for (int i = 0; i < 2000; ++i) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    for (const TriangleMesh* mesh : {&ball, &iron}) {
      double most = -1e9;
      for (const Vector3d& each : mesh->vertices()) most = std::max(most, d.dot(each));
      CHECK(mesh->farthest(d).dot(d) == most);
    }
  }
}

TEST_CASE("a point is inside exactly if it is inside of one of the two boxes") {
  const TriangleMesh iron = test::angle_iron();
  CHECK_FALSE(iron.is_convex());
  Random random(4);
  for (int i = 0; i < 20000; ++i) {
    Vector3d p(random.uniform(-0.02, 0.12), random.uniform(-0.02, 0.12),
               random.uniform(-0.01, 0.06));
    if (i % 3 == 0) p.x() = p.y();  // rays along symmetries
    if (i % 5 == 0) p = Vector3d(0.005 * std::round(200 * p.x()), p.y(), p.z());
    const auto in_box = [&](double x, double y) {
      return p.x() > 0 && p.x() < x && p.y() > 0 && p.y() < y && p.z() > 0 && p.z() < 0.05;
    };
    const bool on_face = p.x() == 0.0 || p.x() == 0.02 || p.x() == 0.1;
    if (!on_face) CHECK(iron.holds(p) == (in_box(0.1, 0.02) || in_box(0.02, 0.1)));
  }
}

TEST_CASE("scaled and moved meshes know their file, and where its points have gone") {
  TriangleMesh mesh = tetrahedron();
  const auto bytes = std::make_shared<const std::string>("a file");
  mesh.set_source(bytes);
  const Eigen::Isometry3d T =
      Eigen::Translation3d(0.1, -0.2, 0.3) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized());
  const Eigen::Isometry3d shift(Eigen::Translation3d(0.5, 0.0, -1.0));
  const TriangleMesh last = mesh.scaled({2.0, -3.0, 0.5}).moved(T).moved(shift).scaled({1, 1, 2});
  CHECK(last.source().bytes == bytes);
  for (const Vector3d& each : mesh.vertices()) {
    const Vector3d p = last.source().T_mesh_file * each;
    CHECK(std::ranges::any_of(last.vertices(),
                              [&](const Vector3d& q) { return (p - q).norm() < 1e-12; }));
  }
  CHECK(tetrahedron().moved(T).source().bytes == nullptr);
}
