"""Members and joints in more than name: hubs, bearings, screws, compliance, springs on coordinates."""
