#include "vocabulary/table_files.hpp"

#include <doctest/doctest.h>

using namespace armlet;

namespace {

// Files of which one is a table, which counts what it is asked.
struct OneTable {
  std::string text = "t [s],part\n0,bolt\n";
  int asked = 0;
  ModuleLoader load = [this](const std::string& path, const std::string&) {
    ++asked;
    return path == "a.csv" ? ImportedText{.name = path, .text = text}
                           : ImportedText{.why = "there is no such file"};
  };
};

}  // namespace

TEST_CASE("a table is asked for and read once for all checks of a text") {
  OneTable folder;
  TableFiles tables;
  const TableFile& first = tables.find(folder.load, "a.csv", "cell.rbt");
  REQUIRE(first.columns.ok());
  CHECK(columns_text(first.columns.value()) == "t [s], part: string");
  CHECK(first.columns.value()[0].numbers.empty());
  CHECK(&tables.find(folder.load, "a.csv", "cell.rbt") == &first);
  CHECK(folder.asked == 1);
  CHECK(tables.find(folder.load, "b.csv", "cell.rbt").found.why == "there is no such file");
  tables.find(folder.load, "b.csv", "cell.rbt");
  CHECK(folder.asked == 2);
}

TEST_CASE("for a text that is much alike a table is read again only if its text has changed") {
  OneTable folder;
  TableFiles before;
  const TableFile& first = before.find(folder.load, "a.csv", "cell.rbt");
  TableFiles same(&before);
  CHECK(&same.find(folder.load, "a.csv", "cell.rbt") == &first);
  CHECK(folder.asked == 2);
  folder.text = "t [s],part [mm]\n0,1\n";
  TableFiles other(&same);
  const TableFile& changed = other.find(folder.load, "a.csv", "cell.rbt");
  CHECK(&changed != &first);
  REQUIRE(changed.columns.ok());
  CHECK(columns_text(changed.columns.value()) == "t [s], part [mm]");
  folder.text = "t [s]\nx\n";
  TableFiles wrong(&other);
  CHECK_FALSE(wrong.find(folder.load, "a.csv", "cell.rbt").columns.ok());
}
