# Half-angle laws of a pin in a hole, equal materials.
table = 'figure4.csv'
load_name = "load parameter λ = 2P/(π ε̄ ρ_1 E)"
largest_load = 1
limit = 84.85
error_range = 15
load plots.'/law_panels.gp'
