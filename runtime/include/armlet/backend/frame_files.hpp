// Pictures of cameras as PNG files.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "armlet/backend/backend.hpp"
#include "armlet/core/files.hpp"

namespace armlet {

// Writes each picture that a camera takes into a folder, and passes all events on. A picture is
// passed on with the path of its file. A picture with the name of an earlier one replaces it, for
// example after an Undone.
class FrameFiles : public Backend {
 public:
  // folder  the beginning of the paths of files.
  // next    not owned; lives at least as long as this; null: events are not passed on.
  FrameFiles(std::string folder, Backend* next);

  // Opens the folder, which has to exist. Pictures before this call are not written. error() says
  // if it cannot be opened.
  void open();

  void on(const Event& event) override;
  [[nodiscard]] EventKinds ignores() const override;
  [[nodiscard]] bool wants_link_poses() const override;
  // Its own error first; otherwise that of the next backend.
  [[nodiscard]] std::string error() const override;
  [[nodiscard]] const std::string& own_error() const { return error_; }

  [[nodiscard]] std::uint64_t written() const { return written_; }
  // Whether a file of this name is a picture of this run.
  [[nodiscard]] bool has_written(const std::string& name) const { return names_.contains(name); }

 private:
  void write(ImageFrame frame);

  std::string path_;
  std::optional<Folder> folder_;
  Backend* next_;
  std::string error_;
  std::uint64_t written_ = 0;
  std::set<std::string> names_;
};

// "eye-000012.png".
[[nodiscard]] std::string frame_file_name(const ImageFrame& frame);

}  // namespace armlet
