#include "runs/record.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "armlet/stdlib/install.hpp"
#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

TEST_CASE("rows: long lists grow ever more slowly, and never lose what is to be kept") {
  Rows rows(1);
  constexpr std::size_t kAdded = 2'000'000;
  std::size_t seen = 0;
  bool grows = true;
  for (std::size_t i = 0; i < kAdded; ++i) {
    const double value = static_cast<double>(i);
    rows.add({&value, 1}, i % 100'000 == 77);
    grows = grows && rows.count() >= seen;
    seen = rows.count();
  }
  CHECK(grows);
  // 60,000, then as many for every doubling.
  CHECK(rows.count() <= Rows::kMost * 7);
  CHECK(rows.rows(Rows::kMost - 1, 1)[0] == doctest::Approx(Rows::kMost - 1));
  double before = -1.0;
  std::size_t kept = 0;
  for (const double each : rows.rows(0, rows.count())) {
    grows = grows && each > before;
    before = each;
    kept += std::fmod(each, 100'000.0) == 77.0 ? 1 : 0;
  }
  CHECK(grows);
  CHECK(kept == kAdded / 100'000);
}

TEST_CASE("moves to where the robot is count, as the command counts them") {
  const std::string program =
      "moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\n"
      "moveJ(posJ(20deg, 30deg, 10mm, 0deg))\n"
      "moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\n"
      "moveJ(posJ(0deg, 30deg, 10mm, 0deg), time: 1s)\n";
  std::vector<std::string> told;
  SessionOptions plain = lab_with("").session;
  plain.on_move = [&](const FinishedMove& report) { told.push_back(report.function); };
  Session session(library_engine(), plain);
  REQUIRE(session.compile(program, "program.rbt"));
  REQUIRE(session.run().status == Progress::kDone);

  Laboratory laboratory(lab_with(program));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const TestJson moves = page.list("moves", 1);
  REQUIRE(moves.size() == told.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    CHECK(moves[i]["text"].get<std::string>().find(told[i]) != std::string::npos);
    CHECK(moves[i]["span"][0] == static_cast<int>(i) + 1);
  }
  CHECK(moves[1]["t0"] == moves[1]["t1"]);
}

TEST_CASE("a program that never ends keeps its robot, and says at which line it is") {
  LaboratoryOptions options = lab_with(
      "moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\nvar k = 0\nwhile (true) {\n    k += "
      "1\n}\n");
  options.bounds = {.time_ns = 20'000'000'000, .steps = 1'000'000};
  Laboratory laboratory(options);
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  const TestJson run = page.last("run");
  CHECK(run["state"] == "stopped");
  CHECK(run["error"]["severity"] == "advice");
  const int line = run["error"]["span"][0];
  CHECK(line >= 3);
  CHECK(line <= 4);
  CHECK(run["error"]["message"].get<std::string>().find("still running") != std::string::npos);
  CHECK(page.last("description")["robots"].size() == 1);
  const TestJson lines = page.list("statements", 1);
  REQUIRE(!lines.empty());
  CHECK(lines.back()[1] >= 3);
}

TEST_CASE("the runs of one change are one entry of the list") {
  Laboratory laboratory(lab_with("wait(1s)\n"));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  const auto run = [&](const std::string& text, int version, int change) {
    page.ask({{"type", "text"}, {"text", text}, {"version", version}, {"change", change}});
  };
  for (int k = 2; k <= 13; ++k) run("wait(" + std::to_string(k) + "s)\n", k, 5);
  const TestJson runs = page.last("runs")["list"];
  REQUIRE(runs.size() == 2);
  CHECK(runs[1]["label"] == "line 1: wait(13s)");
  CHECK(runs[1]["parent"] == runs[0]["run"]);
  run("wait(14s)\n", 14, 6);
  CHECK(page.last("runs")["list"].size() == 3);
  run("wait(15s)\n", 15, 0);
  run("wait(16s)\n", 16, 0);
  CHECK(page.last("runs")["list"].size() == 5);
  // A question about a run that has been replaced is answered.
  CHECK(page.ask({{"type", "goto"}, {"t", 0.5}, {"run", 3}})["type"] == "error");
}

TEST_CASE("people at pages have names") {
  Laboratory laboratory(lab_with("wait(1s)\n"));
  TestPage teacher(laboratory);
  TestPage student(laboratory);
  teacher.hello();
  student.hello();
  teacher.send({{"type", "name"}, {"name", "Ada"}});
  finish_work(laboratory);
  student.take();
  CHECK(student.last("control")["names"][std::to_string(teacher.number)] == "Ada");
  teacher.send({{"type", "name"}, {"name", ""}});
  student.take();
  CHECK(student.last("control")["names"].empty());
}
