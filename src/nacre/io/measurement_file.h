#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/measure/measurement.h"

// What all formats have in common: one reading as a file states it, which may be more or less than
// is needed. Internal to this folder.

namespace nacre::io {

inline constexpr std::size_t kMaxMeasuredWavelengths = 2000;
inline constexpr Range kMeasuredReflectance{-1, 1e9};
inline constexpr Range kMeasuredColour{-1e6, 1e6};  // L*, a*, b*
inline constexpr Range kMeasuredTristimulus{-1e15, 1e15};
inline constexpr Range kMeasuredAngle{-360, 360, "deg"};
inline constexpr Range kMeasuredWavelength{100, 10000, "nm"};

/// By which the colour of a reading may differ from that of its spectrum, Delta E 2000. Colours of
/// one spectrum by other tables of weights and other wavelength steps differ by less than 1, those
/// under a wrong light or on a wrong scale by far more.
inline constexpr double kMaxColourError = 5;

/// Three numbers of a colour, and the unit of the last digit that is written of each; 0: not known.
struct WrittenColour {
    Vec3d values{}, unit{};
};

/// The unit of the last digit of a number: 0.01 of "1,25".
double last_digit(std::string_view text);

/// L*a*b* of lightness, chroma, and hue in degrees.
Vec3d lab_of_lch(const Vec3d& lch);

struct MeasurementRow {
    std::string place;  ///< "file.csv:3:1: ", for messages
    std::string name;   ///< of the geometry; empty: not stated
    std::optional<double> theta_i_deg, aspecular_deg, theta_o_deg, phi_deg;
    std::vector<double> reflectance_factor;
    std::optional<Vec3d> xyz, lab;
    bool states_lab = true;  ///< false: lab is that of lch
    std::optional<WrittenColour> lch = {};
    /// As in WrittenColour.
    Vec3d xyz_unit{}, lab_unit{};
    double reflectance_unit = 0;
};

inline bool states_colour(const MeasurementRow& row) { return row.lab || row.xyz; }

class ColourAgreement;
struct MeasurementFile;

/// Completes rows to a measurement.
/// @param agreement  asked about each row
/// @throws InputError as parse_measurement()
measure::Measurement assemble_measurement(std::string name, const measure::Conditions& conditions,
                                          std::vector<double> wavelengths_nm,
                                          const std::vector<MeasurementRow>& rows,
                                          ColourAgreement& agreement);

/// What is said of a file that does not state the light of its colours, or the observer.
/// @param conditions  those that are taken
/// @return none where it states both
std::optional<std::string> note_of_light(const std::string& filename, bool states_illuminant,
                                         bool states_observer,
                                         const measure::Conditions& conditions);

// The JSON below. Internal to this folder.

MeasurementFile parse_measurement_json(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults);

// Multi-angle colour as CSV, JSON and CGATS: what Nacre writes, and what instruments' software and
// spreadsheets export. The columns and keys, and the defaults where one is missing: docs/measure.md.

/// What a file holds.
struct MeasurementFile {
    std::vector<measure::Measurement> samples;  ///< one at least, in the order of the file
    /// What was decided that the file does not say, such as a scale in percent; each names the file.
    std::vector<std::string> notes = {};
    /// By sample: where columns contradict each other by more than what rounds, and which of them counts; each
    /// names file and line.
    std::vector<std::vector<std::string>> contradictions = {};
};

inline constexpr std::size_t kMaxReadings = 100'000;
/// The "format" of the JSON.
inline constexpr std::string_view kMeasurementFormat = "nacre-measurement";
inline constexpr int kMeasurementFormatVersion = 1;

/// A column beside those of a measurement, with a cell for each reading.
struct MeasurementColumn {
    std::string name;
    std::vector<std::string> cells;  ///< as many as readings
};

/// As CSV: a row a geometry. Reading it back gives the same measurement, bit for bit.
/// @param standard_error  of reflectance, by reading and wavelength, for columns SE<nm>; empty:
///        there are none
/// @param more  the last columns; a reader passes over these and SE<nm>
std::string measurement_csv(const measure::Measurement& measurement,
                            const std::vector<std::vector<double>>& standard_error = {},
                            const std::vector<MeasurementColumn>& more = {});

/// As JSON, with flop index and colour travel. Reading it back gives the same measurement, bit for
/// bit, as far as names are UTF-8; members that somebody adds are passed over.
nlohmann::json measurement_json(const measure::Measurement& measurement);

/// Reads any of the formats. Colours that are missing come from the spectra, XYZ that are missing
/// from L*a*b*. Reflectances in percent become factors.
///
/// @param filename  for messages
/// @param defaults  for what the text does not state: light, observer, aperture
/// @throws InputError naming file, line and column (CSV, CGATS) or member (JSON) if a geometry is not
///         stated, is stated twice, or contradicts itself; a value is missing, no number, or out of
///         range; wavelengths have unequal steps; rows differ in light, observer or aperture;
///         reflectances may be factors or percent; or L*a*b* differ from those of the spectrum by
///         more than kMaxColourError
MeasurementFile parse_measurement_file(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults = {});

/// The sample of that name, or that number counted from 1; the only one if the name is empty.
/// @throws InputError naming the samples if there is none, or several
const measure::Measurement& sample_called(const MeasurementFile& file, std::string_view name,
                                          const std::string& filename);

/// One sample of a file.
/// @throws InputError as parse_measurement_file() and sample_called()
measure::Measurement parse_measurement(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults = {},
                                       std::string_view sample = {});

/// A file and a sample in it, as people name them: "panels.csv#Silver 2".
struct SampleName {
    std::filesystem::path file;
    std::string sample;  ///< empty: none is named
};
/// Takes the name apart. The file is the longest beginning that there is, the whole name or up to a
/// '#', and the sample all that follows that mark, which may hold others; where there is no such file,
/// the first mark behind the folders divides. A mark at the beginning or the end is none.
SampleName split_sample_name(const std::filesystem::path& name);

/// @throws InputError as parse_measurement(), or if the file cannot be read
measure::Measurement read_measurement(const std::filesystem::path& path,
                                      const measure::Conditions& defaults = {});

/// Whether a text starts like a measurement, and not like a recipe: a JSON object, a table of CGATS,
/// or a header of which enough columns are known.
bool looks_like_measurement(std::string_view text);

}  // namespace nacre::io
