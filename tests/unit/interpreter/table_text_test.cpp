#include "armlet/interpreter/host/table_text.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>
#include <vector>

using namespace armlet;

namespace {

std::string fault_of(std::string_view text) {
  const Result<TableText> table = read_table_text(text);
  return table.ok() ? std::string() : table.error().message;
}

std::vector<double> numbers_of(std::string_view text, std::size_t column = 0) {
  const Result<TableText> table = read_table_text(text);
  REQUIRE(table.ok());
  return table->columns[column].numbers;
}

std::string in_quotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

}  // namespace

TEST_CASE("columns have names, units and one kind of cells") {
  const Result<TableText> table = read_table_text("t [s],q1 [deg],part\n0,90,bolt\n1e-1,-90,12\n");
  REQUIRE(table.ok());
  CHECK(table->rows == 2);
  CHECK(columns_text(table->columns) == "t [s], q1 [deg], part: string");
  CHECK(table->columns[1].dim == dims::kAngle);
  CHECK(table->columns[1].numbers ==
        std::vector<double>{parse_quantity("90deg")->si, -parse_quantity("90deg")->si});
  CHECK(table->columns[2].texts == std::vector<std::string>{"bolt", "12"});
  const auto again = read_columns_text(columns_text(table->columns));
  REQUIRE(again.ok());
  CHECK(columns_text(*again) == columns_text(table->columns));
}

TEST_CASE("line ends, byte order marks, separators and blanks do not matter") {
  const std::vector<double> wanted{1.0, 3.0};
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    for (const std::string separator : {",", ";", "\t", " , ", "; "}) {
      for (const std::string mark : {"", "\xEF\xBB\xBF"}) {
        for (const std::string last : {"", "\n", "\r\n\r\n"}) {
          const std::string text = mark + "a" + separator + "b" + end + "1" + separator + "2" +
                                   end + " 3 " + separator + "+4" + last;
          CHECK(numbers_of(text) == wanted);
          CHECK(numbers_of(text, 1) == std::vector<double>{2.0, 4.0});
        }
      }
    }
  }
}

TEST_CASE("numbers in a unit are those of literals, to the last bit") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) {
    const std::string digits =
        std::to_string(random() % 100'000) + "." + std::to_string(random() % 1000);
    for (const std::string unit : {"mm", "deg", "rpm", "km", "mm/s", "N*mm"}) {
      const std::vector<double> read =
          numbers_of("x [" + unit + "]\n" + digits + "\n-" + digits + "\n");
      const double si = parse_quantity(digits + unit)->si;
      CHECK(read == std::vector<double>{si, -si});
    }
  }
}

TEST_CASE("whatever texts there are come back as they were") {
  std::mt19937_64 random(5);
  const std::string pieces[] = {"a", "\"",  ",", ";",        "\n", "\r\n",
                                " ", "1.5", "-", "\xC3\xA4", "\t", ""};
  for (int round = 0; round < 500; ++round) {
    std::vector<std::string> texts(1 + random() % 6);
    std::string file = "n,text\n";
    for (std::size_t i = 0; i < texts.size(); ++i) {
      for (auto k = random() % 6; k > 0; --k) texts[i] += pieces[random() % std::size(pieces)];
      file += std::to_string(i) + ',' + in_quotes(texts[i]) + '\n';
    }
    const Result<TableText> table = read_table_text(file);
    REQUIRE(table.ok());
    CHECK(table->columns[1].texts == texts);
  }
}

TEST_CASE("what is wrong is said with its line and its column") {
  CHECK(fault_of("") == "it is empty; its first line has the names of the columns");
  CHECK(fault_of("a,b\n1,2\n3\n") == "line 3 has 1 cell, and the first line has 2");
  CHECK(fault_of("a,b\n1,2,3\n") == "line 2 has 3 cells, and the first line has 2");
  CHECK(fault_of("a,b\n1,5,2,5\n") ==
        "line 2 has 4 cells, and the first line has 2; numbers have a decimal point, not a comma");
  CHECK(fault_of("a,b\n1,2\n\n3,4\n") == "line 3 is empty");
  CHECK(fault_of("a,b\n1,\n") == "line 2, column `b`: the value is missing");
  CHECK(fault_of("a,b\n1,nan\n") == "line 2, column `b`: the value is missing: `nan`");
  CHECK(fault_of("a;b\n1;x\n2,5;y\n") ==
        "line 3, column `a`: `2,5` has a decimal comma; write 2.5");
  CHECK(fault_of("a;b\n1,5;x\n") == "line 2, column `a`: `1,5` has a decimal comma; write 1.5");
  CHECK(fault_of("a\n\"x\ny\"\n\"z").find("line 4: a text in quotes has no end") == 0);
  CHECK(fault_of("a\n\"x\" y\n").find("line 2: behind a text in quotes a cell ends") == 0);
  CHECK(fault_of("a\n1\nx\n").find("line 3, column `a`: `x` is not a number") == 0);
  CHECK(fault_of("a [m]\nx\n") == "line 2, column `a`: `x` is not a number");
  CHECK(fault_of("a,,c\n1,2,3\n") == "the first line has no name for column 2");
  CHECK(fault_of("1,2\n3,4\n").find("column 1 begins with the number `1`") != std::string::npos);
  CHECK(fault_of("a [parsec]\n1\n") == "the unit `parsec` of column 1 is not known");
  CHECK(fault_of("a,a\n1,2\n") == "two columns have the name `a`");
  CHECK(fault_of("a\n\xFF\n").find("it is no text in UTF-8, from byte 2 on") == 0);
  CHECK(fault_of(std::string_view("\xFF\xFE"
                                  "a\0",
                                  4))
            .find("UTF-16") != std::string::npos);
  CHECK(fault_of("a [mm]\n1e400\n").find("line 2, column `a`") == 0);
}

TEST_CASE("commas in cells of a column of texts are part of the text") {
  const Result<TableText> table = read_table_text("part;code;q\nbolt;a;1\n1,5;2,5;2\n");
  REQUIRE(table.ok());
  CHECK(table->columns[0].texts == std::vector<std::string>{"bolt", "1,5"});
  CHECK(table->columns[1].texts == std::vector<std::string>{"a", "2,5"});
}

TEST_CASE("columns are read back as they were written, whatever their units") {
  std::mt19937_64 random(12);
  for (int round = 0; round < 2'000; ++round) {
    const auto part = [&] {
      return static_cast<std::int8_t>(static_cast<int>(random() % 255) - 127);
    };
    TableColumn column{.name = "x", .dim = {part(), part(), part(), part()}};
    if (round % 2 == 0) {
      for (std::int8_t Dim::*each : {&Dim::length, &Dim::mass, &Dim::time, &Dim::angle})
        column.dim.*each = static_cast<std::int8_t>(column.dim.*each / 40);
    }
    column.unit = si_unit(column.dim);
    const std::string text = columns_text(std::span(&column, 1));
    const Result<std::vector<TableColumn>> said = read_columns_text(text);
    REQUIRE_MESSAGE(said.ok(), text);
    CHECK_MESSAGE((*said)[0].dim == column.dim, text);
    const Result<TableText> table = read_table_text(text + "\n-5.5\n1e-3\n");
    REQUIRE_MESSAGE(table.ok(), text);
    CHECK(table->columns[0].dim == column.dim);
    CHECK(table->columns[0].numbers == std::vector<double>{-5.5, 1e-3});
  }
}

TEST_CASE("names that a program cannot write behind a point are no names of columns") {
  for (const std::string name : {"if", "while", "length", "let"}) {
    CHECK_FALSE(read_columns_text(name).ok());
    const Result<TableText> table = read_table_text(name + "\n1\n");
    REQUIRE(table.ok());
    const std::string columns = columns_text(table->columns);
    CHECK(columns == name + '_');
    CHECK(read_columns_text(columns).ok());
  }
  CHECK(columns_text(*read_columns_text("x [1], y [-], z []")) == "x, y, z");
}

TEST_CASE("no bytes make it fail otherwise") {
  std::mt19937_64 random(11);
  const std::string signs = "a1,;\t\"\n\r[]m.-+e \xC3";
  for (int round = 0; round < 20'000; ++round) {
    std::string text;
    for (auto k = random() % 24; k > 0; --k) text += signs[random() % signs.size()];
    const Result<TableText> table = read_table_text(text);
    if (!table.ok()) {
      CHECK_FALSE(table.error().message.empty());
      continue;
    }
    for (const TableColumn& column : table->columns)
      CHECK(std::max(column.numbers.size(), column.texts.size()) == table->rows);
  }
}
