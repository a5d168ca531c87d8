"""The portal in PyNite, with so many elements for each member."""

from Pynite import FEModel3D


def hertz(elements):
    model = FEModel3D()
    model.add_material("steel", 2.1e11, 2.1e11 / 2.6, 0.3, 7850.0)
    model.add_section("tube", 6e-3, 2.5e-5, 2.5e-5, 5e-5)
    corners = [(0.0, 0.0), (0.0, 4.0), (6.0, 4.0), (6.0, 0.0)]
    model.add_node("0", *corners[0], 0.0)
    for member, ((x0, y0), (x1, y1)) in enumerate(zip(corners, corners[1:])):
        for k in range(1, elements + 1):
            tag, part = member * elements + k, k / elements
            model.add_node(f"{tag}", x0 + part * (x1 - x0), y0 + part * (y1 - y0), 0.0)
            model.add_member(f"{tag}", f"{tag - 1}", f"{tag}", "steel", "tube")
    last = 3 * elements
    for tag in range(last + 1):
        foot = tag in (0, last)
        model.def_support(f"{tag}", foot, foot, True, True, True, foot)
    model.add_member_self_weight("FY", -1.0)
    model.analyze_modal(num_modes=10)
    return [float(value) for value in model.frequencies]
