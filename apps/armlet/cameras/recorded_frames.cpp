#include "cameras/recorded_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "armlet/core/files.hpp"
#include "armlet/core/similar.hpp"
#include "console/console.hpp"

namespace armlet::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPictureBytes = std::size_t{64} << 20U;  // of one picture
constexpr std::array<std::string_view, 3> kPictureEndings{".png", ".jpg", ".jpeg"};

// The picture files of one camera, in alphabetical order.
struct Recorded {
  std::string folder;
  std::vector<std::string> paths;
};

bool is_picture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(kPictureEndings, ending) != kPictureEndings.end();
}

// An error with the reason if the folder cannot be read or holds no pictures.
Result<Recorded> pictures_in(const std::string& folder) {
  std::error_code failed;
  Recorded out{folder, {}};
  fs::directory_iterator files(folder, failed);
  if (failed) return Error{"folder", failed.message()};
  for (; !failed && files != fs::directory_iterator(); files.increment(failed)) {
    if (is_picture(files->path())) out.paths.push_back(files->path().string());
  }
  if (failed) return Error{"folder", failed.message()};
  if (out.paths.empty()) return Error{"folder", "there is no PNG or JPEG file in it"};
  std::ranges::sort(out.paths);
  return out;
}

Result<std::string> picture_of(const Recorded& recorded, const FrameRequest& asked) {
  const std::size_t count = recorded.paths.size();
  if (asked.number >= count) {
    return Error{"frames", fmt::format("there {} {} picture{} in {}", count == 1 ? "is" : "are",
                                       count, count == 1 ? "" : "s", recorded.folder)};
  }
  const std::string& path = recorded.paths[asked.number];
  Result<std::string> bytes = armlet::read_file(path, kMostPictureBytes);
  if (bytes.ok()) return bytes;
  return Error{"frames", fmt::format("{} cannot be read: {}", path, bytes.error().message)};
}

// Whether a file has the name of a picture that --frames writes: "eye-000012.png".
bool is_frame_name(std::string_view name) {
  constexpr std::string_view kEnding = ".png";
  constexpr std::size_t kDigits = 6;
  if (!name.ends_with(kEnding)) return false;
  name.remove_suffix(kEnding.size());
  const std::size_t hyphen = name.find_last_of('-');
  return hyphen != 0 && hyphen != name.npos && name.size() - hyphen > kDigits &&
         std::ranges::all_of(name.substr(hyphen + 1),
                             [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

int choose_recorded_frames(const std::vector<std::string>& named, SessionOptions& session) {
  if (named.empty()) return kDone;
  auto cameras = std::make_shared<std::map<std::string, Recorded, std::less<>>>();  // of the frames
  for (const std::string& each : named) {
    const std::string name = each.substr(0, each.find('='));
    const std::string folder = each.substr(name.size() + 1);
    Result<Recorded> recorded = pictures_in(folder);
    if (!recorded.ok()) {
      progress(fmt::format("armlet: the pictures of the camera `{}` cannot be read from {}: {}",
                           name, folder, recorded.error().message));
      return kNoFile;
    }
    if (!cameras->emplace(name, std::move(recorded).value()).second) {
      progress(fmt::format("armlet: --camera names the camera `{}` twice", name));
      return kUsage;
    }
    session.frames.cameras.push_back(name);
  }
  session.frames.take = [cameras](const FrameRequest& asked) {
    return picture_of(cameras->find(asked.camera)->second, asked);
  };
  return kDone;
}

int check_recorded_frames(const HostFrames& frames, const Session& session) {
  const std::vector<std::string> declared = session.program()->declared_names("camera");
  for (const std::string& name : frames.cameras) {
    if (std::ranges::find(declared, name) != declared.end()) continue;
    const std::vector<std::string_view> known(declared.begin(), declared.end());
    const auto meant = most_similar(name, known);
    std::string hint;
    if (meant) {
      hint = fmt::format("; did you mean `{}`?", *meant);
    } else if (!declared.empty()) {
      hint = fmt::format("; it has {}", fmt::join(declared, ", "));
    }
    progress(fmt::format("armlet: the program has no camera `{}`{}", name, hint));
    return kUsage;
  }
  return kDone;
}

void FrameFolder::choose(const std::string& path, Backend* next) {
  path_ = path;
  if (!path.empty()) files_ = std::make_unique<FrameFiles>(path, next);
}

int FrameFolder::open() {
  if (files_ == nullptr) return kDone;
  std::error_code failed;
  fs::create_directories(path_, failed);
  if (failed) {
    progress(fmt::format("armlet: the folder {} cannot be made: {}", path_, failed.message()));
    return kNoFile;
  }
  files_->open();
  if (files_->own_error().empty()) return kDone;
  progress(fmt::format("armlet: {}", files_->own_error()));
  return kNoFile;
}

int FrameFolder::finish() const {
  if (files_ == nullptr) return kDone;
  if (!files_->own_error().empty()) {
    progress(fmt::format("armlet: {}", files_->own_error()));
    return kFailed;
  }
  std::vector<std::string> old;
  std::error_code failed;
  for (fs::directory_iterator files(path_, failed); !failed && files != fs::directory_iterator();
       files.increment(failed)) {
    const std::string name = files->path().filename().string();
    if (is_frame_name(name) && !files_->has_written(name)) old.push_back(name);
  }
  if (old.empty()) return kDone;
  std::ranges::sort(old);
  progress(fmt::format("armlet: {} also holds {} picture{} of an earlier run: {}{}", path_,
                       old.size(), old.size() == 1 ? "" : "s", old.front(),
                       old.size() == 1 ? "" : " to " + old.back()));
  return kDone;
}

}  // namespace armlet::cli
