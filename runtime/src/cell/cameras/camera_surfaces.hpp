#pragma once
// The contents of a cell as surfaces that cameras draw.

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "armlet/camera/scene.hpp"
#include "armlet/cell/cameras.hpp"
#include "armlet/cell/cell.hpp"

namespace armlet {

// Surfaces of objects and drawings by name, made again when their appearance changes.
class Cameras::Surfaces {
 public:
  // Objects in the order of the world, robots with a body for each link, drawings.
  [[nodiscard]] std::vector<SceneBody> bodies_of(const Cell& cell);

 private:
  struct KeptObject {
    Shape shape;
    std::string color;
    std::shared_ptr<const std::string> texture;
    SceneBody body;
  };
  struct KeptDrawing {
    DrawingKind kind;
    Eigen::Vector3d size;
    std::string color;
    SceneBody body;
  };
  const SceneBody& body_of(const Object& object);
  const SceneBody* body_of(const Drawing& drawing);  // null: a text

  std::map<std::string, KeptObject, std::less<>> objects_;
  std::map<std::string, KeptDrawing, std::less<>> drawings_;
};

}  // namespace armlet
