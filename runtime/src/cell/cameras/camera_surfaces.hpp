#pragma once
// The contents of a cell as surfaces that cameras draw.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "armlet/camera/scene.hpp"
#include "armlet/cell/cameras.hpp"
#include "armlet/cell/cell.hpp"

namespace armlet {

// Surfaces of objects and drawings by name, made again when their looks change, and forgotten when a
// scene is made without them.
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
    std::uint64_t scene = 0;  // the last one that it was in
  };
  struct KeptDrawing {
    DrawingKind kind;
    Eigen::Vector3d size;
    std::string color;
    SceneBody body;
    std::uint64_t scene = 0;
  };
  const SceneBody& body_of(const Object& object);
  const SceneBody* body_of(const Drawing& drawing);  // null: a text

  std::uint64_t scene_ = 0;  // how many were made
  std::map<std::string, KeptObject, std::less<>> objects_;
  std::map<std::string, KeptDrawing, std::less<>> drawings_;
};

}  // namespace armlet
