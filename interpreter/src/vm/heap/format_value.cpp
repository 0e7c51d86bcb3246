#include "vm/heap/format_value.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <string_view>

#include "armlet/interpreter/work.hpp"

namespace armlet::lang {

namespace {

constexpr int kMostDigits = 15;
constexpr int kMostQuantityDigits = 10;  // of quantities, and of the elements of matrices
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
Decimal decimal_of(double value, int most_digits) {
  char buffer[64];
  auto end =
      std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  Decimal shortest = read_scientific({buffer, static_cast<std::size_t>(end - buffer)});
  if (shortest.digits.size() <= static_cast<std::size_t>(most_digits)) return shortest;
  end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific,
                      most_digits - 1)
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

// The text of a number; is_whole: it has neither point nor exponent.
std::string plain_number(double value, bool& is_whole, int most_digits) {
  is_whole = false;
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  is_whole = value == 0.0;
  if (is_whole) return "0";
  const Decimal d = decimal_of(std::abs(value), most_digits);
  const std::string sign = value < 0 ? "-" : "";
  if (d.exponent < -4 || d.exponent >= kMostDigits) return sign + with_exponent(d);
  if (d.exponent < 0)
    return sign + "0." + std::string(static_cast<std::size_t>(-d.exponent - 1), '0') + d.digits;
  const auto before = static_cast<std::size_t>(d.exponent) + 1;
  is_whole = d.digits.size() <= before;
  if (is_whole) return sign + d.digits + std::string(before - d.digits.size(), '0');
  return sign + d.digits.substr(0, before) + '.' + d.digits.substr(before);
}

// The number of a quantity, rounded to ten digits, because further digits are rounding errors.
std::string measured_text(double value) {
  bool is_whole = false;
  return plain_number(value, is_whole, kMostQuantityDigits);
}

// The text of a number with a number of digits. Zero has no sign: "0.00", not "-0.00".
std::string number_with_digits(double value, int digits, char style) {
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

// The number before a unit, with the digits of a style.
std::string styled_number(double value, const TextStyle& style) {
  return style.has_digits() ? number_with_digits(value, style.digits, style.notation)
                            : measured_text(value);
}

std::size_t characters(std::string_view text) {
  const auto is_start = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
  return static_cast<std::size_t>(std::ranges::count_if(text, is_start));
}

// The numbers of blanks before and after a text that fill the width of a style.
std::pair<std::size_t, std::size_t> blanks_around(std::string_view text, const TextStyle& style,
                                                  char otherwise = '<') {
  if (text.size() >= std::size_t{style.width} * 4) return {0, 0};
  const std::size_t length = characters(text);
  if (length >= style.width) return {0, 0};
  const std::size_t missing = style.width - length;
  const char align = style.align != 0 ? style.align : otherwise;
  const std::size_t before = align == '>' ? missing : align == '^' ? missing / 2 : 0;
  return {before, missing - before};
}

// Adds blanks to the text from `begin` on, up to the width of a style.
void fill_up(std::string& out, std::size_t begin, const TextStyle& style, bool is_number) {
  if (style.width == 0) return;
  const auto [before, behind] =
      blanks_around(std::string_view(out).substr(begin), style, is_number ? '>' : '<');
  const std::size_t first = begin + (out[begin] == '-' || out[begin] == '+' ? 1 : 0);
  const bool has_digits = out[first] >= '0' && out[first] <= '9';  // neither inf nor nan
  if (style.zeros && is_number && has_digits) {
    out.insert(first, before + behind, '0');
    return;
  }
  out.insert(begin, before, ' ');
  out.append(behind, ' ');
}

class Writer {
 public:
  // is_shown: the text is output of the program, not a part of a message.
  Writer(const Format& format, std::size_t limit, bool is_shown)
      : format_(format), limit_(limit), is_shown_(is_shown) {}
  Writer(const Format& format, Vm& vm, TextMaker& text) : format_(format), vm_(&vm), text_(&text) {}

  void value(Slot s, const Type& type);
  // Appends the characters since the last flush to the text of the program. Returns false if the
  // text is complete or cannot grow.
  bool flush();
  std::string out;

 private:
  class Noise;

  void real(double value, Dim dim);
  void number(double value, Dim dim);
  void text(std::string_view text);
  void list(const ListObj& list, const Type& element);
  void map(const MapObj& map, const Type& type);
  void table(Slot s, const RecordInfo& info);
  void record(const RecordObj& record, const RecordInfo& info);
  void matrix(const MatrixObj& matrix);
  void reference(Slot s, const Type& type);

  // Whether the text is still shorter than the limit.
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
  double negligible_ = 0.0;  // elements up to this absolute value are written as 0
  bool in_matrix_ = false;
};

// In the lifetime of a Noise, elements of a vector or matrix that are negligible beside the largest
// one are written as 0.
class Writer::Noise {
 public:
  Noise(Writer& writer, std::span<const double> numbers) : writer_(writer) {
    constexpr double kNothing = 1e-12;
    double largest = 0.0;
    for (const double number : numbers) {
      if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
    }
    writer_.negligible_ = kNothing * largest;
  }
  ~Noise() { writer_.negligible_ = 0.0; }
  Noise(const Noise&) = delete;
  Noise& operator=(const Noise&) = delete;

 private:
  Writer& writer_;
};

bool Writer::flush() {
  constexpr std::uint64_t kCost = 8;  // per byte of a number
  failed_ = failed_ || !charge_work(*vm_, kCost * out.size()) || !text_->add(out);
  out.clear();
  return !failed_;
}

void Writer::real(double value, Dim dim) {
  const TextStyle& style = format_.style;
  const std::size_t begin = out.size();
  number(std::abs(value) <= negligible_ && !style.has_digits() ? 0.0 : value, dim);
  if (style.sign && out[begin] != '-' && !std::isnan(value)) out.insert(begin, 1, '+');
  fill_up(out, begin, style, true);
}

void Writer::number(double value, Dim dim) {
  const TextStyle& style = format_.style;
  if (!format_.unit.empty()) {
    out += styled_number(value / format_.factor, style) + ' ' + format_.unit;
  } else if (!dim.is_none()) {
    const DisplayUnit unit = display_unit(dim, value);
    out += styled_number(value / unit.factor, style);
    if (!unit.name.empty()) out += ' ' + unit.name;
  } else if (style.has_digits()) {
    out += styled_number(value, style);
  } else if (in_matrix_) {
    const std::string text = measured_text(value);
    out += text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  } else {
    out += number_text(value);
  }
}

void Writer::text(std::string_view text) {
  if (level_ == 0) {
    const auto [before, behind] = blanks_around(text, format_.style);
    out.append(before, ' ');
    if (text_ == nullptr) {
      out += text;
    } else {
      failed_ = !flush() || !text_->add(text);
    }
    out.append(behind, ' ');
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
  const bool of_quantities = element.is(Kind::kReal) && !element.dim.is_none();
  const Noise noise(*this, of_quantities ? list.reals() : std::span<const double>());
  out += '[';
  for (std::uint32_t i = 0; i < list.size && goes_on(); ++i) {
    if (i > 0) out += ", ";
    value(list.data[i], element);
  }
  out += ']';
}

// ["bolt": 3, "nut": 5]; a format applies to the values.
void Writer::map(const MapObj& map, const Type& type) {
  out += '[';
  bool is_first = true;
  for (const MapEntry& entry : map.all()) {
    if (!goes_on()) return;
    if (entry.is_removed) continue;
    if (!is_first) out += ", ";
    is_first = false;
    if (type.key->is(Kind::kText)) {
      text(static_cast<TextObj*>(entry.key.o)->view());
    } else {
      out += value_text(entry.key, *type.key);
    }
    out += ": ";
    value(entry.value, *type.element);
  }
  out += is_first ? ":]" : "]";
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
  const std::size_t count = std::size_t{matrix.rows} * matrix.cols;
  const Noise noise(*this, {matrix.data(), count});
  in_matrix_ = true;
  out += '[';
  for (std::size_t i = 0; i < count && goes_on(); ++i) {
    if (i > 0) out += i % matrix.cols == 0 ? "; " : ", ";
    real(matrix.data()[i], dims::kNone);
  }
  if (matrix.rows == 1 && count > 0) out += ';';  // a program that reads it gets a matrix again
  out += ']';
  in_matrix_ = false;
}

void Writer::reference(Slot s, const Type& type) {
  if (s.o == nullptr) {  // an element without a value, or an absent argument
    if (level_ > 0) out += "unset";
    return;
  }
  if (type.is(Kind::kText)) return text(static_cast<TextObj*>(s.o)->view());
  if (level_ >= kMostLevels) {
    out += "...";
    return;
  }
  ++level_;
  if (type.is(Kind::kList)) list(*static_cast<ListObj*>(s.o), *type.element);
  if (type.is(Kind::kMap)) map(*static_cast<MapObj*>(s.o), type);
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
      // Only a value that the program shows by itself may have several lines.
      if (!is_shown_ || level_ > 1) out.resize(std::min(out.find('\n', begin), out.size()));
    } else {
      out += type.host->name;
    }
  }
  --level_;
}

void Writer::value(Slot s, const Type& type) {
  const std::size_t begin = out.size();
  const TextStyle& style = format_.style;
  switch (type.kind) {
    case Kind::kBool:
      out += s.i != 0 ? "true" : "false";
      return fill_up(out, begin, style, false);
    case Kind::kInt:
      if (style.has_digits() || !format_.unit.empty())
        return real(static_cast<double>(s.i), dims::kNone);
      if (style.sign && s.i >= 0) out += '+';
      out += std::to_string(s.i);
      return fill_up(out, begin, style, true);
    case Kind::kReal:
      return real(s.d, type.dim);
    case Kind::kEnum:
      out += type.enumeration->name + '.' + type.enumeration->values[static_cast<std::size_t>(s.i)];
      return fill_up(out, begin, style, false);
    case Kind::kText:
    case Kind::kList:
    case Kind::kMap:
    case Kind::kMatrix:
    case Kind::kRecord:
    case Kind::kFunction:
    case Kind::kHost:
      return reference(s, type);
    case Kind::kAny:
    case Kind::kVoid:
      return;
  }
}

}  // namespace

std::string number_text(double value) {
  bool is_whole = false;
  std::string text = plain_number(value, is_whole, kMostDigits);
  return is_whole ? text + ".0" : text;
}

std::string bare_number_text(double value) {
  bool is_whole = false;
  return plain_number(value, is_whole, kMostDigits);
}

std::string quantity_text(double si, Dim dim) {
  const DisplayUnit unit = display_unit(dim, si);
  return measured_text(si / unit.factor) + (unit.name.empty() ? "" : " " + unit.name);
}

std::string value_text(Slot value, const Type& type, std::size_t limit) {
  const Format plain{&type, {}, {}, 1.0};
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
