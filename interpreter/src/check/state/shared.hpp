#pragma once
// The state of a check that all files of a program share.

#include <vector>

#include "check/scopes/earlier.hpp"
#include "check/scopes/top_level.hpp"
#include "check/scopes/uses.hpp"
#include "check/state/constants.hpp"
#include "check/state/defaults.hpp"
#include "check/state/instances.hpp"
#include "check/state/postponed.hpp"
#include "check/state/signatures.hpp"
#include "check/state/structs.hpp"
#include "hir/checked_program.hpp"
#include "hir/program_names.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

struct Checker;
class Learnt;

// The depth of nested checks, which follows the nesting of the text and of the bodies of called
// functions. The parser limits the nesting of the text only; this class limits both.
class Depth {
 public:
  static constexpr int kMost = 600;

  // One level of depth, for its lifetime.
  class Level {
   public:
    explicit Level(Depth& depth) : depth_(depth) { ++depth_.levels_; }
    ~Level() { --depth_.levels_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Depth& depth_;
  };

  [[nodiscard]] bool is_full() const { return levels_ >= kMost; }

 private:
  int levels_ = 0;
};

struct Shared {
  // kept  the names of the entry before this one; null if there is none.
  Shared(const CheckedProgram& into, const Registry& registry, const KeptNames* kept,
         DiagnosticSink& messages)
      : sink(messages),
        earlier(*this, kept),
        instances(*into.arena, *into.types),
        signatures(registry, *into.types),
        error_type(into.types->library_record("error")) {}

  Learnt* learnt = nullptr;  // results for editors; null: not needed
  bool guesses = false;      // see Learnt::guesses
  DiagnosticSink& sink;
  std::vector<Checker*> files{};  // imported ones before those that import them
  Earlier earlier;
  Depth depth{};
  Instances instances;
  Uses uses{};
  TopLevel top_level{};
  Postponed postponed{};
  Structs structs{earlier};
  Defaults defaults{};
  Constants constants{};
  Signatures signatures;
  BlockNames blocks{};
  Mentions mentions{};
  const Type* const error_type;
};

}  // namespace armlet::lang
