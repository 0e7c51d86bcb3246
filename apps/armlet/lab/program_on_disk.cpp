#include "lab/program_on_disk.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "messages/request.hpp"

namespace armlet::cli {
namespace {

using std::filesystem::perms;

// Whether no user may write the file. The system lets root write such a file.
bool is_read_only(const std::string& path) {
  constexpr perms kWriting = perms::owner_write | perms::group_write | perms::others_write;
  std::error_code why;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, why);
  return !why && std::filesystem::is_regular_file(status) &&
         (status.permissions() & kWriting) == perms::none;
}

}  // namespace

Result<ProgramOnDisk> ProgramOnDisk::open(const std::string& path) {
  const std::string real = real_path(std::filesystem::absolute(path).string());
  const std::size_t slash = real.find_last_of('/');
  Result<Folder> folder = Folder::open(slash == 0 ? "/" : real.substr(0, slash));
  if (!folder.ok()) return folder.error();
  return ProgramOnDisk(std::move(folder).value(), real, real.substr(slash + 1));
}

Result<std::string> ProgramOnDisk::read() const { return folder_.read(name_, lab::kMostTextBytes); }

std::optional<Error> ProgramOnDisk::write(const std::string& text) const {
  if (is_read_only(path_)) return Error{"system", "the file is read-only"};
  return folder_.save(name_, text);
}

}  // namespace armlet::cli
