// A tree of shader nodes as it comes from outside: checked at every call, so that a graph that was
// built compiles unless it runs in a circle.

#pragma once

#include "shading/node.h"

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace eye_render {

struct NodeOutput {
    std::size_t node = 0;
    std::size_t output = 0;
};

class NodeGraph {
public:
    // What feeds an input: nothing but the socket's default, a value, or another node.
    using Source = std::variant<std::monostate, NodeValue, NodeOutput>;

    struct Node {
        const NodeType* type = nullptr;
        NodeOptions options;
        std::vector<Source> inputs;  // one a socket of the type
        // As checked when it was added, where nothing of a scene is in it but the usual working
        // space; the one that fits the role, or none.
        std::shared_ptr<const ValueNode> value{};
        std::shared_ptr<const ClosureNode> closure{};
        bool depends_on_space = false;

        // For a scene; throw std::invalid_argument for a texture that it does not have.
        [[nodiscard]] std::shared_ptr<const ValueNode> made_value(NodeResources& resources) const;
        [[nodiscard]] std::shared_ptr<const ClosureNode> made_closure(
            NodeResources& resources) const;

    private:
        // Whether what was made when it was added is right for a scene, too.
        [[nodiscard]] bool fits(NodeResources& resources) const;
    };

    // Returns the node's number. Throws std::invalid_argument for a kind or an option that does
    // not exist, or for a value that the option cannot have.
    std::size_t add(std::string_view type, NodeOptions options = {});

    // Throw std::invalid_argument for a node or a socket that does not exist.
    void set(std::size_t node, std::string_view input, const NodeValue& value);
    void link(std::size_t node, std::string_view input, const NodeOutput& from);
    [[nodiscard]] NodeOutput output(std::size_t node, std::string_view output) const;

    [[nodiscard]] const Node& node(std::size_t number) const { return nodes_[number]; }
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    // The numbers, ascending, of the nodes that the output may depend on: its own, and what is
    // linked to their inputs.
    [[nodiscard]] std::vector<std::size_t> reached_from(const NodeOutput& output) const;

private:
    [[nodiscard]] const Node& checked(std::size_t node) const;
    [[nodiscard]] Source& input(std::size_t node, std::string_view identifier);

    std::vector<Node> nodes_;
};

}  // namespace eye_render
