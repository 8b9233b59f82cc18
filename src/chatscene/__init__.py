"""From a sentence about a dangerous traffic situation to scenes worth testing on."""

import os

# One thread for linear algebra, in every process that imports us and every process that it starts, said before NumPy
# is loaded and reads it. The networks that drive are so small that a second thread slows them by up to two, the
# processes of a run would fight for the cores, and how a sum is split among threads changes its last bits.
os.environ |= dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "VECLIB_MAXIMUM_THREADS"), "1"
)
