#include "nacre/report/markup.h"

#include <gtest/gtest.h>

namespace nacre::report {
namespace {

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
