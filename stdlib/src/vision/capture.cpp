#include "vision/capture.hpp"

#include <fmt/format.h>

#include "armlet/core/checkpoint.hpp"
#include "armlet/image/files.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "values/world/pictures.hpp"

namespace armlet::bind {
namespace {

class RateFact : public Fact {
 public:
  explicit RateFact(bool rate) : has_rate(rate) {}
  const bool has_rate;
};

// The failure for a picture that the host did not supply.
Failed fail_frame(Vm& vm, const FrameRequest& asked, std::string why) {
  Failure f;
  f.headline = {row("R0686"), {std::to_string(asked.number + 1), std::string(asked.camera)}};
  f.why = std::move(why);
  f.fix = fmt::format("give an RGB picture of {} x {} for each one that the camera takes",
                      asked.width, asked.height);
  return fail(vm, std::move(f));
}

// The picture of the host, if it supplies those of this camera; nullopt: it is to be rendered.
Answer<std::optional<Image>> given_frame(Vm& vm, const Camera& camera, std::uint64_t number) {
  Host& host = Host::of(vm);
  const Intrinsics& lens = camera.lens.intrinsics();
  const FrameRequest asked{camera.name, number, host.now_ns(), lens.width, lens.height};
  const auto bytes = host.host_frame(asked);
  if (!bytes) return std::optional<Image>();
  if (!bytes->ok()) return fail_frame(vm, asked, bytes->error().message);
  Result<Image> image = [&] {
    const Supervised nobody(nullptr);  // a replay, which has the pixels, takes as many steps
    return read_image(**bytes);
  }();
  if (!image.ok()) return fail_frame(vm, asked, image.error().message);
  if (image->width() != lens.width || image->height() != lens.height) {
    return fail_frame(vm, asked,
                      fmt::format("the picture is {} x {}, and the camera takes {} x {}",
                                  image->width(), image->height(), lens.width, lens.height));
  }
  if (image->kind() != PixelKind::kRgb)
    return fail_frame(vm, asked, "the picture is grey, with one channel, and cameras take RGB");
  return std::optional<Image>(std::move(image).value());
}

// Waits until the next frame of a camera; if it is stopped before, it takes a picture then.
class FrameWaiting : public Waiting {
 public:
  FrameWaiting(Vm& vm, const CameraRef& camera, const PosC* from)
      : host_(Host::of(vm)), camera_(camera), due_ns_(next()) {
    if (from != nullptr) from_ = *from;
  }
  [[nodiscard]] std::int64_t due_ns() const override { return due_ns_; }
  [[nodiscard]] bool is_over() const override { return host_.now_ns() >= due_ns_; }
  void stop() override { due_ns_ = host_.now_ns(); }
  Signal finish(Vm& vm, Slot& result) override {
    auto image = capture(vm, camera_, from_ ? &*from_ : nullptr);
    return image ? Given<Image>::leave(vm, *std::move(image), result) : Signal::kFail;
  }
  [[nodiscard]] std::string what() const override {
    return fmt::format("the next picture of {}", host_.cell().cameras().at(camera_.id).name);
  }

 private:
  [[nodiscard]] std::int64_t next() const {
    return host_.cell().cameras().next_frame_ns(camera_.id, host_.now_ns());
  }

  Host& host_;
  CameraRef camera_;
  std::optional<PosC> from_;
  std::int64_t due_ns_;
};

}  // namespace

void note_rate(CheckCall& call, CallPart rate) {
  call.set_result_fact(std::make_shared<RateFact>(call.given(rate)));
}

void check_rate(CheckCall& call, CallPart camera) {
  const auto known = std::dynamic_pointer_cast<const RateFact>(call.fact(camera));
  if (known ? known->has_rate : !call.declared_names("camera.rate").empty()) call.take_time();
}

Answer<Image> capture(Vm& vm, const CameraRef& camera, const PosC* from) try {
  Cell& cell = Host::of(vm).cell();
  const Eigen::Isometry3d T_world_camera =
      from == nullptr ? cell.cameras().T_world_camera(cell, camera.id)
                      : cell.cameras().T_world_camera_for(cell, camera.id, from->T);
  // A row of a page may be read at any time: reading must not change the run.
  if (is_reading(vm)) return cell.cameras().preview(cell, camera.id, T_world_camera);
  // Another task has already taken the frame of this instant.
  if (const Image* taken = cell.cameras().taken_at(camera.id, cell.now_ns(), T_world_camera))
    return *taken;
  auto given = given_frame(vm, cell.cameras().at(camera.id), cell.cameras().taken(camera.id));
  if (!given) return Failed{};
  return cell.capture(camera.id, T_world_camera, *std::move(given));
} catch (const ArgumentError& error) {
  return fail_blind(vm, clause_of(error));
}

Answer<std::unique_ptr<Waiting>> capture_next(Vm& vm, const CameraRef& camera, const PosC* from) {
  std::unique_ptr<Waiting> waiting = std::make_unique<FrameWaiting>(vm, camera, from);
  return waiting;
}

}  // namespace armlet::bind
