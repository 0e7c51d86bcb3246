// Setup of OpenCV: one thread, no graphics processor, no output.

#include <opencv2/core.hpp>
#include <opencv2/core/ocl.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "vision/opencv/room.hpp"

namespace armlet::room {
namespace {

int print_nothing(int, const char*, const char*, const char*, int, void*) { return 0; }

void prepare() {
  cv::setNumThreads(1);
  cv::ocl::setUseOpenCL(false);
  cv::redirectError(print_nothing);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
}

constexpr OpencvDoor kDoor{
    .edges = guarded<edges>,
    .lines = guarded<lines>,
    .circles = guarded<circles>,
    .match = guarded<match>,
    .fast = guarded<fast>,
    .contours = guarded<contours>,
    .polygon = guarded<polygon>,
    .adaptive = guarded<adaptive>,
    .morphology = guarded<morphology>,
    .flow = guarded<flow>,
    .markers = guarded<markers>,
    .marker = guarded<marker>,
    .pose = guarded<pose>,
    .calibrate = guarded<calibrate>,
    .hand_eye = guarded<hand_eye>,
    .undistort = guarded<undistort>,
};

}  // namespace
}  // namespace armlet::room

extern "C" __attribute__((visibility("default"))) const armlet::OpencvDoor*
armlet_open_opencv_door() noexcept {
  static const bool prepared = [] {
    try {
      armlet::room::prepare();
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }();
  return prepared ? &armlet::room::kDoor : nullptr;
}
