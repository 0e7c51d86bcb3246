#include "check/scopes/earlier.hpp"

#include "check/state/checker.hpp"

namespace armlet::lang {

// A file of an earlier entry, without statements to check.
struct Earlier::File {
  File(const KeptFile& kept, Shared& shared, const Checker& main)
      : checker(tree, shared, main.into, main.registry, main.options, shared.sink) {
    tree.program.span = kept.span;
    checker.kept_file = &kept;
    checker.follow(kept);
    checker.scopes.begin(checker.arena.make<hir::Function>(), unused);
    checker.scopes.open_block();
  }

  FileTree tree;
  Use unused;
  Checker checker;
};

Earlier::Earlier(Shared& shared, const KeptNames* kept) : shared_(shared), kept_(kept) {}
Earlier::~Earlier() = default;

Checker& Earlier::file(const KeptFile& kept) {
  std::unique_ptr<File>& known = files_[&kept];
  if (known == nullptr) known = std::make_unique<File>(kept, shared_, *shared_.files.back());
  return known->checker;
}

FunctionDecl& Earlier::function(const std::shared_ptr<const KeptFunction>& kept) {
  std::unique_ptr<Function>& known = functions_[kept.get()];
  if (known != nullptr) return known->made;
  known = std::make_unique<Function>();
  known->kept = kept;
  FunctionDecl& made = known->made;
  made.node = kept->node;
  made.file = &file(*kept->file);
  made.parameters = kept->parameters;
  made.result = kept->result;
  for (const KeptInstance& form : kept->instances) {
    shared_.uses.of(form.function).pauses = form.pauses;
    made.instances.push_back(&known->instances.emplace_back(
        Instance{form.types, form.function, true, true, &made, kept->node->name.span}));
  }
  return made;
}

const Import& Earlier::import(const KeptName& kept) {
  const auto [at, is_new] = imports_.try_emplace(&kept);
  if (is_new) at->second = {kept.declared, &file(*kept.import)};
  return at->second;
}

hir::Variable* Earlier::variable(const KeptName& kept) {
  hir::Variable*& known = variables_[kept.variable];
  if (known != nullptr) return known;
  Checker& main = *shared_.files.back();
  known = main.arena.make<hir::Variable>(*kept.variable);
  known->owner = nullptr;
  known->maybe_unset = kept.maybe_unset;
  if (known->init != nullptr) shared_.constants.note(*known);
  return known;
}

const KeptType* Earlier::type(const void* info) const {
  return kept_ == nullptr ? nullptr : kept_->types.find(key_of(info));
}

std::vector<Earlier::Grown> Earlier::grown() const {
  std::vector<Grown> out;
  for (const auto& [kept, function] : functions_) {
    if (function->made.instances.size() > kept->instances.size())
      out.push_back({function->kept, &function->made});
  }
  return out;
}

}  // namespace armlet::lang
