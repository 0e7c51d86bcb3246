// Samples of robots reach a backend without memory from the heap.
#include <doctest/doctest.h>

#include "armlet/backend/backend.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/trajectory/joint_move.hpp"
#include "count_allocations.hpp"

using namespace armlet;

namespace {

class Counter : public Backend {
 public:
  explicit Counter(bool wants) : wants_(wants) {}
  void on(const Event& event) override {
    if (std::holds_alternative<JointSample>(event)) ++samples;
  }
  [[nodiscard]] bool wants_link_poses() const override { return wants_; }

  int samples = 0;

 private:
  bool wants_;
};

}  // namespace

TEST_CASE("a sample allocates nothing, with the frames of the links and without") {
  for (const bool wants : {false, true}) {
    CAPTURE(wants);
    Counter counter(wants);
    Cell cell;
    cell.set_backend(&counter);
    cell.add_robot(make_robot("puma560"));
    const PlannerSet planners;
    const CellRobot& arm = cell.robot(0);
    const JointMove move{.q0 = arm.q, .q1 = arm.q.array() + 0.2, .time = 2.0};
    cell.start(0, *plan_joint_move(planners, *arm.model, move).trajectory);
    cell.advance_to(100'000'000);
    const long before = allocations;
    const int had = counter.samples;
    cell.advance_to(1'900'000'000);
    CHECK(allocations == before);
    CHECK(counter.samples == had + 180);
  }
}
