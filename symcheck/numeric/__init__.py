"""Numbers in, numbers out: arrays go through the formulas of the papers. Knows no paper and no algebra."""
