%feedforward
N10 G01 X30 F12000
N20 G135                  (100 % for all axes)
N30 G01 X0
N40 G136 X80 Y95 Z0       (Z has no feedforward)
N50 G01 X30 Y20
N60 S[G135 G136=80]       (of a spindle: nothing for X)
N70 G136 X0
N80 G00 X0 Y0
N90 G137
N100 G04 X0.05
M30
