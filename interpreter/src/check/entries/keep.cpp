#include "check/entries/keep.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/diagnostic/backticks.hpp"
#include "base/words.hpp"
#include "check/names/variables.hpp"

namespace armlet::lang {
namespace {

using Users = std::vector<std::string_view>;

// The different words of a text.
std::set<std::string_view> words_of(std::string_view text) {
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_word_character(text[end])) ++end;
    if (end > i) words.insert(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
  return words;
}

class Keeper {
 public:
  explicit Keeper(Checker& main)
      : main_(main),
        shared_(main.shared),
        before_(main.shared.earlier.kept()),
        kept_(before_ != nullptr ? continued(*before_) : std::make_unique<KeptNames>()) {
    if (before_ == nullptr) {
      kept_->ambient = std::make_shared<std::vector<KeptAmbient>>();
      kept_->blocks = std::make_shared<BlockNames>();
    }
  }

  std::unique_ptr<const KeptNames> run() {
    number_globals();
    number_functions();
    for (Checker* file : shared_.files) {
      file->kept_file = kept_->files.emplace_back(std::make_unique<KeptFile>()).get();
    }
    for (std::size_t i = 0; i < shared_.files.size(); ++i)
      keep(*shared_.files[i], *kept_->files[i]);
    keep_grown();
    keep_ambient();
    keep_blocks();
    note_users();
    advise();
    free_globals();
    return std::move(kept_);
  }

 private:
  static std::unique_ptr<KeptNames> continued(const KeptNames& before) {
    auto kept = std::make_unique<KeptNames>();
    kept->types = before.types;
    kept->imported = before.imported;
    kept->ambient = before.ambient;
    kept->blocks = before.blocks;
    kept->users = before.users;
    kept->functions = before.functions;
    kept->globals = before.globals;
    kept->free_globals = before.free_globals;
    return kept;
  }

  // Numbers of variables that no code can use any more are given to new ones.
  void number_globals() {
    for (hir::Variable* variable : main_.into.module.globals) {
      if (kept_->free_globals.empty()) {
        variable->index = kept_->globals++;
      } else {
        variable->index = kept_->free_globals.back();
        kept_->free_globals.pop_back();
      }
    }
  }

  // The text of an entry runs once and has number 0. A function with the signature of an older one
  // gets its number, so that callers of the older one call the new one.
  void number_functions() {
    kept_->functions = std::max(kept_->functions, 1U);
    std::unordered_map<const hir::Function*, const hir::Function*> replaced;
    for (const auto& [name, function] : main_.names.functions()) {
      const KeptName* old = before_ != nullptr ? before_->main().find(name) : nullptr;
      if (old == nullptr || old->function == nullptr || function.is_generic()) continue;
      for (const KeptInstance& form : old->function->instances) {
        for (const Instance* mine : function.instances) {
          if (mine->types == form.types && mine->function->result == form.function->result)
            replaced[mine->function] = form.function;
        }
      }
    }
    for (hir::Function* function : main_.into.module.functions) {
      const auto old = replaced.find(function);
      if (function == main_.into.module.main) {
        function->index = 0;
      } else if (old == replaced.end()) {
        function->index = kept_->functions++;
      } else {
        function->index = old->second->index;
        replaced_.insert(function->index);
        // Callers move the arguments that the older function takes over, so the new one must take
        // them over too.
        for (std::size_t i = 0; i < function->parameters.size(); ++i)
          function->parameters[i]->adopted = old->second->parameters[i]->adopted;
      }
    }
  }

  void keep(Checker& file, KeptFile& into) {
    const bool is_main = &file == &main_;
    const auto set = [&](KeptName kept) {
      if (is_main) declared_.insert(kept.name);
      into.set(std::move(kept));
    };
    into.span = file.file.program.span;
    if (is_main && before_ != nullptr) into.names = before_->main().names;
    for (const auto& [name, import] : file.names.imports()) {
      if (import.file == nullptr) continue;
      KeptName kept{.name = name, .declared = import.span};
      kept.import = import.file->kept_file;
      set(std::move(kept));
    }
    for (const FileTree::Import& import : file.file.imports) {
      const KeptFile* from = import.file >= 0 ? kept_->files[import.file].get() : import.kept;
      if (from != nullptr) into.imports.push_back({path_of(*import.statement), from});
    }
    for (const auto& [name, type] : file.names.types()) {
      KeptName kept{.name = name, .declared = file.names.declaration_of(name)};
      kept.type = type;
      set(std::move(kept));
      const StructDecl* declared = shared_.structs.find(type);
      const void* const info = type->is(Kind::kRecord)
                                   ? static_cast<const void*>(type->record)
                                   : static_cast<const void*>(type->enumeration);
      kept_->types.set(key_of(info), {declared != nullptr ? declared->node : nullptr, &into});
      main_.into.entry.keeps_syntax = true;
    }
    for (const auto& [name, function] : file.names.functions()) {
      KeptName kept{.name = name, .declared = function.node->name.span};
      kept.function = kept_form(function, into);
      set(std::move(kept));
      main_.into.entry.keeps_syntax = true;
    }
    for (const TopLevel::Entry& entry : shared_.top_level.entries()) {
      const hir::Variable& variable = *entry.variable;
      if (variable.declared.source != into.span.source) continue;
      const Local* local = file.scopes.main().find(variable.name);
      KeptName kept{.name = variable.name, .declared = variable.declared, .how = Declared::kLet};
      if (local != nullptr) {
        kept.how = local->how;
        kept.keyword = local->keyword;
      }
      kept.maybe_unset = variable.maybe_unset && entry.init->value == nullptr;
      kept.variable = &variable;
      set(std::move(kept));
    }
    if (!is_main) {
      const std::string& name = (*main_.into.sources)[into.span.source].name();
      const auto* known = kept_->imported.find(key_of(name));
      auto files = known != nullptr ? *known : std::vector<const KeptFile*>();
      files.push_back(&into);
      kept_->imported.set(key_of(name), std::move(files));
    }
  }

  std::shared_ptr<const KeptFunction> kept_form(const FunctionDecl& function,
                                                const KeptFile& file) {
    auto kept = std::make_shared<KeptFunction>(
        KeptFunction{function.node, &file, function.parameters, function.result, {}});
    for (const Instance* form : function.instances) {
      if (!form->result_known) continue;
      const Use& use = shared_.uses.of(form->function);
      kept->instances.push_back({form->types, form->function, shared_.uses.may_pause(use)});
    }
    return kept;
  }

  // Keeps functions of earlier entries that were checked for further types.
  void keep_grown() {
    for (const Earlier::Grown& grown : shared_.earlier.grown()) {
      KeptFile& file = *kept_->files.back();
      const KeptName* known = file.find(grown.from->node->name.text);
      if (known == nullptr || known->function != grown.from) continue;
      KeptName kept = *known;
      kept.function = kept_form(*grown.function, *grown.from->file);
      file.set(std::move(kept));
    }
  }

  // Keeps the ambient values of all entries, with the newest declaration of each name, for calls
  // that omit them.
  void keep_ambient() {
    std::vector<KeptAmbient> all;
    bool changed = false;
    for (const KeptAmbient& ambient : *kept_->ambient) {
      const bool hidden = ambient.file == nullptr && declared_.contains(ambient.name);
      changed = changed || hidden;
      if (!hidden) all.push_back(ambient);
    }
    for (const Checker* file : shared_.files) {
      for (const auto& [type, names] : file->names.ambient()) {
        changed = true;
        for (const std::string_view name : names)
          all.push_back({type, name, file == &main_ ? nullptr : file->kept_file});
      }
    }
    if (changed) kept_->ambient = std::make_shared<std::vector<KeptAmbient>>(std::move(all));
  }

  void keep_blocks() {
    const auto added = shared_.blocks.all();
    if (added.empty()) return;
    auto blocks = std::make_shared<BlockNames>(*kept_->blocks);
    for (const auto& [type, names] : added) {
      for (const std::string& name : names) {
        if (!blocks->has(type, name)) blocks->add(type, name);
      }
    }
    kept_->blocks = std::move(blocks);
  }

  void add_user(std::uint64_t key, std::string_view user) {
    const Users* known = kept_->users.find(key);
    if (known != nullptr && std::ranges::find(*known, user) != known->end()) return;
    Users longer = known != nullptr ? *known : Users();
    longer.push_back(user);
    kept_->users.set(key, std::move(longer));
  }

  void note_users() {
    for (const hir::Function* function : main_.into.module.functions) {
      if (function == main_.into.module.main) continue;
      const Use& use = shared_.uses.of(function);
      for (const hir::Variable* variable : use.globals)
        add_user(use_key(*variable), function->name);
      for (const hir::Function* called : use.calls) add_user(use_key(*called), function->name);
    }
    // Bodies and default values that later entries check refer to the names in their texts.
    const KeptFile& file = *kept_->files.back();
    for (const auto& [name, function] : main_.names.functions())
      note_words(file, function.node->span, name);
    for (const auto& [name, type] : main_.names.types())
      if (const StructDecl* declared = shared_.structs.find(type))
        note_words(file, declared->node->span, name);
  }

  void note_words(const KeptFile& file, Span text, std::string_view user) {
    for (const std::string_view word : words_of(main_.into.sources->slice(text))) {
      const KeptName* known = file.find(word);
      if (known != nullptr && known->variable != nullptr) add_user(use_key(*known->variable), user);
    }
  }

  // Whether a user of a function or variable is still active: a function that later entries can
  // call, or an armed block.
  [[nodiscard]] bool lives_on(std::string_view user) const {
    if (user.starts_with("when ") || user.starts_with("every ")) return true;
    const KeptName* kept = kept_->files.back()->find(user);
    return kept != nullptr && kept->function != nullptr && !declared_.contains(user);
  }

  // Reports advice if a name is declared again while other code still uses the older declaration.
  void advise() {
    if (before_ == nullptr) return;
    for (const std::string_view name : declared_) {
      const KeptName* old = before_->main().find(name);
      if (old == nullptr) continue;
      std::set<std::string_view> users;
      const auto look = [&](std::uint64_t key) {
        const Users* known = before_->users.find(key);
        for (const std::string_view user : known != nullptr ? *known : Users())
          if (lives_on(user)) users.insert(user);
      };
      if (old->variable != nullptr) look(use_key(*old->variable));
      if (old->function != nullptr) {
        for (const KeptInstance& form : old->function->instances)
          if (!replaced_.contains(form.function->index)) look(use_key(*form.function));
      }
      if (!users.empty()) advise(*old, users);
    }
  }

  void advise(const KeptName& old, const std::set<std::string_view>& users) {
    constexpr std::size_t kMost = 3;
    std::string who;
    for (std::size_t i = 0; const std::string_view user : users) {
      if (i == kMost) who += " and others";
      if (i++ >= kMost) continue;
      who += (who.empty() ? "" : ", ") + in_backticks(user);
    }
    const std::string name(old.name);
    Diagnostic advice =
        make_diagnostic("W0719", kept_->files.back()->find(name)->declared, {name, who});
    advice.related.push_back({old.declared, "the earlier one"});
    const std::string again = "declare " + in_backticks(*users.begin()) + " again too";
    advice.fix =
        Fix{.text = old.variable != nullptr
                        ? "write " + name + " = ... to change the earlier one, or " + again
                        : "give it the parameters and the result of the earlier one, or " + again};
    main_.messages.begin_statement();
    main_.report(std::move(advice));
  }

  // Frees the numbers of variables that no code can use any more: those that are declared again,
  // and those of blocks.
  void free_globals() {
    for (const std::string_view name : declared_) {
      const KeptName* old = before_ != nullptr ? before_->main().find(name) : nullptr;
      if (old == nullptr || old->variable == nullptr) continue;
      if (kept_->users.find(use_key(*old->variable)) == nullptr)
        kept_->free_globals.push_back(old->variable->index);
    }
    for (const hir::Variable* variable : main_.into.module.globals) {
      if (shared_.top_level.use_of(variable) == nullptr)
        kept_->free_globals.push_back(variable->index);
    }
  }

  Checker& main_;
  Shared& shared_;
  const KeptNames* before_;
  std::unique_ptr<KeptNames> kept_;
  std::set<std::uint32_t> replaced_;     // numbers of replaced variables
  std::set<std::string_view> declared_;  // names declared by the main file
};

}  // namespace

void keep_names(Checker& main) { main.into.entry.kept = Keeper(main).run(); }

}  // namespace armlet::lang
