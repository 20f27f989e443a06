"""Ignatov 2005, title page, abstract and section 1: what reaction wheels are for, the momenta required of them."""

from symcheck.papers.declare import by_cases, definition, exclusion, premise
from symcheck.papers.ignatov2005.notation import requirements

abstract = exclusion(
    "0.1",
    18,
    words="Two arrays of reaction wheels, along the side edges of a four-sided and of a regular six-sided pyramid; the momenta "
    "they can have, also when a wheel fails; how to choose the angles.",
    reason="says what the paper does; the statements follow",
)

abstract_in_english = exclusion(
    "0.2",
    26,
    words="The abstract once more, in English; 'tetrahedral' and 'regular hexahedral' there mean four-sided and regular six-sided.",
    reason="repeats 0.1",
)

purpose_of_actuators = exclusion(
    "1.0.1",
    30,
    words="Electromechanical actuators of attitude control, their mass and power, their three kinds (lines 30 to 38).",
    reason="describes the field; no relation",
)

momenta_required = definition(
    "1.0.2",
    40,
    words="A_T holds the total momenta of the actuators, in body axes, that the control asks for, A_C those they can have.",
    opaque=True,
)

requirement = premise(
    "1.1",
    44,
    r"A_T \subset A_C.",
    words="What is asked for can be had.",
    notation=requirements,
)

sufficient_momentum = exclusion(
    "1.1.1",
    46,
    words="Under (1.1) the momentum of the wheels suffices for the rates required.",
    reason="says what A_T is once more",
)

body_frame = premise("1.1.2", 48, words="OXYZ is right-handed; its axes are the principal central axes of inertia.")

ellipsoid_of_momenta = premise(
    "1.2",
    50,
    r"\frac{(H_{TX})^2}{(J_X w_X)^2} + \frac{(H_{TY})^2}{(J_Y w_Y)^2} + \frac{(H_{TZ})^2}{(J_Z w_Z)^2} = 1,",
    words="A_T is usually bounded by this ellipsoid.",
    notation=requirements,
)


def _on_the_ellipsoid(x: str, y: str, z: str) -> str:
    """A turn about the axis x alone, at the largest rate, takes a momentum on the ellipsoid."""
    return (
        rf"(H_{{T{x}}} = -J_{x} w_{x} \land H_{{T{y}}} = 0 \land H_{{T{z}}} = 0) \Rightarrow "
        r"\frac{H_{TX}^2}{(J_X w_X)^2} + \frac{H_{TY}^2}{(J_Y w_Y)^2} + \frac{H_{TZ}^2}{(J_Z w_Z)^2} = 1"
    )


semi_axes_of_the_ellipsoid = by_cases.ours(
    "1.2.1",
    50,
    words="A turn about one axis alone, at the largest rate and with zero total momentum, takes a momentum at an end of an axis of "
    "the ellipsoid: its semi-axes are J_X w_X, J_Y w_Y, J_Z w_Z.",
    states=(_on_the_ellipsoid("X", "Y", "Z"), _on_the_ellipsoid("Y", "Z", "X"), _on_the_ellipsoid("Z", "X", "Y")),
    uses=["1.2"],
    notation=requirements,
)

letters_of_the_ellipsoid = definition(
    "1.2.2",
    52,
    words="H_TX, H_TY, H_TZ are the components of the momentum required, J_X, J_Y, J_Z the moments of inertia, w_X, w_Y, w_Z the "
    "largest rates required about the axes.",
    opaque=True,
)

shape_can_be_chosen = exclusion(
    "1.2.3",
    54,
    words="A_C depends on how the actuators are placed, and can be fitted to the moments of inertia.",
    reason="announces sections 2.3 and 3.3",
)

why_wheels = exclusion(
    "1.2.4", 56, words="Two arrays of wheels are treated; wheels are cheap and simple.", reason="no relation"
)

torques_likewise = exclusion(
    "1.2.5",
    58,
    words="The same construction gives the torques the wheels can exert.",
    reason="a torque is the same combination of the axes, with the rates of the h_i in place of the h_i; no relation of its own",
)
