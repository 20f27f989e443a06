"""Records as something to look at: terminal, page, notebooks, exports and pictures. Nothing is decided here."""
