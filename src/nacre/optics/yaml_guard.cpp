#include "nacre/optics/yaml_guard.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <sstream>

#include "nacre/core/error.h"

namespace nacre::optics {

namespace {

class PlainPageCheck : public YAML::EventHandler {
 public:
    explicit PlainPageCheck(const std::string& name) : name_(name) {}

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { refuse(mark, anchor); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse(mark, 1); }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  const std::string&) override {
        refuse(mark, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnSequenceEnd() override { --depth_; }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnMapEnd() override { --depth_; }

 private:
    static constexpr int kDeepest = 16;

    void refuse(const YAML::Mark& mark, YAML::anchor_t anchor) const {
        if (anchor != 0) {
            throw InputError(fmt::format("{}:{}: anchors and aliases (& and *) are not allowed",
                                         name_, mark.line + 1));
        }
    }
    void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
        refuse(mark, anchor);
        if (++depth_ > kDeepest) {
            throw InputError(
                fmt::format("{}:{}: nested more than {} deep", name_, mark.line + 1, kDeepest));
        }
    }

    const std::string& name_;
    int depth_ = 0;
};

}  // namespace

void require_plain_yaml(std::string_view text, const std::string& name) {
    std::istringstream stream{std::string(text)};
    PlainPageCheck check(name);
    YAML::Parser(stream).HandleNextDocument(check);
}

}  // namespace nacre::optics
