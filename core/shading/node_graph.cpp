#include "shading/node_graph.h"

#include <cmath>
#include <stdexcept>

namespace eye_render {

namespace {

// The place of the socket or option of that name among those of the node's type.
template <typename Sockets>
std::size_t index_of(const char* what,
                     std::string_view identifier,
                     const Sockets& sockets,
                     const NodeType& type,
                     auto name_of)
{
    std::string names;
    for (std::size_t i = 0; i < sockets.size(); ++i) {
        if (name_of(sockets[i]) == identifier) {
            return i;
        }
        names += (i == 0 ? "" : ", ") + std::string(name_of(sockets[i]));
    }
    throw std::invalid_argument(std::string(what) + " '" + std::string(identifier) + "' of " +
                                std::string(type.name) + " does not exist; expected " +
                                (names.empty() ? "none" : "one of " + names));
}

// Of no scene yet: whatever a node names is there.
class AnyResources final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string& /*name*/) override { return 0; }
    [[nodiscard]] int attribute(const std::string& /*name*/) override { return 0; }
    void require_texture(int /*texture*/) override {}
};

// Makes the node once, so that a value out of an option's range is refused where it is said.
void require_makeable(const NodeType& type, const NodeOptions& options)
{
    AnyResources any;
    if (type.make_value != nullptr) {
        static_cast<void>(type.make_value(options, any));
    } else if (type.make_closure != nullptr) {
        static_cast<void>(type.make_closure(options, any));
    }
}

constexpr auto identifier_of = [](const auto& socket) { return socket.identifier; };
constexpr auto itself = [](std::string_view name) { return name; };

}  // namespace

const NodeType* node_type_named(std::string_view name)
{
    for (const NodeType* type : node_types()) {
        if (type->name == name) {
            return type;
        }
    }
    return nullptr;
}

std::size_t NodeGraph::add(std::string_view type, NodeOptions options)
{
    const NodeType* found = node_type_named(type);
    if (found == nullptr) {
        throw std::invalid_argument("node kind '" + std::string(type) + "' is not supported");
    }
    for (const auto& [name, value] : options.values()) {
        static_cast<void>(index_of("option", name, found->options, *found, itself));
    }
    require_makeable(*found, options);
    nodes_.push_back({.type = found,
                      .options = std::move(options),
                      .inputs = std::vector<Source>(found->inputs.size())});
    return nodes_.size() - 1;
}

const NodeGraph::Node& NodeGraph::checked(std::size_t node) const
{
    if (node >= nodes_.size()) {
        throw std::invalid_argument("node " + std::to_string(node) +
                                    " does not exist; the graph has " +
                                    std::to_string(nodes_.size()));
    }
    return nodes_[node];
}

NodeGraph::Source& NodeGraph::input(std::size_t node, std::string_view identifier)
{
    const NodeType& type = *checked(node).type;
    return nodes_[node].inputs[index_of("input", identifier, type.inputs, type, identifier_of)];
}

void NodeGraph::set(std::size_t node, std::string_view input_identifier, const NodeValue& value)
{
    Source& source = input(node, input_identifier);
    if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z)) {
        throw std::invalid_argument("input '" + std::string(input_identifier) + "' of " +
                                    std::string(nodes_[node].type->name) +
                                    " is not finite; expected finite numbers");
    }
    source = value;
}

void NodeGraph::link(std::size_t node, std::string_view input_identifier, const NodeOutput& from)
{
    const NodeType& type = *checked(from.node).type;
    if (from.output >= type.outputs.size()) {
        throw std::invalid_argument("output " + std::to_string(from.output) + " of " +
                                    std::string(type.name) + " does not exist; it has " +
                                    std::to_string(type.outputs.size()));
    }
    input(node, input_identifier) = from;
}

NodeOutput NodeGraph::output(std::size_t node, std::string_view output) const
{
    const NodeType& type = *checked(node).type;
    return {.node = node, .output = index_of("output", output, type.outputs, type, identifier_of)};
}

}  // namespace eye_render
