// Files that pages draw, and files that are dropped onto them.

#include "kept_file.hpp"

#include <doctest/doctest.h>

#include <map>

#include "armlet/core/random.hpp"
#include "armlet/mesh/glb.hpp"
#include "lab_support.hpp"
#include "messages/base85.hpp"
#include "runs/shown_files.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

std::string triangle(double size) {
  GlbPart part{.positions = {{0, 0, 0}, {static_cast<float>(size), 0, 0}, {0, 1, 0}},
               .normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
               .corners = {0, 1, 2}};
  GlbScene scene{.materials = {{.name = "grey"}}};
  scene.nodes.push_back({.name = "part", .parts = {part}});
  return write_glb(scene);
}

FileBytes bytes(std::string text) { return std::make_shared<const std::string>(std::move(text)); }

// A folder in which a link, and what else cannot be read, has a name too.
struct Folder {
  std::map<std::string, std::string> files;
  std::string unreadable;

  Result<KeptFile> keep(const std::string& name, const std::string& content) {
    return keep_beside(
        name, content,
        [&](const std::string& each) {
          const auto found = files.find(each);
          if (found == files.end()) return NameInUse{.is_used = each == unreadable};
          return NameInUse{.is_used = true, .bytes = found->second};
        },
        [&](const std::string& each, const std::string& saved) {
          REQUIRE(!files.contains(each));
          files[each] = saved;
          return std::optional<Error>();
        });
  }
};

}  // namespace

TEST_CASE("bytes of all lengths come back from their digits, which end no element and no text") {
  Random random(3);
  for (std::size_t size = 0; size < 200; ++size) {
    std::string given;
    for (std::size_t i = 0; i < size; ++i) given += static_cast<char>(random.next());
    const std::string text = to_base85(given);
    CHECK(from_base85(text) == given);
    CHECK(text.find_first_of("<=\"") == std::string::npos);
    CHECK(text.size() <= size + (size + 3) / 4);
  }
  CHECK(to_base85(std::string(4, '\0')) == "(((((");
  CHECK(from_base85("~~~~~") == std::nullopt);  // more than four bytes hold
  CHECK(from_base85("(") == std::nullopt);
  CHECK(from_base85("((<((") == std::nullopt);
}

TEST_CASE("what a message cannot carry as a text is none") {
  CHECK(is_text("plain, \xC3\xA4, \xE2\x82\xAC, \xF0\x9F\xA4\x96\n"));
  for (const char* each : {"\xC3", "\x80", "\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"})
    CHECK(!is_text(each));
  CHECK(!is_text(std::string_view("a\0b", 3)));
}

TEST_CASE("a file has the name of its bytes, and is kept once and as long as somebody shows it") {
  ShownFiles files;
  FileBytes one = bytes("one"), same = bytes("one"), other = bytes("other");
  const std::string name = files.keep(one);
  CHECK(files.keep(same) == name);
  CHECK(same == one);
  CHECK(files.keep(other) != name);
  CHECK(files.find(name) == one);
  CHECK(files.find("") == nullptr);
  CHECK(files.find("../" + name) == nullptr);
  one.reset();
  CHECK(files.find(name) == same);
  same.reset();
  CHECK(files.find(name) == nullptr);
}

TEST_CASE("a file that is kept replaces no other") {
  Folder folder;
  const std::string first = triangle(1.0), second = triangle(2.0);
  for (int k = 0; k < 2; ++k) {
    const KeptFile kept = folder.keep("part.glb", first).value();
    CHECK(kept.name == "part.glb");
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(kept.size[axis] == doctest::Approx(axis < 2 ? 1.0 : 0.0).epsilon(1e-6));
  }
  folder.unreadable = "part-2.glb";
  CHECK(folder.keep("part.glb", second).value().name == "part-3.glb");
  CHECK(folder.files.at("part.glb") == first);
  CHECK(folder.files.size() == 2);
  CHECK(!folder.keep("part.obj", first).ok());
  CHECK(!folder.keep("part.glb", "nothing").ok());
}

TEST_CASE("a page in control sends a file in pieces; hostile names become plain ones") {
  LaboratoryOptions options = lab_with("moveJ(posJ(20deg, 30deg, 10mm, 0deg), time: 1s)\n");
  std::map<std::string, std::string> kept;
  options.most_kept_bytes = 2 << 20U;
  options.keep_file = [&](const std::string& name, std::string content) {
    kept[name] = std::move(content);
    return Result<KeptFile>({.name = name});
  };
  Laboratory laboratory(std::move(options));
  TestPage page(laboratory), follower(laboratory);
  page.hello();
  follower.hello();
  finish_work(laboratory);
  const auto piece = [](const std::string& name, const std::string& part, bool first, bool last) {
    return TestJson{{"type", "keep"},
                    {"name", name},
                    {"base85", to_base85(part)},
                    {"first", first},
                    {"last", last}};
  };
  CHECK(page.ask(piece("a.glb", "first, ", true, false))["name"] == "");
  CHECK(page.ask(piece("a.glb", "second", false, true))["name"] == "a.glb");
  CHECK(kept.at("a.glb") == "first, second");
  for (const auto& [given, name] : std::map<std::string, std::string>{
           {"../../etc/pass wd.glb", "pass-wd.glb"},
           {"C:\\parts\\\xC3\xA4 b.glb", "b.glb"},
           {"...hidden.glb", "hidden.glb"},
           {std::string(500, 'x') + ".glb", std::string(60, 'x') + ".glb"}})
    CHECK(page.ask(piece(given, "x", true, true))["name"] == name);
  CHECK(page.ask(piece("../..", "x", true, true))["type"] == "error");
  CHECK(page.ask(piece("b.glb", "x", false, true))["type"] == "error");  // has not begun
  CHECK(follower.ask(piece("c.glb", "x", true, true))["reason"] == "control");
  CHECK(!kept.contains("c.glb"));
  // More than a laboratory takes.
  const std::string large(700'000, 'x');
  TestJson answer = TestJson::object();
  for (int i = 0; i < 60 && answer.value("type", "") != "error"; ++i)
    answer = page.ask(piece("large.glb", large, i == 0, false));
  CHECK(answer["reason"] == "limit");
  // The same of all files together.
  int taken = 0;
  for (; taken < 5 && page.ask(piece("own.glb", large, true, true))["type"] == "kept"; ++taken) {
  }
  CHECK(taken == 2);
  CHECK(page.last("error")["reason"] == "limit");
}
