// Logs of runs: any records are refused with a reason, or make a session that ends.
//
// The input is records that end in 0x1E, each a kind and its fields, which begin with 0x1F. The
// sizes of the fields, the first line of the log and its sum are added here.

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "armlet/core/hash.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/stdlib/session_log.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

constexpr int kMostEntries = 8;

// The first line that this version writes.
std::string first_line() {
  const std::string bytes = write_log(SessionLog{}).value();
  return bytes.substr(0, bytes.find('\n') + 1);
}

// The part of the text before the sign, which is taken off with it.
std::string_view take_until(std::string_view& text, char sign) {
  const std::string_view part = text.substr(0, text.find(sign));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

std::string log_of(std::string_view input) {
  static const std::string first = first_line();
  std::string bytes = first;
  while (!input.empty()) {
    std::string_view fields = take_until(input, '\x1E');
    std::string body;
    bytes += take_until(fields, '\x1F');
    while (!fields.empty()) {
      const std::string_view field = take_until(fields, '\x1F');
      bytes += fmt::format(" {}", field.size());
      body += field;
    }
    bytes += "\n" + body + "\n";
  }
  Fnv1a hash;
  hash.add_bytes(bytes);
  return bytes + fmt::format("sum 16\n{:016x}\n", hash.value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = log_of(fuzz::text_of(data, size));
  Result<SessionLog> read = read_log(bytes);
  if (!read.ok()) {
    fuzz::demand(!read.error().message.empty(), "what is refused has a reason");
    return 0;
  }
  SessionLog log = std::move(read).value();
  const Result<std::string> again = write_log(log);
  fuzz::demand(again.ok() && *again == bytes, "a log that was read is written as it was");

  SessionOptions options = fuzz::small_session();
  log.robot = options.robot->name();
  log.planners.clear();
  log.limits = options.limits;
  options.world = log.world;
  options.default_world = log.default_world;
  options.open = log.open;
  options.laboratory = log.laboratory;
  Session session(library_engine(), std::move(options));
  try {
    if (!session.replay(log)) {
      fuzz::show_all(session);
      return 0;
    }
  } catch (const ArgumentError& error) {
    fuzz::demand(*error.what() != '\0', "what is refused has a reason");
    return 0;
  }
  for (int i = 0; i < kMostEntries && session.to_come() > 0; ++i) {
    const RunResult result = session.run();
    fuzz::demand(result.error.has_value() == (result.status != Progress::kDone),
                 "what does not end well has a message, and only that");
  }
  fuzz::show_all(session);
  return 0;
}
