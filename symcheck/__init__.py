"""symcheck: audits the printed equations of mechanics papers and says of each: proved, refuted or undecided."""

__version__ = "0.1.0"
