#include "vocabulary/union_rows.hpp"

namespace armlet::lang {
namespace {

// A part of a signature: one text, or the types of a union.
using Choices = std::vector<std::string_view>;

// The length of the literal text that begins at `at`: = "Syn".
std::size_t literal_length(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
  return end + 1 - at;
}

std::string_view without_spaces(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

// Splits the signature into texts and unions.
std::vector<Choices> parts_of(std::string_view text) {
  std::vector<Choices> parts;
  Choices types;            // of the union that is being read
  std::size_t written = 0;  // the end of the parts
  std::size_t type = 0;     // the begin of the type that is being read
  int depth = 0;
  const auto end_of_type = [&](std::size_t at) {
    if (types.empty()) return;
    types.push_back(without_spaces(text.substr(type, at - type)));
    parts.push_back(std::move(types));
    types.clear();
    written = at;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      i += literal_length(text, i) - 1;
    } else if (c == '(' || c == '[' || c == '{') {
      ++depth;
    } else if (c == ')' || c == ']' || c == '}') {
      if (--depth == 0) end_of_type(i);
    } else if (c == ':' && depth == 1) {
      type = i + 1;
    } else if (c == ',' && depth == 1) {
      end_of_type(i);
    } else if (c == '|' && depth == 1) {
      if (types.empty()) parts.push_back({text.substr(written, type + 1 - written)});
      types.push_back(without_spaces(text.substr(type, i - type)));
      type = i + 1;
    }
  }
  parts.push_back({text.substr(written)});
  return parts;
}

}  // namespace

bool has_union(std::string_view signature) { return signature.find('|') != std::string_view::npos; }

std::vector<std::string> signatures_of(std::string_view signature) {
  std::vector<std::string> all = {std::string()};
  for (const Choices& choices : parts_of(signature)) {
    std::vector<std::string> longer;
    for (const std::string& begin : all) {
      for (const std::string_view choice : choices) longer.push_back(begin + std::string(choice));
    }
    all = std::move(longer);
  }
  return all;
}

NativeFunction choice_of(const NativeFunction& row, std::size_t i, std::string_view signature) {
  NativeFunction one = row;
  one.signature = signature;
  one.row = &row;
  one.alternatives = {};
  if (row.alternatives.empty()) return one;
  const Alternative& chosen = row.alternatives[i];
  one.thunk = chosen.thunk;
  one.takes = chosen.takes;
  one.gives = chosen.gives;
  return one;
}

}  // namespace armlet::lang
