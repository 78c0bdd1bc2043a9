#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// As colour-cxf 0.1.1 writes it (colour_cxf.write_cxf of these readings), line breaks apart.
const std::string kCxf = R"(<?xml version="1.0" encoding="UTF-8"?>
<ns0:CxF xmlns:ns0="http://colorexchangeformat.com/CxF3-core"><ns0:FileInformation><ns0:Creator>colour-cxf</ns0:Creator><ns0:CreationDate>2026-11-23T12:00:00</ns0:CreationDate><ns0:Description>x</ns0:Description></ns0:FileInformation><ns0:Resources><ns0:ObjectCollection>
<ns0:Object ObjectType="Standard" Name="Silver 2" Id="o1"><ns0:CreationDate>2026-11-23T12:00:00</ns0:CreationDate><ns0:ColorValues>
<ns0:ReflectanceSpectrum ColorSpecification="m15">1.5 1.6 1.7 1.8</ns0:ReflectanceSpectrum>
<ns0:ReflectanceSpectrum ColorSpecification="p45">0.2 0.21 0.22 0.23</ns0:ReflectanceSpectrum>
<ns0:ReflectanceSpectrum ColorSpecification="az">0.9 0.91 0.92 0.93</ns0:ReflectanceSpectrum>
<ns0:ReflectanceSpectrum ColorSpecification="sphere">0.5 0.5 0.5 0.5</ns0:ReflectanceSpectrum></ns0:ColorValues></ns0:Object>
<ns0:Object ObjectType="Trial" Name="Trial 1" Id="o2"><ns0:CreationDate>2026-11-23T12:00:00</ns0:CreationDate><ns0:ColorValues>
<ns0:ReflectanceSpectrum ColorSpecification="m15">1.4 1.5 1.6 1.7</ns0:ReflectanceSpectrum>
<ns0:ReflectanceSpectrum ColorSpecification="p45">0.25 0.26 0.27 0.28</ns0:ReflectanceSpectrum>
<ns0:ReflectanceSpectrum ColorSpecification="az">0.8 0.81 0.82 0.83</ns0:ReflectanceSpectrum></ns0:ColorValues></ns0:Object></ns0:ObjectCollection><ns0:ColorSpecificationCollection>
<ns0:ColorSpecification Id="m15"><ns0:TristimulusSpec><ns0:Illuminant>D65</ns0:Illuminant><ns0:Observer>10_Degree</ns0:Observer><ns0:Method>E308_Table5</ns0:Method></ns0:TristimulusSpec>
<ns0:MeasurementSpec><ns0:MeasurementType>Spectrum_Reflectance</ns0:MeasurementType>
<ns0:GeometryChoice><ns0:MultiAngle><ns0:BRDFAngle Notation="45as-15">
<ns0:IlluminationAngle>45.0</ns0:IlluminationAngle>
<ns0:Aspecular>-15.0</ns0:Aspecular></ns0:BRDFAngle></ns0:MultiAngle></ns0:GeometryChoice>
<ns0:WavelengthRange StartWL="400" Increment="100"/></ns0:MeasurementSpec></ns0:ColorSpecification>
<ns0:ColorSpecification Id="p45"><ns0:TristimulusSpec><ns0:Illuminant>D65</ns0:Illuminant><ns0:Observer>10_Degree</ns0:Observer><ns0:Method>E308_Table5</ns0:Method></ns0:TristimulusSpec>
<ns0:MeasurementSpec><ns0:MeasurementType>Spectrum_Reflectance</ns0:MeasurementType>
<ns0:GeometryChoice><ns0:MultiAngle><ns0:BRDFAngle Notation="45as45">
<ns0:IlluminationAngle>45.0</ns0:IlluminationAngle>
<ns0:Aspecular>45.0</ns0:Aspecular></ns0:BRDFAngle></ns0:MultiAngle></ns0:GeometryChoice>
<ns0:WavelengthRange StartWL="400" Increment="100"/></ns0:MeasurementSpec></ns0:ColorSpecification>
<ns0:ColorSpecification Id="az"><ns0:TristimulusSpec><ns0:Illuminant>D65</ns0:Illuminant><ns0:Observer>10_Degree</ns0:Observer><ns0:Method>E308_Table5</ns0:Method></ns0:TristimulusSpec>
<ns0:MeasurementSpec><ns0:MeasurementType>Spectrum_Reflectance</ns0:MeasurementType>
<ns0:GeometryChoice><ns0:MultiAngle><ns0:BRDFAngle Notation="45as25az90">
<ns0:IlluminationAngle>45.0</ns0:IlluminationAngle>
<ns0:Aspecular>25.0</ns0:Aspecular>
<ns0:Azimuth>90.0</ns0:Azimuth></ns0:BRDFAngle></ns0:MultiAngle></ns0:GeometryChoice>
<ns0:WavelengthRange StartWL="400" Increment="100"/></ns0:MeasurementSpec></ns0:ColorSpecification>
<ns0:ColorSpecification Id="sphere"><ns0:TristimulusSpec><ns0:Illuminant>D65</ns0:Illuminant><ns0:Observer>10_Degree</ns0:Observer><ns0:Method>E308_Table5</ns0:Method></ns0:TristimulusSpec>
<ns0:MeasurementSpec><ns0:MeasurementType>Spectrum_Reflectance</ns0:MeasurementType>
<ns0:GeometryChoice><ns0:SphereGeometry>Specular_Included</ns0:SphereGeometry></ns0:GeometryChoice>
<ns0:WavelengthRange StartWL="400" Increment="100"/></ns0:MeasurementSpec></ns0:ColorSpecification></ns0:ColorSpecificationCollection></ns0:Resources></ns0:CxF>)";

std::string refused_cxf(const std::string& text) {
    return message_of<InputError>([&] { parse_measurement_file(text, "m.cxf"); });
}

TEST(Cxf, ReadsSpectraByTheGeometryOfTheirSpecification) {
    EXPECT_EQ(file_kind(kCxf), FileKind::measured_colours);
    const MeasurementFile file = parse_measurement_file(kCxf, "m.cxf");
    ASSERT_EQ(file.samples.size(), 2u);
    const measure::Measurement& silver = file.samples[0];
    EXPECT_EQ(silver.name, "Silver 2");
    EXPECT_EQ(silver.conditions.illuminant, spectra::Illuminant::D65);
    EXPECT_EQ(silver.conditions.observer, spectra::Observer::cie1964_10deg);
    ASSERT_EQ(silver.readings.size(), 3u);
    EXPECT_EQ(silver.readings[0].geometry.name, "45as-15");
    EXPECT_EQ(silver.readings[1].geometry.name, "45as45");
    EXPECT_EQ(silver.readings[2].geometry.name, measure::off_plane(45, 25, 90).name);
    EXPECT_THAT(silver.wavelengths_nm, ElementsAre(400, 500, 600, 700));
    EXPECT_THAT(silver.readings[1].reflectance_factor, ElementsAre(0.2, 0.21, 0.22, 0.23));
    EXPECT_EQ(file.samples[1].name, "Trial 1");
    EXPECT_THAT(file.notes, ElementsAre(AllOf(HasSubstr("left out"), HasSubstr("sphere"))));
}

TEST(Cxf, ReadsColoursWhereThereAreNoSpectra) {
    const MeasurementFile file = parse_measurement_file(
        R"(<CxF xmlns="http://colorexchangeformat.com/CxF3-core"><Resources><ObjectCollection>
<Object Name="Red" Id="1"><ColorValues><ColorCIELab ColorSpecification="a">
<L>50</L><A>60</A><B>30.5</B></ColorCIELab></ColorValues></Object></ObjectCollection>
<ColorSpecificationCollection><ColorSpecification Id="a"><TristimulusSpec>
<Illuminant>F11</Illuminant><Observer>2_Degree</Observer></TristimulusSpec><MeasurementSpec>
<MeasurementType>Colorimetric_Reflectance</MeasurementType><GeometryChoice><SingleAngle>
<SingleAngleConfiguration>Annular</SingleAngleConfiguration>
<IlluminationAngle>45</IlluminationAngle><MeasurementAngle>0</MeasurementAngle></SingleAngle>
</GeometryChoice></MeasurementSpec></ColorSpecification></ColorSpecificationCollection>
</Resources></CxF>)",
        "m.cxf");
    ASSERT_EQ(file.samples.size(), 1u);
    EXPECT_THAT(file.notes, IsEmpty());
    EXPECT_EQ(file.samples[0].conditions.illuminant, spectra::Illuminant::FL11);
    EXPECT_EQ(file.samples[0].conditions.observer, spectra::Observer::cie1931_2deg);
    EXPECT_EQ(file.samples[0].readings[0].geometry.name, "45as45");
    EXPECT_EQ(file.samples[0].readings[0].lab, (Vec3d{50, 60, 30.5}));
}

TEST(Cxf, RefusesWhatItCannotTell) {
    EXPECT_THAT(refused_cxf(kCxf.substr(0, 900)), HasSubstr("m.cxf:"));
    EXPECT_THAT(
        refused_cxf(replaced(kCxf, "ColorSpecification=\"p45\"", "ColorSpecification=\"none\"")),
        AllOf(HasSubstr("object 'Silver 2'"), HasSubstr("'none'")));
    EXPECT_THAT(refused_cxf(replaced(kCxf, "0.25 0.26 0.27 0.28", "0.25 0.26 0.27")),
                AllOf(HasSubstr("object 'Trial 1'"), HasSubstr("has 3 values")));
    EXPECT_THAT(refused_cxf(replaced(kCxf, "Increment=\"100\"", "Increment=\"0\"")),
                HasSubstr("WavelengthRange"));
    EXPECT_THAT(refused_cxf(replaced(kCxf, "0.25 0.26 0.27 0.28", "0.25 0.26 x 0.28")),
                HasSubstr("x"));
    EXPECT_THAT(refused_cxf(replaced(kCxf, "D65", "Custom")), HasSubstr("Custom"));
    EXPECT_THAT(refused_cxf("<cc:CxF><cc:Resources/></cc:CxF>"), HasSubstr("has no reading"));
    // Entities are not expanded.
    EXPECT_THAT(refused_cxf(R"(<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]>
<CxF>&b;</CxF>)"),
                HasSubstr("has no reading"));
}

}  // namespace
}  // namespace nacre::io
