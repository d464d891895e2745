
 E