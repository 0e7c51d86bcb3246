// Closed parts of a surface that are inside out, lie in one another or overlap.

#include <doctest/doctest.h>

#include <algorithm>

#include "armlet/core/random.hpp"
#include "armlet/mesh/triangle_mesh.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

// Meshes put together: all their triangles in one list.
class Together {
 public:
  Together& add(const TriangleMesh& mesh, bool inside_out = false) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    vertices_.insert(vertices_.end(), mesh.vertices().begin(), mesh.vertices().end());
    for (Corners each : mesh.triangles()) {
      for (std::uint32_t& k : each) k += first;
      if (inside_out) std::swap(each[0], each[1]);
      triangles_.push_back(each);
    }
    return *this;
  }
  [[nodiscard]] TriangleMesh mesh() const { return {vertices_, triangles_}; }
  [[nodiscard]] double volume() const { return mesh().mass_properties()->volume; }

 private:
  std::vector<Vector3d> vertices_;
  std::vector<Corners> triangles_;
};

TriangleMesh cube(double size, const Vector3d& middle = Vector3d::Zero()) {
  return test::box_mesh(Vector3d::Constant(size), middle);
}

}  // namespace

TEST_CASE("a part that is inside out beside another one is reversed") {
  // 0.1^3 + 0.03^3, whichever of the two is inside out.
  for (const auto& [first, second] : {std::pair(false, true), {true, false}, {true, true}}) {
    const TriangleMesh mesh =
        Together().add(cube(0.1), first).add(cube(0.03, {0.08, 0.0, 0.0}), second).mesh();
    CHECK(mesh.mass_properties()->volume == doctest::Approx(1.027e-3).epsilon(1e-12));
    CHECK(mesh.doubled_because().empty());
    CHECK(mesh.holds({0.08, 0.001, 0.002}));
  }
  // Equal ones: the volumes would be nothing together.
  const TriangleMesh twins = Together().add(cube(0.1)).add(cube(0.1, {0.0, 0.3, 0.0}), true).mesh();
  CHECK(twins.mass_properties()->volume == doctest::Approx(2e-3).epsilon(1e-12));
}

TEST_CASE("a cavity stays, and what lies in it is a body again") {
  const TriangleMesh hollow = Together().add(cube(0.1)).add(cube(0.05), true).mesh();
  CHECK(hollow.mass_properties()->volume == doctest::Approx(1e-3 - 0.125e-3).epsilon(1e-12));
  CHECK(hollow.doubled_because().empty());
  CHECK_FALSE(hollow.holds({0.001, 0.002, 0.003}));
  const TriangleMesh filled =
      Together().add(cube(0.1)).add(cube(0.05), true).add(cube(0.02)).mesh();
  CHECK(filled.mass_properties()->volume == doctest::Approx(1e-3 - 0.125e-3 + 8e-6));
  CHECK(filled.doubled_because().empty());
  CHECK(filled.holds({0.001, 0.002, 0.003}));
}

TEST_CASE("an inner surface that looks outwards is reported with the volume that counts twice") {
  const TriangleMesh mesh = Together().add(cube(0.1)).add(cube(0.05)).mesh();
  CHECK(mesh.mass_properties()->volume == doctest::Approx(1.125e-3).epsilon(1e-12));
  CHECK(mesh.doubled_because() ==
        "a closed part of it lies inside of another one and counts more than once, 0.000125 m^3: "
        "the surface of a cavity would look inwards");
  const TriangleMesh two = Together()
                               .add(cube(0.1))
                               .add(cube(0.02, {0.02, 0.02, 0.02}))
                               .add(cube(0.02, {-0.02, 0.0, 0.0}))
                               .mesh();
  CHECK(two.doubled_because().starts_with("2 closed parts of it lie inside of others"));
}

TEST_CASE("parts that overlap are reported, parts that touch are not") {
  const auto why = [](const TriangleMesh& a, const TriangleMesh& b) {
    return Together().add(a).add(b).mesh().doubled_because();
  };
  const std::string kOverlap = "closed parts of it overlap at (";
  CHECK(why(cube(0.1), cube(0.1, {0.05, 0.03, 0.02})).starts_with(kOverlap));
  // Sides in the same planes.
  CHECK(why(cube(0.1), cube(0.1, {0.05, 0.0, 0.0})).starts_with(kOverlap));
  // A cross of two bars: the middles of all triangles are outside of the other one.
  CHECK(why(test::box_mesh({0.4, 0.02, 0.02}), test::box_mesh({0.018, 0.4, 0.022}))
            .starts_with(kOverlap));
  CHECK(why(cube(0.1), test::ball_mesh(0.03, 12).moved(
                           Eigen::Isometry3d(Eigen::Translation3d(0.07, 0.01, 0.003))))
            .starts_with(kOverlap));
  CHECK(why(cube(0.1), cube(0.1, {0.1, 0.0, 0.0})).empty());
  CHECK(why(cube(0.1), cube(0.1, {0.1, 0.03, 0.02})).empty());
  CHECK(why(cube(0.1), cube(0.1, {0.1, 0.1, 0.0})).empty());
  CHECK(why(cube(0.1), cube(0.1, {0.1, 0.1, 0.1})).empty());
  CHECK(why(cube(0.1), cube(0.04, {0.07, 0.0, 0.0})).empty());
  CHECK(why(test::angle_iron(), cube(0.02, {0.035, 0.035, 0.025})).empty());
}

TEST_CASE("a sheet whose two sides are one surface is no body that overlaps") {
  const TriangleMesh box = cube(0.1);
  std::vector<Vector3d> vertices = box.vertices();
  std::vector<Corners> triangles = box.triangles();
  for (const Vector3d& p :
       {Vector3d(-0.2, 0.01, 0.0), Vector3d(0.2, 0.01, 0.02), Vector3d(0.0, 0.02, 0.3)})
    vertices.push_back(p);
  triangles.push_back({8, 9, 10});
  triangles.push_back({8, 10, 9});
  const TriangleMesh mesh(vertices, triangles);
  REQUIRE(mesh.is_closed());
  CHECK(mesh.doubled_because().empty());
  CHECK(mesh.mass_properties()->volume == doctest::Approx(1e-3).epsilon(1e-12));
}

TEST_CASE("of very many parts it is said that they are not looked at") {
  Together many;
  for (int i = 0; i < 5001; ++i) many.add(cube(0.01, {0.02 * (i % 100), 0.02 * (i / 100), 0.0}));
  CHECK(
      many.mesh().doubled_because().starts_with("it has 5001 closed parts, and of more than 5000"));
}

TEST_CASE("of boxes in a row whose sides are reversed at random the volume is that of all") {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    Together row;
    double volume = 0.0, x = 0.0;
    for (int i = 0; i < 12; ++i) {
      const Vector3d size(random.uniform(0.01, 0.1), random.uniform(0.01, 0.1),
                          random.uniform(0.01, 0.1));
      // Some touch the one before.
      x += 0.5 * size.x() + (i % 3 == 0 ? 0.0 : random.uniform(0.001, 0.02));
      row.add(test::box_mesh(size, {x, 0.0, 0.5 * size.z()}), random.uniform(0.0, 1.0) < 0.4);
      x += 0.5 * size.x();
      volume += size.prod();
    }
    CHECK(row.volume() == doctest::Approx(volume).epsilon(1e-9));
    CHECK(row.mesh().doubled_because().empty());
  }
}

TEST_CASE("whether two boxes of any position overlap is what their distances along axes say") {
  Random random(12);
  int overlapping = 0;
  for (int round = 0; round < 400; ++round) {
    const auto some = [&](double least, double most) {
      return Vector3d(random.uniform(least, most), random.uniform(least, most),
                      random.uniform(least, most));
    };
    const Vector3d a = some(0.02, 0.3), b = some(0.02, 0.3), p = some(-0.2, 0.2);
    // Boxes along the same axes overlap exactly if they do along each of these.
    const Vector3d gap = p.cwiseAbs() - 0.5 * (a + b);
    if (std::abs(gap.maxCoeff()) < 1e-4) continue;
    const bool overlap = gap.maxCoeff() < 0.0;
    overlapping += overlap ? 1 : 0;
    const TriangleMesh mesh = Together().add(test::box_mesh(a)).add(test::box_mesh(b, p)).mesh();
    CHECK(mesh.doubled_because().empty() == !overlap);
  }
  CHECK(overlapping > 40);
}
