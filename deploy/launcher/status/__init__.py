"""`scarab status`: what runs and what it says, from the system (/proc), the keeper's files and the
bus."""
