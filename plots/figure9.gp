# Area integrals, the friction of adhesion in (3.7) and (3.8).
unset colorbox
name1 = "I', friction force"
name2 = "J', sliding moment"
name3 = "K', spinning moment"
column1 = 7
column2 = 8
column3 = 9
top1 = 5.5
top2 = 5.5
top3 = 5.5
load plots.'/panels.gp'
