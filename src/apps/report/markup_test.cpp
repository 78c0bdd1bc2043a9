#include "apps/report/markup.h"

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

TEST(Markup, KnowsCodeEmphasisAndLinks) {
    EXPECT_EQ(markup_to_html("run `nacre *x* <y>` *at once*, see [Table *1*](#table-1)."),
              "run <code>nacre *x* &lt;y&gt;</code> <em>at once</em>, see "
              "<a href=\"#table-1\">Table <em>1</em></a>.");
    EXPECT_EQ(markup_to_html("*all of [this](a.png)*"),
              "<em>all of <a href=\"a.png\">this</a></em>");
}

TEST(Markup, LeavesStarsOfColourSpacesAlone) {
    for (const char* text : {"L*a*b*", "a* and b*", "ΔE*ab, C* (h*)", "2 * 3 * 4", "a *b", "x**",
                             "**", "`", "``", "[mir-2022]", "[a] (b)", "[](b)"}) {
        EXPECT_EQ(markup_to_html(text), text);
        EXPECT_EQ(markup_to_plain(text), text);
    }
}

TEST(Markup, TakesAddressesThatCannotRun) {
    for (const char* url : {"https://doi.org/10.1/x?a=b&c=d", "http://a.b", "mailto:a@b.c", "#a-b",
                            "pictures/a.png", "./a:b", "a?b=c:d"}) {
        const std::string html = markup_to_html("[x](" + std::string(url) + ")");
        EXPECT_EQ(html.substr(0, 9), "<a href=\"") << html;
    }
    for (const char* url :
         {"javascript:alert`1`", "JavaScript:x", "data:text/html,x", "//evil.example", "vbscript:x",
          "java\tscript:x", " javascript:x", "\\\\evil.example", ""}) {
        const std::string html = markup_to_html("[x](" + std::string(url) + ")");
        EXPECT_EQ(html.find("<a"), std::string::npos) << html;
    }
}

TEST(Markup, EscapesEverywhere) {
    const std::string evil = "<script>\"'&";
    for (const std::string& text :
         {evil, "`" + evil + "`", "*" + evil + "*", "[" + evil + "](#a)", "[a](#" + evil + ")"}) {
        const std::string html = markup_to_html(text);
        EXPECT_EQ(html.find("<script"), std::string::npos) << html;
        EXPECT_NE(html.find("&lt;script&gt;&quot;&#39;&amp;"), std::string::npos) << html;
    }
}

TEST(Markup, GivesPlainTextWithoutMarks) {
    EXPECT_EQ(markup_to_plain("`a` *b [c](#d)* <e>"), "a b c <e>");
}

TEST(Markup, ReadsTextsFullOfOpeningMarks) {
    // In time proportional to their length: quadratic time would be felt.
    for (const char* mark : {"*a ", "[", "`a", "[a]("}) {
        std::string text;
        for (int i = 0; i < 30'000; ++i) text += mark;
        if (*mark != '`') {
            EXPECT_EQ(markup_to_plain(text), text);
        } else {
            EXPECT_FALSE(markup_to_plain(text).empty());
        }
    }
}

}  // namespace
}  // namespace nacre::report
