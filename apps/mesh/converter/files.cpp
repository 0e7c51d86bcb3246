#include "converter/files.hpp"

#include <unistd.h>

#include <cerrno>

namespace armlet::mesh {
namespace {

constexpr int kNobodyListens = 3;  // exit status

void write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) _exit(kNobodyListens);
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void read_all(char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t taken = read(STDIN_FILENO, bytes, count);
    if (taken < 0 && errno == EINTR) continue;
    if (taken <= 0) _exit(kNobodyListens);
    bytes += taken;
    count -= static_cast<std::size_t>(taken);
  }
}

void say(Say what, std::string_view text) {
  write_all(say_header(what, text.size()));
  write_all(text);
}

GivenFile take() {
  char header[kSayHeader];
  read_all(header, sizeof header);
  GivenFile file{static_cast<Say>(header[0]), {}};
  file.text.resize(said_length(header));
  read_all(file.text.data(), file.text.size());
  return file;
}

}  // namespace

std::string Files::take_input() { return take().text; }

const GivenFile& Files::find(const std::string& name) {
  const auto known = given_.find(name);
  if (known != given_.end()) return known->second;
  say(Say::kWant, name);
  return given_.emplace(name, take()).first->second;
}

void Files::tell_stage(std::string_view stage) { say(Say::kStage, stage); }

void Files::finish(std::string_view glb) {
  say(Say::kDone, glb);
  _exit(0);  // libraries are not shut down: their data may be damaged
}

void Files::fail(std::string_view why) {
  say(Say::kFailed, why);
  _exit(0);
}

}  // namespace armlet::mesh
