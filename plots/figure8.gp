# Friction coefficients (3.9): force, sliding moment, spinning moment.
unset colorbox
name1 = 'χ, friction force'
name2 = 'σ_Y, sliding moment'
name3 = 'σ_Z, spinning moment'
column1 = 10
column2 = 11
column3 = 12
top1 = 1.4
top2 = 1.4
top3 = 1.4
load plots.'/panels.gp'
