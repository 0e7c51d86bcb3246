// Pictures and marks of rows with cameras and with computed pictures.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/image/arithmetic.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "armlet/vision/corners.hpp"
#include "session/run.hpp"
#include "values/values.hpp"
#include "values/world/pictures.hpp"

namespace armlet {
namespace {

constexpr Eigen::Index kMostMarks = 2000;  // of one kind

// While it lives, pictures taken for the page do not change the later pictures of the program.
class Unnoticed {
 public:
  explicit Unnoticed(Cameras& cameras) : cameras_(cameras), taken_(cameras.taken()) {}
  ~Unnoticed() { cameras_.set_taken(std::move(taken_)); }
  Unnoticed(const Unnoticed&) = delete;
  Unnoticed& operator=(const Unnoticed&) = delete;

 private:
  Cameras& cameras_;
  std::vector<std::uint64_t> taken_;
};

Value value_of(const Image& image) {
  auto kept = std::make_shared<bind::KeptPicture>();
  kept->image = image;
  return Value::Host{&bind::kImage, std::make_shared<const bind::PictureValue>(
                                        bind::PictureValue{std::move(kept)})};
}

// The picture in a value; null: it holds none.
const Image* picture_in(const Value& value) {
  const auto* host = value.get_if<Value::Host>();
  if (host == nullptr || host->type != &bind::kImage) return nullptr;
  return &static_cast<const bind::PictureValue*>(host->value.get())->kept->image;
}

std::vector<std::array<double, 2>> pixels_in(const PlanePoints& points) {
  std::vector<std::array<double, 2>> pixels;
  for (Eigen::Index i = 0; i < std::min(points.rows(), kMostMarks); ++i)
    pixels.push_back({points(i, 0), points(i, 1)});
  return pixels;
}

// The rows of a matrix of the program that are pixels of the picture; the others are left out.
std::vector<std::array<double, 2>> pixels_in(const Value::Matrix& matrix) {
  std::vector<std::array<double, 2>> pixels;
  for (std::size_t i = 0; i + 1 < matrix.elements.size() && pixels.size() < kMostMarks; i += 2) {
    const std::array<double, 2> pixel{matrix.elements[i], matrix.elements[i + 1]};
    if (std::isfinite(pixel[0]) && std::isfinite(pixel[1])) pixels.push_back(pixel);
  }
  return pixels;
}

std::vector<LabMarks> true_corners(Cell& cell, int camera) {
  std::vector<LabMarks> marks;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cell.world().size() && count < kMostMarks; ++i) {
    const std::string& name = cell.world().object(i).name;
    LabMarks each{.what = "truth", .object = name};
    for (const SeenCorner& corner : cell.cameras().corners(cell, camera, name))
      each.pixels.push_back({corner.pixel.x(), corner.pixel.y()});
    count += each.pixels.size();
    if (!each.pixels.empty()) marks.push_back(std::move(each));
  }
  return marks;
}

int camera_named(const Cameras& cameras, std::string_view name) {
  for (int i = 0; i < cameras.count(); ++i)
    if (cameras.at(i).name == name) return i;
  throw ArgumentError(fmt::format("There is no camera `{}`.", name));
}

}  // namespace

Result<Value> LabControls::call(const LabRow& row, std::span<const Value> arguments) {
  const Unnoticed unnoticed(session_.run_->host->cell().cameras());
  try {
    return read_function(*session_.run_->vm, fmt::format("{}.{}", rows()->name, row.name),
                         arguments);
  } catch (const ArgumentError& error) {
    return Error{"failed", error.what()};
  }
}

Image LabControls::seen(const LabRow& view) {
  Cell& cell = session_.run_->host->cell();
  Cameras& cameras = cell.cameras();
  const int camera = camera_named(cameras, view.camera);
  const Unnoticed unnoticed(cameras);
  return cameras.color(cell, camera, cameras.T_world_camera(cell, camera));
}

Result<Value> LabControls::features(const LabRow& view, const Image& image) {
  const std::vector<Value> arguments =
      view.takes_picture ? std::vector<Value>{value_of(image)} : std::vector<Value>();
  Result<Value> value = call(view, arguments);
  if (!value) return value;
  const auto* matrix = value->get_if<Value::Matrix>();
  if (matrix == nullptr || matrix->cols != 2) {
    return Error{
        "failed",
        fmt::format("Its function gives {} x {} numbers; pixels are the rows of an N x 2 "
                    "matrix, x first.",
                    matrix == nullptr ? 0 : matrix->rows, matrix == nullptr ? 0 : matrix->cols)};
  }
  return value;
}

Result<LabPicture> LabControls::picture(std::string_view name) {
  session_.require_idle("look at a picture");
  if (rows() == nullptr) return Error{"no lab", "The program has not come to a `lab` block."};
  const LabRow* row = rows()->find(name);
  const bool is_view = row != nullptr && row->kind == LabRowKind::kView;
  if (row == nullptr || !(is_view || (row->kind == LabRowKind::kImage && row->is_read))) {
    return Error{"unknown", fmt::format("`{}` has no view and no image that is computed `{}`.",
                                        rows()->name, name)};
  }
  try {
    if (!is_view) {
      const Result<Value> value = call(*row);
      if (!value) return value.error();
      const Image* image = picture_in(*value);
      if (image == nullptr) return Error{"failed", "Its function gives no picture."};
      return LabPicture{.image = *image};
    }
    LabPicture out{.image = seen(*row)};
    if (row->overlay == LabOverlay::kCorners)
      out.marks.push_back(
          {.what = "corner", .pixels = pixels_in(find_corners(to_grey(out.image)))});
    if (row->overlay == LabOverlay::kTruth) {
      Cell& cell = session_.run_->host->cell();
      out.marks = true_corners(cell, camera_named(cell.cameras(), row->camera));
    }
    if (!row->wanted.empty()) out.marks.push_back({.what = "wanted", .pixels = row->wanted});
    if (row->is_read) {
      const Result<Value> found = features(*row, out.image);
      if (found.ok()) {
        out.marks.push_back({.what = "feature", .pixels = pixels_in(found->get<Value::Matrix>())});
      } else {
        out.fault = found.error().message;
      }
    }
    return out;
  } catch (const ArgumentError& error) {
    return Error{"failed", error.what()};
  }
}

}  // namespace armlet
