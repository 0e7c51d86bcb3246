#pragma once
// Writes the pictures of a video: into one video file, or each into its own picture file.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/image/image.hpp"

namespace armlet::cli {

inline constexpr int kVideoWidth = 768, kVideoHeight = 576;  // pixels of a picture
inline constexpr int kVideoRate = 25;                        // pictures a second

// A sink that goes without `finish` leaves no file that is not whole.
class VideoSink {
 public:
  virtual ~VideoSink() = default;
  // Called once it is known that the program runs. The texts are files that the video must not
  // overwrite.
  // The exit status, after a message if nothing can be written.
  virtual int open(const std::vector<std::string>& texts) = 0;
  // The exit status as above; after a failure there is nothing more to do.
  virtual int add(const Image& picture) = 0;
  virtual int finish() = 0;
};

// Null, after a message, if no video is called so.
std::unique_ptr<VideoSink> video_sink(const std::string& path);

}  // namespace armlet::cli
