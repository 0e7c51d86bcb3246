// Runs a target without libFuzzer: replay CORPUS DICTIONARY MUTATIONS SEED, or replay FILE...
//
// Every file of the folder CORPUS is an input, then come so many mutations of them. An input that
// crashes or takes too long is left in the file fuzz_input.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "entry.hpp"
#include "mutator.hpp"

namespace {

constexpr unsigned kSeconds = 30;  // for one input, on a machine that is busy with other things

std::string present;  // the input that is being run

extern "C" void keep_input(int signal) {
  const int file = open("fuzz_input", O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file >= 0 && write(file, present.data(), present.size()) >= 0) close(file);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void run(std::string input) {
  present = std::move(input);
  alarm(kSeconds);
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(present.data()), present.size());
  alarm(0);
}

std::vector<std::string> read_folder(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry);
  std::ranges::sort(paths);
  std::vector<std::string> out;
  for (const auto& path : paths) out.push_back(read(path));
  return out;
}

void keep_input_of_crashes() {
  static char stack[65536];  // a crash may be an overflow of the stack
  const stack_t other{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
  sigaltstack(&other, nullptr);
  struct sigaction action {};
  action.sa_handler = keep_input;
  action.sa_flags = SA_ONSTACK;
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGALRM})
    sigaction(signal, &action, nullptr);
}

}  // namespace

int main(int argc, char** argv) {
  keep_input_of_crashes();
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() != 4 || !std::filesystem::is_directory(arguments[0])) {
    for (const std::string& file : arguments) run(read(file));
    return arguments.empty() ? 64 : 0;
  }
  const std::vector<std::string> corpus = read_folder(arguments[0]);
  for (const std::string& input : corpus) run(input);
  armlet::fuzz::Mutator mutator(corpus, armlet::fuzz::words_of(read(arguments[1])),
                                std::stoull(arguments[3]));
  const int mutations = std::stoi(arguments[2]);
  for (int i = 0; i < mutations; ++i) run(mutator.next());
  std::printf("%zu files and %d mutations\n", corpus.size(), mutations);
  return 0;
}
