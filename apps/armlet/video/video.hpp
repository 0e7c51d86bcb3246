#pragma once
// A video of the cell: armlet run FILE --video FILE.mp4, or --video FOLDER/ for its pictures.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "armlet/cell/cameras.hpp"
#include "armlet/cell/overview.hpp"
#include "video/kept_scenes.hpp"
#include "video/video_sink.hpp"

namespace armlet::cli {

// Keeps what the cell looks like 25 times in a second of virtual time, and draws it when the run
// has ended: only then it is known what has to be in the pictures, which are all taken from one
// viewpoint.
class Video {
 public:
  static constexpr std::size_t kMostPictures = std::size_t{30} * 60 * kVideoRate;

  // The exit status, after a message if no video is called so; empty: none is wanted.
  int choose(const std::string& path);
  [[nodiscard]] bool is_wanted() const { return sink_ != nullptr; }
  // Called once it is known that the program runs. The texts are files that the video must not
  // overwrite. Returns the exit status, after a message if the video cannot be written.
  int open(const std::vector<std::string>& texts);
  // To be called before time goes on from an instant, at least at each multiple of 10 ms, when all
  // that happens there has happened (HostOptions::pace).
  void look(const Cell& cell);
  // Draws the pictures, the last one of the cell as it is now, and writes them.
  //
  // talks    says how far it is, and what it left.
  // returns  the exit status, after a message if the video cannot be written.
  int finish(const Cell& cell, bool talks);

 private:
  void keep(const Cell& cell);
  int draw(bool talks);

  std::string path_;
  std::unique_ptr<VideoSink> sink_;
  Cameras cameras_;  // keeps the surfaces of what is drawn
  Overview view_{kVideoWidth, kVideoHeight};
  KeptScenes scenes_;
  std::int64_t last_look_ns_ = -1;
  std::int64_t end_ns_ = 0;
  bool is_cut_ = false;  // the run went on
};

}  // namespace armlet::cli
