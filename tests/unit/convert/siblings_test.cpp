#include "client/siblings.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "temporary_folder.hpp"

using namespace armlet;
using namespace armlet::mesh;

TEST_CASE("names of other systems are understood, and those that lead out are not") {
  const auto name = [](const char* text) {
    const Result<std::string> read = sibling_name(text);
    return read.ok() ? *read : read.error().code;
  };
  CHECK(name(".\\Tex.jpg") == "Tex.jpg");
  CHECK(name("a\\b//./c.png") == "a/b/c.png");
  CHECK(name("my picture.png") == "my picture.png");
  for (const char* const outside :
       {"..\\x", "a/../../x", "a/..", "/etc/passwd", "\\\\server\\x", "C:\\x", "c:x", "http://h/x",
        "file:x", "file:///etc/passwd", "urn:x"}) {
    CAPTURE(outside);
    CHECK(name(outside) == "outside");
  }
  CHECK(name("") == "name");
  CHECK(name("./") == "name");
  CHECK(name("a\nb") == "name");
  CHECK(name(std::string(2000, 'x').c_str()) == "name");
}

TEST_CASE("a file is found in another case, the first one of several, and never through a link") {
  const TemporaryFolder place;
  namespace fs = std::filesystem;
  const auto write = [&](const std::string& name, const char* text) {
    fs::create_directories((place.path() / name).parent_path());
    std::ofstream(place.path() / name) << text;
  };
  write("mesh/Tex.PNG", "one");
  write("mesh/TEX.png", "two");
  write("mesh/Sub/a b.png", "three");
  write("outside.png", "four");
  fs::create_symlink(place.path() / "outside.png", place.path() / "mesh/link.png");
  fs::create_directory_symlink(place.path(), place.path() / "mesh/up");
  REQUIRE(mkfifo((place.path() / "mesh/pipe.png").c_str(), 0600) == 0);
  const Result<Folder> folder = Folder::open(place.path().string());
  REQUIRE(folder.ok());
  const Siblings siblings(*folder, place.path().string(), "mesh/");
  const auto find = [&](const char* name) { return siblings.find(name, 100); };
  CHECK(find("Tex.PNG").text == "one");
  CHECK(find(".\\tex.png").text == "two");
  CHECK(find("sub\\A%20b.PNG").text == "three");
  CHECK(find("nothing.png").state == Say::kAbsent);
  CHECK(find("../outside.png").state == Say::kOutside);
  CHECK(find("%2e%2e/outside.png").state == Say::kOutside);
  CHECK(find("link.png").state == Say::kUnusable);
  CHECK(find("up/outside.png").state == Say::kUnusable);
  CHECK(find("UP/outside.png").state != Say::kFile);
  CHECK(find("pipe.png").state == Say::kUnusable);
  CHECK(find("Sub").state != Say::kFile);
  CHECK(siblings.find("Tex.PNG", 2).state == Say::kUnusable);
}
