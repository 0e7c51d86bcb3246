// Tables made by `record`, and tables in files (language reference, sections 16 and 19).

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <optional>

#include "armlet/interpreter/host/table_text.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/interpreter/work.hpp"
#include "armlet/stdlib/host.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/number_units.hpp"
#include "values/setting_words.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// A text in a comma-separated file, in quotes if it needs them (RFC 4180) or would be read back as
// a number, as empty or without its blanks.
std::string csv_field(std::string_view text) {
  const bool is_plain = text.find_first_of(",;\t\"\r\n") == std::string_view::npos;
  if (is_plain && !text.empty() && text.front() != ' ' && text.back() != ' ' &&
      !reads_as_number(text))
    return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + '"';
}

// The cells of a value: one cell, or one for each of its numbers.
std::vector<std::string> cells_of(Slot value, const Type& type) {
  std::vector<std::string> cells;
  const auto number = [&](double x) { cells.push_back(fmt::format("{}", x)); };
  if (type.is(Kind::kReal)) {
    number(value.d);
  } else if (type.is(Kind::kInt) || type.is(Kind::kEnum)) {
    cells.push_back(std::to_string(value.i));
  } else if (type.is(Kind::kBool)) {
    cells.emplace_back(value.i != 0 ? "true" : "false");
  } else if (type.is(Kind::kText)) {
    cells.push_back(csv_field(text_value(value)));
  } else if (type.is(Kind::kList)) {
    for (const Slot item : items_value(value)) {
      for (std::string& cell : cells_of(item, *type.element)) cells.push_back(std::move(cell));
    }
  } else if (type.is(Kind::kMatrix)) {
    const MatrixObj& matrix = matrix_value(value);
    for (std::size_t i = 0; i < std::size_t{matrix.rows} * matrix.cols; ++i)
      number(matrix.data()[i]);
  } else if (type.is(Kind::kHost) && type.host == &kPosJ) {
    for (const double q : posj(value).vector()) number(q);
  } else if (type.is(Kind::kHost) && type.host == &kPosC) {
    const Eigen::Isometry3d& T = posc(value).T;
    const Eigen::Quaterniond r(T.linear());
    const double sign = r.w() < 0.0 ? -1.0 : 1.0;
    for (const double x : T.translation()) number(x);
    for (const double x : {r.w(), r.x(), r.y(), r.z()}) number(sign * x);
  } else if (type.is(Kind::kHost) && type.host->text != nullptr) {
    std::string text;
    type.host->text(static_cast<const HostObj*>(value.o)->payload(), text);
    cells.push_back(csv_field(text));
  } else if (type.is(Kind::kRecord) && !type.is_table()) {
    const auto& record = *static_cast<const RecordObj*>(value.o);
    for (std::size_t i = 0; i < type.record->fields.size(); ++i) {
      for (std::string& cell : cells_of(record.fields()[i], *type.record->fields[i].type))
        cells.push_back(std::move(cell));
    }
  } else {
    cells.push_back(type_name(&type));
  }
  return cells;
}

// The number of these cells; may stop counting above `most`.
std::uint64_t cell_count(Slot value, const Type& type, std::uint64_t most) {
  if (type.is(Kind::kMatrix))
    return std::uint64_t{matrix_value(value).rows} * matrix_value(value).cols;
  std::uint64_t count = 0;
  if (type.is(Kind::kList)) {
    for (const Slot item : items_value(value)) {
      count += cell_count(item, *type.element, most);
      if (count > most) return count;
    }
    return count;
  }
  if (type.is(Kind::kRecord) && !type.is_table()) {
    const auto& record = *static_cast<const RecordObj*>(value.o);
    for (std::size_t i = 0; i < type.record->fields.size() && count <= most; ++i)
      count += cell_count(record.fields()[i], *type.record->fields[i].type, most);
    return count;
  }
  return 1;
}

// The units of the cells of a value by its type; empty: the type has none.
std::vector<std::string> units_by_type(Slot value, const Type& type, std::size_t cells) {
  if (type.is(Kind::kHost) && type.host == &kPosJ) {
    std::vector<std::string> units;
    const PosJ& joints = posj(value);
    for (int i = 0; i < joints.n; ++i)
      units.emplace_back(joints.turns[static_cast<std::size_t>(i)] ? "rad" : "m");
    return units;
  }
  if (type.is(Kind::kHost) && type.host == &kPosC) return {"m", "m", "m", "", "", "", ""};
  const Type* number = &type;
  while (number->is(Kind::kList)) number = number->element;
  return number->is_quantity() ? std::vector<std::string>(cells, si_unit(number->dim))
                               : std::vector<std::string>();
}

// "t [s]", "q1 [rad]", "q2 [rad]": the headers of a column with several cells are numbered.
std::string header_of(const std::string& name, std::size_t width,
                      const std::vector<std::string>& units) {
  std::string out;
  for (std::size_t i = 0; i < width; ++i) {
    out += (i > 0 ? "," : "") + name;
    if (width > 1) out += std::to_string(i + 1);
    if (units.size() == width && !units[i].empty()) out += fmt::format(" [{}]", units[i]);
  }
  return out;
}

constexpr FileKind kTable{"a table", kTableEndings};

// Charges a text that is being built for a file: as work, and against the heap limit.
class Growth {
 public:
  explicit Growth(Vm& vm) : vm_(vm) {}
  // The present number of bytes of the text. False: it failed, and the failure is set.
  bool add(std::size_t size) {
    constexpr std::uint64_t kCost = 16;  // of a byte of a number
    constexpr std::size_t kStep = std::size_t{1} << 14U;
    if (size < counted_ + kStep) return true;
    if (!charge_work(vm_, kCost * (size - counted_))) return false;
    // The memory counts twice, since a string doubles its capacity when it is full.
    if (2 * size > (scratch_ ? granted_ : 0)) {
      scratch_.reset();
      granted_ = 4 * size;
      scratch_.emplace(vm_, granted_);
    }
    counted_ = size;
    return scratch_->granted();
  }

 private:
  Vm& vm_;
  std::optional<Scratch> scratch_;
  std::uint64_t granted_ = 0;
  std::size_t counted_ = 0;
};

Answer<void> save(Vm& vm, const RecordObj& table, std::string_view file,
                  std::optional<std::string_view> read) {
  const RecordInfo& info = *table.layout->type->record;
  const std::vector<RecordField>& columns = info.row->record->fields;
  std::vector<std::size_t> widths;
  std::string header;
  std::string body;
  Growth room(vm);
  const auto rows = table_rows(table);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (!room.add(header.size() + body.size())) return Failed{};
    const Slot* fields = static_cast<const RecordObj*>(rows[row].o)->fields();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      constexpr std::uint64_t kMostCells = 100'000;
      if (cell_count(fields[i], *columns[i].type, kMostCells) > kMostCells) {
        return failure(vm, "R0613",
                       fmt::format("the column `{}` has more than {} values in row {}",
                                   columns[i].name, kMostCells, row),
                       at("t"), "that is the limit for a file");
      }
      const std::vector<std::string> cells = cells_of(fields[i], *columns[i].type);
      if (row == 0) {
        widths.push_back(cells.size());
        auto units = units_by_type(fields[i], *columns[i].type, cells.size());
        const std::string_view known = part_of(read.value_or(""), i);
        if (units.empty() && !known.empty())
          units = units_of(known, cells.size(), Host::of(vm).cell());
        header += (i > 0 ? "," : "") + header_of(columns[i].name, cells.size(), units);
      } else if (cells.size() != widths[i]) {
        return failure(vm, "R0613",
                       fmt::format("the column `{}` has {} values in row {} and {} in row 0",
                                   columns[i].name, cells.size(), row, widths[i]),
                       at("t"), "a file has equally long rows");
      }
      for (std::size_t k = 0; k < cells.size(); ++k) body += (i + k > 0 ? "," : "") + cells[k];
    }
    body += '\n';
  }
  if (rows.empty()) {
    for (const RecordField& column : columns) header += (header.empty() ? "" : ",") + column.name;
  }
  const auto saved = Host::of(vm).save_file(kTable, std::string(file), header + '\n' + body);
  if (saved.ok()) return {};
  Failure f;
  f.headline = Headline::own("R0626", fmt::format("`{}` cannot be saved", file));
  f.mark = at("file");
  f.why = saved.error().message;
  return fail(vm, std::move(f));
}

Failed cannot_load(Vm& vm, std::string_view file, std::string why, std::string fix = {}) {
  Failure f;
  f.headline = Headline::own("R0626", fmt::format("`{}` cannot be read", file));
  f.mark = at("file");
  f.why = std::move(why);
  f.fix = std::move(fix);
  return fail(vm, std::move(f));
}

// The SI value of a number with a unit, the same double as that of the literal in a program.
double in_unit(double number, const std::string& unit) {
  const double size = std::abs(number);
  const double si = si_of(fmt::format("{}", size), unit).value_or(size * parse_unit(unit)->factor);
  return std::signbit(number) ? -si : si;
}

// Checks that the columns of the file are those that the program was checked with. A column without
// a unit in the file may have one in the program.
bool take_columns(std::span<const TableColumn> known, TableText& table) {
  if (known.size() != table.columns.size()) return false;
  for (std::size_t i = 0; i < known.size(); ++i) {
    TableColumn& column = table.columns[i];
    if (table.rows == 0 && column.unit.empty()) column.is_text = known[i].is_text;
    const bool gets_unit = column.unit.empty() && !column.is_text;
    if (column.name != known[i].name || column.is_text != known[i].is_text ||
        (column.dim != known[i].dim && !gets_unit)) {
      return false;
    }
    if (!gets_unit || known[i].unit.empty()) continue;
    for (double& number : column.numbers) number = in_unit(number, known[i].unit);
    column.unit = known[i].unit;
    column.dim = known[i].dim;
  }
  return true;
}

Answer<RecordObj*> load_table(Vm& vm, std::string_view file,
                              std::optional<std::string_view> columns) {
  constexpr std::size_t kMostBytes = std::size_t{16} << 20U;
  constexpr std::uint64_t kByteWork = 16;
  const Result<std::string> text = Host::of(vm).load_file(std::string(file), kMostBytes);
  if (!text.ok()) return cannot_load(vm, file, text.error().message);
  const Scratch scratch(vm, 8 * text->size());  // a cell is larger than its text
  if (!scratch.granted() || !charge_work(vm, kByteWork * text->size())) return Failed{};
  Result<TableText> read = read_table_text(*text);
  if (!read.ok()) return cannot_load(vm, file, read.error().message);
  TableText table = std::move(read).value();
  const Result<std::vector<TableColumn>> known = read_columns_text(columns.value_or(""));
  if (!known.ok()) return cannot_load(vm, file, known.error().message);
  const std::string in_file = columns_text(table.columns);
  if (!take_columns(*known, table)) {
    return cannot_load(
        vm, file,
        fmt::format("its columns are {}, and the program was checked with {}", in_file, *columns),
        "run the program again, or correct `columns`");
  }
  return new_table(vm, table);
}

constexpr NativeFunction kTableFunctions[] = {
    def<load_table>(
        "loadTable(file: string, columns: string?) -> table",
        "Reads a file of comma-separated values (.csv). The first line has the names of the "
        "columns, with a unit in brackets if any: q1 [deg]. Which columns there are is found in "
        "the file when the program is checked; of a file that is written later, columns says it, "
        "and gives units to columns that have none in the file. A column whose first cell is a "
        "number has numbers, otherwise texts. Semicolons and tabulators may separate the cells. A "
        "value that is missing is an error with its line and column.",
        "let m = loadTable(\"points.csv\", columns: \"t [s], q1 [deg], part: string\")",
        {.check = check_ending<"file", kTableEndings>}),
    def<save>(
        "save(t: table, file: string, tUnits: units(t)?)",
        "Writes a table into a file of comma-separated values (.csv), in SI units: a line with the "
        "names of "
        "the columns and their units, as `q1 [rad]`, then one line for each row. A list, a posJ "
        "and "
        "a posC become several columns.",
        "record run every (10ms) { q: joints() }; run.save(\"run.csv\")",
        {.check = check_ending<"file", kTableEndings>}),
};

}  // namespace

std::span<const NativeFunction> table_functions() { return kTableFunctions; }

}  // namespace armlet::bind
