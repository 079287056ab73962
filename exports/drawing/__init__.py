"""How figures are drawn; everything that needs the plotting library."""
