S[G135]                (Activate feedforward control for S)
S[G136=80]             (Specifying feedforward control weighting in
%)
S[G137]                (Deactivate feedforward control)
S2[G135 G136=90]      (Activate at 90% weighting for S2)
S2[G136=0]            (Change weighting to 0%)
S1[G135]              (Activating with 100% default weighting for
S1)
