#include "nacre/study/peak_memory.h"

#include <fstream>
#include <string>

#include "nacre/core/error.h"

namespace nacre::study {

PeakMemory::PeakMemory() {
    std::ofstream("/proc/self/clear_refs") << "5";  // resets VmHWM: proc(5)
}

double PeakMemory::mebibytes() const {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        if (word != "VmHWM:") continue;
        double kibibytes = 0;
        if (status >> kibibytes) return kibibytes / 1024;
    }
    throw Error("the system does not tell how much memory this process uses (/proc/self/status)");
}

}  // namespace nacre::study
