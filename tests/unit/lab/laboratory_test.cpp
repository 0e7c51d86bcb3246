// A laboratory spoken to as pages do.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "armlet/backend/recorder.hpp"
#include "armlet/backend/run_hash.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/stdlib/install.hpp"
#include "lab_support.hpp"
#include "temporary_folder.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

const std::string kTwoMoves = R"(let far = 30deg
fn there(k: int) {
    let x = far + k * 10deg
    moveJ(posJ(x, 30deg, 10mm, 0deg), time: 1s)
}
moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)
there(1)
print("done")
)";

}  // namespace

TEST_CASE("a page receives everything of the run that the laboratory has already taken") {
  Laboratory laboratory(lab_with(kTwoMoves));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  CHECK(page.last("welcome")["text"] == kTwoMoves);
  CHECK(page.last("control")["holder"] == page.number);
  CHECK(page.last("diagnostics")["runs"] == true);
  const TestJson run = page.last("run");
  CHECK(run["state"] == "done");
  CHECK(page.last("gap").is_null());

  // The same program without a laboratory.
  SessionOptions plain = lab_with("").session;
  Recorder recorder;
  RunHash hash;
  plain.backends = {&recorder, &hash};
  Session session(library_engine(), plain);
  REQUIRE(session.compile(kTwoMoves, "program.rbt"));
  REQUIRE(session.run().status == Progress::kDone);
  CHECK(run["hash"] == hash.text());
  const std::vector<double>& rows = page.rows[{1, 1, 0}];
  REQUIRE(rows.size() == recorder.joints().size() * 20);
  for (std::size_t i = 0; i < recorder.joints().size(); ++i) {
    const RecordedJoints& sample = recorder.joints()[i];
    CHECK(rows[20 * i] == to_seconds(sample.t_ns));
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(rows[20 * i + 1 + j] == sample.q[j]);
      CHECK(rows[20 * i + 5 + j] == sample.qd[j]);
      CHECK(rows[20 * i + 9 + j] == sample.qdd[j]);
    }
    CHECK(rows[20 * i + 13] == sample.T_world_tool(0, 3));
  }
  const TestJson moves = page.list("moves", 1);
  REQUIRE(moves.size() == 2);
  CHECK(moves[0]["text"] == "moveJ");
  CHECK(moves[0]["span"] == TestJson({6, 0, 6, 47}));
  CHECK(moves[1]["span"][0] == 4);
  CHECK(moves[1]["t0"] == 1.0);
  CHECK(page.list("statements", 1) == TestJson({{0.0, 6}, {1.0, 4}, {run["t_end"], 8}}));
  const TestJson notes = page.list("notes", 1);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0]["kind"] == "output");
  CHECK(notes[0]["text"] == "done\n");
  CHECK(page.last("description")["robots"][0]["shapes"].size() > 8);
}

TEST_CASE(
    "advice of a run is told with its place and its time, in the run and in one made from it") {
  Laboratory laboratory(
      lab_with("object wall { shape: box(20mm, 800mm, 600mm); at: xyz(250mm, 0mm, 300mm) }\n"
               "moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\n"
               "moveJ(posJ(-40deg, 60deg, 50mm, 0deg), time: 1s)\n"));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const TestJson advice = page.list("advice", 1);
  REQUIRE(advice.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(advice[i]["severity"] == "advice");
    CHECK(advice[i]["code"] == "W0711");
    CHECK(advice[i]["span"][0] == 2 + i);
    CHECK(advice[i]["t"] >= double(i));
    CHECK(advice[i]["t"] <= double(i) + 1.0);
  }
  page.ask({{"type", "input"}, {"t", 1.5}, {"joints", "arm"}, {"values", {0.1, 0.2, 0.05, 0.0}}});
  const TestJson shown = page.last("shown");
  if (shown["run"] != 1) CHECK(page.list("advice", shown["run"]).size() >= 2);
}

TEST_CASE("a text with mistakes keeps the last run, and its fix is an edit") {
  Laboratory laboratory(lab_with("wait(1s)\n"));
  TestPage page(laboratory);
  page.hello();
  page.ask({{"type", "text"}, {"text", "wait(1m)\n"}, {"version", 3}});
  const TestJson diagnostics = page.last("diagnostics");
  CHECK(diagnostics["runs"] == false);
  CHECK(diagnostics["text_version"] == 3);
  REQUIRE(diagnostics["items"].size() == 1);
  CHECK(diagnostics["items"][0]["span"] == TestJson({1, 5, 1, 7}));
  CHECK(page.last("shown")["run"] == 1);
  page.ask({{"type", "text"}, {"text", "wait(2s)\n"}, {"version", 4}});
  CHECK(page.last("shown")["run"] == 2);
  CHECK(page.last("run")["t_end"] == 2.0);
  CHECK(page.last("run")["label"] == "line 1: wait(2s)");
  CHECK(page.last("run")["parent"] == 1);
  // Only looked at.
  page.ask({{"type", "text"}, {"text", "wait(3s)\n"}, {"version", 5}, {"run", false}});
  CHECK(page.last("diagnostics")["runs"] == true);
  CHECK(page.last("shown")["run"] == 2);
}

TEST_CASE("instants, steps and breakpoints") {
  Laboratory laboratory(lab_with(kTwoMoves));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const auto value = [](const TestJson& instant, std::string_view name) {
    for (const TestJson& each : instant["variables"]) {
      if (each["name"] == name) return each["value"];
    }
    return TestJson("none");
  };
  TestJson seen = page.ask({{"type", "goto"}, {"t", 1.5}});
  CHECK(seen["t"] == 1.5);
  CHECK(seen["line"] == 4);
  CHECK(seen["cursor"] == true);
  CHECK(value(seen, "x") == "40 deg");
  CHECK(seen["tasks"][0]["calls"] == TestJson({"", "there"}));
  seen = page.ask({{"type", "goto"}, {"t", 0.5}});
  CHECK(seen["line"] == 6);
  CHECK(value(seen, "x") == "none");
  seen = page.ask({{"type", "step"}, {"how", "over"}});
  CHECK(seen["line"] == 7);
  CHECK(seen["t"] == 1.0);
  const TestJson before = seen;
  seen = page.ask({{"type", "step"}, {"how", "into"}});
  CHECK(seen["line"] == 3);
  seen = page.ask({{"type", "step"}, {"how", "out"}});
  CHECK(seen["line"] == 8);
  seen = page.ask({{"type", "step"}, {"how", "back"}});
  CHECK(seen["line"] == 4);
  seen = page.ask({{"type", "step"}, {"how", "back"}});
  seen = page.ask({{"type", "step"}, {"how", "back"}});
  CHECK(seen["line"] == before["line"]);
  CHECK(seen["statements"] == before["statements"]);
  CHECK(seen["variables"] == before["variables"]);
  CHECK(page.ask({{"type", "breakpoints"}, {"lines", {5, 3}}})["lines"] == TestJson({3, 6}));
  page.ask({{"type", "goto"}, {"t", 0.0}});
  seen = page.ask({{"type", "step"}, {"how", "continue"}});
  CHECK(seen["line"] == 3);
  CHECK(seen["at_breakpoint"] == true);
  seen = page.ask({{"type", "step"}, {"how", "continue"}});
  CHECK(seen["ended"] == true);
  CHECK(page.ask({{"type", "goto"}, {"t", 99.0}})["type"] == "error");
  CHECK(page.ask({{"type", "goto"}, {"t", -1.0}})["type"] == "error");
}

TEST_CASE("looking at a run changes nothing of it") {
  Laboratory laboratory(lab_with(kTwoMoves));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const TestJson run = page.last("run");
  const std::size_t rows = page.rows[{1, 1, 0}].size();
  page.ask({{"type", "goto"}, {"t", 0.7}});
  page.ask({{"type", "step"}, {"how", "over"}});
  page.ask({{"type", "fetch"}, {"run", 1}});
  CHECK(page.last("run") == run);
  CHECK(page.rows[{1, 1, 0}].size() == rows);
}

TEST_CASE("runs are compared, and say where they part") {
  Laboratory laboratory(lab_with(kTwoMoves));
  TestPage page(laboratory);
  page.hello();
  std::string other = kTwoMoves;
  other.replace(other.find("k * 10deg"), 9, "k * 20deg");
  finish_work(laboratory);
  page.ask({{"type", "text"}, {"text", other}, {"version", 1}});
  TestJson found = page.ask({{"type", "compare"}, {"run", 1}, {"with", 2}});
  CHECK(found["same"] == false);
  CHECK(found["same_until"] == 1.0);
  CHECK(found["line_with"] == 4);
  CHECK(page.last("run")["parts_at"] == 1.0);
  found = page.ask({{"type", "compare"}, {"run", 2}, {"with", 2}});
  CHECK(found["same"] == true);
}

TEST_CASE("what never ends is ended, and the laboratory goes on") {
  LaboratoryOptions options = lab_with("while (true) { wait(1s) }\n");
  options.bounds = {.time_ns = 20'000'000'000, .steps = 1'000'000};
  Laboratory laboratory(options);
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  CHECK(page.last("run")["state"] == "stopped");
  CHECK(page.last("run")["t_end"] == 20.0);
  CHECK(page.ask({{"type", "goto"}, {"t", 12.5}})["t"] == 12.5);
  for (const char* text : {"var k = 0\nwhile (true) k += 1\n", "while (true) { print(\"x\") }\n",
                           "fn f(k: int) -> int { return f(k + 1) }\nprint(f(0))\n",
                           "int[] a = {}\nwhile (true) { a.push(1) }\n",
                           "every (1ms) { print(\"y\") }\nwait(1000s)\n"}) {
    CAPTURE(text);
    page.ask({{"type", "text"}, {"text", text}, {"version", 1}});
    if (page.last("diagnostics")["runs"] == false) FAIL(page.last("diagnostics").dump());
    CHECK(page.last("run")["state"] != "running");
    CHECK(page.last("run")["state"] != "done");
  }
  page.ask({{"type", "text"}, {"text", "wait(1s)\n"}, {"version", 2}});
  CHECK(page.last("run")["state"] == "done");
}

TEST_CASE("one page is in control, and passes it on") {
  Laboratory laboratory(lab_with("wait(1s)\n"));
  TestPage teacher(laboratory);
  TestPage student(laboratory);
  teacher.hello();
  student.hello();
  CHECK(student.ask({{"type", "text"}, {"text", "wait(2s)\n"}, {"version", 1}})["reason"] ==
        "control");
  CHECK(student.ask({{"type", "goto"}, {"t", 0.5}})["cursor"] == false);
  teacher.ask({{"type", "text"}, {"text", "wait(3s)\n"}, {"version", 1}});
  student.take();
  CHECK(student.last("text")["text"] == "wait(3s)\n");
  CHECK(teacher.last("text").is_null());
  student.send({{"type", "take"}});
  teacher.take();
  CHECK(teacher.last("control")["wishes"] == TestJson({student.number}));
  CHECK(teacher.last("control")["holder"] == teacher.number);
  CHECK(teacher.ask({{"type", "give"}, {"to", 99}})["type"] == "error");
  teacher.send({{"type", "give"}, {"to", student.number}});
  student.ask({{"type", "text"}, {"text", "wait(4s)\n"}, {"version", 2}});
  CHECK(student.last("control")["holder"] == student.number);
  teacher.take();
  CHECK(teacher.last("text")["text"] == "wait(4s)\n");
  laboratory.leave(student.number);
  teacher.take();
  CHECK(teacher.last("control")["holder"].is_null());
  CHECK(teacher.last("control")["pages"] == TestJson({teacher.number}));
  teacher.send({{"type", "take"}});
  teacher.take();
  CHECK(teacher.last("control")["holder"] == teacher.number);
  // Loaded again, before it was noticed that it has gone.
  TestPage guest(laboratory);
  guest.hello();
  TestPage again(laboratory);
  again.send({{"type", "hello"},
              {"protocol", 1},
              {"key", teacher.last("welcome")["key"].get<std::string>()}});
  guest.send({{"type", "take"}});
  guest.take();
  CHECK(guest.last("control")["holder"] == again.number);
  laboratory.leave(teacher.number);
  laboratory.leave(again.number);
  guest.take();
  CHECK(guest.last("control")["holder"] == guest.number);
}

TEST_CASE("a page that comes late, or takes little at a time, receives the same") {
  Laboratory laboratory(lab_with(kTwoMoves));
  TestPage early(laboratory);
  TestPage slow(laboratory);
  early.hello();
  slow.hello();
  finish_work(laboratory);
  early.take();
  slow.take(1);
  TestPage late(laboratory);
  late.hello();
  late.take();
  for (const TestPage* page : {&slow, &late}) {
    CHECK(page->rows == early.rows);
    CHECK(page->last("run") == early.last("run"));
    CHECK(page->last("gap").is_null());
    for (const char* list : {"moves", "statements", "notes", "objects"})
      CHECK(page->list(list, 1) == early.list(list, 1));
  }
}

TEST_CASE("messages that cannot be read are answered, and nothing else happens") {
  Laboratory laboratory(lab_with("wait(1s)\n"));
  TestPage page(laboratory);
  CHECK(page.ask({{"type", "format"}})["message"] == "The first message of a page is \"hello\".");
  page.hello();
  const std::string deep(100'000, '[');
  for (const std::string& message :
       {std::string(), std::string("x"), std::string("[]"), std::string("{}"), deep,
        std::string(R"({"type": 1})"), std::string(R"({"type": "text", "text": 1, "version": 1})"),
        std::string("{\"type\": \"text\", \"text\": \"\xFF\", \"version\": 1}"),
        std::string(R"({"type": "goto", "t": 1e999})"),
        std::string(R"({"type": "goto", "t": "1"})"),
        std::string(R"({"type": "hover", "at": [0, 0]})"),
        std::string(R"({"type": "hover", "at": [1]})"),
        std::string(R"({"type": "hover", "at": [1, 99999999999999999999]})"),
        std::string(R"({"type": "nothing"})"), std::string(R"({"type": "hello", "protocol": 2})"),
        std::string(R"({"type": "inverse", "robot": "scara", "pose": [0,0,0,0,0,0,0]})"),
        std::string(R"({"type": "step", "how": "sideways"})"),
        R"({"type": "text", "version": 1, "text": ")" + std::string(600'000, 'x') + "\"}",
        std::string(1'100'000, ' ')}) {
    CAPTURE(message.substr(0, 60));
    page.told.clear();
    laboratory.receive(page.number, message);
    page.take();
    CHECK(page.last("error")["reason"] == "message");
    CHECK(page.last("error")["message"].get<std::string>().size() > 10);
  }
  for (const TestJson& message :
       {TestJson{{"type", "show"}, {"run", 77}}, TestJson{{"type", "fetch"}, {"run", 77}},
        TestJson{{"type", "compare"}, {"run", 1}, {"with", 77}},
        TestJson{{"type", "goto"}, {"t", 0.0}, {"run", 77}},
        TestJson{{"type", "inverse"}, {"robot", "nobody"}, {"pose", {0, 0, 0, 1, 0, 0, 0}}}})
    CHECK(page.ask(message)["type"] == "error");
  CHECK(page.ask({{"type", "text"}, {"text", "wait(2s)\n"}, {"version", 1}}).is_null());
  CHECK(page.last("run")["t_end"] == 2.0);
}

TEST_CASE("programs write no files, but they think so") {
  const TemporaryFolder place;
  const std::filesystem::path& folder = place.path();
  LaboratoryOptions options = lab_with(R"(record r every (100ms) { k: 1.0 }
wait(1s)
plot([1, 2, 3])
r.save("r.csv")
savePlot("f.svg")
)");
  options.session.folder = folder;
  Laboratory laboratory(options);
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  CAPTURE(page.last("diagnostics").dump());
  CAPTURE(page.last("run").dump());
  CHECK(page.last("run")["state"] == "done");
  CHECK(page.last("figures")["svg"].get<std::string>().starts_with("<svg"));
  CHECK(std::filesystem::is_empty(folder));
}

TEST_CASE("as many runs are kept as fit, and the shown one always") {
  LaboratoryOptions options = lab_with("wait(1s)\n");
  options.most_runs = 3;
  Laboratory laboratory(options);
  TestPage page(laboratory);
  page.hello();
  for (int i = 2; i < 12; ++i) {
    page.ask({{"type", "text"}, {"text", "wait(" + std::to_string(i) + "s)\n"}, {"version", i}});
  }
  CHECK(page.last("runs")["list"].size() == 3);
  page.send({{"type", "show"}, {"run", 9}});
  page.ask({{"type", "text"}, {"text", "wait(40s)\n"}, {"version", 40}});
  page.ask({{"type", "text"}, {"text", "wait(41s)\n"}, {"version", 41}});
  const TestJson list = page.last("runs")["list"];
  CHECK(list.back()["t_end"] == 41.0);
  CHECK(list.size() == 3);
}

TEST_CASE("an exported laboratory has its runs, and the files that they took") {
  LaboratoryOptions options = lab_with(
      "import \"tools/grips.rbt\"\nmoveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\n"
      "print(grips.wide)\nsavePlot(\"own.svg\")\n");
  options.file = "cell.rbt";
  options.session.world = WorldText{"none", ""};
  options.session.load = [](const std::string& path, const std::string& from) {
    ImportedText given;
    if (path == "tools/grips.rbt") given.text = "import \"more.rbt\"\nlet wide = more.two * 2\n";
    if (path == "more.rbt" && from == "/far/away/tools/grips.rbt") given.text = "let two = 2\n";
    given.name = "/far/away/tools/" + path.substr(path.find('/') + 1);
    return given;
  };
  Laboratory laboratory(std::move(options));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  REQUIRE(page.ask({{"type", "input"}, {"t", 0.5}, {"joints", "robot"}, {"values", {0, 0, 0, 0}}})
              .is_object());
  const TestJson told = page.ask({{"type", "export"}});
  REQUIRE(told["type"] == "exported");
  const TestJson& saved = told["laboratory"];
  INFO(saved.dump(2));
  CHECK(saved["file"] == "cell.rbt");
  CHECK(saved["robot"] == "scara");
  CHECK(saved["world"]["name"] == "none");
  CHECK(saved["files"] ==
        TestJson({{"tools/grips.rbt", "import \"more.rbt\"\nlet wide = more.two * 2\n"},
                  {"tools/more.rbt", "let two = 2\n"}}));
  const TestJson& runs = saved["runs"];
  REQUIRE(!runs.empty());
  CHECK(runs[0]["text"] == saved["text"]);
  CHECK(runs[0]["hash"].get<std::string>().size() == 16);
  CHECK(runs[0]["inputs"].empty());
}

TEST_CASE(
    "an exported laboratory has the tables that its program reads, and runs with them alone") {
  const auto reading = [](const TemporaryFolder& place) {
    LaboratoryOptions options = lab_with(
        "let points = loadTable(\"data/points.csv\")\nlet name = \"times of moves\"\n"
        "moveJ(posJ(points.q[1], 30deg, 10mm, 0deg), time: 1s)\n"
        "wait(loadTable(f\"{name}.csv\", columns: \"t [s]\").t[0])\n");
    options.file = "cell.rbt";
    options.session.folder = place.path();
    options.session.load = [&place](const std::string& path, const std::string&) {
      ImportedText given{.name = path};
      std::ifstream file(place.path() / path);
      if (file) given.text = std::string(std::istreambuf_iterator<char>(file), {});
      return given;
    };
    return options;
  };
  const TemporaryFolder place;
  std::filesystem::create_directory(place.path() / "data");
  std::ofstream(place.path() / "data/points.csv") << "q [deg]\n10\n20\n";
  std::ofstream(place.path() / "times of moves.csv") << "t [s]\n0.25\n";
  const auto exported = [&](const TemporaryFolder& from) {
    Laboratory laboratory(reading(from));
    TestPage page(laboratory);
    page.hello();
    finish_work(laboratory);
    return page.ask({{"type", "export"}})["laboratory"];
  };
  const TestJson saved = exported(place);
  INFO(saved.dump(2));
  CHECK(saved["files"] == TestJson({{"data/points.csv", "q [deg]\n10\n20\n"},
                                    {"times of moves.csv", "t [s]\n0.25\n"}}));
  const TemporaryFolder other;
  for (const auto& [path, text] : saved["files"].items()) {
    std::filesystem::create_directories((other.path() / path).parent_path());
    std::ofstream(other.path() / path) << text.get<std::string>();
  }
  const TestJson again = exported(other);
  CHECK(again["runs"][0]["state"] == "done");
  CHECK(again["runs"][0]["hash"] == saved["runs"][0]["hash"]);
}

TEST_CASE("a goal out of reach comes with what is nearest to it") {
  Laboratory laboratory(lab_with(
      "robot arm = robots.scara()\n"
      "lab cell { sliders hand(of: arm, as: \"x y z roll\") }\n"
      "try { arm.moveL(xyz(2m, 0mm, 100mm), speed: 100mm/s) } catch (e) { print(e.message) }\n"
      "wait(1s)\narm.moveL(xyz(5m, 0mm, 100mm), speed: 100mm/s)\n"));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const TestJson error = page.last("run")["error"];
  INFO(error.dump());
  CHECK(error["robot"] == 0);
  CHECK(error["goal"][0] == 5.0);
  CHECK(error["nearest"]["q"].size() == 4);
  CHECK(error["nearest"]["distance"].get<double>() > 4.0);
  CHECK(error["nearest"]["pose"][0].get<double>() < 1.0);

  const TestJson refused =
      page.ask({{"type", "input"}, {"t", 0.5}, {"hand", "hand"}, {"values", {3.0, 0.0, 0.2, 0.0}}});
  INFO(refused.dump());
  CHECK(refused["type"] == "error");
  CHECK(refused["robot"] == 0);
  CHECK(refused["goal"][0] == 3.0);
  CHECK(refused["nearest"]["q"].size() == 4);
  const TestJson unknown =
      page.ask({{"type", "input"}, {"t", 0.5}, {"set", "nothing"}, {"value", 1}});
  CHECK(unknown["type"] == "error");
  CHECK(!unknown.contains("nearest"));
}
