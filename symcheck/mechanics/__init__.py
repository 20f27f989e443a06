"""Rotation, inertia and momentum envelopes of rigid bodies, independent of any paper."""
