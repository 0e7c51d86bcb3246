// Meshes of descriptions: triangles of those for collisions, bytes of those that are only drawn.

#include <doctest/doctest.h>

#include <map>

#include "armlet/mesh/glb.hpp"
#include "armlet/model/robot_scene.hpp"
#include "armlet/model/serial_arm.hpp"
#include "armlet/model/urdf.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;

namespace {

using Eigen::Vector3d;

std::string file_of(const TriangleMesh& mesh) {
  GlbScene scene{.materials = {{.name = "grey"}}, .nodes = {{.name = "body"}}};
  scene.nodes[0].parts.resize(1);
  add_triangles(mesh, Eigen::Isometry3d::Identity(), scene.nodes[0].parts[0]);
  return write_glb(scene);
}

std::string element(const std::string& kind, const std::string& mesh,
                    const std::string& scale = "1 1 1") {
  return "<" + kind + "><origin xyz=\"0.1 0 0\"/><geometry><mesh filename=\"" + mesh +
         "\" scale=\"" + scale + "\"/></geometry></" + kind + ">";
}

// An arm of one joint whose link has these elements, with the files "plain.glb" (a box), "fine.glb"
// (a ball) and "broken.glb".
struct Description {
  std::map<std::string, int> loads;

  Robot robot(const std::string& elements) {
    const std::string text =
        "<robot name=\"a\"><link name=\"base\"/><link name=\"arm\">" + elements +
        "</link><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/>"
        "<axis xyz=\"0 0 1\"/><limit lower=\"-1\" upper=\"1\" effort=\"5\" "
        "velocity=\"2\"/></joint></robot>";
    UrdfOptions options;
    options.load_glb = [&](const std::string& name) -> Result<std::shared_ptr<const std::string>> {
      ++loads[name];
      if (name == "broken.glb") return std::make_shared<const std::string>("glTF");
      if (name == "gone.glb") return Error{"file", "it is gone"};
      if (name == "other.xyz") return std::shared_ptr<const std::string>();
      return std::make_shared<const std::string>(
          file_of(name == "fine.glb" ? test::ball_mesh(0.2, 12) : test::box_mesh({0.4, 0.1, 0.1})));
    };
    Result<RobotSpec> spec = serial_arm_of_urdf(text, options);
    REQUIRE(spec.ok());
    return Robot(std::move(spec).value());
  }
};

}  // namespace

TEST_CASE("a mesh that is only drawn has no triangles until a picture needs them") {
  Description description;
  const Robot robot = description.robot(element("visual", "fine.glb", "1 2 -1") +
                                        element("collision", "plain.glb") +
                                        element("visual", "fine.glb", "1 2 -1"));
  const std::vector<LinkMesh>& meshes = robot.body(1).bodies;
  REQUIRE(meshes.size() == 3);
  CHECK(description.loads == std::map<std::string, int>{{"fine.glb", 1}, {"plain.glb", 1}});
  CHECK(meshes[0].triangles != nullptr);
  CHECK(meshes[0].use == LinkSolidUse::kCollision);
  CHECK(meshes[1].triangles == nullptr);
  CHECK(meshes[1].use == LinkSolidUse::kPicture);
  CHECK(meshes[1].source().bytes == meshes[2].source().bytes);
  CHECK(meshes[1].source().T_mesh_file.linear().diagonal() == Vector3d(1, 2, -1));
  const TriangleMesh expected =
      read_glb(file_of(test::ball_mesh(0.2, 12)))->scaled(Vector3d(1, 2, -1));
  const auto triangles = triangles_of(meshes[1]);
  CHECK(triangles->vertices() == expected.vertices());
  CHECK(triangles->triangles() == expected.triangles());
  CHECK(triangles->source().T_mesh_file.matrix() == meshes[1].source().T_mesh_file.matrix());
  // The scene of the robot has both pictures, and nothing else in the link.
  std::size_t corners = 0;
  const GlbScene scene = robot_scene(robot);
  for (const GlbPart& part : scene.nodes.at(1).parts) corners += part.corners.size();
  CHECK(corners == 2 * 3 * expected.triangles().size());
}

TEST_CASE("one mesh for pictures and collisions is read once and is for both") {
  Description description;
  const Robot robot =
      description.robot(element("visual", "plain.glb") + element("collision", "plain.glb"));
  REQUIRE(robot.body(1).bodies.size() == 1);
  CHECK(robot.body(1).bodies[0].use == LinkSolidUse::kBoth);
  CHECK(description.loads.at("plain.glb") == 1);
  for (const char* kind : {"visual", "collision"}) {
    const Robot alone = description.robot(element(kind, "plain.glb"));
    REQUIRE(alone.body(1).bodies.size() == 1);
    CHECK(alone.body(1).bodies[0].use == LinkSolidUse::kBoth);
    CHECK(alone.body(1).bodies[0].triangles != nullptr);
  }
}

TEST_CASE("a drawn mesh that cannot be used is reported when it is read, and the other is drawn") {
  struct Case {
    const char* mesh;
    const char* scale;
    std::string why;
  };
  for (const Case& each :
       {Case{"broken.glb", "1 1 1", read_glb("glTF").error().message},
        Case{"gone.glb", "1 1 1", "it is gone"},
        Case{"fine.glb", "0 0 0", "none of its triangles has three different corners"},
        Case{"fine.glb", "1e6 1 1", "is more than 10 km from the origin"}}) {
    CAPTURE(each.mesh);
    Description description;
    const Robot robot = description.robot(element("collision", "plain.glb") +
                                          element("visual", each.mesh, each.scale));
    REQUIRE(robot.spec().notes.size() == 1);
    CHECK(robot.spec().notes[0].find(each.why) != std::string::npos);
    CHECK(robot.spec().notes[0].find("of link `arm` cannot be used") != std::string::npos);
    REQUIRE(robot.body(1).bodies.size() == 1);
    CHECK(robot.body(1).bodies[0].use == LinkSolidUse::kBoth);
  }
  Description description;
  const Robot robot =
      description.robot(element("collision", "plain.glb") + element("visual", "other.xyz"));
  CHECK(robot.spec().notes.empty());
  CHECK(robot.body(1).bodies.size() == 1);
}
