#include "armlet/backend/frame_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/files.hpp"

namespace armlet {

std::string frame_file_name(const ImageFrame& frame) {
  return fmt::format("{}-{:06d}.png", frame.camera, frame.frame);
}

FrameFiles::FrameFiles(std::string folder, Backend* next) : path_(std::move(folder)), next_(next) {}

void FrameFiles::open() {
  Result<Folder> opened = Folder::open(path_);
  if (opened.ok()) {
    folder_.emplace(std::move(opened).value());
  } else {
    error_ = fmt::format("The folder {} of the pictures cannot be opened: {}.", path_,
                         opened.error().message);
  }
}

void FrameFiles::on(const Event& event) {
  if (const auto* frame = std::get_if<ImageFrame>(&event)) return write(*frame);
  if (next_ != nullptr) next_->on(event);
}

void FrameFiles::write(ImageFrame frame) {
  std::string file;
  if (folder_ && error_.empty()) {
    Image image(frame.width, frame.height,
                frame.channels == 1 ? PixelKind::kGrey : PixelKind::kRgb);
    if (image.bytes().size() != frame.pixels.size())
      throw ArgumentError(fmt::format("A picture of {} x {} with {} channels has {} bytes.",
                                      frame.width, frame.height, frame.channels,
                                      frame.pixels.size()));
    std::ranges::copy(frame.pixels, image.row(0));
    const std::string name = frame_file_name(frame);
    // The steps of a program do not depend on what is written about it.
    const Supervised nobody(nullptr);
    if (const auto failed = folder_->save(name, write_png(image))) {
      error_ =
          fmt::format("The picture {}/{} cannot be written: {}.", path_, name, failed->message);
    } else {
      ++written_;
      names_.insert(name);
      file = path_.ends_with('/') ? path_ + name : path_ + "/" + name;
    }
  }
  if (next_ == nullptr) return;
  frame.file = file;
  next_->on(frame);
}

EventKinds FrameFiles::ignores() const {
  constexpr Ignore<BeginRun, RobotAdded, RobotChanged, JointSample, ObjectAdded, ObjectSample,
                   ObjectEvent, Note, FigureChanged, FinalFigure, Undone, EndRun, DrawingChanged,
                   CameraAdded>
      kOthers{};
  return next_ == nullptr ? kOthers.kinds() : next_->ignores() & kOthers.kinds();
}

bool FrameFiles::wants_link_poses() const { return next_ != nullptr && next_->wants_link_poses(); }

std::string FrameFiles::error() const {
  return !error_.empty() || next_ == nullptr ? error_ : next_->error();
}

}  // namespace armlet
