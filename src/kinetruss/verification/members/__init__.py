"""Members and joints in more than name: springs on hinges and other coordinates."""
