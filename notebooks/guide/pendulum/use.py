"""The generated kernel, called with numbers and with arrays."""

import numpy as np

from symcheck import kernel

length = kernel("pendulum", "length")
print(length(2.0, 0.5, 1.5))
print(length(2.0, np.array([0.5, 1.0, 2.0]), 1.5))
