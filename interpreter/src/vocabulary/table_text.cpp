#include "armlet/interpreter/host/table_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "base/utf8.hpp"
#include "base/words.hpp"

namespace armlet {
namespace {

constexpr std::size_t kMostColumns = 1000;

struct Cell {
  std::string text{};
  bool quoted = false;
};

Error refuse(std::string why) { return Error{"table", std::move(why)}; }

bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 40;
  if (text.size() <= kMost) return '`' + std::string(text) + '`';
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return '`' + std::string(text.substr(0, end)) + "...`";
}

// A plain decimal number such as "-2.5e3"; words such as inf are not accepted.
std::optional<double> plain_number(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

// Whether a cell is "nan", "inf" or a similar word that programs write for a missing number.
bool is_no_number(std::string_view text) {
  double value = 0.0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && !std::isfinite(value);
}

// Whether a cell is a number with a decimal comma, such as "1,5" or "-1,5".
bool has_decimal_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || comma + 1 == text.size()) return false;
  std::string with_point(text);
  with_point[comma] = '.';
  return with_point.find(',') == std::string::npos && plain_number(with_point).has_value();
}

// The value of a number with a unit, the same as that of the literal in a program.
std::optional<double> number_in(std::string_view text, const std::string& unit) {
  std::optional<double> plain = plain_number(text);
  if (!plain || unit.empty()) return plain;
  const bool negative = std::signbit(*plain);
  if (text[0] == '-' || text[0] == '+') text.remove_prefix(1);
  const std::optional<double> si = si_of(text, unit);
  if (!si) return std::nullopt;
  return negative ? -*si : *si;
}

// Whether programs can use a column's name after a point: keywords cannot be used there, and
// `table.length` is the count of rows.
bool can_be_column(std::string_view name) {
  return !lang::is_reserved_word(name) && name != "length";
}

// Sets the unit in brackets after the name of a column; `[]`, `[1]` and `[-]` mean no unit. Returns
// false if the unit is not known.
bool take_unit(TableColumn& column, std::string_view said) {
  if (said.empty() || said == "-" || said == "1") return true;
  column.unit = said;
  const auto unit = parse_unit(said);
  if (unit) column.dim = unit->dim;
  return unit.has_value();
}

class TableReader {
 public:
  explicit TableReader(std::string_view text) : text_(text) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    while (!text_.empty() && (text_.back() == '\n' || text_.back() == '\r')) text_.remove_suffix(1);
    text_size_ = text_.size();
  }

  Result<TableText> read() {
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
      return refuse("it is in UTF-16; save it in UTF-8");
    if (const auto byte = lang::broken_byte(text_))
      return refuse("it is no text in UTF-8, from byte " + std::to_string(*byte) + " on");
    if (text_.find('\0') != std::string_view::npos) return refuse("it is no text");
    if (text_.empty()) return refuse("it is empty; its first line has the names of the columns");
    if (!read_header()) return std::move(*error_);
    while (at_ < text_size_) {
      if (!read_row()) return std::move(*error_);
    }
    return std::move(table_);
  }

 private:
  bool fail(std::string why) {
    error_ = refuse(std::move(why));
    return false;
  }
  // Sets the error "line 17, column `q1`: ..."
  bool fail_at(std::size_t column, const std::string& why) {
    return fail("line " + std::to_string(line_) + ", column `" + table_.columns[column].name +
                "`: " + why);
  }

  // The separator of cells: the first separator character in the first line outside of quotes and
  // brackets.
  char separator_of_header() const {
    bool quoted = false;
    bool tab = false;
    for (const char c : text_) {
      if (c == '"') quoted = !quoted;
      if (quoted) continue;
      if (c == '\n' || c == '\r') break;
      if (c == ';') return ';';
      tab = tab || c == '\t';
    }
    return tab ? '\t' : ',';
  }

  bool at_end_of_line() const {
    return at_ >= text_size_ || text_[at_] == '\n' || text_[at_] == '\r';
  }

  // The cells of a row, which has several lines if a text in quotes has.
  bool read_cells(std::vector<Cell>& cells) {
    cells.clear();
    line_ = next_line_;
    while (true) {
      if (!read_cell(cells.emplace_back())) return false;
      if (at_ < text_size_ && text_[at_] == separator_) {
        ++at_;
        continue;
      }
      break;
    }
    if (at_ < text_size_) {
      at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
      ++next_line_;
    }
    return true;
  }

  bool read_cell(Cell& cell) {
    while (at_ < text_size_ && is_blank(text_[at_]) && text_[at_] != separator_) ++at_;
    if (at_ < text_size_ && text_[at_] == '"') return read_quoted(cell);
    const std::size_t begin = at_;
    while (!at_end_of_line() && text_[at_] != separator_) ++at_;
    cell.text = trimmed(text_.substr(begin, at_ - begin));
    return true;
  }

  bool read_quoted(Cell& cell) {
    const std::size_t line = next_line_;
    cell.quoted = true;
    for (++at_; at_ < text_size_; ++at_) {
      const char c = text_[at_];
      if (c == '"' && at_ + 1 < text_size_ && text_[at_ + 1] == '"') {
        ++at_;
      } else if (c == '"') {
        break;
      }
      const bool ends_line = c == '\n' || (c == '\r' && !text_.substr(at_).starts_with("\r\n"));
      if (ends_line) ++next_line_;
      cell.text += c;
    }
    if (at_ >= text_size_)
      return fail("line " + std::to_string(line) + ": a text in quotes has no end");
    ++at_;
    while (at_ < text_size_ && is_blank(text_[at_]) && text_[at_] != separator_) ++at_;
    if (at_end_of_line() || text_[at_] == separator_) return true;
    return fail("line " + std::to_string(next_line_) +
                ": behind a text in quotes a cell ends; quotes inside are written twice");
  }

  bool read_header() {
    separator_ = separator_of_header();
    std::vector<Cell> cells;
    if (!read_cells(cells)) return false;
    if (cells.size() > kMostColumns)
      return fail("it has " + std::to_string(cells.size()) + " columns; at most " +
                  std::to_string(kMostColumns) + " can be read");
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!add_column(cells[i], i)) return false;
    }
    return true;
  }

  bool add_column(const Cell& cell, std::size_t index) {
    const std::string number = std::to_string(index + 1);
    std::string_view said = trimmed(cell.text);
    if (said.empty()) return fail("the first line has no name for column " + number);
    if (!cell.quoted && plain_number(said))
      return fail("the first line has the names of the columns, and column " + number +
                  " begins with the number " + shown(said));
    TableColumn column;
    if (const std::size_t open = said.find('[');
        said.ends_with(']') && open > 0 && open != std::string_view::npos) {
      if (!take_unit(column, trimmed(said.substr(open + 1, said.size() - open - 2))))
        return fail("the unit " + shown(column.unit) + " of column " + number + " is not known");
      said = trimmed(said.substr(0, open));
      has_unit_.push_back(true);
    } else {
      has_unit_.push_back(false);
    }
    column.name = name_of(said);
    const auto same = std::ranges::find(table_.columns, column.name, &TableColumn::name);
    if (same != table_.columns.end())
      return fail("two columns have the name `" + column.name + '`');
    table_.columns.push_back(std::move(column));
    return true;
  }

  // The name of a column as a name that programs can use.
  static std::string name_of(std::string_view said) {
    std::string name;
    for (const char c : said) name += lang::is_word_character(c) ? c : '_';
    if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name.insert(name.begin(), '_');
    if (!can_be_column(name)) name += '_';
    return name;
  }

  bool read_row() {
    std::vector<Cell>& cells = cells_;
    if (!read_cells(cells)) return false;
    const std::size_t n = table_.columns.size();
    if (cells.size() != n) {
      const auto count = [](std::size_t k) {
        return std::to_string(k) + (k == 1 ? " cell" : " cells");
      };
      std::string why = "line " + std::to_string(line_) + " has " + count(cells.size()) +
                        ", and the first line has " + std::to_string(n);
      if (cells.size() == 1 && cells[0].text.empty()) {
        why = "line " + std::to_string(line_) + " is empty";
      } else if (separator_ == ',' && cells.size() == 2 * n) {
        why += "; numbers have a decimal point, not a comma";
      }
      return fail(std::move(why));
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (table_.rows == 0 && !has_unit_[i])
        table_.columns[i].is_text = cells[i].quoted || !reads_as_number(cells[i].text);
      if (!take_cell(i, cells[i])) return false;
    }
    ++table_.rows;
    return true;
  }

  bool take_cell(std::size_t i, Cell& cell) {
    TableColumn& column = table_.columns[i];
    const std::string_view text = cell.quoted ? trimmed(cell.text) : std::string_view(cell.text);
    if (text.empty() && !(cell.quoted && column.is_text)) return fail_at(i, "the value is missing");
    if (column.is_text) {
      column.texts.push_back(std::move(cell.text));
      return true;
    }
    if (!cell.quoted && has_decimal_comma(text)) {
      std::string with_point(text);
      with_point[with_point.find(',')] = '.';
      return fail_at(i, shown(text) + " has a decimal comma; write " + with_point);
    }
    if (is_no_number(text)) return fail_at(i, "the value is missing: " + shown(text));
    const std::optional<double> number = number_in(text, column.unit);
    if (!number && plain_number(text)) return fail_at(i, shown(text) + " is too large");
    if (!number && has_unit_[i]) return fail_at(i, shown(text) + " is not a number");
    if (!number || (cell.quoted && !has_unit_[i]))
      return fail_at(i, shown(text) + (number ? " is in quotes" : " is not a number") +
                            ", and the first cell of the column is a number; texts that look "
                            "like numbers are in quotes");
    column.numbers.push_back(*number);
    return true;
  }

  std::string_view text_;
  std::size_t text_size_ = 0;
  std::size_t at_ = 0;
  std::size_t line_ = 1;       // of the current row
  std::size_t next_line_ = 1;  // counted from 1
  char separator_ = ',';
  std::vector<bool> has_unit_;  // of each column
  std::vector<Cell> cells_;
  TableText table_;
  std::optional<Error> error_;
};

}  // namespace

bool reads_as_number(std::string_view cell) {
  const std::string_view text = trimmed(cell);
  return plain_number(text).has_value() || is_no_number(text) || has_decimal_comma(text);
}

Result<TableText> read_table_text(std::string_view text) { return TableReader(text).read(); }

std::string columns_text(std::span<const TableColumn> columns) {
  std::string out;
  for (const TableColumn& column : columns) {
    if (!out.empty()) out += ", ";
    out += column.name;
    if (column.is_text) out += ": string";
    if (!column.unit.empty()) out += " [" + column.unit + ']';
  }
  return out;
}

Result<std::vector<TableColumn>> read_columns_text(std::string_view text) {
  std::vector<TableColumn> columns;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    std::string_view said = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    TableColumn column;
    if (const std::size_t colon = said.find(':'); colon != std::string_view::npos) {
      if (trimmed(said.substr(colon + 1)) != "string")
        return refuse("behind a colon stands string, not " + shown(said.substr(colon + 1)));
      column.is_text = true;
      said = trimmed(said.substr(0, colon));
    } else if (const std::size_t open = said.find('['); said.ends_with(']')) {
      if (!take_unit(column, trimmed(said.substr(open + 1, said.size() - open - 2))))
        return refuse("the unit " + shown(column.unit) + " is not known");
      said = trimmed(said.substr(0, open));
    }
    column.name = said;
    const bool is_name = !said.empty() && std::ranges::all_of(said, lang::is_word_character) &&
                         (said[0] < '0' || said[0] > '9');
    if (!is_name || !can_be_column(said)) {
      return refuse(shown(said) + " is no name of a column" +
                    (is_name ? "; of a file with this name it is `" + column.name + "_`" : ""));
    }
    if (std::ranges::find(columns, column.name, &TableColumn::name) != columns.end())
      return refuse("two columns have the name " + shown(said));
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace armlet
