// Common parts of the sources that use OpenCV: conversions of pictures, results, and a wrapper that
// catches all exceptions.
#pragma once

#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "vision/opencv_door.hpp"

namespace armlet::room {

// An operation that is refused; its message continues a sentence.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The pixels of a picture, neither copied nor changed.
inline cv::Mat mat_of(const DoorPicture& picture) {
  return {picture.height, picture.width, picture.channels == 3 ? CV_8UC3 : CV_8UC1,
          const_cast<std::uint8_t*>(picture.pixels)};
}

inline void give(const DoorResult& result, const std::vector<double>& numbers) {
  double* const room = result.numbers(result.context, numbers.size());
  if (room == nullptr) throw std::bad_alloc();
  std::copy(numbers.begin(), numbers.end(), room);
}

inline void give(const DoorResult& result, const cv::Mat& picture) {
  std::uint8_t* const room =
      result.picture(result.context, picture.cols, picture.rows, picture.channels());
  if (room == nullptr) throw std::bad_alloc();
  const std::size_t row = static_cast<std::size_t>(picture.cols) * picture.elemSize();
  for (int y = 0; y < picture.rows; ++y) std::copy_n(picture.ptr(y), row, room + row * y);
}

inline std::vector<cv::Point2d> points_of(const DoorNumbers& numbers) {
  std::vector<cv::Point2d> points;
  for (std::size_t i = 0; i + 1 < numbers.count; i += 2)
    points.emplace_back(numbers.values[i], numbers.values[i + 1]);
  return points;
}
inline std::vector<cv::Point3d> space_points_of(const DoorNumbers& numbers) {
  std::vector<cv::Point3d> points;
  for (std::size_t i = 0; i + 2 < numbers.count; i += 3)
    points.emplace_back(numbers.values[i], numbers.values[i + 1], numbers.values[i + 2]);
  return points;
}

// Wraps work(input, result) as a function of the interface and converts its exceptions to a
// DoorEnd.
template <auto kWork>
DoorEnd guarded(const DoorInput* input, const DoorResult* result) noexcept {
  try {
    cv::theRNG() = cv::RNG(1);  // for results that do not depend on earlier calls
    kWork(*input, *result);
    return DoorEnd::kDone;
  } catch (const std::bad_alloc&) {
    return DoorEnd::kNoMemory;
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) return DoorEnd::kNoMemory;
    result->refuse(result->context, error.err.c_str());
  } catch (const std::exception& error) {
    result->refuse(result->context, error.what());
  }
  return DoorEnd::kRefused;
}

// features.cpp
void edges(const DoorInput& input, const DoorResult& result);
void lines(const DoorInput& input, const DoorResult& result);
void circles(const DoorInput& input, const DoorResult& result);
void match(const DoorInput& input, const DoorResult& result);
void fast(const DoorInput& input, const DoorResult& result);
// shapes.cpp
void contours(const DoorInput& input, const DoorResult& result);
void polygon(const DoorInput& input, const DoorResult& result);
void adaptive(const DoorInput& input, const DoorResult& result);
void morphology(const DoorInput& input, const DoorResult& result);
void flow(const DoorInput& input, const DoorResult& result);
// geometry.cpp
void markers(const DoorInput& input, const DoorResult& result);
void marker(const DoorInput& input, const DoorResult& result);
void pose(const DoorInput& input, const DoorResult& result);
void calibrate(const DoorInput& input, const DoorResult& result);
void hand_eye(const DoorInput& input, const DoorResult& result);
void undistort(const DoorInput& input, const DoorResult& result);

}  // namespace armlet::room
