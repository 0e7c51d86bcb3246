#pragma once
// The registry of an engine: native functions, constants, host types and records of the library, by
// name.
//
// The registry contains only names and texts. A program parses the signatures that it uses, with
// its own types, so several threads may share an engine.

#include <array>
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

// Functions that were added together, with their chapter of the reference.
struct Chapter {
  std::string_view title;
  std::span<const NativeFunction> functions;
  std::span<const NativeConstant> constants;
};

// The end of the name of a function that makes named rows: "motor.phase.NAME".
inline constexpr std::string_view kNamedRow = ".NAME";

// Whether programs write the name. "operator+", "point.x=", "motor{}" and "motor()" are only looked
// up by the checker.
[[nodiscard]] inline bool is_written(std::string_view name) {
  return !name.starts_with("operator") && name.find_first_of("[]{}()=") == std::string_view::npos;
}

class Registry {
 public:
  // language  must outlive the registry.
  explicit Registry(const LanguageFunctions& language);

  [[nodiscard]] const LanguageFunctions& language() const { return language_; }

  // Adds all functions. If one exists already, adds none and returns it; null otherwise.
  const NativeFunction* add_functions(std::span<const NativeFunction> functions);
  // Stores a function, with data that it needs, for the lifetime of the registry, for
  // add_functions.
  std::span<const NativeFunction> keep(const NativeFunction& function,
                                       std::shared_ptr<const void> needs);
  void keep(std::shared_ptr<const void> needs) { kept_.push_back(std::move(needs)); }
  void add_constant(const NativeConstant& constant);
  void add_type(const HostType& type);
  void take_back_type(std::string_view name);
  void add_record(std::string_view name, std::string_view fields);
  void add_messages(std::span<const CatalogEntry> rows) { messages_.add(rows); }
  [[nodiscard]] const MessageTables& messages() const { return messages_; }
  // Adds functions without effects: a statement with only a call of one does nothing.
  void add_values(std::span<const NativeFunction> functions) { values_.push_back(functions); }
  [[nodiscard]] bool only_gives(const NativeFunction& function) const;
  void add_chapter(const Chapter& chapter) { chapters_.push_back(chapter); }
  // throws  ArgumentError for a word that was added before.
  void add_foreign_names(std::span<const ForeignName> rows);
  // The row for a name of another language; null if there is none.
  [[nodiscard]] const ForeignName* foreign(std::string_view word,
                                           ForeignKind kind = ForeignKind::kName) const;

  // All functions with one name, in the order in which they were added.
  [[nodiscard]] std::span<const NativeFunction* const> functions(std::string_view name) const;
  // The functions that run at an event of a block.
  [[nodiscard]] std::span<const NativeFunction* const> functions(BlockEvent event) const {
    return at_events_[static_cast<std::size_t>(event)];
  }
  [[nodiscard]] const NativeConstant* constant(std::string_view name) const;
  [[nodiscard]] const HostType* type(std::string_view name) const;
  // Whether names such as "Math.sin" exist for the name "Math".
  [[nodiscard]] bool is_namespace(std::string_view name) const;
  [[nodiscard]] const std::map<std::string, const HostType*, std::less<>>& types() const {
    return types_;
  }
  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& records() const {
    return records_;
  }
  [[nodiscard]] const std::vector<Chapter>& chapters() const { return chapters_; }
  // Whether blocks of this type have named rows: "motor.phase.NAME".
  [[nodiscard]] bool has_named_rows(std::string_view type) const;
  // The names that a program can use, sorted, for proposals.
  [[nodiscard]] std::vector<std::string_view> public_names() const;

  // The types of the library's records, which all programs share.
  [[nodiscard]] std::shared_ptr<const TypePool> library_types() const;
  // Host types and library records by name, as types of one program.
  [[nodiscard]] TypeNames type_names(TypePool& types) const;
  // Makes the record types of the library; fields with an invalid type are omitted.
  void declare_records(TypePool& types) const;
  // All functions by name.
  [[nodiscard]] const std::map<std::string_view, std::vector<const NativeFunction*>>& functions()
      const {
    return functions_;
  }

 private:
  // The functions that a row stands for: several if it has unions.
  std::vector<const NativeFunction*> functions_of(const NativeFunction& row);
  // Adds fields to the record of a caught error: one for each type of resource, for the one that
  // was commanded.
  void describe_errors();
  const LanguageFunctions& language_;
  // The keys refer to the names of functions and constants, which outlive the engine.
  std::map<std::string_view, std::vector<const NativeFunction*>> functions_;
  std::array<std::vector<const NativeFunction*>, kBlockEvents> at_events_;
  std::map<std::string_view, const NativeConstant*> constants_;
  std::map<std::string, const HostType*, std::less<>> types_;
  std::map<std::string, std::string, std::less<>> records_;
  MessageTables messages_;
  std::map<std::pair<ForeignKind, std::string_view>, ForeignName> foreign_;
  std::vector<Chapter> chapters_;
  std::vector<std::span<const NativeFunction>> values_;
  std::deque<NativeFunction> defined_;
  std::deque<std::string> signatures_;             // of the choices of rows with unions
  std::vector<std::shared_ptr<const void>> kept_;  // data of the stored functions
  mutable std::mutex making_types_;
  mutable std::shared_ptr<const TypePool> library_types_;  // null: to be made after the last change
};

// The actions that take time, as part of a sentence in the words of the host: "wait or move".
[[nodiscard]] std::string what_takes_time(const Registry& registry);

}  // namespace armlet::lang
