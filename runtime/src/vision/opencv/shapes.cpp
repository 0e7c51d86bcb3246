// Contours, thresholds, morphology and optical flow.

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "vision/opencv/room.hpp"

namespace armlet::room {

void contours(const DoorInput& input, const DoorResult& result) {
  constexpr std::size_t kMost = 10'000;
  std::vector<std::vector<cv::Point>> found;
  const bool holes = input.options[0] != 0.0;
  cv::findContours(mat_of(input.picture), found, holes ? cv::RETR_LIST : cv::RETR_EXTERNAL,
                   cv::CHAIN_APPROX_NONE);
  std::reverse(found.begin(), found.end());  // OpenCV finds them from the last row to the first
  std::vector<double> numbers{0.0};
  for (const auto& contour : found) {
    if (cv::contourArea(contour) < input.options[1]) continue;
    numbers.front() += 1.0;
    if (numbers.front() > kMost)
      throw Refused("it has more than " + std::to_string(kMost) + " contours: raise `minArea`");
    numbers.push_back(static_cast<double>(contour.size()));
    for (const cv::Point& p : contour) {
      numbers.push_back(p.x);
      numbers.push_back(p.y);
    }
  }
  give(result, numbers);
}

void polygon(const DoorInput& input, const DoorResult& result) {
  std::vector<cv::Point2f> curve, corners;
  for (const cv::Point2d& p : points_of(input.numbers[0])) curve.emplace_back(p);
  cv::approxPolyDP(curve, corners, input.options[0], true);
  std::vector<double> numbers;
  for (const cv::Point2f& p : corners) {
    numbers.push_back(p.x);
    numbers.push_back(p.y);
  }
  give(result, numbers);
}

void adaptive(const DoorInput& input, const DoorResult& result) {
  const int size = 2 * static_cast<int>(input.options[0]) + 1;
  cv::Mat found;
  cv::adaptiveThreshold(
      mat_of(input.picture), found, 255.0,
      input.options[2] != 0.0 ? cv::ADAPTIVE_THRESH_GAUSSIAN_C : cv::ADAPTIVE_THRESH_MEAN_C,
      cv::THRESH_BINARY, size, input.options[1]);
  give(result, found);
}

void morphology(const DoorInput& input, const DoorResult& result) {
  const int size = 2 * static_cast<int>(input.options[1]) + 1;
  const cv::Mat mask = cv::getStructuringElement(
      input.options[2] != 0.0 ? cv::MORPH_ELLIPSE : cv::MORPH_RECT, cv::Size(size, size));
  cv::Mat found;
  cv::morphologyEx(mat_of(input.picture), found,
                   input.options[0] != 0.0 ? cv::MORPH_DILATE : cv::MORPH_ERODE, mask);
  give(result, found);
}

void flow(const DoorInput& input, const DoorResult& result) {
  std::vector<cv::Point2f> start, there, back;
  for (const cv::Point2d& p : points_of(input.numbers[0])) start.emplace_back(p);
  const cv::Mat first = mat_of(input.picture), second = mat_of(input.other);
  const int window = static_cast<int>(input.options[0]);
  const int levels = static_cast<int>(input.options[1]);
  const cv::TermCriteria end(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 30, 0.01);
  std::vector<std::uint8_t> found, found_back;
  cv::calcOpticalFlowPyrLK(first, second, start, there, found, cv::noArray(), {window, window},
                           levels, end);
  cv::calcOpticalFlowPyrLK(second, first, there, back, found_back, cv::noArray(), {window, window},
                           levels, end);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double error = std::hypot(back[i].x - start[i].x, back[i].y - start[i].y);
    const bool is_found = found[i] != 0 && found_back[i] != 0 && std::isfinite(error);
    numbers.insert(numbers.end(), {there[i].x, there[i].y, is_found ? 1.0 : 0.0, error});
  }
  give(result, numbers);
}

}  // namespace armlet::room
