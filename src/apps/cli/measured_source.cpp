#include "apps/cli/measured_source.h"

#include <fmt/format.h>

#include "apps/cli/options.h"
#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/file.h"
#include "nacre/io/measured_brdf_file.h"

namespace nacre::cli {

bool is_measured_brdf(std::string_view bytes) {
    return io::looks_like_rgl(bytes) || io::looks_like_merl(bytes);
}

bool is_measured_brdf_file(const std::filesystem::path& path) {
    return is_measured_brdf(read_file(path, io::kMaxMeasuredBytes));
}

std::shared_ptr<const bsdf::Bsdf> make_measured_brdf(std::string_view bytes,
                                                     const std::string& name) {
    if (io::looks_like_rgl(bytes)) {
        return std::make_shared<const bsdf::MeasuredRgl>(io::parse_rgl(bytes, name));
    }
    return std::make_shared<const bsdf::MeasuredMerl>(io::parse_merl(bytes, name));
}

void refuse_model_of_measured(bool model_given, const std::string& model, const std::string& file) {
    if (!model_given) return;
    throw UsageError(
        fmt::format("--model = {}: {} holds a measured BRDF, which is shown as it was measured; "
                    "models are for recipes",
                    model, file));
}

}  // namespace nacre::cli
