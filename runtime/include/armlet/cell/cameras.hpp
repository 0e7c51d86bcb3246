#pragma once
// Cameras of a cell: where they are, and what they see now.

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/camera/ground_truth.hpp"
#include "armlet/camera/pinhole.hpp"
#include "armlet/camera/scene.hpp"
#include "armlet/cell/kept_pictures.hpp"
#include "armlet/image/image.hpp"
#include "armlet/math/eigen_layout.hpp"
#include "armlet/model/link_shapes.hpp"  // its kFlange would shadow that of world.hpp
#include "armlet/world/world.hpp"

namespace armlet {

class Cell;

// A camera that is mounted on the world, an object, a frame or a link of a robot.
//
// T_on_camera  pose of the camera in the frame that it is mounted on: z forward, x right, y down.
// samples      1 or 4 in each pixel.
// noise        standard deviation of Gaussian noise in colours, grey levels, 0 to 255.
// blur         standard deviation of a Gaussian filter over the picture, px, 0 to 30.
// seed         of the noise; each picture gets different noise.
// key_light    true: shading and shadows; false: every surface has its own colour.
// rate         pictures a second, kLeastRate to kMostRate: one at each multiple of the period. 0: a
//              picture is taken whenever one is asked for.
// ground       whether the ground is drawn, at the height of the world's floor or at 0.
struct Camera {
  std::string name;
  Mount on{};
  Eigen::Isometry3d T_on_camera = Eigen::Isometry3d::Identity();
  Pinhole lens{Intrinsics{}};
  int samples = 4;
  double noise = 0.0;
  double blur = 0.0;
  std::uint64_t seed = 1;
  bool key_light = true;
  bool ground = true;
  double rate = 0.0;
};

// The cameras of a cell. They see the objects, the robots with their grippers, and the shapes that
// are only shown, except texts; transparent shapes are seen as solid. Surfaces are made when the
// first picture is taken, and kept until one is taken after their objects are gone.
class Cameras {
 public:
  static constexpr int kMost = 100;
  static constexpr std::int64_t kMostPixels = 4'194'304;  // of a picture
  static constexpr double kLeastRate = 0.001, kMostRate = 10'000.0;

  Cameras();
  ~Cameras();
  // A copy does not share surfaces: it makes them when one of its cameras takes a picture.
  Cameras(const Cameras& other);
  Cameras& operator=(const Cameras& other);
  Cameras(Cameras&&) noexcept;
  Cameras& operator=(Cameras&&) noexcept;

  // Adds a camera and returns its number, from 0.
  //
  // throws  ArgumentError for a name that is empty or in use, more than kMost cameras or
  //         kMostPixels pixels, a setting out of range, and a matrix that is not a pose.
  int add(Camera camera);
  [[nodiscard]] int count() const { return static_cast<int>(cameras_.size()); }
  // throws  ArgumentError if no camera has this number, as do all functions that take one.
  [[nodiscard]] const Camera& at(int camera) const;

  // The present pose of a camera.
  //
  // throws  ArgumentError if what the camera is mounted on was removed.
  [[nodiscard]] Eigen::Isometry3d T_world_camera(const Cell& cell, int camera) const;
  // The pose that the camera would have if the tool point of the arm that carries it were at
  // `tool`. For a camera that no arm carries, `tool` is the camera's own frame.
  //
  // throws  ArgumentError for a camera on a link before the flange.
  [[nodiscard]] Eigen::Isometry3d T_world_camera_for(const Cell& cell, int camera,
                                                     const Eigen::Isometry3d& tool) const;

  // Everything that the camera may see at this instant.
  [[nodiscard]] Scene scene(const Cell& cell, int camera);
  // The scene for a picture that no camera of the cell takes: with the key light and the ground.
  [[nodiscard]] Scene scene(const Cell& cell);

  // Before a picture is drawn it is looked for in `kept`, and stored there afterwards; null:
  // pictures are not kept. Noise is added to each picture afresh.
  void keep_pictures(std::shared_ptr<KeptPictures> kept) { kept_ = std::move(kept); }
  // Number of pictures that each camera took. It determines the noise of the next picture. Code
  // that previews what a program would see restores it afterwards with set_taken.
  [[nodiscard]] const std::vector<std::uint64_t>& taken() const { return taken_; }
  // throws  ArgumentError for numbers of more cameras than there are.
  void set_taken(std::vector<std::uint64_t> taken);

  // An RGB picture, with blur and noise; the next one has other noise.
  [[nodiscard]] Image color(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera);
  // The picture that color would give, which does not count.
  [[nodiscard]] Image preview(const Cell& cell, int camera,
                              const Eigen::Isometry3d& T_world_camera);
  // Takes a given RGB picture instead of drawing one; it counts as a picture of the camera.
  //
  // throws  ArgumentError if it has another size or kind.
  [[nodiscard]] Image take_given(int camera, Image given);
  // Number of pictures that the camera took, which is the number of the next one.
  [[nodiscard]] std::uint64_t taken(int camera) const;
  // The first instant after now at which the camera takes a picture; now if it has no rate.
  [[nodiscard]] std::int64_t next_frame_ns(int camera, std::int64_t now_ns) const;
  // The picture that a camera with a rate took at this instant from this pose, as keep() stored it;
  // null: there is none.
  [[nodiscard]] const Image* taken_at(int camera, std::int64_t t_ns,
                                      const Eigen::Isometry3d& T_world_camera) const;
  void keep(int camera, std::int64_t t_ns, const Eigen::Isometry3d& T_world_camera,
            const Image& image);
  // Depths z in metres; 0 where no surface is seen.
  [[nodiscard]] Image depth(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera);
  // For each pixel, row by row, the number of the body in `scene`, kGroundBody or kNoBody.
  [[nodiscard]] std::vector<std::int32_t> bodies(const Cell& cell, int camera,
                                                 const Eigen::Isometry3d& T_world_camera);
  // Share of the pixels of an object that is visible, 0 to 1 (Renderer::visible_share).
  //
  // throws  ArgumentError if there is no such object; the same holds for `corners`.
  [[nodiscard]] double visible_share(const Cell& cell, int camera, std::string_view object);
  // Corners of an object that are in the picture and not hidden.
  [[nodiscard]] std::vector<SeenCorner> corners(const Cell& cell, int camera,
                                                std::string_view object);

 private:
  class Surfaces;
  class Drawer;
  // The picture before noise is added.
  [[nodiscard]] Image clean(const Cell& cell, int camera, const Eigen::Isometry3d& T_world_camera);
  struct LastTaken {
    std::int64_t t_ns = 0;
    Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
    std::shared_ptr<const Image> image;  // shared by copies
  };
  std::vector<Camera> cameras_;
  std::vector<std::uint64_t> taken_;  // how many pictures each took
  std::map<int, LastTaken> last_;     // of cameras with a rate
  std::unique_ptr<Surfaces> surfaces_;
  std::unique_ptr<Drawer> drawer_;  // null until a camera looks
  std::shared_ptr<KeptPictures> kept_;
};

}  // namespace armlet
