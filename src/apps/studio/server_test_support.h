#pragma once

#include <map>
#include <memory>
#include <string>
#include <thread>

#include "apps/studio/messages/recipe_tree.h"
#include "apps/studio/server.h"

// Only for tests: a server that runs, asked through its sockets. Beast stays in the .cpp.

namespace nacre::studio {

struct HttpAnswer {
    unsigned status = 0;
    std::map<std::string, std::string> fields;  ///< by name, in small letters
    std::string body;
};

/// A server that runs while the test does.
class RunningServer {
 public:
    explicit RunningServer(const ServerSettings& settings = {})
        : server_(settings), thread_([this] { server_.run(); }) {}
    ~RunningServer() {
        server_.stop();
        thread_.join();
    }

    std::string host() const { return "127.0.0.1:" + std::to_string(port()); }
    unsigned short port() const { return server_.port(); }
    const std::string& token() const { return server_.token(); }

    /// @param fields  of the request, in place of or beside those that a browser sends
    HttpAnswer get(const std::string& target, const std::map<std::string, std::string>& fields = {},
                   const std::string& method = "GET", const std::string& body = "") const;
    /// Of the answer to a request that is sent as it is.
    unsigned status_of(const std::string& request) const;
    /// With the token.
    HttpAnswer api(const std::string& target) const;

 private:
    Server server_;
    std::thread thread_;
};

/// A page's end of the session. Throws where the server refuses or ends it.
class PageClient {
 public:
    /// @param token, origin, host  empty: as the server expects
    explicit PageClient(const RunningServer& server, const std::string& token = "",
                        const std::string& origin = "", const std::string& host = "");
    ~PageClient();

    void send(const Tree& message) { send_text(message.dump()); }
    void send_text(const std::string& text);

    /// The next frame, which must be text.
    Tree read();
    std::string read_bytes();
    /// The next answer of a type; others are passed over.
    Tree read_until(const std::string& type);

 private:
    struct Socket;
    std::unique_ptr<Socket> socket_;
};

std::string red_gold();
Tree red_gold_tree();

}  // namespace nacre::studio
