#pragma once

#include <string>

// Only for tests: what an error says.

namespace nacre::test {

/// What the error of type E says that `work` throws; "accepted" if it throws none. Other errors
/// pass on, and fail the test.
template <class E, class Work>
std::string message_of(const Work& work) {
    try {
        work();
    } catch (const E& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace nacre::test
