// A `lab` block, and what people do at its page.
#include <doctest/doctest.h>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "armlet/backend/run_hash.hpp"
#include "armlet/core/random.hpp"
#include "armlet/kinematics/forward.hpp"
#include "armlet/kinematics/reach.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "armlet/stdlib/session_log.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

const char* const kLab = R"(
robot arm = robots.scara()
var presses = 0
fn count() { presses = presses + 1; print("pressed", presses, "at", now()) }
fn noisy() -> double { presses = presses + 100; print("read"); return random(0.0, 1.0) }
lab cell {
    title: "Test"
    layout: "stack"
    sliders joints(of: arm, label: "Joints")
    sliders hand(of: arm, as: "x y z roll")
    field clearance(80mm, range: [20mm, 200mm])
    field pieces(3, range: [1, 9])
    field slow(false)
    field word("hello")
    field gain(0.5)
    button go("Go", fn() { count(); arm.moveJ(posJ(20deg, 60deg, 50mm, 0deg), time: 1s) })
    button far("Far", fn() { arm.moveL(xyz(2m, 0mm, 200mm)) })
    button forever("For ever", fn() { while (true) { wait(1s) } })
    plot angles(fn() => arm.joints())
    plot height(fn() => cell.clearance)
    plot chance(fn() => noisy())
    table dh(fn() => arm.dhTable(), header: ["theta", "d", "a", "alpha"])
    text intro("The arm.")
    text where(fn() => f"{cell.pieces} pieces")
    trail way(of: arm)
    torques bars(of: arm)
    program editor()
}
arm.moveJ(posJ(10deg, 20deg, 30mm, 40deg), time: 2s)
print("end", random(0.0, 1.0), presses, cell.clearance)
)";

constexpr std::int64_t kMs = 1'000'000;

struct Lab {
  explicit Lab(const std::string& text = kLab) {
    SessionOptions options = at_the_table();
    options.laboratory = true;
    options.backends = {&hash};
    options.output = [this](std::string_view part) { printed += part; };
    options.on_press = [this](const PressReport& report) { presses.push_back(report); };
    session.emplace(library_engine(), std::move(options));
    const bool compiles = session->compile(text, "lab.rbt");
    for (const Problem& problem : session->problems()) CAPTURE(problem.diagnostic.message);
    REQUIRE(compiles);
  }
  void to(double t) { session->run({.until_ns = static_cast<std::int64_t>(t * 1e9)}); }
  std::string finish() {
    session->run(Budget{});
    session->finish();
    return hash.text();
  }

  RunHash hash;
  std::string printed;
  std::vector<PressReport> presses;
  std::optional<Session> session;
};

std::string code_of(const std::optional<Error>& error) { return error ? error->code : "none"; }
template <class T>
std::string code_of(const Result<T>& result) {
  return result.ok() ? "none" : result.error().code;
}

// A run with a few inputs; what `meanwhile` does between them must not be seen.
template <class F>
std::string run_with_inputs(Lab& lab, F meanwhile) {
  LabControls controls(*lab.session);
  lab.to(0.7);
  CHECK_FALSE(controls.set_field("clearance", Value(30, "mm")));
  meanwhile(controls);
  lab.to(1.0);
  CHECK_FALSE(controls.press("far"));  // the arm is busy
  meanwhile(controls);
  lab.to(3.0);
  CHECK_FALSE(controls.move_joints("arm", Eigen::Vector4d(0.1, 0.2, 0.03, 0.4)));
  meanwhile(controls);
  CHECK_FALSE(controls.press("go"));
  lab.to(3.4);
  meanwhile(controls);
  return lab.finish();
}

}  // namespace

TEST_CASE("a lab block says what stands on its page, in order") {
  Lab lab;
  LabControls controls(*lab.session);
  CHECK(controls.rows() == nullptr);
  CHECK(code_of(controls.set_field("clearance", Value(1, "mm"))) == "ended");
  lab.to(0.0);
  const LabRows* page = controls.rows();
  REQUIRE(page != nullptr);
  CHECK(page->name == "cell");
  CHECK(page->title == "Test");
  CHECK(page->layout == LabLayout::kStack);
  std::string words;
  for (const LabRow& row : page->rows) words += std::string(word_of(row.kind)) + ' ';
  CHECK(words ==
        "sliders sliders field field field field field button button button plot plot plot table "
        "text text trail torques program ");
  CHECK(page->find("joints")->label == "Joints");
  CHECK(page->find("joints")->axes.empty());
  CHECK(page->find("hand")->axes ==
        std::vector{HandAxis::kX, HandAxis::kY, HandAxis::kZ, HandAxis::kTurn});
  CHECK(page->find("hand")->robot == "arm");
  const LabRow& clearance = *page->find("clearance");
  CHECK(clearance.dim == dims::kLength);
  CHECK(clearance.unit == "mm");
  CHECK(clearance.value.in("mm") == doctest::Approx(80));
  CHECK((*clearance.range)[1] == doctest::Approx(0.2));
  CHECK(page->find("pieces")->type == LabFieldType::kInt);
  CHECK(page->find("slow")->type == LabFieldType::kBool);
  CHECK(page->find("word")->value == Value("hello"));
  CHECK(page->find("gain")->unit.empty());
  CHECK(page->find("go")->label == "Go");
  CHECK(page->find("dh")->header.size() == 4);
  CHECK(page->find("intro")->value == Value("The arm."));
  CHECK_FALSE(page->find("intro")->is_read);
  CHECK(page->find("where")->is_read);
}

TEST_CASE("a field takes its own type inside its range, and the program reads it") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.to(0.5);
  CHECK_FALSE(controls.set_field("clearance", Value(20, "mm")));
  CHECK_FALSE(controls.set_field("clearance", Value(0.2, "m")));
  CHECK(code_of(controls.set_field("clearance", Value(201, "mm"))) == "range");
  CHECK(code_of(controls.set_field("clearance", Value(0.1))) == "type");
  CHECK(code_of(controls.set_field("clearance", Value("a"))) == "type");
  CHECK(code_of(controls.set_field("pieces", Value(4.5))) == "type");
  CHECK_FALSE(controls.set_field("pieces", Value(4.0)));
  CHECK(code_of(controls.set_field("pieces", Value(10))) == "range");
  CHECK(code_of(controls.set_field("slow", Value(1))) == "type");
  CHECK_FALSE(controls.set_field("slow", Value(true)));
  CHECK_FALSE(controls.set_field("word", Value("good bye")));
  CHECK(code_of(controls.set_field("gain", Value(std::nan("")))) == "type");
  CHECK(code_of(controls.set_field("nothing", Value(1))) == "unknown");
  CHECK(code_of(controls.set_field("go", Value(1))) == "unknown");
  const auto beyond = controls.set_field("clearance", Value(1, "mm"));
  CHECK(beyond->message == "The field `clearance` goes from 20 mm to 200 mm; 1 mm lies outside.");
  CHECK(controls.field("clearance")->in("mm") == doctest::Approx(200));
  CHECK(*controls.field("pieces") == Value(4));
  CHECK(*controls.read("where") == Value("4 pieces"));
  lab.finish();
  CHECK(lab.printed.ends_with(" 0 200 mm\n"));
}

TEST_CASE("a button starts a task beside the program and after its end; its failure is its own") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.to(0.5);
  CHECK(code_of(controls.press("nothing")) == "unknown");
  CHECK_FALSE(controls.press("go"));  // its move finds the arm busy
  lab.to(0.5);
  REQUIRE(lab.presses.size() == 1);
  REQUIRE(lab.presses[0].failure);
  CHECK(lab.presses[0].button == "go");
  CHECK(lab.presses[0].failure->code == "R0617");
  lab.session->run(Budget{});
  CHECK(lab.session->is_at_rest());
  CHECK(lab.session->host()->now_ns() == 2000 * kMs);
  lab.to(3.25);
  CHECK_FALSE(controls.press("go"));
  CHECK_FALSE(lab.session->is_at_rest());
  lab.session->run(Budget{});
  CHECK(lab.session->is_at_rest());
  CHECK(lab.session->host()->now_ns() == 4250 * kMs);
  REQUIRE(lab.presses.size() == 2);
  CHECK_FALSE(lab.presses[1].failure);
  CHECK(lab.presses[1].start_ns == 3250 * kMs);
  CHECK(lab.presses[1].end_ns == 4250 * kMs);
  CHECK(lab.printed.find("pressed 2 at 3.25 s") != std::string::npos);
  CHECK_FALSE(controls.press("far"));
  lab.session->run(Budget{});
  REQUIRE(lab.presses.size() == 3);
  CHECK(lab.presses[2].failure->code == "R0601");
  lab.finish();
  CHECK(lab.session->result().status == Progress::kDone);
  CHECK(code_of(controls.press("go")) == "ended");
}

TEST_CASE("a button that never ends is stopped, and the laboratory goes on") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.session->run(Budget{});
  CHECK_FALSE(controls.press("forever"));
  CHECK(lab.session->run({.steps = 1000}) == Progress::kPaused);
  CHECK_FALSE(lab.session->is_at_rest());
  lab.session->cancel();
  lab.session->run(Budget{});
  CHECK(lab.session->is_at_rest());
  REQUIRE(lab.presses.size() == 1);
  CHECK(lab.presses[0].failure->code == "R0629");
  CHECK_FALSE(controls.press("go"));
  lab.finish();
  CHECK(lab.presses.size() == 2);
  CHECK_FALSE(lab.presses[1].failure);
}

TEST_CASE("reading leaves no trace in the run") {
  Lab quiet;
  const std::string hash = run_with_inputs(quiet, [](LabControls&) {});
  Lab read;
  CHECK(run_with_inputs(read, [](LabControls& controls) {
          for (const char* row : {"angles", "height", "chance", "dh", "where"})
            CHECK(controls.read(row).ok());
          CHECK(code_of(controls.read("go")) == "unknown");
          CHECK(code_of(controls.read("intro")) == "unknown");
        }) == hash);
  CHECK(read.printed == quiet.printed);
  CHECK(read.printed.find("read") == std::string::npos);
}

TEST_CASE("a plot of joint values reads as numbers with their units") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.session->run(Budget{});
  const Result<Value> angles = controls.read("angles");
  REQUIRE(angles.ok());
  const auto& list = angles->get<Value::List>();
  REQUIRE(list.size() == 4);
  CHECK(list[0].in("deg") == doctest::Approx(10));
  CHECK(list[2].in("mm") == doctest::Approx(30));
  CHECK(controls.read("dh")->get<Value::List>().size() == 4);
}

TEST_CASE("a run with inputs is taken again bit for bit, from its log and from its file") {
  Lab lab;
  const std::string hash = run_with_inputs(lab, [](LabControls&) {});
  const SessionLog log = lab.session->log();
  CHECK(log.laboratory);
  CHECK(log.entries.front().inputs.size() == 4);
  const Result<std::string> file = write_log(log);
  REQUIRE(file.ok());
  const Result<SessionLog> again = read_log(*file);
  REQUIRE(again.ok());
  CHECK(again->entries.front().inputs == log.entries.front().inputs);
  Lab other;
  REQUIRE(other.session->replay(*again));
  CHECK(other.finish() == hash);
  CHECK(other.printed == lab.printed);
}

TEST_CASE("a run with inputs does not depend on how it is cut") {
  Lab lab;
  const std::string hash = run_with_inputs(lab, [](LabControls&) {});
  for (const std::uint64_t steps : {3, 50}) {
    Lab cut;
    REQUIRE(cut.session->replay(lab.session->log()));
    for (int i = 0; i < 100'000 && !cut.session->is_at_rest(); ++i)
      cut.session->run({.steps = steps});
    cut.session->run({.until_ns = lab.session->host()->now_ns()});
    CHECK(cut.finish() == hash);
  }
}

TEST_CASE("a laboratory goes back to a time before an input, and on otherwise") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.to(3.0);
  CHECK_FALSE(controls.press("go"));
  lab.session->run(Budget{});
  CHECK(lab.session->host()->now_ns() == 4000 * kMs);
  REQUIRE(lab.session->go_to(1000 * kMs));
  CHECK(*controls.read("where") == Value("3 pieces"));
  lab.session->run(Budget{});
  CHECK(lab.session->host()->now_ns() == 4000 * kMs);  // as it was
  REQUIRE(lab.session->go_to(2500 * kMs));
  CHECK_FALSE(controls.move_joints("arm", Eigen::Vector4d(0.1, 0.2, 0.03, 0.4)));
  lab.session->run(Budget{});
  CHECK(lab.session->host()->now_ns() == 2500 * kMs);
  CHECK(lab.session->runs().size() == 1);
  CHECK(lab.session->host()->cell().robot(0).q[3] == 0.4);
}

TEST_CASE("sliders of joints move an idle robot inside its limits, and say why not") {
  Lab lab;
  LabControls controls(*lab.session);
  lab.to(1.0);
  const Eigen::Vector4d q(0.1, 0.2, 0.03, 0.4);
  CHECK(controls.move_joints("arm", q)->message ==
        "`arm` is moving; its sliders follow until it stands.");
  lab.session->run(Budget{});
  CHECK_FALSE(controls.move_joints("arm", q));
  CHECK(lab.session->host()->cell().robot(0).q == q);
  CHECK(code_of(controls.move_joints("left", q)) == "unknown");
  CHECK(code_of(controls.move_joints("arm", Eigen::Vector3d(0, 0, 0))) == "type");
  const auto beyond = controls.move_joints("arm", Eigen::Vector4d(0.1, 0.2, 0.3, 0.4));
  CHECK(code_of(beyond) == "range");
  CHECK(beyond->message.find("joint 3 would slide to 300 mm") != std::string::npos);
  CHECK(lab.session->host()->cell().robot(0).q == q);
}

TEST_CASE("sliders of a tool lead where they stand, or say why not") {
  for (const char* name : {"scara", "puma560", "pa10", "planar3"}) {
    CAPTURE(name);
    Lab lab("robot arm = robots." + std::string(name) + "()\n");
    LabControls controls(*lab.session);
    lab.session->run(Budget{});
    const Cell& cell = lab.session->host()->cell();
    const Robot& robot = *cell.robot(0).model;
    const LabRows page = default_lab_rows(cell);
    REQUIRE(page.find("hand of arm") != nullptr);
    const std::size_t axes = page.find("hand of arm")->axes.size();
    CHECK(axes == (robot.n() > 3 ? 4 : 3));
    Random random(7);
    for (int i = 0; i < 20; ++i) {
      Eigen::VectorXd q(robot.n());
      for (int j = 0; j < robot.n(); ++j)
        q[j] = robot.lower()[j] + (robot.upper()[j] - robot.lower()[j]) * random.uniform();
      REQUIRE_FALSE(controls.move_joints("arm", q));
      const std::vector<double> here = *controls.hand("hand of arm");
      // Where it stands it stays, and a position nearby is reached to the micrometre.
      REQUIRE_FALSE(controls.move_hand("hand of arm", here));
      CHECK((cell.robot(0).q - q).norm() < 1e-9);
      std::vector<double> near = here;
      near[0] += 0.002;
      if (axes == 4) near[3] += 0.01;
      if (const auto why = controls.move_hand("hand of arm", near)) {
        CHECK(why->code == "unreachable");
        CHECK(why->message.size() > 20);
        continue;
      }
      const std::vector<double> there = *controls.hand("hand of arm");
      for (std::size_t k = 0; k < axes; ++k)
        CHECK(std::abs(std::remainder(there[k] - near[k], 2 * std::numbers::pi)) < 3e-6);
    }
    const auto far = controls.move_hand("hand of arm", std::vector<double>(axes, 9.0));
    REQUIRE(far);
    CHECK(far->code == "unreachable");
    const auto ranges = controls.hand_ranges("hand of arm");
    REQUIRE(ranges.ok());
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK((*ranges)[k][0] == reach_box(robot).lower[static_cast<Eigen::Index>(k)]);
      CHECK((*ranges)[k][1] == reach_box(robot).upper[static_cast<Eigen::Index>(k)]);
    }
  }
}

TEST_CASE("a tool slider out of reach keeps the arm and shows a pose with the same orientation") {
  Lab lab("robot arm = robots.scara()\n");
  LabControls controls(*lab.session);
  lab.session->run(Budget{});
  const Cell& cell = lab.session->host()->cell();
  const Robot& robot = *cell.robot(0).model;
  REQUIRE_FALSE(controls.move_joints("arm", Eigen::Vector4d(0.2, 0.7, 0.05, 0.3)));
  const Eigen::VectorXd q = cell.robot(0).q;
  const std::vector<double> here = *controls.hand("hand of arm");
  double last = q[3];
  for (int k = 1; k <= 8; ++k) {
    std::vector<double> there = here;
    there[0] += 0.1 * k;
    const bool refused = controls.move_hand("hand of arm", there).has_value();
    const Eigen::VectorXd shown =
        refused ? lab.session->host()->unreached()->q_nearest : cell.robot(0).q;
    CHECK(angle_between(forward(robot, shown), forward(robot, q)) < 1e-6);
    CHECK(std::abs(shown[3] - last) < 1.5);
    last = shown[3];
  }
  REQUIRE(lab.session->host()->unreached() != nullptr);
  CHECK(lab.session->host()->unreached()->distance > 0.1);
}

TEST_CASE("without a lab block there is no page but the default one") {
  Lab lab("robot arm = robots.scara()\n");
  LabControls controls(*lab.session);
  lab.session->run(Budget{});
  CHECK(controls.rows() == nullptr);
  CHECK(code_of(controls.press("go")) == "no lab");
  CHECK(code_of(controls.read("go")) == "no lab");
  CHECK(code_of(controls.hand("joints of arm")) == "unknown");
  CHECK(code_of(controls.hand("hand of arm")) == "none");
}

TEST_CASE("a session that is no laboratory ends with its program") {
  SessionOptions options = at_the_table();
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(kLab, "lab.rbt"));
  session.run({.until_ns = 1000 * kMs});
  LabControls controls(session);
  CHECK(code_of(controls.press("go")) == "failed");
  CHECK_FALSE(controls.set_field("clearance", Value(30, "mm")));
  CHECK(session.run().status == Progress::kDone);
  CHECK_FALSE(session.is_at_rest());
}
