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

// Nodes that depend on the space of colours are kept for the usual one.
constexpr WorkingSpace kept_space = WorkingSpace::Rec709;

// Of no scene yet: whatever a node names is there.
class AnyResources final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string& /*name*/) override { return asked(); }
    [[nodiscard]] int attribute(const std::string& /*name*/) override { return asked(); }
    void require_texture(int /*texture*/) override { asked(); }
    [[nodiscard]] WorkingSpace working_space() override
    {
        was_asked_space_ = true;
        return kept_space;
    }

    [[nodiscard]] bool was_asked() const { return was_asked_; }
    [[nodiscard]] bool was_asked_space() const { return was_asked_space_; }

private:
    int asked()
    {
        was_asked_ = true;
        return 0;
    }

    bool was_asked_ = false;
    bool was_asked_space_ = false;
};

// Makes the node, so that a value out of an option's range is refused where it is said, and keeps
// it where every scene makes the same: a sky's table, a profile's text are work.
void make(NodeGraph::Node& node)
{
    AnyResources any;
    if (node.type->make_value != nullptr) {
        node.value = node.type->make_value(node.options, any);
    } else if (node.type->make_closure != nullptr) {
        node.closure = node.type->make_closure(node.options, any);
    }
    node.depends_on_space = any.was_asked_space();
    if (any.was_asked()) {
        node.value = nullptr;
        node.closure = nullptr;
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
    Node node{.type = found,
              .options = std::move(options),
              .inputs = std::vector<Source>(found->inputs.size())};
    make(node);
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
}

bool NodeGraph::Node::fits(NodeResources& resources) const
{
    return !depends_on_space || resources.working_space() == kept_space;
}

std::shared_ptr<const ValueNode> NodeGraph::Node::made_value(NodeResources& resources) const
{
    return value && fits(resources) ? value : type->make_value(options, resources);
}

std::shared_ptr<const ClosureNode> NodeGraph::Node::made_closure(NodeResources& resources) const
{
    return closure && fits(resources) ? closure : type->make_closure(options, resources);
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

std::vector<std::size_t> NodeGraph::reached_from(const NodeOutput& output) const
{
    std::vector<bool> is_reached(nodes_.size(), false);
    std::vector<std::size_t> to_follow{output.node};
    while (!to_follow.empty()) {
        const std::size_t number = to_follow.back();
        to_follow.pop_back();
        if (is_reached[number]) {
            continue;
        }
        is_reached[number] = true;
        for (const Source& source : nodes_[number].inputs) {
            if (const auto* from = std::get_if<NodeOutput>(&source)) {
                to_follow.push_back(from->node);
            }
        }
    }
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < is_reached.size(); ++i) {
        if (is_reached[i]) {
            numbers.push_back(i);
        }
    }
    return numbers;
}

NodeOutput NodeGraph::output(std::size_t node, std::string_view output) const
{
    const NodeType& type = *checked(node).type;
    return {.node = node, .output = index_of("output", output, type.outputs, type, identifier_of)};
}

}  // namespace eye_render
