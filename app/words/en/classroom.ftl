# A pupil's page, the wall and the teacher's desk.

class-title = softrod: a class
class-needs-javascript = A class needs JavaScript, which is switched off here.
class-blocked = The page has loaded, but its live connection fails: something on the way blocks WebSockets. Try another network, such as the hotspot of the teacher's computer.
