#include "render/passes.h"

namespace eye_render {

std::string PassRequest::name() const
{
    std::string text(info(pass).name);
    if (info(pass).source == PassSource::Coverage) {
        text += {static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10)};
    }
    return text + label;
}

std::optional<PassRequest> pass_named(std::string_view name)
{
    const std::string_view group = info(Pass::LightGroup).name;
    if (name.starts_with(group)) {
        return PassRequest(Pass::LightGroup, std::string(name.substr(group.size())));
    }
    for (const PassInfo& entry : pass_table) {
        if (entry.is_named) {
            continue;
        }
        const int count = entry.source == PassSource::Coverage ? most_crypto_pictures : 1;
        for (int number = 0; number < count; ++number) {
            const PassRequest request(entry.pass, number);
            if (request.name() == name) {
                return request;
            }
        }
    }
    return std::nullopt;
}

}  // namespace eye_render
