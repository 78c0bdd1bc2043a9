#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

// What decides whether a request is answered at all, as functions of its texts.

namespace nacre::studio {

struct Target {
    std::string path;  ///< decoded
    std::map<std::string, std::string> query;
};

/// The path and the query of a request line, of at most kMaxTargetBytes.
/// @return none if it is not in origin form ("/path?key=value"), or an escape in it is wrong
std::optional<Target> parse_target(std::string_view target);
inline constexpr std::size_t kMaxTargetBytes = 4096;

/// 128 random bits in hexadecimal, of the system's generator.
/// @throws Error if it gives none
std::string new_token();

/// Whether two texts are equal, in a time that does not tell how far.
bool same_secret(std::string_view given, std::string_view secret);

/// Where a connection arrived at.
struct Place {
    std::string address;  ///< "127.0.0.1", "::1"
    unsigned short port = 0;
    bool loopback = true;
};

/// Whether a Host header names the place by its number, or a loopback by "localhost". Any other name
/// may be one that a stranger's page has had resolved to this machine.
bool is_host(std::string_view host, const Place& place);

/// Whether an Origin header, "http://HOST", has that host.
bool is_origin(std::string_view origin, std::string_view host);

/// Of the contents, by a file's name: "text/html; charset=utf-8".
std::string_view content_type(std::string_view path);

}  // namespace nacre::studio
