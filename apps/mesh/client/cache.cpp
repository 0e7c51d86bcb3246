#include "client/cache.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "client/sha256.hpp"

namespace armlet::mesh {
namespace {

constexpr std::string_view kFirstLine = "armlet mesh names 1\n";
constexpr std::size_t kMostNames = std::size_t{1} << 20;  // bytes

namespace fs = std::filesystem;

// Removes the first line from the text and returns it; nullopt if no line ends.
std::optional<std::string> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  std::string line(text.substr(0, end));
  text.remove_prefix(end + 1);
  return line;
}

}  // namespace

std::string hash_of(const Sibling& sibling) {
  Sha256 hash;
  hash.add_text(std::string(1, static_cast<char>(sibling.state)));
  hash.add_text(sibling.text);
  return hash.digits();
}

Cache::Cache(std::string folder, std::string key, std::uintmax_t most)
    : path_(std::move(folder)), key_(std::move(key)), most_(most) {
  if (path_.empty()) return;
  std::error_code failed;
  fs::create_directories(path_, failed);
  Result<Folder> opened = Folder::open(path_);
  if (opened.ok()) folder_.emplace(std::move(opened).value());
}

// Other processes may do the same at this moment: a missing file is no failure, and a reader that
// finds the names but not the result has found nothing.
void Cache::make_room() const {
  struct File {
    fs::file_time_type used;
    std::string name;
    std::uintmax_t size;
  };
  std::vector<File> files;
  std::uintmax_t sum = 0;
  std::error_code failed;
  for (fs::directory_iterator each(path_, failed), end; !failed && each != end;
       each.increment(failed)) {
    std::error_code gone;
    if (!fs::is_regular_file(each->symlink_status(gone))) continue;
    File file{each->last_write_time(gone), each->path().filename().string(), each->file_size(gone)};
    if (gone || !(file.name.ends_with(".glb") || file.name.ends_with(".names"))) continue;
    sum += file.size;
    files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, [](const File& each) { return std::tie(each.used, each.name); });
  for (const File& each : files) {
    if (sum <= most_) return;
    fs::remove(fs::path(path_) / each.name, failed);
    sum -= each.size;
  }
}

void Cache::mark_used(const std::string& name) const {
  std::error_code failed;  // then the file counts as older than it is
  fs::last_write_time(fs::path(path_) / name, fs::file_time_type::clock::now(), failed);
}

std::string Cache::result_name(const std::vector<Asked>& asked) const {
  Sha256 hash;
  hash.add_text(key_);
  for (const Asked& each : asked) {
    hash.add_text(each.name);
    hash.add_text(each.hash);
  }
  return hash.digits() + ".glb";
}

std::optional<std::string> Cache::find(
    const std::function<Sibling(const std::string& name)>& find) const {
  if (!folder_) return std::nullopt;
  const Result<std::string> names = folder_->read(key_ + ".names", kMostNames);
  if (!names.ok() || !names->starts_with(kFirstLine)) return std::nullopt;
  std::string_view text(*names);
  text.remove_prefix(kFirstLine.size());
  const auto wanted = take_line(text);
  if (!wanted) return std::nullopt;
  std::vector<Asked> asked;
  while (!text.empty()) {
    auto name = take_line(text);
    if (!name) return std::nullopt;
    asked.push_back({*name, hash_of(find(*name))});
  }
  const std::string result = result_name(asked);
  Result<std::string> glb = folder_->read(result, ConvertLimits{}.result);
  if (!glb.ok() || sha256(*glb) != *wanted) return std::nullopt;
  mark_used(result);
  mark_used(key_ + ".names");
  return std::move(glb).value();
}

void Cache::keep(const std::vector<Asked>& asked, const std::string& glb) const {
  if (!folder_) return;
  std::string names(kFirstLine);
  names += sha256(glb) + "\n";
  for (const Asked& each : asked) {
    if (each.name.find('\n') != std::string::npos) return;
    names += each.name + "\n";
  }
  // The result is written first, so that a reader of the names finds it.
  if (folder_->save(result_name(asked), glb)) return;
  (void)folder_->save(key_ + ".names", names);
  make_room();
}

}  // namespace armlet::mesh
