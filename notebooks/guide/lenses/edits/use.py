"""The kernel of the audit, with numbers and with arrays."""

import numpy as np

from symcheck import kernel

focal_length = kernel("audit", "focal_length")
print(focal_length(R_1=0.1, R_2=-0.1, n=1.5))
print(focal_length(R_1=np.array([0.1, 0.2]), R_2=-0.1, n=1.5).round(4))
