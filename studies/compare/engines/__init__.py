"""The engines and solvers that are compared; `studies.compare.contenders` lists them."""
