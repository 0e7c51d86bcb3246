#pragma once
// What tests of editors share: the examples, their imports, their tokens.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "syntax/tokens/lex.hpp"

namespace armlet::editor_test {

inline std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<std::filesystem::path> programs_below(const char* folder) {
  std::vector<std::filesystem::path> out;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(ARMLET_ROOT) / folder)) {
    if (entry.path().extension() == ".rbt") out.push_back(entry.path());
  }
  std::ranges::sort(out);
  return out;
}

inline SessionOptions options_for(const std::filesystem::path& program) {
  SessionOptions out;
  out.default_world = table_world();
  out.load = [folder = program.parent_path()](const std::string& path, const std::string&) {
    ImportedText found{.name = path};
    if (std::filesystem::exists(folder / path)) found.text = read(folder / path);
    return found;
  };
  return out;
}

inline lang::Tokens tokens_of(const std::string& text) {
  const Source source("program.rbt", text);
  DiagnosticSink sink;
  return lang::lex(source, lang::program_range(source), sink, {}).tokens;
}

inline std::shared_ptr<const Analysis> analysis_of(const std::string& text) {
  Session session(library_engine(), {.default_world = table_world()});
  return session.analyse(text, "program.rbt");
}

inline bool offers(const Completions& completions, std::string_view text) {
  return std::ranges::any_of(completions.items, [&](const Completion& item) {
    return item.text == text ||
           (item.kind == NameKind::kSetting && item.text == std::string(text) + ':');
  });
}

}  // namespace armlet::editor_test
