"""Kernels: the expressions of the derivations as NumPy functions."""
