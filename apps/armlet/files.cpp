#include "files.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "armlet/interpreter/engine.hpp"

namespace armlet::cli {

std::optional<std::string> read_text(const std::string& path, std::string& reason) {
  struct stat info {};
  if (stat(path.c_str(), &info) != 0) {
    reason = errno == ENOENT ? "there is no such file" : std::strerror(errno);
    return std::nullopt;
  }
  if (S_ISDIR(info.st_mode)) {
    reason = "it is a folder";
    return std::nullopt;
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    reason = std::strerror(errno);
    return std::nullopt;
  }
  const std::size_t limit = ParseLimits{}.bytes;
  std::string text;
  char buffer[65536];
  std::size_t got = 0;
  while (text.size() <= limit && (got = std::fread(buffer, 1, sizeof buffer, file)) > 0)
    text.append(buffer, got);
  const bool failed = std::ferror(file) != 0;
  std::fclose(file);
  if (!failed) return text;
  reason = "reading failed";
  return std::nullopt;
}

}  // namespace armlet::cli
