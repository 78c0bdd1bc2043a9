#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "apps/studio/messages/messages.h"
#include "apps/studio/outbox.h"
#include "nacre/core/progress.h"
#include "nacre/measure/difference.h"
#include "nacre/nacre.h"

// What the server answers: each function does what one message asks for, through the front door
// (nacre/nacre.h), and hands back frames. Their fields: docs/studio-api.md.

namespace nacre::studio {

/// What one page has told that later messages build on. Shared by the threads that answer it.
class Memory {
 public:
    /// What the page's paints are compared with; null: nothing.
    std::shared_ptr<const Paint> standard() const;
    void set_standard(std::shared_ptr<const Paint> standard);
    /// The text that was last opened, whose comments stay in the texts that are answered.
    std::string opened() const;
    void set_opened(std::string toml);

    /// A name for a shape or a light that the page brings along: "own-shape-1". Another each time, so
    /// that nobody is shown an older one for it.
    std::string next_own_name(const std::string& what);
    /// Takes the place of the one before.
    void set_own(std::shared_ptr<const OwnShape> shape);
    void set_own(std::shared_ptr<const OwnLight> light);
    void lend_own_files(Stage& stage) const;

 private:
    mutable std::mutex mutex_;
    std::shared_ptr<const Paint> standard_;
    std::string opened_;
    int own_names_ = 0;
    std::shared_ptr<const OwnShape> own_shape_;
    std::shared_ptr<const OwnLight> own_light_;
};

/// The paints that were answered last, solved: who asks for their sparkle or picture need not solve
/// them again.
class SolvedPaints {
 public:
    std::optional<Paint> find(const std::string& toml) const;
    void add(const std::string& toml, const Paint& paint);

 private:
    static constexpr std::size_t kMax = 8;
    mutable std::mutex mutex_;
    std::vector<std::pair<std::string, Paint>> paints_;  // the newest last
};

/// A paint from a page, which names no files.
struct NamedPaint {
    Paint paint;
    std::string toml;
};

/// Where parts of an answer go before its end, by their kind.
using Send = std::function<void(const std::string& kind, Frames)>;

/// Whatever an answer needs besides its message.
struct Context {
    Tree id;
    Memory& memory;
    SolvedPaints& solved;
    Progress progress;  ///< says whether to go on
    Send send;
};

/// @throws InputError naming key and line in the text that the tree becomes
NamedPaint paint_of(const Tree& recipe, const Context& context);

Frames answer(const OpenRequest& request, const Context& context);
Frames answer(const PaintRequest& request, const Context& context);
Frames answer(const FilmsRequest& request, const Context& context);
Frames answer(const StandardRequest& request, const Context& context);
Frames answer(const SparkleRequest& request, const Context& context);
Frames answer(const FitRequest& request, const Context& context);
Frames answer(const ReportRequest& request, const Context& context);
Frames answer(const AtlasRequest& request, const Context& context);
/// Sends pictures of few samples before the last.
Frames answer(const RenderRequest& request, const Context& context);
Frames answer(const ShapeRequest& request, const Context& context);
Frames answer(const LightRequest& request, const Context& context);
/// Any of these.
/// @throws InputError, DomainError, Error, which error_frames() states; any error once
///         `context.progress` asks to stop
Frames answer(const Message& message, const Context& context);

/// How a paint is read for a page; measured colours take no model.
MeasureSettings settings_of(const Viewed& viewed);
/// The standard's readings under the light of the page, or as they were made where they have no
/// spectra.
Measurement standard_readings(const Paint& standard, const Viewed& viewed);
/// The limits that concern angles of the comparison: the page may show other angles than it limits.
measure::Tolerance known_limits(measure::Tolerance tolerance,
                                const measure::Difference& difference);

}  // namespace nacre::studio
