// GLB files read back, and broken ones: refused with a reason, never a crash, never out of bounds.

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/mesh/glb.hpp"
#include "mesh_bodies.hpp"

using namespace armlet;
using Eigen::Vector3d;

namespace {

GlbPart part_of(const TriangleMesh& mesh) {
  GlbPart part;
  for (const Vector3d& each : mesh.vertices()) {
    part.positions.emplace_back(each.cast<float>());
    part.normals.emplace_back(0.0F, 0.0F, 1.0F);
  }
  for (const Corners& each : mesh.triangles())
    part.corners.insert(part.corners.end(), each.begin(), each.end());
  return part;
}

std::string file_of(const TriangleMesh& mesh,
                    const Eigen::Isometry3d& T = Eigen::Isometry3d::Identity()) {
  GlbScene scene{.materials = {{.name = "grey"}}};
  scene.nodes.push_back({.name = "outer", .T_parent_node = T});
  scene.nodes.push_back({.name = "body", .parent = 0, .parts = {part_of(mesh)}});
  return write_glb(scene);
}

void put_u32(std::string& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t k = 0; k < 4; ++k) bytes[at + k] = static_cast<char>(value >> (8 * k) & 0xffU);
}

std::string header(std::uint32_t json_bytes) {
  std::string bytes(20, '\0');
  put_u32(bytes, 0, 0x46546C67);
  put_u32(bytes, 4, 2);
  put_u32(bytes, 12, json_bytes);
  put_u32(bytes, 16, 0x4E4F534A);
  return bytes;
}

// A file with this JSON part, and so many bytes of zeros as its binary part.
std::string with_json(std::string json, std::uint32_t binary = 0) {
  while (json.size() % 4 != 0) json += ' ';
  std::string bytes = header(static_cast<std::uint32_t>(json.size())) + json;
  if (binary > 0) {
    std::string chunk(8, '\0');
    put_u32(chunk, 0, binary);
    put_u32(chunk, 4, 0x004E4942);
    bytes += chunk + std::string(binary, '\0');
  }
  put_u32(bytes, 8, static_cast<std::uint32_t>(bytes.size()));
  return bytes;
}

// Whether the check of a file says the same as its reader.
std::string why(const std::string& bytes) {
  const Result<TriangleMesh> read = read_glb(bytes);
  const auto fault = glb_fault(bytes);
  std::string reason = read.ok() ? "" : read.error().message;
  CHECK(reason == (fault ? fault->message : ""));
  return reason;
}

// With one text in the JSON part instead of another of the same length.
std::string changed(std::string bytes, const std::string& from, std::string to) {
  const std::size_t at = bytes.find(from);
  REQUIRE(at != std::string::npos);
  REQUIRE(to.size() <= from.size());
  to.resize(from.size(), ' ');
  return bytes.replace(at, from.size(), to);
}

bool says(const std::string& bytes, const std::string& text) {
  const std::string reason = why(bytes);
  CAPTURE(reason);
  const bool found = reason.find(text) != std::string::npos;
  CHECK(found);
  return found;
}

}  // namespace

TEST_CASE("what is written is read back, z up, where its nodes put it") {
  Eigen::Isometry3d T(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  T.translation() = Vector3d(0.5, -0.25, 1.0);
  const TriangleMesh iron = test::angle_iron();
  const Result<TriangleMesh> read = read_glb(file_of(iron, T));
  REQUIRE(read.ok());
  CHECK(read->is_closed());
  const MassProperties& mass = *read->mass_properties();
  CHECK(mass.volume == doctest::Approx(iron.mass_properties()->volume).epsilon(1e-6));
  CHECK((mass.center_of_mass - T * iron.mass_properties()->center_of_mass).norm() < 1e-7);
}

TEST_CASE("a file that is cut off is refused, wherever it is cut") {
  const std::string bytes = file_of(test::angle_iron());
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    CHECK_FALSE(why(bytes.substr(0, n)).empty());
    // Also with a header that agrees.
    if (n < 20) continue;
    std::string shorter = bytes.substr(0, n);
    put_u32(shorter, 8, static_cast<std::uint32_t>(n));
    CHECK_FALSE(why(shorter).empty());
  }
}

TEST_CASE("random bytes in a file make no crash") {
  const std::string bytes = file_of(test::box_mesh({0.1, 0.1, 0.1}));
  Random random(5);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string broken = bytes;
    for (std::uint64_t k = random.below(6) + 1; k > 0; --k)
      broken[random.below(bytes.size())] = static_cast<char>(random.below(256));
    if (!why(broken).empty()) ++refused;
  }
  CHECK(refused > 10000);
}

TEST_CASE("a check of a file in another size refuses what its mesh would refuse in that size") {
  const std::string bytes = file_of(test::angle_iron());
  const TriangleMesh mesh = *read_glb(bytes);
  Random random(8);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    Vector3d factors;
    for (double& each : factors)
      each = random.below(3) == 0
                 ? 0.0
                 : std::pow(10.0, random.uniform(-3, 8)) * (random.below(2) == 0 ? -1.0 : 1.0);
    std::string reason;
    try {
      (void)mesh.scaled(factors);
    } catch (const ArgumentError& error) {
      reason = error.what();
    }
    const auto fault = glb_fault(bytes, factors);
    REQUIRE(fault.has_value() == !reason.empty());
    refused += fault ? 1 : 0;
  }
  CHECK(refused > 100);
  CHECK(refused < 450);
}

TEST_CASE("sizes that the file has not are refused before anything is taken") {
  const std::string bytes = file_of(test::box_mesh({0.1, 0.1, 0.1}));
  std::string large = bytes;
  put_u32(large, 12, 0x7fffffff);
  says(large, "a chunk of 2147483647 bytes does not fit into it");
  put_u32(large = bytes, 8, 0x80000000);
  says(large, "its header says 2147483648 bytes");
  says(changed(bytes, "\"count\":36", "\"count\":99"), "more than the 144 bytes of its view hold");
  says(changed(bytes, "\"byteLength\":96", "\"byteLength\":-1"), "expected a whole number");
  says(changed(bytes, "\"count\":36", "\"count\":-1"), "expected a whole number");
  says(changed(bytes, "\"componentType\":5126", "\"componentType\":5120"), "is not read there");
  says(changed(bytes, "\"bufferView\":0", "\"bufferView\":9"), "bufferView 9 is not there; it has");
  says(changed(bytes, "\"mesh\":0", "\"mesh\":1"), "mesh 1 is not there; it has 1");
}

TEST_CASE("an index that no vertex has is refused") {
  std::string bytes = file_of(test::box_mesh({0.1, 0.1, 0.1}));
  put_u32(bytes, bytes.size() - 4, 8);
  says(bytes, "index 35 is 8, but there are 8 vertices");
}

TEST_CASE("a coordinate that is no number is refused") {
  std::string bytes = file_of(test::box_mesh({0.1, 0.1, 0.1}));
  put_u32(bytes, bytes.size() - 144 - 96 - 96, 0x7fc00000);
  says(bytes, "a coordinate that is no number");
}

TEST_CASE("loops of nodes, other files and what is not read are reported") {
  const std::string bytes = file_of(test::box_mesh({0.1, 0.1, 0.1}));
  says(changed(bytes, "\"children\":[1]", "\"children\":[0]"), "node 0 is below itself");
  says(with_json("[]"), "its JSON part is broken");
  says(with_json("{"), "its JSON part is broken");
  says(with_json(R"({"nodes":[{}]})"), "there are no triangles in it");
  says(with_json(R"({"extensionsRequired":["KHR_draco_mesh_compression"]})"),
       "it needs the extension \"KHR_draco_mesh_compression\"");
  says(with_json(
           R"({"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"/etc/passwd"}]})"),
       "its geometry lies in another file");
  says(with_json(std::string(100000, '[')), "more than 64 values in one another");
  says(with_json("{\"extras\":" + std::string(100, '[') + std::string(100, ']') + "}"),
       "more than 64 values in one another");
}

TEST_CASE("a few bytes never stand for more than a million triangles") {
  // One box, in each of 100,000 nodes.
  std::string nodes, roots;
  for (int i = 0; i < 100000; ++i) {
    nodes += i > 0 ? ",{\"mesh\":0}" : "{\"mesh\":0}";
    roots += (i > 0 ? "," : "") + std::to_string(i);
  }
  const std::string rest =
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":36,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":432}],"buffers":[{"byteLength":432}],"nodes":[)" +
      nodes + "]}";
  says(with_json("{\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," + rest, 432),
       "it has more than 1000000 triangles");
  says(
      with_json("{\"meshes\":[{\"primitives\":[{\"mode\":0},{\"mode\":0},{\"mode\":0},{\"mode\":0},"
                "{\"mode\":0},{\"mode\":0},{\"mode\":0},{\"mode\":0},{\"mode\":0},{\"mode\":0},"
                "{\"mode\":0}]}]," +
                    rest,
                432),
      "more than a million parts");
}

namespace {

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

nlohmann::json description_of(const std::string& bytes) {
  return nlohmann::json::parse(bytes.substr(20, u32_at(bytes, 12)));
}

// Something that begins as a PNG does.
std::string picture(char with) { return "\x89PNG\r\n\x1a\n" + std::string(2000, with); }

// Two boxes with a picture each, the second one rotated, moved and below a node that is.
std::string two_boxes() {
  GlbScene scene;
  scene.images = {{"first", picture('a')}, {"second", picture('b')}};
  scene.materials = {{.name = "one", .texture = 0}, {.name = "two", .texture = 1}};
  Eigen::Isometry3d T(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  T.translation() = Vector3d(0.5, -0.25, 1.0);
  for (int k = 0; k < 2; ++k) {
    GlbPart part = part_of(test::box_mesh({0.1, 0.2, 0.3 + k}));
    part.material = k;
    part.on_image.assign(part.positions.size(), {0.5F, 0.25F});
    scene.nodes.push_back({.name = k == 0 ? "body" : "lid", .parent = k - 1, .T_parent_node = T});
    scene.nodes.back().parts = {part};
  }
  return write_glb(scene);
}

}  // namespace

TEST_CASE("a node is cut out of a file with its own picture, and is what the node was") {
  const std::string whole = two_boxes();
  for (const char* const name : {"body", "lid"}) {
    CAPTURE(name);
    const bool is_lid = name[0] == 'l';
    const Result<std::vector<GlbThing>> things = read_glb_things(whole, name);
    REQUIRE(things.ok());
    const std::string cut = cut_glb(whole, things->front()).value();
    CHECK(cut.size() < whole.size() - 1500);  // without the other picture
    const nlohmann::json json = description_of(cut);
    REQUIRE(json.at("images").size() == 1);
    CHECK(json.at("images")[0].at("name") == (is_lid ? "second" : "first"));
    CHECK(json.at("materials").size() == 1);
    CHECK(json.at("meshes")[0].at("primitives")[0].at("attributes").contains("TEXCOORD_0"));
    const auto number = json.at("images")[0].at("bufferView").get<std::size_t>();
    const nlohmann::json& view = json.at("bufferViews")[number];
    const std::size_t binary = 28 + u32_at(cut, 12);
    CHECK(cut.substr(binary + view.at("byteOffset").get<std::size_t>(),
                     view.at("byteLength").get<std::size_t>()) == picture(is_lid ? 'b' : 'a'));
    // The same body, where the thing has it.
    const Result<TriangleMesh> read = read_glb(cut);
    REQUIRE(read.ok());
    CHECK((read->low() - things->front().triangles.low()).norm() < 1e-6);
    CHECK((read->high() - things->front().triangles.high()).norm() < 1e-6);
    // Axes of nodes have y up.
    CHECK(read->high().y() == doctest::Approx(is_lid ? 0.65 : 0.15));
  }
}

TEST_CASE("a picture that is not in the file, or none, is left out of what is cut") {
  const std::string whole = two_boxes();
  const auto cut_of = [](const std::string& bytes) {
    const Result<std::vector<GlbThing>> things = read_glb_things(bytes, "lid");
    REQUIRE(things.ok());
    return description_of(cut_glb(bytes, things->front()).value());
  };
  // Of the view that does not fit, the reference is dropped with all that follows.
  const nlohmann::json json = description_of(whole);
  const std::string source = R"("textures":[{"source":0},{"source":1}])";
  const nlohmann::json broken =
      cut_of(changed(whole, source, R"("textures":[{"source":0},{"source":7}])"));
  CHECK_FALSE(broken.contains("images"));
  CHECK_FALSE(broken.at("materials")[0].at("pbrMetallicRoughness").contains("baseColorTexture"));
  CHECK(cut_of(whole).at("materials")[0].at("pbrMetallicRoughness").contains("baseColorTexture"));
}

TEST_CASE("a long name is cut between letters") {
  std::string name;
  for (int k = 0; k < 60; ++k) name += "\xc3\xa4";
  GlbScene scene{.materials = {{.name = "grey"}}};
  scene.nodes.push_back({.name = "x" + name, .parts = {part_of(test::box_mesh({1, 1, 1}))}});
  const std::string whole = write_glb(scene);
  const Result<std::vector<GlbThing>> things = read_glb_things(whole);
  REQUIRE(things.ok());
  CHECK(things->front().name == "x" + name.substr(0, 98));
  CHECK(read_glb(cut_glb(whole, things->front()).value()).ok());
}

TEST_CASE("what a thing is drawn by and cannot be used is left out of what is cut") {
  const std::string whole = two_boxes();
  const auto cut_of = [&](const std::string& from, const std::string& to) {
    const std::string bytes = changed(whole, from, to);
    const Result<std::vector<GlbThing>> things = read_glb_things(bytes, "lid");
    REQUIRE(things.ok());
    const Result<std::string> cut = cut_glb(bytes, things->front());
    REQUIRE(cut.ok());
    CHECK(read_glb(*cut).ok());
    return description_of(*cut).at("meshes")[0].at("primitives")[0];
  };
  const nlohmann::json plain = cut_of("", "");
  CHECK(plain.at("attributes").contains("NORMAL"));
  // An array that is not there: the two boxes have eight.
  CHECK_FALSE(cut_of("\"NORMAL\":5", "\"NORMAL\":9").at("attributes").contains("NORMAL"));
  CHECK_FALSE(
      cut_of("\"TEXCOORD_0\":6", "\"TEXCOORD_0\":9").at("attributes").contains("TEXCOORD_0"));
}

TEST_CASE(
    "whatever is changed in a description, a node that is read is cut out, and that is read "
    "again") {
  const std::string whole = two_boxes();
  const std::size_t json = u32_at(whole, 12);
  Random random(147);
  int cut = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = whole;
    for (int k = 0; k < 1 + round % 3; ++k) {
      const std::string some = "0123456789,{}[]\"abtx-";
      const auto at = 20 + static_cast<std::size_t>(random.below(json));
      bytes[at] = some[static_cast<std::size_t>(random.below(some.size()))];
    }
    const Result<std::vector<GlbThing>> things = read_glb_things(bytes, "lid");
    if (!things.ok()) continue;
    // Whatever could be read can be cut out.
    const Result<std::string> part = cut_glb(bytes, things->front());
    REQUIRE(part.ok());
    CHECK(read_glb(*part).ok());
    ++cut;
    // Bytes that the thing does not come from give an error or a file.
    (void)cut_glb(
        std::string_view(bytes).substr(0, static_cast<std::size_t>(random.below(bytes.size()))),
        things->front());
  }
  CHECK(cut > 500);
}
