#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "nacre/core/references.h"

// What a file is, by its contents: for commands that take any, and for messages about one that was
// given in the place of another.

namespace nacre::io {

class TomlDocument;

enum class FileKind {
    // Texts in TOML.
    recipe,
    scene,
    geometry_set,
    pigment,
    // Results of Nacre in HDF5.
    solved_paint,
    brdf_table,
    picture_shard,  ///< of its samples
    // Measurements.
    rgl,               ///< .bsdf
    merl,              ///< .binary
    measured_colours,  ///< CSV, JSON, CGATS or CxF3
    drawdown,          ///< CSV
    // What recipes and scenes name.
    material,  ///< optical constants, CSV or YAML
    spectrum,  ///< CSV of two columns
    mesh,      ///< OBJ, PLY, STL, glTF
    picture,   ///< OpenEXR, PNG, Radiance HDR
    // Results that are not read again.
    result_table,     ///< CSV
    result_document,  ///< JSON
    report,           ///< JSON
    materialx,
    cycles_script,   ///< .blender.py
    threejs_module,  ///< .three.js
    page,            ///< HTML
    plot,            ///< SVG
    // What Nacre does not read.
    empty,
    other_table,  ///< CSV whose header is not known
    other_json,
    other_xml,
    other_hdf5,
    other_picture,   ///< JPEG, TIFF
    spreadsheet,     ///< .xlsx, .ods, .xls; or another archive
    document,        ///< PDF
    other_encoding,  ///< a text that is not UTF-8
    binary,
    /// A text that is none of these: perhaps TOML.
    text
};

/// How a shard of a picture begins; it is read above this room (render/shard_file.h).
inline constexpr std::string_view kPictureShardName = "nacre share of a picture";

/// What documents in JSON that commands write and none reads name as their "format".
inline constexpr std::string_view kDifferenceFormat = "nacre-difference";
inline constexpr std::string_view kSparkleFormat = "nacre-sparkle";

/// As messages name it: "a scene", "a spreadsheet or another archive; save its table as CSV".
std::string words_for(FileKind kind);

/// By the first bytes as far as they tell, never by parsing: a text in TOML is `text`.
FileKind kind_of_bytes(std::string_view bytes);

/// The same where TOML is told apart by the keys that it has; a text that is not TOML counts as a
/// recipe, whose reader says what is wrong in it.
FileKind file_kind(std::string_view bytes);

/// A file that has been told apart, with all that was found out on the way, so that its reader need not
/// do it again.
struct TypedFile {
    std::string name;  ///< for messages
    std::string bytes;
    References references;  ///< the files that it may name
    FileKind kind = FileKind::empty;
    /// Null where it is not TOML: a text that counts as a recipe has none either, if it is wrong.
    std::shared_ptr<TomlDocument> toml = {};
};

/// Tells a file apart as file_kind().
TypedFile typed_file(std::string bytes, std::string name, const References& references);

/// What a table or a document of results holds: "reflectance and transmittance of films (nacre
/// film)"; empty for what is of neither kind. Differences are among them.
std::string_view result_of(std::string_view text);

}  // namespace nacre::io
