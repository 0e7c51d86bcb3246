// What a cell tells its backend.
#include <doctest/doctest.h>

#include <vector>

#include "armlet/backend/backend.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"

using namespace armlet;

namespace {

struct Heard {
  EventKind kind{};
  std::int64_t t_ns = 0;
  std::uint64_t number = 0;
};

class Listener : public Backend {
 public:
  void on(const Event& event) override {
    heard.push_back({kind_of(event), time_of(event), number_of(event)});
  }
  std::vector<Heard> heard;
};

}  // namespace

TEST_CASE("events are numbered from 0 in the order in which they are told") {
  Cell cell;
  Listener listener;
  cell.set_backend(&listener);
  cell.add_robot(make_robot("scara"));
  cell.note(NoteKind::kOutput, "before the run begins");
  cell.insert({.name = "cube", .shape = Box{{0.04, 0.04, 0.04}}, .mass = 0.2});
  cell.advance_to(5'000'000);
  cell.add_robot(make_robot("puma560"));
  cell.insert({.name = "ball", .shape = Sphere{0.02}, .mass = 0.1});
  cell.take(0, "ball");
  cell.let_go(0);
  cell.remove("cube");
  cell.figure(Figure{.title = "speed"});
  cell.end();
  REQUIRE(listener.heard.size() > 10);
  CHECK(listener.heard.front().kind == EventKind::kBeginRun);
  CHECK(listener.heard.back().kind == EventKind::kEndRun);
  for (std::size_t i = 0; i < listener.heard.size(); ++i) {
    CAPTURE(i);
    CHECK(listener.heard[i].number == i);
    CHECK((i == 0 || listener.heard[i].t_ns >= listener.heard[i - 1].t_ns));
  }
}
