// Pictures of cameras that a host gives, and runs with pictures once more.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armlet/backend/run_hash.hpp"
#include "armlet/image/files.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "tape.hpp"

using namespace armlet;

namespace {

const char* const kLooks = R"(
robot arm = robots.ur5()
camera eye { on: arm; at: xyz(z: 60mm); size: [8, 6]; noise: 2.0 }
camera other { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, 900mm)); size: [8, 6] }
for (i in range(3)) {
    wait(200ms)
    print(eye.capture()[2, 3], other.capture()[0, 0])
    wait(200ms)
}
)";

// A host that gives the pictures of `eye`: the number of each as its red.
HostFrames counted(std::vector<std::string>& asked) {
  return {{"eye"}, [&asked](const FrameRequest& frame) -> Result<std::string> {
            asked.push_back(fmt::format("{} {} {} {}x{}", frame.camera, frame.number, frame.t_ns,
                                        frame.width, frame.height));
            Image image(frame.width, frame.height, PixelKind::kRgb);
            for (int y = 0; y < image.height(); ++y)
              for (int x = 0; x < image.width(); ++x)
                image.row(y)[3 * x] = static_cast<std::uint8_t>(10 * frame.number + 1);
            return write_netpbm(image);
          }};
}

struct LookingRun {
  explicit LookingRun(HostFrames frames = {}) {
    SessionOptions options = at_the_table();
    options.frames = std::move(frames);
    options.backends = {&tape};
    options.output = [this](std::string_view text) {
      printed += text;
      return std::string();
    };
    session.emplace(library_engine(), std::move(options));
  }
  Session* operator->() { return &*session; }

  Tape tape;
  std::string printed;
  std::optional<Session> session;
};

// Why a program of one picture of 8 x 6 pixels fails.
std::string failure_with(const std::function<Result<std::string>(const FrameRequest&)>& take) {
  LookingRun run({{"eye"}, take});
  REQUIRE(run->compile("camera eye { at: xyz(z: 1m); size: [8, 6] }\nprint(eye.capture())\n", "p"));
  const RunResult result = run->run();
  REQUIRE(result.error);
  CHECK(result.error->code == "R0686");
  return result.error->message + ": " + result.error->why;
}

}  // namespace

TEST_CASE("a host gives the pictures of one camera, and the others are drawn") {
  std::vector<std::string> asked;
  LookingRun run(counted(asked));
  REQUIRE(run->compile(kLooks, "p.rbt"));
  CHECK(run->run().status == Progress::kDone);
  CHECK(asked == std::vector<std::string>{"eye 0 200000000 8x6", "eye 1 600000000 8x6",
                                          "eye 2 1000000000 8x6"});
  LookingRun drawn;
  REQUIRE(drawn->compile(kLooks, "p.rbt"));
  CHECK(drawn->run().status == Progress::kDone);
  CHECK(run.printed.starts_with("Color(r: 1, g: 0, b: 0) "));
  const auto others = [](const std::string& lines) {
    std::string out;
    for (std::size_t at = 0; at < lines.size(); at = lines.find('\n', at) + 1)
      out +=
          lines.substr(lines.find(") Color", at), lines.find('\n', at) - lines.find(") Color", at));
    return out;
  };
  CHECK(others(run.printed) == others(drawn.printed));
}

TEST_CASE("a run with pictures is the same again from its log, without the host") {
  std::vector<std::string> asked;
  for (const bool given : {false, true}) {
    CAPTURE(given);
    LookingRun first(given ? counted(asked) : HostFrames{});
    REQUIRE(first->compile(kLooks, "p.rbt"));
    CHECK(first->run().status == Progress::kDone);
    const Result<std::string> bytes = write_log(first->log());
    REQUIRE(bytes.ok());
    const Result<SessionLog> log = read_log(*bytes);
    REQUIRE(log.ok());
    CHECK(log->frames == std::vector<std::string>(given ? 1 : 0, "eye"));
    LookingRun second(HostFrames{log->frames, {}});
    REQUIRE(second->replay(*log));
    CHECK(second->run().status == Progress::kDone);
    CHECK(second.printed == first.printed);
    CHECK(second.tape.hashes() == first.tape.hashes());
    // Back to an instant before the second picture, and on from there.
    REQUIRE(second->go_to(500'000'000));
    CHECK(second->run().status == Progress::kDone);
    CHECK(second.tape.hashes() == first.tape.hashes());
    // A session without these cameras is another one.
    if (given) {
      LookingRun third;
      CHECK_THROWS_AS((void)third->replay(*log), ArgumentError);
    }
  }
  CHECK(asked.size() == 3);
}

TEST_CASE("a changed picture is seen when a run is compared with its log") {
  std::vector<std::string> asked;
  LookingRun first(counted(asked));
  REQUIRE(first->compile(kLooks, "p.rbt"));
  CHECK(first->run().status == Progress::kDone);
  SessionLog log = first->log();
  Image other(8, 6, PixelKind::kRgb);
  other.row(0)[0] = 1;  // not at the pixel that the program looks at
  for (Reply& reply : log.entries.front().replies)
    if (reply.question == "frame 1 of eye") reply.text = write_netpbm(other);
  LookingRun second(HostFrames{log.frames, {}});
  REQUIRE(second->replay(log));
  CHECK(second->run().status == Progress::kDone);
  CHECK(second.tape.hashes() != first.tape.hashes());
  CHECK(second.tape.hashes().size() == first.tape.hashes().size());
}

TEST_CASE("pictures of a host that do not fit are refused with what is wrong") {
  const auto of_size = [](int width, int height, PixelKind kind) {
    return [=](const FrameRequest&) -> Result<std::string> {
      return write_netpbm(Image(width, height, kind));
    };
  };
  CHECK(
      failure_with(of_size(6, 8, PixelKind::kRgb)) ==
      "picture 1 for the camera `eye` cannot be taken: the picture is 6 x 8, and the camera takes "
      "8 x 6");
  CHECK(failure_with(of_size(8, 6, PixelKind::kGrey)).find("grey") != std::string::npos);
  CHECK(failure_with([](const FrameRequest&) -> Result<std::string> {
          return std::string("\x89PNG\r\n\x1a\n");
        }).find("picture 1") == 0);
  CHECK(failure_with([](const FrameRequest&) -> Result<std::string> {
          return Error{"frames", "the camera is switched off"};
        }).ends_with("the camera is switched off"));
  CHECK(failure_with(nullptr).find("log") != std::string::npos);
}

TEST_CASE("rows of a page that take pictures are read without a trace in the run") {
  const char* const kPage = R"(
camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, 900mm)); size: [8, 6]; noise: 30.0 }
lab page { text seen(fn() => f"{eye.capture()[2, 3].r} {eye.capture()[2, 3].r}") }
for (i in range(4)) { print(eye.capture()[2, 3]); wait(100ms) }
)";
  std::string printed[2];
  std::string hashes[2];
  for (const bool is_read : {false, true}) {
    RunHash hash;
    SessionOptions options = at_the_table();
    options.laboratory = true;
    options.backends = {&hash};
    options.output = [&](std::string_view text) {
      printed[is_read ? 1 : 0] += text;
      return std::string();
    };
    Session session(library_engine(), std::move(options));
    REQUIRE(session.compile(kPage, "page.rbt"));
    for (int k = 1; k < 4; ++k) {
      session.run({.until_ns = k * 100'000'000 - 50'000'000});
      if (!is_read) continue;
      const Result<Value> seen = LabControls(session).read("seen");
      REQUIRE(seen.ok());
      // Both calls of the row see what the program would see next.
      const auto text = seen->get<std::string>();
      CHECK(text.substr(0, text.find(' ')) == text.substr(text.find(' ') + 1));
    }
    session.run(Budget{});
    session.finish();
    hashes[is_read ? 1 : 0] = hash.text();
  }
  CHECK(printed[0] == printed[1]);
  CHECK(hashes[0] == hashes[1]);
}
