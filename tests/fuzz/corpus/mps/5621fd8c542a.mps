NAA–\\////// T
r