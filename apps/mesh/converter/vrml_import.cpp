// The only source that includes Coin.

#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLAppearance.h>
#include <Inventor/VRMLnodes/SoVRMLColor.h>
#include <Inventor/VRMLnodes/SoVRMLCoordinate.h>
#include <Inventor/VRMLnodes/SoVRMLElevationGrid.h>
#include <Inventor/VRMLnodes/SoVRMLExtrusion.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedFaceSet.h>
#include <Inventor/VRMLnodes/SoVRMLIndexedLineSet.h>
#include <Inventor/VRMLnodes/SoVRMLMaterial.h>
#include <Inventor/VRMLnodes/SoVRMLMovieTexture.h>
#include <Inventor/VRMLnodes/SoVRMLNormal.h>
#include <Inventor/VRMLnodes/SoVRMLPixelTexture.h>
#include <Inventor/VRMLnodes/SoVRMLPointSet.h>
#include <Inventor/VRMLnodes/SoVRMLShape.h>
#include <Inventor/VRMLnodes/SoVRMLText.h>
#include <Inventor/VRMLnodes/SoVRMLTextureCoordinate.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/elements/SoMultiTextureEnabledElement.h>
#include <Inventor/errors/SoDebugError.h>
#include <Inventor/errors/SoMemoryError.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/misc/SoChildList.h>
#include <fmt/format.h>

#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "armlet/core/error.hpp"
#include "converter/importers.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

using Eigen::Vector3d;

// ---- messages of Coin while it reads

std::string first_error;  // Coin's callbacks have no argument to store them

void note_error(const SoError* error, void*) {
  const std::string text = error->getDebugString().getString();
  // Nothing moves here, so routes of events without a target do not matter.
  if (!first_error.empty() || text.find("ROUTE") != std::string::npos) return;
  first_error = text;
  for (char& c : first_error) {
    if (c == '\n' || c == '\t') c = ' ';
  }
}

// ---- checks of the graph before it is traversed

// Visits every node once, refuses loops, and counts the visible nodes, also those that are reused.
class GraphCheck {
 public:
  void look(SoNode* node) {
    constexpr double kMost = 1e7;
    if (count(node) > kMost)
      refuse("nodes that are used again and again show more than 10 million shapes");
  }

 private:
  double count(SoNode* node) {
    constexpr int kDeepest = 2000;
    if (node == nullptr) return 0.0;
    const auto known = shown_.find(node);
    if (known != shown_.end()) return known->second;
    if (!open_.insert(node).second) refuse("a node contains itself (USE inside of its own DEF)");
    if (static_cast<int>(open_.size()) > kDeepest)
      refuse("it has more than 2000 nodes in one another");
    check(node);
    double sum = 1.0;
    const SoChildList* children = node->getChildren();
    for (int i = 0; children != nullptr && i < children->getLength(); ++i)
      sum += count((*children)[i]);
    open_.erase(node);
    shown_[node] = sum;
    return sum;
  }

  void check(SoNode* node) {
    if (auto* faces = dynamic_cast<SoVRMLIndexedFaceSet*>(node)) check_faces(*faces);
    if (auto* grid = dynamic_cast<SoVRMLElevationGrid*>(node)) check_grid(*grid);
    if (auto* extrusion = dynamic_cast<SoVRMLExtrusion*>(node)) check_extrusion(*extrusion);
  }

  // Checks that every index is -1 or below `count`.
  static void check_indices(const SoMFInt32& list, int count, const char* name, const char* what) {
    for (int i = 0; i < list.getNum(); ++i) {
      if (list[i] < -1 || list[i] >= count) {
        refuse(fmt::format("`{}` {} is {}, but there are {} {}", name, i, list[i], count, what));
      }
    }
  }

  template <class T>
  static int count_of(const SoSFNode& field, SoMFVec3f T::*list) {
    auto* node = dynamic_cast<T*>(field.getValue());
    return node == nullptr ? 0 : (node->*list).getNum();
  }

  static void check_faces(SoVRMLIndexedFaceSet& faces) {
    const int points = count_of(faces.coord, &SoVRMLCoordinate::point);
    check_indices(faces.coordIndex, points, "coordIndex", "points");
    int corners = 0, polygons = 0, open = 0, largest = -1;
    for (int i = 0; i < faces.coordIndex.getNum(); ++i) {
      largest = std::max<int>(largest, faces.coordIndex[i]);
      if (faces.coordIndex[i] < 0) {
        ++polygons;
        open = 0;
      } else {
        ++corners;
        ++open;
      }
    }
    if (open > 0) ++polygons;
    const auto check_list = [&](const SoMFInt32& list, bool per_vertex, int count, const char* name,
                                const char* what) {
      if (count == 0) return;
      check_indices(list, count, name, what);
      // One per corner including the ends of polygons, or one per polygon, or up to the largest
      // index.
      const int listed = list.getNum();
      const int wanted = per_vertex ? faces.coordIndex.getNum() : polygons;
      const bool by_index = listed > 0;
      if (by_index && listed < (per_vertex ? wanted - 1 : wanted))
        refuse(fmt::format("`{}` has {} indices; expected {}", name, listed, wanted));
      const int needed = by_index ? 0 : per_vertex ? largest + 1 : polygons;
      if (count < needed) refuse(fmt::format("there are {} {}; expected {}", count, what, needed));
    };
    const auto* on_image = dynamic_cast<SoVRMLTextureCoordinate*>(faces.texCoord.getValue());
    if (on_image != nullptr)
      check_list(faces.texCoordIndex, true, on_image->point.getNum(), "texCoordIndex",
                 "texture coordinates");
    const auto* normals = dynamic_cast<SoVRMLNormal*>(faces.normal.getValue());
    if (normals != nullptr)
      check_list(faces.normalIndex, faces.normalPerVertex.getValue() != 0, normals->vector.getNum(),
                 "normalIndex", "normals");
    const auto* colors = dynamic_cast<SoVRMLColor*>(faces.color.getValue());
    if (colors != nullptr)
      check_list(faces.colorIndex, faces.colorPerVertex.getValue() != 0, colors->color.getNum(),
                 "colorIndex", "colours");
  }

  static void check_grid(SoVRMLElevationGrid& grid) {
    const double x = grid.xDimension.getValue(), z = grid.zDimension.getValue();
    if (x < 0 || z < 0 || x * z > grid.height.getNum()) {
      refuse(fmt::format("an ElevationGrid of {} x {} has {} heights", x, z, grid.height.getNum()));
    }
    const double cells = std::max(x - 1, 0.0) * std::max(z - 1, 0.0);
    const auto check_count = [&](int count, bool per_vertex, const char* what) {
      if (count < (per_vertex ? x * z : cells))
        refuse(fmt::format("an ElevationGrid of {} x {} has {} {}", x, z, count, what));
    };
    if (auto* each = dynamic_cast<SoVRMLColor*>(grid.color.getValue()))
      check_count(each->color.getNum(), grid.colorPerVertex.getValue() != 0, "colours");
    if (auto* each = dynamic_cast<SoVRMLNormal*>(grid.normal.getValue()))
      check_count(each->vector.getNum(), grid.normalPerVertex.getValue() != 0, "normals");
    if (auto* each = dynamic_cast<SoVRMLTextureCoordinate*>(grid.texCoord.getValue()))
      check_count(each->point.getNum(), true, "texture coordinates");
  }

  static void check_extrusion(SoVRMLExtrusion& extrusion) {
    const int spine = extrusion.spine.getNum(), section = extrusion.crossSection.getNum();
    if (spine < 2 || section < 2)
      refuse("an Extrusion needs two points of its spine and two of its cross-section");
    for (const int count : {extrusion.scale.getNum(), extrusion.orientation.getNum()}) {
      if (count != 1 && count < spine)
        refuse(fmt::format("an Extrusion with {} points of its spine has {} scales or orientations",
                           spine, count));
    }
    if (static_cast<double>(spine) * section > 4e6)
      refuse("an Extrusion has more than 4 million points");
  }

  std::unordered_map<SoNode*, double> shown_;
  std::unordered_set<SoNode*> open_;
};

// ---- triangles

class Collector {
 public:
  Collector(SceneBuilder& to, bool y_up) : to_(to), y_up_(y_up) {}

  void collect(SoNode* root) {
    SoCallbackAction action(SbViewportRegion(100, 100));
    action.addPreCallback(SoVRMLShape::getClassTypeId(), begin_shape, this);
    for (const SoType type : {SoVRMLText::getClassTypeId(), SoVRMLIndexedLineSet::getClassTypeId(),
                              SoVRMLPointSet::getClassTypeId()})
      action.addPreCallback(type, pass_over, this);
    action.addPreCallback(SoVRMLGeometry::getClassTypeId(), begin_geometry, this);
    action.addTriangleCallback(SoVRMLGeometry::getClassTypeId(), take_triangle, this);
    action.apply(root);
    if (!fault_.empty()) refuse(fault_);
  }

 private:
  static SoCallbackAction::Response pass_over(void*, SoCallbackAction*, const SoNode*) {
    return SoCallbackAction::PRUNE;
  }

  static SoCallbackAction::Response begin_shape(void* self, SoCallbackAction*, const SoNode* node) {
    auto& me = *static_cast<Collector*>(self);
    if (!me.fault_.empty()) return SoCallbackAction::ABORT;
    // No exception may leave a callback of Coin.
    try {
      me.begin(*static_cast<const SoVRMLShape*>(node));
    } catch (const std::exception& error) {
      me.fault_ = error.what();
      return SoCallbackAction::ABORT;
    }
    return SoCallbackAction::CONTINUE;
  }

  // Coin provides texture coordinates only if a texture is shown.
  static SoCallbackAction::Response begin_geometry(void* self, SoCallbackAction* action,
                                                   const SoNode*) {
    if (!static_cast<Collector*>(self)->texture_.empty())
      SoMultiTextureEnabledElement::set(action->getState(), TRUE);
    return SoCallbackAction::CONTINUE;
  }

  static void take_triangle(void* self, SoCallbackAction* action, const SoPrimitiveVertex* a,
                            const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
    auto& me = *static_cast<Collector*>(self);
    if (!me.fault_.empty()) return;
    try {
      me.take(*action, {a, b, c});
    } catch (const std::exception& error) {
      me.fault_ = error.what();
    }
  }

  void begin(const SoVRMLShape& shape) {
    color_ = Eigen::Vector4d(0.8, 0.8, 0.8, 1.0);
    texture_.clear();
    if (const auto* look = dynamic_cast<SoVRMLAppearance*>(shape.appearance.getValue())) {
      if (const auto* m = dynamic_cast<SoVRMLMaterial*>(look->material.getValue())) {
        const SbColor c = m->diffuseColor.getValue();
        color_ = Eigen::Vector4d(c[0], c[1], c[2], 1.0 - m->transparency.getValue());
      }
      // An ImageTexture of the file (safe_vrml).
      if (const auto* t = dynamic_cast<SoVRMLMovieTexture*>(look->texture.getValue())) {
        if (t->url.getNum() > 0) texture_ = t->url[0].getString();
      } else if (dynamic_cast<SoVRMLPixelTexture*>(look->texture.getValue()) != nullptr) {
        to_.note("a PixelTexture is left out");
      }
    }
    SoNode* geometry = shape.geometry.getValue();
    bool solid = true;
    ccw_ = true;
    snapped_ = true;
    colored_ = false;
    const auto sides = [&](const auto* node) {
      if (node == nullptr) return;
      solid = node->solid.getValue() != 0;
      ccw_ = node->ccw.getValue() != 0;
    };
    sides(dynamic_cast<SoVRMLElevationGrid*>(geometry));
    sides(dynamic_cast<SoVRMLExtrusion*>(geometry));
    if (const auto* faces = dynamic_cast<SoVRMLIndexedFaceSet*>(geometry)) {
      sides(faces);
      snapped_ = false;
      colored_ = faces->color.getValue() != nullptr;
    } else if (const auto* grid = dynamic_cast<SoVRMLElevationGrid*>(geometry)) {
      colored_ = grid->color.getValue() != nullptr;
    }
    if (!texture_.empty() || colored_) color_.head<3>().setOnes();
    material_ = to_.material(shape.getName().getString(), color_, texture_, !solid);
  }

  void take(const SoCallbackAction& action, const std::array<const SoPrimitiveVertex*, 3>& from) {
    const SbMatrix& T = action.getModelMatrix();
    const SbMatrix inverse = T.det3() != 0.0F ? T.inverse().transpose() : T;
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      SbVec3f p, n;
      SbVec3f local = from[k]->getPoint();
      if (snapped_) snap(local);
      T.multVecMatrix(local, p);
      inverse.multDirMatrix(from[k]->getNormal(), n);
      corners[k].position = upright(p);
      corners[k].normal = upright(n);
      if (!texture_.empty()) {
        SbVec4f at;
        action.getTextureMatrix().multVecMatrix(from[k]->getTextureCoords(), at);
        corners[k].on_image = Eigen::Vector2d(at[0], at[1]);
      }
      if (colored_) {
        SbColor ambient, diffuse, specular, emission;
        float shine = 0, transparency = 0;
        action.getMaterial(ambient, diffuse, specular, emission, shine, transparency,
                           from[k]->getMaterialIndex());
        corners[k].color = Eigen::Vector4d(diffuse[0], diffuse[1], diffuse[2], 1.0);
      }
    }
    if ((T.det3() < 0.0F) != !ccw_) std::swap(corners[1], corners[2]);
    to_.add_triangle(material_, corners);
  }

  // Makes the end of a curved shape equal to its start in all digits.
  static void snap(SbVec3f& p) {
    constexpr float kSteps = 1 << 20;
    for (int k = 0; k < 3; ++k) {
      if (std::abs(p[k]) < 1e4F) p[k] = std::round(p[k] * kSteps) / kSteps;
    }
  }

  [[nodiscard]] Vector3d upright(const SbVec3f& p) const {
    return y_up_ ? Vector3d(p[0], -p[2], p[1]) : Vector3d(p[0], p[1], p[2]);
  }

  SceneBuilder& to_;
  bool y_up_;
  std::string fault_;
  Eigen::Vector4d color_;
  std::string texture_;
  int material_ = 0;
  bool ccw_ = true, snapped_ = false, colored_ = false;
};

}  // namespace

void prepare_vrml() {
  SoDB::init();
  SoReadError::setHandlerCallback(note_error, nullptr);
  SoDebugError::setHandlerCallback([](const SoError*, void*) {}, nullptr);
  SoMemoryError::setHandlerCallback(note_error, nullptr);
}

void import_vrml(const Input& input, Files& files, SceneBuilder& scene) {
  SoInput from;
  const std::string text = safe_vrml(input.bytes);
  from.setBuffer(text.data(), text.size());
  SoVRMLGroup* root = SoDB::readAllVRML(&from);
  if (root == nullptr || !first_error.empty()) {
    refuse(first_error.empty() ? "it cannot be read"
                               : fmt::format("it cannot be read: {}", first_error));
  }
  root->ref();
  GraphCheck().look(root);
  files.tell_stage("collecting triangles");
  Collector(scene, input.up != 'z').collect(root);
}

}  // namespace armlet::mesh
