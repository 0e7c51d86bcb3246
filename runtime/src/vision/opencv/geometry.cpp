// Markers, poses, calibration and distortion.

#include <algorithm>
#include <cmath>
#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/opencv/room.hpp"

namespace armlet::room {
namespace {

cv::Ptr<cv::aruco::Dictionary> dictionary_of(double index) {
  constexpr cv::aruco::PREDEFINED_DICTIONARY_NAME kNames[] = {
      cv::aruco::DICT_4X4_50, cv::aruco::DICT_5X5_100, cv::aruco::DICT_6X6_250,
      cv::aruco::DICT_ARUCO_ORIGINAL, cv::aruco::DICT_APRILTAG_36h11};
  return cv::aruco::getPredefinedDictionary(kNames[static_cast<int>(index)]);
}

void add_pose(std::vector<double>& numbers, const cv::Matx33d& R, const cv::Vec3d& t) {
  numbers.insert(numbers.end(), R.val, R.val + 9);
  numbers.insert(numbers.end(), t.val, t.val + 3);
}

// Rotations by rows, each followed by a translation.
void read_poses(const DoorNumbers& numbers, std::vector<cv::Mat>& R, std::vector<cv::Mat>& t) {
  for (std::size_t i = 0; i + 12 <= numbers.count; i += 12) {
    R.push_back(cv::Mat(cv::Matx33d(numbers.values + i), true));
    t.push_back(cv::Mat(cv::Matx31d(numbers.values + i + 9), true));
  }
}

}  // namespace

void markers(const DoorInput& input, const DoorResult& result) {
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(mat_of(input.picture), dictionary_of(input.options[0]), corners, ids,
                           parameters);
  std::vector<std::size_t> order(ids.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  std::vector<double> numbers;
  for (const std::size_t i : order) {
    numbers.push_back(ids[i]);
    for (const cv::Point2f& corner : corners[i]) {
      numbers.push_back(corner.x);
      numbers.push_back(corner.y);
    }
  }
  give(result, numbers);
}

void marker(const DoorInput& input, const DoorResult& result) {
  const auto dictionary = dictionary_of(input.options[0]);
  const int id = static_cast<int>(input.options[1]);
  const int cell = static_cast<int>(input.options[2]);
  if (id >= dictionary->bytesList.rows) {
    throw Refused("there is no marker " + std::to_string(id) +
                  " in this dictionary; its markers are 0 to " +
                  std::to_string(dictionary->bytesList.rows - 1));
  }
  const int side = (dictionary->markerSize + 2) * cell;
  cv::Mat black;
  cv::aruco::drawMarker(dictionary, id, side, black, 1);
  cv::Mat picture(side + 2 * cell, side + 2 * cell, CV_8UC1, cv::Scalar(255));
  black.copyTo(picture(cv::Rect(cell, cell, side, side)));
  give(result, picture);
}

void pose(const DoorInput& input, const DoorResult& result) {
  const auto points = space_points_of(input.numbers[0]);
  const auto seen = points_of(input.numbers[1]);
  const cv::Matx33d K = cv::Matx33d::eye();
  cv::Vec3d r, t;
  if (!cv::solvePnP(points, seen, K, cv::noArray(), r, t, false, cv::SOLVEPNP_SQPNP))
    throw Refused("no pose explains these points");
  cv::solvePnPRefineLM(points, seen, K, cv::noArray(), r, t);
  cv::Matx33d R;
  cv::Rodrigues(r, R);
  std::vector<double> numbers;
  add_pose(numbers, R, t);
  give(result, numbers);
}

void calibrate(const DoorInput& input, const DoorResult& result) {
  const auto points = space_points_of(input.numbers[0]);
  const auto seen = points_of(input.numbers[1]);
  std::vector<std::vector<cv::Point3f>> objects;
  std::vector<std::vector<cv::Point2f>> pictures;
  std::size_t first = 0;
  for (std::size_t view = 0; view < input.numbers[2].count; ++view) {
    const auto count = static_cast<std::size_t>(input.numbers[2].values[view]);
    objects.emplace_back(points.begin() + first, points.begin() + first + count);
    pictures.emplace_back(seen.begin() + first, seen.begin() + first + count);
    first += count;
  }
  const int terms = static_cast<int>(input.options[2]);
  int flags = cv::CALIB_USE_LU;  // singular values take time with the third power of the views
  if (terms < 5) flags |= cv::CALIB_FIX_K3;
  if (terms < 4) flags |= cv::CALIB_ZERO_TANGENT_DIST;
  if (terms < 2) flags |= cv::CALIB_FIX_K2;
  if (terms < 1) flags |= cv::CALIB_FIX_K1;
  cv::Mat K = cv::Mat::eye(3, 3, CV_64F), distortion = cv::Mat::zeros(1, 5, CV_64F), deviations;
  std::vector<cv::Mat> r, t;
  const double rms = cv::calibrateCamera(
      objects, pictures,
      cv::Size(static_cast<int>(input.options[0]), static_cast<int>(input.options[1])), K,
      distortion, r, t, deviations, cv::noArray(), cv::noArray(), flags,
      {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 50, 1e-12});
  std::vector<double> numbers{K.at<double>(0, 0), K.at<double>(1, 1), K.at<double>(0, 2),
                              K.at<double>(1, 2)};
  for (int i = 0; i < 5; ++i) numbers.push_back(distortion.at<double>(i));
  numbers.push_back(rms);
  for (int i = 0; i < 9; ++i) numbers.push_back(deviations.at<double>(i));
  for (std::size_t view = 0; view < r.size(); ++view) {
    cv::Matx33d R;
    cv::Rodrigues(r[view], R);
    add_pose(numbers, R, cv::Vec3d(t[view].ptr<double>()));
  }
  give(result, numbers);
}

void hand_eye(const DoorInput& input, const DoorResult& result) {
  std::vector<cv::Mat> R_world_tool, p_world_tool, R_camera_target, p_camera_target;
  read_poses(input.numbers[0], R_world_tool, p_world_tool);
  read_poses(input.numbers[1], R_camera_target, p_camera_target);
  constexpr cv::HandEyeCalibrationMethod kMethods[] = {
      cv::CALIB_HAND_EYE_TSAI, cv::CALIB_HAND_EYE_PARK, cv::CALIB_HAND_EYE_HORAUD,
      cv::CALIB_HAND_EYE_DANIILIDIS};
  cv::Mat R, t;
  cv::calibrateHandEye(R_world_tool, p_world_tool, R_camera_target, p_camera_target, R, t,
                       kMethods[static_cast<int>(input.options[0])]);
  std::vector<double> numbers;
  add_pose(numbers, cv::Matx33d(R), cv::Vec3d(t.ptr<double>()));
  give(result, numbers);
}

void undistort(const DoorInput& input, const DoorResult& result) {
  const double* o = input.options;
  const cv::Matx33d K(o[0], 0, o[2], 0, o[1], o[3], 0, 0, 1);
  const cv::Matx<double, 1, 5> distortion(o + 4);
  cv::Mat found;
  cv::undistort(mat_of(input.picture), found, K, distortion);
  give(result, found);
}

}  // namespace armlet::room
