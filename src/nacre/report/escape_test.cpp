#include "nacre/report/escape.h"

#include <gtest/gtest.h>

namespace nacre::report {
namespace {

using namespace std::string_literals;

TEST(Escape, LeavesNothingThatHtmlTakesForMarkup) {
    EXPECT_EQ(escape_html("<b a='1' c=\"2\">&amp;"),
              "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;amp;");
}

TEST(Escape, KeepsValidUtf8) {
    const std::string text =
        "tab\tline\r\nΔE* ≤ 1 日本 \U0001F3A8 \u007E\u00A0\uD7FF\uE000\U0010FFFF";
    EXPECT_EQ(clean_utf8(text), text);
}

TEST(Escape, ReplacesWhatIsNoUtf8) {
    const std::string r = "\uFFFD";
    EXPECT_EQ(clean_utf8("a\xFFz"), "a" + r + "z");
    EXPECT_EQ(clean_utf8("a\xC3"), "a" + r);                   // cut short
    EXPECT_EQ(clean_utf8("\xC0\xAF"), r + r);                  // overlong /
    EXPECT_EQ(clean_utf8("\xE0\x80\xAF"), r + r + r);          // overlong /
    EXPECT_EQ(clean_utf8("\xED\xA0\x80"), r + r + r);          // a surrogate
    EXPECT_EQ(clean_utf8("\xF4\x90\x80\x80"), r + r + r + r);  // beyond U+10FFFF
    EXPECT_EQ(clean_utf8("\0a\x1B[31m\x7F\xC2\x85"s), r + "a" + r + "[31m" + r + r);  // controls
}

TEST(Escape, LetsNoScriptEndItsElement) {
    EXPECT_EQ(escape_script("a='</script>'; b='</ScRiPt x'; c='<!--'; d='</style>'"),
              "a='<\\/script>'; b='<\\/ScRiPt x'; c='<\\!--'; d='</style>'");
    EXPECT_EQ(escape_json("{\"a\":\"</script><!--\"}"), "{\"a\":\"\\u003c/script>\\u003c!--\"}");
}

}  // namespace
}  // namespace nacre::report
