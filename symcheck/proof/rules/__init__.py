"""The rules of proof, one in each file: the step as the checker reads it, and the functions that find such steps."""
