// Deletes one token at a time from programs and prints how many messages that gives.
//
//   token_deletions [--show N] FOLDER...     N: also show the trials with more messages than that
#include <cstdio>
#include <cstdlib>
#include <string>

#include "deletions.hpp"

using namespace armlet::test;

int main(int argc, char** argv) {
  int first = 1;
  std::size_t show = 1000;
  if (argc > 2 && std::string(argv[1]) == "--show") {
    show = static_cast<std::size_t>(std::atoi(argv[2]));
    first = 3;
  }
  if (argc <= first) {
    std::fprintf(stderr, "usage: token_deletions [--show N] FOLDER...\n");
    return 64;
  }
  Distribution all;
  std::size_t programs = 0;
  for (int i = first; i < argc; ++i) {
    for (const auto& [path, text] : programs_below(argv[i])) {
      const armlet::Source source(path, text);
      const std::vector<Trial> trials = delete_tokens(text);
      all.add(trials);
      ++programs;
      for (const Trial& trial : trials) {
        if (trial.messages.size() <= show) continue;
        const armlet::Position at = source.position(trial.deleted.begin);
        std::printf("%s:%d:%d without `%s`\n", path.c_str(), at.line, at.column,
                    std::string(source.slice(trial.deleted)).c_str());
        for (const std::string& message : trial.messages) std::printf("    %s\n", message.c_str());
      }
    }
  }
  std::printf("%zu programs, %zu trials\n%s%.1f %% with more than two messages\n", programs,
              all.all(), all.text().c_str(), 100.0 * all.above(2));
  return 0;
}
