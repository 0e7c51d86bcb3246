// Writes random programs into files, for those who run them in another process or another build:
// write_programs FOLDER COUNT leaves FOLDER/random_1.rbt and so on.

#include <fmt/format.h>

#include <cstdlib>

#include "armlet/core/files.hpp"
#include "random/program.hpp"

int main(int count, char** arguments) {
  using namespace armlet;
  if (count != 3) {
    fmt::print(stderr, "write_programs FOLDER COUNT\n");
    return 2;
  }
  const Result<Folder> folder = Folder::open(arguments[1]);
  if (!folder.ok()) {
    fmt::print(stderr, "{}: {}\n", arguments[1], folder.error().message);
    return 1;
  }
  for (std::uint64_t number = 1; number <= std::strtoull(arguments[2], nullptr, 10); ++number) {
    const std::string name = fmt::format("random_{}.rbt", number);
    if (const auto error = folder->save(name, oracle::RandomProgram(number).text())) {
      fmt::print(stderr, "{}: {}\n", name, error->message);
      return 1;
    }
  }
  return 0;
}
