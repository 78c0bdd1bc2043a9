#pragma once

namespace nacre {

/// While one lives, Ceres Solver prints nothing. Its option SILENT holds for its own course only:
/// where a function cannot be evaluated, as once the user has interrupted the work, its line search
/// and its evaluators write to stderr through glog, with a warning that glog was not initialised.
/// So everything below FATAL is kept from glog, messages of the program's own among them. Any number
/// may live, on any threads; the last one puts back what was there.
class QuietCeres {
 public:
    QuietCeres();
    ~QuietCeres();
    QuietCeres(const QuietCeres&) = delete;
    QuietCeres& operator=(const QuietCeres&) = delete;
};

}  // namespace nacre
