#include "armlet/core/files.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace armlet;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = 1 << 20;

// An empty folder for one test, removed behind it.
class Empty {
 public:
  Empty() {
    static int count = 0;
    path_ = fs::temp_directory_path() /
            ("armlet_core_files_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Empty() { fs::remove_all(path_); }
  Empty(const Empty&) = delete;
  Empty& operator=(const Empty&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

std::string content(const fs::path& file) {
  std::ostringstream out;
  out << std::ifstream(file, std::ios::binary).rdbuf();
  return out.str();
}

// "" or the reason.
std::string refusal(const std::optional<Error>& error) { return error ? error->message : ""; }
template <class T>
std::string refusal(const Result<T>& result) {
  return result.ok() ? "" : result.error().message;
}
template <class T>
std::string code(const Result<T>& result) {
  return result.ok() ? "" : result.error().code;
}
std::string code(const std::optional<Error>& error) { return error ? error->code : ""; }

Folder at(const fs::path& path) {
  Result<Folder> folder = Folder::open(path.string());
  REQUIRE(folder.ok());
  return std::move(folder).value();
}

int files_in(const fs::path& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder)) ++count;
  return count;
}

// Forms in which a system writes.
long three_at_a_time(int file, const void* bytes, std::size_t count) {
  return ::write(file, bytes, std::min<std::size_t>(count, 3));
}
int interruptions = 0;
long interrupted_first(int file, const void* bytes, std::size_t count) {
  if (interruptions++ % 2 == 0) {
    errno = EINTR;
    return -1;
  }
  return ::write(file, bytes, std::min<std::size_t>(count, 2));
}
long room = 0;
long until_full(int file, const void* bytes, std::size_t count) {
  if (room == 0) {
    errno = ENOSPC;
    return -1;
  }
  const long written = ::write(file, bytes, std::min<std::size_t>(count, room));
  room -= written;
  return written;
}
long nothing(int, const void*, std::size_t) { return 0; }
long to_a_full_device(int, const void* bytes, std::size_t count) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  const long written = ::write(full, bytes, count);
  const int number = errno;
  ::close(full);
  errno = number;
  return written;
}

}  // namespace

TEST_CASE("a file that is being written can be returned to") {
  const Empty folder;
  Result<NewFile> made = create_file(folder / "a.bin");
  REQUIRE(made.ok());
  NewFile file = std::move(made).value();
  FileStream out(file);
  out << "head tail";
  out.seekp(0);
  out << "HEAD";
  out.seekp(9);
  out << '!';
  CHECK(out.good());
  CHECK_FALSE(file.finish());
  CHECK(content(folder / "a.bin") == "HEAD tail!");
  CHECK_FALSE(file.seek(0));  // it is finished
}

TEST_CASE("what is written is read again, and replaces what was there") {
  const Empty empty;
  const Folder folder = at(empty.path());
  CHECK(refusal(folder.save("a.txt", "one")) == "");
  CHECK(*folder.read("a.txt", kMost) == "one");
  fs::permissions(empty.path() / "a.txt", fs::perms(0640));
  const std::string bytes("two\0\n\xff", 6);
  CHECK(refusal(folder.save("a.txt", bytes)) == "");
  CHECK(*folder.read("a.txt", kMost) == bytes);
  CHECK(fs::status(empty.path() / "a.txt").permissions() == fs::perms(0640));
  CHECK(folder.save("empty.txt", "") == std::nullopt);
  CHECK(*folder.read("empty.txt", 0) == "");
  CHECK(files_in(empty.path()) == 2);
}

TEST_CASE("names lead to files below the folder and nowhere else") {
  const Empty empty;
  fs::create_directories(empty.path() / "in" / "deep");
  const Folder folder = at(empty.path() / "in");
  const fs::path in = fs::canonical(empty.path() / "in");
  for (const std::string& name :
       {std::string("run.csv"), std::string("./run.csv"), std::string("deep/../run.csv"),
        std::string("deep//.././/run.csv"), in.string() + "/run.csv"}) {
    CAPTURE(name);
    CHECK(*folder.clean(name) == "run.csv");
    CHECK(refusal(folder.save(name, name)) == "");
    CHECK(content(in / "run.csv") == name);
  }
  CHECK(refusal(folder.save("deep/run.csv", "x")) == "");
  for (const std::string& name :
       {std::string("../run.csv"), std::string("deep/../../run.csv"), std::string("/run.csv"),
        std::string(".."), in.string() + "x/run.csv", std::string("/../") + in.string() + "/x"}) {
    CAPTURE(name);
    CHECK(code(folder.save(name, "x")) == "outside");
    CHECK(code(folder.read(name, kMost)) == "outside");
    CHECK_FALSE(folder.has_file(name));
  }
  CHECK(refusal(folder.save("", "x")) == "the name of the file is empty");
  CHECK(refusal(folder.save(std::string("a.rbt\0.csv", 10), "x")) ==
        "the name of the file holds a zero byte");
  CHECK(refusal(folder.save(std::string(5000, 'n'), "x")) ==
        "the name of the file has 5000 bytes; at most 4095 are possible");
  CHECK(code(folder.save(std::string(300, 'n'), "x")) == "system");
  CHECK(refusal(folder.save(".", "x")) == "it is a folder");
  CHECK(refusal(folder.save("deep", "x")) == "there is a folder of that name");
  CHECK(refusal(folder.read("deep", kMost)) == "it is a folder");
  CHECK(refusal(folder.read("none", kMost)) == "there is no such file");
  CHECK(refusal(folder.save("deep/none/run.csv", "x")) == "there is no folder \"deep/none\"");
  CHECK(refusal(folder.save("run.csv/more.csv", "x")) == "\"run.csv\" is no folder");
  CHECK(folder.has_file("deep/run.csv"));
  CHECK_FALSE(folder.has_file("deep"));
  CHECK(folder.names("", ".csv") == std::vector<std::string>{"run.csv"});
  CHECK(folder.names("deep", ".csv") == std::vector<std::string>{"run.csv"});
  CHECK(folder.names("none", ".csv").empty());
  CHECK(folder.names("..", "").empty());
  CHECK(files_in(empty.path()) == 1);
}

TEST_CASE("no link is followed below a folder, wherever it leads") {
  const Empty empty;
  fs::create_directories(empty.path() / "in" / "deep");
  fs::create_directories(empty.path() / "out");
  std::ofstream(empty.path() / "out" / "secret.txt") << "secret";
  const fs::path in = empty.path() / "in";
  std::ofstream(in / "deep" / "own.txt") << "own";
  fs::create_symlink(empty.path() / "out" / "secret.txt", in / "there.txt");
  fs::create_symlink(empty.path() / "out" / "new.txt", in / "dangling.txt");
  fs::create_symlink("deep/own.txt", in / "inside.txt");
  fs::create_directory_symlink(empty.path() / "out", in / "way");
  fs::create_symlink("circle.txt", in / "circle.txt");
  const Folder folder = at(in);
  for (const char* name : {"there.txt", "dangling.txt", "inside.txt", "circle.txt"}) {
    CAPTURE(name);
    CHECK(refusal(folder.save(name, "x")) == "it is a link, and links are not followed here");
    CHECK(refusal(folder.read(name, kMost)) == "it is a link, and links are not followed here");
    CHECK_FALSE(folder.has_file(name));
    CHECK(fs::is_symlink(in / name));
  }
  CHECK(refusal(folder.save("way/new.txt", "x")) ==
        "\"way\" is a link, and links are not followed here");
  CHECK(code(folder.read("way/secret.txt", kMost)) == "link");
  CHECK(folder.names("way", ".txt").empty());
  CHECK(content(empty.path() / "out" / "secret.txt") == "secret");
  CHECK(content(in / "deep" / "own.txt") == "own");
  CHECK(files_in(empty.path() / "out") == 1);
}

TEST_CASE("a folder that is held open stays the same one when its name comes to mean another") {
  const Empty empty;
  fs::create_directories(empty.path() / "mine");
  fs::create_directories(empty.path() / "other");
  const Folder folder = at(empty.path() / "mine");
  fs::rename(empty.path() / "mine", empty.path() / "moved");
  fs::create_directory_symlink(empty.path() / "other", empty.path() / "mine");
  CHECK(refusal(folder.save("a.txt", "x")) == "");
  CHECK(content(empty.path() / "moved" / "a.txt") == "x");
  CHECK(fs::is_empty(empty.path() / "other"));
}

TEST_CASE("what is no regular file is refused and nobody waits for it") {
  const Empty empty;
  REQUIRE(mkfifo((empty / "pipe").c_str(), 0600) == 0);
  const Folder folder = at(empty.path());
  CHECK(refusal(folder.read("pipe", kMost)) == "it is a pipe, not a file");
  CHECK(refusal(folder.save("pipe", "x")) == "it is a pipe, not a file");
  CHECK(refusal(read_file(empty / "pipe", kMost)) == "it is a pipe, not a file");
  CHECK(refusal(create_file(empty / "pipe")) == "it is a pipe, not a file");
  CHECK(refusal(read_file("/dev/zero", kMost)) == "it is a device, not a file");
  CHECK(refusal(create_file("/dev/full")) == "it is a device, not a file");
  CHECK(refusal(read_file(empty.path().string(), kMost)) == "it is a folder");
  CHECK(refusal(create_file(empty.path().string() + "/")) == "it is a folder");
  CHECK(refusal(create_file(empty / "no/file")).starts_with("there is no folder \""));
}

TEST_CASE("a file that is too large is refused before it is read") {
  const Empty empty;
  const Folder folder = at(empty.path());
  REQUIRE_FALSE(folder.save("large", std::string(1001, 'x')));
  CHECK(refusal(folder.read("large", 1000)) == "it has 1001 bytes; at most 1000 are read");
  CHECK(folder.read("large", 1001).ok());
  // The system gives no size for what it makes up while it is read.
  CHECK(refusal(read_file("/proc/self/status", 10)) ==
        "it has more than 10 bytes; no more are read");
}

TEST_CASE("files arrive whole from a system that takes a few bytes at a time") {
  const Empty empty;
  const Folder folder = at(empty.path());
  const std::string text = "a few bytes at a time, and all of them in order";
  for (const WriteBytes write : {three_at_a_time, interrupted_first}) {
    CHECK(refusal(folder.save("a.txt", text, write)) == "");
    CHECK(content(empty.path() / "a.txt") == text);
  }
}

TEST_CASE("a device that fills up leaves the file before as it was, and nothing half") {
  const Empty empty;
  const Folder folder = at(empty.path());
  REQUIRE_FALSE(folder.save("old.txt", "old"));
  for (const WriteBytes write : {until_full, to_a_full_device, nothing}) {
    for (const char* name : {"old.txt", "new.txt"}) {
      room = 5;
      CHECK(refusal(folder.save(name, "more than five", write)) == "No space left on device");
    }
  }
  CHECK(content(empty.path() / "old.txt") == "old");
  CHECK(files_in(empty.path()) == 1);
}

TEST_CASE("a limit on the size of files is a full device too") {
  const Empty empty;
  const Folder folder = at(empty.path());
  REQUIRE_FALSE(folder.save("old.txt", "old"));
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{1000, before.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const std::optional<Error> failed = folder.save("old.txt", std::string(5000, 'x'));
  const std::optional<Error> done = folder.save("small.txt", std::string(1000, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(refusal(failed) == "File too large");
  CHECK(refusal(done) == "");
  CHECK(content(empty.path() / "old.txt") == "old");
  CHECK(files_in(empty.path()) == 2);
}

TEST_CASE("until a file is finished its name means the one before") {
  const Empty empty;
  const Folder folder = at(empty.path());
  REQUIRE_FALSE(folder.save("a.txt", "old"));
  {
    Result<NewFile> made = folder.create("a.txt");
    REQUIRE(made.ok());
    NewFile file = std::move(made).value();
    FileStream out(file);
    out << "new " << 1 << '\n';
    CHECK(out.good());
    CHECK(content(empty.path() / "a.txt") == "old");
    NewFile moved = std::move(file);
    CHECK_FALSE(file.write("x"));
    CHECK(moved.finish() == std::nullopt);
    CHECK(moved.finish() != std::nullopt);
  }
  CHECK(content(empty.path() / "a.txt") == "new 1\n");
  {
    Result<NewFile> made = folder.create("a.txt");
    REQUIRE(made.ok());
    NewFile file = std::move(made).value();
    CHECK(file.write("given up"));
    CHECK(files_in(empty.path()) == 2);
  }
  CHECK(content(empty.path() / "a.txt") == "new 1\n");
  CHECK(files_in(empty.path()) == 1);
}

TEST_CASE("a library can write an unfinished file by its path, which has the ending of the name") {
  const Empty empty;
  Result<NewFile> made = at(empty.path()).create("film.mp4");
  REQUIRE(made.ok());
  NewFile file = std::move(made).value();
  CHECK(file.path().ends_with(".mp4"));
  std::ofstream(file.path(), std::ios::binary | std::ios::trunc) << "written elsewhere";
  CHECK_FALSE(fs::exists(empty.path() / "film.mp4"));
  CHECK(file.finish() == std::nullopt);
  CHECK(content(empty.path() / "film.mp4") == "written elsewhere");
  CHECK(file.path().empty());
  CHECK(files_in(empty.path()) == 1);
}

TEST_CASE("a stream goes bad when its file cannot be written") {
  const Empty empty;
  Result<NewFile> made = at(empty.path()).create("a.txt", until_full);
  REQUIRE(made.ok());
  NewFile file = std::move(made).value();
  FileStream out(file);
  room = 3;
  out.put('a');
  CHECK(out.good());
  out << "bcdef";
  CHECK(out.bad());
  CHECK(refusal(file.finish()) == "No space left on device");
  CHECK(files_in(empty.path()) == 0);
}

TEST_CASE("a process that is being ended takes its unfinished files with it") {
  const Empty empty;
  const Folder folder = at(empty.path());
  Result<NewFile> made = folder.create("a.txt");
  REQUIRE(made.ok());
  NewFile file = std::move(made).value();
  CHECK(file.write("half"));
  CHECK(files_in(empty.path()) == 1);
  remove_unfinished_files();
  CHECK(files_in(empty.path()) == 0);
  CHECK(code(file.finish()) == "system");  // it is gone
}

TEST_CASE("a file that its owner protects is not replaced") {
  if (geteuid() == 0) return;  // root may do everything
  const Empty empty;
  const Folder folder = at(empty.path());
  REQUIRE_FALSE(folder.save("a.txt", "old"));
  fs::permissions(empty.path() / "a.txt", fs::perms(0444));
  CHECK(refusal(folder.save("a.txt", "new")) == "Permission denied");
  CHECK(content(empty.path() / "a.txt") == "old");
}

TEST_CASE("links that a person names are followed, and what they lead to is replaced") {
  const Empty empty;
  fs::create_directories(empty.path() / "data");
  std::ofstream(empty.path() / "data" / "run.csv") << "old";
  fs::create_symlink("data/run.csv", empty.path() / "link.csv");
  fs::create_symlink("data/none.csv", empty.path() / "nowhere.csv");
  CHECK(*read_file(empty / "link.csv", kMost) == "old");
  Result<NewFile> made = create_file(empty / "link.csv");
  REQUIRE(made.ok());
  NewFile file = std::move(made).value();
  file.write("new");
  CHECK(file.finish() == std::nullopt);
  CHECK(fs::is_symlink(empty.path() / "link.csv"));
  CHECK(content(empty.path() / "data" / "run.csv") == "new");
  CHECK(refusal(create_file(empty / "nowhere.csv")) == "it is a link that leads nowhere");
  CHECK(is_same_file(empty / "link.csv", empty / "data/run.csv"));
  CHECK_FALSE(is_same_file(empty / "link.csv", empty / "nowhere.csv"));
  CHECK_FALSE(is_same_file(empty / "none", empty / "none"));
}
