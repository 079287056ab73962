"""What is true of a mechanism: arrays in, arrays out. SI units throughout."""
