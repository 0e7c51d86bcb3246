// What a program is reported whose time is too short: the least time suffices as it is written, and
// 1 % less does not.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <vector>

#include "armlet/core/random.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

// The message of a motion that TIME is too short for; empty if it can be made.
std::string refusal(const std::string& before, std::string motion, double time) {
  motion.replace(motion.find("TIME"), 4, fmt::format("{:.17g}s", time));
  std::string printed;
  SessionOptions made = at_the_table();
  made.output = [&printed](std::string_view part) { printed += part; };
  Session session(library_engine(), std::move(made));
  const std::string text =
      before + "\ntry { " + motion + " } catch (e) { print(e.kind, e.message) }";
  REQUIRE_MESSAGE(session.compile(text, "p.rbt"), text);
  REQUIRE_MESSAGE(session.run().status == Progress::kDone, text);
  return printed;
}

void check_least_time(const std::string& before, const std::string& motion) {
  CAPTURE(before);
  CAPTURE(motion);
  const std::string message = refusal(before, motion, 1e-6);
  const std::string words = "it needs at least ";
  const std::size_t at = message.find(words);
  REQUIRE_MESSAGE(at != std::string::npos, message);
  const std::string number = message.substr(at + words.size());
  CAPTURE(number);
  // Three digits and the point, zeros in front and behind.
  std::string digits = number.substr(0, number.find(' '));
  std::erase(digits, '.');
  digits.erase(0, digits.find_first_not_of('0'));
  digits.erase(digits.find_last_not_of('0') + 1);
  CHECK(digits.size() <= 3);
  const double least = std::stod(number);
  CHECK(refusal(before, motion, least) == "");
  CHECK(refusal(before, motion, 0.99 * least).find("TooFast") == 0);
}

// Positions that the arm reaches: its tool is between 0.15 and 0.35 m above the floor.
std::string point(Random& random) {
  return fmt::format("xyz({:.4f}m, {:.4f}m, {:.4f}m)", random.uniform(0.3, 0.4),
                     random.uniform(0.0, 0.2), random.uniform(0.16, 0.34));
}

std::string joints(Random& random) {
  return fmt::format("posJ({:.4f}rad, {:.4f}rad, {:.4f}m, {:.4f}rad)", random.uniform(-1.0, 1.0),
                     random.uniform(0.3, 1.5), random.uniform(0.01, 0.1),
                     random.uniform(-1.0, 1.0));
}

}  // namespace

TEST_CASE("the least time that a message names suffices, and 1 % less does not") {
  Random random(52);
  for (int round = 0; round < 3; ++round) {
    const std::string start = "moveJ(" + point(random) + ")";
    const std::string a = joints(random), b = joints(random), c = joints(random);
    for (const char* planner : {"Syn", "Asyn", "Lin", "Trap", "Cubic", "SCurve", "Septic",
                                "Cycloid", "ModSine", "Seq", "Fastest", "Spline5"}) {
      check_least_time("", fmt::format("moveJ({}, traj: \"{}\", time: TIME)", a, planner));
      const std::string through = fmt::format("[{}, {}, {}]", a, b, c);
      check_least_time("", fmt::format("trajectory(\"{}\", {}, time: TIME)", planner, through));
    }
    check_least_time("", fmt::format("moveJ({}, time: TIME)", point(random)));
    check_least_time(start, fmt::format("moveL({}, time: TIME)", point(random)));
    check_least_time(start, "moveL(here() * xyz(0mm, 1mm, 0mm), time: TIME)");
    check_least_time(
        start,
        "moveCirc(here() * xyz(-30mm, 20mm, 0mm), here() * xyz(0mm, 60mm, 0mm), time: TIME)");
    check_least_time("", fmt::format("trajectory(\"Lin\", [{}, {}, {}], time: TIME)", point(random),
                                     point(random), point(random)));
    for (const char* track : {"slow", "damped"}) {
      check_least_time(start, fmt::format("with (track: \"{}\") {{ moveL({}, time: TIME) }}", track,
                                          point(random)));
    }
    check_least_time(start, fmt::format("path (blend: 20mm, time: TIME) {{ moveL({}); moveL({}) }}",
                                        point(random), point(random)));
  }
}
