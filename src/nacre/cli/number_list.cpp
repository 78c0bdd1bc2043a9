#include "nacre/cli/number_list.h"

#include <charconv>
#include <cmath>

#include "nacre/cli/usage_error.h"

namespace nacre::cli {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find(separator, begin)) != std::string::npos;) {
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    parts.push_back(text.substr(begin));
    return parts;
}

double parse_number(const std::string& option, const std::string& text, const Range& range) {
    const char* first = text.data();
    const char* last = first + text.size();
    if (first != last && *first == '+') ++first;  // from_chars takes no plus sign
    double number = 0;
    const auto [end, error] = std::from_chars(first, last, number);
    if (error != std::errc() || end != last || !std::isfinite(number) || !range.contains(number)) {
        throw UsageError(
            fmt::format("{} = {}: must be a number in {}", option, text, range.text()));
    }
    return number;
}

std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const Range& range) {
    std::vector<double> numbers;
    const auto check_count = [&](double more) {
        if (static_cast<double>(numbers.size()) + more > static_cast<double>(kMostNumbers)) {
            throw UsageError(
                fmt::format("{} = {}: more than {} values", option, text, kMostNumbers));
        }
    };
    for (const std::string& part : split(text, ',')) {
        const std::vector<std::string> ends = split(part, ':');
        if (ends.size() == 1) {
            check_count(1);
            numbers.push_back(parse_number(option, part, range));
            continue;
        }
        if (ends.size() != 3) {
            throw UsageError(fmt::format(
                "{} = {}: must be a number, a comma list, or first:last:step", option, text));
        }
        const double first = parse_number(option, ends[0], range);
        const double last = parse_number(option, ends[1], range);
        const double step = parse_number(option, ends[2], Range{});
        // Rounding must not lose the last value, as in 0:0.3:0.1.
        const double steps = std::floor((last - first) / step + 1e-9);
        if (!(steps >= 0)) {
            throw UsageError(fmt::format("{} = {}: the step {} does not lead from {} to {}", option,
                                         text, step, first, last));
        }
        check_count(steps + 1);
        for (double i = 0; i <= steps; ++i) numbers.push_back(first + i * step);
    }
    return numbers;
}

}  // namespace nacre::cli
