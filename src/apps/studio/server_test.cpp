#include "apps/studio/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "apps/studio/messages/messages.h"
#include "apps/studio/page_files.h"
#include "apps/studio/server_test_support.h"
#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"
#include "nacre/nacre.h"
#include "nacre/render.h"

// Requests to the server, through its sockets: what it serves, to whom, and what it refuses.

namespace nacre::studio {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(StudioServer, ServesThePageAndNothingElse) {
    const RunningServer server;
    ASSERT_FALSE(page_files().empty());
    const auto page = server.get("/");
    EXPECT_EQ(page.status, 200u);
    EXPECT_THAT(page.fields.at("content-type"), StartsWith("text/html"));
    EXPECT_THAT(page.fields.at("content-security-policy"), HasSubstr("default-src 'self'"));
    EXPECT_EQ(page.fields.at("referrer-policy"), "no-referrer");
    EXPECT_EQ(page.body, std::ranges::find(page_files(), "/index.html", &PageFile::path)->bytes);
    for (const char* path : {"/etc/passwd", "/../server.cpp", "/%2e%2e/%2e%2e/etc/passwd",
                             "/page/index.html", "//etc/passwd", "/index.html%00"}) {
        EXPECT_EQ(server.get(path).status, 404u) << path;
    }
    EXPECT_EQ(server.get("/%zz").status, 400u);
    EXPECT_EQ(server.get("/" + std::string(5000, 'a')).status, 400u);
    EXPECT_EQ(server.get("/", {}, "POST", "x").status, 405u);
    const auto head = server.get("/", {}, "HEAD");
    EXPECT_EQ(head.status, 200u);
    EXPECT_EQ(head.fields.at("content-length"), std::to_string(page.body.size()));
}

TEST(StudioServer, RefusesOtherHostsTokensAndOrigins) {
    const RunningServer server;
    const std::string port = server.host().substr(server.host().find(':'));
    for (const std::string& host :
         std::vector<std::string>{"evil.example", "evil.example" + port, "127.0.0.1", "127.0.0.1:1",
                                  "127.0.0.2" + port, ""}) {
        EXPECT_EQ(server.get("/", {{"Host", host}}).status, 403u) << host;
    }
    EXPECT_EQ(server.get("/", {{"Host", "localhost" + port}}).status, 200u);

    const std::string shape = "/api/shape/panel";
    EXPECT_EQ(server.get(shape).status, 401u);
    EXPECT_EQ(server.get(shape + "?token=").status, 401u);
    EXPECT_EQ(server.get(shape + "?token=" + std::string(32, '0')).status, 401u);
    EXPECT_EQ(server.get(shape + "?token=" + server.token() + "0").status, 401u);
    EXPECT_EQ(server.get(shape + "?token=" + server.token()).status, 200u);
    EXPECT_EQ(server.get(shape, {{"X-Nacre-Token", server.token()}}).status, 200u);
    EXPECT_EQ(server.token().size(), 32u);
    EXPECT_NE(server.token(), RunningServer().token());

    EXPECT_NO_THROW(PageClient{server});
    EXPECT_ANY_THROW(PageClient(server, "wrong"));
    EXPECT_ANY_THROW(PageClient(server, "", "http://evil.example"));
    EXPECT_ANY_THROW(PageClient(server, "", "null"));
    EXPECT_ANY_THROW(PageClient(server, "", "http://evil.example", "evil.example"));
}

TEST(StudioServer, RefusesTwoHosts) {
    const RunningServer server;
    EXPECT_EQ(server.status_of("GET / HTTP/1.1\r\nHost: " + server.host() + "\r\n\r\n"), 200u);
    for (const std::string& other : {std::string("evil.example"), server.host()}) {
        EXPECT_EQ(server.status_of("GET / HTTP/1.1\r\nHost: " + server.host() +
                                   "\r\nHost: " + other + "\r\n\r\n"),
                  400u)
            << other;
    }
}

TEST(StudioServer, RefusesWhatIsTooLarge) {
    const RunningServer server;
    const auto large = server.get("/", {{"X-Large", std::string(20'000, 'x')}});
    EXPECT_EQ(large.status, 431u);
    const auto body = server.get("/", {{"Content-Length", "100000000"}});
    EXPECT_EQ(body.status, 413u);
    PageClient page(server);
    // The server ends the session, and goes on with others.
    EXPECT_ANY_THROW({
        page.send_text(std::string(kMaxMessageBytes + 1, ' '));
        page.read();
    });
    EXPECT_EQ(server.get("/").status, 200u);
}

TEST(StudioServer, SaysWhereItCannotListen) {
    const Server first({});
    EXPECT_THROW(Server({.address = "127.0.0.1", .port = first.port()}), InputError);
    EXPECT_THROW(Server({.address = "localhost"}), InputError);
    EXPECT_TRUE(is_loopback("127.0.0.1"));
    EXPECT_TRUE(is_loopback("::1"));
    EXPECT_FALSE(is_loopback("0.0.0.0"));
    EXPECT_THAT(first.url(), StartsWith("http://127.0.0.1:"));
}

TEST(StudioServer, ShapesAndLightsAreWhole) {
    const RunningServer server;
    const Tree schema = Tree::parse(server.api("/api/schema").body);
    ASSERT_GT(schema["shapes"].size(), 1u);
    ASSERT_GT(schema["lights"].size(), 1u);
    for (const Tree& shape : schema["shapes"]) {
        const std::string name = shape["name"];
        const auto answer = server.api("/api/shape/" + name);
        ASSERT_EQ(answer.status, 200u) << name;
        std::uint32_t counts[2];
        ASSERT_GE(answer.body.size(), sizeof counts);
        std::memcpy(counts, answer.body.data(), sizeof counts);
        EXPECT_GT(counts[1], 1u) << name;
        EXPECT_EQ(answer.body.size(), 8 + 32 * counts[0] + 12 * counts[1]) << name;
    }
    for (const Tree& light : schema["lights"]) {
        const std::string name = light["name"];
        const auto answer = server.api("/api/light/" + name + "?width=32");
        ASSERT_EQ(answer.status, 200u) << name;
        const std::string& body = answer.body;
        std::uint32_t length = 0, size[2];
        std::memcpy(&length, body.data(), 4);
        const Tree header = Tree::parse(body.substr(4, length));
        std::memcpy(size, body.data() + 4 + length, 8);
        EXPECT_EQ(size[0], 32u);
        EXPECT_EQ(size[1], 16u);
        EXPECT_EQ(body.size(), 12 + length + 32 * 16 * 12) << name;
        EXPECT_EQ(header["sun"].is_null(), name != "sun") << name;
        EXPECT_EQ(header["rectangles"].size(),
                  name.starts_with("booth") || name == "microscope" ? 1u : 0u)
            << name;
    }
    EXPECT_EQ(server.api("/api/shape/cube").status, 404u);
    EXPECT_EQ(server.api("/api/light/sun?width=1000000").status, 400u);
    EXPECT_EQ(server.api("/api/light/sun?width=x").status, 400u);
    EXPECT_EQ(server.api("/api/other").status, 404u);
}

TEST(StudioServer, TheSchemaSaysWhatShips) {
    const RunningServer server({.toml = red_gold()});
    const auto answer = server.api("/api/schema");
    ASSERT_EQ(answer.status, 200u);
    const Tree schema = Tree::parse(answer.body);
    EXPECT_EQ(schema["start"], red_gold());
    EXPECT_EQ(schema["paints"].size(), shipped_paints().size());
    for (const Tree& shape : schema["shapes"]) {  // 400 mm long; others are as wide as high
        const double aspect = shape["camera"]["aspect"];
        if (shape["name"] == "speed-shape") {
            EXPECT_GT(aspect, 1.2);
            EXPECT_LT(aspect, 1.6);
        } else if (shape["name"] == "ball" || shape["name"] == "macro") {
            EXPECT_EQ(aspect, 1) << shape["name"];
        }
    }
    for (const Tree& paint : schema["paints"]) {
        EXPECT_NO_THROW(io::parse_recipe_file(paint["toml"].get<std::string>(), "x", {}))
            << paint["name"];
    }
    std::set<std::string> names;
    for (const Tree& flakes : schema["flakes"]) {
        const std::string name = flakes["name"];
        EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
        Tree recipe = tree_of_toml("ior = 1.5\n[[layer]]\nthickness_um = 20\n", "x");
        recipe["layer"][0]["flakes"] = Tree::array({flakes["value"]});
        EXPECT_NO_THROW(io::parse_recipe_file(toml_of_tree(recipe), "x", {})) << name;
    }
    EXPECT_GT(names.size(), 25u);
    EXPECT_GT(schema["materials"].size(), 20u);
    EXPECT_GT(schema["pigments"].size(), 5u);
    EXPECT_EQ(schema["illuminants"].size(), 6u);
}

}  // namespace
}  // namespace nacre::studio
