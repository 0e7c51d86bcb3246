#include "format_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "armlet/interpreter/work.hpp"

namespace armlet::lang {

namespace {

constexpr int kMostDigits = 15;
constexpr int kMostLevels = 200;

// Significant digits without trailing zeros, and the decimal exponent of the first one.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

Decimal read_scientific(std::string_view text) {
  const std::size_t e = text.find('e');
  Decimal out;
  for (const char c : text.substr(0, e)) {
    if (c != '.') out.digits += c;
  }
  while (out.digits.size() > 1 && out.digits.back() == '0') out.digits.pop_back();
  const std::string_view exponent = text.substr(e + (text[e + 1] == '+' ? 2 : 1));
  std::from_chars(exponent.data(), exponent.data() + exponent.size(), out.exponent);
  return out;
}

// value: finite, > 0.
Decimal decimal_of(double value) {
  char buffer[64];
  auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  Decimal shortest = read_scientific({buffer, static_cast<std::size_t>(end - buffer)});
  if (shortest.digits.size() <= kMostDigits) return shortest;
  end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific,
                      kMostDigits - 1)
            .ptr;
  return read_scientific({buffer, static_cast<std::size_t>(end - buffer)});
}

std::string with_exponent(const Decimal& d) {
  std::string out = d.digits.substr(0, 1);
  if (d.digits.size() > 1) out += '.' + d.digits.substr(1);
  const int size = std::abs(d.exponent);
  out += d.exponent < 0 ? "e-" : "e+";
  if (size < 10) out += '0';
  return out + std::to_string(size);
}

// The text, and whether it has neither point nor exponent.
std::string plain_number(double value, bool& is_whole) {
  is_whole = false;
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  is_whole = value == 0.0;
  if (is_whole) return "0";
  const Decimal d = decimal_of(std::abs(value));
  const std::string sign = value < 0 ? "-" : "";
  if (d.exponent < -4 || d.exponent >= kMostDigits) return sign + with_exponent(d);
  if (d.exponent < 0)
    return sign + "0." + std::string(static_cast<std::size_t>(-d.exponent - 1), '0') + d.digits;
  const auto before = static_cast<std::size_t>(d.exponent) + 1;
  is_whole = d.digits.size() <= before;
  if (is_whole) return sign + d.digits + std::string(before - d.digits.size(), '0');
  return sign + d.digits.substr(0, before) + '.' + d.digits.substr(before);
}

// With a number of digits; "-0.00" is written "0.00".
std::string styled_number(double value, int digits, char style) {
  if (!std::isfinite(value)) return bare_number_text(value);
  const auto format = style == 'e'   ? std::chars_format::scientific
                      : style == 'g' ? std::chars_format::general
                                     : std::chars_format::fixed;
  char buffer[512];
  const int places = digits < 0 ? 6 : digits;
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, format, places).ptr;
  const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  const bool is_zero =
      text.substr(0, text.find('e')).find_first_of("123456789") == std::string_view::npos;
  return std::string(text.substr(is_zero && text.starts_with('-') ? 1 : 0));
}

class Writer {
 public:
  // is_shown: the value is what the program shows, not a part of a message.
  Writer(const Format& format, std::size_t limit, bool is_shown)
      : format_(format), limit_(limit), is_shown_(is_shown) {}
  Writer(const Format& format, Vm& vm, TextMaker& text) : format_(format), vm_(&vm), text_(&text) {}

  void value(Slot s, const Type& type);
  // What has been written since the last time goes into the text. False: no more can be written.
  bool flush();
  std::string out;

 private:
  [[nodiscard]] bool is_plain() const {
    return format_.digits < 0 && format_.style == 0 && format_.unit.empty();
  }
  void real(double value, Dim dim);
  void text(std::string_view text);
  void list(const ListObj& list, const Type& element);
  void table(Slot s, const RecordInfo& info);
  void record(const RecordObj& record, const RecordInfo& info);
  void matrix(const MatrixObj& matrix);
  void reference(Slot s, const Type& type);

  // Whether more is wanted.
  bool goes_on() {
    if (text_ == nullptr) return out.size() <= limit_;
    return !failed_ && (out.size() < kPiece || flush());
  }

  static constexpr std::size_t kPiece = std::size_t{1} << 15U;

  const Format& format_;
  std::size_t limit_ = kNoLimit;
  bool is_shown_ = true;
  Vm* vm_ = nullptr;
  TextMaker* text_ = nullptr;
  bool failed_ = false;
  int level_ = 0;
};

bool Writer::flush() {
  constexpr std::uint64_t kCost = 8;  // of a byte of a number
  failed_ = failed_ || !charge_work(*vm_, kCost * out.size()) || !text_->add(out);
  out.clear();
  return !failed_;
}

void Writer::real(double value, Dim dim) {
  const bool styled = format_.digits >= 0 || format_.style != 0;
  if (!format_.unit.empty()) {
    const double number = value / format_.factor;
    out += styled ? styled_number(number, format_.digits, format_.style) : bare_number_text(number);
    out += ' ';
    out += format_.unit;
    return;
  }
  if (dim.is_none()) {
    out += styled ? styled_number(value, format_.digits, format_.style) : number_text(value);
    return;
  }
  const DisplayUnit unit = display_unit(dim, value);
  const double number = value / unit.factor;
  out += styled ? styled_number(number, format_.digits, format_.style) : bare_number_text(number);
  if (!unit.name.empty()) out += ' ' + unit.name;
}

void Writer::text(std::string_view text) {
  if (level_ == 0) {
    if (text_ == nullptr) {
      out += text;
    } else {
      failed_ = !flush() || !text_->add(text);
    }
    return;
  }
  out += '"';
  for (const char c : text) {
    if (!goes_on()) return;
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n') {
      out += "\\n";
    } else {
      out += c;
    }
  }
  out += '"';
}

void Writer::list(const ListObj& list, const Type& element) {
  out += '[';
  for (std::uint32_t i = 0; i < list.size && goes_on(); ++i) {
    if (i > 0) out += ", ";
    value(list.data[i], element);
  }
  out += ']';
}

void Writer::record(const RecordObj& record, const RecordInfo& info) {
  out += info.name;
  out += '(';
  for (std::size_t i = 0; i < info.fields.size() && goes_on(); ++i) {
    if (i > 0) out += ", ";
    out += info.fields[i].name;
    out += ": ";
    value(record.fields()[i], *info.fields[i].type);
  }
  out += ')';
}

// table(t, q, tau; 101 rows)
void Writer::table(Slot s, const RecordInfo& info) {
  out += info.name;
  for (std::size_t i = 0; i < info.fields.size(); ++i) {
    out += i == 0 ? "(" : ", ";
    out += info.fields[i].name;
  }
  const std::size_t rows = table_rows(s).size();
  out += "; " + std::to_string(rows) + (rows == 1 ? " row)" : " rows)");
}

void Writer::matrix(const MatrixObj& matrix) {
  out += '[';
  const std::size_t count = std::size_t{matrix.rows} * matrix.cols;
  for (std::size_t i = 0; i < count && goes_on(); ++i) {
    if (i > 0) out += i % matrix.cols == 0 ? "; " : ", ";
    real(matrix.data()[i], dims::kNone);
  }
  if (matrix.rows == 1 && count > 0) out += ';';  // read back, it is a matrix again
  out += ']';
}

void Writer::reference(Slot s, const Type& type) {
  if (s.o == nullptr) return;  // an argument that was left out
  if (type.is(Kind::kText)) return text(static_cast<TextObj*>(s.o)->view());
  if (level_ >= kMostLevels) {
    out += "...";
    return;
  }
  ++level_;
  if (type.is(Kind::kList)) list(*static_cast<ListObj*>(s.o), *type.element);
  if (type.is_table()) {
    table(s, *type.record);
  } else if (type.is(Kind::kRecord)) {
    record(*static_cast<RecordObj*>(s.o), *type.record);
  }
  if (type.is(Kind::kMatrix)) matrix(*static_cast<MatrixObj*>(s.o));
  if (type.is(Kind::kFunction)) out += type_name(&type);
  if (type.is(Kind::kHost)) {
    const auto* host = static_cast<HostObj*>(s.o);
    if (host->type->text != nullptr) {
      const std::size_t begin = out.size();
      host->type->text(host->payload(), out);
      // Only a value that the program shows by itself has room for more than a line.
      if (!is_shown_ || level_ > 1) out.resize(std::min(out.find('\n', begin), out.size()));
    } else {
      out += host->type->name;
    }
  }
  --level_;
}

void Writer::value(Slot s, const Type& type) {
  switch (type.kind) {
    case Kind::kBool:
      out += s.i != 0 ? "true" : "false";
      break;
    case Kind::kInt:
      if (is_plain()) {
        out += std::to_string(s.i);
      } else {
        real(static_cast<double>(s.i), dims::kNone);
      }
      break;
    case Kind::kReal:
      real(s.d, type.dim);
      break;
    case Kind::kEnum:
      out += type.enumeration->name + '.' + type.enumeration->values[static_cast<std::size_t>(s.i)];
      break;
    default:
      if (type.is_reference()) reference(s, type);
  }
}

}  // namespace

std::string number_text(double value) {
  bool is_whole = false;
  std::string text = plain_number(value, is_whole);
  return is_whole ? text + ".0" : text;
}

std::string bare_number_text(double value) {
  bool is_whole = false;
  return plain_number(value, is_whole);
}

std::string quantity_text(double si, Dim dim) {
  const DisplayUnit unit = display_unit(dim, si);
  return bare_number_text(si / unit.factor) + (unit.name.empty() ? "" : " " + unit.name);
}

std::string value_text(Slot value, const Type& type, std::size_t limit) {
  const Format plain{&type, -1, 0, {}, 1.0};
  Writer writer(plain, limit, false);
  writer.value(value, type);
  return std::move(writer.out);
}

bool write_value(Vm& vm, TextMaker& text, Slot value, const Format& format) {
  Writer writer(format, vm, text);
  writer.value(value, *format.type);
  return writer.flush();
}

std::string format_value(Slot value, const Format& format, std::size_t limit) {
  Writer writer(format, limit, true);
  writer.value(value, *format.type);
  return std::move(writer.out);
}

}  // namespace armlet::lang
