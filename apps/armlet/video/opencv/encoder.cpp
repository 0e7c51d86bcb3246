// The library that writes videos: H.264 by OpenCV's videoio and FFmpeg behind it, which prints
// nothing.

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <opencv2/videoio/registry.hpp>
#include <stdexcept>
#include <string>

#include "video/video_door.hpp"

namespace armlet::cli {
namespace {

// The reason why a video cannot be made, as the end of a sentence.
struct VideoRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct OpenVideo {
  std::string path;
  cv::Mat picture;  // BGR
  cv::VideoWriter writer{};
  int count = 0;
};

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

// How a file calls H.264 whose name ends so.
int code_for(const std::string& path) {
  if (path.ends_with(".mp4")) return cv::VideoWriter::fourcc('a', 'v', 'c', '1');
  if (path.ends_with(".mkv")) return cv::VideoWriter::fourcc('H', '2', '6', '4');
  throw VideoRefused("it ends neither in .mp4 nor in .mkv");
}

void* open_video(const VideoFormat& format) {
  constexpr int kLargest = 8192;
  const int least = std::min(format.width, format.height);
  const int most = std::max(format.width, format.height);
  // Colours are stored for two by two pixels; OpenCV would cut off the last column and row.
  if (least < 2 || most > kLargest || format.width % 2 != 0 || format.height % 2 != 0) {
    throw VideoRefused("pictures of H.264 have sides of even numbers up to " +
                       std::to_string(kLargest) + ", not " +
                       size_text(format.width, format.height));
  }
  if (!(format.rate > 0.0 && format.rate <= 1000.0))
    throw VideoRefused("it has " + std::to_string(format.rate) + " pictures a second");
  auto video =
      std::make_unique<OpenVideo>(OpenVideo{format.path, {format.height, format.width, CV_8UC3}});
  const int code = code_for(video->path);
  if (!cv::videoio_registry::hasBackend(cv::CAP_FFMPEG))
    throw VideoRefused("the videoio of OpenCV that is installed cannot use FFmpeg");
  if (!video->writer.open(video->path, cv::CAP_FFMPEG, code, format.rate, video->picture.size())) {
    throw VideoRefused(
        "the FFmpeg that is installed cannot write H.264 there (Debian's libavcodec can, by x264)");
  }
  return video.release();
}

void add_picture(OpenVideo& video, const std::uint8_t* rgb) {
  for (int y = 0; y < video.picture.rows; ++y) {
    std::uint8_t* to = video.picture.ptr(y);
    for (int x = 0; x < video.picture.cols; ++x, to += 3, rgb += 3) {
      to[0] = rgb[2];
      to[1] = rgb[1];
      to[2] = rgb[0];
    }
  }
  video.writer.write(video.picture);
  ++video.count;
}

// The writer does not say whether the system took its bytes.
void close_video(OpenVideo& video) {
  video.writer.release();
  cv::VideoCapture reader(video.path, cv::CAP_FFMPEG);
  int count = 0;
  while (reader.isOpened() && count <= video.count && reader.grab()) ++count;
  if (count == video.count) return;
  throw VideoRefused("of " + std::to_string(video.count) + " pictures only " +
                     std::to_string(count) + " can be read back");
}

// work(), whose exceptions become refusals; `refused` then.
template <class Work, class Value>
Value guarded(const VideoRefusal& refusal, Value refused, Work work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    refusal.say(refusal.context, "there is not enough memory");
  } catch (const cv::Exception& error) {
    refusal.say(refusal.context, error.err.c_str());
  } catch (const std::exception& error) {
    refusal.say(refusal.context, error.what());
  }
  return refused;
}

OpenVideo& video_of(void* video) { return *static_cast<OpenVideo*>(video); }

constexpr VideoDoor kDoor{
    .open =
        [](const VideoFormat* format, const VideoRefusal* refusal) {
          return guarded(*refusal, static_cast<void*>(nullptr),
                         [&] { return open_video(*format); });
        },
    .add =
        [](void* video, const std::uint8_t* rgb, const VideoRefusal* refusal) {
          return guarded(*refusal, false, [&] {
            add_picture(video_of(video), rgb);
            return true;
          });
        },
    .close =
        [](void* video, const VideoRefusal* refusal) {
          const std::unique_ptr<OpenVideo> owned(&video_of(video));
          return guarded(*refusal, false, [&] {
            close_video(*owned);
            return true;
          });
        },
    .drop = [](void* video) { delete &video_of(video); },
};

int print_nothing(int, const char*, const char*, const char*, int, void*) { return 0; }

void prepare() {
  cv::setNumThreads(1);
  cv::redirectError(print_nothing);
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);  // AV_LOG_QUIET
}

}  // namespace
}  // namespace armlet::cli

extern "C" __attribute__((visibility("default"))) const armlet::cli::VideoDoor*
armlet_open_video_door() noexcept {
  static const bool prepared = [] {
    try {
      armlet::cli::prepare();
      return true;
    } catch (const std::exception&) {
      return false;
    }
  }();
  return prepared ? &armlet::cli::kDoor : nullptr;
}
