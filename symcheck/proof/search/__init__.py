"""The search for proofs and points: it puts the steps of the rules together. Nothing here has to be trusted."""
