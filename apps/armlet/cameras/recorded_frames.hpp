#pragma once
// Camera pictures in files: recorded pictures that replace rendered ones, and files of the pictures
// that cameras take.

#include <memory>
#include <string>
#include <vector>

#include "armlet/backend/frame_files.hpp"
#include "armlet/stdlib/session.hpp"

namespace armlet::cli {

// Sets the frames of a session from --camera NAME=FOLDER. Returns the exit status, after a message
// if a folder cannot be read or holds no pictures.
int choose_recorded_frames(const std::vector<std::string>& named, SessionOptions& session);
// The exit status, after a message if the program has no camera with one of these names.
int check_recorded_frames(const HostFrames& frames, const Session& session);

// The folder of --frames; it is made if it does not exist.
class FrameFolder {
 public:
  // path  empty: no pictures are written.
  // next  receives the pictures with the names of their files; null: nobody does.
  void choose(const std::string& path, Backend* next);
  // Called once the program is known to run. Returns the exit status, after a message if the folder
  // cannot be made or opened.
  int open();
  [[nodiscard]] Backend* backend() const { return files_.get(); }
  // Returns the exit status, after a message if a picture could not be written.
  int finish() const;

 private:
  std::string path_;
  std::unique_ptr<FrameFiles> files_;
};

}  // namespace armlet::cli
