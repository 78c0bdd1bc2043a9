#include "apps/studio/session.h"

#include <exception>
#include <utility>

#include "nacre/models/models.h"

namespace nacre::studio {

Lane& Workshop::lane_of(const std::string& type) {
    if (type == "sparkle" || type == "report") return look_;
    if (type == "fit") return fit_;
    if (type == "render" || type == "shape" || type == "light") return picture_;
    if (type == "atlas") return atlas_;
    return paint_;
}

void Workshop::forget(ClientId client) {
    for (Lane* lane : {&paint_, &look_, &fit_, &picture_, &atlas_}) lane->stop(client);
}

std::size_t Workshop::stop(ClientId client, const std::optional<std::string>& type) {
    std::size_t stopped = 0;
    for (Lane* lane : {&look_, &fit_, &picture_, &atlas_}) stopped += lane->stop(client, type);
    return stopped;
}

void Workshop::end() {
    for (Lane* lane : {&paint_, &look_, &fit_, &picture_, &atlas_}) lane->end();
}

void Session::receive(std::string_view text) {
    Message message;
    try {
        message = parse_message(text, models::names_of_fitted());
    } catch (const MessageError& error) {
        post_({"error", error_frames(error.id(), "message", error)});
        return;
    }
    if (const auto* stop = std::get_if<StopRequest>(&message.request)) {
        const std::size_t stopped = workshop_.stop(id_, stop->type);
        post_({"stopped",
               {{dumped({{"type", "stopped"}, {"id", message.id}, {"jobs", stopped}}), {}}}});
        return;
    }
    Lane& lane = workshop_.lane_of(message.type);
    const std::string kind = message.type;
    lane.post(id_, {kind, [message = std::move(message), memory = memory_, post = post_,
                           &solved = workshop_.solved()](const Progress& progress) {
                        const Context context{message.id, *memory, solved, progress,
                                              [&](const std::string& part, Frames frames) {
                                                  post({part, std::move(frames)});
                                              }};
                        try {
                            post({message.type, answer(message, context)});
                        } catch (const std::exception& error) {
                            // Who was told to stop has nothing to say, whatever it throws.
                            if (!progress(1)) return;
                            post({message.type, error_frames(message.id, message.type, error)});
                        }
                    }});
}

}  // namespace nacre::studio
