#pragma once
// The vocabulary of an engine: native functions, constants, host types and records of the library,
// by name.
//
// Only names and texts are kept here. A program reads the signatures it needs against its own
// types, so an engine may be shared by threads.

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/interpreter/foreign_name.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"
#include "vocabulary/language_functions.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

// What was added in one go, and the chapter of the reference that it belongs to.
struct Chapter {
  std::string_view title;
  std::span<const NativeFunction> functions;
  std::span<const NativeConstant> constants;
};

// How the name of a function ends that makes rows named by the program: "motor.phase.NAME".
inline constexpr std::string_view kNamedRow = ".NAME";

// "operator+", "point.x=", "motor{}" and "motor()" are found by the checker, not written by
// programs.
[[nodiscard]] inline bool is_written(std::string_view name) {
  return !name.starts_with("operator") && name.find_first_of("[]{}()=") == std::string_view::npos;
}

class Registry {
 public:
  // language  outlives the registry.
  explicit Registry(const LanguageFunctions& language);

  [[nodiscard]] const LanguageFunctions& language() const { return language_; }

  // Adds all, or none and returns the first that is there already.
  const NativeFunction* add_functions(std::span<const NativeFunction> functions);
  // Keeps a function as long as the registry, for add_functions, with what it needs.
  std::span<const NativeFunction> keep(const NativeFunction& function,
                                       std::shared_ptr<const void> needs);
  void keep(std::shared_ptr<const void> needs) { kept_.push_back(std::move(needs)); }
  void add_constant(const NativeConstant& constant);
  void add_type(const HostType& type);
  void take_back_type(std::string_view name);
  void add_record(std::string_view name, std::string_view fields);
  void add_messages(std::span<const CatalogEntry> rows) { messages_.add(rows); }
  [[nodiscard]] const MessageTables& messages() const { return messages_; }
  // Functions that change nothing, so that a statement made of a call of one does nothing.
  void add_values(std::span<const NativeFunction> functions) { values_.push_back(functions); }
  [[nodiscard]] bool only_gives(const NativeFunction& function) const;
  void add_chapter(const Chapter& chapter) { chapters_.push_back(chapter); }
  // throws  ArgumentError for a word that is known already.
  void add_foreign_names(std::span<const ForeignName> rows);
  // What a word of another language is called here; null if it is not known.
  [[nodiscard]] const ForeignName* foreign(std::string_view word,
                                           ForeignKind kind = ForeignKind::kName) const;
  // A name of the language reference that nothing stands behind yet.

  // All functions of one name, in the order in which they were added.
  [[nodiscard]] std::span<const NativeFunction* const> functions(std::string_view name) const;
  [[nodiscard]] const NativeConstant* constant(std::string_view name) const;
  [[nodiscard]] const HostType* type(std::string_view name) const;
  // Whether names such as "Math.sin" exist for "Math".
  [[nodiscard]] bool is_namespace(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, const HostType*, std::less<>>& types() const {
    return types_;
  }
  // What takes time, as part of a sentence in the words of the host: "wait or move".
  [[nodiscard]] std::string what_takes_time() const;
  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& records() const {
    return records_;
  }
  [[nodiscard]] const std::vector<Chapter>& chapters() const { return chapters_; }
  // Whether blocks of this type have rows that the program names: "motor.phase.NAME".
  [[nodiscard]] bool has_named_rows(std::string_view type) const;
  // Names a program can write, sorted: for suggestions.
  [[nodiscard]] std::vector<std::string_view> public_names() const;

  // The types of the library's records, which all programs share.
  [[nodiscard]] std::shared_ptr<const TypePool> library_types() const;
  // Host types and library records by name, as types of one program.
  [[nodiscard]] TypeNames type_names(TypePool& types) const;
  // Makes the records of the library; the fields of one that cannot be read are missing.
  void declare_records(TypePool& types) const;
  // All functions by name.
  [[nodiscard]] const std::map<std::string_view, std::vector<const NativeFunction*>>& functions()
      const {
    return functions_;
  }

 private:
  // The record of a caught error has a field for each type of resource: the one that was commanded.
  void describe_errors();
  const LanguageFunctions& language_;
  // The names are those of the functions and constants, which outlive the engine.
  std::map<std::string_view, std::vector<const NativeFunction*>> functions_;
  std::map<std::string_view, const NativeConstant*> constants_;
  std::map<std::string, const HostType*, std::less<>> types_;
  std::map<std::string, std::string, std::less<>> records_;
  MessageTables messages_;
  std::map<std::pair<ForeignKind, std::string_view>, ForeignName> foreign_;
  std::vector<Chapter> chapters_;
  std::vector<std::span<const NativeFunction>> values_;
  std::deque<NativeFunction> defined_;
  std::vector<std::shared_ptr<const void>> kept_;  // what they need
  mutable std::mutex making_types_;
  mutable std::shared_ptr<const TypePool> library_types_;  // null: not made since the last change
};

}  // namespace armlet::lang
