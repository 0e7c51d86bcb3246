// armlet fmt: lays programs out.

#include "armlet/interpreter/format.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "console.hpp"

namespace armlet::cli {
namespace {

constexpr std::string_view kStandardInput = "-";

// The file that a name stands for, behind symbolic links.
std::string real_path(const std::string& path) {
  char* resolved = realpath(path.c_str(), nullptr);
  if (resolved == nullptr) return path;
  std::string out = resolved;
  std::free(resolved);
  return out;
}

bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) return false;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// Puts `text` into the file in one step: whoever reads it sees the old text or the new one.
// Permissions and owner stay. False, with errno set, if that was not possible.
bool replace_file(const std::string& path, std::string_view text) {
  const std::string target = real_path(path);
  struct stat info {};
  if (stat(target.c_str(), &info) != 0 || access(target.c_str(), W_OK) != 0) return false;
  std::string temporary = target + ".XXXXXX";
  const int file = mkstemp(temporary.data());
  if (file < 0) return false;
  // Only root may give files away; for everyone else the owner is right already.
  const bool owned =
      fchown(file, info.st_uid, info.st_gid) == 0 || (errno == EPERM && info.st_uid == geteuid());
  bool good =
      owned && write_all(file, text) && fchmod(file, info.st_mode & 07777) == 0 && fsync(file) == 0;
  good = close(file) == 0 && good;
  good = good && std::rename(temporary.c_str(), target.c_str()) == 0;
  const int reason = errno;
  if (!good) unlink(temporary.c_str());
  errno = reason;
  return good;
}

int format_text(const FormatOptions& options, const std::string& name, std::string text) {
  SourceSet sources;
  const Source& source = sources.add(name, std::move(text));
  const Formatted result = format_program(source);
  for (const Diagnostic& problem : result.problems) show(problem, sources, options.json);
  if (!result.text) return kRejected;
  if (result.changed_meaning) {
    progress(
        fmt::format("armlet: a defect of armlet itself: {} was left as it is, because another "
                    "layout would have changed what it says",
                    name));
    return kFailed;
  }
  const bool differs = *result.text != source.text();
  if (options.check) {
    if (differs) print_out(name + "\n");
    return differs ? kUnformatted : kDone;
  }
  if (name == kStandardInput) {
    print_out(*result.text);
  } else if (differs && !replace_file(name, *result.text)) {
    progress(fmt::format("armlet: {} cannot be written: {}", name, std::strerror(errno)));
    return kNoFile;
  }
  return kDone;
}

}  // namespace

int format(const FormatOptions& options) {
  int exit = kDone;
  for (const std::string& file : options.files) {
    auto text = file == kStandardInput ? read_file("/dev/stdin", options.json)
                                       : read_file(file, options.json);
    exit = std::max<int>(exit, text ? format_text(options, file, *std::move(text)) : kNoFile);
  }
  return finish_output() ? exit : kFailed;
}

}  // namespace armlet::cli
