#include "lab/browser.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <system_error>
#include <thread>

extern char** environ;

namespace armlet::cli {
namespace {

// Makes a folder that only this user can enter.
std::optional<std::filesystem::path> make_private_folder() {
  for (const char* variable : {"XDG_RUNTIME_DIR", "TMPDIR", ""}) {
    const char* place = *variable == '\0' ? "/tmp" : std::getenv(variable);
    if (place == nullptr || *place == '\0') continue;
    std::string name = std::string(place) + "/armlet-lab-XXXXXX";
    if (mkdtemp(name.data()) != nullptr) return name;
  }
  return std::nullopt;
}

bool write_private(const std::filesystem::path& file, const std::string& text) {
  const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (handle < 0) return false;
  const bool is_written =
      ::write(handle, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  return (::close(handle) == 0) && is_written;
}

void start_browser(const std::string& address) {
  std::string command = "xdg-open";
  std::string argument = address;
  char* const arguments[] = {command.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&quiet, 2, "/dev/null", 1, 0);
  pid_t child = 0;
  const bool begun =
      posix_spawnp(&child, command.c_str(), &quiet, nullptr, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&quiet);
  if (begun) std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

}  // namespace

BrowserOpener::~BrowserOpener() {
  std::error_code none;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, none);
}

void BrowserOpener::open(const std::string& address) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const auto folder = make_private_folder();
  if (!folder) return;
  folder_ = *folder;
  const std::filesystem::path file = folder_ / "laboratory.html";
  const std::string page = fmt::format(
      "<!doctype html>\n<meta charset=\"utf-8\">\n<meta name=\"referrer\" "
      "content=\"no-referrer\">\n"
      "<meta http-equiv=\"refresh\" content=\"0; url={0}\">\n<title>Armlet laboratory</title>\n"
      "<a href=\"{0}\">The laboratory</a>\n",
      address);
  if (write_private(file, page)) start_browser("file://" + file.string());
}

}  // namespace armlet::cli
