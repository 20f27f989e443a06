"""Rotation, inertia and momentum envelopes of rigid bodies, independent of any paper."""

__all__ = ["inertia", "rotation", "zonotope"]
