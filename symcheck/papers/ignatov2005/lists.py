r"""Ignatov 2005: the lists of vertices, edges and faces, and the tables of coordinates, as they stand in the source.

They are read row by row (`symcheck.papers.listing`); what each row states, and the right one where it is wrong, is
worked out in `rows` and declared in `listed`.
"""

from fractions import Fraction
from functools import cache

from symcheck.core.claims import Hypothesis
from symcheck.papers.ignatov2005 import derivation
from symcheck.papers.ignatov2005.hypotheses import real_base, real_pyramid
from symcheck.papers.ignatov2005.listed import Block, Printed, declared
from symcheck.papers.ignatov2005.notation import five_of_six, four_wheels, six_wheels, three_of_four
from symcheck.papers.ignatov2005.rows import Array

# The axes of the four-sided pyramid in units of (sin a sin b, sin a cos b, cos a), those of the six-sided one in units of
# (sqrt(3)/2 sin a, 1/2 sin a, cos a). Normals have units so that products with axes are whole multiples of one unit.
ONE, HALF = Fraction(1), Fraction(1, 2)
FOUR_AXES = ((1, -1, -1), (1, 1, -1), (1, -1, 1), (1, 1, 1))  # by wheel, in the units below (2.0.4)
FOUR_UNITS = ((ONE, "", r"\sin a \sin b"), (ONE, "", r"\sin a \cos b"), (ONE, "", r"\cos a"))
FOUR_NORMALS = (r"\cos a \cos b", r"\cos a \sin b", r"\sin a \sin b \cos b")
# by wheel, in the units below (3.0.4)
SIX_AXES = ((0, -2, 1), (1, -1, 1), (1, 1, 1), (0, -2, -1), (1, -1, -1), (1, 1, -1))
SIX_UNITS = ((HALF, r"\sqrt{3}", r"\sin a"), (HALF, "", r"\sin a"), (ONE, "", r"\cos a"))
SIX_NORMALS = (r"\frac{2\sqrt{3}}{3} \cos a", r"2 \cos a", r"\sin a")
six_axes = cache(derivation.six_axes)

ANGLES_OF_FOUR = Hypothesis(
    "angles of the table", "a = 67 and b = 32 degrees (lines 128, 211)", r"a = 67^\circ, b = 32^\circ"
)
ANGLE_OF_SIX = Hypothesis("angle of the table", "a = 72 degrees (lines 404, 554)", r"a = 72^\circ")
OPEN_RANGE = (real_pyramid, real_base)

four = Array("2.1", FOUR_AXES, FOUR_UNITS, FOUR_NORMALS, four_wheels, OPEN_RANGE, ANGLES_OF_FOUR)
three = Array("2.2", FOUR_AXES[:3], FOUR_UNITS, FOUR_NORMALS, three_of_four, OPEN_RANGE, ANGLES_OF_FOUR)
six = Array("3.1", SIX_AXES, SIX_UNITS, SIX_NORMALS, six_wheels, (real_pyramid,), ANGLE_OF_SIX, six_axes)
five = Array("3.2", SIX_AXES[:5], SIX_UNITS, SIX_NORMALS, five_of_six, (real_pyramid,), ANGLE_OF_SIX, six_axes)

# --- 2.1

VERTICES_OF_FOUR = Block(
    85,
    r"""1) $V_1 : \mathbf{H} = [1, 1, 1, 1] = (4 \sin a \sin b, 0, 0)$ ,	$\{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\}$ ,
2) $V_2 : \mathbf{H} = [-1, 1, 1, 1] = (2 \sin a \sin b, 2 \sin a \cos b, 2 \cos a)$ ,	$\{\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_4\}$ ,
3) $V_3 : \mathbf{H} = [1, -1, 1, 1] = (2 \sin a \sin b, -2 \sin a \cos b, 2 \cos a)$ ,	$\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3\}$ ,
4) $V_4 : \mathbf{H} = [1, 1, -1, 1] = (2 \sin a \sin b, 2 \sin a \cos b, -2 \cos a)$ ,	$\{-\mathbf{e}_1, -\mathbf{e}_3, \mathbf{e}_4\}$ ,
5) $V_5 : \mathbf{H} = [1, 1, 1, -1] = (2 \sin a \sin b, -2 \sin a \cos b, -2 \cos a)$ ,	$\{-\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4\}$ ,
6) $V_6 : \mathbf{H} = [1, -1, 1, -1] = (0, -4 \sin a \cos b, 0)$ ,	$\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4\}$ ,
7) $V_7 : \mathbf{H} = [1, 1, -1, -1] = (0, 0, -4 \cos a)$ ,	$\{-\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\}$ ,
8) $V'_1 : \mathbf{H} = [-1, -1, 1, 1] = (0, 0, 4 \cos a)$ ,	$\{\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\}$ ,
9) $V'_6 : \mathbf{H} = [-1, 1, -1, 1] = (0, 4 \sin a \cos b, 0)$ ,	$\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4\}$ ,
10) $V'_5 : \mathbf{H} = [-1, -1, -1, 1] = (-2 \sin a \sin b, 2 \sin a \cos b, 2 \cos a)$ ,	$\{\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4\}$ ,
11) $V'_4 : \mathbf{H} = [-1, -1, 1, -1] = (-2 \sin a \sin b, -2 \sin a \cos b, 2 \cos a)$ ,	$\{\mathbf{e}_1, \mathbf{e}_3, -\mathbf{e}_4\}$ ,
12) $V'_3 : \mathbf{H} = [-1, 1, -1, -1] = (-2 \sin a \sin b, 2 \sin a \cos b, -2 \cos a)$ ,	$\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3\}$ ,
13) $V'_2 : \mathbf{H} = [1, -1, -1, -1] = (-2 \sin a \sin b, -2 \sin a \cos b, -2 \cos a)$ ,	$\{-\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_4\}$ ,
14) $V'_1 : \mathbf{H} = [-1, -1, -1, -1] = (-4 \sin a \sin b, 0, 0)$ ,	$\{\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\}$ .""",
)

EDGES_OF_FOUR = Block(
    102,
    r"""1) $V_2 V_1 : \mathbf{H} = [u, 1, 1, 1]$ ,	9) $V_3 V_7 : \mathbf{H} = [u, 1, -1, -1]$ ,	17) $V_2 V_7 : \mathbf{H} = [1, u, -1, -1]$ ,
2) $V_3 V_1 : \mathbf{H} = [1, u, 1, 1]$ ,	10) $V_3 V'_6 : \mathbf{H} = [-1, 1, -1, u]$ ,	18) $V_4 V_6 : \mathbf{H} = [u, -1, 1, -1]$ ,
3) $V_4 V_1 : \mathbf{H} = [1, 1, u, 1]$ ,	11) $V_5 V'_7 : \mathbf{H} = [-1, -1, u, 1]$ ,	19) $V_2 V_6 : \mathbf{H} = [1, -1, u, -1]$ ,
4) $V_5 V_1 : \mathbf{H} = [1, 1, 1, u]$ ,	12) $V_5 V'_6 : \mathbf{H} = [-1, u, -1, 1]$ ,	20) $V_4 V'_7 : \mathbf{H} = [-1, -1, 1, u]$ ,
5) $V_7 V_3 : \mathbf{H} = [u, -1, 1, 1]$ ,	13) $V_6 V_4 : \mathbf{H} = [u, 1, -1, 1]$ ,	21) $V_1 V'_3 : \mathbf{H} = [-1, u, -1, -1]$ ,
6) $V_7 V_2 : \mathbf{H} = [-1, u, 1, 1]$ ,	14) $V_6 V_2 : \mathbf{H} = [-1, 1, u, 1]$ ,	22) $V_1 V'_4 : \mathbf{H} = [-1, -1, u, -1]$ ,
7) $V_7 V_5 : \mathbf{H} = [1, 1, u, -1]$ ,	15) $V_6 V_3 : \mathbf{H} = [1, -1, 1, u]$ ,	23) $V_1 V'_5 : \mathbf{H} = [u, -1, -1, -1]$ ,
8) $V_7 V_4 : \mathbf{H} = [1, 1, -1, u]$ ,	16) $V_6 V_5 : \mathbf{H} = [1, u, 1, -1]$ ,	24) $V_1 V'_5 : \mathbf{H} = [-1, -1, -1, u]$ .""",
)

FACES_OF_FOUR = Block(
    115,
    r"""| 1) $F_1 = \{V_1V_4, V_4V_7, V_7V_5, V_5V_1\}$ ,       | $\mathbf{H} = [1, 1, u, v]$ ,   |
| 2) $F'_1 = \{V_1V'_4, V_4V'_7, V_7V'_5, V_5V'_1\}$ ,  | $\mathbf{H} = [-1, -1, u, v]$ , |
| 3) $F_2 = \{V_4V'_6, V_6V'_3, V_3V_7, V_7V_4\}$ ,     | $\mathbf{H} = [u, 1, -1, v]$ ,  |
| 4) $F'_2 = \{V_4V_6, V_6V_3, V_3V'_7, V_7V'_4\}$ ,    | $\mathbf{H} = [u, -1, 1, v]$ ,  |
| 5) $F_3 = \{V_1V_5, V_5V_6, V_6V_3, V_3V_1\}$ ,       | $\mathbf{H} = [1, u, 1, v]$ ,   |
| 6) $F'_3 = \{V_1V'_5, V_5V'_6, V_6V'_3, V_3V'_1\}$ ,  | $\mathbf{H} = [-1, u, -1, v]$ , |
| 7) $F_4 = \{V_5V_7, V_7V'_2, V_2V_6, V_6V_5\}$ ,      | $\mathbf{H} = [1, u, v, -1]$ ,  |
| 8) $F'_4 = \{V_5V'_7, V_7V'_2, V_2V'_6, V_6V'_5\}$ ,  | $\mathbf{H} = [-1, u, v, 1]$ ,  |
| 9) $F_5 = \{V_1V_3, V_3V'_7, V_7V_2, V_2V_1\}$ ,      | $\mathbf{H} = [u, v, 1, 1]$ ,   |
| 10) $F'_5 = \{V_1V'_3, V_3V'_7, V_7V'_2, V_2V'_1\}$ , | $\mathbf{H} = [u, v, -1, -1]$ , |
| 11) $F_6 = \{V_2V'_6, V_6V'_4, V_4V_1, V_1V_2\}$ ,    | $\mathbf{H} = [u, 1, v, 1]$ ,   |
| 12) $F'_6 = \{V_2V_6, V_6V_4, V_4V'_1, V_1V'_2\}$ ,   | $\mathbf{H} = [u, -1, v, -1]$ . |""",
)

TABLE_1 = Block(
    132,
    r"""Вершина	$X$	$Y$	$Z$
$V_1$	1.951	0	0
$V_2$	0.976	1.561	0.781
$V_3$	0.976	-1.561	0.781
$V_4$	0.976	1.561	-0.781
$V_5$	0.976	-1.561	-0.781
$V_6$	0	-3.123	0
$V_7$	0	0	-1.563
$V'_7$	0	0	1.563
$V'_6$	0	3.123	0
$V'_5$	-0.976	1.561	0.781
$V'_4$	-0.976	-1.561	0.781
$V'_3$	-0.976	1.561	-0.781
$V'_2$	-0.976	-1.561	-0.781
$V'_1$	-1.951	0	0""",
)

printed_four = Printed(four, VERTICES_OF_FOUR, EDGES_OF_FOUR, FACES_OF_FOUR, TABLE_1, 1)
of_four = declared(printed_four)
names_of_four = of_four.defined
vertices_of_four = of_four.vertices
edges_of_four = of_four.edges
faces_of_four = of_four.faces
table_1 = of_four.table

# --- 2.2

VERTICES_OF_THREE = Block(
    197,
    r"""$$\begin{aligned} 1) V_1 : \mathbf{H} = [1, 1, 1] &= (3 \sin a \sin b, -\sin a \cos b, -\cos a), & \{\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3\}, \\ 2) V_2 : \mathbf{H} = [-1, 1, 1] &= (\sin a \sin b, \sin a \cos b, \cos a), & \{\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3\}, \\ 3) V_3 : \mathbf{H} = [1, -1, 1] &= (\sin a \sin b, -3 \sin a \cos b, \cos a), & \{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3\}, \\ 4) V_4 : \mathbf{H} = [1, 1, -1] &= (\sin a \sin b, \sin a \cos b, -3 \cos a), & \{-\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3\}, \\ 5) V'_4 : \mathbf{H} = [-1, -1, 1] &= (-\sin a \sin b, -\sin a \cos b, 3 \cos a), & \{\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3\}, \\ 6) V'_3 : \mathbf{H} = [-1, 1, -1] &= (-\sin a \sin b, 3 \sin a \cos b, -\cos a), & \{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3\}, \\ 7) V'_2 : \mathbf{H} = [1, -1, -1] &= (-\sin a \sin b, -\sin a \cos b, -\cos a), & \{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3\}, \\ 8) V'_1 : \mathbf{H} = [-1, -1, -1] &= (-3 \sin a \sin b, \sin a \cos b, \cos a), & \{-\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3\}. \end{aligned}$$""",
)

EDGES_OF_THREE = Block(
    201,
    r"""$$\begin{aligned} 1) V_2 V_1 : \mathbf{H} = [u, 1, 1], & \quad 5) V_4 V_3 : \mathbf{H} = [u, -1, 1], & \quad 9) V_1 V'_4 : \mathbf{H} = [-1, -1, u], \\ 2) V_3 V_1 : \mathbf{H} = [1, u, 1], & \quad 6) V_2 V_3 : \mathbf{H} = [1, -1, u], & \quad 10) V_2 V'_4 : \mathbf{H} = [1, u, -1], \\ 3) V_4 V_1 : \mathbf{H} = [1, 1, u], & \quad 7) V_1 V'_2 : \mathbf{H} = [u, -1, -1], & \quad 11) V_3 V'_4 : \mathbf{H} = [u, 1, -1], \\ 4) V_4 V_2 : \mathbf{H} = [-1, u, 1], & \quad 8) V_1 V'_3 : \mathbf{H} = [-1, u, -1], & \quad 12) V_3 V'_2 : \mathbf{H} = [-1, 1, u]. \end{aligned}$$""",
)

FACES_OF_THREE = Block(
    205,
    r"""$$\begin{aligned} 1) F_1 &= \{V_1 V_2, V_2 V'_4, V_4 V_3, V_3 V_1\}, & \mathbf{H} = [u, v, 1], \\ 2) F_2 &= \{V_1 V_3, V_3 V'_2, V_2 V_4, V_4 V_1\}, & \mathbf{H} = [1, u, v], \\ 3) F_3 &= \{V_1 V_4, V_4 V'_3, V_3 V_2, V_2 V_1\}, & \mathbf{H} = [u, 1, v], \\ 4) F'_1 &= \{V_1 V'_2, V_2 V_4, V_4 V'_3, V_3 V'_1\}, & \mathbf{H} = [u, v, -1], \end{aligned}$$

$$5) F'_2 = \{V_1V'_3, V_3V_2, V_2V'_4, V_4V_1\}, \quad \mathbf{H} = [-1, u, v],$$

$$6) F'_3 = \{V_1V'_4, V_4V_3, V_3V'_2, V_2V_1\}, \quad \mathbf{H} = [u, -1, v].$$""",
)

TABLE_4 = Block(
    215,
    r"""Вершина	$X$	$Y$	$Z$
$V_1$	1.463	-0.781	-0.391
$V_2$	0.488	0.781	0.391
$V_3$	0.488	-2.342	0.391
$V_4$	0.488	0.781	-1.172
$V'_4$	-0.488	-0.781	1.172
$V'_3$	-0.488	2.342	-0.391
$V'_2$	-0.488	-0.781	-0.391
$V'_1$	-1.463	0.781	0.391""",
)

printed_three = Printed(three, VERTICES_OF_THREE, EDGES_OF_THREE, FACES_OF_THREE, TABLE_4, 4)
of_three = declared(printed_three)
names_of_three = of_three.defined
vertices_of_three = of_three.vertices
edges_of_three = of_three.edges
faces_of_three = of_three.faces
table_4 = of_three.table

# --- 3.1

VERTICES_OF_SIX = Block(
    293,
    r"""| 1) $V_1 : \mathbf{H} = [1,1,1,-1,-1,-1] = (0,0,6 \cos a),$                                | $\{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4, \mathbf{e}_5, \mathbf{e}_6\},$ |
| 2) $V_2 : \mathbf{H} = [-1,1,1,-1,-1,-1] = (0,2 \sin a,4 \cos a),$                        | $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_6\},$   |
| 3) $V_3 : \mathbf{H} = [1,-1,1,-1,-1,-1] = (-\sqrt{3} \sin a, \sin a,4 \cos a),$          | $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3\},$  |
| 4) $V_4 : \mathbf{H} = [1,1,-1,-1,-1,-1] = (-\sqrt{3} \sin a, -\sin a,4 \cos a),$         | $\{-\mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\},$   |
| 5) $V_5 : \mathbf{H} = [1,1,1,1,-1,-1] = (0,-2 \sin a,4 \cos a),$                         | $\{-\mathbf{e}_3, -\mathbf{e}_4, \mathbf{e}_5\},$  |
| 6) $V_6 : \mathbf{H} = [1,1,1,-1,1,-1] = (\sqrt{3} \sin a, -\sin a,4 \cos a),$            | $\{\mathbf{e}_4, -\mathbf{e}_5, \mathbf{e}_6\},$   |
| 7) $V_7 : \mathbf{H} = [1,1,1,-1,-1,1] = (\sqrt{3} \sin a, \sin a,4 \cos a),$             | $\{-\mathbf{e}_1, \mathbf{e}_5, -\mathbf{e}_6\},$  |
| 8) $V_8 : \mathbf{H} = [-1,1,1,-1,-1,1] = (\sqrt{3} \sin a, 3 \sin a,2 \cos a),$          | $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_5, -\mathbf{e}_6\},$                              |
| 9) $V_9 : \mathbf{H} = [-1,-1,1,-1,-1,-1] = (-\sqrt{3} \sin a, 3 \sin a,2 \cos a),$       | $\{\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_6\},$                               |
| 10) $V_{10} : \mathbf{H} = [1,-1,-1,-1,-1,-1] = (-2\sqrt{3} \sin a, 0,2 \cos a),$         | $\{-\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\},$                               |
| 11) $V_{11} : \mathbf{H} = [1,1,-1,1,-1,-1] = (-\sqrt{3} \sin a, -3 \sin a,2 \cos a),$    | $\{-\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4, \mathbf{e}_5\},$                              |
| 12) $V_{12} : \mathbf{H} = [1,1,1,1,1,-1] = (\sqrt{3} \sin a, -3 \sin a,2 \cos a),$       | $\{-\mathbf{e}_3, -\mathbf{e}_4, -\mathbf{e}_5, \mathbf{e}_6\},$                             |
| 13) $V_{13} : \mathbf{H} = [1,1,1,-1,1,1] = (2\sqrt{3} \sin a, 0,2 \cos a),$              | $\{-\mathbf{e}_1, \mathbf{e}_4, -\mathbf{e}_5, -\mathbf{e}_6\},$                             |
| 14) $V_{14} : \mathbf{H} = [-1,1,1,-1,1,1] = (2\sqrt{3} \sin a, 2 \sin a, 0),$            | $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_4, -\mathbf{e}_5\},$                              |
| 15) $V_{15} : \mathbf{H} = [-1,-1,1,-1,-1,1] = (0,4 \sin a, 0),$                          | $\{\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_5, -\mathbf{e}_6\},$                              |
| 16) $V_{16} : \mathbf{H} = [-1,-1,-1,-1,-1,-1] = (-2\sqrt{3} \sin a, 2 \sin a, 0),$       | $\{\mathbf{e}_1, \mathbf{e}_3, \mathbf{e}_4, \mathbf{e}_6\},$                                |
| 17) $V'_{16} : \mathbf{H} = [1,1,1,1,1,1] = (2\sqrt{3} \sin a, -2 \sin a, 0),$            | $\{-\mathbf{e}_1, -\mathbf{e}_3, -\mathbf{e}_4, -\mathbf{e}_6\},$                            |
| 18) $V'_{15} : \mathbf{H} = [1,1,-1,1,1,-1] = (0,-4 \sin a, 0),$                          | $\{-\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_5, \mathbf{e}_6\},$                              |
| 19) $V'_{14} : \mathbf{H} = [1,-1,-1,1,-1,-1] = (-2\sqrt{3} \sin a, -2 \sin a, 0),$       | $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_4, \mathbf{e}_5\},$                              |
| 20) $V'_{13} : \mathbf{H} = [-1,-1,-1,1,-1,-1] = (-2\sqrt{3} \sin a, 0,-2 \cos a),$       | $\{\mathbf{e}_1, -\mathbf{e}_4, \mathbf{e}_5, \mathbf{e}_6\},$                               |
| 21) $V'_{12} : \mathbf{H} = [-1,-1,-1,-1,-1,1] = (-\sqrt{3} \sin a, 3 \sin a,-2 \cos a),$ | $\{\mathbf{e}_3, \mathbf{e}_4, \mathbf{e}_5, -\mathbf{e}_6\},$                               |
| 22) $V'_{11} : \mathbf{H} = [-1,-1,1,-1,1,1] = (\sqrt{3} \sin a, 3 \sin a,-2 \cos a),$    | $\{\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4, -\mathbf{e}_5\},$                              |
| 23) $V'_{10} : \mathbf{H} = [-1,1,1,1,1,1] = (2\sqrt{3} \sin a, 0,-2 \cos a),$            | $\{\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\},$                             |
| 24) $V'_9 : \mathbf{H} = [1,1,-1,1,1,1] = (\sqrt{3} \sin a, -3 \sin a,-2 \cos a),$        | $\{-\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_6\},$                             |
| 25) $V'_8 : \mathbf{H} = [1,-1,-1,1,1,-1] = (-\sqrt{3} \sin a, -3 \sin a,-2 \cos a),$     | $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_5, \mathbf{e}_6\},$                              |
| 26) $V'_7 : \mathbf{H} = [-1,-1,-1,1,1,-1] = (-\sqrt{3} \sin a, -\sin a,-4 \cos a),$      | $\{\mathbf{e}_1, -\mathbf{e}_5, \mathbf{e}_6\},$   |
| 27) $V'_6 : \mathbf{H} = [-1,-1,-1,1,-1,1] = (-\sqrt{3} \sin a, \sin a,-4 \cos a),$       | $\{-\mathbf{e}_4, \mathbf{e}_5, -\mathbf{e}_6\},$  |
| 28) $V'_5 : \mathbf{H} = [-1,-1,-1,-1,1,1] = (0,2 \sin a,-4 \cos a),$                     | $\{\mathbf{e}_3, \mathbf{e}_4, -\mathbf{e}_5\},$   |
| 29) $V'_4 : \mathbf{H} = [-1,-1,1,1,1,1] = (\sqrt{3} \sin a, \sin a,-4 \cos a),$          | $\{\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\},$  |
| 30) $V'_3 : \mathbf{H} = [-1,1,-1,1,1,1] = (\sqrt{3} \sin a, -\sin a,-4 \cos a),$         | $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3\},$   |
| 31) $V'_2 : \mathbf{H} = [1,-1,-1,1,1,1] = (0,-2 \sin a,-4 \cos a),$                      | $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_6\},$  |
| 32) $V'_1 : \mathbf{H} = [-1,-1,-1,1,1,1] = (0,0,-6 \cos a),$                             | $\{\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4, -\mathbf{e}_5, -\mathbf{e}_6\}.$ |""",
)

EDGES_OF_SIX = Block(
    334,
    r"""| 1) $V_2V_1 : \mathbf{H} = [u, 1, 1, -1, -1, -1]$ ,           | 31) $V_3V_1 : \mathbf{H} = [1, u, 1, -1, -1, -1]$ ,          |
| 2) $V_4V_1 : \mathbf{H} = [1, 1, u, -1, -1, -1]$ ,           | 32) $V_1V_5 : \mathbf{H} = [1, 1, 1, u, -1, -1]$ ,           |
| 3) $V_1V_6 : \mathbf{H} = [1, 1, 1, -1, u, -1]$ ,            | 33) $V_1V_7 : \mathbf{H} = [1, 1, 1, -1, -1, u]$ ,           |
| 4) $V_9V_2 : \mathbf{H} = [-1, u, 1, -1, -1, -1]$ ,          | 34) $V_2V_8 : \mathbf{H} = [-1, 1, 1, -1, -1, u]$ ,          |
| 5) $V_9V_3 : \mathbf{H} = [u, -1, 1, -1, -1, -1]$ ,          | 35) $V_{10}V_3 : \mathbf{H} = [1, -1, u, -1, -1, -1]$ ,      |
| 6) $V_{10}V_4 : \mathbf{H} = [1, u, -1, -1, -1, -1]$ ,       | 36) $V_4V_{11} : \mathbf{H} = [1, 1, -1, u, -1, -1]$ ,       |
| 7) $V_{11}V_5 : \mathbf{H} = [1, 1, u, 1, -1, -1]$ ,         | 37) $V_5V_{12} : \mathbf{H} = [1, 1, 1, 1, u, -1]$ ,         |
| 8) $V_6V_{12} : \mathbf{H} = [1, 1, 1, u, 1, -1]$ ,          | 38) $V_6V_{13} : \mathbf{H} = [1, 1, 1, -1, 1, u]$ ,         |
| 9) $V_7V_{13} : \mathbf{H} = [1, 1, 1, -1, u, 1]$ ,          | 39) $V_8V_7 : \mathbf{H} = [u, 1, 1, -1, -1, 1]$ ,           |
| 10) $V_8V_{14} : \mathbf{H} = [-1, 1, 1, -1, u, 1]$ ,        | 40) $V_{15}V_8 : \mathbf{H} = [-1, u, 1, -1, -1, 1]$ ,       |
| 11) $V_9V_{15} : \mathbf{H} = [-1, -1, 1, -1, -1, u]$ ,      | 41) $V_{16}V_9 : \mathbf{H} = [-1, -1, u, -1, -1, -1]$ ,     |
| 12) $V_{16}V_{10} : \mathbf{H} = [u, -1, -1, -1, -1, -1]$ ,  | 42) $V_{10}V'_{14} : \mathbf{H} = [1, -1, -1, u, -1, -1]$ ,  |
| 13) $V'_{14}V_{11} : \mathbf{H} = [1, u, -1, 1, -1, -1]$ ,   | 43) $V_{11}V'_{15} : \mathbf{H} = [1, 1, -1, 1, u, -1]$ ,    |
| 14) $V'_{15}V_{12} : \mathbf{H} = [1, 1, u, 1, 1, -1]$ ,     | 44) $V_{12}V'_{16} : \mathbf{H} = [1, 1, 1, 1, 1, u]$ ,      |
| 15) $V_{13}V'_{16} : \mathbf{H} = [1, 1, 1, u, 1, 1]$ ,      | 45) $V_{14}V_{13} : \mathbf{H} = [u, 1, 1, -1, 1, 1]$ ,      |
| 16) $V'_{13}V'_{14} : \mathbf{H} = [u, -1, -1, 1, -1, -1]$ , | 46) $V_{16}V'_{13} : \mathbf{H} = [-1, -1, -1, u, -1, -1]$ , |
| 17) $V_{16}V'_{12} : \mathbf{H} = [-1, -1, -1, -1, -1, u]$ , | 47) $V'_{12}V_{15} : \mathbf{H} = [-1, -1, u, -1, -1, 1]$ ,  |
| 18) $V_{15}V'_{11} : \mathbf{H} = [-1, -1, 1, -1, u, 1]$ ,   | 48) $V'_{11}V_{14} : \mathbf{H} = [-1, u, 1, -1, 1, 1]$ ,    |
| 19) $V_{14}V'_{10} : \mathbf{H} = [-1, 1, 1, u, 1, 1]$ ,     | 49) $V'_{10}V'_{16} : \mathbf{H} = [u, 1, 1, 1, 1, 1]$ ,     |
| 20) $V_9V'_{16} : \mathbf{H} = [1, 1, u, 1, 1, 1]$ ,         | 50) $V'_{15}V'_9 : \mathbf{H} = [1, 1, -1, 1, 1, u]$ ,       |
| 21) $V_8V'_{15} : \mathbf{H} = [1, u, -1, 1, 1, -1]$ ,       | 51) $V'_{14}V'_8 : \mathbf{H} = [1, -1, -1, 1, u, -1]$ ,     |
| 22) $V_7V'_8 : \mathbf{H} = [u, -1, -1, 1, 1, -1]$ ,         | 52) $V'_{13}V'_7 : \mathbf{H} = [-1, -1, -1, 1, u, 1]$ ,     |
| 23) $V'_{13}V'_6 : \mathbf{H} = [-1, -1, -1, 1, -1, u]$ ,    | 53) $V'_{12}V'_6 : \mathbf{H} = [-1, -1, -1, u, -1, 1]$ ,    |
| 24) $V'_{12}V'_5 : \mathbf{H} = [-1, -1, -1, -1, u, 1]$ ,    | 54) $V_5V'_{11} : \mathbf{H} = [-1, -1, u, -1, 1, 1]$ ,      |
| 25) $V'_{11}V'_4 : \mathbf{H} = [-1, -1, 1, u, 1, 1]$ ,      | 55) $V_4V'_{10} : \mathbf{H} = [-1, u, 1, 1, 1, 1]$ ,        |
| 26) $V_3V'_{10} : \mathbf{H} = [-1, 1, u, 1, 1, 1]$ ,        | 56) $V_3V'_9 : \mathbf{H} = [u, 1, -1, 1, 1, 1]$ ,           |
| 27) $V_2V'_9 : \mathbf{H} = [1, u, -1, 1, 1, 1]$ ,           | 57) $V_8V'_2 : \mathbf{H} = [1, -1, -1, 1, 1, u]$ ,          |
| 28) $V_7V'_1 : \mathbf{H} = [-1, -1, -1, 1, 1, u]$ ,         | 58) $V_6V'_1 : \mathbf{H} = [-1, -1, -1, 1, u, 1]$ ,         |
| 29) $V_5V'_1 : \mathbf{H} = [-1, -1, -1, u, 1, 1]$ ,         | 59) $V_1V'_4 : \mathbf{H} = [-1, -1, u, 1, 1, 1]$ ,          |
| 30) $V_1V'_3 : \mathbf{H} = [-1, u, -1, 1, 1, 1]$ ,          | 60) $V_1V'_2 : \mathbf{H} = [u, -1, -1, 1, 1, 1]$            |""",
)

FACES_OF_SIX = Block(
    371,
    r"""| 1) $F_1 = \{V_1V_2, V_2V_8, V_8V_7, V_7V_1\}$ ,                                  | $\mathbf{H} = [u, 1, 1, -1, -1, v]$ ,   |
| 2) $F'_1 = \{V'_1V'_2, V'_2V'_8, V'_8V'_7, V'_7V'_1\}$ ,                         | $\mathbf{H} = [u, -1, -1, 1, 1, v]$ ,   |
| 3) $F_2 = \{V_1V_3, V_3V_9, V_9V_2, V_2V_1\}$ ,                                  | $\mathbf{H} = [u, v, 1, -1, -1, -1]$ ,  |
| 4) $F'_2 = \{V'_1V'_3, V'_3V'_9, V'_9V'_2, V'_2V'_1\}$ ,                         | $\mathbf{H} = [u, v, -1, 1, 1, 1]$ ,    |
| 5) $F_3 = \{V_1V_4, V_4V_{10}, V_{10}V_3, V_3V_1\}$ ,                            | $\mathbf{H} = [1, u, v, -1, -1, -1]$ ,  |
| 6) $F'_3 = \{V'_1V'_4, V'_4V'_{10}, V'_{10}V'_3, V'_3V'_1\}$ ,                   | $\mathbf{H} = [-1, u, v, 1, 1, 1]$ ,    |
| 7) $F_4 = \{V_1V_5, V_5V_{11}, V_{11}V_4, V_4V_1\}$ ,                            | $\mathbf{H} = [1, 1, u, v, -1, -1]$ ,   |
| 8) $F'_4 = \{V'_1V'_5, V'_5V'_{11}, V'_{11}V'_4, V'_4V'_1\}$ ,                   | $\mathbf{H} = [-1, -1, u, v, 1, 1]$ ,   |
| 9) $F_5 = \{V_1V_6, V_6V_{12}, V_{12}V_5, V_5V_1\}$ ,                            | $\mathbf{H} = [1, 1, 1, u, v, -1]$ ,    |
| 10) $F'_5 = \{V'_1V'_6, V'_6V'_{12}, V'_{12}V'_5, V'_5V'_1\}$ ,                  | $\mathbf{H} = [-1, -1, -1, u, v, 1]$ ,  |
| 11) $F_6 = \{V_1V_7, V_7V_{13}, V_{13}V_6, V_6V_1\}$ ,                           | $\mathbf{H} = [1, 1, 1, -1, u, v]$ ,    |
| 12) $F'_6 = \{V'_1V'_7, V'_7V'_{13}, V'_{13}V'_6, V'_6V'_1\}$ ,                  | $\mathbf{H} = [-1, -1, -1, 1, u, v]$ ,  |
| 13) $F_7 = \{V_7V_8, V_8V_{14}, V_{14}V_{13}, V_{13}V_7\}$ ,                     | $\mathbf{H} = [u, 1, 1, -1, v, 1]$ ,    |
| 14) $F'_7 = \{V'_7V'_8, V'_8V'_{14}, V'_{14}V'_{13}, V'_{13}V'_7\}$ ,            | $\mathbf{H} = [u, -1, -1, 1, v, -1]$ ,  |
| 15) $F_8 = \{V_8V_2, V_2V_9, V_9V_{15}, V_{15}V_8\}$ ,                           | $\mathbf{H} = [-1, u, 1, -1, -1, v]$ ,  |
| 16) $F'_8 = \{V'_8V'_2, V'_2V'_9, V'_9V'_{15}, V'_{15}V'_8\}$ ,                  | $\mathbf{H} = [1, u, -1, 1, 1, v]$ ,    |
| 17) $F_9 = \{V_9V_3, V_3V_{10}, V_{10}V_{16}, V_{16}V_9\}$ ,                     | $\mathbf{H} = [u, -1, v, -1, -1, -1]$ , |
| 18) $F'_9 = \{V'_9V'_3, V'_3V'_{10}, V'_{10}V'_{16}, V'_{16}V'_9\}$ ,            | $\mathbf{H} = [u, 1, v, 1, 1, 1]$ ,     |
| 19) $F_{10} = \{V_{10}V_4, V_4V_{11}, V_{11}V'_{14}, V'_{14}V_{10}\}$ ,          | $\mathbf{H} = [1, u, -1, v, -1, -1]$ ,  |
| 20) $F'_{10} = \{V'_{10}V'_4, V'_4V'_{11}, V'_{11}V_{14}, V_{14}V'_{10}\}$ ,     | $\mathbf{H} = [-1, u, 1, v, 1, 1]$ ,    |
| 21) $F_{11} = \{V_{11}V_5, V_5V_{12}, V_{12}V'_{15}, V'_{15}V_{11}\}$ ,          | $\mathbf{H} = [1, 1, u, 1, v, -1]$ ,    |
| 22) $F'_{11} = \{V'_{11}V'_5, V'_5V'_{12}, V'_{12}V_{15}, V_{15}V'_{11}\}$ ,     | $\mathbf{H} = [-1, -1, u, -1, v, 1]$ ,  |
| 23) $F_{12} = \{V_{12}V_6, V_6V_{13}, V_{13}V'_{16}, V'_{16}V_{12}\}$ ,          | $\mathbf{H} = [1, 1, 1, u, 1, v]$ ,     |
| 24) $F'_{12} = \{V'_{12}V'_6, V'_6V'_{13}, V'_{13}V_{16}, V_{16}V'_{12}\}$ ,     | $\mathbf{H} = [-1, -1, -1, u, -1, v]$ , |
| 25) $F_{13} = \{V_{13}V_{14}, V_{14}V'_{10}, V'_{10}V'_{16}, V'_{16}V_{13}\}$ ,  | $\mathbf{H} = [u, 1, 1, v, 1, 1]$ ,     |
| 26) $F'_{13} = \{V'_{13}V'_{14}, V'_{14}V_{10}, V_{10}V_{16}, V_{16}V'_{13}\}$ , | $\mathbf{H} = [u, -1, -1, v, -1, -1]$ , |
| 27) $F_{14} = \{V_8V_{15}, V_{15}V'_{11}, V'_{11}V_{14}, V_{14}V_8\}$ ,          | $\mathbf{H} = [-1, u, 1, -1, v, 1]$ ,   |
| 28) $F'_{14} = \{V'_8V'_{15}, V'_{15}V'_{11}, V'_{11}V'_{14}, V'_{14}V'_8\}$ ,   | $\mathbf{H} = [1, u, -1, 1, v, -1]$ ,   |
| 29) $F_{15} = \{V_9V_{16}, V_{16}V'_{12}, V'_{12}V_{16}, V_{16}V_9\}$ ,          | $\mathbf{H} = [-1, -1, u, -1, -1, v]$ , |
| 30) $F'_{15} = \{V'_9V'_{16}, V'_{16}V'_{12}, V'_{12}V'_{16}, V'_{16}V'_9\}$ ,   | $\mathbf{H} = [1, 1, u, 1, 1, v]$ .     |""",
)

TABLE_6 = Block(
    408,
    r"""Вершина	$X$	$Y$	$Z$	Вершина	$X$	$Y$	$Z$
$V_1$	0	0	1.854	$V'_1$	0	0	-1.854
$V_2$	0	1.902	1.236	$V'_2$	0	-1.902	-1.236
$V_3$	-1.647	0.951	1.236	$V'_3$	1.647	-0.951	-1.236
$V_4$	-1.647	-0.951	1.236	$V'_4$	1.647	0.951	-1.236
$V_5$	0	-1.902	1.236	$V'_5$	0	1.902	-1.236
$V_6$	1.647	-0.951	1.236	$V'_6$	-1.647	0.951	-1.236
$V_7$	1.647	0.951	1.236	$V'_7$	-1.647	-0.951	-1.236
$V_8$	1.647	2.853	0.618	$V'_8$	-1.647	-2.853	-0.618
$V_9$	-1.647	2.853	0.618	$V'_9$	1.647	-2.853	-0.618
$V_{10}$	-3.294	0	0.618	$V'_{10}$	3.294	0	-0.618
$V_{11}$	-1.647	-2.853	0.618	$V'_{11}$	1.647	2.853	-0.618
$V_{12}$	1.647	-2.853	0.618	$V'_{12}$	-1.647	2.853	-0.618
$V_{13}$	3.294	0	0.618	$V'_{13}$	-3.294	0	-0.618
$V_{14}$	3.294	1.902	0	$V'_{14}$	-3.294	-1.902	0
$V_{15}$	0	3.804	0	$V'_{15}$	0	-3.804	0
$V_{16}$	-3.294	1.902	0	$V'_{16}$	3.294	-1.902	0""",
)

printed_six = Printed(six, VERTICES_OF_SIX, EDGES_OF_SIX, FACES_OF_SIX, TABLE_6, 6)
of_six = declared(printed_six)
names_of_six = of_six.defined
vertices_of_six = of_six.vertices
edges_of_six = of_six.edges
faces_of_six = of_six.faces
table_6 = of_six.table

# --- 3.2

VERTICES_OF_FIVE = Block(
    483,
    r"""- 1)  $V_1 : \mathbf{H} = [1, 1, 1, -1, -1] = \left( \frac{\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, 5 \cos a \right) \quad \{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4, \mathbf{e}_5\},$
- 2)  $V_2 : \mathbf{H} = [-1, 1, 1, -1, -1] = \left( \frac{\sqrt{3}}{2} \sin a, \frac{5}{2} \sin a, 3 \cos a \right) \quad \{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_5\},$
- 3)  $V_3 : \mathbf{H} = [1, -1, 1, -1, -1] = \left( -\frac{\sqrt{3}}{2} \sin a, \frac{3}{2} \sin a, 3 \cos a \right) \quad \{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3\},$
- 4)  $V_4 : \mathbf{H} = [1, 1, -1, -1, -1] = \left( -\frac{\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, 3 \cos a \right) \quad \{-\mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\},$
- 5)  $V_5 : \mathbf{H} = [1, 1, 1, 1, -1] = \left( \frac{\sqrt{3}}{2} \sin a, -\frac{3}{2} \sin a, 3 \cos a \right) \quad \{-\mathbf{e}_3, -\mathbf{e}_4, \mathbf{e}_5\},$

- 6)  $V_6 : \mathbf{H} = [1,1,1,-1,1] = \left( \frac{3\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, 3 \cos a \right)$   $\{-\mathbf{e}_1, \mathbf{e}_4, -\mathbf{e}_5\}$ ,
- 7)  $V_7 : \mathbf{H} = [-1,1,1,-1,1] = \left( \frac{3\sqrt{3}}{2} \sin a, \frac{3}{2} \sin a, \cos a \right)$   $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_4, -\mathbf{e}_5\}$ ,
- 8)  $V_8 : \mathbf{H} = [-1,-1,1,-1,-1] = \left( -\frac{\sqrt{3}}{2} \sin a, \frac{7}{2} \sin a, \cos a \right)$   $\{\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_5\}$ ,
- 9)  $V_9 : \mathbf{H} = [1,-1,-1,-1,-1] = \left( -\frac{3\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, \cos a \right)$   $\{-\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\}$ ,
- 10)  $V_{10} : \mathbf{H} = [1,1,-1,1,-1] = \left( -\frac{\sqrt{3}}{2} \sin a, -\frac{5}{2} \sin a, \cos a \right)$   $\{-\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4, \mathbf{e}_5\}$ ,
- 11)  $V_{11} : \mathbf{H} = [1,1,1,1,1] = \left( \frac{3\sqrt{3}}{2} \sin a, -\frac{5}{2} \sin a, \cos a \right)$   $\{-\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\}$ ,
- 12)  $V'_{11} : \mathbf{H} = [-1,-1,-1,-1,-1] = \left( -\frac{3\sqrt{3}}{2} \sin a, \frac{5}{2} \sin a, -\cos a \right)$   $\{\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, \mathbf{e}_4\}$ ,
- 13)  $V'_{10} : \mathbf{H} = [-1,-1,1,-1,1] = \left( \frac{\sqrt{3}}{2} \sin a, \frac{5}{2} \sin a, -\cos a \right)$   $\{\mathbf{e}_2, -\mathbf{e}_3, \mathbf{e}_4, -\mathbf{e}_5\}$ ,
- 14)  $V'_9 : \mathbf{H} = [-1,1,1,1,1] = \left( \frac{3\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, -\cos a \right)$   $\{\mathbf{e}_1, -\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\}$ ,
- 15)  $V'_8 : \mathbf{H} = [1,1,-1,1,1] = \left( \frac{\sqrt{3}}{2} \sin a, -\frac{7}{2} \sin a, -\cos a \right)$   $\{-\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_5\}$ ,
- 16)  $V'_7 : \mathbf{H} = [1,-1,-1,1,-1] = \left( -\frac{3\sqrt{3}}{2} \sin a, -\frac{3}{2} \sin a, -\cos a \right)$   $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_4, \mathbf{e}_5\}$ ,
- 17)  $V'_6 : \mathbf{H} = [-1,-1,-1,1,-1] = \left( -\frac{3\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, -3 \cos a \right)$   $\{\mathbf{e}_1, -\mathbf{e}_4, \mathbf{e}_5\}$ ,
- 18)  $V'_5 : \mathbf{H} = [-1,-1,-1,-1,1] = \left( -\frac{\sqrt{3}}{2} \sin a, \frac{3}{2} \sin a, -3 \cos a \right)$   $\{\mathbf{e}_3, \mathbf{e}_4, -\mathbf{e}_5\}$ ,
- 19)  $V'_4 : \mathbf{H} = [-1,-1,1,1,1] = \left( \frac{\sqrt{3}}{2} \sin a, \frac{1}{2} \sin a, -3 \cos a \right)$   $\{\mathbf{e}_2, -\mathbf{e}_3, -\mathbf{e}_4\}$ ,
- 20)  $V'_3 : \mathbf{H} = [-1,1,-1,1,1] = \left( \frac{\sqrt{3}}{2} \sin a, -\frac{3}{2} \sin a, -3 \cos a \right)$   $\{\mathbf{e}_1, -\mathbf{e}_2, \mathbf{e}_3\}$ ,
- 21)  $V'_2 : \mathbf{H} = [1,-1,-1,1,1] = \left( -\frac{\sqrt{3}}{2} \sin a, -\frac{5}{2} \sin a, -3 \cos a \right)$   $\{-\mathbf{e}_1, \mathbf{e}_2, -\mathbf{e}_5\}$ ,
- 22)  $V'_1 : \mathbf{H} = [-1,-1,-1,1,1] = \left( -\frac{\sqrt{3}}{2} \sin a, -\frac{1}{2} \sin a, -5 \cos a \right)$   $\{\mathbf{e}_1, \mathbf{e}_2, \mathbf{e}_3, -\mathbf{e}_4, -\mathbf{e}_5\}$ .""",
)

EDGES_OF_FIVE = Block(
    510,
    r"""1) V_2V_1 : \mathbf{H} = [u, 1, 1, -1, -1], & 15) V_3V_1 : \mathbf{H} = [1, u, 1, -1, -1], & 29) V_6V_7' : \mathbf{H} = [u, -1, -1, 1, -1], \\
2) V_4V_1 : \mathbf{H} = [1, 1, u, -1, -1], & 16) V_1V_5 : \mathbf{H} = [1, 1, 1, u, -1], & 30) V_9V_7' : \mathbf{H} = [1, -1, -1, u, -1], \\
3) V_1V_6 : \mathbf{H} = [1, 1, 1, -1, u], & 17) V_2V_7 : \mathbf{H} = [-1, 1, 1, -1, u], & 31) V_6V_1' : \mathbf{H} = [-1, -1, -1, 1, u], \\
4) V_8V_2 : \mathbf{H} = [-1, u, 1, -1, -1], & 18) V_3V_8' : \mathbf{H} = [u, 1, -1, 1, 1], & 32) V_5V_{10}' : \mathbf{H} = [-1, -1, u, -1, 1], \\
5) V_9V_3 : \mathbf{H} = [1, -1, u, -1, -1], & 19) V_1V_2' : \mathbf{H} = [u, -1, -1, 1, 1], & 33) V_{10}'V_4' : \mathbf{H} = [-1, -1, 1, u, 1], \\
6) V_4V_{10} : \mathbf{H} = [1, 1, -1, u, -1], & 20) V_{10}V_5 : \mathbf{H} = [1, 1, u, 1, -1], & 34) V_{11}'V_6' : \mathbf{H} = [-1, -1, -1, u, -1], \\
7) V_5V_{11} : \mathbf{H} = [1, 1, 1, 1, u], & 21) V_7V_6 : \mathbf{H} = [u, 1, 1, -1, 1], & 35) V_{11}'V_8 : \mathbf{H} = [-1, -1, u, -1, -1], \\
8) V_6V_{11} : \mathbf{H} = [1, 1, 1, u, 1], & 22) V_7V_9' : \mathbf{H} = [-1, 1, 1, u, 1], & 36) V_{11}'V_9 : \mathbf{H} = [u, -1, -1, -1, -1], \\
9) V_{10}'V_7 : \mathbf{H} = [-1, u, 1, -1, 1], & 23) V_2V_8' : \mathbf{H} = [1, u, -1, 1, 1], & 37) V_8V_3 : \mathbf{H} = [u, -1, 1, -1, -1], \\
10) V_1V_3' : \mathbf{H} = [-1, u, -1, 1, 1], & 24) V_9V_{11} : \mathbf{H} = [u, 1, 1, 1, 1], & 38) V_{11}'V_5' : \mathbf{H} = [-1, -1, -1, -1, u], \\
11) V_7V_2' : \mathbf{H} = [1, -1, -1, 1, u], & 25) V_8V_{11} : \mathbf{H} = [1, 1, u, 1, 1], & 39) V_8V_{10}' : \mathbf{H} = [-1, -1, 1, -1, u], \\
12) V_{10}'V_8' : \mathbf{H} = [1, 1, -1, 1, u], & 26) V_7V_{10} : \mathbf{H} = [1, u, -1, 1, -1], & 40) V_9V_4 : \mathbf{H} = [1, u, -1, -1, -1], \\
13) V_4V_9' : \mathbf{H} = [-1, u, 1, 1, 1], & 27) V_3V_9' : \mathbf{H} = [-1, 1, u, 1, 1], & \\
14) V_1V_4' : \mathbf{H} = [-1, -1, u, 1, 1], & 28) V_5V_1' : \mathbf{H} = [-1, -1, -1, u, 1], &""",
)

FACES_OF_FIVE = Block(
    529,
    r"""1) F_1 = \{V_1V_2, V_2V_7, V_7V_6, V_6V_1\}, & \mathbf{H} = [u, 1, 1, -1, v], \\
2) F_1' = \{V_1V_2', V_2V_7', V_7V_6', V_6V_1'\}, & \mathbf{H} = [u, -1, -1, 1, v], \\
3) F_2 = \{V_1V_3, V_3V_8, V_8V_2, V_2V_1\}, & \mathbf{H} = [u, v, 1, -1, -1], \\
4) F_2' = \{V_1V_3', V_3V_8', V_8V_2', V_2V_1'\}, & \mathbf{H} = [u, v, -1, 1, 1], \\
5) F_3 = \{V_1V_4, V_4V_9, V_9V_3, V_3V_1\}, & \mathbf{H} = [1, u, v, -1, -1], \\
6) F_3' = \{V_1V_4', V_4V_9', V_9V_3', V_3V_1'\}, & \mathbf{H} = [-1, u, v, 1, 1], \\
7) F_4 = \{V_1V_5, V_5V_{10}, V_{10}V_4, V_4V_1\}, & \mathbf{H} = [1, 1, u, v, -1], \\
8) F_4' = \{V_1V_5', V_5V_{10}', V_{10}V_4', V_4V_1'\}, & \mathbf{H} = [-1, -1, u, v, 1], \\
9) F_5 = \{V_1V_6, V_6V_{11}, V_{11}V_5, V_5V_1\}, & \mathbf{H} = [1, 1, 1, u, v], \\
10) F_5' = \{V_1V_6', V_6V_{11}', V_{11}V_5', V_5V_1'\}, & \mathbf{H} = [-1, -1, -1, u, v], \\
11) F_6 = \{V_3V_9, V_9V_{11}, V_{11}V_8, V_8V_3\}, & \mathbf{H} = [u, -1, v, -1, -1], \\
12) F_6' = \{V_3V_9', V_9V_{11}', V_{11}V_8', V_8V_3'\}, & \mathbf{H} = [u, 1, v, 1, 1], \\
13) F_7 = \{V_4V_{10}, V_{10}V_7, V_7V_9, V_9V_4\}, & \mathbf{H} = [1, u, -1, v, -1], \\
14) F_7' = \{V_4V_{10}', V_{10}V_7', V_7V_9', V_9V_4'\}, & \mathbf{H} = [-1, u, 1, v, 1],
\end{array}$$



- 15)  $F_8 = \{V_5V_{11}, V_{11}V_8', V_8'V_{10}, V_{10}V_5\}$ ,  $\mathbf{H} = [1, 1, u, 1, v]$ ,
 16)  $F_8' = \{V_5'V_{11}', V_{11}'V_8, V_8V_{10}', V_{10}'V_5'\}$ ,  $\mathbf{H} = [-1, -1, u, -1, v]$ ,
 17)  $F_9 = \{V_6V_7, V_7V_9', V_9'V_{11}, V_{11}V_6\}$ ,  $\mathbf{H} = [u, 1, 1, v, 1]$ ,
 18)  $F_9' = \{V_6'V_7', V_7'V_9, V_9V_{11}', V_{11}'V_6'\}$ ,  $\mathbf{H} = [u, -1, -1, v, -1]$ ,
 19)  $F_{10} = \{V_7V_2, V_2V_8, V_8V_{10}', V_{10}'V_7\}$ ,  $\mathbf{H} = [-1, u, 1, -1, v]$ ,
 20)  $F_{10}' = \{V_7'V_2', V_2'V_8', V_8'V_{10}, V_{10}V_7'\}$ ,  $\mathbf{H} = [1, u, -1, 1, v]$ .""",
)

TABLE_9 = Block(
    558,
    r"""Вершина	X	Y	Z	Вершина	X	Y	Z
$V_1$	0.824	0.476	1.545	$V_1'$	-0.824	-0.476	-1.545
$V_2$	0.824	2.378	0.927	$V_2'$	-0.824	-2.378	-0.927
$V_3$	-0.824	1.427	0.927	$V_3'$	0.824	-1.427	-0.927
$V_4$	-0.824	-0.476	0.927	$V_4'$	0.824	0.476	-0.927
$V_5$	0.824	-1.427	0.927	$V_5'$	-0.824	1.427	-0.927
$V_6$	2.471	-0.476	0.927	$V_6'$	-2.471	0.476	-0.927
$V_7$	2.471	1.427	0.309	$V_7'$	-2.471	-1.427	-0.309
$V_8$	-0.824	3.329	0.309	$V_8'$	0.824	-3.329	-0.309
$V_9$	-2.471	0.476	0.309	$V_9'$	2.478	-0.478	-0.309
$V_{10}$	-0.824	-2.378	0.309	$V_{10}'$	0.824	2.378	-0.309
$V_{11}$	2.471	-2.378	0.309	$V_{11}'$	-2.471	2.378	-0.309""",
)

printed_five = Printed(five, VERTICES_OF_FIVE, EDGES_OF_FIVE, FACES_OF_FIVE, TABLE_9, 9)
of_five = declared(printed_five)
names_of_five = of_five.defined
vertices_of_five = of_five.vertices
edges_of_five = of_five.edges
faces_of_five = of_five.faces
table_9 = of_five.table
