#include "video/video_sink.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "armlet/core/files.hpp"
#include "armlet/image/files.hpp"
#include "commands.hpp"
#include "console/console.hpp"
#include "console/output_file.hpp"
#include "video/video_door.hpp"

namespace armlet::cli {
namespace {

namespace fs = std::filesystem;

// One file, written by OpenCV under another name until it is whole.
class VideoFile : public VideoSink {
 public:
  explicit VideoFile(std::string path) : path_(std::move(path)) { file_.set_path(path_); }
  ~VideoFile() override { drop(); }
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  int open(const std::vector<std::string>& texts) override {
    door_ = video_door();
    if (door_ == nullptr) {
      progress(fmt::format(
          "armlet: {} cannot be written: {} was not found. `./dev build video` builds it, and "
          "installs OpenCV's videoio (Debian package libopencv-videoio-dev) for it; `--video "
          "frames/` writes the pictures as PNG files and needs neither",
          path_, kVideoLibrary));
      return kNoFile;
    }
    if (const int exit = file_.open(texts); exit != kDone) return exit;
    const std::string part = file_.file().path();
    const VideoFormat format{part.c_str(), kVideoWidth, kVideoHeight, kVideoRate};
    const VideoRefusal refusal = listen();
    video_ = door_->open(&format, &refusal);
    return video_ != nullptr ? kDone : refuse(kNoFile);
  }

  int add(const Image& picture) override {
    const VideoRefusal refusal = listen();
    return door_->add(video_, picture.bytes().data(), &refusal) ? kDone : refuse(kFailed);
  }

  int finish() override {
    const VideoRefusal refusal = listen();
    if (!door_->close(std::exchange(video_, nullptr), &refusal)) {
      std::error_code failed;
      const fs::space_info space = fs::space(folder(), failed);
      if (!failed) why_ += fmt::format("; {} kB are free on its disk", space.available / 1000);
      return refuse(kFailed);
    }
    return file_.finish();
  }

 private:
  VideoRefusal listen() {
    return {this,
            [](void* context, const char* why) { static_cast<VideoFile*>(context)->why_ = why; }};
  }

  [[nodiscard]] std::string folder() const {
    const std::string above = fs::path(path_).parent_path().string();
    return above.empty() ? "." : above;
  }

  int refuse(int exit) {
    drop();
    file_.give_up();
    progress(fmt::format("armlet: the video {} cannot be written: {}", path_, why_));
    return exit;
  }

  void drop() {
    if (void* video = std::exchange(video_, nullptr)) door_->drop(video);
  }

  std::string path_;
  OutputFile file_{"video"};
  const VideoDoor* door_ = nullptr;
  void* video_ = nullptr;
  std::string why_;
};

std::string picture_name(std::size_t number) { return fmt::format("frame-{:06}.png", number); }

// A PNG file for each picture.
class PictureFolder : public VideoSink {
 public:
  explicit PictureFolder(std::string path) : path_(std::move(path)) {}

  int open(const std::vector<std::string>&) override {
    std::error_code failed;
    fs::create_directories(path_, failed);
    if (failed) return refuse(failed.message(), kNoFile);
    Result<Folder> opened = Folder::open(path_);
    if (!opened.ok()) return refuse(opened.error().message, kNoFile);
    folder_ = std::move(opened).value();
    // Whether files can be made in it.
    const Result<NewFile> tried = folder_->create(picture_name(0));
    return tried.ok() ? kDone : refuse(tried.error().message, kNoFile);
  }

  int add(const Image& picture) override {
    const auto error = folder_->save(picture_name(count_++), write_png(picture));
    return error ? refuse(error->message, kFailed) : kDone;
  }

  int finish() override {
    if (folder_->has_file(picture_name(count_))) {
      progress(fmt::format("armlet: {}/{} and later ones belong to another video", folder_name(),
                           picture_name(count_)));
    }
    return kDone;
  }

 private:
  [[nodiscard]] std::string folder_name() const {
    return path_.size() > 1 && path_.ends_with('/') ? path_.substr(0, path_.size() - 1) : path_;
  }

  int refuse(const std::string& why, int exit) const {
    progress(
        fmt::format("armlet: the pictures of the video cannot be written to {}: {}", path_, why));
    return exit;
  }

  std::string path_;
  std::optional<Folder> folder_;
  std::size_t count_ = 0;
};

}  // namespace

std::unique_ptr<VideoSink> video_sink(const std::string& path) {
  if (path.ends_with(".mp4") || path.ends_with(".mkv")) return std::make_unique<VideoFile>(path);
  std::error_code none;
  if (path.ends_with('/') || fs::is_directory(path, none))
    return std::make_unique<PictureFolder>(path);
  if (path.ends_with(".gif")) {
    const std::string video = path.substr(0, path.size() - 3) + "mp4";
    progress(fmt::format(
        "armlet: a video is an .mp4 or .mkv file, not \"{}\": a GIF has 256 colours and is many "
        "times as large. `--video {}` is shown by browsers and slides alike; where it has to be a "
        "GIF, `ffmpeg -i {} {}` makes one of it",
        path, video, video, path));
  } else {
    progress(fmt::format(
        "armlet: a video is an .mp4 or .mkv file, or a folder for its pictures such as frames/, "
        "not \"{}\"",
        path));
  }
  return nullptr;
}

}  // namespace armlet::cli
