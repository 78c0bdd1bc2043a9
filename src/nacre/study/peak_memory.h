#pragma once

namespace nacre::study {

/// The largest resident memory of this process since it was made, in MiB. Where the system cannot
/// start counting afresh (it needs Linux's /proc/self/clear_refs): since the process began.
class PeakMemory {
 public:
    PeakMemory();
    /// @throws Error where the system does not tell
    double mebibytes() const;
};

}  // namespace nacre::study
