* expeCt: 
NzAM+E C A
ENDATA
