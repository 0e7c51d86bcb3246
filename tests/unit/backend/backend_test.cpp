#include "armlet/backend/backend.hpp"

#include <doctest/doctest.h>

#include "run.hpp"

using namespace armlet;

namespace {

class Silent : public Backend {
 public:
  void on(const Event&) override {}
};

}  // namespace

TEST_CASE("a backend that says nothing else ignores no event and has no error") {
  Silent silent;
  play_short_run(silent);
  CHECK(silent.ignores() == EventKinds());
  CHECK(silent.error().empty());
}
