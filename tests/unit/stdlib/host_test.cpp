#include "armlet/stdlib/host.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"

using namespace armlet;

namespace {

namespace fs = std::filesystem;

// An empty folder for one test, removed behind it.
class Folder {
 public:
  explicit Folder(const char* name)
      : path_(fs::temp_directory_path() / (std::string(name) + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

constexpr std::string_view kTableEndings[] = {".csv"};
constexpr FileKind kTable{"a table", kTableEndings};

std::string content(const fs::path& file) {
  std::ostringstream out;
  out << std::ifstream(file, std::ios::binary).rdbuf();
  return out.str();
}

Host host_in(const fs::path& folder) {
  HostOptions options;
  options.folder = folder;
  return Host(std::move(options));
}

// Runs a program whose robot is halted from outside at 0.5 s; gives what it printed.
std::string run_halted(const std::string& text, RunResult& result) {
  Engine engine;
  install(engine);
  HostOptions options;
  options.robot = make_robot("scara");
  Host* running = nullptr;
  options.pace = [&running](std::int64_t t_ns) {
    if (t_ns == 500'000'000) running->cell().halt(0);
    return true;
  };
  Host host(std::move(options));
  running = &host;
  CompileOptions compile_options;
  compile_options.host = &host;
  const Compilation compiled = engine.compile(text, "p.rbt", compile_options);
  REQUIRE(compiled.program != nullptr);
  std::string printed;
  VmOptions vm_options;
  vm_options.timeline = &host;
  vm_options.host = &host;
  vm_options.output = [&printed](std::string_view part) { printed += part; };
  Vm vm(compiled.program, std::move(vm_options));
  result = vm.run();
  return printed;
}

}  // namespace

TEST_CASE("a host without a folder writes no files") {
  const Host host((HostOptions()));
  CHECK_FALSE(host.save_file(kTable, "run.csv", "x").ok());
}

TEST_CASE("files are written below the granted folder and nowhere else") {
  const Folder folder("armlet_files_");
  fs::create_directories(folder.path() / "inner" / "deep");
  const Host host = host_in(folder.path() / "inner");
  REQUIRE(host.save_file(kTable, "run.csv", "a,b\n").ok());
  CHECK(content(folder.path() / "inner" / "run.csv") == "a,b\n");
  CHECK(host.save_file(kTable, "deep/../deep/run.csv", "c\n").ok());
  CHECK(content(folder.path() / "inner" / "deep" / "run.csv") == "c\n");
  CHECK(host.save_file(kTable, "run.csv", "d\n").ok());
  CHECK(content(folder.path() / "inner" / "run.csv") == "d\n");
  for (const char* name :
       {"../run.csv", "deep/../../run.csv", "/run.csv", "", ".", "deep", "missing/run.csv"}) {
    CAPTURE(name);
    CHECK_FALSE(host.save_file(kTable, name, "x").ok());
  }
  CHECK_FALSE(fs::exists(folder.path() / "run.csv"));
}

TEST_CASE("a link out of the folder leads nowhere") {
  const Folder folder("armlet_links_");
  fs::create_directories(folder.path() / "inner");
  fs::create_directories(folder.path() / "outer");
  fs::create_directory_symlink(folder.path() / "outer", folder.path() / "inner" / "way");
  const Host host = host_in(folder.path() / "inner");
  CHECK_FALSE(host.save_file(kTable, "way/run.csv", "x").ok());
  CHECK(fs::is_empty(folder.path() / "outer"));
}

TEST_CASE("a link in the granted folder leads nowhere, even if nothing is there yet") {
  const Folder folder("armlet_dangling_");
  fs::create_directories(folder.path() / "inner");
  fs::create_symlink(folder.path() / "made.csv", folder.path() / "inner" / "run.csv");
  const Host host = host_in(folder.path() / "inner");
  const auto saved = host.save_file(kTable, "run.csv", "x");
  REQUIRE_FALSE(saved.ok());
  CHECK(saved.error().message == "it is a link, and links are not followed here");
  CHECK_FALSE(fs::exists(folder.path() / "made.csv"));
  CHECK(host.load_file("run.csv").error().message ==
        "it is a link, and links are not followed here");
  REQUIRE(mkfifo((folder.path() / "inner" / "pipe.csv").c_str(), 0600) == 0);
  CHECK(host.save_file(kTable, "pipe.csv", "x").error().message == "it is a pipe, not a file");
  CHECK(host.load_file("pipe.csv").error().message == "it is a pipe, not a file");
}

TEST_CASE("a function writes only files of its kind") {
  const Folder folder("armlet_kinds_");
  const Host host = host_in(folder.path());
  for (const char* name : {"p.rbt", ".bashrc", "csv", "run.csv.sh", "run.CSV", "run.csv/"}) {
    CAPTURE(name);
    const auto saved = host.save_file(kTable, name, "x");
    REQUIRE_FALSE(saved.ok());
    CHECK(saved.error().message == "a table is a .csv file");
  }
  CHECK_FALSE(host.save_file(kTable, std::string("p.rbt\0.csv", 10), "x").ok());
  CHECK(fs::is_empty(folder.path()));
}

TEST_CASE("a table is saved with a heading and one line for each row") {
  const Folder folder("armlet_tables_");
  Engine engine;
  install(engine);
  SessionOptions options;
  options.robot = make_robot("scara");
  options.folder = folder.path();
  Session session(engine, std::move(options));
  REQUIRE(session.compile(
      "var n = 0\n"
      "setJoints(posJ(0deg, 0deg, 50mm, 0deg))\n"
      "record run every (500ms) { half: now() / 2; n: n; ok: n > 1; text: \"a,b\"; q: joints(); "
      "v: [1.5, n] }\n"
      "wait(0.6s)\n"
      "n = 2\n"
      "wait(0.5s)\n"
      "run.save(\"run.csv\")\n",
      "p.rbt"));
  REQUIRE(session.run().status == Progress::kDone);
  CHECK(content(folder.path() / "run.csv") ==
        "t [s],half [s],n,ok,text,q1 [rad],q2 [rad],q3 [m],q4 [rad],v1,v2\n"
        "0,0,0,false,\"a,b\",0,0,0.05,0,1.5,0\n"
        "0.5,0.25,0,false,\"a,b\",0,0,0.05,0,1.5,0\n"
        "1,0.5,2,true,\"a,b\",0,0,0.05,0,1.5,2\n");
}

TEST_CASE("a move that is halted fails with the kind Halted once the robot stands") {
  const std::string start = "setJoints(posJ(0deg, 0deg, 0mm, 0deg))\n";
  const std::string move = "moveJ(posJ(90deg, 0deg, 0mm, 0deg), time: 1s)\n";
  RunResult result;
  const std::string printed =
      run_halted(start + "try {\n" + move + "print(\"arrived\")\n} catch (e) {\n" +
                     "print(e.kind, e.robot, moving(), joints()[0] > 0.5, joints()[0] < 1.5)\n}\n" +
                     "print(moveJ(home(), time: 1s).reached)\n",
                 result);
  CHECK(result.status == Progress::kDone);
  CHECK(printed == "Halted scara false true true\ntrue\n");
  run_halted(start + move, result);
  REQUIRE(result.error);
  CHECK(result.error->code == "R0618");
}
