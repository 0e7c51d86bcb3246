// Entries of a session in a cell: what a prompt does.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/random.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

// A session that keeps what it prints.
class Typed {
 public:
  explicit Typed(SessionOptions options = at_the_table())
      : session(library_engine(), listened(std::move(options))) {}

  // What the entry printed and shows, or the code of its message.
  std::string operator()(const std::string& text) {
    printed_.clear();
    if (!session.submit(text, "line"))
      return session.problems().empty() ? "?" : session.problems().front().diagnostic.code;
    const RunResult result = session.run();
    if (result.error) return printed_ + result.error->code;
    const auto shown = session.shown();
    return printed_ + (shown ? shown->text : std::string());
  }
  // All that can be seen of the cell, bit by bit, and the names.
  std::string state() {
    std::ostringstream out;
    const Host* host = session.host();
    if (host == nullptr) return "nothing";
    out << std::hexfloat << host->now_ns() << ' ' << host->move_count();
    const Cell& cell = host->cell();
    for (int i = 0; i < cell.robot_count(); ++i)
      out << '\n' << cell.robot(i).q.transpose() << ' ' << cell.robot(i).held;
    const World& world = cell.world();
    for (std::size_t i = 0; i < world.size(); ++i)
      out << '\n' << world.object(i).name << ' ' << world.object(i).T_world_obj.matrix();
    const auto analysis = session.analyse("", "line");
    for (const Completion& item : analysis->completion(0).items)
      if (item.kind == NameKind::kVariable || item.kind == NameKind::kFunction)
        out << '\n' << item.text << ' ' << item.detail;
    return out.str();
  }

 private:
  SessionOptions listened(SessionOptions options) {
    options.output = [this](std::string_view text) {
      printed_ += text;
      return std::string();
    };
    return options;
  }
  std::string printed_;

 public:
  Session session;
};

// A first lesson, which carries the cube away.
const std::vector<std::string> kLesson = {
    "let p = poseOf(object(\"cube\"))",
    "let safe = above(p, 80mm)",
    "fn up(q: posC) -> posC { return above(q, 90mm) }",
    "moveJ(safe)",
    "moveL(p, speed: 80mm/s)",
    "grasp(object(\"cube\"))",
    "moveL(up(p), speed: 80mm/s)",
    "moveJ(posJ(-20deg, 40deg, 20mm, 0deg), time: 2s)",
    "var n = 3; wait(0.25s)",
};

}  // namespace

TEST_CASE("entries run one after the other in one cell") {
  Typed enter;
  CHECK(enter("now()") == "0 s");
  CHECK(enter("moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)").find("Move") != std::string::npos);
  CHECK(enter("now()") == "1 s");
  CHECK(enter("joints()").find("20 deg") != std::string::npos);
  CHECK(enter("poseOf(object(\"cube\")).z > 0mm") == "true");
}

TEST_CASE("an entry that fails, or does not compile, leaves names, world, robots and clock") {
  Typed enter;
  for (const std::string& text : kLesson) enter(text);
  const std::string before = enter.state();
  for (const char* text : {"nowhere + 1", "moveL(xyz(9m, 0m, 0m), time: 1s)",
                           "n = 8; moveJ(posJ(0deg, 10deg, 0mm, 0deg), time: 1s); [1, 2][n]",
                           "release(); wait(1s); assert(false)",
                           "fn up(q: posC) -> posC { return q }\nlet p = 4; wait(2s); [1][7]"}) {
    CAPTURE(text);
    const std::string said = enter(text);
    CHECK((said.find("E0") != std::string::npos || said.find("R0") != std::string::npos));
    CHECK(enter.state() == before);
  }
  CHECK(enter("n") == "3");
}

TEST_CASE("undo and redo come to the same bits, also of a motion that holds an object") {
  Typed enter;
  std::vector<std::string> states;
  enter("");
  states.push_back(enter.state());
  for (const std::string& text : kLesson) {
    enter(text);
    REQUIRE(enter.session.result().status == Progress::kDone);
    states.push_back(enter.state());
  }
  CHECK(states[7].find("cube") != std::string::npos);
  std::size_t at = kLesson.size();
  Random random(5);
  for (int i = 0; i < 40; ++i) {
    const std::size_t count = random.below(4);
    if (random.below(2) == 0) {
      const std::size_t most = std::min<std::size_t>(count, at);
      CHECK(enter.session.undo(most) == most);
      at -= most;
    } else {
      const std::size_t most = std::min(count, kLesson.size() - at);
      CHECK(enter.session.redo(count) == most);
      at += most;
    }
    CAPTURE(at);
    CHECK(enter.state() == states[at]);
  }
  CHECK(enter.session.undo(100) == at + 1);  // the empty one too
  CHECK(enter.state() == "nothing");
  CHECK(enter.session.redo(100) == kLesson.size() + 1);
  CHECK(enter.state() == states.back());
  // A new entry replaces what was undone.
  enter.session.undo(2);
  CHECK(enter("let q = 5") == "5");
  CHECK(enter.session.redo(1) == 0);
  CHECK(enter("n") == "E0201");
}

TEST_CASE("the same lines in one text come to the same bits") {
  Typed enter;
  std::string text;
  for (const std::string& line : kLesson) {
    enter(line);
    text += line + "\n";
  }
  Session whole(library_engine(), at_the_table());
  REQUIRE(whole.compile(text, "whole.rbt"));
  REQUIRE(whole.run().status == Progress::kDone);
  const Cell& a = enter.session.host()->cell();
  const Cell& b = whole.host()->cell();
  CHECK(a.robot(0).q == b.robot(0).q);
  CHECK(enter.session.host()->now_ns() == whole.host()->now_ns());
  CHECK(a.world().at("cube").T_world_obj.matrix() == b.world().at("cube").T_world_obj.matrix());
}

TEST_CASE("a classic program carries an object when it is entered line by line") {
  Typed enter;
  for (const char* line :
       {"insertObj(\"cube\");", "double[] pick = {0.61, 0.94, 0.11, -0.33};",
        "moveJ('Syn', posJ([0.61, 0.94, 0.02, -0.33]), 2.0);", "moveJ('Syn', new posJ(pick), 1.0);",
        "moveJ('Syn', posJ([0.61, 0.94, 0.02, -0.33]), 1.0);"})
    enter(line);
  CHECK(enter.session.host()->cell().robot(0).held == "cube");
  enter("release()");
  CHECK(enter.session.host()->cell().robot(0).held.empty());
  enter.session.undo(1);
  CHECK(enter.session.host()->cell().robot(0).held == "cube");
}

TEST_CASE("what runs once more is not heard, and writes no files") {
  const auto folder = std::filesystem::temp_directory_path() / "armlet_entries_test";
  std::filesystem::create_directories(folder);
  SessionOptions options = at_the_table();
  options.folder = folder;
  int moves = 0;
  options.on_move = [&](const FinishedMove&) { ++moves; };
  Typed enter(std::move(options));
  CHECK(enter("print(7)") == "7\n");
  enter("moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  enter("plot([1.0, 2.0, 3.0]); savePlot(\"a.svg\")");
  REQUIRE(std::filesystem::exists(folder / "a.svg"));
  std::filesystem::remove(folder / "a.svg");
  CHECK(moves == 1);
  CHECK(enter("let z = 1; [1][5]") == "R0606");
  CHECK(enter.session.undo(1) == 1);
  CHECK(enter.session.redo(1) == 1);
  CHECK_FALSE(std::filesystem::exists(folder / "a.svg"));
  CHECK(moves == 1);
  enter("savePlot(\"b.svg\")");
  CHECK(std::filesystem::exists(folder / "b.svg"));
  std::filesystem::remove_all(folder);
}

TEST_CASE("entries are taken one at a time") {
  SUBCASE("while one is paused") {
    Typed enter;
    REQUIRE(enter.session.submit("wait(1s)", "line"));
    CHECK(enter.session.run({.until_ns = 500'000'000}) == Progress::kPaused);
    CHECK_THROWS_AS(enter.session.submit("1", "line"), ArgumentError);
    CHECK_THROWS_AS(enter.session.undo(), ArgumentError);
    CHECK_THROWS_AS(enter.session.redo(), ArgumentError);
    CHECK(enter.session.run(Budget{}) == Progress::kDone);
    CHECK(enter("now()") == "1 s");
  }
  SUBCASE("once each") {
    Typed enter;
    CHECK(enter("var n = 1; n") == "1");
    CHECK_THROWS_AS((void)enter.session.run(), ArgumentError);
    CHECK_THROWS_AS((void)enter.session.run_test(0), ArgumentError);
    CHECK(enter("n") == "1");
  }
  SUBCASE("in one thread") {
    SessionOptions options = at_the_table();
    int refused = 0;
    Session* session = nullptr;
    options.on_move = [&](const FinishedMove&) {
      for (int i = 0; i < 2; ++i) {
        const auto ask = [&] {
          try {
            i == 0 ? (void)session->submit("1", "line") : (void)session->undo();
          } catch (const ArgumentError&) {
            ++refused;
          }
        };
        ask();
        std::thread(ask).join();
      }
    };
    Typed enter(std::move(options));
    session = &enter.session;
    enter("moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
    CHECK(refused == 4);
    CHECK(enter("now()") == "1 s");
  }
  SUBCASE("until a whole program comes") {
    Typed enter;
    enter("let a = 1");
    REQUIRE(enter.session.compile("print(2)", "whole.rbt"));
    CHECK(enter.session.run().status == Progress::kDone);
    CHECK(enter.session.entries().size() == 1);
    CHECK(enter("a") == "E0201");
  }
}

TEST_CASE("what is cancelled leaves all as it was") {
  SessionOptions options = at_the_table();
  Session* session = nullptr;
  options.pace = [&](std::int64_t t_ns) {
    if (session != nullptr && t_ns > 1'500'000'000) session->cancel();
    return true;
  };
  Typed enter(std::move(options));
  enter("moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)");
  const std::string before = enter.state();
  session = &enter.session;
  enter("moveJ(posJ(0deg, 0deg, 50mm, 0deg), time: 1s); wait(1s); moveJ(home(), time: 3s)");
  CHECK(enter.session.result().status == Progress::kCancelled);
  session = nullptr;
  CHECK(enter.state() == before);
  CHECK(enter("1 + 1") == "2");
}

TEST_CASE("a stop request that comes when nothing is left to stop does not stop the next entry") {
  SessionOptions options = at_the_table();
  Session* session = nullptr;
  options.pace = [&](std::int64_t t_ns) {
    if (session != nullptr && t_ns == 1'000'000'000) std::exchange(session, nullptr)->cancel();
    return true;
  };
  Typed enter(std::move(options));
  session = &enter.session;
  enter("moveJ(home() + [0.1, 0, 0, 0], time: 1s)");  // it ends with the move
  CHECK(session == nullptr);
  CHECK(enter("1 + 1") == "2");
  CHECK(enter("2 + 1") == "3");
}

TEST_CASE("what is written next is offered behind entries") {
  Typed enter;
  enter("let width = 4cm; struct Part { size: length; count: int }; enum Side { left, right }");
  enter(
      "fn widen(by: length) -> length { return width + by }\nlet part = Part(size: 1mm, count: 2)");
  const auto offers = [&](const std::string& text, std::string_view wanted) {
    const auto found =
        enter.session.analyse(text, "line")->completion(static_cast<std::uint32_t>(text.size()));
    for (const Completion& item : found.items)
      if (item.text == wanted) return true;
    return false;
  };
  CHECK(offers("wi", "width"));
  CHECK(offers("let x = w", "widen"));
  CHECK(offers("part.", "size"));
  CHECK(offers("Side.", "right"));
  CHECK(offers("widen(", "by:"));
  CHECK(offers("Part(", "count:"));
  CHECK(offers("moveJ('Sy", "Syn"));
  CHECK_FALSE(offers("wi", "height"));
  const auto analysis = enter.session.analyse("let x = widen(2mm)\nx + width", "line");
  CHECK(analysis->diagnostics().empty());
  CHECK(analysis->hover(9)->text.find("widen(by: length)") != std::string::npos);
  CHECK(analysis->rename(9, "wider").edits.empty());
  CHECK_FALSE(analysis->rename(4, "y").edits.empty());
}

TEST_CASE("a host reads and sets variables of all entries") {
  Typed enter;
  enter("var a = 80mm");
  enter("let b = a * 2\nfn twice(x: double) -> double { return 2 * x }");
  Vm& vm = *enter.session.vm();
  CHECK(vm.global("a").in("mm") == doctest::Approx(80.0));
  CHECK(vm.global("b").in("mm") == doctest::Approx(160.0));
  vm.set("a", 10.0, "mm");
  CHECK(enter("a") == "10 mm");
  CHECK_THROWS_AS(vm.set("b", 1.0, "m"), ArgumentError);
  CHECK_THROWS_AS((void)vm.global("c"), ArgumentError);
}

namespace {

// Numbers follow each other, and time goes on, but where a mark says how far the run went back.
class Follower : public Backend {
 public:
  void on(const Event& event) override {
    CHECK(number_of(event) == next_);
    CHECK(time_of(event) >= last_ns_);
    ++next_;
    last_ns_ = time_of(event);
    if (const auto* mark = std::get_if<Undone>(&event)) {
      marks.push_back(*mark);
      next_ = mark->from;
      last_ns_ = mark->back_ns;
    }
  }
  [[nodiscard]] std::uint64_t next() const { return next_; }

  std::vector<Undone> marks;

 private:
  std::uint64_t next_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace

TEST_CASE("an event says which entries are undone, by a failure or by going back") {
  Follower heard;
  SessionOptions options = at_the_table();
  options.backends = {&heard};
  Typed typed(std::move(options));
  CHECK(typed("print(1)\nmoveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s);") == "1\n");
  const std::uint64_t first = heard.next();
  CHECK(first > 100);
  CHECK(heard.marks.empty());

  CHECK(typed("moveJ(posJ(0deg, 0deg, 50mm, 0deg), time: 1s); [1][5]") == "R0606");
  REQUIRE(heard.marks.size() == 1);
  CHECK(heard.marks[0].from == first);
  CHECK(heard.marks[0].number >= first + 100);
  CHECK(heard.marks[0].t_ns == 2'000'000'000);
  CHECK(heard.marks[0].back_ns == 1'000'000'000);

  CHECK(typed("moveJ(posJ(0deg, 0deg, 50mm, 0deg), time: 1s);") == "");
  const std::uint64_t second = heard.next();
  CHECK(typed.session.undo() == 1);
  REQUIRE(heard.marks.size() == 2);
  CHECK(heard.marks[1].number == second);
  CHECK(heard.marks[1].from == first);
  CHECK(typed.session.redo() == 1);
  REQUIRE(heard.marks.size() == 3);
  CHECK(heard.marks[2].number == first);
  CHECK(heard.marks[2].from == second);
  CHECK(typed("print(2)") == "2\n");
  CHECK(heard.next() == second + 1);
  CHECK(typed.session.undo(3) == 3);
  CHECK(heard.marks.back().from == 0);
  CHECK(heard.marks.back().back_ns == 0);
}
