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

TEST_CASE(
    "images, places on them, colours and notes are inside, and the surface is read as before") {
  GlbScene scene = triangle();
  const std::string picture = "\x89PNG\r\n\x1a\n and the rest";
  scene.images.push_back({"wood", picture});
  scene.materials[0].texture = 0;
  scene.nodes[0].parts[0].on_image = {{0, 0}, {1, 0}, {0, 1}};
  scene.nodes[0].parts[0].colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  scene.notes = {"one is missing", "so is another"};
  const std::string bytes = write_glb(scene);
  CHECK(bytes.find(picture) != std::string::npos);
  CHECK(bytes.find("\"baseColorTexture\":{\"index\":0}") != std::string::npos);
  CHECK(glb_notes(bytes) == scene.notes);
  const Result<TriangleMesh> read = read_glb(bytes);
  REQUIRE(read.ok());
  CHECK(read->triangles().size() == 1);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::string> notes = glb_notes(std::string_view(bytes).substr(0, size));
    CHECK(notes.empty());
  }
  SUBCASE("an image that is not there") { scene.materials[0].texture = 1; }
  SUBCASE("an image of another kind") { scene.images[0].bytes = "BM"; }
  SUBCASE("a digit too few") { scene.nodes[0].parts[0].on_image.pop_back(); }
  SUBCASE("a colour too few") { scene.nodes[0].parts[0].colors.pop_back(); }
  CHECK_THROWS_AS(write_glb(scene), ArgumentError);
}

TEST_CASE("how deep lists and objects lie in one another, not counting what is in quotes") {
  CHECK(json_depth("") == 0);
  CHECK(json_depth(R"({"a": [1, {"b": []}], "c": {}})") == 4);
  CHECK(json_depth(R"(["[[[", "\"[[", "\\", []])") == 2);
  CHECK(json_depth(std::string(1000, '[')) == 1000);
}

TEST_CASE("formats are known by the ending of a name, in whatever case") {
  CHECK(mesh_format("a.b/cup.WRL") == "wrl");
  CHECK(mesh_format("cup.3dS") == "3ds");
  CHECK(mesh_format("cup.GLB") == "glb");
  CHECK(is_glb_name("cup.GLB"));
  for (const char* const other : {"", "cup", "glb", "cup.", "cup.objx", "cup.glb2", ".glb.txt"})
    CHECK(mesh_format(other).empty());
}
