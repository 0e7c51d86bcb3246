#include "driver/load_files.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "armlet/interpreter/host/table_text.hpp"
#include "check/state/suggest.hpp"
#include "hir/kept.hpp"
#include "program/program.hpp"
#include "syntax/parse.hpp"

namespace armlet::lang {
namespace {

// The limit of files in a program, and of files that import each other in a chain.
constexpr std::size_t kMostFiles = 200;

// The limit of messages about files of a text that is repaired; after it no file is read.
constexpr int kMostUntold = 100;

std::string without_folders(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

// The reason why an import that is usual in another language is not needed here.
std::string_view always_there(std::string_view path) {
  const std::string_view first = path.substr(0, path.find('.'));
  if (first == "math" || first == "Math" || first == "cmath" || first == "numpy")
    return "the functions of mathematics are always there: sin, sqrt, PI";
  if (first == "time" || first == "random" || first == "sys" || first == "java" || first == "std")
    return "the library is always there: wait, now, random, print";
  constexpr std::array<std::string_view, 10> kToolboxes = {
      "roboticstoolbox", "spatialmath", "spatialgeometry",  "swift",         "robodk",
      "robolink",        "rospy",       "moveit_commander", "geometry_msgs", "pybullet"};
  if (std::ranges::find(kToolboxes, first) != kToolboxes.end())
    return "what the library offers is always there, without an import";
  return {};
}

std::string files_there(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 6;
  std::string out;
  for (std::size_t i = 0; i < names.size() && i < kMost; ++i)
    out += (i == 0 ? "the files there are \"" : ", \"") + names[i] + '"';
  return names.size() > kMost ? out + " and more" : out;
}

class Loader {
 public:
  Loader(SourceSet& sources, Arena& tree, const CompileOptions& options, DiagnosticSink& sink,
         Mended* main_file, const ReadBefore* before)
      : sources_(sources),
        tree_(tree),
        options_(options),
        sink_(&sink),
        kept_(options.after != nullptr ? options.after->compiled().entry.kept.get() : nullptr),
        main_file_(main_file),
        before_(before) {}

  std::vector<FileTree> run() {
    const Source& main = sources_[sources_.first()];
    bytes_ = main.text().size();
    numbers_[main.name()] = kBeingRead;
    read(main);
    return std::move(files_);
  }

 private:
  static constexpr int kBeingRead = -2;

  struct Step {
    const Source* file;
    const ast::ImportStmt* import;
  };

  // Parses a file and returns its number.
  int read(const Source& source) {
    const Parsed parsed = parsed_of(source);
    FileTree file{.program = {}, .ok = parsed.ok};
    file.program.span = {0, static_cast<std::uint32_t>(source.text().size()), source.id()};
    file.program.body = tree_.copy(parsed.statements);
    // Failed imports of imported files are known to editors but not reported.
    DiagnosticSink* const before = sink_;
    const bool is_mended =
        main_file_ != nullptr && source.id() == sources_.first() && !main_file_->is_readable;
    if (is_mended) {
      file.program.body = tree_.copy(main_file_->statements);
      sink_ = &quiet_;
    }
    for (const ast::Stmt* stmt : file.program.body) {
      if (stmt->kind != ast::StmtKind::kImport) continue;
      const auto& import = stmt->as<ast::ImportStmt>();
      sink_->begin_statement();
      if (const KeptFile* kept = unchanged(import, source)) {
        file.imports.push_back({&import, -1, kept});
        continue;
      }
      path_.push_back({&source, &import});
      file.imports.push_back({&import, follow(source, import)});
      path_.pop_back();
    }
    sink_ = before;
    files_.push_back(std::move(file));
    return numbers_[source.name()] = static_cast<int>(files_.size()) - 1;
  }

  Parsed parsed_of(const Source& source) {
    if (main_file_ == nullptr || source.id() != sources_.first())
      return parse(source, tree_, *sink_, options_.limits, nullptr, options_.cancelled);
    *main_file_ =
        parse_and_mend(source, tree_, *sink_, options_.limits, options_.cancelled, before_);
    return main_file_->exact;
  }

  // The file as an earlier entry has read it; null if none did, or if the file or one of its
  // imports has changed.
  const KeptFile* unchanged(const ast::ImportStmt& import, const Source& from) {
    if (kept_ == nullptr || !options_.load) return nullptr;
    const ImportedText found = options_.load(path_of(import), from.name());
    const auto* known = found.text ? kept_->imported.find(key_of(found.name)) : nullptr;
    if (known == nullptr) return nullptr;
    const KeptFile& newest = *known->back();
    return is_unchanged(newest, found) ? &newest : nullptr;
  }

  bool is_unchanged(const KeptFile& file, const ImportedText& found) {
    const Source& source = sources_[file.span.source];
    if (source.name() != found.name || source.text() != *found.text) return false;
    return std::ranges::all_of(file.imports, [&](const KeptFile::KeptImport& import) {
      const ImportedText inner = options_.load(import.path, source.name());
      return inner.text && is_unchanged(*import.file, inner);
    });
  }

  // Loads an imported file and returns its number; -1 after a message.
  int follow(const Source& from, const ast::ImportStmt& import) {
    const std::string path = path_of(import);
    const auto followed = followed_.find({from.id(), path});
    if (followed != followed_.end()) return followed->second;  // the host need not load it again
    if (sink_->full() && sink_ != &quiet_) return -1;
    const int file = look_up(from, import, path);
    if (file >= 0) followed_.emplace(std::pair(from.id(), path), file);
    return file;
  }

  int look_up(const Source& from, const ast::ImportStmt& import, const std::string& path) {
    ImportedText found;
    // Files with tables are read by loadTable; as programs they are refused like other endings.
    if (options_.load && !path.ends_with(kTableEnding)) found = options_.load(path, from.name());
    const auto known = numbers_.find(found.name);
    if (found.text && known != numbers_.end()) {
      if (known->second == kBeingRead) return refuse_circle(import, found.name);
      return known->second;
    }
    if (!found.text) return refuse_missing(import, path, found);
    bytes_ += found.text->size();
    const bool many = sources_.size() - sources_.first() >= kMostFiles;
    if (many || bytes_ > options_.limits.bytes) {
      const std::string what =
          many ? "more than " + std::to_string(kMostFiles) + " files"
               : "its files have more than " + std::to_string(options_.limits.bytes) + " bytes";
      sink_->report(make_diagnostic("E0124", import.path_span, {what}));
      return -1;
    }
    numbers_[found.name] = kBeingRead;
    return read(sources_.add(std::move(found.name), *std::move(found.text)));
  }

  int refuse_missing(const ast::ImportStmt& import, const std::string& path,
                     const ImportedText& found) {
    Diagnostic out = make_diagnostic("E0213", import.path_span, {path});
    out.why = path.ends_with(kTableEnding) ? "it is a table; loadTable(\"" + path + "\") reads it"
              : options_.load              ? found.why
                                           : "the host of this program gives it no files to import";
    const std::string_view there = always_there(import.path);
    if (!import.is_file && !there.empty()) {
      out.why = there;
      out.fix = Fix{"delete this line", {{import.span, ""}}, Confidence::kMaybe};
    } else {
      const std::vector<std::string_view> names(found.others.begin(), found.others.end());
      std::optional<std::string_view> meant;
      for (const std::string_view name : names) {
        if (name == path + ".rbt") meant = name;
      }
      if (!meant) meant = suggest(path, std::span<const std::string_view>(names));
      if (!meant && out.why.empty()) out.why = files_there(found.others);
      if (meant) {
        const std::string better = '"' + std::string(*meant) + '"';
        out.fix =
            Fix{"did you mean " + better + "?", {{import.path_span, better}}, Confidence::kSure};
      }
    }
    sink_->report(std::move(out));
    return -1;
  }

  int refuse_circle(const ast::ImportStmt& import, const std::string& name) {
    std::size_t first = 0;
    while (path_[first].file->name() != name) ++first;
    std::string circle;
    for (std::size_t i = first; i < path_.size(); ++i)
      circle += without_folders(path_[i].file->name()) + " -> ";
    Diagnostic out = make_diagnostic("E0214", import.path_span, {circle + without_folders(name)});
    for (std::size_t i = first; i + 1 < path_.size(); ++i)
      out.related.push_back({path_[i].import->path_span, ""});
    out.fix = Fix{"move what both need into a third file", {}, Confidence::kMaybe};
    sink_->report(std::move(out));
    return -1;
  }

  SourceSet& sources_;
  Arena& tree_;
  const CompileOptions& options_;
  DiagnosticSink* sink_;
  DiagnosticSink quiet_{kMostUntold};
  const KeptNames* kept_;  // of the entry before this one; null: none
  Mended* main_file_;
  const ReadBefore* before_;
  std::vector<FileTree> files_;
  std::map<std::string, int> numbers_;                             // of files by name
  std::map<std::pair<std::uint32_t, std::string>, int> followed_;  // by file and text of the import
  std::vector<Step> path_;  // from the main file to the current one
  std::size_t bytes_ = 0;
};

}  // namespace

std::vector<FileTree> load_files(SourceSet& sources, Arena& tree, const CompileOptions& options,
                                 DiagnosticSink& sink, Mended* main_file,
                                 const ReadBefore* before) {
  return Loader(sources, tree, options, sink, main_file, before).run();
}

}  // namespace armlet::lang
