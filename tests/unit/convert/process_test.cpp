#include "client/process.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "temporary_folder.hpp"

using namespace armlet;
using namespace armlet::mesh;

namespace {

// A converter that is a script of the shell.
struct Script {
  explicit Script(const std::string& text) {
    program = (place.path() / "converter").string();
    std::ofstream(program) << "#!/bin/sh\n" << text << "\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }
  [[nodiscard]] std::string run(std::string_view input = "mesh") const {
    ConverterRun run;
    run.program = program;
    run.arguments = {"obj"};
    run.input = input;
    run.find = [](const std::string& name) { return Sibling{Say::kFile, "file " + name}; };
    run.limits.wall = 1;
    run.limits.result = 1000;
    const Result<std::string> glb = run_converter(run);
    return glb.ok() ? "made " + *glb : glb.error().message;
  }

  TemporaryFolder place;
  std::string program;
};

}  // namespace

TEST_CASE("what the converter says last is what the caller gets") {
  CHECK(Script("printf 'D\\003\\000\\000\\000GLB'").run() == "made GLB");
  CHECK(Script("printf 'E\\007\\000\\000\\000no\\nfile'").run() == "no file");
  CHECK(Script("printf 'E\\002\\000\\000\\000\\377x'").run() == "?x");
}

TEST_CASE("the converter gets the mesh and what it asks for") {
  // Its input, 5 + 4 bytes, then a file of 5 + 6 bytes.
  const Script script(
      "head -c 9 >/dev/null; printf 'W\\001\\000\\000\\000x'; head -c 5 >/dev/null; "
      "printf 'D\\006\\000\\000\\000'; head -c 6");
  CHECK(script.run() == "made file x");
}

TEST_CASE("a converter that goes on for too long is ended, whatever it does") {
  for (const char* const text : {"sleep 1000", "exec 0<&- 1>&-; exec sleep 1000",
                                 "while :; do printf 'S\\001\\000\\000\\000x'; sleep 0.01; done"}) {
    CAPTURE(text);
    const auto start = std::chrono::steady_clock::now();
    const std::string said = Script(text).run();
    const auto took = std::chrono::steady_clock::now() - start;
    const bool told = said.find("took more than 1 s and was ended") != std::string::npos ||
                      said.find("broke down over it (signal 9") != std::string::npos;
    CAPTURE(said);
    CHECK(told);
    CHECK(took < std::chrono::seconds(30));
  }
}

TEST_CASE("the end of a converter is reported") {
  CHECK(Script("kill -SEGV $$").run().find("signal 11") != std::string::npos);
  CHECK(Script("kill -XCPU $$").run().find("60 s of computing") != std::string::npos);
  CHECK(Script("exit 3").run().find("exit status 3") != std::string::npos);
  CHECK(Script("printf 'D\\377\\377\\377\\177'; sleep 1000").run().find("expected 1000 at most") !=
        std::string::npos);
  // It does not read: more than a socket holds.
  CHECK(Script("exit 3").run(std::string(10'000'000, 'x')).find("exit status 3") !=
        std::string::npos);
  CHECK(Script("sleep 1000").run(std::string(10'000'000, 'x')).find("took more than 1 s") !=
        std::string::npos);
}

TEST_CASE("a converter that cannot be started is reported with its path") {
  ConverterRun run;
  run.program = "/nowhere/armlet-mesh";
  const Result<std::string> glb = run_converter(run);
  REQUIRE(!glb.ok());
  CHECK(glb.error().code == "converter");
  CHECK(glb.error().message.find("/nowhere/armlet-mesh cannot be started") != std::string::npos);
}
