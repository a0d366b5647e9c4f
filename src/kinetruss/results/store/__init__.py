"""The run store: folders that are whole or not there, one writer each, readable while they grow."""
