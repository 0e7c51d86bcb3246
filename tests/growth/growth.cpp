// Compiles programs, each part of the work in a function of its own, so that a tool that counts
// instructions by function can show how the work of each part grows.
//
//   growth FILE...     at most kMost files; file number i is worked on by read<i>, check<i>,
//   lower<i>, show<i>, lay_out<i>
#include <malloc.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "armlet/interpreter/format.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/stdlib/install.hpp"
#include "check/check.hpp"
#include "driver/explained_habits.hpp"
#include "driver/load_files.hpp"
#include "driver/vocabulary.hpp"
#include "lower/lower.hpp"

using namespace armlet;
using namespace armlet::lang;

// A function that stays a function of its own, whatever the optimiser sees of it.
#ifdef __clang__
#define APART [[gnu::noinline, clang::optnone]]
#else
#define APART [[gnu::noipa]]
#endif

namespace {

constexpr std::size_t kMost = 256;  // files

struct Work {
  const Engine& engine;
  CompileOptions options;
  CheckedProgram program;
  std::shared_ptr<SourceSet> sources;  // those of `program`, which lowering takes
  DiagnosticSink sink{10};
  Arena tree;
  std::vector<FileTree> files;
  bool well = false;
  std::vector<Diagnostic> problems;
};

template <std::size_t kFile>
APART void read(Work& work) {
  work.files = load_files(*work.sources, work.tree, work.options, work.sink);
}

template <std::size_t kFile>
APART void check(Work& work) {
  work.well =
      check_program(work.files, work.program, work.engine.registry(), work.options, work.sink);
}

template <std::size_t kFile>
APART void lower_all(Work& work) {
  if (work.well && work.files.back().ok) (void)lower(std::move(work.program));
}

template <std::size_t kFile>
APART void explain(Work& work) {
  work.problems = work.sink.take_sorted();
  Trials trials(work.engine.registry(), *work.sources, work.options);
  explain_habits(work.problems, *work.sources, trials);
}

template <std::size_t kFile>
APART void show(Work& work) {
  for (const Diagnostic& problem : work.problems) {
    (void)render_text(problem, *work.sources);
    (void)render_json(problem, *work.sources);
  }
}

template <std::size_t kFile>
APART void lay_out(const std::string& text) {
  (void)format_program(Source("growth.rbt", text));
}

template <std::size_t kFile>
void all(const Engine& engine, Host& host, const std::string& text) {
  Work work{
      .engine = engine, .options = {}, .program = {}, .tree = {}, .files = {}, .problems = {}};
  work.options.host = &host;
  work.sources = std::make_shared<SourceSet>();
  work.sources->add("growth.rbt", text);
  work.program.sources = work.sources;
  read<kFile>(work);
  check<kFile>(work);
  lower_all<kFile>(work);
  explain<kFile>(work);
  show<kFile>(work);
  if (text.starts_with("// fmt")) lay_out<kFile>(text);
}

using All = void (*)(const Engine&, Host&, const std::string&);

template <std::size_t... kFiles>
constexpr std::array<All, kMost> all_of(std::index_sequence<kFiles...>) {
  return {&all<kFiles>...};
}
constexpr std::array<All, kMost> kAll = all_of(std::make_index_sequence<kMost>());

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || static_cast<std::size_t>(argc) > kMost) {
    std::fprintf(stderr, "usage: growth FILE...\n");
    return 64;
  }
  Engine engine;
  install(engine);
  for (int i = 1; i < argc; ++i) {
    std::ifstream file(argv[i], std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    HostOptions options;
    options.robot = make_robot("scara");
    Host host(std::move(options));
#ifdef __GLIBC__
    // What earlier programs freed is joined now: malloc would do it, thousands of pieces at once,
    // in whatever part first asks for much.
    malloc_trim(0);
#endif
    kAll[static_cast<std::size_t>(i)](engine, host, text);
  }
}
