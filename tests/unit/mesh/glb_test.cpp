// Scenes as GLB: bytes that can be read by the specification alone are compared in
// tests/glb_command.py; here what is refused, and what the header says.

#include "armlet/mesh/glb.hpp"

#include <doctest/doctest.h>

#include "armlet/core/error.hpp"

using namespace armlet;

namespace {

GlbScene triangle() {
  GlbPart part{.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
               .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
               .corners = {0, 1, 2}};
  GlbScene scene{.materials = {{.name = "grey"}}};
  scene.nodes.push_back({.name = "a \"quoted\" name", .parts = {part}});
  return scene;
}

std::size_t u32(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = 256 * value + static_cast<unsigned char>(bytes[at + k]);
  return value;
}

}  // namespace

TEST_CASE("a scene has the lengths that its header says, in whole words") {
  const std::string bytes = write_glb(triangle());
  CHECK(bytes.substr(0, 4) == "glTF");
  CHECK(u32(bytes, 8) == bytes.size());
  CHECK(bytes.size() % 4 == 0);
  const std::size_t json = u32(bytes, 12);
  CHECK(u32(bytes, 20 + json) == bytes.size() - 28 - json);
  CHECK(u32(bytes, 20 + json) == 2 * 36 + 12);  // two arrays of 3 vectors, 3 indices
}

TEST_CASE("a scene of frames alone has no binary part") {
  GlbScene scene;
  scene.nodes.push_back({.name = "frame"});
  const std::string bytes = write_glb(scene);
  CHECK(20 + u32(bytes, 12) == bytes.size());
}

TEST_CASE("what does not fit together is refused") {
  GlbScene scene = triangle();
  SUBCASE("a parent behind its child") { scene.nodes[0].parent = 0; }
  SUBCASE("a negative parent") { scene.nodes[0].parent = -2; }
  SUBCASE("a material that is not there") { scene.nodes[0].parts[0].material = 1; }
  SUBCASE("an index that is too large") { scene.nodes[0].parts[0].corners[1] = 3; }
  SUBCASE("a normal too few") { scene.nodes[0].parts[0].normals.pop_back(); }
  SUBCASE("a corner too few") { scene.nodes[0].parts[0].corners.pop_back(); }
  SUBCASE("no triangles") { scene.nodes[0].parts[0].corners.clear(); }
  CHECK_THROWS_AS(write_glb(scene), ArgumentError);
}
