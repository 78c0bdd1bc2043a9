#pragma once

#include <exception>
#include <string>
#include <vector>

#include "apps/studio/messages/recipe_tree.h"

// What an answer to a page is made of.

namespace nacre::studio {

/// A frame of text, and the binary one that follows it; empty: none does.
struct Frame {
    std::string text, binary;
    /// The name of a program in it, which a page is sent once: the text then is `text_when_new`.
    std::string program = {}, text_when_new = {};
};
using Frames = std::vector<Frame>;

/// About a message that cannot be answered. Key, line and range are taken out of the texts of
/// errors, which name them (docs/conventions.md).
Frames error_frames(const Tree& id, const std::string& type, const std::exception& error);

/// A text frame; bytes that are no UTF-8 are replaced.
std::string dumped(const Tree& tree);

}  // namespace nacre::studio
