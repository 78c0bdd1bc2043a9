#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "apps/studio/messages/http_rules.h"

// What GET requests are answered with, once they may be: the files of the page, and the API's data.

namespace nacre::studio {

struct HttpAnswer {
    unsigned status = 200;
    std::string type;  ///< of the contents
    std::string body;
};

/// {"error": why}.
HttpAnswer error_answer(unsigned status, const std::string& why);

/// Of every answer. The page takes scripts from here alone; styles stand in reports, which it shows.
/// The address holds the token, which is nobody else's business.
inline constexpr std::pair<const char*, const char*> kSecurityHeaders[] = {
    {"Content-Security-Policy",
     "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:; "
     "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
     "frame-ancestors 'none'"},
    {"X-Content-Type-Options", "nosniff"},
    {"Referrer-Policy", "no-referrer"},
    {"Cross-Origin-Resource-Policy", "same-origin"},
    {"Cross-Origin-Opener-Policy", "same-origin"},
    {"Cache-Control", "no-store"}};

class HttpAnswers {
 public:
    /// The recipe that the page shows first, and the model by which it reads paints at first.
    void start_with(std::optional<std::string> toml, std::string reading_model) {
        toml_ = std::move(toml);
        reading_model_ = std::move(reading_model);
    }

    /// From one thread at a time.
    /// @param ending  whether the server ends, so that no answer is wanted any more
    HttpAnswer answer(const Target& target, const std::function<bool()>& ending);
    /// Makes the schema before it is asked for.
    void prepare(const std::function<bool()>& ending);

 private:
    HttpAnswer api_answer(const Target& target, const std::function<bool()>& ending);

    std::optional<std::string> toml_;
    std::string reading_model_;
    std::string schema_;  // once it has been asked for
};

}  // namespace nacre::studio
