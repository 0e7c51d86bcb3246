#include "armlet/interpreter/diagnostic.hpp"

#include <doctest/doctest.h>

#include <type_traits>

#include "armlet/core/error.hpp"

namespace armlet {

TEST_CASE("the headline takes its arguments in order") {
  const Diagnostic made = make_diagnostic("E0207", {3, 5}, {"moveL", "{}"});
  CHECK(made.message == "`moveL` has no setting called `{}`");
  CHECK(made.code == "E0207");
  CHECK(made.mark.span == Span{3, 5});
  CHECK(made.severity == Severity::kError);
}

TEST_CASE("only codes that start with W are advice") {
  CHECK(make_diagnostic("W0709", {}, {"x"}).severity == Severity::kAdvice);
  CHECK(make_diagnostic("R0613", {}, {"2 and 3"}).severity == Severity::kError);
}

TEST_CASE("a wrong number of arguments does not compile, and is reported for rows of the run") {
  static_assert(std::is_constructible_v<Headline, MessageCode<1>, const std::string(&)[1]>);
  static_assert(!std::is_constructible_v<Headline, MessageCode<1>, const std::string(&)[2]>);
  static_assert(!std::is_constructible_v<Headline, MessageCode<1>>);
  static_assert(!std::is_constructible_v<Headline, MessageCode<0>, const std::string(&)[1]>);
  const CatalogEntry row{.code = "E0901", .kind = {}, .headline = "`{}` is {}", .page = {}};
  const std::string two[] = {"a", "{}"};
  CHECK(Headline::of(row, two).text() == "`a` is {}");
  CHECK_THROWS_AS((void)Headline::of(row, std::span(two, 1)), ArgumentError);
  CHECK_THROWS_AS((void)Headline::of(row, {}), ArgumentError);
}

TEST_CASE("a statement reports its first error only") {
  DiagnosticSink sink;
  CHECK(sink.report(make_diagnostic("E0401", {1, 2})));
  CHECK_FALSE(sink.report(make_diagnostic("E0401", {4, 5})));
  CHECK(sink.report(make_diagnostic("W0709", {6, 7}, {"x"})));
  sink.begin_statement();
  CHECK(sink.report(make_diagnostic("E0401", {8, 9})));
  CHECK(sink.all().size() == 3);
}

TEST_CASE("the same mistake at the same position is reported once") {
  DiagnosticSink sink;
  CHECK(sink.report(make_diagnostic("E0401", {1, 2})));
  sink.begin_statement();
  CHECK_FALSE(sink.report(make_diagnostic("E0401", {1, 2})));
  CHECK(sink.statement_failed());
}

TEST_CASE("there are at most ten messages, and advice makes room for errors") {
  DiagnosticSink sink;
  for (std::uint32_t i = 0; i < 20; ++i) sink.report(make_diagnostic("W0710", {i, i + 1}));
  CHECK(sink.all().size() == 10);
  CHECK_FALSE(sink.has_errors());
  for (std::uint32_t i = 0; i < 20; ++i) {
    sink.begin_statement();
    CHECK(sink.full() == (i >= 10));
    CHECK(sink.report(make_diagnostic("E0401", {i, i + 1})) == (i < 10));
  }
  CHECK(sink.all().size() == 10);
  for (const Diagnostic& message : sink.all()) CHECK(message.code == "E0401");
}

TEST_CASE("messages come in the order of the text, file by file") {
  DiagnosticSink sink;
  sink.report(make_diagnostic("W0710", {1, 2, 1}));
  sink.report(make_diagnostic("E0401", {9, 10, 0}));
  sink.report(make_diagnostic("W0710", {3, 4, 0}));
  const std::vector<Diagnostic> sorted = sink.take_sorted();
  REQUIRE(sorted.size() == 3);
  CHECK(sorted[0].mark.span == Span{3, 4, 0});
  CHECK(sorted[1].mark.span == Span{9, 10, 0});
  CHECK(sorted[2].mark.span == Span{1, 2, 1});
  CHECK(sink.all().empty());
  CHECK_FALSE(sink.has_errors());
}

}  // namespace armlet
