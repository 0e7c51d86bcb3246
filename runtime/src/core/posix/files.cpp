#include "armlet/core/files.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

namespace armlet {
namespace {

Error because(std::string code, std::string why) { return {std::move(code), std::move(why)}; }
Error system_says(int number) {
  if (number == ENOENT) return because("missing", "there is no such file");
  return because("system", std::strerror(number));
}

// A file descriptor that is closed by the destructor.
class Handle {
 public:
  explicit Handle(int number = -1) : number_(number) {}
  Handle(Handle&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Handle() {
    if (number_ >= 0) ::close(number_);
  }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

// Why a file is not a regular one; nothing if it is.
std::optional<Error> no_file(mode_t mode) {
  if (S_ISREG(mode)) return std::nullopt;
  if (S_ISDIR(mode)) return because("kind", "it is a folder");
  if (S_ISLNK(mode)) return because("link", "it is a link, and links are not followed here");
  if (S_ISFIFO(mode)) return because("kind", "it is a pipe, not a file");
  if (S_ISSOCK(mode)) return because("kind", "it is a socket, not a file");
  return because("kind", "it is a device, not a file");
}

// Links are followed only if O_NOFOLLOW is left out. Does not block.
Result<std::string> read_at(int folder, const std::string& name, std::size_t most, int no_follow) {
  struct stat info {};
  const int flags = no_follow == 0 ? 0 : AT_SYMLINK_NOFOLLOW;
  if (fstatat(folder, name.c_str(), &info, flags) != 0) return system_says(errno);
  if (auto error = no_file(info.st_mode)) return *error;  // opening a device may have effects
  const Handle file(
      openat(folder, name.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | no_follow));
  if (file.number() < 0) return system_says(errno);
  if (fstat(file.number(), &info) != 0) return system_says(errno);
  if (auto error = no_file(info.st_mode)) return *error;
  if (static_cast<std::size_t>(info.st_size) > most) {
    return because("large",
                   fmt::format("it has {} bytes; at most {} are read", info.st_size, most));
  }
  return read_all(file.number(), most);
}

// ---- unfinished files, in a form that a signal handler can use --------------------------------

struct Unfinished {
  static constexpr int kFree = -1, kBusy = -2;
  std::atomic<int> folder{kFree};
  char name[64] = {};
};
std::array<Unfinished, 32> unfinished;

// Null if there are too many.
Unfinished* remember(int folder, const std::string& name) {
  for (Unfinished& one : unfinished) {
    int expected = Unfinished::kFree;
    if (!one.folder.compare_exchange_strong(expected, Unfinished::kBusy)) continue;
    std::strncpy(one.name, name.c_str(), sizeof one.name - 1);
    one.folder.store(folder);
    return &one;
  }
  return nullptr;
}

// The name of the unfinished file. It has the ending of the final name, from which libraries
// determine the format.
std::string temporary_name(std::string_view name) {
  static std::atomic<unsigned> count{0};
  constexpr std::size_t kLongestEnding = 8;
  const std::size_t dot = std::min(name.find_last_of('.'), name.size());
  const std::string_view ending = name.substr(dot);
  return fmt::format(".armlet-{}-{}.part{}", getpid(), count.fetch_add(1),
                     ending.size() <= kLongestEnding ? ending : std::string_view());
}

bool may_go_without_sync(int number) {
  return number == EINVAL || number == ENOSYS || number == EOPNOTSUPP;
}

}  // namespace

void remove_unfinished_files() noexcept {
  for (Unfinished& one : unfinished) {
    const int folder = one.folder.load();
    if (folder >= 0) unlinkat(folder, one.name, 0);
  }
}

// ---- NewFile ----------------------------------------------------------------------------------

struct NewFile::Open {
  Handle folder;
  std::string name;
  std::string temporary{};
  Handle file{};
  WriteBytes write = nullptr;
  std::optional<struct stat> replaced{};
  std::optional<Error> failure{};
  Unfinished* slot = nullptr;

  ~Open() {
    if (file.number() >= 0) unlinkat(folder.number(), temporary.c_str(), 0);
    forget();
  }

  void forget() {
    if (slot != nullptr) slot->folder.store(Unfinished::kFree);
    slot = nullptr;
  }

  void fail(int number) {
    if (!failure) failure = because("system", std::strerror(number));
  }

  // False, with the error set, if there cannot be a file of that name.
  bool begin() {
    struct stat info {};
    if (fstatat(folder.number(), name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0) {
      failure = S_ISDIR(info.st_mode) ? because("kind", "there is a folder of that name")
                                      : no_file(info.st_mode);
      if (failure) return false;
      // rename() would not check this.
      if (faccessat(folder.number(), name.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
      replaced = info;
    } else if (errno != ENOENT) {
      fail(errno);
    }
    for (int attempt = 0; !failure && file.number() < 0; ++attempt) {
      temporary = temporary_name(name);
      forget();
      slot =
          remember(folder.number(), temporary);  // before it exists: a signal may come at any time
      file = Handle(openat(folder.number(), temporary.c_str(),
                           O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
      if (file.number() < 0 && (errno != EEXIST || attempt == 100)) fail(errno);
    }
    return !failure;
  }

  // Copies the permissions and the owner of the file that is replaced. Only root may change owners;
  // for everyone else the owner is right already.
  bool take_over() {
    if (!replaced) return true;
    const int number = file.number();
    const bool owned = fchown(number, replaced->st_uid, replaced->st_gid) == 0 ||
                       (errno == EPERM && replaced->st_uid == geteuid());
    return owned && fchmod(number, replaced->st_mode & 07777) == 0;
  }

  void finish() {
    if (!failure && !take_over()) fail(errno);
    if (!failure && fsync(file.number()) != 0 && !may_go_without_sync(errno)) fail(errno);
    // An error of delayed writing may be reported only now.
    if (::close(file.release()) != 0) fail(errno);
    const int at = folder.number();
    if (!failure && renameat(at, temporary.c_str(), at, name.c_str()) != 0) fail(errno);
    if (failure) unlinkat(at, temporary.c_str(), 0);
  }
};

NewFile::NewFile(std::unique_ptr<Open> open) : open_(std::move(open)) {}
NewFile::NewFile(NewFile&& other) noexcept = default;
NewFile& NewFile::operator=(NewFile&& other) noexcept = default;
NewFile::~NewFile() = default;

bool NewFile::write(std::string_view bytes) {
  if (open_ == nullptr) return false;
  while (!open_->failure && !bytes.empty()) {
    const int file = open_->file.number();
    const long count = open_->write != nullptr ? open_->write(file, bytes.data(), bytes.size())
                                               : ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) open_->fail(errno);
    if (count == 0) open_->fail(ENOSPC);
    if (count > 0) bytes.remove_prefix(std::min(static_cast<std::size_t>(count), bytes.size()));
  }
  return !open_->failure;
}

bool NewFile::seek(std::uint64_t offset) {
  if (open_ == nullptr) return false;
  if (!open_->failure && lseek(open_->file.number(), static_cast<off_t>(offset), SEEK_SET) < 0)
    open_->fail(errno);
  return !open_->failure;
}

std::string NewFile::path() const {
  if (open_ == nullptr) return {};
  return fmt::format("/proc/self/fd/{}/{}", open_->folder.number(), open_->temporary);
}

std::optional<Error> NewFile::finish() {
  if (open_ == nullptr) return because("name", "it is finished already");
  const std::unique_ptr<Open> open = std::move(open_);
  open->finish();
  return open->failure;
}

// ---- Folder -----------------------------------------------------------------------------------

// The open folder that contains a file, and the file's name in it.
struct Folder::Place {
  Handle folder;
  std::string name;
};

Folder::Folder(int handle, std::string path) : handle_(handle), path_(std::move(path)) {}
Folder::Folder(Folder&& other) noexcept
    : handle_(std::exchange(other.handle_, -1)), path_(std::move(other.path_)) {}
Folder& Folder::operator=(Folder&& other) noexcept {
  std::swap(handle_, other.handle_);
  std::swap(path_, other.path_);
  return *this;
}
Folder::~Folder() {
  if (handle_ >= 0) ::close(handle_);
}

Result<Folder> Folder::open(const std::string& path) {
  const std::string name = path.empty() ? "." : path;
  char* real = realpath(name.c_str(), nullptr);
  if (real == nullptr) {
    return errno == ENOENT ? because("missing", "there is no such folder") : system_says(errno);
  }
  std::string clean = real;
  std::free(real);
  const int handle = ::open(clean.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (handle < 0) return errno == ENOTDIR ? because("kind", "it is no folder") : system_says(errno);
  return Folder(handle, std::move(clean));
}

Result<Folder::Place> Folder::place_of(std::string_view name) const {
  Result<std::string> cleaned = clean(name);
  if (!cleaned.ok()) return cleaned.error();
  const std::string path = std::move(cleaned).value();
  if (path.empty()) return because("kind", "it is a folder");
  Handle at(fcntl(handle_, F_DUPFD_CLOEXEC, 0));
  if (at.number() < 0) return system_says(errno);
  std::size_t begin = 0;
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', begin)) {
    const std::string part = path.substr(begin, end - begin);
    Handle next(openat(at.number(), part.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (next.number() < 0) {
      const int number = errno;
      const std::string way = path.substr(0, end);
      struct stat info {};
      if (number == ENOENT)
        return because("missing", fmt::format("there is no folder \"{}\"", way));
      if (fstatat(at.number(), part.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 &&
          S_ISLNK(info.st_mode)) {
        return because("link",
                       fmt::format("\"{}\" is a link, and links are not followed here", way));
      }
      if (number == ENOTDIR) return because("kind", fmt::format("\"{}\" is no folder", way));
      return system_says(number);
    }
    at = std::move(next);
    begin = end + 1;
  }
  return Place{std::move(at), path.substr(begin)};
}

Result<std::string> Folder::read(std::string_view name, std::size_t most) const {
  const Result<Place> place = place_of(name);
  if (!place.ok()) return place.error();
  return read_at(place->folder.number(), place->name, most, O_NOFOLLOW);
}

bool Folder::has_file(std::string_view name) const {
  const Result<Place> place = place_of(name);
  struct stat info {};
  return place.ok() &&
         fstatat(place->folder.number(), place->name.c_str(), &info, AT_SYMLINK_NOFOLLOW) == 0 &&
         S_ISREG(info.st_mode);
}

std::vector<std::string> Folder::names(std::string_view folder, std::string_view ending) const {
  constexpr std::size_t kMost = 1000;
  std::vector<std::string> found;
  // Checked as the folder of some file.
  const Result<Place> place = place_of(folder.empty() ? "name" : std::string(folder) + "/name");
  if (!place.ok()) return found;
  const int handle =
      openat(place->folder.number(), ".", O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (handle < 0) return found;
  DIR* entries = fdopendir(handle);
  if (entries == nullptr) {
    ::close(handle);
    return found;
  }
  while (const dirent* entry = readdir(entries)) {
    const std::string_view name = entry->d_name;
    if (name.ends_with(ending)) found.emplace_back(name);
    if (found.size() == kMost) break;
  }
  closedir(entries);
  std::ranges::sort(found);
  return found;
}

Result<NewFile> Folder::create(std::string_view name, WriteBytes write) const {
  Result<Place> found = place_of(name);
  if (!found.ok()) return found.error();
  Place place = std::move(found).value();
  auto open = std::make_unique<NewFile::Open>();
  open->folder = std::move(place.folder);
  open->name = std::move(place.name);
  open->write = write;
  if (!open->begin()) return *open->failure;
  return NewFile(std::move(open));
}

// ---- files that a user named ------------------------------------------------------------------

Result<std::string> read_file(const std::string& path, std::size_t most) {
  return read_at(AT_FDCWD, path, most, 0);
}

Result<NewFile> create_file(const std::string& path, WriteBytes write) {
  std::string target = path;
  struct stat info {};
  if (lstat(path.c_str(), &info) == 0 && S_ISLNK(info.st_mode)) {
    char* real = realpath(path.c_str(), nullptr);
    if (real == nullptr) return because("link", "it is a link that leads nowhere");
    target = real;
    std::free(real);
  }
  const std::size_t slash = target.find_last_of('/');
  const std::string name = slash == std::string::npos ? target : target.substr(slash + 1);
  if (name.empty() || name == "." || name == "..") return because("kind", "it is a folder");
  const std::string above = slash == std::string::npos ? "." : target.substr(0, slash + 1);
  const Result<Folder> folder = Folder::open(above);
  if (!folder.ok()) {
    if (folder.error().code != "missing") return folder.error();
    return because("missing", fmt::format("there is no folder \"{}\"", above));
  }
  return folder->create(name, write);
}

Result<std::string> read_all(int file, std::size_t most) {
  std::string text;
  char buffer[65536];
  while (true) {
    const ssize_t count = ::read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return system_says(errno);
    if (count == 0) return text;
    text.append(buffer, static_cast<std::size_t>(count));
    if (text.size() > most)
      return because("large", fmt::format("it has more than {} bytes; no more are read", most));
  }
}

bool is_same_file(const std::string& a, const std::string& b) {
  struct stat one {
  }, other{};
  return stat(a.c_str(), &one) == 0 && stat(b.c_str(), &other) == 0 && one.st_dev == other.st_dev &&
         one.st_ino == other.st_ino;
}

std::string real_path(const std::string& path) {
  std::error_code problem;
  return std::filesystem::weakly_canonical(path, problem).string();
}

bool is_file(const std::string& path) {
  struct stat info {};
  return stat(path.c_str(), &info) == 0 && S_ISREG(info.st_mode);
}

}  // namespace armlet
