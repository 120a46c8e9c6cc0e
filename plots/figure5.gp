# Half-angle laws of a ball in a rigid seat.
table = 'figure5.csv'
load_name = "load parameter μ = 3R_n/(2 ε̄ ρ_1^2 E)"
largest_load = 4
limit = 92.5
error_range = 20
load plots.'/law_panels.gp'
