// The interface to OpenCV, which is loaded when one of its functions is first called. It consists
// of plain numbers and functions: no header of OpenCV is used outside of runtime/src/vision/opencv,
// and no exception leaves that folder.
#pragma once

#include <cstddef>
#include <cstdint>

namespace armlet {

// Pixels of 8 bits in rows without gaps, one or three channels; null: no picture.
struct DoorPicture {
  int width;
  int height;
  int channels;
  const std::uint8_t* pixels;
};

// Consecutive numbers.
struct DoorNumbers {
  const double* values;
  std::size_t count;
};

// Callbacks for results. Each is called at most once.
//
// numbers  memory for this many numbers; null: there is none.
// picture  memory for pixels; null: there is none.
// refuse   why there is no result: a sentence without capital and full stop.
struct DoorResult {
  void* context;
  double* (*numbers)(void* context, std::size_t count);
  std::uint8_t* (*picture)(void* context, int width, int height, int channels);
  void (*refuse)(void* context, const char* why);
};

enum class DoorEnd : int { kDone, kRefused, kNoMemory };

// The arguments of a function. Each function uses some of them.
struct DoorInput {
  DoorPicture picture;
  DoorPicture other;
  DoorNumbers numbers[3];
  const double* options;
};

// Functions of the library, with arguments and results.
//
// edges       picture; options: low, high. -> picture
// lines       picture of 0 and 255; options: votes, least length, largest gap.
//             -> x0, y0, x1, y1 for each
// circles     picture; options: least and largest radius, distance, edge, roundness. -> x, y, r
// match       picture, other; -> x, y, score
// fast        picture; options: threshold. -> x, y, response
// contours    picture; options: holes too, least area. -> count, then n, x, y, x, y ... for each
// polygon     numbers 0: x, y; options: tolerance. -> x, y
// adaptive    picture; options: radius, offset, Gaussian. -> picture
// morphology  picture; options: operation (0 erode, 1 dilate), radius, disc. -> picture
// flow        picture, other, numbers 0: x, y; options: window, levels. -> x, y, found, way back
// markers     picture; options: dictionary. -> id, x0, y0 ... x3, y3
// marker      options: dictionary, id, cell. -> picture
// pose        numbers 0: x, y, z; 1: x/z, y/z. -> rotation by rows, translation
// calibrate   numbers 0: x, y, z of all views; 1: u, v; 2: points of each view; options: width,
//             height, terms of distortion. -> fx, fy, cx, cy, distortion 5, rms, deviations 9, then
//             rotation by rows and translation of each view
// hand_eye    numbers 0: rotation by rows and translation of the tool in the world, 1: of the
//             target in the camera; options: method. -> rotation by rows, translation
// undistort   picture; options: fx, fy, cx, cy, distortion 5. -> picture
using DoorFunction = DoorEnd (*)(const DoorInput*, const DoorResult*);
struct OpencvDoor {
  DoorFunction edges, lines, circles, match, fast;
  DoorFunction contours, polygon, adaptive, morphology, flow;
  DoorFunction markers, marker, pose, calibrate, hand_eye, undistort;
};

using OpenOpencvDoor = const OpencvDoor* (*)();
inline constexpr const char* kOpenOpencvDoor = "armlet_open_opencv_door";
inline constexpr const char* kOpencvLibrary = "libarmlet_vision.so";

}  // namespace armlet
