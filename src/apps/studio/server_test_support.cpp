#include "apps/studio/server_test_support.h"

#include <gtest/gtest.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cctype>

#include "nacre/core/file.h"
#include "nacre/nacre.h"

namespace nacre::studio {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = net::ip::tcp;

namespace {

tcp::endpoint place_of(const RunningServer& server) {
    return {net::ip::make_address("127.0.0.1"), server.port()};
}

}  // namespace

HttpAnswer RunningServer::get(const std::string& target,
                              const std::map<std::string, std::string>& fields,
                              const std::string& method, const std::string& body) const {
    net::io_context io;
    tcp::socket socket(io);
    socket.connect(place_of(*this));
    const http::verb verb = http::string_to_verb(method);
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
    HttpAnswer answer{parser.get().result_int(), {}, parser.get().body()};
    for (const auto& field : parser.get()) {
        std::string name(field.name_string());
        for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        answer.fields[name] = std::string(field.value());
    }
    return answer;
}

unsigned RunningServer::status_of(const std::string& request) const {
    net::io_context io;
    tcp::socket socket(io);
    socket.connect(place_of(*this));
    net::write(socket, net::buffer(request));
    beast::flat_buffer buffer;
    http::response<http::string_body> response;
    http::read(socket, buffer, response);
    return response.result_int();
}

HttpAnswer RunningServer::api(const std::string& target) const {
    return get(target + (target.find('?') == std::string::npos ? "?" : "&") + "token=" + token());
}

struct PageClient::Socket {
    net::io_context io;
    websocket::stream<tcp::socket, false> stream{io};
};

PageClient::PageClient(const RunningServer& server, const std::string& token,
                       const std::string& origin, const std::string& host)
    : socket_(std::make_unique<Socket>()) {
    auto& stream = socket_->stream;
    stream.next_layer().connect(place_of(server));
    stream.set_option(websocket::stream_base::decorator([&](websocket::request_type& request) {
        request.set(http::field::origin, origin.empty() ? "http://" + server.host() : origin);
    }));
    stream.read_message_max(std::size_t{1} << 30);
    websocket::response_type response;
    stream.handshake(response, host.empty() ? server.host() : host,
                     "/api/session?token=" + (token.empty() ? server.token() : token));
}

PageClient::~PageClient() = default;

void PageClient::send_text(const std::string& text) { socket_->stream.write(net::buffer(text)); }

Tree PageClient::read() {
    const std::string text = read_bytes();
    EXPECT_TRUE(socket_->stream.got_text());
    return Tree::parse(text);
}

std::string PageClient::read_bytes() {
    beast::flat_buffer buffer;
    socket_->stream.read(buffer);
    return beast::buffers_to_string(buffer.data());
}

Tree PageClient::read_until(const std::string& type) {
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

std::string red_gold() { return read_file(find_paint("red-gold")); }
Tree red_gold_tree() { return tree_of_toml(red_gold(), "red-gold.toml"); }

}  // namespace nacre::studio
