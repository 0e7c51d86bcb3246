#pragma once
// Pictures of cameras between a program and the file system: recorded ones that take the place of
// drawn ones, and files of those that cameras took.

#include <memory>
#include <string>
#include <vector>

#include "armlet/backend/frame_files.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet::cli {

// The files of --camera NAME=FOLDER, as the frames of a session. The exit status after a message if
// a folder cannot be read or holds no pictures.
int choose_recorded_frames(const std::vector<std::string>& named, SessionOptions& session);
// The exit status after a message if the program has no camera of one of those names.
int check_recorded_frames(const HostFrames& frames, const Session& session);

// The folder of --frames, which is made if it is not there.
class FrameFolder {
 public:
  // Nothing is wanted if the path is empty.
  // next  what the pictures are passed on to with the names of their files; null: nobody.
  void choose(const std::string& path, Backend* next);
  // Once it is known that the program runs. The exit status, after a message if the folder cannot
  // be made or opened.
  int open();
  [[nodiscard]] Backend* backend() const { return files_.get(); }
  // The exit status, after a message if a picture could not be written.
  int finish() const;

 private:
  std::string path_;
  std::unique_ptr<FrameFiles> files_;
};

}  // namespace armlet::cli
