#pragma once
// The door to the library that writes videos, which is loaded when --video is given. Plain numbers
// and functions go through it: no header of OpenCV is seen outside of apps/armlet/video/opencv, and
// no exception leaves it.

#include <cstdint>

namespace armlet::cli {

// path    ends in .mp4 or .mkv; an existing file is written over.
// width, height  pixels of a picture, even numbers.
// rate    pictures a second.
struct VideoFormat {
  const char* path;
  int width;
  int height;
  double rate;
};

// Why something was refused, called at most once: a sentence without capital and full stop.
struct VideoRefusal {
  void* context;
  void (*say)(void* context, const char* why);
};

// open   null: refused.
// add    a picture of RGB in rows without gaps. False: refused.
// close  ends the file and reads it back whole. False: refused. The video is gone in any case.
// drop   ends it without looking at it.
struct VideoDoor {
  void* (*open)(const VideoFormat* format, const VideoRefusal* refusal);
  bool (*add)(void* video, const std::uint8_t* rgb, const VideoRefusal* refusal);
  bool (*close)(void* video, const VideoRefusal* refusal);
  void (*drop)(void* video);
};

using OpenVideoDoor = const VideoDoor* (*)();
inline constexpr const char* kOpenVideoDoor = "armlet_open_video_door";
inline constexpr const char* kVideoLibrary = "libarmlet_video.so";

// Null: there is no such library.
const VideoDoor* video_door();

}  // namespace armlet::cli
