// Tables that are written into files and read again.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "temporary_folder.hpp"

using namespace armlet;
namespace fs = std::filesystem;

namespace {

struct Ran {
  std::string printed;
  std::string fault;
};

Ran run(const std::string& program, const fs::path& folder) {
  Ran out;
  SessionOptions options;
  options.folder = folder;
  options.output = [&](std::string_view text) { out.printed += text; };
  options.load = [&](const std::string& path, const std::string&) {
    ImportedText found{.name = path};
    std::ifstream file(folder / path, std::ios::binary);
    if (file) found.text = std::string(std::istreambuf_iterator<char>(file), {});
    return found;
  };
  Session session(library_engine(), options);
  if (!session.compile(program, "tables.rbt")) {
    out.fault = session.problems().front().diagnostic.message;
    return out;
  }
  const RunResult result = session.run();
  if (result.error) out.fault = result.error->message;
  return out;
}

}  // namespace

TEST_CASE("what a table writes is read again as it was, over random tables") {
  const TemporaryFolder place;
  const fs::path& folder = place.path();
  const Ran ran = run(R"(
let pieces = ["a", "\"", ",", ";", "\n", " ", "1.5", "-", "x", "\t", "nan", "1,5"]
fn anyText() -> string {
    var out = ""
    for (i in range(randomInt(5))) out += pieces[randomInt(pieces.length)]
    return out
}
fn anyNumber() -> double {
    let x = (random() - 0.5) * 10.0 ^ (randomInt(30) - 15)
    return randomInt(5) == 0 ? double(randomInt(9)) : x
}
seed(4)
for (k in range(200)) {
    var x = anyNumber()
    var s = anyText()
    var n = randomInt(1000)
    record made every (10ms) { x: x; s: s; n: n }
    for (i in range(randomInt(6))) {
        wait(10ms)
        x = anyNumber()
        s = anyText()
        n = randomInt(1000)
    }
    made.save("made.csv")
    let back = loadTable("made.csv", columns: "t [s], x, s: string, n")
    assert(back.length == made.length)
    for (i in range(made.length)) {
        assert(back.t[i] == made.t[i] && back.x[i] == made.x[i] && back.s[i] == made.s[i])
        assert(back.n[i] == double(made.n[i]))
    }
}
print("done")
)",
                      folder);
  CHECK(ran.fault.empty());
  CHECK(ran.printed == "done\n");
}

TEST_CASE("columns with units without a name of their own are read again as they were") {
  const TemporaryFolder made_here;
  const fs::path folder = made_here.path();
  const Ran ran = run(R"(
record made every (10ms) {
    perTime: 1.0 / (2s) ^ 2
    root: sqrt(2mm)
    spring: 3N / 1mm
    turning: 5Nm * 1s / 1deg
    square: (30deg) ^ 2
    steep: 1.0 / (1mm) ^ 12
}
for (i in range(3)) wait(10ms)
made.save("made.csv")
let back = loadTable("made.csv", columns: "t [s], perTime [1/s^2], root [m^0.5], spring [N/m], turning [Nm*s/rad], square [rad^2], steep [1/m^12]")
for (i in range(made.length)) {
    assert(back.perTime[i] == made.perTime[i] && back.root[i] == made.root[i])
    assert(back.spring[i] == made.spring[i] && back.turning[i] == made.turning[i])
    assert(back.square[i] == made.square[i] && back.steep[i] == made.steep[i])
}
print("done")
)",
                      folder);
  CHECK(ran.fault.empty());
  CHECK(ran.printed == "done\n");
  fs::remove_all(folder);
}

TEST_CASE("the columns of a file are known when the program is checked") {
  const TemporaryFolder place;
  const fs::path& folder = place.path();
  std::ofstream(folder / "m.csv") << "t [s],q [deg]\n0,10\n1,20\n";
  CHECK(run("let m = loadTable(\"m.csv\")\nprint(m.q[1])", folder).printed == "20 deg\n");
  CHECK(run("print(loadTable(\"m.csv\").part)", folder).fault.find("part") != std::string::npos);
  CHECK(run("let x: length = loadTable(\"m.csv\").q[0]", folder).fault.find("angle") !=
        std::string::npos);
}

TEST_CASE("a file that has changed since the check is an error of the run") {
  const TemporaryFolder place;
  const fs::path& folder = place.path();
  std::ofstream(folder / "m.csv") << "x\n1\n";
  SessionOptions options;
  options.folder = folder;
  options.load = [](const std::string& path, const std::string&) {
    return ImportedText{.name = path, .text = "x,y\n1,2\n"};
  };
  Session session(library_engine(), options);
  REQUIRE(session.compile("print(loadTable(\"m.csv\").y[0])", "tables.rbt"));
  const RunResult result = session.run();
  REQUIRE(result.error.has_value());
  CHECK(result.error->message == "`m.csv` cannot be read");
  CHECK(result.error->why.find("its columns are x, and the program was checked with x, y") == 0);
}
