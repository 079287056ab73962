"""What travels over the wire: models, canonical form, presets, examples."""
