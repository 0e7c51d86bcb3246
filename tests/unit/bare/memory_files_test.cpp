// The bare platform, which is that of WebAssembly, compiled for this machine.
#include "core/bare/memory_files.hpp"

#include <doctest/doctest.h>

#include <random>
#include <system_error>

#include "armlet/core/files.hpp"
#include "armlet/core/platform.hpp"

using namespace armlet;

namespace {

constexpr std::size_t kMost = 1 << 20;

std::string code_of(const Result<std::string>& result) {
  return result.ok() ? "" : result.error().code;
}

}  // namespace

TEST_CASE("what a host puts there a program reads, and the other way round") {
  memory_files::put("/job/data/in.csv", "t,x\n0,1\n");
  const Result<Folder> folder = Folder::open("job/");
  REQUIRE(folder.ok());
  CHECK(folder->read("data/in.csv", kMost).value() == "t,x\n0,1\n");
  CHECK(folder->read("./data/../data//in.csv", kMost).value() == "t,x\n0,1\n");
  CHECK(folder->has_file("data/in.csv"));
  CHECK_FALSE(folder->has_file("data"));
  REQUIRE_FALSE(folder->save("out.svg", "<svg/>"));
  CHECK(memory_files::get("/job/out.svg") == "<svg/>");
  CHECK(read_file("job/out.svg", kMost).value() == "<svg/>");
  CHECK(memory_files::list("/job") == std::vector<std::string>{"/job/data/in.csv", "/job/out.svg"});
  CHECK(folder->names("", ".svg") == std::vector<std::string>{"out.svg"});
  CHECK(folder->names("data", ".csv") == std::vector<std::string>{"in.csv"});
  CHECK(is_file("/job/out.svg"));
  CHECK(is_same_file("job/out.svg", "/job/./out.svg"));
  CHECK(memory_files::remove("/job/out.svg"));
  CHECK_FALSE(memory_files::remove("/job/out.svg"));
  CHECK(memory_files::remove("/job/data/in.csv"));
  CHECK(memory_files::list("/").empty());
}

TEST_CASE("what cannot be read is refused with the codes of other platforms") {
  memory_files::put("/job/data/in.csv", "12345");
  const Result<Folder> folder = Folder::open("/job");
  REQUIRE(folder.ok());
  CHECK(code_of(folder->read("none.csv", kMost)) == "missing");
  CHECK(code_of(folder->read("../other.csv", kMost)) == "outside");
  CHECK(code_of(folder->read("/etc/passwd", kMost)) == "outside");
  CHECK(code_of(folder->read("data", kMost)) == "kind");
  CHECK(code_of(folder->read("data/in.csv/deeper", kMost)) == "kind");
  CHECK(code_of(folder->read("", kMost)) == "name");
  CHECK(code_of(folder->read("data/in.csv", 4)) == "large");
  CHECK(folder->save("data", "x")->code == "kind");
  CHECK_FALSE(Folder::open("/job/data/in.csv").ok());
  CHECK(read_all(0, kMost).error().code == "system");
  memory_files::remove("/job/data/in.csv");
}

TEST_CASE("a file that is not finished is not there") {
  const Result<Folder> folder = Folder::open("/job");
  REQUIRE(folder.ok());
  memory_files::put("/job/a.csv", "before");
  {
    NewFile file = folder->create("a.csv").value();
    CHECK(file.write("after"));
  }
  CHECK(memory_files::get("/job/a.csv") == "before");
  NewFile file = folder->create("a.csv").value();
  CHECK(file.write("after"));
  CHECK_FALSE(file.finish());
  CHECK(memory_files::get("/job/a.csv") == "after");
  CHECK(file.finish()->code == "name");
  memory_files::remove("/job/a.csv");
}

TEST_CASE("writing and seeking leave what a plain text would hold") {
  std::mt19937 random(15);
  const Result<Folder> folder = Folder::open("/job");
  for (int round = 0; round < 200; ++round) {
    NewFile file = folder->create("a.bin").value();
    std::string expected;
    std::size_t at = 0;
    for (int step = 0; step < 20; ++step) {
      if (random() % 3 == 0) {
        at = random() % 50;
        CHECK(file.seek(at));
        continue;
      }
      const std::string piece(random() % 9, static_cast<char>('a' + random() % 26));
      CHECK(file.write(piece));
      if (!piece.empty() && expected.size() < at + piece.size()) expected.resize(at + piece.size());
      for (const char c : piece) expected[at++] = c;
    }
    REQUIRE_FALSE(file.finish());
    CHECK(memory_files::get("/job/a.bin") == expected);
  }
  memory_files::remove("/job/a.bin");
}

TEST_CASE("one thread has no alarm") {
  CHECK_THROWS_AS(Alarm(1000, [] {}), std::system_error);
  CHECK(LoadedLibrary("libm.so.6").find("sin") == nullptr);
  CHECK_FALSE(reserves_for_free());
  ReservedMemory memory(1 << 20);
  static_cast<char*>(memory.begin())[memory.bytes() - 1] = 'x';
  memory.give_back(100);
  CHECK(static_cast<char*>(memory.begin())[memory.bytes() - 1] == 'x');
  const std::int64_t before = steady_time_ns();
  CHECK(before <= steady_time_ns());
}
