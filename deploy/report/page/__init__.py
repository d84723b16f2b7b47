"""Reports as pages that need no other file."""
