"""What moves a body in time: the methods and their stability limits, a step of each (`steps`), the linear
systems of implicit ones (`linear`), and the energy balance (`balance`).
"""
