#include "nacre/io/toml_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_columns.h"

namespace nacre::io {

namespace {

constexpr std::size_t kMaxComplaintLength = 200;  // of the TOML parser, which quotes the text

std::string_view line_of(std::string_view text, std::size_t line) {
    for (; line > 1; --line) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    return text.substr(0, text.find('\n'));
}

/// The key that a line begins with, as in "reflectance: "; nothing where it begins otherwise.
std::string key_on_line(std::string_view text, std::size_t line) {
    text = line_of(text, line);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return {};
    const std::string_view key = trimmed(text.substr(0, equals));
    const bool bare =
        !key.empty() && key.size() <= kMaxShownLength &&
        std::all_of(key.begin(), key.end(), [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '.';
        });
    return bare ? std::string(key) + ": " : std::string();
}

/// What is meant by a number such as 0,03, of which TOML reads the 0 alone: "x = 0,03: ...". Nothing
/// where the line has none.
std::string decimal_comma_on_line(std::string_view text, std::size_t line) {
    text = line_of(text, line);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    for (std::size_t equals = text.find('='); equals != std::string_view::npos;
         equals = text.find('=', equals + 1)) {
        const std::string_view value = trimmed(text.substr(equals + 1));
        std::size_t comma = value.starts_with('-') || value.starts_with('+') ? 1 : 0;
        const std::size_t first = comma;
        while (comma < value.size() && is_digit(value[comma])) ++comma;
        if (comma == first || comma + 1 >= value.size() || value[comma] != ',' ||
            !is_digit(value[comma + 1])) {
            continue;
        }
        std::size_t end = comma + 1;
        while (end < value.size() && is_digit(value[end])) ++end;
        const std::string number(value.substr(0, end));
        return fmt::format("{}: a number has a decimal point: {}", excerpt(number),
                           excerpt(replaced(number, ",", ".")));
    }
    return {};
}

/// Refuses deep nesting by one pass over the characters. It need only be right about text that is
/// TOML so far: the parser, which comes next, stops at the first character that is not.
class NestingScan {
 public:
    NestingScan(std::string_view text, const std::string& filename)
        : text_(text), filename_(filename) {}

    void run() {
        while (position_ < text_.size()) {
            switch (text_[position_]) {
                case '#':
                    position_ = std::min(text_.find('\n', position_), text_.size());
                    continue;
                case '"':
                case '\'':
                    skip_string();
                    continue;
                case '.':
                    if (++dots_ >= kMaxTomlNesting) refuse("a key of more than {} parts");
                    break;
                case '[':
                case '{':
                    dots_ = 0;
                    if (++depth_ > kMaxTomlNesting) refuse("nested more than {} deep");
                    break;
                case ']':
                case '}':
                    --depth_;
                    break;
                case '\n':
                case ',':
                case '=':
                    dots_ = 0;
                    break;
                default:
                    break;
            }
            ++position_;
        }
    }

 private:
    /// To behind the string that starts here: "...", '...', or either with three quotes.
    void skip_string() {
        const char quote = text_[position_];
        const std::string three(3, quote);
        const bool lines = text_.substr(position_).starts_with(three);
        const std::string_view end = lines ? std::string_view(three) : text_.substr(position_, 1);
        position_ += end.size();
        while (position_ < text_.size() && !text_.substr(position_).starts_with(end)) {
            if (!lines && text_[position_] == '\n') return;  // not TOML
            if (quote == '"' && text_[position_] == '\\') ++position_;
            ++position_;
        }
        position_ = std::min(position_ + end.size(), text_.size());
        // Up to two quotes may stand before the three that end a text.
        for (int i = 0; lines && i < 2 && position_ < text_.size() && text_[position_] == quote;
             ++i)
            ++position_;
    }

    [[noreturn]] void refuse(fmt::format_string<const int&> why) const {
        const std::string_view before = text_.substr(0, position_);
        const auto line = 1 + std::count(before.begin(), before.end(), '\n');
        const std::size_t start = before.find_last_of('\n') + 1;  // npos + 1 is 0
        throw InputError(fmt::format("{}:{}:{}: {}", filename_, line, position_ - start + 1,
                                     fmt::format(why, kMaxTomlNesting)));
    }

    std::string_view text_;
    const std::string& filename_;
    std::size_t position_ = 0;
    int depth_ = 0, dots_ = 0;
};

}  // namespace

TomlDocument::TomlDocument(std::string_view text, std::string filename, References references,
                           std::optional<FileKind> kind)
    : filename_(std::move(filename)), references_(std::move(references)) {
    if (text.size() > kMaxTextBytes) {
        throw InputError(fmt::format("{}: has {} bytes; at most {} are allowed", filename_,
                                     text.size(), kMaxTextBytes));
    }
    if (references_.may_quote()) refuse_other_kind(kind ? *kind : kind_of_bytes(text));
    require_utf8(text, filename_);
    NestingScan(text, filename_).run();
    try {
        root_ = toml::parse(text, filename_);
    } catch (const toml::parse_error& error) {
        const std::string where = place(error.source());
        if (!references_.may_quote()) throw InputError(where + "is not TOML");
        const std::size_t line = error.source().begin.line;
        const std::string comma = decimal_comma_on_line(text, line);
        if (comma.empty() && !is_toml_line(first_csv_line(text))) {
            throw InputError(
                fmt::format("{}the file is of no kind that is read here; taken for TOML: {}", where,
                            excerpt(error.description(), kMaxComplaintLength, ' ')));
        }
        throw InputError(
            where + key_on_line(text, line) +
            (comma.empty() ? excerpt(error.description(), kMaxComplaintLength, ' ') : comma));
    }
}

std::shared_ptr<TomlDocument> TomlDocument::of(const TypedFile& file) {
    if (file.toml) return file.toml;
    return std::make_shared<TomlDocument>(file.bytes, file.name, file.references);
}

void TomlDocument::refuse_other_kind(FileKind kind) const {
    // An empty text is an empty table, and its reader says what it lacks.
    if (kind == FileKind::text || kind == FileKind::empty || kind == FileKind::other_encoding) {
        return;
    }
    throw InputError(
        fmt::format("{}: is {}; a text in TOML is needed here", filename_, words_for(kind)));
}

std::string TomlDocument::place(const toml::source_region& where) const {
    return fmt::format("{}:{}:{}: ", filename_, where.begin.line, where.begin.column);
}

void TomlDocument::note(const std::string& key, const toml::source_region& where) {
    places_.insert_or_assign(key, where);
}

std::string TomlDocument::location(std::string key) const {
    while (!key.empty()) {
        if (const auto found = places_.find(key); found != places_.end()) {
            return place(found->second);
        }
        const std::size_t cut = key.find_last_of(".[");
        key.resize(cut == std::string::npos ? 0 : cut);
    }
    return filename_ + ": ";
}

void rethrow_with_location(const TomlDocument& document, const std::string& message) {
    const std::string key = message.substr(0, message.find_first_of(" :"));
    throw InputError(document.location(key) + message);
}

}  // namespace nacre::io
