#include "apps/studio/messages/http_rules.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre::studio {

namespace {

std::optional<int> hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

std::optional<std::string> decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        if (i + 2 >= text.size()) return std::nullopt;
        const auto high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
        if (!high || !low) return std::nullopt;
        out += static_cast<char>(16 * *high + *low);
        i += 2;
    }
    return out;
}

}  // namespace

std::optional<Target> parse_target(std::string_view target) {
    if (target.empty() || target[0] != '/' || target.size() > kMaxTargetBytes) return std::nullopt;
    const std::size_t mark = target.find('?');
    const auto path = decoded(target.substr(0, mark));
    if (!path) return std::nullopt;
    Target parsed{*path, {}};
    if (mark == std::string_view::npos) return parsed;
    for (const std::string_view part : split(target.substr(mark + 1), '&')) {
        const std::size_t equals = part.find('=');
        const auto key = decoded(part.substr(0, equals));
        const auto value = equals == std::string_view::npos ? std::optional<std::string>("")
                                                            : decoded(part.substr(equals + 1));
        if (!key || !value) return std::nullopt;
        parsed.query.emplace(*key, *value);
    }
    return parsed;
}

std::string new_token() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
        throw Error("the system gives no random numbers");
    }
    std::string token;
    for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
    return token;
}

bool same_secret(std::string_view given, std::string_view secret) {
    // How long the secret is is no secret.
    if (given.size() != secret.size()) return false;
    volatile unsigned char difference = 0;
    for (std::size_t i = 0; i < secret.size(); ++i) {
        difference =
            static_cast<unsigned char>(difference | (static_cast<unsigned char>(given[i]) ^
                                                     static_cast<unsigned char>(secret[i])));
    }
    return difference == 0;
}

bool is_host(std::string_view host, const Place& place) {
    const bool v6 = place.address.find(':') != std::string::npos;
    const std::string number = v6 ? "[" + place.address + "]" : place.address;
    const std::string port = fmt::format(":{}", place.port);
    if (host == number + port) return true;
    if (place.port == 80 && host == number) return true;  // browsers leave it out
    return place.loopback && lowercase(host) == "localhost" + port;
}

bool is_origin(std::string_view origin, std::string_view host) {
    return lowercase(origin) == "http://" + lowercase(host);
}

std::string_view content_type(std::string_view path) {
    using Pair = std::pair<std::string_view, std::string_view>;
    static constexpr Pair kTypes[] = {{".html", "text/html; charset=utf-8"},
                                      {".js", "text/javascript; charset=utf-8"},
                                      {".css", "text/css; charset=utf-8"},
                                      {".svg", "image/svg+xml"},
                                      {".png", "image/png"},
                                      {".ico", "image/x-icon"},
                                      {".json", "application/json"},
                                      {".woff2", "font/woff2"},
                                      {".wasm", "application/wasm"}};
    for (const auto& [ending, type] : kTypes) {
        if (path.ends_with(ending)) return type;
    }
    return "application/octet-stream";
}

}  // namespace nacre::studio
