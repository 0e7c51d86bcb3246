// The only source that includes Assimp.

#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cstring>
#include <new>
#include <vector>

#include "armlet/core/error.hpp"
#include "converter/file_checks.hpp"
#include "converter/importers.hpp"

// Debian's Assimp ends the process when one of its assertions fails; this function is linked first
// and replaces that.
namespace Assimp {
[[gnu::visibility("default")]] void aiAssertViolation(const char* claim, const char*, int) {
  throw armlet::ArgumentError(fmt::format("Assimp did not expect !({})", claim));
}
}  // namespace Assimp

namespace armlet::mesh {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

// ---- files: the mesh, and the files that the command supplies

class GivenStream : public Assimp::IOStream {
 public:
  explicit GivenStream(std::string_view bytes) : bytes_(bytes) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    if (size == 0) return 0;
    const std::size_t whole = std::min(count, (bytes_.size() - at_) / size);
    std::memcpy(to, bytes_.data() + at_, whole * size);
    at_ += whole * size;
    return whole;
  }
  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }
  aiReturn Seek(std::size_t offset, aiOrigin from) override {
    const std::size_t base = from == aiOrigin_SET ? 0 : from == aiOrigin_CUR ? at_ : bytes_.size();
    const std::size_t to = base + offset;  // offsets below zero wrap around
    if (to > bytes_.size()) return aiReturn_FAILURE;
    at_ = to;
    return aiReturn_SUCCESS;
  }
  [[nodiscard]] std::size_t Tell() const override { return at_; }
  [[nodiscard]] std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

class GivenFiles : public Assimp::IOSystem {
 public:
  GivenFiles(const Input& input, Files& files) : input_(input), files_(files) {}

  bool Exists(const char* name) const override { return find(name) != nullptr; }
  [[nodiscard]] char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override {
    const std::string* bytes = find(name);
    if (bytes == nullptr || std::strpbrk(mode, "wa+") != nullptr) return nullptr;
    return new GivenStream(*bytes);
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  // Files other than pictures that the mesh names and that are missing.
  [[nodiscard]] const std::vector<std::string>& missed() const { return missed_; }
  // The reason why a file that exists cannot be read; empty: none.
  [[nodiscard]] const std::string& unusable() const { return unusable_; }

 private:
  [[nodiscard]] const std::string* find(const std::string& name) const {
    if (name == input_.name) return &input_.bytes;
    const GivenFile& given = files_.find(name);
    if (given.state == Say::kFile) {
      // Only materials of OBJ are read; they are checked, as the mesh is.
      if (input_.format == "obj") check_lines(given.text, name);
      return &given.text;
    }
    std::string why = fmt::format("the file \"{}\" cannot be read: {}", name, given.text);
    if (given.state == Say::kUnusable) {
      unusable_ = why;
    } else if (std::ranges::find(missed_, why) == missed_.end()) {
      missed_.push_back(std::move(why));
    }
    return nullptr;
  }

  const Input& input_;
  Files& files_;
  mutable std::vector<std::string> missed_;
  mutable std::string unusable_;
};

// ---- the scene of Assimp

Matrix4d matrix(const aiMatrix4x4& m) {
  Matrix4d out;
  out << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2, m.d3,
      m.d4;
  return out;
}

Vector3d vector(const aiVector3D& v) { return {v.x, v.y, v.z}; }

// The rotation from the axes of Assimp's scene to z up.
//
// 3DS has z up, and so have files of other formats that do not say. Assimp rotates 3DS and DAE,
// which gives its axis, to y up.
Matrix4d upright(const Input& input) {
  Matrix4d y_to_z = Matrix4d::Identity();
  y_to_z.topLeftCorner<3, 3>() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const bool is_dae = input.format == "dae";
  Matrix4d to_file = Matrix4d::Identity();
  if (input.format == "3ds") to_file = y_to_z;
  const char up = input.up != 0 ? input.up : is_dae ? 'y' : 'z';
  return up == 'y' ? y_to_z * to_file : to_file;
}

class SceneReader {
 public:
  SceneReader(const aiScene& from, SceneBuilder& to) : from_(from), to_(to) {}

  void read(const Matrix4d& T_up) {
    struct Open {
      const aiNode* node;
      Matrix4d T;
    };
    constexpr std::size_t kMostNodes = 1'000'000;
    std::size_t nodes = 0;
    std::vector<Open> open{{from_.mRootNode, T_up}};
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      if (++nodes > kMostNodes) throw ArgumentError("it has more than a million nodes");
      const Matrix4d T = next.T * matrix(next.node->mTransformation);
      for (unsigned i = 0; i < next.node->mNumMeshes; ++i) add_mesh(next.node->mMeshes[i], T);
      for (unsigned i = next.node->mNumChildren; i-- > 0;)
        open.push_back({next.node->mChildren[i], T});
    }
  }

 private:
  int material_of(const aiMesh& mesh) {
    const auto known = materials_.find(mesh.mMaterialIndex);
    if (known != materials_.end()) return known->second;
    Eigen::Vector4d color(0.8, 0.8, 0.8, 1.0);
    std::string name, texture;
    bool two_sided = false;
    if (mesh.mMaterialIndex < from_.mNumMaterials) {
      const aiMaterial& material = *from_.mMaterials[mesh.mMaterialIndex];
      aiColor4D diffuse;
      if (material.Get(AI_MATKEY_COLOR_DIFFUSE, diffuse) == aiReturn_SUCCESS)
        color = Eigen::Vector4d(diffuse.r, diffuse.g, diffuse.b, 1.0);
      float opacity = 1.0F;
      if (material.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS) color[3] = opacity;
      int sides = 0;
      if (material.Get(AI_MATKEY_TWOSIDED, sides) == aiReturn_SUCCESS) two_sided = sides != 0;
      aiString text;
      if (material.Get(AI_MATKEY_NAME, text) == aiReturn_SUCCESS) name = text.C_Str();
      for (const aiTextureType kind : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
        if (texture.empty() && material.GetTexture(kind, 0, &text) == aiReturn_SUCCESS)
          texture = text.C_Str();
      }
    }
    // A picture is shown unchanged: programs differ in how they combine a colour with
    // it.
    if (!texture.empty() || mesh.HasVertexColors(0)) color.head<3>().setOnes();
    const int index = to_.material(name, color, texture, two_sided);
    return materials_.emplace(mesh.mMaterialIndex, index).first->second;
  }

  void add_mesh(unsigned index, const Matrix4d& T) {
    if (index >= from_.mNumMeshes) throw ArgumentError("a node names a mesh that is not there");
    const aiMesh& mesh = *from_.mMeshes[index];
    if ((mesh.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) return;
    const int material = material_of(mesh);
    const Eigen::Matrix3d linear = T.topLeftCorner<3, 3>();
    const bool mirrored = linear.determinant() < 0.0;
    const Eigen::Matrix3d for_normals = cofactors(linear);
    const auto corner = [&](unsigned i) {
      if (i >= mesh.mNumVertices) {
        throw ArgumentError(fmt::format("a triangle names vertex {}, but there are {} vertices", i,
                                        mesh.mNumVertices));
      }
      Corner c;
      c.position = (T * vector(mesh.mVertices[i]).homogeneous()).head<3>();
      if (mesh.HasNormals()) c.normal = for_normals * vector(mesh.mNormals[i]);
      if (mesh.HasTextureCoords(0))
        c.on_image = Eigen::Vector2d(mesh.mTextureCoords[0][i].x, mesh.mTextureCoords[0][i].y);
      if (mesh.HasVertexColors(0)) {
        const aiColor4D& color = mesh.mColors[0][i];
        c.color = Eigen::Vector4d(color.r, color.g, color.b, color.a);
      }
      return c;
    };
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;  // points and lines
      std::array<Corner, 3> corners{corner(face.mIndices[0]), corner(face.mIndices[1]),
                                    corner(face.mIndices[2])};
      if (mirrored) std::swap(corners[1], corners[2]);
      to_.add_triangle(material, corners);
    }
  }

  // The inverse transpose times the determinant, which exists for singular matrices too.
  static Eigen::Matrix3d cofactors(const Eigen::Matrix3d& m) {
    Eigen::Matrix3d out;
    out.col(0) = m.col(1).cross(m.col(2));
    out.col(1) = m.col(2).cross(m.col(0));
    out.col(2) = m.col(0).cross(m.col(1));
    return m.determinant() < 0.0 ? Eigen::Matrix3d(-out) : out;
  }

  const aiScene& from_;
  SceneBuilder& to_;
  std::map<unsigned, int> materials_;
};

// Keeps only the reader of Assimp for this extension: the others must not be tried on the bytes.
void keep_one_reader(Assimp::Importer& importer, const std::string& format) {
  const std::size_t count = importer.GetImporterCount();
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < count; ++i) {
    const aiImporterDesc* description = importer.GetImporterInfo(i);
    const std::string endings =
        fmt::format(" {} ", description == nullptr ? "" : description->mFileExtensions);
    if (endings.find(fmt::format(" {} ", format)) == std::string::npos)
      others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* each : others) importer.UnregisterLoader(each);
}

}  // namespace

void import_with_assimp(const Input& given_input, Files& files, SceneBuilder& scene) {
  check_before_assimp(given_input);
  Input input = given_input;
  if (input.format == "stl") {
    std::vector<std::string> notes;
    input.bytes = plain_stl(given_input.bytes, notes);
    for (std::string& each : notes) scene.note(std::move(each));
  }
  Assimp::Importer importer;
  keep_one_reader(importer, input.format);
  auto* given = new GivenFiles(input, files);  // owned by the importer
  importer.SetIOHandler(given);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  constexpr unsigned kSteps =
      aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType;
  const aiScene* read = importer.ReadFile(input.name, kSteps);
  if (!given->unusable().empty()) throw ArgumentError(given->unusable());
  if (read == nullptr || read->mRootNode == nullptr) {
    std::string why = importer.GetErrorString();
    std::replace(why.begin(), why.end(), '\n', ' ');
    if (why.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    throw ArgumentError(why.empty() ? "it cannot be read"
                                    : fmt::format("it cannot be read: {}", why));
  }
  for (const std::string& each : given->missed()) scene.note(each);
  files.tell_stage("collecting triangles");
  SceneReader(*read, scene).read(upright(input));
}

}  // namespace armlet::mesh
