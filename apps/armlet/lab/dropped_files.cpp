#include "lab/dropped_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "armlet/core/files.hpp"
#include "armlet/mesh/glb.hpp"
#include "client/convert.hpp"
#include "messages/request.hpp"

namespace armlet::cli {
namespace {

constexpr std::size_t kMostAside = std::size_t{128} << 20;
// The laboratory is blocked while the converter runs.
constexpr int kMostSeconds = 20;

// Whether a mesh of another format may refer to a file of this kind.
bool is_companion(std::string_view name) {
  constexpr std::array<std::string_view, 5> kEndings = {"mtl", "png", "jpg", "jpeg", "bin"};
  std::string ending(name.substr(name.rfind('.') + 1));
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

// The file or other entry with a name in the folder; none of them is overwritten.
lab::NameInUse look_at(const Folder& folder, const std::string& name) {
  Result<std::string> bytes = folder.read(name, lab::kMostFileBytes);
  if (bytes.ok()) return {.is_used = true, .bytes = std::move(bytes).value()};
  return {.is_used = bytes.error().code != "missing"};
}

}  // namespace

DroppedFiles::~DroppedFiles() {
  std::error_code ignored;
  if (!aside_.empty()) std::filesystem::remove_all(aside_, ignored);
}

std::optional<Error> DroppedFiles::put_aside(const std::string& name, const std::string& bytes) {
  const Error none{"folder", "There is no room for files that are converted."};
  if (bytes_aside_ + bytes.size() > kMostAside) return none;
  if (aside_.empty()) {
    std::error_code why;
    std::string path = (std::filesystem::temp_directory_path(why) / "armlet-XXXXXX").string();
    if (why || mkdtemp(path.data()) == nullptr) return none;
    aside_ = path;
  }
  const Result<Folder> folder = Folder::open(aside_.string());
  if (!folder.ok() || folder->save(name, bytes)) return none;
  bytes_aside_ += bytes.size();
  return std::nullopt;
}

Result<std::string> DroppedFiles::convert(const std::string& name) {
  const Result<Folder> folder = Folder::open(aside_.string());
  if (!folder.ok()) return folder.error();
  mesh::ConvertOptions how;
  how.limits.wall = how.limits.cpu = kMostSeconds;
  Result<std::string> glb = mesh::convert_mesh(*folder, aside_.string(), name, how);
  if (!glb.ok()) return Error{"mesh", fmt::format("{}: {}.", name, glb.error().message)};
  return glb;
}

Result<lab::KeptFile> DroppedFiles::keep(const std::string& name, const std::string& bytes) {
  const Result<Folder> folder = Folder::open(folder_);
  if (!folder.ok()) return Error{"folder", "The folder of the program cannot be opened."};
  const auto keep_glb = [&](const std::string& under, const std::string& glb) {
    return lab::keep_beside(
        under, glb, [&](const std::string& each) { return look_at(*folder, each); },
        [&](const std::string& each, const std::string& content) {
          return folder->save(each, content);
        });
  };
  if (is_glb_name(name) || (mesh_format(name).empty() && !is_companion(name)))
    return keep_glb(name, bytes);
  if (const std::optional<Error> why = put_aside(name, bytes)) return *why;
  if (is_companion(name)) return lab::KeptFile{};
  const Result<std::string> glb = convert(name);
  if (!glb.ok()) return glb.error();
  return keep_glb(name.substr(0, name.rfind('.')) + ".glb", *glb);
}

}  // namespace armlet::cli
