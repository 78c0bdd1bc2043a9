Socket = bpy.types.NodeSocket
Value = Socket | float | tuple[float, float, float]
KIND = "ShaderNodeTree"


class Nodes:
    """Makes nodes in columns: each stands to the right of those that it takes values from."""

    def __init__(self, tree: bpy.types.NodeTree) -> None:
        self.tree = tree
        self.column: dict[str, int] = {}
        self.row: dict[int, int] = {}

    def add(self, kind: str, *values: Value | None, label: str = "", **settings: object):
        node = self.tree.nodes.new(kind)
        node.label = label
        for name, value in settings.items():
            setattr(node, name, value)
        column = 0
        for socket, value in zip(node.inputs, values, strict=False):
            if isinstance(value, Socket):
                self.tree.links.new(value, socket)
                column = max(column, self.column[value.node.name] + 1)
            elif value is not None:
                socket.default_value = value
        self.column[node.name] = column
        row = self.row[column] = self.row.get(column, -1) + 1
        node.location = (220 * column, -280 * row)
        return node

    def math(self, operation: str, *values: Value, clamp: bool = False) -> Socket:
        return self.add("ShaderNodeMath", *values, operation=operation, use_clamp=clamp).outputs[0]

    def vector(self, operation: str, *values: Value) -> Socket:
        node = self.add("ShaderNodeVectorMath", *values, operation=operation)
        return node.outputs["Value" if operation == "DOT_PRODUCT" else "Vector"]

    def scale(self, vector: Value, by: Value) -> Socket:
        node = self.add("ShaderNodeVectorMath", vector, operation="SCALE")
        if isinstance(by, Socket):
            self.tree.links.new(by, node.inputs["Scale"])
        else:
            node.inputs["Scale"].default_value = by
        return node.outputs["Vector"]

    def ramp(self, place: Socket, colors: list[tuple[float, float, float]], label: str) -> Socket:
        """Colours at even places from 0, seen face on, to 1, at grazing angles."""
        node = self.add("ShaderNodeValToRGB", place, label=label)
        ramp = node.color_ramp
        ramp.interpolation = "B_SPLINE"
        while len(ramp.elements) < len(colors):
            ramp.elements.new(1.0)
        for k, color in enumerate(colors):
            ramp.elements[k].position = k / (len(colors) - 1)
            ramp.elements[k].color = (*color, 1.0)
        return node.outputs["Color"]


def flake_slopes(nodes: Nodes, normal: Socket, size: Socket) -> Socket:
    """A slope for each cell, as a vector in the surface: Gaussian, of Beckmann's alpha 1."""
    place = nodes.add("ShaderNodeTexCoord").outputs["Object"]
    cells = nodes.add("ShaderNodeTexVoronoi", place, feature="F1", label="Flakes")
    nodes.tree.links.new(nodes.math("DIVIDE", 1.0, size), cells.inputs["Scale"])
    nodes.column[cells.name] = max(nodes.column[cells.name], 2)
    random = nodes.add("ShaderNodeSeparateXYZ", cells.outputs["Color"]).outputs
    steepness = nodes.math("LOGARITHM", nodes.math("MAXIMUM", random["X"], 1e-6), math.e)
    radius = nodes.math("SQRT", nodes.math("MULTIPLY", steepness, -1.0))
    turn = nodes.math("MULTIPLY", random["Y"], 2 * math.pi)
    # Any direction that turns with the object gives the two along the surface.
    axis = nodes.add(
        "ShaderNodeVectorTransform",
        (0.36, 0.48, 0.8),
        vector_type="VECTOR",
        convert_from="OBJECT",
        convert_to="WORLD",
    ).outputs[0]
    across = nodes.vector("NORMALIZE", nodes.vector("CROSS_PRODUCT", normal, axis))
    along = nodes.vector("CROSS_PRODUCT", across, normal)
    x = nodes.math("MULTIPLY", radius, nodes.math("COSINE", turn))
    y = nodes.math("MULTIPLY", radius, nodes.math("SINE", turn))
    return nodes.vector("ADD", nodes.scale(across, x), nodes.scale(along, y))


def build_node_group() -> bpy.types.NodeTree:
    """A new node group: the paint's closures, with inputs for its flakes."""
    group = bpy.data.node_groups.new(f"Nacre {PAINT['name']}", KIND)
    face = group.interface
    sparkle_input = face.new_socket("Sparkle", in_out="INPUT", socket_type="NodeSocketFloat")
    sparkle_input.description = "Share of the lobes' width that is tilt of single flakes"
    sparkle_input.default_value = 0.0
    sparkle_input.min_value, sparkle_input.max_value = 0.0, 0.98
    sparkle_input.subtype = "FACTOR"
    size_input = face.new_socket("Flake Size", in_out="INPUT", socket_type="NodeSocketFloat")
    size_input.description = "Mean size of flakes in the object's units"
    size_input.default_value = PAINT["flake_size"]
    size_input.min_value, size_input.max_value = 1e-7, 1e3
    face.new_socket("BSDF", in_out="OUTPUT", socket_type="NodeSocketShader")

    nodes = Nodes(group)
    inputs = nodes.add("NodeGroupInput").outputs
    geometry = nodes.add("ShaderNodeNewGeometry").outputs
    normal, view = geometry["Normal"], geometry["Incoming"]
    cosine = nodes.math("MAXIMUM", nodes.vector("DOT_PRODUCT", normal, view), 0.01)
    place = nodes.math("DIVIDE", nodes.math("ARCCOSINE", cosine), math.pi / 2)
    towards_view = nodes.scale(nodes.vector("SUBTRACT", view, nodes.scale(normal, cosine)), cosine)
    # The slopes of the flakes and those of each flake's own lobe add to the slopes of the lobe.
    sparkle = inputs["Sparkle"]
    kept = nodes.math("SUBTRACT", 1.0, nodes.math("MULTIPLY", sparkle, sparkle), clamp=True)
    narrowing = nodes.math("POWER", kept, 0.25)
    slopes = nodes.scale(flake_slopes(nodes, normal, inputs["Flake Size"]), sparkle)

    surface = nodes.add("ShaderNodeBsdfDiffuse", (*PAINT["diffuse"], 1.0), 0.0).outputs[0]
    for k, lobe in enumerate(PAINT["lobes"], start=1):
        color = nodes.ramp(place, lobe["color"], f"Lobe {k}, by view")
        widening = nodes.math("POWER", cosine, -0.5 * lobe["widening"])
        roughness = nodes.math("MULTIPLY", widening, lobe["roughness"], clamp=True)
        alpha = nodes.math("MULTIPLY", roughness, roughness)
        tilt = nodes.vector(
            "ADD", nodes.scale(towards_view, lobe["lean"]), nodes.scale(slopes, alpha)
        )
        glossy = nodes.add(
            "ShaderNodeBsdfAnisotropic",
            color,
            nodes.math("MULTIPLY", roughness, narrowing),
            distribution="BECKMANN",
            label=f"Lobe {k}",
        )
        facing = nodes.vector("NORMALIZE", nodes.vector("ADD", normal, tilt))
        group.links.new(facing, glossy.inputs["Normal"])
        surface = nodes.add("ShaderNodeAddShader", surface, glossy.outputs[0]).outputs[0]
    if "coat" in PAINT:
        coat = nodes.add(
            "ShaderNodeBsdfAnisotropic",
            (1.0, 1.0, 1.0, 1.0),
            PAINT["coat"]["roughness"],
            distribution="BECKMANN",
            label="Coat",
        )
        reflected = nodes.add("ShaderNodeFresnel", PAINT["coat"]["ior"]).outputs[0]
        surface = nodes.add("ShaderNodeMixShader", reflected, surface, coat.outputs[0]).outputs[0]
    nodes.add("NodeGroupOutput", surface)
    return group


def build_material() -> bpy.types.Material:
    """A new material of the node group, kept in the file whether an object has it or not."""
    material = bpy.data.materials.new(f"Nacre {PAINT['name']}")
    material.use_fake_user = True
    if material.node_tree is None:  # before Blender 5.0
        material.use_nodes = True
    material.node_tree.nodes.clear()
    nodes = Nodes(material.node_tree)
    group = nodes.add("ShaderNodeGroup", node_tree=build_node_group())
    group.width = 220
    output = nodes.add("ShaderNodeOutputMaterial", group.outputs["BSDF"])
    output.location.x += 80
    return material


if __name__ == "__main__":
    made = build_material()
    active = bpy.context.active_object
    if active is not None and hasattr(active.data, "materials"):
        active.active_material = made
