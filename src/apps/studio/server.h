#pragma once

#include <memory>
#include <optional>
#include <string>

#include "nacre/models/models.h"

// The server of the studio: a page, and an API for it (docs/studio-api.md), by HTTP and WebSocket.
// All that it computes comes through the front door (nacre/nacre.h).

namespace nacre::studio {

struct ServerSettings {
    std::string address = "127.0.0.1";  ///< to listen at, as a number
    unsigned short port = 0;            ///< 0: any that is free
    /// The recipe to start with, which names no files.
    std::optional<std::string> toml = {};
    /// By which the page reads paints at first (models::names_of_fitted()).
    std::string reading_model = std::string(models::names_of_fitted().front());
    bool prepare = false;  ///< makes the schema at once, which a page asks for first
};

/// Whether an address is one of this machine alone. @throws InputError if it is no address
bool is_loopback(const std::string& address);

class Server {
 public:
    /// Listens; answers once it runs.
    /// @throws InputError if it cannot listen there
    explicit Server(const ServerSettings& settings);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    unsigned short port() const;
    const std::string& token() const;
    /// What to open in a browser, with the token in it.
    std::string url() const;

    /// Answers until stop() or, if asked to heed them, SIGINT or SIGTERM; a second signal ends the
    /// program at once.
    void run(bool heed_signals = false);
    /// From any thread.
    void stop();

 private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace nacre::studio
