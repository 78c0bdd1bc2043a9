#include "nacre/measure/sparkle_measurement.h"

namespace nacre::measure {

SparkleMeasurement measure_pictures(const SparkleCamera& camera, const PanelPictures& pictures,
                                    const Viewing& viewing) {
    SparkleMeasurement measurement{camera.lamps_deg, {}, {}};
    for (const PanelPicture& picture : pictures.by_lamp) {
        measurement.by_lamp.push_back(sparkle(picture, viewing));
    }
    if (!pictures.diffuse.empty()) {
        measurement.diffuse = graininess(pictures.diffuse[0], pictures.diffuse[1], viewing);
    }
    return measurement;
}

}  // namespace nacre::measure
