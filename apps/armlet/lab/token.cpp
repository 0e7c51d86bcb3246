#include "lab/token.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdlib>
#include <string_view>

#include "armlet/core/files.hpp"
#include "server/http_guard.hpp"

namespace armlet::cli {
namespace {

constexpr std::size_t kMostTokenBytes = 4096;
constexpr const char* kVariable = "ARMLET_LAB_TOKEN";

bool is_read_by_others(const std::string& path) {
  struct stat known {};
  return stat(path.c_str(), &known) == 0 && (known.st_mode & (S_IRGRP | S_IROTH)) != 0;
}

}  // namespace

GivenToken given_token(const LabOptions& options) {
  GivenToken given;
  std::string from = kVariable;
  if (options.token_on_command_line) {
    given.fault = fmt::format(
        "--token: every user of this machine can read command lines; write the token into a file "
        "and give --token-file FILE, or set the variable {}",
        kVariable);
  } else if (!options.token_file.empty()) {
    from = options.token_file;
    Result<std::string> text = armlet::read_file(from, kMostTokenBytes);
    if (!text.ok())
      return {
          .token = {}, .warning = {}, .fault = from + ": " + text.error().message, .exit = kNoFile};
    given.token = std::move(text).value();
    given.token.erase(given.token.find_last_not_of(" \t\r\n") + 1);
    if (is_read_by_others(from))
      given.warning = fmt::format("other users can read {0}; chmod 600 {0}", from);
    if (given.token.empty()) given.fault = from + " has no token in it";
  } else if (const char* value = std::getenv(kVariable); value != nullptr) {
    given.token = value;
  }
  if (given.fault.empty() && !given.token.empty()) {
    given.fault = lab::fault_of_token(given.token);
    if (!given.fault.empty()) given.fault = from + ": " + given.fault;
  }
  if (!given.fault.empty()) given.exit = kUsage;
  return given;
}

std::string warning_of_host(const std::string& host) {
  if (lab::is_loopback(host)) return {};
  return fmt::format(
      "other machines can reach {}, and the connection is not encrypted: who can listen on the way "
      "reads the program and the token, with which anybody controls the laboratory. Where that "
      "matters, leave out --host, give --port P, and reach it through a tunnel from the other "
      "machine: ssh -L P:127.0.0.1:P this-machine",
      host);
}

}  // namespace armlet::cli
