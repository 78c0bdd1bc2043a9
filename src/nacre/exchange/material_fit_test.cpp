#include "nacre/exchange/material_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "nacre/core/error.h"
#include "nacre/exchange/gltf_file.h"
#include "nacre/exchange/gltf_material.h"
#include "nacre/exchange/open_pbr.h"

namespace nacre::exchange {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<double> somewhere(const FormatModel& model) {
    std::vector<double> values;
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        const FormatParameter& p = model.parameters[i];
        values.push_back(p.lo + (0.3 + 0.04 * static_cast<double>(i)) * (p.hi - p.lo));
    }
    return values;
}

MaterialFit fit_to_itself(const FormatModel& model, const std::vector<double>& values) {
    const FitGeometries& sets = fit_geometries();
    return fit_material(model, read_material(model, values, sets.fitted),
                        read_material(model, values, sets.tested));
}

TEST(MaterialFit, TestsAtViewsThatItDoesNotFit) {
    for (const bool across : {false, true}) {
        const FitGeometries& sets = fit_geometries(across);
        EXPECT_EQ(sets.fitted[0].name, "45as-15");
        EXPECT_EQ(sets.fitted[kBykMacAngles - 1].name, "45as110");
        for (const auto& a : sets.tested) {
            for (const auto& b : sets.fitted) EXPECT_GT(measure::separation_deg(a, b), 4);
        }
    }
    EXPECT_GT(fit_geometries(true).fitted.size(), fit_geometries().fitted.size());
}

// A material of the format itself is found again, to less than can be seen.
TEST(MaterialFit, FindsAMaterialOfTheFormat) {
    for (const FormatModel& model : {gltf_model(true, false), open_pbr_model(true, true)}) {
        const MaterialFit fit = fit_to_itself(model, somewhere(model));
        EXPECT_LT(fit.fitted.mean_delta_e_2000, 0.3) << model.format;
        EXPECT_LT(fit.tested.max_delta_e_2000, 1.0) << model.format;
    }
}

TEST(MaterialFit, IsTheSameEachTimeAndStops) {
    const FormatModel model = gltf_model(false, false);
    const auto values = somewhere(model);
    EXPECT_EQ(fit_to_itself(model, values).values, fit_to_itself(model, values).values);
    const FitGeometries& sets = fit_geometries();
    const measure::Measurement fitted = read_material(model, values, sets.fitted),
                               tested = read_material(model, values, sets.tested);
    EXPECT_THROW(fit_material(model, fitted, tested, [](double) { return false; }), Stopped);
}

TEST(GltfFile, HoldsTheMaterialAndWhatItMisses) {
    const FormatModel model = gltf_model(true, false);
    MaterialFit fit;
    fit.values = somewhere(model);
    fit.instrument.mean_delta_e_2000 = 7.5;
    const auto gltf =
        nlohmann::json::parse(gltf_text(gltf_material(model, fit.values), "a \"paint\"", fit));
    EXPECT_EQ(gltf["asset"]["version"], "2.0");
    const auto& material = gltf["materials"][0];
    EXPECT_EQ(material["name"], "a \"paint\"");
    EXPECT_EQ(material["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"], 1);
    EXPECT_NEAR(material["pbrMetallicRoughness"]["metallicFactor"], fit.values[3], 1e-5);
    EXPECT_EQ(material["extras"]["nacre_delta_e_2000"]["byk_mac"]["mean"], 7.5);
    EXPECT_THAT(gltf["extensionsUsed"],
                ElementsAre("KHR_materials_specular", "KHR_materials_iridescence",
                            "KHR_materials_clearcoat"));
}

TEST(MaterialXFile, HoldsTheMaterialAndWhatItMisses) {
    const FormatModel model = open_pbr_model(true, false);
    MaterialFit fit;
    fit.values = somewhere(model);
    fit.tested.max_delta_e_2000 = 31.25;
    const std::string text = materialx_text(open_pbr(model, fit.values), "a <\"paint\"> & b", fit);
    EXPECT_THAT(text, HasSubstr("uiname=\"a &lt;&quot;paint&quot;> &amp; b\""));
    EXPECT_THAT(text, HasSubstr("31.2 at angles that the fit did not see"));
    EXPECT_THAT(text, HasSubstr("<input name=\"coat_weight\" type=\"float\" value=\"1\" />"));
}

}  // namespace
}  // namespace nacre::exchange
