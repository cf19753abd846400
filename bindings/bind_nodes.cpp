// eyecore.NodeGraph: shader nodes under Blender's names, and eyecore.NODE_TYPES, what there is.

#include "bind_scene.h"

#include <array>

namespace eye_render {

namespace {

// A node of a graph that Python holds.
struct PyNode {
    std::shared_ptr<NodeGraph> graph;
    std::size_t number;
};

NodeOptions::Value option_value(const std::string& name, const py::handle& value)
{
    if (py::isinstance<py::str>(value)) {
        return value.cast<std::string>();
    }
    if (const auto number = number_from(value)) {
        return *number;
    }
    try {
        return value.cast<std::vector<float>>();
    } catch (const py::cast_error&) {
        throw std::invalid_argument(name + " is " + text_of(value) +
                                    "; expected a text, a number or a list of numbers");
    }
}

NodeOptions options_from(const py::kwargs& options)
{
    std::map<std::string, NodeOptions::Value> values;
    for (const auto& [key, value] : options) {
        const auto name = key.cast<std::string>();
        values.emplace(name, option_value(name, value));
    }
    return NodeOptions(std::move(values));
}

// A number, or the first three of a vector or a colour with alpha.
NodeValue value_from(const std::string& input, const py::handle& value)
{
    if (const auto number = number_from(value)) {
        return NodeValue(static_cast<float>(*number));
    }
    try {
        const auto numbers = value.cast<std::vector<float>>();
        if (numbers.size() == 3 || numbers.size() == 4) {
            return {numbers[0], numbers[1], numbers[2]};
        }
    } catch (const py::cast_error&) {
    }
    throw std::invalid_argument("input '" + input + "' is " + text_of(value) +
                                "; expected a number, three or four numbers, or a socket");
}

void set_input(const PyNode& node, const std::string& input, const py::handle& value)
{
    if (!py::isinstance<NodeSocket>(value)) {
        node.graph->set(node.number, input, value_from(input, value));
        return;
    }
    const auto& from = value.cast<const NodeSocket&>();
    if (from.graph != node.graph) {
        throw std::invalid_argument("input '" + input + "' is linked to another graph");
    }
    node.graph->link(node.number, input, from.output);
}

py::dict types_as_dict()
{
    py::dict types;
    for (const NodeType* type : node_types()) {
        py::list inputs;
        py::list outputs;
        py::list options;
        for (const InputSocket& socket : type->inputs) {
            inputs.append(std::string(socket.identifier));
        }
        for (const OutputSocket& socket : type->outputs) {
            outputs.append(std::string(socket.identifier));
        }
        for (const std::string_view option : type->options) {
            options.append(std::string(option));
        }
        py::dict row;
        row["inputs"] = inputs;
        row["outputs"] = outputs;
        row["options"] = options;
        types[py::str(std::string(type->name))] = row;
    }
    return types;
}

}  // namespace

void bind_nodes(py::module_& m)
{
    using namespace py::literals;

    m.attr("NODE_TYPES") = types_as_dict();
    const py::class_<NodeSocket> socket(m, "NodeSocket", "An output of a node.");
    py::class_<PyNode>(m, "Node", "A node of a graph; node['Color'] is its output of that name.")
        .def(
            "set",
            [](const PyNode& node, const std::string& input, const py::object& value) {
                set_input(node, input, value);
            },
            "input"_a, "value"_a,
            "Feeds an input, by its identifier in Blender: a number, a colour, or an output.")
        .def(
            "__getitem__",
            [](const PyNode& node, const std::string& output) {
                return NodeSocket{node.graph, node.graph->output(node.number, output)};
            },
            "output"_a);
    py::class_<NodeGraph, std::shared_ptr<NodeGraph>>(
        m, "NodeGraph", "Shader nodes of a material, the world or a lamp, as Blender has them.")
        .def(py::init<>())
        .def(
            "add",
            [](const std::shared_ptr<NodeGraph>& graph, const std::string& kind,
               const py::dict& inputs, const py::kwargs& options) {
                PyNode node{graph, graph->add(kind, options_from(options))};
                for (const auto& [input, value] : inputs) {
                    set_input(node, input.cast<std::string>(), value);
                }
                return node;
            },
            "kind"_a, "inputs"_a = py::dict(),
            "A new node of one of NODE_TYPES, with its options by keyword.");
}

}  // namespace eye_render
