#include "armlet/interpreter/editor/analysis.hpp"

#include <utility>

#include "editor/facts.hpp"

namespace armlet {

Analysis::Analysis(std::unique_ptr<const Facts> facts) : facts_(std::move(facts)) {}
Analysis::~Analysis() = default;

const SourceSet& Analysis::sources() const { return *facts_->compiled.sources; }
const std::vector<Diagnostic>& Analysis::diagnostics() const { return facts_->diagnostics; }
bool Analysis::was_cancelled() const { return facts_->cancelled; }

std::string_view name_kind_text(NameKind kind) {
  switch (kind) {
    case NameKind::kVariable:
      return "variable";
    case NameKind::kParameter:
      return "parameter";
    case NameKind::kFunction:
      return "function";
    case NameKind::kStruct:
      return "struct";
    case NameKind::kEnum:
      return "enum";
    case NameKind::kField:
      return "field";
    case NameKind::kEnumValue:
      return "enum value";
    case NameKind::kModule:
      return "module";
    case NameKind::kLibraryFunction:
      return "library function";
    case NameKind::kConstant:
      return "constant";
    case NameKind::kType:
      return "type";
    case NameKind::kSetting:
      return "setting";
    case NameKind::kWord:
      return "word";
    case NameKind::kText:
      return "text";
  }
  return {};
}

}  // namespace armlet
