#pragma once

#include <algorithm>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre::render {

/// What is wrong with a mesh's file; its name is put in front by whoever knows it.
class MeshFault : public Error {
 public:
    using Error::Error;
};

/// A message of a library without what it quotes of the file. A scene may name any file as a mesh,
/// and what stands in it is not for the eyes of whoever sees the message.
inline std::string without_quotes(std::string message) {
    message.resize(std::min(message.size(), message.find("; last read: ")));  // nlohmann's
    const std::size_t first = message.find('"'), last = message.rfind('"');
    if (first != std::string::npos) message.replace(first, last - first + 1, "...");
    return excerpt(message, 200);
}

}  // namespace nacre::render
