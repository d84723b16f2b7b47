"""The launcher of the Scarab stack. `deploy/scarab --help` shows what it does."""
