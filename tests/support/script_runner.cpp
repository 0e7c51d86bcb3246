// Runs one .rbt script with the command and compares what it did with the comments in it.
//
//   script_runner [--update] COMMAND FILE
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "expectations.hpp"

namespace fs = std::filesystem;
using namespace armlet::test;

namespace {

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

void replace_all(std::string& text, const std::string& old, const std::string& now) {
  for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos; at += now.size())
    text.replace(at, old.size(), now);
}

// Messages name the script by its path; scripts expect the bare name or one of their choice.
std::string renamed(std::string text, const fs::path& script, const std::string& name) {
  if (!name.empty()) replace_all(text, script.string(), name);
  replace_all(text, script.parent_path().string() + "/", "");
  return text;
}

struct Run {
  std::string output, errors;
  int exit = 0;
};

// Runs the command in a folder of its own, so that traces are left nowhere else.
Run run(const std::string& command, std::string options, const fs::path& script,
        const std::string& name = "") {
  replace_all(options, "{folder}", quoted(script.parent_path().string()));
  const fs::path folder =
      fs::temp_directory_path() / ("armlet_script_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const std::string line = "cd " + quoted(folder) + " && " + quoted(command) + " " + options + " " +
                           quoted(script) + " >stdout 2>stderr </dev/null";
  const int status = std::system(line.c_str());
  const Run result{read(folder / "stdout"), renamed(read(folder / "stderr"), script, name),
                   WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)};
  fs::remove_all(folder);
  return result;
}

Outcome outcome_of(const std::string& command, const Expectations& expected,
                   const fs::path& script) {
  const Run json = run(command, expected.command + " --json", script);
  Outcome outcome{split_lines(json.output), {}, {}, json.exit};
  for (const std::string& line : split_lines(json.errors)) {
    const auto message = nlohmann::json::parse(line, nullptr, false);
    if (message.is_object() && message.contains("code"))
      outcome.messages.push_back({message["code"], message["message"], message.value("line", 0),
                                  message.value("column", 0)});
    else if (json.exit > 70 || json.exit == 1)  // not a status of ours: show what was said
      std::fprintf(stderr, "%s\n", line.c_str());
  }
  if (!expected.shown.empty())
    outcome.shown = only_messages(
        split_lines(run(command, expected.command, script, expected.shown_as).errors));
  return outcome;
}

int check(const std::string& command, const fs::path& script, bool update) {
  const std::string source = read(script);
  const Expectations expected = parse_expectations(source);
  const Outcome outcome = outcome_of(command, expected, script);
  if (update) {
    std::ofstream(script, std::ios::binary) << update_expectations(source, outcome);
    return 0;
  }
  const auto found = differences(expected, outcome);
  for (const std::string& difference : found)
    std::fprintf(stderr, "%s: %s\n", script.filename().c_str(), difference.c_str());
  return found.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool update = argc > 1 && std::string(argv[1]) == "--update";
  const int first = update ? 2 : 1;
  if (argc < first + 2) {
    std::fprintf(stderr, "usage: script_runner [--update] COMMAND FILE [LIBRARY THAT IT LOADS]\n");
    return 64;
  }
  try {
    return check(fs::absolute(argv[first]), fs::absolute(argv[first + 1]), update);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[first + 1], error.what());
    return 1;
  }
}
