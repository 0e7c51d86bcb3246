#include "armlet/core/xml.hpp"

#include <doctest/doctest.h>

using namespace armlet;

TEST_CASE(
    "marks of XML are written as words, line breaks as numbers, what XML does not allow as "
    "blanks") {
  CHECK(xml_escaped("a < b && \"c\" > d") == "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
  CHECK(xml_escaped("line\nline\x01\x7f") == "line&#10;line &#127;");
  CHECK(xml_escaped("30\u00b0") == "30\u00b0");
  CHECK(xml_escaped("").empty());
}
