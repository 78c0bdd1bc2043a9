#include "apps/studio/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <map>
#include <thread>

#include "apps/studio/messages.h"
#include "apps/studio/page_files.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/io/recipe_file.h"
#include "nacre/nacre.h"
#include "nacre/render.h"

// The server from outside, through its sockets.

namespace nacre::studio {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = net::ip::tcp;
using testing::HasSubstr;
using testing::StartsWith;

/// A server that runs while the test does.
class RunningServer {
 public:
    explicit RunningServer(const ServerSettings& settings = {})
        : server_(settings), thread_([this] { server_.run(); }) {}
    ~RunningServer() {
        server_.stop();
        thread_.join();
    }

    std::string host() const { return "127.0.0.1:" + std::to_string(server_.port()); }
    const std::string& token() const { return server_.token(); }
    tcp::endpoint place() const { return {net::ip::make_address("127.0.0.1"), server_.port()}; }

    using Fields = std::map<std::string, std::string>;
    http::response<http::string_body> get(const std::string& target, const Fields& fields = {},
                                          http::verb verb = http::verb::get,
                                          const std::string& body = "") const {
        net::io_context io;
        tcp::socket socket(io);
        socket.connect(place());
        http::request<http::string_body> request(verb, target, 11, body);
        request.set(http::field::host, host());
        request.prepare_payload();
        for (const auto& [name, value] : fields) request.set(name, value);
        boost::system::error_code error;
        http::write(socket, request, error);  // a refusal may come before all of it
        beast::flat_buffer buffer;
        http::response_parser<http::string_body> parser;
        parser.body_limit(std::uint64_t{1} << 30);
        parser.skip(verb == http::verb::head);
        http::read(socket, buffer, parser);
        return parser.release();
    }
    http::response<http::string_body> api(const std::string& target) const {
        return get(target + (target.find('?') == std::string::npos ? "?" : "&") +
                   "token=" + token());
    }

 private:
    Server server_;
    std::thread thread_;
};

/// A page's end of the session.
class PageClient {
 public:
    explicit PageClient(const RunningServer& server, const std::string& token = "",
                        const std::string& origin = "", const std::string& host = "")
        : socket_(io_) {
        socket_.next_layer().connect(server.place());
        socket_.set_option(websocket::stream_base::decorator([&](websocket::request_type& r) {
            r.set(http::field::origin, origin.empty() ? "http://" + server.host() : origin);
        }));
        socket_.read_message_max(std::size_t{1} << 30);
        socket_.handshake(response_, host.empty() ? server.host() : host,
                          "/api/session?token=" + (token.empty() ? server.token() : token));
    }

    void send(const Tree& message) { socket_.write(net::buffer(message.dump())); }
    void send_text(const std::string& text) { socket_.write(net::buffer(text)); }

    Tree read() {
        const std::string text = read_bytes();
        EXPECT_TRUE(socket_.got_text());
        return Tree::parse(text);
    }
    std::string read_bytes() {
        beast::flat_buffer buffer;
        socket_.read(buffer);
        return beast::buffers_to_string(buffer.data());
    }
    /// The next answer of a type; others are passed over.
    Tree read_until(const std::string& type) {
        for (;;) {
            Tree answer = read();
            if (answer.contains("binary") && answer["type"] != type) read_bytes();
            if (answer["type"] == type) return answer;
            if (answer["type"] == "error") {
                ADD_FAILURE() << answer.dump();
                return answer;
            }
        }
    }

 private:
    net::io_context io_;
    websocket::stream<tcp::socket> socket_;
    websocket::response_type response_;
};

std::string red_gold() { return read_file(find_paint("red-gold")); }
Tree red_gold_tree() { return tree_of_toml(red_gold(), "red-gold.toml"); }

// ------------------------------------------------------------------------------------ doors

TEST(StudioServer, ServesThePageAndNothingElse) {
    const RunningServer server;
    ASSERT_FALSE(page_files().empty());
    const auto page = server.get("/");
    EXPECT_EQ(page.result_int(), 200u);
    EXPECT_THAT(std::string(page[http::field::content_type]), StartsWith("text/html"));
    EXPECT_THAT(std::string(page["Content-Security-Policy"]), HasSubstr("default-src 'self'"));
    EXPECT_EQ(std::string(page["Referrer-Policy"]), "no-referrer");
    EXPECT_EQ(page.body(), std::ranges::find(page_files(), "/index.html", &PageFile::path)->bytes);
    for (const char* path : {"/etc/passwd", "/../server.cpp", "/%2e%2e/%2e%2e/etc/passwd",
                             "/page/index.html", "//etc/passwd", "/index.html%00"}) {
        EXPECT_EQ(server.get(path).result_int(), 404u) << path;
    }
    EXPECT_EQ(server.get("/%zz").result_int(), 400u);
    EXPECT_EQ(server.get("/" + std::string(5000, 'a')).result_int(), 400u);
    EXPECT_EQ(server.get("/", {}, http::verb::post, "x").result_int(), 405u);
    const auto head = server.get("/", {}, http::verb::head);
    EXPECT_EQ(head.result_int(), 200u);
    EXPECT_EQ(std::string(head[http::field::content_length]), std::to_string(page.body().size()));
}

TEST(StudioServer, RefusesOtherHostsTokensAndOrigins) {
    const RunningServer server;
    const std::string port = server.host().substr(server.host().find(':'));
    for (const std::string& host :
         std::vector<std::string>{"evil.example", "evil.example" + port, "127.0.0.1", "127.0.0.1:1",
                                  "127.0.0.2" + port, ""}) {
        EXPECT_EQ(server.get("/", {{"Host", host}}).result_int(), 403u) << host;
    }
    EXPECT_EQ(server.get("/", {{"Host", "localhost" + port}}).result_int(), 200u);

    const std::string shape = "/api/shape/panel";
    EXPECT_EQ(server.get(shape).result_int(), 401u);
    EXPECT_EQ(server.get(shape + "?token=").result_int(), 401u);
    EXPECT_EQ(server.get(shape + "?token=" + std::string(32, '0')).result_int(), 401u);
    EXPECT_EQ(server.get(shape + "?token=" + server.token() + "0").result_int(), 401u);
    EXPECT_EQ(server.get(shape + "?token=" + server.token()).result_int(), 200u);
    EXPECT_EQ(server.get(shape, {{"X-Nacre-Token", server.token()}}).result_int(), 200u);
    EXPECT_EQ(server.token().size(), 32u);
    EXPECT_NE(server.token(), RunningServer().token());

    EXPECT_NO_THROW(PageClient{server});
    EXPECT_ANY_THROW(PageClient(server, "wrong"));
    EXPECT_ANY_THROW(PageClient(server, "", "http://evil.example"));
    EXPECT_ANY_THROW(PageClient(server, "", "null"));
    EXPECT_ANY_THROW(PageClient(server, "", "http://evil.example", "evil.example"));
}

TEST(StudioServer, RefusesWhatIsTooLarge) {
    const RunningServer server;
    const auto large = server.get("/", {{"X-Large", std::string(20'000, 'x')}});
    EXPECT_EQ(large.result_int(), 431u);
    const auto body = server.get("/", {{"Content-Length", "100000000"}});
    EXPECT_EQ(body.result_int(), 413u);
    PageClient page(server);
    // The server ends the session, and goes on with others.
    EXPECT_ANY_THROW({
        page.send_text(std::string(kMaxMessageBytes + 1, ' '));
        page.read();
    });
    EXPECT_EQ(server.get("/").result_int(), 200u);
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

// -------------------------------------------------------------------------------- the paint

TEST(StudioServer, ReadingsAreThoseOfMeasure) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "open"}, {"id", 1}, {"toml", red_gold()}});
    const Tree opened = page.read();
    EXPECT_EQ(opened["type"], "recipe");
    EXPECT_EQ(opened["id"], 1);
    EXPECT_EQ(opened["toml"], red_gold());

    page.send({{"type", "paint"},
               {"id", "two"},
               {"recipe", opened["tree"]},
               {"geometries", "byk-mac"},
               {"illuminant", "D65"},
               {"observer", "10"}});
    const Tree recipe = page.read(), readings = page.read(), done = page.read();
    EXPECT_EQ(recipe["type"], "recipe");
    EXPECT_EQ(recipe["toml"], red_gold());
    EXPECT_EQ(readings["type"], "readings");
    EXPECT_EQ(readings["id"], "two");
    EXPECT_EQ(done, Tree({{"type", "done"}, {"id", "two"}}));
    const Readings measured =
        open(find_paint("red-gold"))
            .measure(geometries("byk-mac"),
                     {.illuminant = Illuminant::D65, .observer = Observer::cie1964_10deg});
    EXPECT_EQ(readings["csv"].get<std::string>(), measured.csv());
    ASSERT_EQ(readings["lab"].size(), measured.measurement.readings.size());
    EXPECT_EQ(readings["lab"][0][1].get<double>(), measured.measurement.readings[0].lab[1]);
    EXPECT_EQ(readings["reflectance"][5].size(), readings["wavelengths_nm"].size());
    EXPECT_TRUE(readings["standard"].is_null());
    ASSERT_GT(recipe["numbers"].size(), 5u);
    EXPECT_LT(recipe["numbers"][0]["min"].get<double>(), recipe["numbers"][0]["max"].get<double>());
}

TEST(StudioServer, OfManyMessagesTheLastIsAnswered) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    constexpr int kMessages = 100;
    for (int i = 1; i <= kMessages; ++i) {
        tree["layer"][0]["thickness_um"] = 10 + 0.1 * i;
        page.send({{"type", "paint"}, {"id", i}, {"recipe", tree}});
    }
    int answers = 0, last = 0;
    Tree readings;
    while (last != kMessages) {
        const Tree recipe = page.read_until("recipe");
        readings = page.read_until("readings");
        ASSERT_GT(readings["id"].get<int>(), last);
        last = readings["id"];
        EXPECT_EQ(recipe["id"], last);
        EXPECT_EQ(recipe["tree"]["layer"][0]["thickness_um"].get<double>(), 10 + 0.1 * last);
        ++answers;
    }
    EXPECT_LT(answers, kMessages / 2);
    const Paint same = open_text(toml_of_tree(tree), "recipe.toml");
    EXPECT_EQ(readings["csv"].get<std::string>(), same.measure().csv());
}

TEST(StudioServer, TheShaderIsThatOfTheSolvedPaint) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    for (const int thickness : {15, 20}) {
        tree["layer"][0]["thickness_um"] = thickness;
        const auto lamp = thickness == 15 ? Illuminant::D65 : Illuminant::FL11;
        page.send({{"type", "paint"},
                   {"id", thickness},
                   {"recipe", tree},
                   {"shader", true},
                   {"lamp", spectra::name(lamp)}});
        page.read_until("readings");
        const Tree told = page.read();
        ASSERT_EQ(told["type"], "shader");
        const std::string bytes = page.read_bytes();
        EXPECT_EQ(page.read()["type"], "done");
        const auto shader = exchange::make_live_webgl_shader(
            open_text(toml_of_tree(tree), "recipe.toml").solved(), 0, lamp);
        EXPECT_EQ(told["program"], shader.program);
        // Its text is sent once: the second paint has the same structure.
        EXPECT_EQ(told.contains("glsl"), thickness == 15);
        if (thickness == 15) {
            EXPECT_EQ(told["glsl"], shader.glsl);
        }
        ASSERT_EQ(told["uniforms"].size(), shader.uniforms.size());
        EXPECT_EQ(told["uniforms"][0]["values"].get<std::vector<float>>(),
                  shader.uniforms[0].values);
        std::size_t at = 0;
        ASSERT_EQ(told["binary"].size(), shader.textures.size());
        for (std::size_t i = 0; i < shader.textures.size(); ++i) {
            const auto& texture = shader.textures[i];
            std::size_t count = 1;
            for (const Tree& side : told["binary"][i]["shape"]) count *= side.get<std::size_t>();
            ASSERT_EQ(count, texture.rgba.size());
            EXPECT_EQ(std::memcmp(bytes.data() + at, texture.rgba.data(), 2 * count), 0);
            at += 2 * count;
        }
        EXPECT_EQ(at, bytes.size());
    }
}

TEST(StudioServer, ErrorsSayWhere) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    tree["layer"][0]["thickness_um"] = -3;
    page.send({{"type", "paint"}, {"id", 1}, {"recipe", tree}});
    const Tree error = page.read();
    EXPECT_EQ(error["type"], "error");
    EXPECT_EQ(error["id"], 1);
    EXPECT_EQ(error["about"], "paint");
    EXPECT_EQ(error["key"], "layer[0].thickness_um");
    EXPECT_EQ(error["range"], "(0, 1000000] um");
    // The line is that of the text that the tree becomes.
    const std::string toml = toml_of_tree(tree);
    std::size_t start = 0;
    for (int line = 1; line < error["line"]; ++line) start = toml.find('\n', start) + 1;
    EXPECT_THAT(toml.substr(start), StartsWith("thickness_um = -3\n"));

    page.send_text("nonsense");
    EXPECT_THAT(page.read()["message"], HasSubstr("is not JSON"));
    page.send({{"type", "paint"}, {"id", 2}, {"recipe", red_gold_tree()}});
    EXPECT_EQ(page.read_until("done")["id"], 2);
}

TEST(StudioServer, ARecipeFromThePageNamesNoFiles) {
    const RunningServer server;
    PageClient page(server);
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "secret.csv";
    write_file_atomically(file, "wavelength_nm,n,k\n300,1.6,0\n800,1.5,0\n");
    const auto refused = [&](const Tree& recipe) {
        page.send({{"type", "paint"}, {"id", 1}, {"recipe", recipe}});
        const Tree answer = page.read();
        EXPECT_EQ(answer["type"], "error") << answer.dump();
        page.send({{"type", "open"}, {"id", 2}, {"toml", toml_of_tree(recipe)}});
        EXPECT_EQ(page.read()["type"], "error");
    };
    Tree tree = red_gold_tree();
    tree["ior"] = file.string();
    refused(tree);
    tree = red_gold_tree();
    tree["layer"][0]["pigment"] =
        Tree::array({{{"from", file.string()}, {"volume_fraction", 0.1}}});
    refused(tree);
    tree = red_gold_tree();
    tree["substrate"] = {{"reflectance", file.string()}};
    refused(tree);
    // What it names by itself in the program's data is no such file.
    tree = red_gold_tree();
    tree["layer"][0]["pigment"] =
        Tree::array({{{"from", "carbon-black-fine"}, {"volume_fraction", 0.001}}});
    page.send({{"type", "paint"}, {"id", 3}, {"recipe", tree}});
    EXPECT_EQ(page.read_until("done")["id"], 3);
}

TEST(StudioServer, ComparesWithAStandard) {
    const RunningServer server;
    PageClient page(server);
    const Paint other = open(find_paint("tio2-mica-80"));
    const Readings standard = other.measure(geometries("45as15,45as45,45as110"));
    page.send({{"type", "standard"}, {"id", 1}, {"csv", standard.csv()}, {"name", "panel.csv"}});
    const Tree told = page.read();
    ASSERT_EQ(told["type"], "standard") << told.dump();
    EXPECT_EQ(told["geometries"], Tree({"45as15", "45as45", "45as110"}));

    page.send(
        {{"type", "paint"}, {"id", 2}, {"recipe", red_gold_tree()}, {"tolerance", {{"limit", 1}}}});
    const Tree compared = page.read_until("readings")["standard"];
    const Readings sample = open(find_paint("red-gold")).measure(geometries("byk-mac"));
    const auto difference = measure::difference(standard.measurement, sample.measurement);
    ASSERT_EQ(compared["delta_e_2000"].size(), 6u) << compared.dump();
    EXPECT_TRUE(compared["delta_e_2000"][0].is_null());  // 45as-15 was not read
    EXPECT_DOUBLE_EQ(compared["delta_e_2000"][1].get<double>(), difference.angles[0].delta_e_2000);
    EXPECT_DOUBLE_EQ(compared["mean"].get<double>(), difference.mean_delta_e_2000);
    EXPECT_EQ(compared["passes"][1], false);
    EXPECT_EQ(compared["all_pass"], false);

    page.send({{"type", "standard"}, {"id", 3}, {"csv", "no,colours\n1,2\n"}});
    EXPECT_EQ(page.read_until("done")["id"], 2);
    EXPECT_EQ(page.read()["type"], "error");
    page.send({{"type", "standard"}, {"id", 4}, {"csv", nullptr}});
    EXPECT_TRUE(page.read()["name"].is_null());
}

TEST(StudioServer, FitsFromThePage) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = tree_of_toml(read_file(find_paint("tio2-mica-80")), "recipe.toml");
    const std::string key = "layer[0].flakes[0].coats[0].thickness_nm";
    const Paint wanted = open(find_paint("tio2-mica-80")).with(key, 95);
    page.send({{"type", "standard"}, {"id", 1}, {"csv", wanted.measure().csv()}});
    EXPECT_EQ(page.read()["type"], "standard");
    page.send({{"type", "fit"}, {"id", 2}, {"recipe", tree}, {"free", {key}}, {"starts", 1}});
    const Tree found = page.read_until("matches");
    EXPECT_EQ(found["id"], 2);
    EXPECT_EQ(found["matched"], true);
    const Tree& best = found["matches"][0];
    EXPECT_NEAR(best["parameters"][0]["value"].get<double>(), 95, 0.1);
    EXPECT_EQ(best["parameters"][0]["unit"], "nm");
    EXPECT_NEAR(best["recipe"]["layer"][0]["flakes"][0]["coats"][0]["thickness_nm"].get<double>(),
                95, 0.1);
    EXPECT_EQ(best["recipe"].dump(),
              tree_of_toml(best["toml"].get<std::string>(), "recipe.toml").dump());
}

TEST(StudioServer, AnAtlasIsThePaintAtEachValue) {
    const RunningServer server;
    PageClient page(server);
    const std::string key = "layer[0].flakes[0].coats[0].thickness_nm";
    page.send({{"type", "atlas"},
               {"id", 1},
               {"recipe", red_gold_tree()},
               {"key", key},
               {"values", {200, 220}},
               {"geometries", "45as15,45as45"}});
    const Tree atlas = page.read_until("atlas");
    ASSERT_EQ(atlas["lab"].size(), 2u);
    const Measurement other = open(find_paint("red-gold"))
                                  .with(key, 220)
                                  .measure(geometries("45as15,45as45"))
                                  .measurement;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(atlas["lab"][1][1][c].get<double>(), other.readings[1].lab[c], 1e-9);
    }
    page.send({{"type", "atlas"}, {"id", 2}, {"recipe", red_gold_tree()}, {"values", {1}}});
    EXPECT_EQ(page.read()["type"], "error");
}

TEST(StudioServer, AFitStopsWhenItIsTold) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "standard"}, {"id", 1}, {"csv", open(find_paint("ruby")).measure().csv()}});
    EXPECT_EQ(page.read()["type"], "standard");
    page.send({{"type", "fit"},
               {"id", 2},
               {"recipe", red_gold_tree()},
               {"free", {"*"}},
               {"starts", 256}});
    page.read_until("progress");
    page.send({{"type", "stop"}, {"id", 3}, {"what", "fit"}});
    const Tree stopped = page.read_until("stopped");
    EXPECT_EQ(stopped["id"], 3);
    EXPECT_EQ(stopped["jobs"], 1);
    // The lane is free for the next, which answers at once that no number is named so.
    page.send({{"type", "fit"}, {"id", 4}, {"recipe", red_gold_tree()}, {"free", {"nothing"}}});
    Tree answer = page.read();
    while (answer["type"] == "progress") answer = page.read();
    EXPECT_EQ(answer["type"], "error");
    EXPECT_EQ(answer["id"], 4);
}

// ------------------------------------------------------------------------------ the picture

TEST(StudioServer, PicturesConvergeToThatOfTheCommandLine) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "render"},
               {"id", 1},
               {"recipe", red_gold_tree()},
               {"scene", {{"shape", "ball"}, {"light", "studio"}}},
               {"width", 24},
               {"height", 16},
               {"samples", 6},
               {"linear", true}});
    std::vector<int> samples;
    std::string bytes;
    while (samples.empty() || samples.back() != 6) {
        const Tree picture = page.read_until("picture");
        samples.push_back(picture["samples"]);
        EXPECT_EQ(picture["of"], 6);
        bytes = page.read_bytes();
        ASSERT_EQ(bytes.size(), 24u * 16 * 3 * 5);
    }
    // Those that a slow reader missed aside.
    EXPECT_THAT(samples, testing::IsSubsetOf({1, 4, 6}));
    const Scene scene(scene_of({}), {.slot = open(find_paint("red-gold"))});
    const Picture whole =
        scene.render({.width = 24, .height = 16, .samples_per_pixel = 6, .noise = true});
    std::vector<float> linear(24 * 16 * 3);
    std::memcpy(linear.data(), bytes.data() + linear.size(), 4 * linear.size());
    EXPECT_EQ(linear, whole.result.rgb);
}

TEST(StudioServer, ShapesAndLightsAreWhole) {
    const RunningServer server;
    for (const std::string& name : shape_names()) {
        const auto answer = server.api("/api/shape/" + name);
        ASSERT_EQ(answer.result_int(), 200u) << name;
        std::uint32_t counts[2];
        ASSERT_GE(answer.body().size(), sizeof counts);
        std::memcpy(counts, answer.body().data(), sizeof counts);
        EXPECT_GT(counts[1], 1u) << name;
        EXPECT_EQ(answer.body().size(), 8 + 32 * counts[0] + 12 * counts[1]) << name;
    }
    for (const std::string& name : light_names()) {
        const auto answer = server.api("/api/light/" + name + "?width=32");
        ASSERT_EQ(answer.result_int(), 200u) << name;
        const std::string& body = answer.body();
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
    EXPECT_EQ(server.api("/api/shape/cube").result_int(), 404u);
    EXPECT_EQ(server.api("/api/light/sun?width=1000000").result_int(), 400u);
    EXPECT_EQ(server.api("/api/light/sun?width=x").result_int(), 400u);
    EXPECT_EQ(server.api("/api/other").result_int(), 404u);
}

TEST(StudioServer, TheSchemaSaysWhatShips) {
    const RunningServer server({.toml = red_gold()});
    const auto answer = server.api("/api/schema");
    ASSERT_EQ(answer.result_int(), 200u);
    const Tree schema = Tree::parse(answer.body());
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
    EXPECT_GT(schema["materials"].size(), 20u);
    EXPECT_GT(schema["pigments"].size(), 5u);
    EXPECT_EQ(schema["illuminants"].size(), 6u);
}

}  // namespace
}  // namespace nacre::studio
