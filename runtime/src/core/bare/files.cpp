// Files in memory.
#include "armlet/core/files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <utility>

#include "memory_files.hpp"

namespace armlet {
namespace {

using Files = std::map<std::string, std::string, std::less<>>;
Files& files() {
  static Files all;
  return all;
}

Error because(std::string code, std::string why) { return {std::move(code), std::move(why)}; }

// Whether a path has files below it.
bool is_folder(const std::string& path) {
  const std::string below = path == "/" ? path : path + '/';
  const auto first = files().lower_bound(below);
  return first != files().end() && first->first.starts_with(below);
}

Result<std::string> read_path(const std::string& path, std::size_t most) {
  const auto found = files().find(path);
  if (found == files().end()) {
    if (is_folder(path)) return because("kind", "it is a folder, not a file");
    return because("missing", "there is no such file");
  }
  if (found->second.size() > most) {
    return because("large",
                   fmt::format("it has {} bytes; at most {} are read", found->second.size(), most));
  }
  return found->second;
}

}  // namespace

namespace memory_files {

void put(std::string_view path, std::string_view content) {
  files().insert_or_assign(real_path(std::string(path)), std::string(content));
}
std::optional<std::string> get(std::string_view path) {
  const auto found = files().find(real_path(std::string(path)));
  return found != files().end() ? std::optional(found->second) : std::nullopt;
}
bool remove(std::string_view path) { return files().erase(real_path(std::string(path))) == 1; }
std::vector<std::string> list(std::string_view folder) {
  const std::string top = real_path(std::string(folder));
  const std::string below = top == "/" ? top : top + '/';
  std::vector<std::string> found;
  for (auto at = files().lower_bound(below); at != files().end() && at->first.starts_with(below);
       ++at)
    found.push_back(at->first);
  return found;
}

}  // namespace memory_files

void remove_unfinished_files() noexcept {}  // they exist only in their NewFile

// ---- NewFile ----------------------------------------------------------------------------------

struct NewFile::Open {
  std::string path;
  std::string content{};
  std::size_t at = 0;
};

NewFile::NewFile(std::unique_ptr<Open> open) : open_(std::move(open)) {}
NewFile::NewFile(NewFile&& other) noexcept = default;
NewFile& NewFile::operator=(NewFile&& other) noexcept = default;
NewFile::~NewFile() = default;

bool NewFile::write(std::string_view bytes) {
  if (open_ == nullptr) return false;
  if (bytes.empty()) return true;
  std::string& content = open_->content;
  if (content.size() < open_->at) content.resize(open_->at);
  content.replace(open_->at, std::min(bytes.size(), content.size() - open_->at), bytes);
  open_->at += bytes.size();
  return true;
}

bool NewFile::seek(std::uint64_t offset) {
  if (open_ == nullptr) return false;
  open_->at = static_cast<std::size_t>(offset);
  return true;
}

std::string NewFile::path() const { return {}; }

std::optional<Error> NewFile::finish() {
  if (open_ == nullptr) return because("name", "it is finished already");
  const std::unique_ptr<Open> open = std::move(open_);
  files().insert_or_assign(open->path, std::move(open->content));
  return std::nullopt;
}

// ---- Folder -----------------------------------------------------------------------------------

struct Folder::Place {
  std::string path;
};

Folder::Folder(int handle, std::string path) : handle_(handle), path_(std::move(path)) {}
Folder::Folder(Folder&& other) noexcept = default;
Folder& Folder::operator=(Folder&& other) noexcept = default;
Folder::~Folder() = default;

Result<Folder> Folder::open(const std::string& path) {
  std::string real = real_path(path);
  if (files().contains(real)) return because("kind", "it is no folder");
  return Folder(0, std::move(real));
}

Result<Folder::Place> Folder::place_of(std::string_view name) const {
  Result<std::string> cleaned = clean(name);
  if (!cleaned.ok()) return cleaned.error();
  if (cleaned->empty()) return because("kind", "it is a folder");
  const std::string below = path_ == "/" ? path_ : path_ + '/';
  for (std::size_t end = cleaned->find('/'); end != std::string::npos;
       end = cleaned->find('/', end + 1)) {
    const std::string way = cleaned->substr(0, end);
    if (files().contains(below + way))
      return because("kind", fmt::format("\"{}\" is no folder", way));
  }
  return Place{below + *cleaned};
}

Result<std::string> Folder::read(std::string_view name, std::size_t most) const {
  const Result<Place> place = place_of(name);
  if (!place.ok()) return place.error();
  return read_path(place->path, most);
}

bool Folder::has_file(std::string_view name) const {
  const Result<Place> place = place_of(name);
  return place.ok() && files().contains(place->path);
}

std::vector<std::string> Folder::names(std::string_view folder, std::string_view ending) const {
  constexpr std::size_t kMost = 1000;
  std::vector<std::string> found;
  const Result<Place> place = place_of(folder.empty() ? "name" : std::string(folder) + "/name");
  if (!place.ok()) return found;
  const std::string below = place->path.substr(0, place->path.rfind('/') + 1);
  for (const std::string& path : memory_files::list(below)) {
    const std::string name = path.substr(below.size());
    if (name.find('/') == std::string::npos && name.ends_with(ending)) found.push_back(name);
    if (found.size() == kMost) break;
  }
  return found;
}

// There is no system call whose failure could be simulated.
Result<NewFile> Folder::create(std::string_view name, WriteBytes) const {
  Result<Place> place = place_of(name);
  if (!place.ok()) return place.error();
  if (is_folder(place->path)) return because("kind", "there is a folder of that name");
  auto open = std::make_unique<NewFile::Open>();
  open->path = std::move(place).value().path;
  return NewFile(std::move(open));
}

// ---- files that a user named ------------------------------------------------------------------

Result<std::string> read_file(const std::string& path, std::size_t most) {
  return read_path(real_path(path), most);
}

Result<NewFile> create_file(const std::string& path, WriteBytes write) {
  const std::string real = real_path(path);
  const Result<Folder> folder = Folder::open(real.substr(0, real.rfind('/') + 1));
  if (!folder.ok()) return folder.error();
  return folder->create(real.substr(real.rfind('/') + 1), write);
}

Result<std::string> read_all(int, std::size_t) {
  return because("system", "there are no pipes here");
}

bool is_same_file(const std::string& a, const std::string& b) {
  return real_path(a) == real_path(b) && files().contains(real_path(a));
}

std::string real_path(const std::string& path) {
  const std::filesystem::path whole = std::filesystem::path("/") / path;
  std::string real = whole.lexically_normal().string();
  if (real.size() > 1 && real.back() == '/') real.pop_back();
  return real;
}

bool is_file(const std::string& path) { return files().contains(real_path(path)); }

}  // namespace armlet
