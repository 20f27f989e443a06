"""The audit as one page to look at: static, self-contained, offline. It shows records and computes nothing."""
