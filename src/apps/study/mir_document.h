#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace nacre::study {

/// A Markdown text with the tables of a study's results put between its markers
///
///     <!-- begin: NAME -->
///     <!-- end: NAME -->
///
/// NAME being that of a table of the page (MirContext::table), or `setting` for a line that says
/// with what version, size, samples and machine the results were made. What stood there before is
/// replaced, everything else stays as it is.
///
/// @param name  of the text, for messages
/// @throws InputError if a marker lacks its other one, names no table of the results, or as
///         require_markers() does
std::string with_tables(const std::string& markdown, const std::string& name,
                        const nlohmann::json& results);

/// Before hours of work. @throws InputError if the text has no marker at all
void require_markers(const std::string& markdown, const std::string& name);

}  // namespace nacre::study
