"""The portal in OpenSeesPy, with so many elements for each member."""

import math

import openseespy.opensees as ops


def hertz(elements):
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    corners = [(0.0, 0.0), (0.0, 4.0), (6.0, 4.0), (6.0, 0.0)]
    ops.node(0, *corners[0])
    for member, ((x0, y0), (x1, y1)) in enumerate(zip(corners, corners[1:])):
        for k in range(1, elements + 1):
            tag, part = member * elements + k, k / elements
            ops.node(tag, x0 + part * (x1 - x0), y0 + part * (y1 - y0))
            ops.element("elasticBeamColumn", tag, tag - 1, tag, 6e-3, 2.1e11, 2.5e-5, 1, "-mass", 47.1, "-cMass")
    for foot in (0, 3 * elements):
        ops.fix(foot, 1, 1, 1)
    return [math.sqrt(square) / math.tau for square in ops.eigen(10)]
