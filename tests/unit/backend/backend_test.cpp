#include "armlet/backend/backend.hpp"

#include <doctest/doctest.h>

#include "run.hpp"

using namespace armlet;

TEST_CASE("a backend may ignore everything") {
  Backend silent;
  play_short_run(silent);
  CHECK(silent.error().empty());
}

TEST_CASE("kinds have words") {
  CHECK(to_text(ObjectChange::kAttached) == "attached");
  CHECK(to_text(ObjectChange::kDetached) == "detached");
  CHECK(to_text(ObjectChange::kRemoved) == "removed");
  CHECK(to_text(NoteKind::kOutput) == "output");
  CHECK(to_text(NoteKind::kMessage) == "message");
  CHECK(to_text(NoteKind::kAdvice) == "advice");
}
