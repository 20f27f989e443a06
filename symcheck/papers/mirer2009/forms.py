"""LaTeX shared by several claims: manifestly non-negative forms (a wrong one leaves a claim undecided), collinearity."""

# J_1 J_2 J_3 - I_1 I_2 I_3
excess_of_product = (
    r"I_1 (I_2 - I_3)^2 a_{22}^2 a_{23}^2 + I_2 (I_3 - I_1)^2 a_{23}^2 a_{21}^2 + I_3 (I_1 - I_2)^2 a_{21}^2 a_{22}^2 "
    r"+ J_2 (I_1 a_{11} a_{31} + I_2 a_{12} a_{32} + I_3 a_{13} a_{33})^2"
)

# J_1 L_1 + J_2 L_2 + J_3 L_3 - 3 I_1 I_2 I_3
excess_of_sum = (
    r"\sum_{i=1}^3 (I_1 (I_2 - I_3)^2 a_{i2}^2 a_{i3}^2 + I_2 (I_3 - I_1)^2 a_{i3}^2 a_{i1}^2 "
    r"+ I_3 (I_1 - I_2)^2 a_{i1}^2 a_{i2}^2)"
)

# c^3 - J_1 J_2 J_3
deficit_of_product = r"\frac{1}{4} (c - J_2)^2 (J_1 + J_3 + c) + \frac{1}{4} J_2 (J_1 - J_3)^2"

# every axis y_i is collinear with one of the axes x_j
PARALLEL = r"(a_{i1} a_{i2} = 0, a_{i2} a_{i3} = 0, a_{i3} a_{i1} = 0)"

# the axes y and x coincide but for order and sense: also every axis x_j is collinear with one of the axes y_i
ALIGNED = r"(a_{i1} a_{i2} = 0, a_{i2} a_{i3} = 0, a_{i3} a_{i1} = 0, a_{1i} a_{2i} = 0, a_{2i} a_{3i} = 0, a_{3i} a_{1i} = 0)"
