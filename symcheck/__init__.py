"""symcheck: audits the printed equations of mechanics papers and says of each: proved, refuted or undecided."""
