"""What a structure is made of: nodes, bars, bodies, membranes, sections, loads, gauges."""
