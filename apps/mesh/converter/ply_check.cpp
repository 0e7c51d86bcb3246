// Checks PLY before Assimp reads it: Assimp trusts the header, and reads beyond the end of the file
// or of a line with fewer numbers.
//
// source  G. Turk, The PLY polygon file format, 1994.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "converter/file_checks.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

constexpr double kMostOfList = 32'767;  // most corners of a face in Assimp

// A type and its size in bytes; kinds: 'i' signed, 'u' unsigned, 'f'.
struct Type {
  std::size_t size = 0;
  char kind = 0;
};

Type type_of(std::string_view name) {
  constexpr std::pair<std::string_view, Type> kTypes[] = {
      {"char", {1, 'i'}},  {"int8", {1, 'i'}},    {"uchar", {1, 'u'}},  {"uint8", {1, 'u'}},
      {"short", {2, 'i'}}, {"int16", {2, 'i'}},   {"ushort", {2, 'u'}}, {"uint16", {2, 'u'}},
      {"int", {4, 'i'}},   {"int32", {4, 'i'}},   {"uint", {4, 'u'}},   {"uint32", {4, 'u'}},
      {"float", {4, 'f'}}, {"float32", {4, 'f'}}, {"double", {8, 'f'}}, {"float64", {8, 'f'}}};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  refuse(fmt::format("its header names the type \"{:.40}\", which PLY has not", name));
}

struct Property {
  bool is_list = false;
  Type count{}, type{};
  bool names_vertices = false;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  std::vector<Element> elements;
  bool is_text = false;
  bool high_first = false;  // numbers are big-endian
};

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = line.find_first_not_of(" \t\r", at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string_view::npos) return std::exchange(text, {});
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

Property property_of(const std::vector<std::string_view>& words) {
  Property made;
  if (words.size() == 5 && words[1] == "list") {
    made = {true, type_of(words[2]), type_of(words[3]), words[4].starts_with("vertex_ind")};
    if (made.count.kind == 'f')
      refuse("its header counts the elements of a list by broken numbers");
  } else if (words.size() == 3) {
    made.type = type_of(words[1]);
  } else {
    refuse("its header has a `property` that is none");
  }
  return made;
}

// Removes the header from the text and returns it.
Header take_header(std::string_view& text) {
  Header header;
  if (words_of(take_line(text)) != std::vector<std::string_view>{"ply"})
    refuse("it is no PLY file: it does not begin with `ply`");
  for (;;) {
    if (text.empty()) refuse("it is cut off: `end_header` is missing");
    const auto words = words_of(take_line(text));
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
    if (words[0] == "end_header" && words.size() == 1) return header;
    if (words[0] == "format" && words.size() == 3) {
      header.is_text = words[1] == "ascii";
      header.high_first = words[1] == "binary_big_endian";
      if (!header.is_text && !header.high_first && words[1] != "binary_little_endian")
        refuse(fmt::format("its format \"{:.40}\" is none of PLY", words[1]));
    } else if (words[0] == "element" && words.size() == 3) {
      Element element;
      element.name = words[1];
      const char* const end = words[2].data() + words[2].size();
      const auto read = std::from_chars(words[2].data(), end, element.count);
      if (read.ec != std::errc() || read.ptr != end)
        refuse(fmt::format("its header says {:.40} elements \"{:.40}\"", words[2], words[1]));
      header.elements.push_back(std::move(element));
    } else if (words[0] == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(property_of(words));
    } else {
      refuse(fmt::format("its header has a line that begins with \"{:.40}\"", words[0]));
    }
  }
}

class Body {
 public:
  Body(const Header& header, std::string_view bytes) : header_(header), bytes_(bytes) {
    for (const Element& each : header.elements) {
      if (each.name == "vertex") vertices_ = each.count;
    }
  }

  void check() {
    for (const Element& each : header_.elements) {
      // An element without properties has no bytes, so its count cannot be checked.
      if (each.properties.empty() && each.count > 0)
        refuse(fmt::format("its elements \"{:.40}\" have no properties", each.name));
      for (std::size_t i = 0; i < each.count; ++i) {
        if (bytes_.empty()) {
          refuse(fmt::format("its header says {} elements \"{:.40}\", but there are {}", each.count,
                             each.name, i));
        }
        if (header_.is_text) {
          check_line(each, i);
        } else {
          check_binary(each, i);
        }
      }
    }
  }

 private:
  void check_line(const Element& element, std::size_t index) {
    std::vector<std::string_view> words;
    while (words.empty() && !bytes_.empty()) words = words_of(take_line(bytes_));
    std::size_t at = 0;
    const auto next = [&]() -> double {
      if (at >= words.size()) cut(element, index);
      const std::string_view word = words[at++];
      double value = 0.0;
      const auto sign = word.starts_with('+') ? 1 : 0;
      const auto read = std::from_chars(word.data() + sign, word.data() + word.size(), value);
      const bool whole = read.ptr == word.data() + word.size();
      if (!whole || (read.ec != std::errc() && read.ec != std::errc::result_out_of_range)) {
        refuse(fmt::format("element {} \"{:.40}\" has \"{:.40}\" where a number should be", index,
                           element.name, word));
      }
      return value;
    };
    for (const Property& each : element.properties) {
      const double count = each.is_list ? next() : 1.0;
      check_count(count, element, index);
      for (double k = 0; k < count; ++k) check_index(each, next(), element, index);
    }
    if (at != words.size()) {
      refuse(fmt::format("element {} \"{:.40}\" has {} numbers; expected {}", index, element.name,
                         words.size(), at));
    }
  }

  void check_binary(const Element& element, std::size_t index) {
    for (const Property& each : element.properties) {
      const double count = each.is_list ? take(each.count, element, index) : 1.0;
      check_count(count, element, index);
      for (double k = 0; k < count; ++k)
        check_index(each, take(each.type, element, index), element, index);
    }
  }

  // A whole number; 0 for other numbers, whose value is not needed.
  double take(const Type& type, const Element& element, std::size_t index) {
    if (bytes_.size() < type.size) cut(element, index);
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < type.size; ++k) {
      const std::size_t at = header_.high_first ? k : type.size - 1 - k;
      value = value << 8 | static_cast<unsigned char>(bytes_[at]);
    }
    bytes_.remove_prefix(type.size);
    if (type.kind == 'f') return 0.0;
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
    if (type.kind == 'i' && (value & sign) != 0)
      return static_cast<double>(value) - 2.0 * static_cast<double>(sign);
    return static_cast<double>(value);
  }

  static void check_count(double count, const Element& element, std::size_t index) {
    if (count < 0.0 || count > kMostOfList || count != std::floor(count)) {
      refuse(fmt::format("element {} \"{:.40}\" has a list of {}; expected 0 to {}", index,
                         element.name, count, kMostOfList));
    }
  }

  void check_index(const Property& property, double value, const Element& element,
                   std::size_t index) const {
    if (!property.names_vertices) return;
    if (!(value >= 0.0 && value < static_cast<double>(vertices_)) || value != std::floor(value)) {
      refuse(fmt::format("element {} \"{:.40}\" names vertex {}, but there are {}", index,
                         element.name, value, vertices_));
    }
  }

  [[noreturn]] static void cut(const Element& element, std::size_t index) {
    refuse(fmt::format("it is cut off in element {} \"{:.40}\"", index, element.name));
  }

  const Header& header_;
  std::string_view bytes_;
  std::size_t vertices_ = 0;
};

}  // namespace

void check_ply(std::string_view bytes) {
  const Header header = take_header(bytes);
  Body(header, bytes).check();
}

}  // namespace armlet::mesh
