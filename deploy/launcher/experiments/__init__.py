"""Named experiments: what is planned, who runs it, and what is kept of it."""
