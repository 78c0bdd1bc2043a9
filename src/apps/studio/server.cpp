#include "apps/studio/server.h"

#include <fmt/format.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <utility>

#include "apps/studio/http_answers.h"
#include "apps/studio/messages/http_rules.h"
#include "apps/studio/messages/messages.h"
#include "apps/studio/session.h"
#include "nacre/core/error.h"

// The only file that knows sockets. One thread reads and writes all of them and does no other work;
// pages are answered by the lanes of a workshop, requests by a thread of their own.

namespace nacre::studio {

namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = net::ip::tcp;
using boost::system::error_code;

/// A page takes two or three; hardly anybody has so many of them open.
constexpr std::size_t kMaxConnections = 200;
constexpr auto kRequestTimeout = std::chrono::seconds(30);
constexpr std::uint32_t kMaxHeaderBytes = 16 << 10;
constexpr int kBacklog = 128;

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

/// Everything that connections share. They hold it by reference: the server outlives them.
struct Shared {
    std::string token;
    std::atomic<bool> ending = false;
    std::size_t connections = 0;
    ClientId next_client = 1;
    HttpAnswers answers;
    Workshop workshop;
    net::io_context io{1};  // holds the connections
    net::thread_pool requests{1};
};

/// Counts a connection for as long as it lives, on the thread of the sockets.
class Counted {
 public:
    explicit Counted(Shared& shared) : shared_(shared) { ++shared_.connections; }
    ~Counted() { --shared_.connections; }
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

 private:
    Shared& shared_;
};

// ---------------------------------------------------------------------------------- a page

class Page : public std::enable_shared_from_this<Page> {
 public:
    Page(tcp::socket socket, Shared& shared)
        : shared_(shared), counted_(shared), socket_(std::move(socket)) {}

    void accept(const Request& request) {
        socket_.auto_fragment(false);  // pictures and textures would go out 4 kB at a time
        auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
        timeout.keep_alive_pings = true;
        socket_.set_option(timeout);
        socket_.read_message_max(kMaxMessageBytes);
        socket_.async_accept(request, [self = shared_from_this()](error_code error) {
            if (!error) self->begin();
        });
    }

 private:
    void begin() {
        session_.emplace(shared_.next_client++, shared_.workshop,
                         [weak = weak_from_this(), &io = shared_.io](Answer answer) {
                             net::post(io, [weak, answer = std::move(answer)]() mutable {
                                 if (const auto self = weak.lock()) self->send(std::move(answer));
                             });
                         });
        read();
    }

    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
            self->received(error);
        });
    }

    void received(error_code error) {
        if (error) {
            session_.reset();  // its jobs end
            return;
        }
        if (socket_.got_text()) {
            session_->receive({static_cast<const char*>(buffer_.data().data()), buffer_.size()});
        } else {
            session_->receive("");  // is told that this is no JSON
        }
        // A large message does not keep its memory.
        buffer_ = {};
        read();
    }

    void send(Answer answer) {
        if (!session_) return;
        outbox_.add(std::move(answer));
        if (!sending_) send_next();
    }

    void send_next() {
        sending_ = outbox_.take();
        frame_ = 0;
        binary_ = false;
        write();
    }

    /// The frame that is next, the binary part of one behind its text.
    void write() {
        if (!sending_) return;
        if (frame_ == sending_->frames.size()) {
            send_next();
            return;
        }
        const Frame& frame = sending_->frames[frame_];
        socket_.text(!binary_);
        socket_.async_write(net::buffer(binary_ ? frame.binary : frame.text),
                            [self = shared_from_this()](error_code error, std::size_t) {
                                if (error) return;  // read() is told too
                                self->written();
                            });
    }

    void written() {
        binary_ = !binary_ && !sending_->frames[frame_].binary.empty();
        if (!binary_) ++frame_;
        write();
    }

    Shared& shared_;
    Counted counted_;
    websocket::stream<beast::tcp_stream, false> socket_;  // nothing is compressed on this machine
    beast::flat_buffer buffer_;
    std::optional<Session> session_;
    Outbox outbox_;
    std::optional<Answer> sending_;
    std::size_t frame_ = 0;
    bool binary_ = false;
};

// ------------------------------------------------------------------------------- a request

class Connection : public std::enable_shared_from_this<Connection> {
 public:
    Connection(tcp::socket socket, Shared& shared)
        : shared_(shared), counted_(shared), stream_(std::move(socket)) {
        error_code error;
        const auto local = stream_.socket().local_endpoint(error);
        place_ = {local.address().to_string(), local.port(), local.address().is_loopback()};
        // Answers are small, and each is waited for.
        stream_.socket().set_option(tcp::no_delay(true), error);
    }

    void read() {
        parser_.emplace();
        parser_->header_limit(kMaxHeaderBytes);
        parser_->body_limit(kMaxMessageBytes);
        stream_.expires_after(kRequestTimeout);
        http::async_read(
            stream_, buffer_, *parser_,
            [self = shared_from_this()](error_code error, std::size_t) { self->received(error); });
    }

 private:
    void received(error_code error) {
        if (error == http::error::body_limit) return refuse(413, "the body is too large");
        if (error == http::error::header_limit) return refuse(431, "the header is too large");
        if (error) return close();
        const Request& request = parser_->get();
        keep_alive_ = request.keep_alive();
        head_ = request.method() == http::verb::head;

        if (request.count(http::field::host) > 1) {  // which of them is believed is not to matter
            return refuse(400, "there must be one Host header");
        }
        const std::string host(request[http::field::host]);
        if (!is_host(host, place_)) {
            return refuse(403, "the Host header must name the address and port of this server");
        }
        const auto target = parse_target({request.target().data(), request.target().size()});
        if (!target) return refuse(400, "the path cannot be read");
        if (target->path.starts_with("/api/")) {
            const auto in_query = target->query.find("token");
            const std::string token = in_query == target->query.end()
                                          ? std::string(request["X-Nacre-Token"])
                                          : in_query->second;
            if (!same_secret(token, shared_.token)) {
                return refuse(401,
                              "the token is missing or wrong; it is in the address that "
                              "nacre studio printed");
            }
        }
        if (websocket::is_upgrade(request)) {
            if (target->path != "/api/session") return refuse(404, "the session is /api/session");
            if (!is_origin(std::string(request[http::field::origin]), host)) {
                return refuse(403, "the Origin header must be that of the page of this server");
            }
            stream_.expires_never();  // the session has its own
            std::make_shared<Page>(stream_.release_socket(), shared_)->accept(request);
            return;
        }
        if (request.method() != http::verb::get && !head_) {
            return refuse(405, "only GET is answered");
        }
        answer(*target);
    }

    /// On the thread of requests: a schema or a picture of the sky takes a moment.
    void answer(Target target) {
        net::post(shared_.requests, [self = shared_from_this(), target = std::move(target)] {
            HttpAnswer answer =
                self->shared_.answers.answer(target, [&] { return self->shared_.ending.load(); });
            net::post(self->shared_.io, [self, answer = std::move(answer)]() mutable {
                self->write(std::move(answer));
            });
        });
    }

    void refuse(unsigned status, const std::string& why) {
        keep_alive_ = false;
        write(error_answer(status, why));
    }

    void write(HttpAnswer answer) {
        response_.emplace();
        Response& response = *response_;
        response.version(11);
        response.result(answer.status);
        response.set(http::field::content_type, answer.type);
        for (const auto& [name, value] : kSecurityHeaders) response.set(name, value);
        if (answer.status == 405) response.set(http::field::allow, "GET, HEAD");
        response.keep_alive(keep_alive_);
        response.body() = std::move(answer.body);
        response.prepare_payload();
        if (head_) response.body().clear();  // its length stays
        stream_.expires_after(kRequestTimeout);
        http::async_write(stream_, response,
                          [self = shared_from_this()](error_code error, std::size_t) {
                              if (error || !self->keep_alive_) return self->close();
                              self->read();
                          });
    }

    void close() {
        error_code ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    }

    Shared& shared_;
    Counted counted_;
    beast::tcp_stream stream_;
    Place place_;
    beast::flat_buffer buffer_;
    std::optional<http::request_parser<http::string_body>> parser_;
    std::optional<Response> response_;
    bool keep_alive_ = false, head_ = false;
};

net::ip::address address_of(const std::string& text) {
    error_code error;
    const auto address = net::ip::make_address(text, error);
    if (error) {
        throw InputError(fmt::format("{}: is no address; must be one as 127.0.0.1 or ::1", text));
    }
    return address;
}

}  // namespace

// ------------------------------------------------------------------------------- the server

struct Server::State {
    explicit State(const ServerSettings& settings) : acceptor(shared.io) {
        const tcp::endpoint place(address_of(settings.address), settings.port);
        try {
            acceptor.open(place.protocol());
            acceptor.set_option(net::socket_base::reuse_address(true));
            acceptor.bind(place);
            acceptor.listen(kBacklog);
        } catch (const boost::system::system_error& error) {
            throw InputError(fmt::format("cannot listen at {} port {}: {}", settings.address,
                                         settings.port, error.code().message()));
        }
        shared.token = new_token();
        shared.answers.start_with(settings.toml, settings.reading_model);
        if (settings.prepare) {
            net::post(shared.requests, [this] {
                try {
                    shared.answers.prepare([this] { return shared.ending.load(); });
                } catch (const std::exception&) {  // whoever asks for it is told
                }
            });
        }
    }

    ~State() {
        // What works for the connections, before these go.
        shared.ending = true;
        shared.requests.join();
        shared.workshop.end();
    }

    void accept() {
        acceptor.async_accept([this](error_code error, tcp::socket socket) {
            if (error == net::error::operation_aborted) return;
            if (!error && shared.connections < kMaxConnections) {
                std::make_shared<Connection>(std::move(socket), shared)->read();
            }
            if (error) {  // as too many open files: not at once again
                retry.expires_after(std::chrono::milliseconds(100));
                retry.async_wait([this](error_code stopped) {
                    if (!stopped) accept();
                });
                return;
            }
            accept();
        });
    }

    Shared shared;
    tcp::acceptor acceptor;
    net::steady_timer retry{shared.io};
};

bool is_loopback(const std::string& address) { return address_of(address).is_loopback(); }

Server::Server(const ServerSettings& settings) : state_(std::make_unique<State>(settings)) {}
Server::~Server() = default;

unsigned short Server::port() const { return state_->acceptor.local_endpoint().port(); }
const std::string& Server::token() const { return state_->shared.token; }

std::string Server::url() const {
    const auto local = state_->acceptor.local_endpoint();
    const std::string address = local.address().to_string();
    return fmt::format("http://{}:{}/?token={}",
                       local.address().is_v6() ? "[" + address + "]" : address, local.port(),
                       token());
}

void Server::run(bool heed_signals) {
    net::io_context& io = state_->shared.io;
    net::signal_set signals(io);
    if (heed_signals) {
        signals.add(SIGINT);
        signals.add(SIGTERM);
        signals.async_wait([&](error_code error, int) {
            if (error) return;
            signals.clear();  // the next one ends the program
            stop();
        });
    }
    state_->accept();
    io.run();
}

void Server::stop() {
    state_->shared.ending = true;
    state_->shared.io.stop();
}

}  // namespace nacre::studio
