// The engine: a scene and an observer become a plan, a built scene, an eye, and a session that
// renders. All that bindings/ needs to start a render.

#pragma once

#include "api/observer.h"
#include "api/observer_eye.h"
#include "api/render_settings.h"
#include "api/scene_builder.h"
#include "render/plan.h"
#include "render/session.h"

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace eye_render {

using Fact = std::variant<std::string, double>;

class Engine {
public:
    // Checks everything, builds everything, starts nothing. The scene refuses changes while the
    // engine lives. Throws std::invalid_argument for a number out of range and std::runtime_error
    // when memory does not suffice.
    Engine(std::shared_ptr<const SceneBuilder> scene,
           const Observer& observer,
           const RenderSettings& settings);

    [[nodiscard]] Session& session() { return *session_; }
    [[nodiscard]] const RenderPlan& plan() const { return plan_; }
    [[nodiscard]] const ObserverEye& eye() const { return eye_; }

    // Sentences for the user: from the scene, and about what the eye could not do as asked.
    [[nodiscard]] std::vector<std::string> warnings() const;

    // One line on the pupil: how wide, and what made it so.
    [[nodiscard]] std::string pupil_report() const;

    // What is known about the picture's making: who looks, with what, and how it is rendered.
    [[nodiscard]] std::map<std::string, Fact> facts() const;

    // The facts as a picture's file should say them; keys without the `eye_render:` prefix.
    [[nodiscard]] std::map<std::string, std::string> metadata() const;

private:
    std::shared_ptr<const SceneBuilder> scene_data_;
    std::shared_ptr<const void> lease_;
    Observer observer_;
    RenderSettings settings_;
    ObserverEye eye_;
    RenderPlan plan_;
    std::unique_ptr<Session> session_;
};

}  // namespace eye_render
